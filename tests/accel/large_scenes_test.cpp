// Scenes of a million parts build and answer in a few seconds, whatever their shape. A plain walk
// over them would be too slow, so what each ray must find is worked out beforehand.
#include <chrono>

#include "check.h"
#include "comparison.h"
#include "random_scene.h"

using accel_test::kInf;

namespace {

#ifdef NDEBUG
constexpr int kMany = 1000000;
#else
constexpr int kMany = 30000;
#endif
/// Ten times what two slow cores need; a quadratic case would take hours.
constexpr double kMostSeconds = 20;

const PhongMaterial kMaterial = shapes::plainMaterial();

class Timer {
 public:
  double seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

template <class T>
Group groupOf(const std::vector<T>& objects) {
  Group group;
  for (const T& object : objects) group.addObject(&object);
  return group;
}

}  // namespace

TEST("of a million equal triangles the first one is hit") {
  const Timer timer;
  const std::vector<Triangle> all(std::size_t(kMany),
                                  Triangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, &kMaterial));
  const Group group = groupOf(all);
  const CompiledScene scene(group, 2);
  Hit hit;
  CHECK(scene.intersect(Ray({0.25, 0.25, 2}, {0, 0, -1}), hit, 0));
  CHECK_EQUAL(hit.getT(), 2.0);
  CHECK(hit.getObject() == &all[0]);
  CHECK(scene.occluded(Ray({0.25, 0.25, 2}, {0, 0, -1}), 0, 3));
  CHECK(!scene.occluded(Ray({0.75, 0.75, 2}, {0, 0, -1}), 0, 3));
  CHECK(timer.seconds() < kMostSeconds);
}

TEST("a million equal faces of a mesh give the first one") {
  const Timer timer;
  const MeshGeometry geometry({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}},
                              std::vector<MeshGeometry::Face>(std::size_t(kMany), {0, 1, 2}));
  const TriangleMesh mesh(&geometry, &kMaterial);
  const CompiledScene scene(mesh, 2);
  Hit hit;
  CHECK(scene.intersect(Ray({0.25, 0.25, 2}, {0, 0, -1}), hit, 0));
  CHECK_EQUAL(hit.getT(), 2.0);
  CHECK_EQUAL(hit.getFace(), 0u);
  CHECK(timer.seconds() < kMostSeconds);
}

TEST("in a row of a million spheres each one is found, across and along the row") {
  const Timer timer;
  std::vector<Sphere> all;
  for (int i = 0; i < kMany; ++i) all.emplace_back(Vec3d(2.0 * i, 0, 0), 0.5, &kMaterial);
  const Group group = groupOf(all);
  const CompiledScene scene(group, 2);
  check::Cases cases;
  Random random(41);
  for (int k = 0; k < 2000; ++k) {
    const int i = random.index(kMany - 1);
    const Vec3d above(2.0 * i, 0, 7), gap(2.0 * i + 1, 0, 0);
    // From above at 7 down to 0.5; from the gap behind sphere i to the next one, half a unit on.
    Hit across, along;
    scene.intersect(Ray(above, {0, 0, -1}), across, 0);
    scene.intersect(Ray(gap, {1, 0, 0}), along, 0);
    cases.expect(across.getT() == 6.5 && across.getObject() == &all[std::size_t(i)],
                 [&] { return "across " + std::to_string(i); });
    cases.expect(along.getT() == 0.5 && along.getObject() == &all[std::size_t(i) + 1],
                 [&] { return "along " + std::to_string(i); });
    cases.expect(!scene.occluded(Ray(gap, {0, 0, 1}), 0, kInf),
                 [&] { return "through the gap at " + std::to_string(i); });
  }
  CHECK_EQUAL(cases.firstFailure(), "");
  CHECK(timer.seconds() < kMostSeconds);
}

TEST("spheres whose sizes and distances double a thousand times are all found") {
  // Ball k of radius 2^k at x = 4 * 2^k: from below, each is met at height -2^k.
  std::vector<Sphere> all;
  for (int k = -450; k < 450; ++k) {
    all.emplace_back(Vec3d(std::ldexp(4.0, k), 0, 0), std::ldexp(1.0, k), &kMaterial);
  }
  const Group group = groupOf(all);
  const CompiledScene scene(group, 2);
  for (int k = -440; k < 450; k += 10) {
    const double r = std::ldexp(1.0, k);
    Hit hit;
    CHECK(scene.intersect(Ray({4 * r, -3 * r, 0}, {0, 1, 0}), hit, 0));
    CHECK_EQUAL(hit.getT(), 2 * r);
  }
}

TEST("a million Transforms of one sphere each show it in its place") {
  const Timer timer;
  const Sphere ball({0, 0, 0}, 1, &kMaterial);
  const int side = int(std::sqrt(double(kMany)));
  std::vector<Transform> all;
  all.reserve(std::size_t(side) * std::size_t(side));
  for (int i = 0; i < side * side; ++i) {
    // Squeezed to a half in z: its top is at height 0.5.
    all.emplace_back(
        Matrix::translation({4.0 * (i % side), 4.0 * (i / side), 0}) * Matrix::scale({1, -1, 0.5}),
        &ball);
  }
  const Group group = groupOf(all);
  const CompiledScene scene(group, 2);
  check::Cases cases;
  Random random(42);
  for (int k = 0; k < 2000; ++k) {
    const Vec3d above{4.0 * random.index(side), 4.0 * random.index(side), 3};
    Hit hit;
    scene.intersect(Ray(above, {0, 0, -1}), hit, 0);
    cases.expect(hit.getT() == 2.5 && hit.getNormal() == Vec3d(0, 0, 1),
                 [&] { return "at " + check::show(above); });
  }
  CHECK_EQUAL(cases.firstFailure(), "");
  CHECK(timer.seconds() < kMostSeconds);
}

TEST("10,000 meshes of one geometry share its tree") {
  const Timer timer;
  const MeshGeometry geometry = shapes::ball(5);  // 8192 triangles
  std::vector<TriangleMesh> meshes;
  std::vector<Transform> all;
  all.reserve(10000);
  meshes.reserve(10000);
  for (int i = 0; i < 10000; ++i) {
    meshes.emplace_back(&geometry, &kMaterial);
    all.emplace_back(Matrix::translation({4.0 * (i % 100), 4.0 * (i / 100), 0}), &meshes.back());
  }
  const Group group = groupOf(all);
  const CompiledScene scene(group, 2);
  // One tree of 8192 triangles takes below 1 MB, 10,000 boxes likewise.
  CHECK(scene.treeBytes() < 4000000);
  for (int i = 0; i < 10000; i += 7) {
    Hit hit;
    CHECK(scene.intersect(Ray({4.0 * (i % 100), 4.0 * (i / 100), 3}, {0, 0, -1}), hit, 0));
    CHECK_EQUAL(hit.getT(), 2.0);  // the pole of the ball, a vertex, is at height 1
    CHECK(hit.getObject() == &meshes[std::size_t(i)]);
  }
  CHECK(timer.seconds() < kMostSeconds);
}
