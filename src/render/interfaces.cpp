// Interfaces: walks on from surface to surface until one changes the medium.
//
// For a hit that may depend on other objects, one line through the scene, beginning just before the
// hit, is asked for all its crossings (Media). What fills the line just before and just behind the
// hit are the two sides. Where both are the inside of one object, the surface is not there, and the
// walk goes on behind it with the same Media.
#include "render/interfaces.h"

#include <algorithm>
#include <optional>

#include "render/media.h"
#include "render/transmittance.h"

namespace {

bool isTransparent(const Material& material) { return anyPositive(material.getTransparentColor()); }

bool anyTransparent(const SceneParser& scene) {
  for (int i = 0; i < scene.getNumMaterials(); ++i) {
    if (isTransparent(*scene.getMaterial(i))) return true;
  }
  return false;
}

Interface::Side sideOf(const Media::Medium& medium, const Hit& hit) {
  return {medium.object == hit.getObject(), medium.indexAt(hit.getIntersectionPoint())};
}

}  // namespace

Interfaces::Interfaces(const SceneParser& scene, const Object3D& geometry, const Shader& shader)
    : solids_(scene.getSolids()),
      geometry_(&geometry),
      shader_(&shader),
      tracksMedia_((shader.options().fresnel || shader.options().nestedDielectrics) &&
                   anyTransparent(scene)) {}

bool Interfaces::intersect(const Ray& ray, double tmin, Hit& hit, Interface& interface,
                           std::vector<Hit>* passed) const {
  const double tmax = hit.getT();
  return geometry_->intersect(ray, hit, tmin) && examine(ray, tmax, hit, interface, passed);
}

bool Interfaces::examine(const Ray& ray, double tmax, Hit& hit, Interface& interface,
                         std::vector<Hit>* passed) const {
  std::optional<Media> media;  // along the line that begins just before the first hit, at `start`
  double start = 0;
  for (;;) {
    interface = plainInterface(ray, hit);
    if (!tracksMedia_ || !dependsOnMedia(hit)) return true;
    if (!media) {
      start = hit.getT() - reachOf(hit);
      media.emplace(*geometry_, solids_, Ray(ray.pointAtParameter(start), ray.getDirection()));
    }
    if (isThere(*media, start, hit, interface)) return true;
    if (passed) passed->push_back(hit);
    Hit next(tmax);
    const bool isFound = geometry_->intersect(ray, next, hit.getT());
    hit = next;
    if (!isFound) return false;
  }
}

/// Whether `hit` asks for all that lies along the ray. What is far from all solids has air around.
bool Interfaces::dependsOnMedia(const Hit& hit) const {
  const RenderOptions& options = shader_->options();
  const bool isNested = options.nestedDielectrics && isTransparent(*hit.getMaterial());
  if (!options.fresnel && !isNested) return false;
  return !solids_ || !solids_->areBeyond(hit.getIntersectionPoint(), reachOf(hit));
}

/// Surfaces as near as this to a hit belong to it: secondary rays do not see them either.
double Interfaces::reachOf(const Hit& hit) const {
  return std::max(double(shader_->epsilonAt(hit)), hit.getMagnitude() * Shader::kRounding);
}

/// Fills in `interface` from the media along the ray, whose parameter is `start` where `media`
/// begins. False where the surface hit changes nothing: the medium before and behind is the same.
bool Interfaces::isThere(const Media& media, double start, const Hit& hit,
                         Interface& interface) const {
  const RenderOptions& options = shader_->options();
  const double t = hit.getT() - start, reach = reachOf(hit);
  const double length = std::max(hit.getT(), 0.0);  // of the way here
  interface.isClosed = media.isClosed(hit.getObject());
  if (!options.nestedDielectrics) {
    interface.tint = media.tintOfAll(t - reach, hit.getIntersectionPoint(), length);
    return true;
  }
  const Media::Medium before = media.mediumAt(t - reach), behind = media.mediumAt(t + reach);
  if (options.fresnel && before.material) {
    const Vec3f color = transparencyAt(*before.material, hit.getIntersectionPoint());
    interface.tint = absorption(color, length);
  }
  if (!interface.isClosed) return true;
  interface.before = sideOf(before, hit);
  interface.behind = sideOf(behind, hit);
  return before.object != behind.object;
}
