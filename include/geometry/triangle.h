// Triangle: three points; its normal points to where they run counter-clockwise. And the one test
// that decides whether a ray hits a triangle, and where: of a Triangle, and of each face of a mesh.
//
// The vertices are taken relative to the ray's origin and moved along its direction onto a plane,
// where the ray is the point (0, 0): a vertex lands at the same place for all triangles that share
// it. On which side of an edge (0, 0) lies is then decided without any rounding error, and (0, 0)
// on the edge counts as inside: no ray passes between two triangles, nor through a vertex, where
// the rounded signs of many edges would have to agree. Source: Woop, Benthin and Wald, "Watertight
// Ray/Triangle Intersection", 2013; the exact product is Dekker's, "A Floating-Point Technique for
// Extending the Available Precision", 1971.
#pragma once
#include <type_traits>

#include "geometry/shape.h"

namespace triangle {

/// Twice the area times the normal; the side from which a, b, c run counter-clockwise.
template <class Number>
Vec3<Number> areaNormal(const Vec3<Number>& a, const Vec3<Number>& b, const Vec3<Number>& c) {
  static_assert(!std::is_same_v<Number, float>, "areas are not computed in single precision");
  return cross(b - a, c - a);
}

/// The largest coordinate of the three, by size.
template <class Number>
Number extent(const Vec3<Number>& a, const Vec3<Number>& b, const Vec3<Number>& c) {
  return larger(larger(maxAbs(a), maxAbs(b)), maxAbs(c));
}

/// Where the ray meets the plane of a triangle, kept between the nearest and the farthest vertex;
/// `normal` is the area normal, and the vertices are relative to the ray's origin. False, and `t`
/// anything, for a triangle without area and where the numbers have overflowed.
template <class Number>
MaskOf<Number> distance(const Vec3<Number>& a, const Vec3<Number>& b, const Vec3<Number>& c,
                        const Vec3<Number>& normal, const Vec3<Number>& direction, Number& t) {
  const Number lengthSquared = dot(direction, direction);
  const Number ta = dot(a, direction), tb = dot(b, direction), tc = dot(c, direction);
  const Number nearest = smaller(smaller(ta, tb), tc) / lengthSquared;
  const Number farthest = larger(larger(ta, tb), tc) / lengthSquared;
  const Number root = dot(normal, a) / dot(normal, direction);
  t = choose(root >= nearest, smaller(root, farthest), nearest);
  return isNotZero(normal) & (nearest <= farthest);
}

/// Finds where the ray meets triangle abc (either side): the parameter `t`, whatever its sign;
/// anything where the result is false. A triangle without area is never hit, nor is one seen
/// exactly edge-on. t never leaves the range of the three vertices, however flat the ray strikes.
bool intersect(const Vec3d& a, const Vec3d& b, const Vec3d& c, const Ray& ray, double& t);

/// The barycentric weights of a point in the plane of triangle abc: the point is weights.x a +
/// weights.y b + weights.z c, and they add up to 1, each but for rounding. At a corner those of the
/// others are 0. Not finite where the triangle has no area. They are quotients of areas in the
/// coordinate plane that the triangle is least slanted to.
Vec3d weightsAt(const Vec3d& a, const Vec3d& b, const Vec3d& c, const Vec3d& point);

/// Like intersect, but a ray through a shared edge or vertex crosses exactly one of the triangles
/// on each side of the surface: ties are broken as if the ray were moved by (e, e^2) on the plane
/// for an e too small to matter. `leaving` tells whether it goes out along the normal; over all
/// faces of a closed mesh, in front and behind, leaving and entering crossings are equally many.
/// Source: Edelsbrunner and Muecke, "Simulation of Simplicity", 1990.
bool crosses(const Vec3d& a, const Vec3d& b, const Vec3d& c, const Ray& ray, double& t,
             bool& leaving);

}  // namespace triangle

class Triangle : public Shape {
 public:
  /// The material is not owned. Without area the triangle is never hit.
  Triangle(const Vec3d& a, const Vec3d& b, const Vec3d& c, const Material* material)
      : Shape(material), vertices_{a, b, c} {}

  /// Vertex 0, 1 or 2.
  const Vec3d& getVertex(int index) const { return vertices_[index]; }
  /// Whether its area normal, as it is computed, is other than zero: three points on a line may
  /// have one by rounding, and points closer than 1e-162 or so have none.
  bool hasArea() const { return areaNormal() != Vec3d(); }

  void visitCrossings(const Ray& ray, CrossingVisitor& visitor) const override;
  void addBounds(const Matrix& toWorld, BoundingBox& box) const override;
  bool isBounded() const override { return true; }

 private:
  bool nearestRoot(const Ray& ray, double tmin, double tmax, double& t) const override;
  Vec3d normalAt(const Vec3d& /*point*/) const override { return normalize(areaNormal()); }
  double extent() const override {
    return triangle::extent(vertices_[0], vertices_[1], vertices_[2]);
  }
  Vec3d areaNormal() const {
    return triangle::areaNormal(vertices_[0], vertices_[1], vertices_[2]);
  }

  Vec3d vertices_[3];
};
