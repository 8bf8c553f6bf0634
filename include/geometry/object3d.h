// Object3D: anything that a ray can hit. The two questions are intersect and occluded, each of one
// ray; what answers for many at once is a BatchGeometry too.
// All objects are const while rays are traced, so any number of threads may ask at once.
#pragma once
#include "geometry/hit.h"
#include "geometry/ray.h"
#include "math/bounding_box.h"
#include "math/matrix.h"

/// One place where a ray passes through a surface. What light loses on its way through transparent
/// objects is counted from all of them.
struct Crossing {
  double t;                  ///< ray parameter
  const Object3D* object;    ///< the sphere, plane, triangle or mesh; not owned
  const Material* material;  ///< its material; not owned
  bool closed;               ///< the object encloses a volume
  bool leaving;              ///< the ray goes out along the normal here
};

class CrossingVisitor {
 public:
  virtual ~CrossingVisitor() = default;
  /// Called once for every crossing, in no particular order.
  virtual void visit(const Crossing& crossing) = 0;
};

class Object3D {
 public:
  virtual ~Object3D() = default;

  /// Finds the nearest surface with tmin < t < hit.getT(); on success stores it in `hit` and
  /// returns true, otherwise leaves `hit` as it was. Of several at the same t the first one in
  /// the scene wins. tmin may be -infinity.
  virtual bool intersect(const Ray& ray, Hit& hit, double tmin) const = 0;

  /// True when any surface lies at tmin < t < tmax. Cheaper than intersect: no normal, no
  /// material, and the first hit ends it. By default it asks intersect.
  virtual bool occluded(const Ray& ray, double tmin, double tmax) const;

  /// Reports every crossing of the ray with a surface at t > 0. By default it asks intersect
  /// again and again, and calls the object open.
  virtual void visitCrossings(const Ray& ray, CrossingVisitor& visitor) const;

  /// Extends `box` by the object as `toWorld` places it. What has no bounds (a plane) adds
  /// nothing, which is also the default.
  virtual void addBounds(const Matrix& toWorld, BoundingBox& box) const;

  /// True when addBounds tells the whole extent. By default it does not.
  virtual bool isBounded() const { return false; }
};
