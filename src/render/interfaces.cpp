// Interfaces: walks on from surface to surface until one changes the medium.
//
// For a hit that may depend on other objects, one line through the scene, beginning just before the
// hit, is asked for all its crossings (Media). What fills the line just before and just behind the
// hit are the two sides. Where both are the inside of one object, the surface is not there, and the
// walk goes on behind it with the same Media.
#include "render/interfaces.h"

#include <algorithm>

#include "render/media.h"
#include "render/transmittance.h"

namespace {

bool anyTransparent(const SceneParser& scene) {
  for (int i = 0; i < scene.getNumMaterials(); ++i) {
    if (scene.getMaterial(i)->isTransparent()) return true;
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
  interface = plainInterface(dot(hit.getNormal(), ray.getDirection()));
  if (!tracksMedia_ || !dependsOnMedia(hit)) return true;
  const double start = hit.getT() - reachOf(hit);
  Media media(solids_);
  geometry_->visitCrossings(Ray(ray.pointAtParameter(start), ray.getDirection()), media);
  media.finish();
  return walk(ray, tmax, media, start, hit, interface, passed);
}

/// The lines of all rays that depend on media are asked for their crossings together.
void Interfaces::examineAll(const BatchGeometry* batches, const RayTable& rays, HitTable& hits,
                            Interface* found, Arena& arena) const {
  const Arena::Frame frame(arena);
  RayTable lines(arena, rays.count, false);
  lines.count = 0;
  auto* rows = arena.take<std::uint16_t>(std::size_t(rays.count));
  struct MediaOfRows : RowCrossingVisitor {
    std::vector<Media> rows;
    void visit(int row, const Crossing& crossing) override {
      rows[std::size_t(row)].visit(crossing);
    }
  } media;
  const auto finish = [&](int row, Hit& hit, bool isThere) {
    rays.tmax[row] = hit.getT();
    hits.setRow(row, hit, isThere ? hits.order[row] : NearestSoFar::kNothing);
  };
  for (int row = 0; row < rays.count; ++row) {
    if (!hits.isFound(row)) continue;
    const Ray ray = rays.rayOf(row);
    Hit hit = hits.hitOf(row, rays.tmax[row]);
    if (!batches) {
      finish(row, hit, examine(ray, Hit().getT(), hit, found[row]));
      continue;
    }
    found[row] = plainInterface(dot(hit.getNormal(), ray.getDirection()));
    if (!dependsOnMedia(hit)) continue;
    lines.tmin[lines.count] = hit.getT() - reachOf(hit);  // where the line starts on the ray
    const Vec3d origin = ray.pointAtParameter(lines.tmin[lines.count]);
    for (int axis = 0; axis < 3; ++axis) {
      lines.origin[axis][lines.count] = origin[axis];
      lines.direction[axis][lines.count] = ray.getDirection()[axis];
    }
    rows[lines.count++] = std::uint16_t(row);
    media.rows.emplace_back(solids_);
  }
  if (lines.count == 0) return;
  batches->visitAllCrossings(lines, media, arena);
  for (int k = 0; k < lines.count; ++k) {
    const int row = rows[k];
    Hit hit = hits.hitOf(row, rays.tmax[row]);
    media.rows[std::size_t(k)].finish();
    finish(row, hit,
           walk(rays.rayOf(row), Hit().getT(), media.rows[std::size_t(k)], lines.tmin[k], hit,
                found[row], nullptr));
  }
}

/// Goes on from `hit`, which depends on the media along the ray, until a surface is there. Their
/// line begins at parameter `start`.
bool Interfaces::walk(const Ray& ray, double tmax, const Media& media, double start, Hit& hit,
                      Interface& interface, std::vector<Hit>* passed) const {
  while (dependsOnMedia(hit) && !isThere(media, start, hit, interface)) {
    if (passed) passed->push_back(hit);
    Hit next(tmax);
    const bool isFound = geometry_->intersect(ray, next, hit.getT());
    hit = next;
    if (!isFound) return false;
    interface = plainInterface(dot(hit.getNormal(), ray.getDirection()));
  }
  return true;
}

/// Whether `hit` asks for all that lies along the ray. What is far from all solids has air around.
bool Interfaces::dependsOnMedia(const Hit& hit) const {
  const RenderOptions& options = shader_->options();
  const bool isNested = options.nestedDielectrics && hit.getMaterial()->isTransparent();
  if (!options.fresnel && !isNested) return false;
  return !solids_ || !solids_->areBeyond(hit.getIntersectionPoint(), reachOf(hit));
}

/// Surfaces as near as this to a hit belong to it: secondary rays do not see them either.
double Interfaces::reachOf(const Hit& hit) const {
  return std::max(double(shader_->epsilonAt(hit.getMagnitude())),
                  hit.getMagnitude() * Shader::kRounding);
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
