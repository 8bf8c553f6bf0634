// Meshes of long thin slanting triangles: their parts hold all of them, the tree over the parts
// answers as the plain mesh, and it tests fewer.
#include <algorithm>
#include <cstring>

#include "accel/build_range.h"
#include "accel/mesh_items.h"
#include "comparison.h"
#include "patience.h"
#include "random_scene.h"

namespace {

using accel::BuildItem;
using accel_test::Comparison;
using accel_test::kInf;
using accel_test::Owner;

/// Vertices and faces while they are put together.
struct Soup {
  std::vector<Vec3f> vertices;
  std::vector<MeshGeometry::Face> faces;

  void add(const MeshGeometry& mesh) {
    const auto first = std::uint32_t(vertices.size());
    for (const Vec3f& v : mesh.getVertices()) vertices.push_back(v);
    for (const MeshGeometry::Face& f : mesh.getFaces()) {
      faces.push_back({f[0] + first, f[1] + first, f[2] + first});
    }
  }
  /// A thin tetrahedron, its faces outwards, from one point to another.
  void addNeedle(const Vec3d& from, const Vec3d& to, double width) {
    const Vec3d along = normalize(to - from), side = normalize(cross(along, Vec3d(1, 2, 3)));
    const Vec3d other = cross(along, side);
    add(MeshGeometry({Vec3f(from), Vec3f(to + side * width), Vec3f(to + other * width),
                      Vec3f(to - (side + other) * width)},
                     {{0, 2, 1}, {0, 3, 2}, {0, 1, 3}, {1, 2, 3}}));
  }
  MeshGeometry geometry() const { return MeshGeometry(vertices, faces); }
};

/// Glass needles across a cube of the size in any direction, each `copies` times.
Soup needles(int count, double size, int copies, const Vec3d& center = {}) {
  Soup soup;
  Random random(3);
  for (int i = 0; i < count; ++i) {
    const Vec3d from = center + random.inCube(-size, size);
    const Vec3d to = center + random.inCube(-size, size);
    for (int k = 0; k < copies; ++k) soup.addNeedle(from, to, 1e-3 * size);
  }
  return soup;
}

/// Single triangles from one point in all directions.
Soup fan(int count) {
  Soup soup;
  Random random(4);
  for (int i = 0; i < count; ++i) {
    const Vec3d end = random.unitVector(), side = random.ofLength(0, 1e-3);
    soup.add(MeshGeometry({{0, 0, 0}, Vec3f(end - side), Vec3f(end + side)}, {{0, 1, 2}}));
  }
  return soup;
}

std::vector<BuildItem> itemsOf(const MeshGeometry& mesh, int threads, bool inParts) {
  std::vector<BuildItem> found;
  accel::ThreadPool::run(threads, mesh.faceCount(), [&](accel::ThreadPool& pool) {
    accel::MeshItems all = accel::meshItems(mesh, 1, pool);
    if (inParts) CHECK(accel::divideIntoParts(mesh, 1, all));
    found.assign(all.items.data(), all.items.data() + all.items.count());
  });
  return found;
}

bool isIn(const Vec3d& point, const BuildItem& item) {
  for (int axis = 0; axis < 3; ++axis) {
    if (point[axis] < double(item.low[axis]) || point[axis] > double(item.high[axis])) return false;
  }
  return true;
}

double halfAreas(const std::vector<BuildItem>& items) {
  double sum = 0;
  for (const BuildItem& item : items) sum += double(accel::Box4::of(item).halfArea());
  return sum;
}

/// Asks all questions of the mesh, for rays at its faces, along them, and away from them.
void expectAsPlain(const MeshGeometry& shape, double size, const Vec3d& center) {
  Owner owner;
  const auto* geometry = owner.geometry(shape);
  const auto& mesh = owner.make<TriangleMesh>(geometry, owner.material(0));
  CHECK(accel::MeshTree(*geometry, 1).bvh().isInParts);
  Comparison comparison(mesh, "needles");
  Random random(5);
  std::vector<ShadowQuery> queries;
  for (int i = 0; i < casesFor(400); ++i) {
    const auto face = std::uint32_t(random.index(int(geometry->faceCount())));
    const auto [a, b, c] = geometry->corners(face);
    const double share = random.index(3) * 0.5 * random.uniform(0, 1);
    const Vec3d to = a + (b - a) * share + (c - a) * random.uniform(0, 1 - share);
    const int kind = random.index(4);
    const Vec3d from = kind == 0 ? b + (b - a) * random.uniform(0, 1)
                                 : center + random.inCube(-2, 2) * (kind == 1 ? 0.1 : 1) * size;
    Ray ray(from, to - from);
    if (kind == 2) {
      ray = Ray(to, from - to);
      ray.setSource(&mesh, face);
    }
    const double tmax = random.index(3) ? kInf : random.uniform(0, 1.5);
    queries.push_back({ray, 0, tmax});
  }
  comparison.askAll(queries);
  CHECK(comparison.hits() > casesFor(400));
}

}  // namespace

TEST("every point of a face is in one of its parts, which are few, not short, and all inside") {
  for (const MeshGeometry& mesh : {needles(1000, 1, 1).geometry(), fan(40000).geometry()}) {
    const std::vector<BuildItem> whole = itemsOf(mesh, 1, false), parts = itemsOf(mesh, 1, true);
    CHECK(parts.size() > 2 * whole.size() && parts.size() <= accel::kMostParts * whole.size());
    std::size_t part = 0;  // those of an item lie together, in the order of the items
    Random random(6);
    int outside = 0, tooShort = 0, uncovered = 0;
    for (const BuildItem& item : whole) {
      const std::size_t first = part;
      for (; part < parts.size() && parts[part].id == item.id; ++part) {
        double longest = 0;
        for (int axis = 0; axis < 3; ++axis) {
          outside += parts[part].low[axis] < item.low[axis];
          outside += parts[part].high[axis] > item.high[axis];
          longest = std::max(longest, double(parts[part].high[axis] - parts[part].low[axis]));
        }
        // The mesh's side is 2; what is shorter as a whole stays whole.
        tooShort += part > first && longest < 1.99 / accel::kFinest;
      }
      for (int k = 0; k < 20; ++k) {
        const auto [a, b, c] = mesh.corners(item.id + std::uint32_t(k % item.primitives));
        const double u = random.index(3) * 0.5, v = random.uniform(0, 1);
        const Vec3d point = a + (b - a) * ((1 - v) * u) + (c - a) * (v * (1 - u));
        uncovered += std::none_of(&parts[first], &parts[first] + (part - first),
                                  [&](const BuildItem& each) { return isIn(point, each); });
      }
    }
    CHECK_EQUAL(part, parts.size());
    CHECK_EQUAL(outside, 0);
    CHECK_EQUAL(tooShort, 0);
    CHECK_EQUAL(uncovered, 0);
  }
}

TEST("parts do not depend on the number of threads") {
  const MeshGeometry mesh = fan(70000).geometry();
  const std::vector<BuildItem> one = itemsOf(mesh, 1, true), three = itemsOf(mesh, 3, true);
  CHECK_EQUAL(one.size(), three.size());
  CHECK(std::memcmp(one.data(), three.data(), one.size() * sizeof one[0]) == 0);
}

TEST("ordinary meshes, few needles and nothing at all are not divided") {
  for (const MeshGeometry& mesh :
       {shapes::ball(5), needles(50, 1, 1).geometry(), MeshGeometry(), fan(1).geometry()}) {
    accel::ThreadPool alone;
    accel::MeshItems all = accel::meshItems(mesh, 1, alone);
    CHECK(!accel::divideIntoParts(mesh, 1, all));
  }
}

TEST("needles of any size answer as the plain mesh, each crossing once") {
  for (const double size : {1e-6, 1.0, 1e12}) {
    expectAsPlain(needles(800, size, 1).geometry(), size, {});
  }
  expectAsPlain(needles(800, 1, 1, {300, -200, 100}).geometry(), 1, {300, -200, 100});
  expectAsPlain(fan(3000).geometry(), 1, {});
}

TEST("needles through a ball far smaller than they are answer as the plain mesh") {
  Soup soup = needles(700, 1, 1);
  for (int i = 0; i < 20; ++i) {
    soup.addNeedle(Vec3d(0.9, 0.02 * i, -0.5), Vec3d(-0.9, -0.02 * i, 0.5), 1e-5);
  }
  soup.add(accel_test::moved(shapes::ball(3), 1e-5f, {0, 0, 0}));
  expectAsPlain(soup.geometry(), 1, {});
}

TEST("needles that are there several times answer as the plain mesh") {
  const MeshGeometry mesh = needles(700, 1, 12).geometry();
  CHECK(accel::MeshTree(mesh, 1).copiesOf(0) != nullptr);
  expectAsPlain(mesh, 1, {});
}

TEST("a ray among needles meets a third of the boxes, and half as many faces are tested") {
  // n parts of a needle have a / n together of its surface a, and there are 4 of each on average.
  const MeshGeometry mesh = fan(6000).geometry();
  CHECK(halfAreas(itemsOf(mesh, 1, true)) < 0.33 * halfAreas(itemsOf(mesh, 1, false)));

  const PhongMaterial material = shapes::plainMaterial();
  const TriangleMesh object(&mesh, &material);
  TestTally tally;
  const CompiledScene scene(object, 1, SimdLevel::automatic, &tally);
  Random random(7);
  constexpr int kRays = 1000;
  for (int i = 0; i < kRays; ++i) {
    const Vec3d from = random.unitVector(), to = random.unitVector();
    Hit hit;
    scene.intersect(Ray(from, to - from), hit, 0);
  }
  // A tree over whole needles takes 635 for each ray.
  CHECK(tally.total().nearest.primitives < 635 / 2 * std::uint64_t(kRays));
}
