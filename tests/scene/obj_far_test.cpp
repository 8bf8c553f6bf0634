// Meshes far from 0: which are, and what is kept of their vertices.
#include <cmath>
#include <cstdio>
#include <iomanip>
#include <sstream>

#include "geometry/triangle.h"
#include "random.h"
#include "scene/obj_reader.h"
#include "scene/scene_files.h"
#include "vectors.h"

namespace {

MeshGeometry read(const std::string& text) {
  MistakeLog log(MistakeLog::Mode::throwFirst);
  std::vector<std::string> warnings;
  return readObj(SourceText("m.obj", text), log, 0, warnings);
}

std::string vertexAt(const Vec3d& place) {
  std::ostringstream out;
  out << std::setprecision(17) << "v " << place.x() << ' ' << place.y() << ' ' << place.z() << '\n';
  return out.str();
}

/// A triangle that has a box of sides 1, 1 and 0 with its least corner at `place`.
std::string triangleAt(const Vec3d& place) {
  return vertexAt(place) + vertexAt(place + Vec3d(1, 0, 0)) + vertexAt(place + Vec3d(0, 1, 0)) +
         "f -1 -2 -3\n";
}

bool isFar(const std::string& text) { return read(text).getOrigin() != Vec3d(); }

/// What rounding takes away from a + b. Source: Knuth, "The Art of Computer Programming", 4.2.2.
double lostIn(double a, double b) {
  const double sum = a + b, rounded = sum - a;
  return (a - (sum - rounded)) + (b - rounded);
}

}  // namespace

TEST("a mesh is far where its box is more than 16 sides from 0") {
  CHECK(!isFar(triangleAt({16, 0, 0})) && isFar(triangleAt({16.5, 0, 0})));
  CHECK(!isFar(triangleAt({0, -17, 3})) && isFar(triangleAt({0, -17.5, 3})));  // 16 from its top
  CHECK(!isFar(triangleAt({-8, 9, -16})) && isFar(triangleAt({-8, 9, 16.5})));
  // An outlier makes the mesh large, not far.
  CHECK(isFar(triangleAt({5e6, 0, 0}) + triangleAt({5.1e6, 0, 0})));
  CHECK(!isFar(triangleAt({5e6, 0, 0}) + triangleAt({0, 0, 5e6})));
  // Floats give these no size.
  CHECK(isFar("v 5000000.1 0 0\nv 5000000.11 0 0\nv 5000000.1 .01 0\nf 1 2 3\n"));
  CHECK(isFar("v 1 2 3\nf 1 1 1\n") && !isFar("v 0 0 0\nf 1 1 1\n"));
  CHECK(!isFar("v 1e9 0 0\n"));
}

TEST("vertices that no face uses may be anywhere") {
  const MeshGeometry mesh =
      read("v 3e38 -3e38 0\n" + triangleAt({-3e37, 5, 5}) + triangleAt({-3e37, 8, 8}));
  CHECK_NEAR(mesh.getOrigin().x(), -3e37, 1e23);
  for (const Vec3f& v : mesh.getVertices()) CHECK(std::isfinite(maxAbs(v)));
}

TEST("usual meshes keep every number, and its sign") {
  const MeshGeometry mesh = read("v -0 1 2\nv 0 -0 7\nv 15.3 1e-30 -0\nf 1 2 3\n");
  const auto [a, b, c] = mesh.corners(0);
  CHECK(std::signbit(a.x()) && !std::signbit(b.x()) && std::signbit(b.y()) && std::signbit(c.z()));
  CHECK_EQUAL(c, Vec3d(15.3f, 1e-30f, 0));
}

TEST("a far mesh keeps 2^-24 of its size, and each corner is a sum without rounding") {
  Random random(14);
  for (int round = 0; round < 400; ++round) {
    const double size = random.logUniform(1e-6, 1e6);
    const Vec3d center = random.unitVector() * (size * random.logUniform(60, 1e12));
    std::vector<Vec3d> places;
    std::string text;
    for (int k = 0; k < 30; ++k) {
      Vec3d place = center + random.inCube(-1, 1) * size;
      if (k % 5 == 0) place[k % 3] = k % 2 ? place[k % 3] * 1e-9 : double(float(place[k % 3]));
      if (maxAbs(place - center) > 2 * size) place = center;
      places.push_back(place);
      text += vertexAt(place);
    }
    for (int k = 3; k <= 30; ++k) text += "f 1 2 " + std::to_string(k) + "\n";
    const MeshGeometry mesh = read(text);
    CHECK(mesh.getOrigin() != Vec3d());
    for (std::uint32_t face = 0; face < mesh.faceCount(); ++face) {
      for (int corner = 0; corner < 3; ++corner) {
        const std::uint32_t vertex = mesh.getFaces()[face][std::size_t(corner)];
        const Vec3d found = mesh.corner(face, corner), offset = mesh.getVertices()[vertex];
        CHECK(maxAbs(found - places[vertex]) <= size * 0x1p-22 * 0.5);
        for (int axis = 0; axis < 3; ++axis) {
          CHECK_EQUAL(lostIn(mesh.getOrigin()[axis], offset[axis]), 0.0);
        }
      }
      const auto [a, b, c] = mesh.corners(face);
      const MeshGeometry near(mesh.getVertices(), mesh.getFaces());
      CHECK(triangle::areaNormal(a, b, c) ==
            triangle::areaNormal(near.corner(face, 0), near.corner(face, 1), near.corner(face, 2)));
    }
  }
}

TEST("a far mesh is the same in chunks of any size, its concave faces cut") {
  const Vec3d door[] = {{0, 0, 0}, {3, 0, 0}, {3, 3, 0}, {2, 3, 0},
                        {2, 1, 0}, {1, 1, 0}, {1, 3, 0}, {0, 3, 0}};
  std::string text;
  for (int k = 0; k < 40; ++k) {
    for (const Vec3d& v : door) text += vertexAt(v * 0.001 + Vec3d(5e5, 5e6, 1e-4 * k));
    text += "f -8 -7 -6 -5 -4 -3 -2 -1\n";
  }
  const std::string path = scenes::write("doors.obj", text);
  const MeshGeometry whole = read(text);
  double area = 0;
  for (std::uint32_t face = 0; face < whole.faceCount(); ++face) {
    const auto [a, b, c] = whole.corners(face);
    area += length(triangle::areaNormal(a, b, c)) / 2;
  }
  CHECK_NEAR(area, 40 * 7e-6, 1e-8);  // double tells places there to 1e-9
  for (const std::size_t bytes : {std::size_t(50), std::size_t(333), std::size_t(100000)}) {
    for (const int threads : {1, 3}) {
      MeshGeometry mesh;
      CHECK(readObjFile(path, {threads, bytes}, mesh));
      CHECK(mesh.getFaces() == whole.getFaces() && mesh.getVertices() == whole.getVertices());
      CHECK_EQUAL(mesh.getOrigin(), whole.getOrigin());
    }
  }
  std::remove(path.c_str());
}
