// MeshGeometry: corners, flat faces, and whether the surface is closed.
#include "geometry/mesh_geometry.h"

#include "geometry/shapes.h"
#include "random.h"
#include "vectors.h"

namespace {

using Faces = std::vector<MeshGeometry::Face>;
using Vertices = std::vector<Vec3f>;

const Vertices kCorners = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
const Faces kTetrahedron = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};

bool isClosed(const Vertices& vertices, const Faces& faces) {
  MeshGeometry geometry(vertices, faces);
  geometry.findWhetherClosed();
  return geometry.isClosed();
}

/// Every face with three vertices of its own.
MeshGeometry loose(const MeshGeometry& joined) {
  Vertices vertices;
  Faces faces;
  for (std::uint32_t face = 0; face < joined.faceCount(); ++face) {
    for (int i = 0; i < 3; ++i) vertices.push_back(Vec3f(joined.corner(face, i)));
    faces.push_back({3 * face, 3 * face + 1, 3 * face + 2});
  }
  return MeshGeometry(vertices, faces);
}

}  // namespace

TEST("corners follow the faces' indices") {
  const MeshGeometry geometry(kCorners, kTetrahedron);
  CHECK_EQUAL(geometry.faceCount(), 4u);
  CHECK_EQUAL(geometry.corner(1, 0), Vec3d(0, 0, 0));
  CHECK_EQUAL(geometry.corner(1, 1), Vec3d(1, 0, 0));
  CHECK_EQUAL(geometry.corner(1, 2), Vec3d(0, 0, 1));
  CHECK_EQUAL(geometry.corner(3, 2), Vec3d(0, 0, 1));
  CHECK_EQUAL(geometry.getVertices().size(), std::size_t(4));
  CHECK_EQUAL(geometry.getFaces().size(), std::size_t(4));
}

TEST("faces whose corners lie on one line or at one point are flat") {
  const Vertices vertices = {{0, 0, 0}, {1, 2, 3}, {2, 4, 6}, {0, 1, 0}, {1, 2, 3}};
  const MeshGeometry geometry(vertices,
                              {{0, 1, 3}, {0, 1, 2}, {0, 1, 1}, {3, 1, 4}, {2, 2, 2}, {3, 1, 0}});
  CHECK_EQUAL(geometry.countFlatFaces(), 4u);
}

TEST("a tetrahedron, a cube and a ball are closed") {
  CHECK(isClosed(kCorners, kTetrahedron));
  MeshGeometry cube = shapes::cube(2), ball = shapes::ball(2);
  cube.findWhetherClosed();
  ball.findWhetherClosed();
  CHECK(cube.isClosed());
  CHECK(ball.isClosed());
}

TEST("nothing counts as closed before it has been looked at") {
  CHECK(!MeshGeometry(kCorners, kTetrahedron).isClosed());
}

TEST("a mesh that lacks a face is open") {
  for (std::size_t missing = 0; missing < 4; ++missing) {
    Faces faces = kTetrahedron;
    faces.erase(faces.begin() + std::ptrdiff_t(missing));
    CHECK(!isClosed(kCorners, faces));
  }
}

TEST("a mesh with one face turned over or given twice is open") {
  Faces turned = kTetrahedron, twice = kTetrahedron;
  std::swap(turned[2][0], turned[2][1]);
  twice.push_back(twice[1]);
  CHECK(!isClosed(kCorners, turned));
  CHECK(!isClosed(kCorners, twice));
}

TEST(
    "a face with the same corner twice encloses nothing, though each of its sides comes both "
    "ways") {
  CHECK(!isClosed(kCorners, {{0, 0, 1}}));
  CHECK(!isClosed(kCorners, {{2, 2, 2}}));
}

TEST("a mesh with all faces turned over is closed") {
  Faces faces = kTetrahedron;
  for (MeshGeometry::Face& face : faces) std::swap(face[0], face[1]);
  CHECK(isClosed(kCorners, faces));
}

TEST("vertices at equal positions are one, and -0 equals 0") {
  MeshGeometry parts = loose(MeshGeometry(kCorners, kTetrahedron));
  parts.findWhetherClosed();
  CHECK(parts.isClosed());
  Vertices vertices = parts.getVertices();
  vertices[3] = Vec3f(-0.0f, 0, -0.0f);  // the origin in another face
  CHECK(isClosed(vertices, parts.getFaces()));
  vertices[3] = Vec3f(1e-30f, 0, 0);
  CHECK(!isClosed(vertices, parts.getFaces()));
}

TEST("two bodies are closed, unless they share an edge") {
  Vertices vertices = kCorners;
  for (const Vec3f& corner : kCorners) vertices.push_back(corner + Vec3f(5, 0, 0));
  Faces faces = kTetrahedron;
  for (const MeshGeometry::Face& face : kTetrahedron)
    faces.push_back({face[0] + 4, face[1] + 4, face[2] + 4});
  CHECK(isClosed(vertices, faces));
  // Mirrored to the other side of the edge from (0, 0, 0) to (0, 0, 1), which then has four faces.
  for (std::size_t i = 0; i < 4; ++i) vertices[4 + i] = kCorners[i] * Vec3f(-1, -1, 1);
  CHECK(!isClosed(vertices, faces));
}

TEST("the bounds of a large mesh under any map are those of all its corners, to the last bit") {
  Random random(41);
  for (int i = 0; i < 60; ++i) {
    // A wavy strip, or a cloud without order; some vertices belong to no face.
    const bool isCloud = i % 3 == 0;
    Vertices vertices;
    for (int k = 0; k < 2000; ++k) {
      const Vec3d wave(0.01 * k, math::sinDegrees(k), random.uniform(0, 0.1));
      vertices.push_back(Vec3f(isCloud ? random.inCube(-1, 1) : wave));
    }
    vertices.push_back({1e6f, 1e6f, 1e6f});
    Faces faces;
    for (std::uint32_t k = 0; k + 2 < 2000; ++k) faces.push_back({k, k + 1, k + 2});
    const Vec3d origin = i % 2 == 0 ? MeshGeometry::kZero : Vec3d(4096, -512, 0);
    const MeshGeometry geometry(vertices, faces, origin);
    BoundingBox box, expected;
    for (int instance = 0; instance < 12; ++instance) {
      const Matrix move = Matrix::translation(random.inCube(-3, 3)), turn = random.rotation();
      const Matrix toWorld = move * turn * Matrix::scale(random.inCube(-2, 2));
      geometry.addBounds(instance == 0 ? Matrix() : toWorld, box);
      for (int k = 0; k < 2000; ++k) {
        const Vec3d corner = origin + vertices[std::size_t(k)];
        expected.extend((instance == 0 ? Matrix() : toWorld).transformPoint(corner));
      }
      CHECK_EQUAL(box.low(), expected.low());
      CHECK_EQUAL(box.high(), expected.high());
    }
  }
}

TEST("the bounds of a flat triangle that is turned are those of its corners") {
  // Its own box has a fourth corner, (1, 1, 0), which a turn by 45 degrees takes to y = sqrt(2).
  const MeshGeometry geometry(kCorners, {{0, 1, 2}});
  const Matrix turn = Matrix::rotation({0, 0, 1}, 45);
  BoundingBox box, expected;
  geometry.addBounds(turn, box);
  for (int i = 0; i < 3; ++i) expected.extend(turn.transformPoint(geometry.corner(0, i)));
  CHECK_EQUAL(box.low(), expected.low());
  CHECK_EQUAL(box.high(), expected.high());
}

TEST("faces without area are counted in every part of a large mesh") {
  // A fan of faces {0, 1, 2}; every third one has a corner twice.
  Faces faces;
  for (std::uint32_t k = 0; k < 100'000; ++k) faces.push_back({0, 1, k % 3 == 0 ? 1u : 2u});
  CHECK_EQUAL(MeshGeometry(kCorners, faces).countFlatFaces(), 33'334u);
  BoundingBox box;
  MeshGeometry(kCorners, {}).addBounds(Matrix(), box);
  CHECK(box.isEmpty());
}
