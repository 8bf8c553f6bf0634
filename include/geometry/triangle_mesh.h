// TriangleMesh: triangles of one material. A hit says which face it is of; its normal and texture
// place are what the geometry's MeshShading makes them.
#pragma once
#include "geometry/mesh_geometry.h"
#include "geometry/object3d.h"

class TriangleMesh : public Object3D {
 public:
  /// Neither the geometry nor the material is owned; several meshes may share a geometry.
  TriangleMesh(const MeshGeometry* geometry, const Material* material)
      : geometry_(geometry), material_(material) {}

  const MeshGeometry& getGeometry() const { return *geometry_; }
  const Material* getMaterial() const { return material_; }

  /// Finds the t at which the ray meets one face, if tmin < t < tmax and the ray does not start on
  /// that face. Where the result is false, `t` is anything.
  bool nearestRoot(std::uint32_t face, const Ray& ray, double tmin, double tmax, double& t) const;
  /// Records in `hit` what lies at parameter t of the ray, which nearestRoot gave for that face.
  void setHit(std::uint32_t face, const Ray& ray, double t, Hit& hit) const;
  /// Reports the crossing with one face, if there is one at t > 0.
  void visitFace(std::uint32_t face, const Ray& ray, CrossingVisitor& visitor) const;

  bool intersect(const Ray& ray, Hit& hit, double tmin) const override;
  bool occluded(const Ray& ray, double tmin, double tmax) const override;
  void visitCrossings(const Ray& ray, CrossingVisitor& visitor) const override;
  void addBounds(const Matrix& toWorld, BoundingBox& box) const override {
    geometry_->addBounds(toWorld, box);
  }
  bool isBounded() const override { return true; }
  bool hasTextureCoordinates() const override {
    return !geometry_->getShading().coordinates.empty();
  }

 private:
  const MeshGeometry* geometry_;  // not owned
  const Material* material_;      // not owned
};
