// MeshGeometry: the vertices and triangles of one OBJ file, shared by all meshes that name it.
// Vertices are stored in float, which holds every digit that OBJ files carry, and used in double.
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "math/vec3.h"

class MeshGeometry {
 public:
  using Face = std::array<std::uint32_t, 3>;

  MeshGeometry() = default;
  /// Every index in `faces` must be below vertices.size().
  MeshGeometry(std::vector<Vec3f> vertices, std::vector<Face> faces)
      : vertices_(std::move(vertices)), faces_(std::move(faces)) {}

  const std::vector<Vec3f>& getVertices() const { return vertices_; }
  const std::vector<Face>& getFaces() const { return faces_; }
  std::uint32_t faceCount() const { return std::uint32_t(faces_.size()); }
  /// Corner 0, 1 or 2 of face `face`.
  Vec3d corner(std::uint32_t face, int index) const {
    return vertices_[faces_[face][std::size_t(index)]];
  }
  /// Faces without area, which no ray ever hits.
  std::uint32_t countFlatFaces() const;

  /// True once findWhetherClosed has found that the surface encloses a volume.
  bool isClosed() const { return closed_; }
  /// Closed means: after merging vertices at equal positions, every edge belongs to exactly two
  /// faces, which run along it in opposite directions. Time n log n.
  void findWhetherClosed();

 private:
  std::vector<Vec3f> vertices_;
  std::vector<Face> faces_;
  bool closed_ = false;
};
