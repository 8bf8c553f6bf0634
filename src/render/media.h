// Media: which closed transparent objects a straight line runs through, and where.
// A place is inside a closed object where the line beyond it leaves the object more often than it
// enters it. So nothing need be remembered of the way that led there, and a line may begin
// anywhere: inside objects as well.
#pragma once
#include <vector>

#include "geometry/object3d.h"
#include "render/wave_tables.h"
#include "scene/solid_objects.h"
#include "shading/material.h"

class Media final : public CrossingVisitor {
 public:
  /// What fills a place; both are null outside of all objects. Not owned.
  struct Medium {
    const Object3D* object = nullptr;
    const Material* material = nullptr;

    /// The index of refraction near a point of the world: 1 outside; of a texture the mean of its
    /// transparent components' there.
    float indexAt(const Vec3d& point) const;
  };

  /// Along a line whose direction is a unit vector. After begin() it is told all crossings at
  /// t > 0, then finish() is called, and then it knows. `solids`, not owned, tells volumes; where
  /// it is null they count as equal. Time n log n and memory n for n crossings; each question takes
  /// time n.
  explicit Media(const SolidObjects* solids) : solids_(solids) {}
  void begin() { crossings_.clear(); }
  void visit(const Crossing& crossing) override;
  void finish();

  /// What fills the place at parameter t: of all objects around it the one whose material has the
  /// largest priority; of several such the one of the smallest volume, which is the innermost where
  /// one stands inside another, and the same for every line where they overlap otherwise; of equal
  /// ones the one that the line leaves first, and of those left at the same t the one entered last.
  /// Source: Schmidt and Budge, "Simple Nested Dielectrics in Ray Traced Images", 2002.
  Medium mediumAt(double t) const;

  /// True when the line meets `object`, and it is closed and transparent.
  bool isClosed(const Object3D* object) const;

  /// Adds a filter of ray `row` for each object around parameter t, where no surface is near, as
  /// often as the line is inside it: what dims light on a way of `length` >= 0 that ends at point
  /// `end`. A texture has its colour of that point all the way.
  void addFilters(double t, const Vec3d& end, double length, int row,
                  ColorFilterTable& filters) const;

 private:
  /// A stretch of the line inside one object.
  struct Stay {
    Medium medium;
    double from, to;
  };

  void addStays(CrossingPlace first, CrossingPlace last);
  bool isStronger(const Stay& a, const Stay& b) const;

  const SolidObjects* solids_;       // not owned; may be null
  std::vector<Crossing> crossings_;  // of closed transparent objects, by object and then by t
  std::vector<Stay> stays_;
};
