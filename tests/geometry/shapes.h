// What the geometry tests share: a material to hit, a list of crossings, and two closed meshes.
#pragma once
#include <algorithm>
#include <vector>

#include "geometry/mesh_geometry.h"
#include "geometry/object3d.h"
#include "shading/phong_material.h"

namespace shapes {

inline constexpr double kInf = std::numeric_limits<double>::infinity();

inline PhongMaterial plainMaterial() {
  return PhongMaterial(Vec3f(1, 1, 1), Vec3f(), 1, Vec3f(), Vec3f(), 1);
}

/// Keeps all crossings in the order of t.
class CrossingList : public CrossingVisitor {
 public:
  CrossingList(const Object3D& object, const Ray& ray) {
    object.visitCrossings(ray, *this);
    std::stable_sort(list_.begin(), list_.end(),
                     [](const Crossing& a, const Crossing& b) { return a.t < b.t; });
  }
  void visit(const Crossing& crossing) override { list_.push_back(crossing); }
  int size() const { return int(list_.size()); }
  const Crossing& operator[](int i) const { return list_[std::size_t(i)]; }
  /// How many more lead out than in.
  int surplusOfLeaving() const {
    int sum = 0;
    for (const Crossing& crossing : list_) sum += crossing.leaving ? 1 : -1;
    return sum;
  }
  /// In and out by turns, but for neighbours less than `tie` apart, whose order says nothing.
  bool alternates(double tie) const {
    for (std::size_t i = 1; i < list_.size(); ++i) {
      const bool same = list_[i].leaving == list_[i - 1].leaving;
      if (same && list_[i].t - list_[i - 1].t > tie) return false;
    }
    return true;
  }

 private:
  std::vector<Crossing> list_;
};

/// The cube [-half, half]^3, faces outwards, two triangles a side.
inline MeshGeometry cube(float half) {
  std::vector<Vec3f> vertices;
  for (int i = 0; i < 8; ++i)
    vertices.emplace_back(i & 1 ? half : -half, i & 2 ? half : -half, i & 4 ? half : -half);
  return MeshGeometry(vertices, {{0, 2, 3},
                                 {0, 3, 1},
                                 {4, 5, 7},
                                 {4, 7, 6},
                                 {0, 1, 5},
                                 {0, 5, 4},
                                 {2, 6, 7},
                                 {2, 7, 3},
                                 {0, 4, 6},
                                 {0, 6, 2},
                                 {1, 3, 7},
                                 {1, 7, 5}});
}

/// Puts the middle of edge ab on the unit sphere; each edge is split once from either side.
inline std::uint32_t splitEdge(std::vector<Vec3f>& vertices, std::uint32_t a, std::uint32_t b) {
  const Vec3f middle(normalize(Vec3d(vertices[a]) + Vec3d(vertices[b])));
  const auto found = std::find(vertices.begin(), vertices.end(), middle);
  const auto place = std::uint32_t(found - vertices.begin());
  if (found == vertices.end()) vertices.push_back(middle);
  return place;
}

/// A ball of 8 x 4^levels triangles around the origin, its vertices at distance 1 in float.
inline MeshGeometry ball(int levels) {
  std::vector<Vec3f> v = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  std::vector<MeshGeometry::Face> faces = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4},
                                           {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
  for (int level = 0; level < levels; ++level) {
    std::vector<MeshGeometry::Face> finer;
    for (const MeshGeometry::Face& f : faces) {
      const std::uint32_t ab = splitEdge(v, f[0], f[1]), bc = splitEdge(v, f[1], f[2]),
                          ca = splitEdge(v, f[2], f[0]);
      finer.insert(finer.end(), {{f[0], ab, ca}, {ab, f[1], bc}, {ca, bc, f[2]}, {ab, bc, ca}});
    }
    faces = finer;
  }
  return MeshGeometry(v, faces);
}

}  // namespace shapes
