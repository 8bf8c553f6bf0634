// The triangle test: the ray's side of three edges, then the distance along the plane.
#include "geometry/triangle_test.h"

#include <algorithm>
#include <utility>

namespace triangle {
namespace {

struct PlanePoint {
  double x, y;
};

/// The ray as an axis: moves points along its direction onto the plane through its origin on which
/// the direction's largest component is constant.
class Projection {
 public:
  explicit Projection(const Vec3d& direction) {
    for (int axis = 1; axis < 3; ++axis) {
      if (std::fabs(direction[axis]) > std::fabs(direction[along_])) along_ = axis;
    }
    first_ = (along_ + 1) % 3;
    second_ = (along_ + 2) % 3;
    if (direction[along_] < 0) std::swap(first_, second_);  // turning right stays turning right
    slopeFirst_ = direction[first_] / direction[along_];
    slopeSecond_ = direction[second_] / direction[along_];
  }
  PlanePoint operator()(const Vec3d& p) const {
    return {p[first_] - slopeFirst_ * p[along_], p[second_] - slopeSecond_ * p[along_]};
  }

 private:
  int along_ = 0, first_, second_;
  double slopeFirst_, slopeSecond_;
};

/// The upper half of x's digits.
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
    const Projection project(ray.getDirection());
    pa = project(a);
    pb = project(b);
    pc = project(c);
  }
};

/// Where the ray meets the plane of the triangle, kept between the nearest and farthest vertex.
bool distance(const Seen& seen, const Vec3d& normal, const Ray& ray, double& t) {
  if (normal == Vec3d()) return false;
  const Vec3d& direction = ray.getDirection();
  const double lengthSquared = dot(direction, direction);
  const double ta = dot(seen.a, direction), tb = dot(seen.b, direction),
               tc = dot(seen.c, direction);
  const double nearest = std::min({ta, tb, tc}) / lengthSquared;
  const double farthest = std::max({ta, tb, tc}) / lengthSquared;
  const double root = dot(normal, seen.a) / dot(normal, direction);
  if (!(nearest <= farthest)) return false;  // the numbers have overflowed
  t = root >= nearest ? std::min(root, farthest) : nearest;
  return true;
}

}  // namespace

bool intersect(const Vec3d& a, const Vec3d& b, const Vec3d& c, const Ray& ray, double& t) {
  const Seen seen(a, b, c, ray);
  const int u = sideOf(seen.pb, seen.pc), v = sideOf(seen.pc, seen.pa);
  if (u * v < 0) return false;
  const int w = sideOf(seen.pa, seen.pb);
  if (u * w < 0 || v * w < 0 || (u == 0 && v == 0 && w == 0)) return false;
  return distance(seen, areaNormal(a, b, c), ray, t);
}

bool crosses(const Vec3d& a, const Vec3d& b, const Vec3d& c, const Ray& ray, double& t,
             bool& leaving) {
  const Seen seen(a, b, c, ray);
  const int u = movedSideOf(seen.pb, seen.pc), v = movedSideOf(seen.pc, seen.pa),
            w = movedSideOf(seen.pa, seen.pb);
  if (u == 0 || u != v || v != w || !distance(seen, areaNormal(a, b, c), ray, t)) return false;
  leaving = u > 0;
  return true;
}

}  // namespace triangle
