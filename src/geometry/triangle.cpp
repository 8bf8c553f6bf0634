// Triangle: the ray's side of three edges, then the distance along the plane.
//
//   1. Take the corners relative to the ray's origin, and move each along the ray's direction onto
//      the plane across the direction's largest axis: drop that coordinate c and subtract c times
//      the direction's slopes. The ray becomes the point (0, 0), the corners become p, q, r.
//   2. The signs of q x r, r x p and p x q tell on which side of the three edges (0, 0) lies. All
//      one sign: inside, seen from the front or from behind; zeros may stand with either.
//   3. Rounded products can be equal where the exact ones are not. Only then the rests that
//      rounding has taken off are computed, and decide.
//   4. With N = (b - a) x (c - a), t = N . a / N . direction, kept between the nearest and the
//      farthest corner: for a ray that strikes very flat the quotient may lie anywhere.
//
// Whoever finds triangles faster may leave out only those that this test rejects, and takes t from
// the same operations.
#include "geometry/triangle.h"

#include <utility>

namespace triangle {
namespace {

/// A point on the plane across the ray.
struct PlanePoint {
  double x, y;
};

/// The upper half of x's digits: 26 of 53, so that the product of two halves is exact.
double upperHalf(double x) {
  const double shifted = 0x8000001p0 * x;  // 2^27 + 1
  return shifted - (shifted - x);
}

/// What rounding has taken off x * y to make it `product`.
double remainder(double x, double y, double product) {
  const double x1 = upperHalf(x), x2 = x - x1, y1 = upperHalf(y), y2 = y - y1;
  return ((x1 * y1 - product) + x1 * y2 + x2 * y1) + x2 * y2;
}

/// The sign of p x q, exactly (short of underflow): 1 where (0, 0) lies left of the way from p to
/// q. Products round in order, so that only equal ones need a closer look.
int sideOf(const PlanePoint& p, const PlanePoint& q) {
  const double left = p.x * q.y, right = p.y * q.x;
  if (left != right) return left > right ? 1 : -1;
  const double leftRest = remainder(p.x, q.y, left), rightRest = remainder(p.y, q.x, right);
  return leftRest > rightRest ? 1 : leftRest < rightRest ? -1 : 0;
}

/// Like sideOf, for (0, 0) moved by (e, e^2): 0 only where p and q are one point.
int movedSideOf(const PlanePoint& p, const PlanePoint& q) {
  const int side = sideOf(p, q);
  if (side != 0) return side;
  if (p.y != q.y) return p.y > q.y ? 1 : -1;
  return q.x > p.x ? 1 : q.x < p.x ? -1 : 0;
}

/// A triangle relative to the origin of a ray, and its corners on the plane across the ray.
struct Seen {
  Vec3d a, b, c;
  PlanePoint pa, pb, pc;

  Seen(const Vec3d& p, const Vec3d& q, const Vec3d& r, const Ray& ray)
      : a(p - ray.getOrigin()), b(q - ray.getOrigin()), c(r - ray.getOrigin()) {
    const Vec3d& direction = ray.getDirection();
    const int along = longestAxis(direction);
    int first = (along + 1) % 3, second = (along + 2) % 3;
    if (direction[along] < 0) std::swap(first, second);  // turning right stays turning right
    const double slopeFirst = direction[first] / direction[along];
    const double slopeSecond = direction[second] / direction[along];
    const auto project = [&](const Vec3d& corner) -> PlanePoint {
      return {corner[first] - slopeFirst * corner[along],
              corner[second] - slopeSecond * corner[along]};
    };
    pa = project(a);
    pb = project(b);
    pc = project(c);
  }
};

}  // namespace

bool intersect(const Vec3d& a, const Vec3d& b, const Vec3d& c, const Ray& ray, double& t) {
  const Seen seen(a, b, c, ray);
  const int u = sideOf(seen.pb, seen.pc), v = sideOf(seen.pc, seen.pa);
  if (u * v < 0) return false;
  const int w = sideOf(seen.pa, seen.pb);
  if (u * w < 0 || v * w < 0 || (u == 0 && v == 0 && w == 0)) return false;
  return distance(seen.a, seen.b, seen.c, areaNormal(a, b, c), ray.getDirection(), t);
}

Vec3d weightsAt(const Vec3d& a, const Vec3d& b, const Vec3d& c, const Vec3d& point) {
  const Vec3d whole = areaNormal(a, b, c);
  const int axis = longestAxis(whole);
  const auto share = [&](const Vec3d& from, const Vec3d& to) {
    return areaNormal(point, from, to)[axis] / whole[axis];
  };
  return {share(b, c), share(c, a), share(a, b)};
}

bool crosses(const Vec3d& a, const Vec3d& b, const Vec3d& c, const Ray& ray, double& t,
             bool& leaving) {
  const Seen seen(a, b, c, ray);
  const int u = movedSideOf(seen.pb, seen.pc), v = movedSideOf(seen.pc, seen.pa),
            w = movedSideOf(seen.pa, seen.pb);
  if (u == 0 || u != v || v != w) return false;
  leaving = u > 0;
  return distance(seen.a, seen.b, seen.c, areaNormal(a, b, c), ray.getDirection(), t);
}

}  // namespace triangle

bool Triangle::nearestRoot(const Ray& ray, double tmin, double tmax, double& t) const {
  const auto& [a, b, c] = vertices_;
  return !ray.leaves(this) && triangle::intersect(a, b, c, ray, t) && t > tmin && t < tmax;
}

void Triangle::visitCrossings(const Ray& ray, CrossingVisitor& visitor) const {
  const auto& [a, b, c] = vertices_;
  double t;
  bool leaving;
  if (!triangle::crosses(a, b, c, ray, t, leaving) || !(t > 0)) return;
  visitor.visit({t, this, getMaterial(), false, leaving});
}

void Triangle::addBounds(const Matrix& toWorld, BoundingBox& box) const {
  for (const Vec3d& vertex : vertices_) box.extend(toWorld.transformPoint(vertex));
}
