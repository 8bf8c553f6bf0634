// Cutting off ears.
//
// An ear is a corner at which the outline turns as the whole polygon does, and whose triangle with
// its two neighbours holds nothing else of the outline. It is cut off, and the outline has a corner
// less. Every simple polygon has two ears (Meisters, "Polygons Have Ears", 1975).
//
//   1. The corners are projected by leaving out the coordinate in which the polygon's normal is
//      largest: no number is rounded.
//   2. Where it turns one way only, and once around, the polygon is convex: a fan will do.
//   3. Where two sides cross, nothing is right.
//   4. Ears are looked for from corner to corner, beginning at the least one, so that the corner
//      that comes first does not matter. Only corners with the other turn can lie in an ear.
//
// A corner that is no ear becomes one only when a neighbour is cut off: what is inside of the rest
// of a polygon was inside of all of it. So each corner is looked at once, and again with every ear
// beside it.
//
// What is not strictly inside an ear may touch it. A corner at the same place as one of the ear's
// own intrudes where a side goes on from it into the ear, which is how slits look. Where nothing is
// left but corners on a line, their triangles have no area.
//
// The turn of three points is the sign of a sum of six products. A product of two floats is exact
// in double, and the sum is taken without rounding. Source for the sum: Shewchuk, "Adaptive
// Precision Floating-Point Arithmetic and Fast Robust Geometric Predicates", 1997.
#include "geometry/polygon.h"

#include <algorithm>
#include <cmath>

namespace {

struct Point {
  float x, y;

  bool operator==(const Point& other) const { return x == other.x && y == other.y; }
  /// From left to right, and upwards where neither is further left.
  bool operator<(const Point& other) const { return x < other.x || (x == other.x && y < other.y); }
};

/// The sign of the exact sum of six finite doubles: they are summed into parts that do not overlap,
/// of which the last one that is not 0 is larger than all before it together.
int signOfSum(const std::array<double, 6>& terms) {
  std::array<double, 6> parts{};
  for (std::size_t count = 0; count < terms.size(); ++count) {
    double sum = terms[count];
    for (std::size_t k = 0; k < count; ++k) {
      const double a = sum, b = parts[k];
      sum = a + b;
      const double rounded = sum - a;
      parts[k] = (a - (sum - rounded)) + (b - rounded);
    }
    parts[count] = sum;
  }
  for (std::size_t k = parts.size(); k-- > 0;) {
    if (parts[k] != 0) return parts[k] > 0 ? 1 : -1;
  }
  return 0;
}

/// 1 where a, b, c turn to the left, -1 where they turn to the right, 0 where they are on a line.
int turn(const Point& a, const Point& b, const Point& c) {
  const double ax = a.x, ay = a.y, bx = b.x, by = b.y, cx = c.x, cy = c.y;
  // In double the sum is off by less than 2^-50 of its parts.
  const double quick = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax);
  const double size =
      std::fabs(bx - ax) * std::fabs(cy - ay) + std::fabs(by - ay) * std::fabs(cx - ax);
  if (std::fabs(quick) > size * 0x1p-48) return quick > 0 ? 1 : -1;
  if (size == 0) return 0;  // no product of floats vanishes in double
  return signOfSum({ax * by, -(ax * cy), bx * cy, -(bx * ay), cx * ay, -(cx * by)});
}

/// The corners without the coordinate in which their normal is largest, as a view from the side
/// from which they turn to the left. Where the normal is 0, as both halves of a bow tie may have
/// the same area, from any side that shows an area, and `hasArea` is false; empty where none does.
/// Source of the normal: Newell, in Sutherland, Sproull and Schumacker, "A Characterization of Ten
/// Hidden-Surface Algorithms", 1974.
std::vector<Point> projected(const std::vector<Vec3f>& corners, bool& hasArea) {
  Vec3d normal, sizes;
  const Vec3d origin(corners[0]);
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const Vec3d area =
        cross(Vec3d(corners[k]) - origin, Vec3d(corners[(k + 1) % corners.size()]) - origin);
    normal += area;
    sizes += absolute(area);
  }
  hasArea = normal != Vec3d();
  const int axis = longestAxis(hasArea ? normal : sizes);
  std::vector<Point> points;
  if (sizes[axis] == 0) return points;
  int first = (axis + 1) % 3, second = (axis + 2) % 3;
  if (normal[axis] < 0) std::swap(first, second);
  for (const Vec3f& corner : corners) points.push_back({corner[first], corner[second]});
  return points;
}

/// The outline without corners that repeat the one before.
std::vector<Point> withoutRepeats(std::vector<Point> points) {
  points.erase(std::unique(points.begin(), points.end()), points.end());
  while (points.size() > 1 && points.back() == points.front()) points.pop_back();
  return points;
}

/// True where the outline, of corners that differ from the next, turns to the left alone, and goes
/// around once: its way from lesser to greater points changes into one back, and again, once each.
bool isConvex(const std::vector<Point>& points) {
  const std::size_t count = points.size();
  int changes = 0;
  for (std::size_t k = 0; k < count; ++k) {
    const Point &a = points[k], &b = points[(k + 1) % count], &c = points[(k + 2) % count];
    const int turned = turn(a, b, c);
    const bool hasChanged = (a < b) != (b < c);
    if (turned < 0 || (turned == 0 && hasChanged)) return false;  // on a line: it turns back
    changes += hasChanged;
  }
  return changes <= 2;
}

/// A side of the outline, from its lesser end to the other one.
struct Side {
  Point a, b;

  /// True where the two have a point inside of both in common, and are not on one line.
  bool crosses(const Side& other) const {
    return turn(a, b, other.a) * turn(a, b, other.b) < 0 &&
           turn(other.a, other.b, a) * turn(other.a, other.b, b) < 0;
  }
};

/// Compares sides with those that begin above them only: sorted from left to right.
bool crossesItself(const std::vector<Point>& points) {
  std::vector<Side> sides;
  for (std::size_t k = 0; k < points.size(); ++k) {
    const auto [a, b] = std::minmax({points[k], points[(k + 1) % points.size()]});
    sides.push_back({a, b});
  }
  std::sort(sides.begin(), sides.end(),
            [](const Side& one, const Side& other) { return one.a < other.a; });
  for (auto side = sides.begin(); side != sides.end(); ++side) {
    for (auto other = side + 1; other != sides.end() && other->a.x <= side->b.x; ++other) {
      if (side->crosses(*other)) return true;
    }
  }
  return false;
}

/// The corners that are left of an outline, in a ring.
class EarCutter {
 public:
  EarCutter(std::vector<Point> points, std::vector<OutlineTriangle>& triangles)
      : points_(std::move(points)), triangles_(triangles), rejected_(points_.size()) {
    const auto count = std::uint32_t(points_.size());
    for (std::uint32_t k = 0; k < count; ++k) {
      ring_.push_back({(k + count - 1) % count, (k + 1) % count});
      if (turnAt(k) <= 0) reflex_.push_back(k);
    }
  }

  /// False where at some time no ear is found, or what is left turns the other way.
  bool cutAll() {
    const auto least = std::min_element(points_.begin(), points_.end());
    std::uint32_t at = std::uint32_t(least - points_.begin());
    std::size_t left = points_.size(), passed = 0;
    while (left > 3) {
      // All the way around no ear: then corners on a line, which leave no area behind.
      const bool mayBeFlat = passed >= left;
      if (passed >= 2 * left) return false;
      if (rejected_[at] <= char(mayBeFlat) && isEar(at, mayBeFlat)) {
        cut(at);
        at = ring_[at].next;  // not the neighbour: slices stay short
        --left;
        passed = 0;
      } else {
        rejected_[at] = std::max(rejected_[at], char(1 + mayBeFlat));
        ++passed;
      }
      at = ring_[at].next;
    }
    triangles_.push_back({ring_[at].before, at, ring_[at].next});
    return turnAt(at) >= 0;
  }

 private:
  struct Neighbours {
    std::uint32_t before, next;
  };

  int turnAt(std::uint32_t at) const {
    return turn(points_[ring_[at].before], points_[at], points_[ring_[at].next]);
  }

  bool isEar(std::uint32_t at, bool mayBeFlat) const {
    const int turned = turnAt(at);
    if (turned <= 0) return turned == 0 && mayBeFlat;
    const std::uint32_t before = ring_[at].before, next = ring_[at].next;
    const Point ear[] = {points_[before], points_[at], points_[next]};
    const auto [left, right] = std::minmax({ear[0].x, ear[1].x, ear[2].x});
    const auto [low, high] = std::minmax({ear[0].y, ear[1].y, ear[2].y});
    for (const std::uint32_t k : reflex_) {
      const Point& p = points_[k];
      if (p.x < left || p.x > right || p.y < low || p.y > high) continue;
      if (k != before && k != at && k != next && intrudes(k, ear, mayBeFlat)) return false;
    }
    return true;
  }

  /// Whether a corner lies in an ear, or a side from it goes into the ear.
  bool intrudes(std::uint32_t k, const Point (&ear)[3], bool mayTouch) const {
    const Point& p = points_[k];
    int sides[3];
    for (int side = 0; side < 3; ++side) {
      sides[side] = turn(ear[side], ear[(side + 1) % 3], p);
      if (sides[side] < 0) return false;
    }
    for (int corner = 0; corner < 3; ++corner) {
      if (!(p == ear[corner])) continue;
      const Point &behind = ear[(corner + 1) % 3], &before = ear[(corner + 2) % 3];
      for (const std::uint32_t other : {ring_[k].before, ring_[k].next}) {
        if (turn(p, behind, points_[other]) > 0 && turn(before, p, points_[other]) > 0) return true;
      }
      return false;
    }
    return !mayTouch || *std::min_element(sides, sides + 3) > 0;
  }

  void cut(std::uint32_t at) {
    const auto [before, next] = ring_[at];
    triangles_.push_back({before, at, next});
    ring_[before].next = next;
    ring_[next].before = before;
    for (const std::uint32_t k : {before, at, next}) {
      rejected_[k] = 0;
      if (k != at && turnAt(k) <= 0) continue;
      const auto place = std::lower_bound(reflex_.begin(), reflex_.end(), k);
      if (place != reflex_.end() && *place == k) reflex_.erase(place);
    }
  }

  const std::vector<Point> points_;
  std::vector<OutlineTriangle>& triangles_;
  std::vector<Neighbours> ring_;
  /// Those that did not turn to the left, and still do not, by rising numbers.
  std::vector<std::uint32_t> reflex_;
  std::vector<char> rejected_;  // 1: it is no ear; 2: nor may anything be cut off there
};

}  // namespace

OutlineShape cutOutline(const std::vector<Vec3f>& corners,
                        std::vector<OutlineTriangle>& triangles) {
  triangles.clear();
  bool hasArea;
  std::vector<Point> points = projected(corners, hasArea);
  if (points.empty() || isConvex(withoutRepeats(points))) return OutlineShape::convex;
  if (crossesItself(points)) return OutlineShape::crossing;
  if (!hasArea) return OutlineShape::convex;
  if (EarCutter(std::move(points), triangles).cutAll()) return OutlineShape::concave;
  triangles.clear();
  return OutlineShape::crossing;
}
