// The transparent solids of a scene, and their volumes.
#include "scene/solid_objects.h"

#include "../geometry/shapes.h"
#include "check.h"
#include "geometry/group.h"
#include "geometry/sphere.h"
#include "geometry/transform.h"
#include "geometry/triangle_mesh.h"

namespace {

constexpr double kInf = std::numeric_limits<double>::infinity();
const double kPi = std::acos(-1);

PhongMaterial glass() {
  return PhongMaterial(Vec3f(), Vec3f(), 1, Vec3f(0, 0.5f, 0), Vec3f(), 1.5f);
}

}  // namespace

TEST("volumes are those in the world, under any Transforms, mirrors too") {
  const PhongMaterial material = glass();
  MeshGeometry cube = shapes::cube(0.5);
  cube.findWhetherClosed();
  const Sphere ball({1, 2, 3}, 2, &material);
  const TriangleMesh mesh(&cube, &material);
  const Transform turned(Matrix::rotation({1, 2, 3}, 40) * Matrix::scale({-2, 3, 5}), &ball);
  const double sheared[3][4] = {{1, 7, 0, 4}, {0, 2, 0, 4}, {0, 0, 0.5, 4}};
  const Transform slanted{Matrix(sheared), &mesh};
  Group inner, root;
  inner.addObject(&slanted);
  const Transform grown(Matrix::scale({3, 3, 3}), &inner);
  root.addObject(&turned);
  root.addObject(&grown);
  const SolidObjects solids(root);
  CHECK_NEAR(solids.volumeOf(&ball), 4 * kPi / 3 * 8 * 30, 1e-10);
  CHECK_NEAR(solids.volumeOf(&mesh), 27, 1e-12);
  CHECK_NEAR(volumeOf(cube), 1, 1e-15);
}

TEST("a mesh that is inside out has the same volume, and a hollow is not counted") {
  const MeshGeometry cube = shapes::cube(1), hollow = shapes::cube(0.5);
  std::vector<Vec3f> vertices = cube.getVertices();
  std::vector<MeshGeometry::Face> faces = cube.getFaces(), inverted;
  for (const MeshGeometry::Face& f : cube.getFaces()) inverted.push_back({f[0], f[2], f[1]});
  CHECK_EQUAL(volumeOf(MeshGeometry(vertices, inverted)), 8.0);
  vertices.insert(vertices.end(), hollow.getVertices().begin(), hollow.getVertices().end());
  for (const MeshGeometry::Face& f : inverted) faces.push_back({f[0] + 8, f[1] + 8, f[2] + 8});
  CHECK_EQUAL(volumeOf(MeshGeometry(vertices, faces)), 7.0);
  CHECK_EQUAL(volumeOf(MeshGeometry()), 0.0);
}

TEST("what is opaque or open is no solid") {
  const PhongMaterial clear = glass(), opaque = shapes::plainMaterial();
  const MeshGeometry open = shapes::cube(1);  // nobody has found out that it is closed
  const Sphere ball({0, 0, 0}, 1, &opaque);
  const TriangleMesh mesh(&open, &clear);
  Group root;
  root.addObject(&ball);
  root.addObject(&mesh);
  const SolidObjects solids(root);
  CHECK_EQUAL(solids.volumeOf(&ball), kInf);
  CHECK_EQUAL(solids.volumeOf(&mesh), kInf);
  CHECK(solids.areBeyond({0, 0, 0}, 0));
}

TEST("solids are beyond a point that is outside of their common box") {
  const PhongMaterial clear = glass();
  const Sphere left({-4, 0, 0}, 1, &clear), right({4, 0, 0}, 1, &clear);
  Group root;
  root.addObject(&left);
  root.addObject(&right);
  const SolidObjects solids(root);
  CHECK(!solids.areBeyond({0, 0, 0}, 0));
  CHECK(!solids.areBeyond({0, 1, 0}, 0));
  CHECK(!solids.areBeyond({0, 1.09, 0}, 0.1));
  CHECK(solids.areBeyond({0, 1.11, 0}, 0.1));
  CHECK(solids.areBeyond({-5.2, 0, 0}, 0.1));
}
