// MeshShading: what a mesh tells of the corners of its faces beyond where they are: normals, which
// make it look smooth, and texture coordinates. Most meshes tell nothing, and keep nothing.
//
// Both are interpolated over a face by the barycentric weights of the point that is hit, in the
// mesh's own space, by one function for all who find hits.
// Source: Phong, "Illumination for Computer Generated Pictures", 1975.
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "math/vec3.h"

class MeshGeometry;

/// What the normal of a vertex is made of.
enum class MeshNormals {
  flat,    ///< nothing: each face is flat
  byArea,  ///< the sum of the normals of its faces, each as long as the face is large
  equal    ///< the sum of their unit normals
};

struct MeshShading {
  using Face = std::array<std::uint32_t, 3>;
  /// Stands in a Face for a corner of which nothing is told.
  static constexpr std::uint32_t kNone = 0xffffffffu;

  /// Of any length; where one is (0, 0, 0), the face's own takes its place.
  std::vector<Vec3f> normals;
  /// The normals of the corners of each face; empty where normals[i] is that of vertex i.
  std::vector<Face> normalFaces;
  std::vector<Vec2f> coordinates;
  /// The texture coordinates of the corners of each face; empty where `coordinates` is.
  std::vector<Face> coordinateFaces;

  bool isEmpty() const { return normals.empty() && coordinates.empty(); }
};

/// For each vertex of the mesh the unit normal that `kind`, not flat, makes from the faces with
/// that vertex (by its number: others at the same place do not count), which are added in their
/// order. (0, 0, 0) where they cancel out, or have no area, or where there are none.
std::vector<Vec3f> smoothNormals(const MeshGeometry& mesh, MeshNormals kind);

/// Gives each corner of the mesh that has no normal yet the smooth one of its vertex.
void makeSmooth(MeshGeometry& mesh, MeshNormals kind);

/// Shades a hit on face `face` at `point`, which is in the mesh's own space: `normal`, the face's
/// own unit normal, becomes the interpolated one, made unit. It stays where the mesh has none, and
/// where that one vanishes or is not finite. `textureCoordinates` becomes the interpolated texture
/// coordinates, (0, 0) where a corner has none.
void shadeHit(const MeshGeometry& mesh, std::uint32_t face, const Vec3d& point, Vec3d& normal,
              Vec2d& textureCoordinates);
