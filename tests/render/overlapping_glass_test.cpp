// -nested_dielectrics: random overlapping balls against a search of the strongest at each place.
#include <algorithm>
#include <memory>

#include "accel/compiled_scene.h"
#include "glasses.h"
#include "random.h"
#include "ray_log.h"
#include "scene_text.h"
#include "vectors.h"

using glasses::ball;
using glasses::Glass;
using glasses::Glasses;
using glasses::nested;
using scene_text::word;

namespace {

struct RandomBall {
  Vec3d center;
  double radius;
  float index;
};

/// The last ball of the list, which is the strongest, around `point`; -1: none.
int strongestAround(const std::vector<RandomBall>& balls, const Vec3d& point) {
  for (int i = int(balls.size()) - 1; i >= 0; --i) {
    const RandomBall& candidate = balls[std::size_t(i)];
    if (length(point - candidate.center) < candidate.radius) return i;
  }
  return -1;
}

float indexOf(const std::vector<RandomBall>& balls, int place) {
  return place < 0 ? 1 : balls[std::size_t(place)].index;
}

/// True when the bend from `in` to `out`, which begins on a ball, is what the balls around make it.
bool isRightBend(const std::vector<RandomBall>& balls, const Ray& in, const Ray& out) {
  const Vec3d point = out.getOrigin();
  const double step = 1e-6;
  const int before = strongestAround(balls, point - in.getDirection() * step);
  const int behind = strongestAround(balls, point + out.getDirection() * step);
  if (before == behind) return false;
  Vec3d normal;
  for (const RandomBall& b : balls) {
    if (std::fabs(length(point - b.center) - b.radius) < 1e-9) normal = normalize(point - b.center);
  }
  const Vec3d change = cross(normal, out.getDirection()) * double(indexOf(balls, behind)) -
                       cross(normal, in.getDirection()) * double(indexOf(balls, before));
  // In between nothing changes.
  const double way = length(point - in.getOrigin());
  for (int i = 1; i < 40; ++i) {
    const double t = way * i / 40;
    if (t < step || way - t < step) continue;
    if (strongestAround(balls, in.pointAtParameter(t)) != before) return false;
  }
  return length(change) < 1e-12;
}

}  // namespace

TEST("random overlapping balls bend rays by the strongest ball on each side") {
  Random random(91);
  // Every other time they differ in priority; else in size, and the smallest is the strongest.
  check::Cases cases;
  int bends = 0;
  for (int round = 0; round < 300; ++round) {
    std::vector<RandomBall> balls;
    std::vector<Glass> list;
    for (int i = 0; i < 8; ++i) {
      balls.push_back(
          {random.inCube(-1, 1), random.uniform(0.3, 1.5), float(random.uniform(1, 2))});
    }
    const bool isBySize = round % 2 == 1;
    if (isBySize) {
      std::sort(balls.begin(), balls.end(),
                [](const RandomBall& a, const RandomBall& b) { return a.radius > b.radius; });
    }
    for (int i = 0; i < 8; ++i) {
      const RandomBall& b = balls[std::size_t(i)];
      list.push_back({b.index, isBySize ? 5 : i * 3 - 10, ball(b.center, b.radius)});
    }
    const Glasses glasses(list);
    for (int k = 0; k < 20; ++k) {
      const Vec3d eye = random.inCube(-2, 2), ahead = random.unitVector();
      const auto path = glasses.path(eye, ahead, nested(10));
      for (std::size_t i = 1; i < path.size(); ++i) {
        ++bends;
        cases.expect(isRightBend(balls, path[i - 1], path[i]), [&] {
          return "round " + std::to_string(round) + " ray " + check::show(eye) + " along " +
                 check::show(ahead) + " bend " + std::to_string(i);
        });
      }
    }
  }
  CHECK(bends > 3000);
  CHECK_EQUAL(cases.firstFailure(), "");
}
