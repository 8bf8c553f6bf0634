// Object3D: anything that a ray can hit. The two questions are intersect and occluded.
// All objects are const while rays are traced, so any number of threads may ask at once.
#pragma once
#include "geometry/crossing.h"
#include "geometry/hit.h"
#include "geometry/ray.h"
#include "math/bounding_box.h"
#include "math/matrix.h"

/// The question of occluded(), to be asked along with others.
struct ShadowQuery {
  Ray ray;
  double tmin = 0, tmax = 0;
  ShadowQuery() {}  // as that of Ray
  ShadowQuery(const Ray& r, double least, double most) : ray(r), tmin(least), tmax(most) {}
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

  /// Asks intersect for `count` rays, each with its own hit: hits[i] is changed as
  /// intersect(rays[i], hits[i], tmins[i]) would. Meant for rays that belong together, up to
  /// kBatchSize of them, which some objects answer faster than one by one.
  virtual void intersectBatch(const Ray* rays, const double* tmins, int count, Hit* hits) const;
  /// Asks occluded for `count` queries and stores each answer in blocked[i].
  virtual void occludedBatch(const ShadowQuery* queries, int count, bool* blocked) const;
  static constexpr int kBatchSize = 256;

  /// Reports every crossing of the ray with a surface at t > 0. By default it asks intersect
  /// again and again, and calls the object open.
  virtual void visitCrossings(const Ray& ray, CrossingVisitor& visitor) const;

  /// Extends `box` by the object as `toWorld` places it. What has no bounds (a plane) adds
  /// nothing, which is also the default.
  virtual void addBounds(const Matrix& toWorld, BoundingBox& box) const;

  /// True when addBounds tells the whole extent. By default it does not.
  virtual bool isBounded() const { return false; }
};
