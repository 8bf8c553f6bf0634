// RayTable and HitTable: rows become columns and rows again, bit by bit.
#include "geometry/ray_table.h"

#include <cstring>
#include <vector>

#include "geometry/triangle_mesh.h"
#include "random.h"
#include "shapes.h"
#include "vectors.h"

namespace {

constexpr double kInf = std::numeric_limits<double>::infinity();

bool sameBits(double a, double b) { return std::memcmp(&a, &b, sizeof a) == 0; }
bool sameBits(const Vec3d& a, const Vec3d& b) {
  return sameBits(a.x(), b.x()) && sameBits(a.y(), b.y()) && sameBits(a.z(), b.z());
}

/// Components of any size, among them zeros of both signs.
Vec3d anyVector(Random& random) {
  Vec3d v;
  for (int axis = 0; axis < 3; ++axis) {
    const double size = random.index(4) ? random.logUniform(1e-300, 1e300) : 0.0;
    v[axis] = random.index(2) ? size : -size;
  }
  return v;
}

}  // namespace

TEST("a ray comes out of a table as it went in, with the surface that it leaves") {
  Arena arena;
  Random random(1);
  const Object3D* const surfaces[] = {nullptr, reinterpret_cast<const Object3D*>(&arena)};
  for (const int count : {1, 3, 64, RayTable::kMost}) {
    const Arena::Frame frame(arena);
    RayTable table(arena, count, true);
    CHECK_EQUAL(table.count, count);
    std::vector<Ray> rays;
    for (int i = 0; i < count; ++i) {
      rays.emplace_back(anyVector(random), anyVector(random));
      rays.back().setSource(surfaces[random.index(2)], std::uint32_t(random.index(9)));
      table.setRow(i, rays.back(), -i, i % 3 ? i : kInf);
    }
    for (int i = 0; i < count; ++i) {
      const Ray ray = table.rayOf(i), &expected = rays[std::size_t(i)];
      CHECK(sameBits(ray.getOrigin(), expected.getOrigin()));
      CHECK(sameBits(ray.getDirection(), expected.getDirection()));
      CHECK(sameBits(table.originOf(i), expected.getOrigin()));
      CHECK(sameBits(table.directionOf(i), expected.getDirection()));
      CHECK(ray.getSource() == expected.getSource());
      CHECK_EQUAL(ray.getSourceFace(), expected.getSourceFace());
      CHECK(sameBits(table.tmin[i], -i) && sameBits(table.tmax[i], i % 3 ? i : kInf));
    }
  }
}

TEST("in a table without columns for them rays leave no surface") {
  Arena arena;
  RayTable table(arena, 1, false);
  CHECK(table.source == nullptr && table.sourceFace == nullptr);
  Ray ray({1, 2, 3}, {4, 5, 6});
  ray.setSource(reinterpret_cast<const Object3D*>(&arena), 7);
  table.setRow(0, ray, 0, 1);
  CHECK(table.rayOf(0).getSource() == nullptr);
  CHECK(sameBits(table.rayOf(0).getDirection(), {4, 5, 6}));
}

TEST("nothing is found in a new table of hits; a hit comes out of it as it went in") {
  Arena arena;
  Random random(2);
  const PhongMaterial material = shapes::plainMaterial();
  MeshGeometry geometry = shapes::cube(1);
  const TriangleMesh plain(&geometry, &material);
  MeshGeometry pictured = shapes::cube(1);
  pictured.setShading({{}, {}, {{0, 0}}, std::vector<MeshShading::Face>(12)});
  const TriangleMesh textured(&pictured, &material);
  HitTable hits(arena, 100);
  for (int i = 0; i < 100; ++i) CHECK(!hits.isFound(i) && !hits.hitOf(i, 1).getMaterial());
  for (int i = 0; i < 100; i += 3) {
    const double t = random.logUniform(1e-9, 1e9);
    Hit hit;
    const TriangleMesh* const object = i % 2 == 0 ? &plain : &textured;
    hit.record(
        t, &material, anyVector(random), anyVector(random),
        {object, std::uint32_t(i), random.logUniform(1e-9, 1e9), Vec2d(i % 2 * 3, i % 2 * 5)});
    hits.setRow(i, hit, std::uint32_t(2 * i));
    const Hit found = hits.hitOf(i, t);
    CHECK(hits.isFound(i));
    CHECK_EQUAL(hits.order[i], std::uint32_t(2 * i));
    CHECK(sameBits(found.getT(), t) && sameBits(found.getMagnitude(), hit.getMagnitude()));
    CHECK(found.getMaterial() == &material && found.getObject() == object);
    CHECK_EQUAL(found.getFace(), std::uint32_t(i));
    CHECK(sameBits(found.getNormal(), hit.getNormal()));
    CHECK(sameBits(found.getIntersectionPoint(), hit.getIntersectionPoint()));
    CHECK_EQUAL(found.getTextureCoordinates().x(), i % 2 * 3.0);
    CHECK_EQUAL(found.getTextureCoordinates().y(), i % 2 * 5.0);
  }
  CHECK(!hits.isFound(1) && !hits.isFound(98));
}

TEST("a list of all rows counts from 0") {
  Arena arena;
  const RowList list = RowList::all(RayTable::kMost, arena);
  int expected = 0;
  for (const std::uint16_t row : list) CHECK_EQUAL(int(row), expected++);
  CHECK_EQUAL(expected, RayTable::kMost);
}

TEST("of hits at equal t the first in the scene is accepted, of one mesh the first face") {
  const NearestSoFar found{2, 5, 3};
  CHECK(found.accepts(1.5, 9, 9));
  CHECK(!found.accepts(2.5, 0, 0));
  CHECK(found.accepts(2, 4, 9));   // an earlier primitive
  CHECK(found.accepts(2, 5, 2));   // an earlier face
  CHECK(!found.accepts(2, 5, 3));  // the same
  CHECK(!found.accepts(2, 5, 4));
  CHECK(!found.accepts(2, 6, 0));
  CHECK(found.inclusiveBound() > 2 && found.inclusiveBound() < 2 + 1e-15);
}

TEST("at the bound of a search nothing is accepted") {
  const NearestSoFar nothing{2};
  CHECK(!nothing.accepts(2, 0, 0));
  CHECK(nothing.accepts(2 - 0x1p-52, 0, 0));
  CHECK_EQUAL(nothing.inclusiveBound(), 2.0);
  CHECK(NearestSoFar{kInf}.accepts(1e308, 0));
}
