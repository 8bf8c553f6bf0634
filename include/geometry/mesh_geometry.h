// MeshGeometry: the vertices and triangles of one OBJ file, shared by all meshes that name it.
// Vertices are stored in float and used in double. Of a mesh far from 0, in units of its own size,
// they are measured from an origin near it, or no float would tell them apart.
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "geometry/mesh_shading.h"
#include "math/bounding_box.h"
#include "math/matrix.h"
#include "math/vec3.h"

class MeshGeometry {
 public:
  /// The corners of a triangle, as indices of vertices.
  using Face = std::array<std::uint32_t, 3>;

  /// The origin that changes nothing: even -0 stays as it is when this is added.
  static constexpr Vec3d kZero{-0.0, -0.0, -0.0};

  MeshGeometry() = default;
  /// Every index in `faces` must be below vertices.size(). The vertices of faces are measured from
  /// `origin`, and double must hold each sum exactly: so what is said of differences, areas and
  /// equal places needs no origin. Large meshes are looked over by several threads.
  MeshGeometry(std::vector<Vec3f> vertices, std::vector<Face> faces, const Vec3d& origin = kZero);

  /// Measured from the origin.
  const std::vector<Vec3f>& getVertices() const { return vertices_; }
  const Vec3d& getOrigin() const { return origin_; }
  /// Whether the origin is other than kZero.
  bool isFar() const { return isFar_; }
  const std::vector<Face>& getFaces() const { return faces_; }
  std::uint32_t faceCount() const { return std::uint32_t(faces_.size()); }
  /// The corners of face `face`, below faceCount(), in the mesh's own space.
  std::array<Vec3d, 3> corners(std::uint32_t face) const {
    const auto& [i, j, k] = faces_[face];
    if (!isFar_) return {vertices_[i], vertices_[j], vertices_[k]};
    return {origin_ + vertices_[i], origin_ + vertices_[j], origin_ + vertices_[k]};
  }
  /// Corner 0, 1 or 2 of face `face`, in the mesh's own space.
  Vec3d corner(std::uint32_t face, int index) const { return corners(face)[std::size_t(index)]; }
  /// Faces without area, which no ray ever hits.
  std::uint32_t countFlatFaces() const;
  /// Extends `box` by all faces as `toWorld` places them. Of a large mesh only the parts that stand
  /// out of the box are visited.
  void addBounds(const Matrix& toWorld, BoundingBox& box) const;

  /// What is told of the corners; mostly nothing.
  const MeshShading& getShading() const { return shading_; }
  /// Every index in it must be below the number of what it counts, or kNone.
  void setShading(MeshShading shading) { shading_ = std::move(shading); }

  /// True once findWhetherClosed has found that the surface encloses a volume.
  bool isClosed() const { return isClosed_.value_or(false); }
  /// Closed means: after merging vertices at equal positions, every edge belongs to exactly two
  /// faces, which run along it in opposite directions. Time n log n; none where it is known.
  void findWhetherClosed();

 private:
  /// What is known of kRunFaces faces in a row (the last run may have fewer).
  struct FaceRun {
    Vec3f low, high;  // their bounding box, measured from the origin
    std::uint32_t flatFaces = 0;
  };
  static constexpr std::size_t kRunFaces = 64;

  FaceRun lookOver(std::size_t run) const;
  void findExtremes();
  template <class Visitor>
  void visitCorners(std::size_t run, const Visitor& visit) const;

  Vec3d origin_ = kZero;
  bool isFar_ = origin_ != kZero;
  std::vector<Vec3f> vertices_;
  std::vector<Face> faces_;
  std::vector<FaceRun> runs_;
  std::vector<Vec3f> extremes_;  // corners on the mesh's own box: at low x, high x, low y, ...
  MeshShading shading_;
  std::optional<bool> isClosed_;  // once it is known
};
