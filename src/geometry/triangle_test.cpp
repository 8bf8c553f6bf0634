// The triangle test: three edge functions in double, then the distance along the plane.
#include "geometry/triangle_test.h"

#include <algorithm>

namespace triangle {
namespace {

/// The vertices relative to the ray's origin, and the side on which the ray passes each edge.
struct EdgeFunctions {
  Vec3d a, b, c;
  Vec3d bc, ca, ab;  // c x b, a x c, b x a
  double u, v, w;    // the same, along the ray

  EdgeFunctions(const Vec3d& p, const Vec3d& q, const Vec3d& r, const Ray& ray)
      : a(p - ray.getOrigin()),
        b(q - ray.getOrigin()),
        c(r - ray.getOrigin()),
        bc(cross(c, b)),
        ca(cross(a, c)),
        ab(cross(b, a)),
        u(dot(ray.getDirection(), bc)),
        v(dot(ray.getDirection(), ca)),
        w(dot(ray.getDirection(), ab)) {}
};

/// Where the ray meets the plane of the triangle, kept between the nearest and farthest vertex.
bool distance(const EdgeFunctions& edges, const Vec3d& normal, const Ray& ray, double& t) {
  if (normal == Vec3d() || edges.u + edges.v + edges.w == 0) return false;
  const Vec3d& direction = ray.getDirection();
  const double lengthSquared = dot(direction, direction);
  const double ta = dot(edges.a, direction), tb = dot(edges.b, direction),
               tc = dot(edges.c, direction);
  const double nearest = std::min({ta, tb, tc}) / lengthSquared;
  const double farthest = std::max({ta, tb, tc}) / lengthSquared;
  const double root = dot(normal, edges.a) / dot(normal, direction);
  if (!(nearest <= farthest)) return false;  // the numbers have overflowed
  t = root >= nearest ? std::min(root, farthest) : nearest;
  return true;
}

/// The sign of an edge function, never 0 unless the edge points at the origin of the ray: where
/// the ray meets the edge, that of the first component that a turn of the direction brings in.
int signOf(double value, const Vec3d& edge) {
  const double first[] = {value, edge.x(), edge.y(), edge.z()};
  for (const double number : first) {
    if (number != 0) return number > 0 ? 1 : -1;
  }
  return 0;
}

}  // namespace

bool intersect(const Vec3d& a, const Vec3d& b, const Vec3d& c, const Ray& ray, double& t) {
  const EdgeFunctions edges(a, b, c, ray);
  const bool front = edges.u >= 0 && edges.v >= 0 && edges.w >= 0;
  const bool back = edges.u <= 0 && edges.v <= 0 && edges.w <= 0;
  return (front || back) && distance(edges, areaNormal(a, b, c), ray, t);
}

bool crosses(const Vec3d& a, const Vec3d& b, const Vec3d& c, const Ray& ray, double& t) {
  const EdgeFunctions edges(a, b, c, ray);
  const int u = signOf(edges.u, edges.bc), v = signOf(edges.v, edges.ca),
            w = signOf(edges.w, edges.ab);
  return u != 0 && u == v && v == w && distance(edges, areaNormal(a, b, c), ray, t);
}

}  // namespace triangle
