// Object3D: anything that a ray can hit. One ray asks three questions: intersect, occluded and, for
// what light loses in transparent objects, visitCrossings. BatchGeometry (ray_table.h) answers them
// for many rays at once.
// A sphere, plane, triangle or mesh decides in one function, nearestRoot, whether and at which t a
// ray meets it; intersect then records what lies there, and occluded asks no more.
// All objects are const while rays are traced, so any number of threads may ask at once.
#pragma once
#include <typeinfo>

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
  /// So many surfaces of the object coincide here; 1 where it is closed.
  std::uint32_t count = 1;
};

class CrossingVisitor {
 public:
  virtual ~CrossingVisitor() = default;
  /// Called for every crossing, in no particular order; once for all that Crossing::count tells.
  virtual void visit(const Crossing& crossing) = 0;
};

class Object3D {
 public:
  virtual ~Object3D() = default;

  /// Finds the nearest surface with tmin < t < hit.getT(); on success stores it in `hit` and
  /// returns true, otherwise leaves `hit` as it was. Of several at the same t the first one in
  /// the scene wins. tmin may be -infinity. `hit` may hold what another object's surface is, which
  /// then has to be nearer, or nothing but a bound.
  virtual bool intersect(const Ray& ray, Hit& hit, double tmin) const = 0;

  /// True when any surface lies at tmin < t < tmax. Cheaper than intersect: no normal, no
  /// material, and the first hit ends it. By default it asks intersect.
  virtual bool occluded(const Ray& ray, double tmin, double tmax) const {
    Hit hit(tmax);
    return intersect(ray, hit, tmin);
  }

  /// Reports every crossing of the ray with a surface at t > 0. By default it asks intersect
  /// again and again, and calls the object open.
  virtual void visitCrossings(const Ray& ray, CrossingVisitor& visitor) const {
    double tmin = 0;
    for (Hit hit; intersect(ray, hit, tmin); hit = Hit()) {
      tmin = hit.getT();
      const bool leaving = dot(hit.getNormal(), ray.getDirection()) > 0;
      const Object3D* const object = hit.getObject() ? hit.getObject() : this;
      visitor.visit({tmin, object, hit.getMaterial(), false, leaving});
    }
  }

  /// Extends `box` by the object as `toWorld` places it. What has no bounds (a plane) adds
  /// nothing, which is also the default.
  virtual void addBounds(const Matrix& /*toWorld*/, BoundingBox& /*box*/) const {}

  /// True when its hits have texture coordinates. By default they have none.
  virtual bool hasTextureCoordinates() const { return false; }

  /// True when addBounds tells the whole extent. By default it does not.
  virtual bool isBounded() const { return false; }
};

/// The question of Object3D::occluded, to be asked along with others.
struct ShadowQuery {
  Ray ray;
  double tmin = 0, tmax = 0;
};

/// `object` (not null), of a class with virtual functions such as Object3D, as a T where it is a T
/// itself and not of a class derived from T, which may answer differently; else null.
template <class T, class Base>
const T* exactly(const Base* object) {
  return typeid(*object) == typeid(T) ? static_cast<const T*>(object) : nullptr;
}
