// MeshTree: leaves hold the corners themselves, so that deciding a hit needs no look at the mesh.
#include "accel/mesh_tree.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <vector>

#include "accel/bvh_builder.h"
#include "geometry/triangle_test.h"
#include "math/bounding_box.h"

namespace accel {
namespace {

float wordAsFloat(std::uint32_t word) {
  float x;
  std::memcpy(&x, &word, sizeof x);
  return x;
}

/// Writes leaves of corners, scaled.
class MeshLeafWriter : public LeafWriter {
 public:
  MeshLeafWriter(const MeshGeometry& geometry, float scale) : geometry_(geometry), scale_(scale) {}

  void write(const BuildItem* items, int count, std::uint32_t* words) const override {
    float edge = 0;
    for (int i = 0; i < count; ++i) {
      Vec3f corners[3];
      const MeshGeometry::Face& face = geometry_.getFaces()[items[i].id];
      for (std::size_t k = 0; k < 3; ++k) corners[k] = geometry_.getVertices()[face[k]] * scale_;
      for (int k = 0; k < 9; ++k) {
        const float value = corners[k / 3][k % 3];
        std::memcpy(words + 1 + k * count + i, &value, sizeof value);
      }
      words[1 + 9 * count + i] = items[i].id | kIdBit;
      edge = std::max({edge, maxAbs(corners[1] - corners[0]), maxAbs(corners[2] - corners[0])});
    }
    words[0] = leafHead(edge, LeafKind::meshTriangles, count);
  }

 private:
  const MeshGeometry& geometry_;
  float scale_;
};

/// A power of two that brings the longest side of the box to 1 to 2, or 1 where there is none.
float scaleFor(const BoundingBox& box) {
  const double longest = std::max(box.longestSide(), 0x1p-100);
  return std::ldexp(1.0f, std::clamp(-std::ilogb(longest), -126, 126));
}

}  // namespace

MeshTree::MeshTree(const MeshGeometry& geometry, int threads) : geometry_(&geometry) {
  BoundingBox box;
  for (const Vec3f& vertex : geometry.getVertices()) box.extend(Vec3d(vertex));
  const float scale = scaleFor(box);
  bvh_.scale = scale;
  for (const Vec3f& vertex : geometry.getVertices()) {
    exact_ = exact_ && vertex * scale * (1 / scale) == vertex;
  }
  std::vector<BuildItem> items;
  items.reserve(geometry.faceCount());
  for (std::uint32_t face = 0; face < geometry.faceCount(); ++face) {
    const Vec3d a = geometry.corner(face, 0), b = geometry.corner(face, 1),
                c = geometry.corner(face, 2);
    if (triangle::areaNormal(a, b, c) == Vec3d()) continue;
    BuildItem item{};
    for (int axis = 0; axis < 3; ++axis) {
      item.low[axis] = float(std::min({a[axis], b[axis], c[axis]})) * scale;
      item.high[axis] = float(std::max({a[axis], b[axis], c[axis]})) * scale;
    }
    item.id = face;
    item.kind = LeafKind::meshTriangles;
    items.push_back(item);
  }
  buildWideBvh(bvh_, items.data(), items.size(), MeshLeafWriter(geometry, scale), threads);
}

Vec3d MeshTree::low() const { return Vec3d(bvh_.low[0], bvh_.low[1], bvh_.low[2]) / bvh_.scale; }
Vec3d MeshTree::high() const {
  return Vec3d(bvh_.high[0], bvh_.high[1], bvh_.high[2]) / bvh_.scale;
}

MeshTree::Triangle MeshTree::triangleAt(const std::uint32_t* words, int lane) const {
  const int n = countOf(words[0]);
  const std::uint32_t face = words[1 + 9 * n + lane] & ~kIdBit;
  if (!exact_) {
    return {geometry_->corner(face, 0), geometry_->corner(face, 1), geometry_->corner(face, 2),
            face};
  }
  const double unscale = 1 / bvh_.scale;
  double v[9];
  for (int k = 0; k < 9; ++k) v[k] = wordAsFloat(words[1 + k * n + lane]) * unscale;
  return {Vec3d(v[0], v[1], v[2]), Vec3d(v[3], v[4], v[5]), Vec3d(v[6], v[7], v[8]), face};
}

}  // namespace accel
