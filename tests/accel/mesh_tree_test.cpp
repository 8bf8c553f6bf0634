// MeshTree: its leaves give back the mesh's own triangles, in few bytes.
#include "accel/mesh_tree.h"

#include <vector>

#include "accel/mesh_items.h"
#include "check.h"
#include "geometry/shapes.h"
#include "random.h"

namespace {

using accel::MeshTree;

/// Each face that any leaf holds is looked up there and in the mesh.
class Inspection {
 public:
  Inspection(const MeshGeometry& mesh, int threads) : mesh_(mesh), seen_(mesh.faceCount()) {
    const MeshTree tree(mesh, threads);
    const accel::WideBvh& bvh = tree.bvh();
    bytes_ = bvh.bytes();
    for (std::size_t i = 0; i < bvh.nodeCount; ++i) {
      for (const std::uint32_t child : bvh.root()[i].child) {
        if ((child & accel::kLeafBit) != 0) {
          look(tree, bvh.words() + (child & ~accel::kLeafBit));
        }
      }
    }
  }
  double bytesPerTriangle() const { return double(bytes_) / mesh_.faceCount(); }
  std::size_t wrong() const { return wrong_; }
  std::size_t notOnce() const {
    std::size_t count = 0;
    for (const int times : seen_) count += times != 1;
    return count;
  }
  /// Leaves with up to 8, up to 16, and up to 24 vertices.
  const int* leaves() const { return leaves_; }

 private:
  void look(const MeshTree& tree, const std::uint32_t* words) {
    ++leaves_[(accel::verticesOf(*words) - 1) / 8];
    for (int lane = 0; lane < accel::countOf(*words); ++lane) {
      double found[9];
      tree.getCorners(words, lane, found, 1);
      const std::uint32_t face = MeshTree::faceAt(words, lane);
      ++seen_.at(face);
      const auto [a, b, c] = mesh_.corners(face);
      if (Vec3d::of(found) != a || Vec3d::of(found + 3) != b || Vec3d::of(found + 6) != c) ++wrong_;
    }
  }

  const MeshGeometry& mesh_;
  std::vector<int> seen_;
  std::size_t bytes_ = 0, wrong_ = 0;
  int leaves_[3] = {};
};

/// Triangles along a line; where vertices are shared, most corners are among the last twenty.
MeshGeometry randomMesh(std::size_t faces, bool isShared, double size, std::uint64_t seed) {
  Random random(seed);
  std::vector<Vec3f> vertices;
  std::vector<MeshGeometry::Face> list;
  for (std::size_t i = 0; i < faces; ++i) {
    const std::size_t known = vertices.size();
    MeshGeometry::Face face;
    for (std::uint32_t& corner : face) {
      if (isShared && known > 20 && random.index(3) != 0) {
        corner = std::uint32_t(known - 1 - std::size_t(random.index(20)));
      } else {
        corner = std::uint32_t(vertices.size());
        const Vec3d place = Vec3d(double(i) / double(faces), 0, 0) + random.inCube(-0.01, 0.01);
        vertices.push_back(Vec3f(place * size));
      }
    }
    list.push_back(face);
  }
  return MeshGeometry(vertices, list);
}

/// n x n vertices of a bent sheet of squares, whose halves may be far from each other in the file.
MeshGeometry sheet(std::uint32_t n, bool areFar) {
  std::vector<Vec3f> vertices;
  std::vector<MeshGeometry::Face> faces, others;
  for (std::uint32_t i = 0; i < n * n; ++i) {
    const double x = double(i % n) / n, y = double(i / n) / n;
    vertices.push_back(Vec3f(Vec3d(x, y, 0.1 * x * y)));
    if (i % n + 1 == n || i / n + 1 == n) continue;
    faces.push_back({i, i + 1, i + n + 1});
    (areFar ? others : faces).push_back({i, i + n + 1, i + n});
  }
  faces.insert(faces.end(), others.begin(), others.end());
  return MeshGeometry(vertices, faces);
}

}  // namespace

TEST("leaves give back the corners of every face, bit for bit") {
  int leaves[3] = {};
  // The smallest lose digits when they are scaled, so that the mesh itself is asked.
  for (const double size : {1.0, 3e5, 1e-3, 1e-38}) {
    for (const std::size_t faces : {std::size_t(1), std::size_t(7), std::size_t(400)}) {
      for (const bool isShared : {true, false}) {
        const MeshGeometry near = randomMesh(faces, isShared, size, faces);
        const Vec3d origin = isShared ? MeshGeometry::kZero : Vec3d(-1024, 4096, 0) * size;
        const MeshGeometry mesh(near.getVertices(), near.getFaces(), origin);
        const Inspection found(mesh, 1);
        CHECK_EQUAL(found.wrong(), std::size_t(0));
        CHECK_EQUAL(found.notOnce(), mesh.countFlatFaces());
        for (int i = 0; i < 3; ++i) leaves[i] += found.leaves()[i];
      }
    }
  }
  CHECK(leaves[0] > 10 && leaves[1] > 10 && leaves[2] > 10);
}

TEST("a large mesh is whole when several threads write its leaves") {
  for (const bool areFar : {true, false}) {
    const MeshGeometry mesh = sheet(150, areFar);
    const Inspection found(mesh, 3);
    CHECK_EQUAL(found.wrong(), std::size_t(0));
    CHECK_EQUAL(found.notOnce(), std::size_t(0));
  }
}

TEST("the halves of a square are one item where one follows the other, copies of a face are not") {
  const auto itemsOf = [](const MeshGeometry& mesh) {
    std::size_t items = 0;
    accel::ThreadPool::run(1, mesh.faceCount(), [&](accel::ThreadPool& pool) {
      items = accel::meshItems(mesh, 1, pool).items.count();
    });
    return items;
  };
  CHECK_EQUAL(itemsOf(sheet(10, false)), std::size_t(81));
  CHECK_EQUAL(itemsOf(sheet(10, true)), std::size_t(162));
  const std::vector<Vec3f> corners = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {9, 9, 9}};
  CHECK_EQUAL(itemsOf(MeshGeometry(corners, {{0, 1, 2}, {0, 1, 2}})), std::size_t(2));
  // A box around both would be far larger than those of each.
  CHECK_EQUAL(itemsOf(MeshGeometry({{0, 0, 0}, {9, 9, 9}, {9, 9, 8}, {0, 0, 1}, {9, -9, 9}},
                                   {{0, 1, 2}, {1, 2, 4}})),
              std::size_t(2));
}

TEST("of equal faces that are too many for a leaf, the tree holds the first") {
  for (const std::uint32_t count : {8u, 9u, 1000u}) {
    std::vector<MeshGeometry::Face> faces = {{3, 4, 5}};
    for (std::uint32_t i = 0; i < count; ++i) faces.push_back({0, 1, 2});
    const MeshGeometry mesh({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {2, 0, 0}, {3, 0, 0}, {3, 1, 0}},
                            faces);
    const MeshTree tree(mesh, 1);
    const accel::FaceCopies* copies = tree.copiesOf(1);
    CHECK_EQUAL(copies != nullptr, count > 8);
    CHECK(tree.copiesOf(0) == nullptr && tree.copiesOf(2) == nullptr);
    if (copies) CHECK(copies->next == 2 && copies->count == count);
    CHECK_EQUAL(Inspection(mesh, 1).notOnce(), copies ? count - 1 : std::size_t(0));
  }
}

TEST("a triangle of an ordinary mesh takes at most 32 bytes") {
  // Seven triangles in a patch have about 9 vertices: head and places 20 bytes, vertices 108, face
  // numbers 28, so 22.3 a triangle; and a node of 256 bytes for about 30 triangles.
  CHECK(Inspection(sheet(200, true), 2).bytesPerTriangle() < 32);
  CHECK(Inspection(shapes::ball(6), 1).bytesPerTriangle() < 32);
}
