// The one function that decides whether a ray hits a triangle, and where.
//
// With the vertices taken relative to the ray's origin, the edge from a to b is passed on the side
// that (b x a) . d has the sign of. The two triangles of a shared edge compute it from the same
// numbers, once as b x a and once as a x b, which differ in sign exactly; zero counts as inside.
// So no ray passes between them. Source of the edge functions: Woop, Benthin and Wald, "Watertight
// Ray/Triangle Intersection", 2013; here in double, without their shear.
#pragma once
#include <algorithm>

#include "geometry/ray.h"

namespace triangle {

/// Twice the area times the normal; the side from which a, b, c run counter-clockwise.
inline Vec3d areaNormal(const Vec3d& a, const Vec3d& b, const Vec3d& c) {
  return cross(b - a, c - a);
}

/// The largest coordinate of the three.
inline double extent(const Vec3d& a, const Vec3d& b, const Vec3d& c) {
  return std::max({maxAbs(a), maxAbs(b), maxAbs(c)});
}

/// Finds where the ray meets triangle abc (either side); on success stores the parameter in `t`,
/// whatever its sign. A triangle without area is never hit, nor is one seen exactly edge-on.
/// t never leaves the range of the three vertices, however flat the ray strikes.
bool intersect(const Vec3d& a, const Vec3d& b, const Vec3d& c, const Ray& ray, double& t);

/// Like intersect, but a ray through a shared edge or vertex crosses exactly one of the triangles
/// on each side of the surface: ties are broken as if the direction were turned by (e, e^2, e^3)
/// for an e too small to matter. Source: Edelsbrunner and Muecke, "Simulation of Simplicity", 1990.
bool crosses(const Vec3d& a, const Vec3d& b, const Vec3d& c, const Ray& ray, double& t);

}  // namespace triangle
