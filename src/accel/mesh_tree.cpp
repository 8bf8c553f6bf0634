// MeshTree: leaves hold the corners themselves, so that deciding a hit needs no look at the mesh.
//
// Corners are stored scaled by a power of two, which brings the mesh's longest side to 1 to 2: that
// loses no digit unless a number leaves the range of float, so dividing gives back the mesh's own
// corners; where any does not come back, they are fetched from the mesh instead. There is no
// anchor, for taking it away would round. Boxes of faces are the exact boxes of such corners. Faces
// without area are left out: no ray hits them. All steps go over chunks by all threads.
#include "accel/mesh_tree.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numeric>
#include <vector>

#include "accel/build_range.h"
#include "accel/thread_pool.h"
#include "geometry/triangle.h"
#include "math/bounding_box.h"

namespace accel {
namespace {

/// Writes leaves of corners, scaled.
class MeshLeafWriter : public LeafWriter {
 public:
  MeshLeafWriter(const MeshGeometry& geometry, float scale) : geometry_(geometry), scale_(scale) {}

  void write(const BuildItem* items, const std::uint8_t* sizes, std::size_t leafCount,
             std::uint32_t* words) const override {
    const BuildItem* end = std::accumulate(sizes, sizes + leafCount, items);
    for (const std::uint8_t* size = sizes; size != sizes + leafCount; ++size) {
      for (int i = 0; i < *size; ++i) prefetchAhead(items + i, end);
      writeLeaf(items, *size, words);
      words += wordsOf(LeafKind::meshTriangles, *size);
      items += *size;
    }
  }

 private:
  /// The items come in no order of the mesh, so every face and vertex would be waited for.
  void prefetchAhead(const BuildItem* item, const BuildItem* end) const {
    constexpr std::ptrdiff_t kFacesAhead = 48, kVerticesAhead = 24;
    if (end - item > kFacesAhead) prefetch(&geometry_.getFaces()[item[kFacesAhead].id]);
    if (end - item <= kVerticesAhead) return;
    for (const std::uint32_t vertex : geometry_.getFaces()[item[kVerticesAhead].id]) {
      prefetch(&geometry_.getVertices()[vertex]);
    }
  }
  void writeLeaf(const BuildItem* items, int count, std::uint32_t* words) const {
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
  const MeshGeometry& geometry_;
  float scale_;
};

/// A power of two that brings the longest side of the box to 1 to 2, or 1 where there is none.
float scaleFor(const BoundingBox& box) {
  const double longest = std::max(box.longestSide(), 0x1p-100);
  return std::ldexp(1.0f, std::clamp(-std::ilogb(longest), -126, 126));
}

constexpr std::size_t kChunk = 32768;

/// Calls work(chunk, begin, end) for chunks of [0, count).
template <class Work>
void forEachChunk(ThreadPool& pool, std::size_t count, const Work& work) {
  pool.forEachIndex((count + kChunk - 1) / kChunk, [&](std::size_t chunk) {
    work(chunk, chunk * kChunk, std::min(count, (chunk + 1) * kChunk));
  });
}

Float4 asFloat4(const Vec3f& v) { return Float4::of(v.x(), v.y(), v.z()); }

BoundingBox boxOf(const std::vector<Vec3f>& vertices, ThreadPool& pool) {
  std::vector<BoundingBox> boxes(vertices.size() / kChunk + 1);
  forEachChunk(pool, vertices.size(), [&](std::size_t chunk, std::size_t begin, std::size_t end) {
    Box4 box = Box4::empty();
    for (std::size_t i = begin; i < end; ++i) box.extend(asFloat4(vertices[i]));
    float low[4], high[4];
    box.low.store(low);
    box.high.store(high);
    boxes[chunk] = {Vec3d(low[0], low[1], low[2]), Vec3d(high[0], high[1], high[2])};
  });
  for (const BoundingBox& box : boxes) boxes[0].extend(box);
  return boxes[0];
}

/// True where scaling loses no digit.
bool scalesExactly(const std::vector<Vec3f>& vertices, float scale, ThreadPool& pool) {
  std::vector<char> exact(vertices.size() / kChunk + 1, 1);
  forEachChunk(pool, vertices.size(), [&](std::size_t chunk, std::size_t begin, std::size_t end) {
    bool same = true;
    for (std::size_t i = begin; i < end; ++i) {
      same = same && vertices[i] * scale * (1 / scale) == vertices[i];
    }
    exact[chunk] = same ? 1 : 0;
  });
  return std::all_of(exact.begin(), exact.end(), [](char same) { return same != 0; });
}

/// Whether triangle::areaNormal is not 0, mostly without computing it: rounding changes the float
/// normal by less than 2^-21 of the product of the edges, a denormal by less than 2^-120.
bool hasArea(const Vec3f& a, const Vec3f& b, const Vec3f& c) {
  const Vec3f e1 = b - a, e2 = c - a;
  if (maxAbs(cross(e1, e2)) > maxAbs(e1) * maxAbs(e2) * 0x1p-20f + 0x1p-120f) return true;
  return triangle::areaNormal(Vec3d(a), Vec3d(b), Vec3d(c)) != Vec3d();
}

/// Appends the boxes of faces [begin, end) that have an area at `item`; returns the end.
BuildItem* appendItems(const MeshGeometry& geometry, float scale, std::size_t begin,
                       std::size_t end, BuildItem* item) {
  const std::vector<Vec3f>& vertices = geometry.getVertices();
  const Float4 scales = Float4::all(scale);
  for (std::size_t i = begin; i < end; ++i) {
    const MeshGeometry::Face& face = geometry.getFaces()[i];
    const Vec3f &v0 = vertices[face[0]], &v1 = vertices[face[1]], &v2 = vertices[face[2]];
    if (!hasArea(v0, v1, v2)) continue;
    const Float4 a = asFloat4(v0), b = asFloat4(v1), c = asFloat4(v2);
    (smaller(a, smaller(b, c)) * scales).store(item->low);
    (larger(a, larger(b, c)) * scales).store(item->high);
    item->id = std::uint32_t(i);
    item->kind = LeafKind::meshTriangles;
    ++item;
  }
  return item;
}

BuildItems itemsOf(const MeshGeometry& geometry, float scale, ThreadPool& pool) {
  const std::size_t faces = geometry.faceCount();
  BuildItems items(faces);
  std::vector<std::size_t> counts(faces / kChunk + 1);
  forEachChunk(pool, faces, [&](std::size_t chunk, std::size_t begin, std::size_t end) {
    BuildItem* first = items.data() + begin;
    counts[chunk] = std::size_t(appendItems(geometry, scale, begin, end, first) - first);
  });
  std::size_t count = 0;  // faces without area leave gaps, which are closed
  for (std::size_t chunk = 0; chunk * kChunk < faces; ++chunk) {
    const BuildItem* first = items.data() + chunk * kChunk;
    if (count != chunk * kChunk) std::copy(first, first + counts[chunk], items.data() + count);
    count += counts[chunk];
  }
  items.setCount(count);
  return items;
}

}  // namespace

MeshTree::MeshTree(const MeshGeometry& geometry, int threads) : geometry_(&geometry) {
  ThreadPool::run(threads, geometry.faceCount(), [&](ThreadPool& pool) {
    const float scale = scaleFor(boxOf(geometry.getVertices(), pool));
    bvh_.scale = scale;
    exact_ = scalesExactly(geometry.getVertices(), scale, pool);
    buildWideBvh(bvh_, itemsOf(geometry, scale, pool), MeshLeafWriter(geometry, scale), pool);
  });
}

BoundingBox MeshTree::box() const {
  const double *low = bvh_.whole.low, *high = bvh_.whole.high;
  return {Vec3d(low[0], low[1], low[2]) / bvh_.scale,
          Vec3d(high[0], high[1], high[2]) / bvh_.scale};
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
  for (int k = 0; k < 9; ++k) {
    float value;
    std::memcpy(&value, words + 1 + k * n + lane, sizeof value);
    v[k] = value * unscale;
  }
  return {Vec3d(v[0], v[1], v[2]), Vec3d(v[3], v[4], v[5]), Vec3d(v[6], v[7], v[8]), face};
}

}  // namespace accel
