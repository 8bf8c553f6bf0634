// SceneReview: objects that the camera cannot see and lights that objects enclose. Both are legal
// and probably mistakes. One walk over all objects, with little to do at each.
#pragma once
#include <cstddef>
#include <vector>

#include "geometry/triangle_mesh.h"
#include "math/vec3.h"
#include "scene/scene_parser.h"
#include "shading/light.h"

class SceneReview {
 public:
  struct EnclosedLight {
    int light;  ///< its number in the scene
    const Object3D* around;
  };

  /// Looks over a scene that is read without a mistake. Nothing is owned.
  explicit SceneReview(const SceneParser& scene);

  /// Spheres, triangles and meshes wholly behind a perspective camera, in scene order. None where
  /// any object is a mirror, which may show them.
  const std::vector<const Object3D*>& getBehindCamera() const { return behind_; }

  /// Point lights inside an opaque closed object (a sphere, a closed mesh) in which the camera is
  /// not, in the order of the lights, with the first such object. Lights are not looked for where
  /// there are too many pairs of light and object, or of light and mesh triangle.
  std::vector<EnclosedLight> getEnclosedLights() const;

 private:
  /// Where normal . p + offset > 0, the camera may see.
  struct View {
    Vec3d normal;
    double offset = 0, length = 0;  // of the normal
  };
  using Points = std::vector<Vec3d>;  // of the eye, then the point lights, in the object's space

  void visit(const Object3D& object, const View& view, const Points& points);
  void visitMoved(const class Transform& transform, const View& view, const Points& points);
  void visitSphere(const class Sphere& sphere, const View& view, const Points& points);
  void visitTriangle(const class Triangle& triangle, const View& view);
  void visitMesh(const TriangleMesh& mesh, const View& view, const Points& points);
  void noteMaterial(const Material& material);
  /// True where the object is opaque and there are lights to look for in it.
  bool mayEnclose(const Material& material);
  template <class IsInside>
  void findEnclosed(const Object3D& object, const Points& points, const IsInside& isInside);

  bool isPerspective_ = false, hasMirror_ = false;
  const Material* lastMaterial_ = nullptr;
  std::size_t steps_ = 0;
  std::vector<int> pointLights_;           // their numbers in the scene
  std::vector<const Object3D*> enclosed_;  // for each point light; null where nothing encloses it
  std::vector<const Object3D*> behind_;
};
