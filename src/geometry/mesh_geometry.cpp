// MeshGeometry: what can be said of a mesh as a whole.
//
// Bounds. One geometry may stand in a scene ten thousand times, each time turned otherwise, and
// tight bounds need every corner. So the faces are looked over once, in runs of 64 that lie next to
// each other in the file, and mostly in space, and the box of each run is kept. For an instance a
// run whose moved box lies within the bounds found so far cannot extend them, and is passed over.
//
// Closed. Every side of every face is an edge from one position to the next, written as one number.
// The surface is closed where no edge comes twice and every edge also comes the other way: then
// each pair of positions joins exactly two faces, which run along it in opposite directions.
#include "geometry/mesh_geometry.h"

#include <algorithm>
#include <numeric>
#include <tuple>

#include "geometry/triangle.h"
#include "system/worker_threads.h"

namespace {

/// By x, then y, then z; -0 is 0.
bool positionLess(const Vec3f& a, const Vec3f& b) {
  return std::make_tuple(a.x(), a.y(), a.z()) < std::make_tuple(b.x(), b.y(), b.z());
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

}  // namespace

MeshGeometry::MeshGeometry(std::vector<Vec3f> vertices, std::vector<Face> faces,
                           const Vec3d& origin)
    : origin_(origin), vertices_(std::move(vertices)), faces_(std::move(faces)) {
  runs_.resize((faces_.size() + kRunFaces - 1) / kRunFaces);
  constexpr std::size_t kRunsAtOnce = 256;  // some 0.2 ms of work
  const std::size_t shares = (runs_.size() + kRunsAtOnce - 1) / kRunsAtOnce;
  shareOnThreads(hardwareThreads(), 0, shares, [&](std::size_t share) {
    const std::size_t last = std::min((share + 1) * kRunsAtOnce, runs_.size());
    for (std::size_t run = share * kRunsAtOnce; run < last; ++run) runs_[run] = lookOver(run);
  });
  findExtremes();
}

template <class Visitor>
void MeshGeometry::visitCorners(std::size_t run, const Visitor& visit) const {
  const std::size_t first = run * kRunFaces, last = std::min(first + kRunFaces, faces_.size());
  for (std::size_t face = first; face < last; ++face) {
    for (const std::uint32_t vertex : faces_[face]) visit(vertices_[vertex]);
  }
}

/// Everything in one pass over the corners, with the box in variables of its own: 0.5 of the
/// instructions of two passes that keep it in memory.
MeshGeometry::FaceRun MeshGeometry::lookOver(std::size_t run) const {
  const std::size_t first = run * kRunFaces, last = std::min(first + kRunFaces, faces_.size());
  Vec3f low = vertices_[faces_[first][0]], high = low;
  std::uint32_t flatFaces = 0;
  for (std::size_t face = first; face < last; ++face) {
    const auto& [i, j, k] = faces_[face];
    const Vec3f &a = vertices_[i], &b = vertices_[j], &c = vertices_[k];
    for (const Vec3f* corner : {&a, &b, &c}) {
      low = least(*corner, low);
      high = largest(*corner, high);
    }
    const Vec3d normal = triangle::areaNormal(Vec3d(a), Vec3d(b), Vec3d(c));
    if (normal.x() != 0) continue;  // so the others are mostly not needed
    flatFaces += normal == Vec3d();
  }
  return {low, high, flatFaces};
}

/// Finds for each side of the mesh's box a corner that lies on it.
void MeshGeometry::findExtremes() {
  if (runs_.empty()) return;
  for (int axis = 0; axis < 3; ++axis) {
    std::size_t lowest = 0, highest = 0;
    for (std::size_t run = 0; run < runs_.size(); ++run) {
      if (runs_[run].low[axis] < runs_[lowest].low[axis]) lowest = run;
      if (runs_[run].high[axis] > runs_[highest].high[axis]) highest = run;
    }
    Vec3f low = runs_[lowest].high, high = runs_[highest].low;
    visitCorners(lowest, [&](const Vec3f& v) { low = v[axis] <= low[axis] ? v : low; });
    visitCorners(highest, [&](const Vec3f& v) { high = v[axis] >= high[axis] ? v : high; });
    extremes_.insert(extremes_.end(), {low, high});
  }
}

std::uint32_t MeshGeometry::countFlatFaces() const {
  std::uint32_t count = 0;
  for (const FaceRun& run : runs_) count += run.flatFaces;
  return count;
}

/// The corners on the sides of the mesh's own box come first: mostly they leave nothing to be
/// found, or but a few runs. (A scene of 10,000 instances of 70,000 faces is read in 0.12 s;
/// without a look at the whole box in 0.6 s, and 36 s went for looking at all corners.)
void MeshGeometry::addBounds(const Matrix& toWorld, BoundingBox& box) const {
  if (runs_.empty()) return;
  const auto extend = [&](const Vec3f& corner) {
    box.extend(toWorld.transformPoint(origin_ + corner));
  };
  const auto isInside = [&](const Vec3f& low, const Vec3f& high) {
    return box.contains(BoundingBox(origin_ + low, origin_ + high).moved(toWorld));
  };
  for (const Vec3f& corner : extremes_) extend(corner);
  const Vec3f low(extremes_[0].x(), extremes_[2].y(), extremes_[4].z()),
      high(extremes_[1].x(), extremes_[3].y(), extremes_[5].z());
  if (isInside(low, high)) return;
  for (std::size_t run = 0; run < runs_.size(); ++run) {
    if (!isInside(runs_[run].low, runs_[run].high)) visitCorners(run, extend);
  }
}

void MeshGeometry::findWhetherClosed() {
  if (isClosed_) return;
  const std::vector<std::uint32_t> numbers = numberPositions(vertices_);
  std::vector<std::uint64_t> edges, reversed;
  edges.reserve(3 * faces_.size());
  reversed.reserve(3 * faces_.size());
  bool hasPoints = false;  // as sides of a face
  for (const Face& face : faces_) {
    for (std::size_t side = 0; side < 3; ++side) {
      const std::uint64_t from = numbers[face[side]], to = numbers[face[(side + 1) % 3]];
      edges.push_back(from << 32 | to);
      reversed.push_back(to << 32 | from);
      hasPoints |= from == to;
    }
  }
  std::sort(edges.begin(), edges.end());
  std::sort(reversed.begin(), reversed.end());
  isClosed_ = !edges.empty() && !hasPoints && edges == reversed &&
              std::adjacent_find(edges.begin(), edges.end()) == edges.end();
}
