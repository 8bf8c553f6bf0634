// The compiled scene gives exactly what the plain objects give, on random scenes.
#include "check.h"
#include "comparison.h"
#include "patience.h"
#include "random_scene.h"

using accel_test::Comparison;
using accel_test::kInf;
using accel_test::RandomScene;

namespace {

constexpr int kScenes = casesFor(200);

/// Scene `i` of the test: few and many objects, all sizes, some far from the origin.
RandomScene sceneOf(int i) {
  Random random(std::uint64_t(7000 + i));
  const int count = i % 5 == 0 ? 3 : i % 5 == 1 ? 120 : 30;
  const double size = i % 4 == 0 ? random.logUniform(1e-18, 1e18) : 1;
  const double away = i % 3 == 0 ? random.logUniform(1, 1e4) : 0;
  return RandomScene(std::uint64_t(i), count, size, random.unitVector() * (size * away));
}

std::string nameOf(int i) { return "scene " + std::to_string(i); }

/// The ray that leaves the surface of `hit`, as a mirror or a shadow ray would.
Ray leaving(const Hit& hit, const Vec3d& direction, bool withSource) {
  Ray ray(hit.getIntersectionPoint(), direction);
  if (withSource) ray.setSource(hit.getObject(), hit.getFace());
  return ray;
}

/// Rays from a point of a surface, and from there to a lamp.
void askFromSurface(RandomScene& scene, Comparison& comparison) {
  Hit hit;
  if (!scene.root().intersect(scene.ray(), hit, 0)) return;
  Random& random = scene.random();
  const double epsilon = random.index(3) ? hit.getMagnitude() * 0x1p-31 : 0;
  const Vec3d way = random.unitVector();
  const Ray away = leaving(hit, way, random.index(2) != 0);
  comparison.ask(away, epsilon, random.index(2) ? kInf : scene.size());
  const Vec3d toLamp = scene.somewhere() - hit.getIntersectionPoint();
  const Ray shadow = leaving(hit, normalize(toLamp), random.index(2) != 0);
  comparison.ask(shadow, epsilon, length(toLamp));
  comparison.askCrossings(shadow);
}

/// A tile of eye rays through one point, all with the same or with a bound of their own.
void askTile(RandomScene& scene, Comparison& comparison, int count) {
  Random& random = scene.random();
  const Vec3d aim = scene.target(), eye = aim + random.ofLength(0, 9) * scene.size();
  const Vec3d middle = scene.target() - eye;
  const double width = random.logUniform(1e-6, 3) * length(middle);
  std::vector<Ray> rays;
  std::vector<Hit> bounds;
  for (int i = 0; i < count; ++i) {
    const Vec3d direction = middle + random.inCube(-1, 1) * width;
    rays.emplace_back(eye, random.index(50) ? normalize(direction) : direction);
    bounds.emplace_back(random.index(3) ? kInf : random.uniform(0, 4) * scene.size());
  }
  comparison.askBatch(rays, scene.tmin(), bounds);
  // As a flat mirror sends them on: they start where they pass it, all but one.
  const double mirrorAt = random.uniform(0.01, 1.5);
  for (Ray& ray : rays) {
    const Vec3d& way = ray.getDirection();
    const double t = mirrorAt * (1 + 0.3 * dot(way, middle) / length(middle)) * length(middle);
    if (random.index(100)) ray = Ray(ray.pointAtParameter(t), way);
  }
  comparison.askBatch(rays, scene.tmin(), bounds);
}

/// Parallel rays, and rays that have nothing in common.
void askOtherBatches(RandomScene& scene, Comparison& comparison, int count) {
  Random& random = scene.random();
  std::vector<Ray> parallel, mixed;
  const Vec3d direction = random.unitVector();
  for (int i = 0; i < count; ++i) {
    parallel.emplace_back(scene.target() - direction * (2 * scene.size()), direction);
    mixed.push_back(scene.ray());
  }
  for (const auto& rays : {parallel, mixed}) {
    const double tmin = scene.tmin();
    comparison.askBatch(rays, tmin, scene.tmax());
  }
}

/// Shadow rays from all over a surface that end in one lamp.
void askLamp(RandomScene& scene, Comparison& comparison, int count) {
  Random& random = scene.random();
  const Vec3d place = scene.somewhere(), lamp = place * random.logUniform(0.5, 20);
  const Vec3d part = scene.target();
  const double width = scene.size() * random.logUniform(1e-6, 1);
  std::vector<ShadowQuery> queries;
  for (int i = 0; i < count; ++i) {
    const Vec3d from = part + random.inCube(-1, 1) * width, way = lamp - from;
    queries.push_back({Ray(from, normalize(way)), random.index(2) ? 0 : scene.size() * 1e-4,
                       random.index(20) ? length(way) : kInf});
  }
  comparison.askShadows(queries);
}

void checkAll(const Comparison& comparison) { CHECK_EQUAL(comparison.firstFailure(), ""); }

}  // namespace

TEST("single rays find in 200 random scenes what the plain objects give, bit for bit") {
  int hits = 0, tried = 0;
  for (int i = 0; i < kScenes; ++i) {
    RandomScene scene = sceneOf(i);
    Comparison comparison(scene.root(), nameOf(i));
    for (int k = 0; k < 150; ++k) {
      const Ray ray = scene.ray();
      const double tmin = scene.tmin();
      comparison.ask(ray, tmin, scene.tmax());
    }
    for (int k = 0; k < 50; ++k) comparison.askCrossings(scene.ray());
    for (int k = 0; k < 40; ++k) askFromSurface(scene, comparison);
    hits += comparison.hits();
    tried += comparison.tried();
    checkAll(comparison);
  }
  CHECK(tried > casesFor(100000) && hits > casesFor(20000));
}

TEST("batches find in 200 random scenes what the plain objects give, bit for bit") {
  // 512 rays walk a tree together.
  constexpr int kCounts[] = {
      1, 2, 3, 4, 7, 8, 9, 16, 63, 64, 100, 256, 511, 512, 513, 999, RayTable::kMost};
  int hits = 0;
  for (int i = 0; i < kScenes; ++i) {
    RandomScene scene = sceneOf(i);
    Comparison comparison(scene.root(), nameOf(i));
    for (int k = 0; k < 3; ++k) {
      askTile(scene, comparison, kCounts[std::size_t(i + 5 * k) % std::size(kCounts)]);
      askLamp(scene, comparison, kCounts[std::size_t(i + 5 * k) % std::size(kCounts)]);
    }
    askOtherBatches(scene, comparison, kCounts[std::size_t(i) % std::size(kCounts)]);
    hits += comparison.hits();
    checkAll(comparison);
  }
  CHECK(hits > casesFor(20000));
}
