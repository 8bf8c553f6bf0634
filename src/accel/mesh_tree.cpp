// MeshTree: leaves hold the corners themselves, so that deciding a hit needs no look at the mesh.
//
// Corners are stored scaled by a power of two, which brings the mesh's longest side to 1 to 2: that
// loses no digit unless a number leaves the range of float, so dividing gives back the mesh's own
// corners; where any does not come back, they are fetched from the mesh instead. The anchor is the
// mesh's origin: taking anything else away would round. All steps go over chunks by all threads.
#include "accel/mesh_tree.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstring>
#include <mutex>
#include <utility>
#include <vector>

#include "accel/build_range.h"
#include "accel/mesh_items.h"
#include "accel/thread_pool.h"
#include "math/bounding_box.h"

namespace accel {
namespace {

constexpr int placeOf(std::uint32_t places, int corner) {
  return int(places >> (kPlaceBits * corner) & 31);
}

/// Numbers the vertices of a leaf.
struct LocalVertices {
  static constexpr int kMost = 24;

  int count = 0;

  /// Where the corners of a face are: five bits each.
  std::uint16_t placesOf(const MeshGeometry::Face& face) {
    return std::uint16_t(placeOf(face[0]) | placeOf(face[1]) << kPlaceBits |
                         placeOf(face[2]) << 2 * kPlaceBits);
  }
  std::uint32_t vertex(int place) const { return vertices_[place + 1]; }

 private:
  /// Without branches, which would be guessed wrongly. Of two vertices with the same hash one may
  /// be there twice.
  int placeOf(std::uint32_t vertex) {
    std::uint8_t& last = last_[vertex * 0x9e3779b1u >> 25];
    const bool isNew = vertices_[last] != vertex;
    count += isNew;
    last = isNew ? std::uint8_t(count) : last;
    vertices_[last] = vertex;
    return last - 1;
  }

  std::uint8_t last_[128] = {};                        // of each hash, counted from 1
  std::uint32_t vertices_[kMost + 1] = {0xffffffffu};  // the first is none
};

/// What turns out while the tree is built. Any thread may add.
struct Findings {
  std::atomic<bool> isExact{true};  ///< scaling has lost no digit
  std::mutex mutex;
  std::vector<FaceCopies> copies;  ///< guarded by mutex
};

/// Writes leaves of corners, scaled.
class MeshLeafWriter : public LeafWriter {
 public:
  /// All items are in front of `end`.
  MeshLeafWriter(const MeshGeometry& geometry, float scale, const BuildItem* end,
                 Findings& findings)
      : geometry_(geometry), scale_(scale), end_(end), findings_(findings) {}

  int write(const BuildItem* items, int count, std::uint32_t* words) const override {
    // Items come in no order of the mesh, so every face and vertex would be waited for (build time
    // 1.09). Not in a function of its own: g++ takes one for a function without effect.
    constexpr std::ptrdiff_t kFacesAhead = 48, kVerticesAhead = 24;
    for (const BuildItem* item = items; item != items + count && end_ - item > kFacesAhead;
         ++item) {
      __builtin_prefetch(&geometry_.getFaces()[item[kFacesAhead].id]);
      const BuildItem& next = item[kVerticesAhead];
      for (std::uint32_t face = next.id; face != next.id + next.primitives; ++face) {
        for (const std::uint32_t vertex : geometry_.getFaces()[face]) {
          __builtin_prefetch(&geometry_.getVertices()[vertex]);
        }
      }
    }
    LocalVertices local;
    std::uint16_t places[8];
    std::uint32_t faces[8];
    int n = 0;
    for (const BuildItem* item = items; item != items + count; ++item) {
      for (std::uint32_t face = item->id; face != item->id + item->primitives; ++face) {
        places[n] = local.placesOf(geometry_.getFaces()[face]);
        faces[n++] = face | kIdBit;
      }
    }
    std::fill(places + n, places + 8, places[n - 1]);
    words[0] = leafHead(writeVertices(local, places, n, words + kFirstRow), LeafKind::meshTriangles,
                        n, local.count);
    std::memcpy(words + 1, places, sizeof places);
    std::copy(faces, faces + n, words + kFirstRow + 3 * local.count);
    return kFirstRow + 3 * local.count + n;
  }

  std::size_t dropCopies(BuildItem* items, std::size_t count) const override {
    const std::lock_guard<std::mutex> lock(findings_.mutex);
    return accel::dropCopies(geometry_, items, count, findings_.copies);
  }

 private:
  /// Returns the largest component of an edge of the `count` faces.
  float writeVertices(const LocalVertices& local, const std::uint16_t* places, int count,
                      std::uint32_t* rows) const {
    Vec3f scaled[LocalVertices::kMost];
    for (int k = 0; k < local.count; ++k) {
      const Vec3f& vertex = geometry_.getVertices()[local.vertex(k)];
      scaled[k] = vertex * scale_;
      if (scaled[k] * (1 / scale_) != vertex) findings_.isExact = false;
      for (int axis = 0; axis < 3; ++axis) {
        const float value = scaled[k][axis];
        std::memcpy(rows + axis * local.count + k, &value, sizeof value);
      }
    }
    float edge = 0;
    for (int i = 0; i < count; ++i) {
      const Vec3f& a = scaled[placeOf(places[i], 0)];
      edge = std::max({edge, maxAbs(scaled[placeOf(places[i], 1)] - a),
                       maxAbs(scaled[placeOf(places[i], 2)] - a)});
    }
    return edge;
  }

  const MeshGeometry& geometry_;
  const float scale_;
  const BuildItem* const end_;
  Findings& findings_;
};

/// A power of two that brings the longest side of the box to 1 to 2, or 1 where there is none.
float scaleFor(const BoundingBox& box) {
  const double longest = std::max(box.longestSide(), 0x1p-100);
  return std::ldexp(1.0f, std::clamp(-std::ilogb(longest), -126, 126));
}

}  // namespace

MeshTree::MeshTree(const MeshGeometry& geometry, int threads) : geometry_(&geometry) {
  ThreadPool::run(threads, geometry.faceCount(), [&](ThreadPool& pool) {
    BoundingBox box;
    geometry.addBounds(Matrix(), box);
    const float scale = scaleFor(box);
    Findings findings;
    MeshItems all = meshItems(geometry, scale, pool);
    bvh_.scale = scale;
    for (int axis = 0; axis < 3; ++axis) bvh_.anchor[axis] = geometry.getOrigin()[axis];
    bvh_.isInParts = divideIntoParts(geometry, scale, all);
    const MeshLeafWriter writer(geometry, scale, all.items.data() + all.items.count(), findings);
    buildWideBvh(bvh_, std::move(all.items), writer, pool);
    unscale_ = findings.isExact && !geometry.isFar() ? 1 / bvh_.scale : 0;
    // Where a face is in parts, its copies have been found for each of them.
    copies_ = std::move(findings.copies);
    std::sort(copies_.begin(), copies_.end(),
              [](const FaceCopies& a, const FaceCopies& b) { return a.face < b.face; });
  });
}

const FaceCopies* MeshTree::copiesOf(std::uint32_t face) const {
  const auto place =
      std::lower_bound(copies_.begin(), copies_.end(), face,
                       [](const FaceCopies& a, std::uint32_t b) { return a.face < b; });
  return place != copies_.end() && place->face == face ? &*place : nullptr;
}

BoundingBox MeshTree::box() const {
  const Vec3d anchor = Vec3d::of(bvh_.anchor);
  return {anchor + Vec3d::of(bvh_.whole.low) / bvh_.scale,
          anchor + Vec3d::of(bvh_.whole.high) / bvh_.scale};
}

void MeshTree::getCorners(const std::uint32_t* words, int lane, double* numbers, int stride) const {
  if (unscale_ == 0) {
    const auto corners = geometry_->corners(faceAt(words, lane));
    for (int k = 0; k < 9; ++k) numbers[k * stride] = corners[std::size_t(k / 3)][k % 3];
    return;
  }
  const int n = verticesOf(*words);
  std::uint16_t places;
  std::memcpy(&places, reinterpret_cast<const char*>(words + 1) + 2 * lane, sizeof places);
  for (int corner = 0; corner < 3; ++corner) {
    const std::uint32_t* row = words + kFirstRow + placeOf(places, corner);
    for (int axis = 0; axis < 3; ++axis, row += n, numbers += stride) {
      float value;
      std::memcpy(&value, row, sizeof value);
      *numbers = value * unscale_;
    }
  }
}

}  // namespace accel
