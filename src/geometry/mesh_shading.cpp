// MeshShading: what a mesh's surface looks like at a point, by what its vertices have.
//
// A vertex's normal is the sum of those of the faces around it, by area or each as a unit vector,
// made unit. At a point of a face normals and texture coordinates are means of the three corners',
// weighted by its barycentric coordinates. Where such a sum vanishes, the face's own normal stands.
#include "geometry/mesh_shading.h"

#include <algorithm>
#include <limits>

#include "geometry/mesh_geometry.h"
#include "geometry/triangle.h"

namespace {

/// `sum`, made unit; `otherwise` where it vanishes or is not finite.
Vec3d unitOr(const Vec3d& sum, const Vec3d& otherwise) {
  const double size = length(sum);
  return size > 0 && size <= std::numeric_limits<double>::max() ? sum / size : otherwise;
}

bool hasGap(const MeshShading::Face& face) {
  return std::find(face.begin(), face.end(), MeshShading::kNone) != face.end();
}

}  // namespace

std::vector<Vec3f> smoothNormals(const MeshGeometry& mesh, MeshNormals kind) {
  std::vector<Vec3d> sums(mesh.getVertices().size());
  for (std::uint32_t face = 0; face < mesh.faceCount(); ++face) {
    const auto [a, b, c] = mesh.corners(face);
    Vec3d normal = triangle::areaNormal(a, b, c);
    if (kind == MeshNormals::equal) normal = unitOr(normal, Vec3d());
    for (const std::uint32_t vertex : mesh.getFaces()[face]) sums[vertex] += normal;
  }
  std::vector<Vec3f> normals;
  normals.reserve(sums.size());
  for (const Vec3d& sum : sums) normals.emplace_back(unitOr(sum, Vec3d()));
  return normals;
}

void makeSmooth(MeshGeometry& mesh, MeshNormals kind) {
  MeshShading shading = mesh.getShading();
  std::vector<MeshShading::Face>& faces = shading.normalFaces;
  if (!faces.empty() && std::none_of(faces.begin(), faces.end(), hasGap)) return;
  const auto first = std::uint32_t(shading.normals.size());
  const std::vector<Vec3f> smooth = smoothNormals(mesh, kind);
  shading.normals.insert(shading.normals.end(), smooth.begin(), smooth.end());
  for (std::size_t face = 0; face < faces.size(); ++face) {
    for (std::size_t k = 0; k < 3; ++k) {
      if (faces[face][k] == MeshShading::kNone) faces[face][k] = first + mesh.getFaces()[face][k];
    }
  }
  mesh.setShading(std::move(shading));
}

void shadeHit(const MeshGeometry& mesh, std::uint32_t face, const Vec3d& point, Vec3d& normal,
              Vec2d& textureCoordinates) {
  const MeshShading& shading = mesh.getShading();
  const auto [a, b, c] = mesh.corners(face);
  const Vec3d weights = triangle::weightsAt(a, b, c, point);
  if (!shading.normals.empty()) {
    const bool areOfVertices = shading.normalFaces.empty();
    const auto& indices = areOfVertices ? mesh.getFaces()[face] : shading.normalFaces[face];
    Vec3d sum;
    for (int k = 0; k < 3; ++k) {
      const std::uint32_t index = indices[std::size_t(k)];
      const Vec3d own = index == MeshShading::kNone ? Vec3d() : Vec3d(shading.normals[index]);
      sum += (own == Vec3d() ? normal : own) * weights[k];
    }
    normal = unitOr(sum, normal);
  }
  textureCoordinates = Vec2d();
  if (shading.coordinates.empty() || hasGap(shading.coordinateFaces[face])) return;
  double u = 0, v = 0;
  for (int k = 0; k < 3; ++k) {
    const Vec2d corner = shading.coordinates[shading.coordinateFaces[face][std::size_t(k)]];
    u += corner.x() * weights[k];
    v += corner.y() * weights[k];
  }
  textureCoordinates = {u, v};
}
