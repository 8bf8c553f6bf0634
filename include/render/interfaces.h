// Interfaces: what a ray meets, and what lies on both sides of it.
//
// The assignment knows two media, air and the material of the surface. With `fresnel` and
// `nestedDielectrics` all closed transparent objects around the place count; a surface inside a
// medium of higher priority is then not there at all, and the ray goes on to the next one.
#pragma once
#include <vector>

#include "geometry/ray_table.h"
#include "render/shader.h"
#include "render/surface.h"

class Media;
struct ColorFilterTable;

class Interfaces {
 public:
  /// Those of a scene whose objects `geometry` answers for. Nothing is owned; `shader` says how
  /// near two surfaces count as one.
  Interfaces(const SceneParser& scene, const Object3D& geometry, const Shader& shader);

  /// Object3D::intersect, but finds only surfaces that are there, and stores in `interface` what
  /// lies on both sides; `index` is that of the medium that the ray travels in, where the Shader
  /// follows it. Surfaces that the ray went through before are appended to `passed`, where
  /// that is not null. Where nothing is found, `hit` is as it was.
  bool intersect(const Ray& ray, double tmin, float index, Hit& hit, Interface& interface,
                 std::vector<Hit>* passed = nullptr) const;
  /// The same for all rays of a table, whose tmax is infinite: in `hits` and rays.tmax is stored
  /// what they meet, in found[row] what lies on both sides of it. `batches` answers as the geometry
  /// does.
  void intersectAll(const BatchGeometry& batches, const RayTable& rays, HitTable& hits,
                    Interface* found, Arena& arena) const;

  /// True where every interface is plain: intersect would only call plainInterface.
  bool arePlain() const { return !tracksMedia_; }
  /// Index 1 on one side and the material's own on the other.
  /// `approach` is n.v, below 0 where the ray comes from outside.
  static const Interface& plainInterface(double approach) {
    static const Interface kEntered{{false, 1}, {true, 1}}, kLeft{{true, 1}, {false, 1}};
    return approach < 0 ? kEntered : kLeft;
  }

 private:
  struct Walk;

  bool dependsOnMedia(const Hit& hit) const;
  double reachOf(const Hit& hit) const;
  bool isThere(const Media& media, double start, const Hit& hit, int row, Interface& interface,
               ColorFilterTable& filters) const;

  const SolidObjects* solids_;  // not owned; null where nobody has listed them
  const Object3D* geometry_;    // not owned
  const Shader* shader_;        // not owned
  bool tracksMedia_;
};
