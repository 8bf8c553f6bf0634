// Hit: the nearest surface found so far along a ray.
// getT() is also the upper bound of the search: intersect() only reports what lies nearer.
#pragma once
#include <cstdint>
#include <limits>

#include "geometry/ray.h"

class Material;

/// Which primitive was hit, how far its numbers can be trusted, and where it was hit on itself.
struct Primitive {
  const Object3D* object = nullptr;  ///< the sphere, plane, triangle or mesh; not owned
  std::uint32_t face = 0;            ///< which triangle of a mesh; 0 for all else
  double magnitude = 0;              ///< as magnitudeOf gives it
  Vec2d textureCoordinates{};        ///< see Hit::getTextureCoordinates
};

/// The largest number that took part in finding `point` = origin + t direction, counted in units of
/// t: rounding errors are proportional to it. `extent` is the largest number that describes the
/// primitive (a coordinate, a radius, an offset), in the space of the ray.
template <class Number>
Number magnitudeOf(const Number& t, const Vec3<Number>& point, const Vec3<Number>& origin,
                   const Vec3<Number>& direction, const Number& extent) {
  const Number largest = larger(larger(extent, maxAbs(origin)), maxAbs(point));
  return larger(absolute(t), largest / length(direction));
}
inline double magnitudeOf(double t, const Vec3d& point, const Ray& ray, double extent) {
  return magnitudeOf(t, point, ray.getOrigin(), ray.getDirection(), extent);
}

class Hit {
 public:
  /// Nothing found yet, and everything is near enough.
  Hit() = default;
  /// Nothing found yet; only surfaces with t < tmax count. tmax may be infinite.
  explicit Hit(double tmax) : t_(tmax) {}
  /// A hit at parameter t, of no known primitive and at no known point: enough for
  /// Material::Shade of materials that are the same everywhere.
  Hit(double t, const Material* material, const Vec3d& normal)
      : t_(t), material_(material), normal_(normal) {}

  /// The ray's parameter, the same in every space; the bound of the search until something is hit.
  double getT() const { return t_; }
  /// Null until something is hit. Not owned.
  const Material* getMaterial() const { return material_; }
  /// The unit normal, in the space of the ray that was asked: the world's once intersect() has
  /// returned to the top. Its side is the surface's own, whichever side the ray came from.
  const Vec3d& getNormal() const { return normal_; }
  /// The ray's point at getT(), in the same space; (0, 0, 0) where none is known.
  const Vec3d& getIntersectionPoint() const { return point_; }
  /// The primitive that was hit, null until then. Not owned.
  const Object3D* getObject() const { return primitive_.object; }
  /// Which triangle of it, where it is a mesh; else 0.
  std::uint32_t getFace() const { return primitive_.face; }
  /// See magnitudeOf.
  double getMagnitude() const { return primitive_.magnitude; }
  /// (u, v), which run over [0, 1] where the picture of a texture covers the surface once, to the
  /// right and up; (0, 0) but on a mesh that has texture coordinates there.
  Vec2d getTextureCoordinates() const { return primitive_.textureCoordinates; }

  /// Becomes the hit of a surface of `material`, with unit normal `normal`, at `point`, which is
  /// the ray's at parameter t.
  void record(double t, const Material* material, const Vec3d& normal, const Vec3d& point,
              const Primitive& primitive) {
    t_ = t;
    material_ = material;
    normal_ = normal;
    point_ = point;
    primitive_ = primitive;
  }
  /// The same hit of a surface of that material, with that unit normal.
  Hit withSurface(const Material* material, const Vec3d& normal) const {
    Hit hit = *this;
    hit.material_ = material;
    hit.normal_ = normal;
    return hit;
  }

 private:
  double t_ = std::numeric_limits<double>::infinity();
  const Material* material_ = nullptr;
  Vec3d normal_;
  Vec3d point_;
  Primitive primitive_;
};
