// Glasses: closed glass objects under a sky, for tests of the media along a ray.
#pragma once
#include <string>
#include <vector>

#include "ray_log.h"
#include "scene_text.h"

namespace glasses {

using scene_text::parse;
using scene_text::word;

/// A glass object: its index, its priority and what it is.
struct Glass {
  double index;
  int priority;
  std::string object;
};

inline std::string ball(const Vec3d& center, double radius) {
  return " Sphere { center" + word(center) + "radius" + word(radius) + "} ";
}

/// Clear glasses under a sky of (0.5, 0.25, 1), ready to be traced.
class Glasses {
 public:
  explicit Glasses(const std::vector<Glass>& list, const std::string& more = "", int countMore = 0)
      : scene_(parse(textOf(list, more, countMore))) {
    scene_.findSolids();
  }
  operator const SceneParser&() const { return scene_; }

  /// The eye ray from `origin` along `direction` and all that continue it.
  std::vector<Ray> path(const Vec3d& origin, const Vec3d& direction,
                        const RenderOptions& options) const {
    std::vector<Ray> rays;
    const RayLog log(*scene_.getGroup(), &rays);
    const RayTracer tracer(scene_, log, options);
    Ray ray(origin, normalize(direction));
    Hit hit;
    tracer.traceRay(ray, 0, 0, 1, 1, hit);
    return rays;
  }

 private:
  static std::string textOf(const std::vector<Glass>& list, const std::string& more,
                            int countMore) {
    std::string materials, objects;
    for (const Glass& glass : list) {
      materials += " Material { diffuseColor 0 0 0 transparentColor 1 1 1 indexOfRefraction" +
                   word(glass.index) + "priority " + std::to_string(glass.priority) + " } ";
    }
    for (std::size_t i = 0; i < list.size(); ++i) {
      objects += " MaterialIndex " + std::to_string(i) + " " + list[i].object;
    }
    const std::string count = std::to_string(list.size());
    return "Background { color 0.5 0.25 1 ambientLight 1 1 1 } Materials { numMaterials " +
           std::to_string(list.size() + 1) + materials +
           " Material { diffuseColor 0.125 0.25 0.75 } } Group { numObjects " +
           std::to_string(list.size() + std::size_t(countMore)) + objects + " MaterialIndex " +
           count + " " + more + " }";
  }

  SceneParser scene_;
};

/// No mirrors, so that a path is one chain.
inline RenderOptions nested(int maxBounces = 20) {
  RenderOptions options = scene_text::bouncing(maxBounces);
  options.minWeight = 0;
  options.nestedDielectrics = true;
  options.epsilon.kind = Epsilon::Kind::adaptive;
  return options;
}

/// The closed cube [-1, 1]^3, or with `inner` > 0 its shell around the hollow cube of half side

}  // namespace glasses
