// MeshShading: smooth normals, texture coordinates, and what a hit between the corners gets of
// both.
#include "geometry/mesh_shading.h"

#include <cmath>

#include "geometry/shapes.h"
#include "geometry/transform.h"
#include "geometry/triangle.h"
#include "geometry/triangle_mesh.h"
#include "random.h"
#include "vectors.h"

namespace {

const PhongMaterial kMaterial = shapes::plainMaterial();
constexpr std::uint32_t kNone = MeshShading::kNone;

/// A ridge along x: face 0 lies in z = 0, with area 1 and normal (0, 0, 1); face 1 in y = 0, with
/// area 3 and normal (0, 1, 0). Vertices 0 and 1 are corners of both.
MeshGeometry ridge() {
  return MeshGeometry({{0, 0, 0}, {2, 0, 0}, {0, 1, 0}, {0, 0, 3}}, {{0, 1, 2}, {0, 3, 1}});
}
MeshGeometry smoothRidge(MeshNormals kind) {
  MeshGeometry mesh = ridge();
  makeSmooth(mesh, kind);
  return mesh;
}

/// What a ray along `direction` through `point` hits.
Hit hitAt(const MeshGeometry& mesh, const Vec3d& point, const Vec3d& direction = {0, 0, -1}) {
  Hit hit;
  CHECK(TriangleMesh(&mesh, &kMaterial).intersect(Ray(point - direction, direction), hit, 0));
  return hit;
}
Vec3d normalAt(const MeshGeometry& mesh, const Vec3d& point) {
  return hitAt(mesh, point).getNormal();
}

}  // namespace

TEST("the weights of a point add up to it, and at a corner those of the others are 0") {
  Random random(1);
  for (int i = 0; i < 1000; ++i) {
    const double size = random.logUniform(1e-60, 1e60);
    const Vec3d a = random.inCube(-1, 1) * size, b = random.inCube(-1, 1) * size,
                c = random.inCube(-1, 1) * size;
    const double u = random.uniform(0, 1), v = random.uniform(0, 1 - u);
    const Vec3d weights = triangle::weightsAt(a, b, c, a * (1 - u - v) + b * u + c * v);
    const double slack =
        1e-14 * size * size / maxAbs(triangle::areaNormal(a, b, c));  // slender ones lose digits
    CHECK_NEAR_VECTOR(weights, Vec3d(1 - u - v, u, v), slack);
    CHECK_EQUAL(triangle::weightsAt(a, b, c, a), Vec3d(1, 0, 0));
    const Vec3d atB = triangle::weightsAt(a, b, c, b), atC = triangle::weightsAt(a, b, c, c);
    CHECK(atB.x() == 0 && atB.z() == 0 && atC.x() == 0 && atC.y() == 0);
  }
}

TEST("a vertex has the mean of its faces' normals, by their areas or each counted once") {
  // By area: (0, 0, 1) + 3 (0, 1, 0); equally: (0, 0, 1) + (0, 1, 0).
  const auto byArea = smoothNormals(ridge(), MeshNormals::byArea);
  CHECK_NEAR_VECTOR(byArea[0], Vec3d(0, 3, 1) / std::sqrt(10.0), 1e-7);
  CHECK(byArea[1] == byArea[0]);
  const auto equal = smoothNormals(ridge(), MeshNormals::equal);
  CHECK_NEAR_VECTOR(equal[0], Vec3d(0, 1, 1) / std::sqrt(2.0), 1e-7);
  for (const auto& normals : {byArea, equal}) {
    CHECK_EQUAL(normals[2], Vec3f(0, 0, 1));  // of one face alone
    CHECK_EQUAL(normals[3], Vec3f(0, 1, 0));
  }
}

TEST("a hit has the mean of the corners' normals, made unit") {
  // In the middle a third of each: twice (0, 3, 1) / sqrt 10, or (0, 1, 1) / sqrt 2, and (0, 0, 1).
  const Vec3d middle(2 / 3.0, 1 / 3.0, 0);
  const double s = std::sqrt(10.0), q = std::sqrt(2.0);
  CHECK_NEAR_VECTOR(normalAt(smoothRidge(MeshNormals::byArea), middle),
                    normalize(Vec3d(0, 6 / s, 2 / s + 1)), 1e-7);
  CHECK_NEAR_VECTOR(normalAt(smoothRidge(MeshNormals::equal), middle),
                    normalize(Vec3d(0, 2 / q, 2 / q + 1)), 1e-7);
  CHECK_EQUAL(normalAt(ridge(), middle), Vec3d(0, 0, 1));
  // At a vertex its own; at a quarter of the way to another three quarters of it.
  const MeshGeometry mesh = smoothRidge(MeshNormals::equal);
  CHECK_NEAR_VECTOR(normalAt(mesh, {2, 0, 0}), Vec3d(0, 1, 1) / q, 1e-7);
  CHECK_NEAR_VECTOR(normalAt(mesh, {0, 1, 0}), Vec3d(0, 0, 1), 0);
  CHECK_NEAR_VECTOR(normalAt(mesh, {0, 0.25, 0}), normalize(Vec3d(0, 0.75 / q, 0.75 / q + 0.25)),
                    1e-7);
}

TEST("under a Transform a smooth normal goes through the inverse transpose, as others do") {
  const MeshGeometry geometry = smoothRidge(MeshNormals::byArea);
  const TriangleMesh mesh(&geometry, &kMaterial);
  const Transform stretched(Matrix::scale({5, 2, 4}), &mesh);
  Hit hit;
  CHECK(stretched.intersect(Ray({10, 0, 1}, {0, 0, -1}), hit, 0));  // vertex 1
  CHECK_NEAR_VECTOR(hit.getNormal(), normalize(Vec3d(0, 3 / 2.0, 1 / 4.0)), 1e-7);
}

TEST("where normals cancel out, the face has its own") {
  // Both sides of a sheet, a face without area, and a vertex without faces.
  MeshGeometry mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, -1}},
                    {{0, 1, 2}, {0, 2, 1}, {0, 0, 1}});
  makeSmooth(mesh, MeshNormals::equal);
  for (const Vec3f& normal : mesh.getShading().normals) CHECK_EQUAL(normal, Vec3f());
  CHECK_EQUAL(normalAt(mesh, {0.3, 0.3, 0}), Vec3d(0, 0, 1));
  // Normals of the corners that cancel out at the middle of an edge, and beside it.
  MeshGeometry face({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}});
  face.setShading({{{1, 0, 0}, {-1, 0, 0}}, {{0, 1, kNone}}, {}, {}});
  CHECK_EQUAL(normalAt(face, {0.5, 0, 0}), Vec3d(0, 0, 1));
  CHECK_EQUAL(normalAt(face, {0.75, 0, 0}), Vec3d(-1, 0, 0));
  CHECK_EQUAL(normalAt(face, {0, 1, 0}), Vec3d(0, 0, 1));  // a corner without one
}

TEST("where corners have normals of their own, only the others become smooth") {
  MeshGeometry mesh = ridge();
  mesh.setShading({{{1, 0, 0}}, {{0, kNone, kNone}, {kNone, 0, 0}}, {}, {}});
  makeSmooth(mesh, MeshNormals::equal);
  CHECK_EQUAL(normalAt(mesh, {0, 0, 0}), Vec3d(1, 0, 0));
  CHECK_NEAR_VECTOR(normalAt(mesh, {2, 0, 0}), Vec3d(0, 1, 1) / std::sqrt(2.0), 1e-7);
  CHECK_EQUAL(normalAt(mesh, {0, 1, 0}), Vec3d(0, 0, 1));
}

TEST("texture coordinates are the mean of the corners' coordinates") {
  MeshGeometry mesh = ridge();
  mesh.setShading({{}, {}, {{0.5f, 1}, {2.5f, 1}, {0.5f, 9}}, {{0, 1, 2}, {0, kNone, 1}}});
  const auto coordinatesAt = [&](const Vec3d& point, const Vec3d& direction) {
    const Vec2d uv = hitAt(mesh, point, direction).getTextureCoordinates();
    return Vec3d(uv.x(), uv.y(), 0);
  };
  // Weights 1/4, 1/2, 1/4.
  CHECK_NEAR_VECTOR(coordinatesAt({1, 0.25, 0}, {0, 0, -1}), Vec3d(1.5, 3, 0), 1e-15);
  CHECK_EQUAL(coordinatesAt({0, 1, 0}, {0, 0, -1}), Vec3d(0.5, 9, 0));
  CHECK_EQUAL(coordinatesAt({0.5, 0, 1}, {0, -1, 0}), Vec3d());  // a corner has none
  CHECK_EQUAL(normalAt(mesh, {1, 0.25, 0}), Vec3d(0, 0, 1));
  CHECK(TriangleMesh(&mesh, &kMaterial).hasTextureCoordinates());
}

TEST("a plain mesh keeps nothing of its corners") {
  const MeshGeometry mesh = ridge();
  const MeshShading& shading = mesh.getShading();
  CHECK(shading.isEmpty() && !TriangleMesh(&mesh, &kMaterial).hasTextureCoordinates());
  CHECK_EQUAL(shading.normals.capacity() + shading.normalFaces.capacity(), 0u);
  CHECK_EQUAL(shading.coordinates.capacity() + shading.coordinateFaces.capacity(), 0u);
  const Vec2d uv = hitAt(mesh, {0.5, 0.25, 0}).getTextureCoordinates();
  CHECK(uv.x() == 0 && uv.y() == 0);
}
