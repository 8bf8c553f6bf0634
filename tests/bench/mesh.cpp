// The displaced icosphere: a geodesic grid whose faces share the vertices of edges and corners.
#include "mesh.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <memory>
#include <stdexcept>

#include "system/worker_threads.h"

namespace bench {
namespace {

constexpr double kRadius = 10;
constexpr double kGolden = 1.618033988749895;

constexpr double kCorners[12][3] = {{-1, kGolden, 0},  {1, kGolden, 0},   {-1, -kGolden, 0},
                                    {1, -kGolden, 0},  {0, -1, kGolden},  {0, 1, kGolden},
                                    {0, -1, -kGolden}, {0, 1, -kGolden},  {kGolden, 0, -1},
                                    {kGolden, 0, 1},   {-kGolden, 0, -1}, {-kGolden, 0, 1}};
constexpr std::uint32_t kFaces[20][3] = {
    {0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
    {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
    {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}};

/// A number in [-1, 1) for each point of the integer grid.
double latticeValue(std::int64_t x, std::int64_t y, std::int64_t z) {
  std::uint64_t h = std::uint64_t(x) * 0x9E3779B97F4A7C15u +
                    std::uint64_t(y) * 0xC2B2AE3D27D4EB4Fu +
                    std::uint64_t(z) * 0x165667B19E3779F9u + 12345;
  h = (h ^ (h >> 31)) * 0xBF58476D1CE4E5B9u;
  h = (h ^ (h >> 27)) * 0x94D049BB133111EBu;
  return double((h ^ (h >> 31)) >> 11) * 0x1p-52 - 1;
}

double mixed(double a, double b, double t) { return a + (b - a) * (t * t * (3 - 2 * t)); }

/// Values of the grid, blended smoothly in between.
double noise(const Vec3d& p) {
  const double fx = std::floor(p.x()), fy = std::floor(p.y()), fz = std::floor(p.z());
  const auto x = std::int64_t(fx), y = std::int64_t(fy), z = std::int64_t(fz);
  double planes[2];
  for (int k = 0; k < 2; ++k) {
    double lines[2];
    for (int j = 0; j < 2; ++j) {
      lines[j] =
          mixed(latticeValue(x, y + j, z + k), latticeValue(x + 1, y + j, z + k), p.x() - fx);
    }
    planes[k] = mixed(lines[0], lines[1], p.y() - fy);
  }
  return mixed(planes[0], planes[1], p.z() - fz);
}

Vec3d displaced(const Vec3d& direction) {
  double height = 0, size = 0.16, frequency = 2.5;
  for (int octave = 0; octave < 5; ++octave) {
    height += size * noise(direction * frequency);
    size /= 2;
    frequency *= 2;
  }
  return direction * (kRadius * (1 + height));
}

/// Numbers the grid's vertices: 12 corners, then those within edges, then those within faces.
class Grid {
 public:
  explicit Grid(int n) : n_(std::uint32_t(n)) {
    for (const auto& face : kFaces) {
      for (int k = 0; k < 3; ++k) edges_.emplace(edge(face[k], face[(k + 1) % 3]), 0);
    }
    std::uint32_t next = 12;
    for (auto& entry : edges_) {
      entry.second = next;
      next += n_ - 1;
    }
    inner_ = next;
  }

  std::uint32_t vertexCount() const { return 10 * n_ * n_ + 2; }

  /// The vertex of `face` that lies i steps towards corner 1 and j towards corner 2.
  std::uint32_t vertex(std::uint32_t face, std::uint32_t i, std::uint32_t j) const {
    const std::uint32_t* c = kFaces[face];
    if (j == 0) return onEdge(c[0], c[1], i);
    if (i == 0) return onEdge(c[0], c[2], j);
    if (i + j == n_) return onEdge(c[1], c[2], j);
    const std::uint32_t perFace = (n_ - 1) * (n_ - 2) / 2;
    // Rows j = 1, 2, ... hold n - 1 - j vertices each.
    return inner_ + face * perFace + (j - 1) * (2 * n_ - 2 - j) / 2 + (i - 1);
  }

  Vec3d place(std::uint32_t face, std::uint32_t i, std::uint32_t j) const {
    const auto corner = [&](int k) {
      const double* c = kCorners[kFaces[face][k]];
      return Vec3d(c[0], c[1], c[2]);
    };
    return normalize(corner(0) * double(n_ - i - j) + corner(1) * double(i) +
                     corner(2) * double(j));
  }

 private:
  static std::pair<std::uint32_t, std::uint32_t> edge(std::uint32_t a, std::uint32_t b) {
    return {std::min(a, b), std::max(a, b)};
  }
  std::uint32_t onEdge(std::uint32_t from, std::uint32_t to, std::uint32_t step) const {
    if (step == 0) return from;
    if (step == n_) return to;
    return edges_.at(edge(from, to)) + (from < to ? step - 1 : n_ - 1 - step);
  }

  std::uint32_t n_;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> edges_;
  std::uint32_t inner_ = 0;
};

void addFaces(const Grid& grid, std::uint32_t face, int cuts,
              std::vector<MeshGeometry::Face>& out) {
  const auto n = std::uint32_t(cuts);
  for (std::uint32_t j = 0; j < n; ++j) {
    for (std::uint32_t i = 0; i + j < n; ++i) {
      const std::uint32_t right = grid.vertex(face, i + 1, j), up = grid.vertex(face, i, j + 1);
      out.push_back({grid.vertex(face, i, j), right, up});
      if (i + j + 1 < n) out.push_back({right, grid.vertex(face, i + 1, j + 1), up});
    }
  }
}

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};

}  // namespace

int cutsForTriangles(double triangles) {
  return std::max(1, int(std::lround(std::sqrt(triangles / 20))));
}

MeshGeometry displacedSphere(int n) {
  const Grid grid(n);
  std::vector<Vec3f> vertices(grid.vertexCount());
  const auto cuts = std::uint32_t(n);
  runOnThreads(20, 0, [&](int face) {
    for (std::uint32_t j = 0; j <= cuts; ++j) {
      for (std::uint32_t i = 0; i + j <= cuts; ++i) {
        // Of vertices on an edge each face finds another rounding; the face listed first decides.
        const bool isInner = i > 0 && j > 0 && i + j < cuts;
        if (!isInner) continue;
        vertices[grid.vertex(std::uint32_t(face), i, j)] =
            Vec3f(displaced(grid.place(std::uint32_t(face), i, j)));
      }
    }
  });
  std::vector<MeshGeometry::Face> faces;
  faces.reserve(20 * std::size_t(n) * std::size_t(n));
  for (std::uint32_t face = 0; face < 20; ++face) {
    for (std::uint32_t i = 0; i <= cuts; ++i) {
      const std::uint32_t rim[3][2] = {{i, 0}, {0, i}, {cuts - i, i}};
      for (const auto& p : rim) {
        vertices[grid.vertex(face, p[0], p[1])] = Vec3f(displaced(grid.place(face, p[0], p[1])));
      }
    }
    addFaces(grid, face, n, faces);
  }
  return MeshGeometry(std::move(vertices), std::move(faces));
}

void writeObj(const MeshGeometry& mesh, const std::string& path) {
  const std::unique_ptr<std::FILE, CloseFile> file(std::fopen(path.c_str(), "w"));
  if (!file) throw std::runtime_error(path + ": cannot be written");
  for (const Vec3f& v : mesh.getVertices()) {
    std::fprintf(file.get(), "v %.6f %.6f %.6f\n", double(v.x()), double(v.y()), double(v.z()));
  }
  for (const MeshGeometry::Face& f : mesh.getFaces()) {
    std::fprintf(file.get(), "f %u %u %u\n", f[0] + 1, f[1] + 1, f[2] + 1);
  }
  if (std::fflush(file.get()) != 0) throw std::runtime_error(path + ": cannot be written");
}

}  // namespace bench
