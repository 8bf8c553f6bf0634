// The items of a mesh: one box for each face, in the order of the faces.
//
// Boxes are the exact boxes of the scaled corners. Faces without area are left out: no ray hits
// them.
#include "accel/mesh_items.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <unordered_map>

#include "geometry/triangle.h"

namespace accel {
namespace {

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

/// The bits of a face's corners.
using Corners = std::array<std::uint32_t, 9>;

Corners cornersOf(const MeshGeometry& geometry, std::uint32_t face) {
  Corners corners;
  for (std::size_t k = 0; k < 9; ++k) {
    const Vec3f& vertex = geometry.getVertices()[geometry.getFaces()[face][k / 3]];
    const float value = vertex[int(k % 3)];
    std::memcpy(&corners[k], &value, sizeof value);
  }
  return corners;
}

struct CornersHash {
  std::size_t operator()(const Corners& corners) const {
    std::uint64_t hash = 0;
    for (const std::uint32_t bits : corners) hash = (hash ^ bits) * 0x9e3779b97f4a7c15u;
    return std::size_t(hash ^ hash >> 32);
  }
};

}  // namespace

BuildItems meshItems(const MeshGeometry& geometry, float scale, ThreadPool& pool) {
  const std::size_t faces = geometry.faceCount();
  BuildItems items(faces);
  std::vector<std::size_t> counts(faces / kFacesPerChunk + 1);
  forEachChunk(pool, faces, [&](std::size_t chunk, std::size_t begin, std::size_t end) {
    BuildItem* first = items.data() + begin;
    counts[chunk] = std::size_t(appendItems(geometry, scale, begin, end, first) - first);
  });
  std::size_t count = 0;  // faces without area leave gaps, which are closed
  for (std::size_t chunk = 0; chunk * kFacesPerChunk < faces; ++chunk) {
    const BuildItem* first = items.data() + chunk * kFacesPerChunk;
    if (count != chunk * kFacesPerChunk)
      std::copy(first, first + counts[chunk], items.data() + count);
    count += counts[chunk];
  }
  items.setCount(count);
  return items;
}

std::vector<FaceCopies> dropCopies(const MeshGeometry& geometry,
                                   const std::vector<std::uint32_t>& faces, BuildItems& items) {
  std::unordered_map<Corners, FaceCopies, CornersHash> found;
  for (const std::uint32_t face : faces) found[cornersOf(geometry, face)] = FaceCopies{};
  BuildItem* end = items.data();
  for (const BuildItem* item = end; item != items.data() + items.count(); ++item) {
    const auto place = found.find(cornersOf(geometry, item->id));
    if (place != found.end()) {
      FaceCopies& copies = place->second;
      if (++copies.count == 1) copies.face = item->id;
      if (copies.count == 2) copies.next = item->id;
      if (copies.count > 1) continue;
    }
    *end++ = *item;
  }
  items.setCount(std::size_t(end - items.data()));
  std::vector<FaceCopies> dropped;
  for (const auto& each : found) {
    if (each.second.count > 1) dropped.push_back(each.second);
  }
  std::sort(dropped.begin(), dropped.end(),
            [](const FaceCopies& a, const FaceCopies& b) { return a.face < b.face; });
  return dropped;
}

}  // namespace accel
