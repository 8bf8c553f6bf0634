// MeshGeometry: what can be said of a mesh as a whole.
#include "geometry/mesh_geometry.h"

#include <algorithm>
#include <numeric>

#include "geometry/triangle_test.h"

namespace {

bool positionLess(const Vec3f& a, const Vec3f& b) {
  for (int axis = 0; axis < 3; ++axis) {
    if (a[axis] != b[axis]) return a[axis] < b[axis];
  }
  return false;
}

/// For each vertex the number of its position, equal positions having equal numbers.
std::vector<std::uint32_t> numberPositions(const std::vector<Vec3f>& vertices) {
  std::vector<std::uint32_t> order(vertices.size());
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(), [&](std::uint32_t i, std::uint32_t j) {
    return positionLess(vertices[i], vertices[j]);
  });
  std::vector<std::uint32_t> numbers(vertices.size());
  std::uint32_t number = 0;
  for (std::size_t k = 0; k < order.size(); ++k) {
    if (k > 0 && vertices[order[k]] != vertices[order[k - 1]]) ++number;
    numbers[order[k]] = number;
  }
  return numbers;
}

/// An edge of a face, its ends in ascending order.
struct Edge {
  std::uint64_t ends;
  bool ascending;  // whether the face runs from the smaller to the larger end
};

}  // namespace

std::uint32_t MeshGeometry::countFlatFaces() const {
  std::uint32_t count = 0;
  for (std::uint32_t face = 0; face < faceCount(); ++face) {
    const Vec3d normal = triangle::areaNormal(corner(face, 0), corner(face, 1), corner(face, 2));
    if (normal == Vec3d()) ++count;
  }
  return count;
}

void MeshGeometry::findWhetherClosed() {
  const std::vector<std::uint32_t> numbers = numberPositions(vertices_);
  std::vector<Edge> edges;
  edges.reserve(3 * faces_.size());
  for (const Face& face : faces_) {
    for (int side = 0; side < 3; ++side) {
      const std::uint64_t from = numbers[face[std::size_t(side)]];
      const std::uint64_t to = numbers[face[std::size_t((side + 1) % 3)]];
      edges.push_back({std::min(from, to) << 32 | std::max(from, to), from < to});
    }
  }
  std::sort(edges.begin(), edges.end(), [](Edge a, Edge b) { return a.ends < b.ends; });
  closed_ = !edges.empty();
  for (std::size_t i = 0; i < edges.size() && closed_; i += 2) {
    closed_ = i + 1 < edges.size() && edges[i].ends == edges[i + 1].ends &&
              edges[i].ascending != edges[i + 1].ascending &&
              (i + 2 == edges.size() || edges[i + 2].ends != edges[i].ends);
  }
}
