// Outlines cut into triangles: what they cover against the crossing rule, corner by corner around.
#include "geometry/polygon.h"

#include <algorithm>
#include <cmath>
#include <ctime>

#include "check.h"
#include "math/functions.h"
#include "patience.h"
#include "random.h"

namespace {

using Outline = std::vector<Vec3f>;

/// In the plane z = 0.
Outline flat(const std::vector<std::array<double, 2>>& corners) {
  Outline outline;
  for (const auto& [x, y] : corners) outline.push_back(Vec3f(Vec3d(x, y, 0)));
  return outline;
}

double area(const Vec3f& a, const Vec3f& b, const Vec3f& c) {
  return cross(Vec3d(b) - Vec3d(a), Vec3d(c) - Vec3d(a)).z() / 2;
}

double outlineArea(const Outline& outline) {
  double sum = 0;
  for (std::size_t k = 1; k + 1 < outline.size(); ++k) {
    sum += area(outline[0], outline[k], outline[k + 1]);
  }
  return sum;
}

/// Whether (x, y) is inside: a ray to the right crosses the outline an odd number of times.
bool isInside(const Outline& outline, double x, double y) {
  bool inside = false;
  for (std::size_t k = 0; k < outline.size(); ++k) {
    const Vec3d a(outline[k]), b(outline[(k + 1) % outline.size()]);
    if ((a.y() > y) == (b.y() > y)) continue;
    inside ^= a.x() + (y - a.y()) / (b.y() - a.y()) * (b.x() - a.x()) > x;
  }
  return inside;
}

/// How many of the triangles hold (x, y).
int covering(const Outline& outline, const std::vector<OutlineTriangle>& triangles, double x,
             double y) {
  int count = 0;
  for (const OutlineTriangle& t : triangles) {
    count += isInside({outline[t[0]], outline[t[1]], outline[t[2]]}, x, y);
  }
  return count;
}

/// Cuts a concave outline of either turn from each of `starts` corners, and looks at random places.
void checkCut(const Outline& outline, int starts = 1 << 30, int places = 200) {
  Random random(outline.size());
  Vec3f low = outline[0], high = low;
  for (const Vec3f& p : outline) {
    low = -largest(-low, -p);
    high = largest(high, p);
  }
  for (const bool isReversed : {false, true}) {
    Outline turned = outline;
    if (isReversed) std::reverse(turned.begin(), turned.end());
    for (int start = 0; start < std::min(starts, int(outline.size())); ++start) {
      std::vector<OutlineTriangle> triangles;
      CHECK(cutOutline(turned, triangles) == OutlineShape::concave);
      CHECK_EQUAL(triangles.size(), turned.size() - 2);
      const double whole = outlineArea(turned);
      double sum = 0;
      for (const OutlineTriangle& t : triangles) {
        const double own = area(turned[t[0]], turned[t[1]], turned[t[2]]);
        CHECK(own * whole >= 0);
        sum += own;
      }
      CHECK_NEAR(sum, whole, std::fabs(whole) * 1e-6);
      for (int place = 0; place < places; ++place) {
        const double x = random.uniform(low.x(), high.x()), y = random.uniform(low.y(), high.y());
        CHECK_EQUAL(covering(turned, triangles, x, y), isInside(turned, x, y) ? 1 : 0);
      }
      std::rotate(turned.begin(), turned.begin() + 1, turned.end());
    }
  }
}

/// A ring of corners at angles that grow, at random distances: simple, and seldom convex.
Outline star(int corners, Random& random) {
  Outline outline;
  for (int k = 0; k < corners; ++k) {
    const double angle = 2 * math::kPi * k / corners, radius = random.uniform(0.2, 1);
    outline.push_back(Vec3f(Vec3d(radius * math::cos(angle), radius * math::sin(angle), 0)));
  }
  return outline;
}

}  // namespace

TEST("the outline around a doorway leaves the door open") {
  const Outline door = flat({{0, 0}, {3, 0}, {3, 3}, {2, 3}, {2, 1}, {1, 1}, {1, 3}, {0, 3}});
  checkCut(door);
  std::vector<OutlineTriangle> triangles;
  cutOutline(door, triangles);
  CHECK_EQUAL(covering(door, triangles, 1.5, 2), 0);
  CHECK_EQUAL(covering(door, triangles, 1.5, 0.5), 1);
  CHECK_EQUAL(outlineArea(door), 7.0);
}

TEST("arrows, combs, spirals and random stars are covered once") {
  checkCut(flat({{0, 0}, {4, 2}, {0, 4}, {1, 2}}));
  Outline comb, spiral;
  for (int k = 0; k < 12; ++k) comb.push_back(Vec3f(Vec3d(k, k % 2 == 0 ? 0 : 3, 0)));
  comb.push_back({11, -1, 0});
  comb.push_back({0, -1, 0});
  checkCut(comb);
  for (int k = 0; k <= 40; ++k) {
    const double angle = 0.3 * k;
    spiral.push_back(
        Vec3f(Vec3d((1 + 0.2 * k) * math::cos(angle), (1 + 0.2 * k) * math::sin(angle), 0)));
  }
  for (int k = 40; k >= 0; --k) {
    const double angle = 0.3 * k, radius = 0.6 + 0.2 * k;
    spiral.push_back(Vec3f(Vec3d(radius * math::cos(angle), radius * math::sin(angle), 0)));
  }
  checkCut(spiral, 5);
  Random random(3);
  for (int corners = 8; corners < 60; corners += 3) checkCut(star(corners, random), 7);
}

TEST("a slit joins the outline of a hole to the one around it") {
  // A square with a square hole, and one with two; each slit is walked along twice.
  checkCut(flat({{0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 0}, {1, 1}, {1, 3}, {3, 3}, {3, 1}, {1, 1}}));
  checkCut(flat({{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {3, 2}, {3, 1}, {2, 1}, {2, 0}, {8, 0},
                 {8, 3}, {5, 3}, {5, 2}, {6, 2}, {6, 1}, {4, 1}, {4, 2}, {5, 2}, {5, 3}, {0, 3}}));
}

TEST("repeated corners and corners on a line change nothing") {
  checkCut(flat({{0, 0},
                 {1, 0},
                 {2, 0},
                 {3, 0},
                 {3, 3},
                 {2, 3},
                 {2, 3},
                 {2, 2},
                 {2, 1},
                 {1, 1},
                 {1, 1},
                 {1, 1},
                 {1, 3},
                 {0, 3},
                 {0, 2},
                 {0, 1}}));
  // A reflex corner that is repeated is one.
  checkCut(flat({{0, 0}, {4, 2}, {0, 4}, {1, 2}, {1, 2}}));
}

TEST("convex outlines and those without area are left alone, crossing ones told") {
  std::vector<OutlineTriangle> triangles;
  const auto shapeOf = [&](const Outline& outline) { return cutOutline(outline, triangles); };
  CHECK(shapeOf(flat({{0, 0}, {1, 0}, {1, 1}, {0, 1}})) == OutlineShape::convex);
  CHECK(shapeOf(flat({{0, 0}, {0.5, 0}, {1, 0}, {1, 1}, {1, 1}, {0, 1}})) == OutlineShape::convex);
  CHECK(shapeOf(flat({{0, 0}, {1, 0}, {2, 0}, {1, 0}})) == OutlineShape::convex);
  CHECK(shapeOf(flat({{1, 1}, {1, 1}, {1, 1}, {1, 1}})) == OutlineShape::convex);
  CHECK(shapeOf(flat({{0, 0}, {2, 3}, {2, 0}, {0, 2}})) == OutlineShape::crossing);
  // The halves of a bow tie have the same area, and turn in opposite ways: their sum is none. There
  // and back is none either, but crosses nothing.
  CHECK(shapeOf(flat({{-1, -1}, {1, -1}, {-1, 1}, {1, 1}})) == OutlineShape::crossing);
  CHECK(shapeOf(flat({{-1, -1}, {1, 1}, {1, -1}, {-1, 1}})) == OutlineShape::crossing);
  CHECK(shapeOf(flat({{0, 0}, {1, 0}, {1, 1}, {1, 0}})) == OutlineShape::convex);
  // A star of five points in one stroke goes around twice.
  Outline pentagram;
  for (int k = 0; k < 5; ++k) {
    const double angle = 4 * math::kPi * k / 5;
    pentagram.push_back(Vec3f(Vec3d(math::cos(angle), math::sin(angle), 0)));
  }
  CHECK(shapeOf(pentagram) == OutlineShape::crossing);
  CHECK(triangles.empty());
}

TEST("outlines in any plane, far from 0, or bent a little are cut alike") {
  const Outline door = flat({{0, 0}, {3, 0}, {3, 3}, {2, 3}, {2, 1}, {1, 1}, {1, 3}, {0, 3}});
  std::vector<OutlineTriangle> expected, found;
  cutOutline(door, expected);
  for (int axis = 0; axis < 3; ++axis) {
    Outline turned;
    for (const Vec3f& p : door) {
      Vec3f q;
      q[(axis + 1) % 3] = p.x() + 4096;
      q[(axis + 2) % 3] = p.y();
      q[axis] = 0.01f * p.x() * p.y();
      turned.push_back(q);
    }
    CHECK(cutOutline(turned, found) == OutlineShape::concave);
    CHECK(found == expected);
  }
}

TEST("an outline of 10,000 corners takes less than a second") {
  constexpr int kHalf = 5000;
  Random random(5);
  Outline spiral, ribbon, line = flat({{10000, 9}, {5000, 4}, {0, 9}});
  for (int k = 0; k < 2 * kHalf; ++k) {
    const int along = k < kHalf ? k : 2 * kHalf - 1 - k;  // there, and back beside it
    const double angle = 0.05 * along, radius = along + (k < kHalf ? 9 : 69);
    spiral.push_back(Vec3f(Vec3d(radius * math::cos(angle), radius * math::sin(angle), 0)));
    ribbon.push_back(Vec3f(float(along), (along % 2 ? 1 : 200) + (k < kHalf ? 0.0f : 1.0f), 0));
    line.push_back(Vec3f(float(k), 0, 0));
  }
  for (const Outline& outline : {star(2 * kHalf, random), spiral, ribbon, line}) {
    std::vector<OutlineTriangle> triangles;
    const std::clock_t start = std::clock();
    CHECK(cutOutline(outline, triangles) == OutlineShape::concave);
    CHECK(double(std::clock() - start) / CLOCKS_PER_SEC < kPatience);
    CHECK_EQUAL(triangles.size(), outline.size() - 2);
  }
}
