// Interfaces: walks on from surface to surface until one changes the medium.
//
// For a hit that may depend on other objects, one line through the scene, beginning just before the
// hit, is asked for all its crossings (Media). What fills the line just before and just behind the
// hit are the two sides. Where both are the inside of one object, the surface is not there, and the
// ray is asked again for what lies behind it; its line stays the same.
// Rays of a table take each of these steps together; a single ray is a table of one.
#include "render/interfaces.h"

#include <algorithm>
#include <tuple>

#include "render/media.h"
#include "render/transmittance.h"
#include "render/wave_kernels.h"

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

/// The product, in an order that does not depend on the order of visits.
Vec3f productOf(std::vector<Vec3f>& tints) {
  std::sort(tints.begin(), tints.end(), [](const Vec3f& a, const Vec3f& b) {
    return std::make_tuple(a.r(), a.g(), a.b()) < std::make_tuple(b.r(), b.g(), b.b());
  });
  Vec3f product(1, 1, 1);
  for (const Vec3f& tint : tints) product *= tint;
  return product;
}

}  // namespace

Interfaces::Interfaces(const SceneParser& scene, const Object3D& geometry, const Shader& shader)
    : solids_(scene.getSolids()),
      geometry_(&geometry),
      shader_(&shader),
      tracksMedia_((shader.options().fresnel || shader.options().nestedDielectrics) &&
                   anyTransparent(scene)) {}

/// The rays of a table on their way. Nothing is owned.
struct Interfaces::Walk {
  const Interfaces& interfaces;
  const BatchGeometry& batches;
  const RayTable& rays;
  HitTable& hits;
  Interface* found;
  Arena& arena;
  double tmax;               // of all rays
  std::vector<Hit>* passed;  // surfaces that were not there; may be null

  // The line of ray rows[k] is row k; its tmin tells where on the ray it starts.
  RayTable lines{arena, rays.count, false};
  std::uint16_t* rows = arena.take<std::uint16_t>(std::size_t(rays.count));
  // The lines on which no surface has been found yet that is there.
  std::uint16_t* open = arena.take<std::uint16_t>(std::size_t(rays.count));
  int openCount = 0;

  void run() {
    batches.intersectAll(rays, hits, arena);
    lines.count = 0;
    for (int row = 0; row < rays.count; ++row) {
      if (hits.isFound(row) && dependsOnMedia(row)) addLine(row);
    }
    // Objects count that reach as far as the places on both sides of the hit. Where the surface is
    // not there, all may count, as long as the ray goes on.
    for (const bool isWhole : {false, true}) {
      if (isWhole) keepOpenLines();
      if (lines.count == 0) return;
      CrossingTable crossings(lines.count);
      batches.visitAllCrossings(lines, crossings, arena);
      ColorFilterTable filters(arena, crossings.size());
      openCount = lines.count;
      do {
        keepHidden(crossings, filters);
        goOn();
      } while (isWhole && openCount > 0);
      setTints(filters);
    }
  }

  Hit hitOf(int row) const { return hits.hitOf(row, rays.tmax[row]); }

  /// Whether more than the surface's own medium counts at what ray `row` has met; at first that
  /// alone is stored.
  bool dependsOnMedia(int row) {
    const Hit hit = hitOf(row);
    found[row] = plainInterface(dot(hit.getNormal(), rays.directionOf(row)));
    return interfaces.dependsOnMedia(hit);
  }
  void addLine(int row) {
    const Hit hit = hitOf(row);
    const Ray ray = rays.rayOf(row);
    const double reach = interfaces.reachOf(hit), start = hit.getT() - reach;
    lines.setRow(lines.count, Ray(ray.pointAtParameter(start), ray.getDirection()), start,
                 4 * reach);
    open[lines.count] = std::uint16_t(lines.count);
    rows[lines.count++] = std::uint16_t(row);
  }

  /// Leaves the open lines alone in lines, for all that lies on them.
  void keepOpenLines() {
    for (int k = 0; k < openCount; ++k) {
      const int line = open[k];
      lines.setRow(k, lines.rayOf(line), lines.tmin[line], Hit().getT());
      rows[k] = rows[line];
      open[k] = std::uint16_t(k);
    }
    lines.count = openCount;
  }

  /// Finds what lies on both sides of what the open lines have met; those stay open on which it is
  /// not there.
  void keepHidden(const CrossingTable& crossings, ColorFilterTable& filters) {
    int count = 0;
    Media media(interfaces.solids_);
    for (int k = 0; k < openCount; ++k) {
      const int line = open[k], row = rows[line];
      media.begin();
      crossings.tell(line, media);
      media.finish();
      if (interfaces.isThere(media, lines.tmin[line], hitOf(row), row, found[row], filters))
        continue;
      open[count++] = std::uint16_t(line);
      if (passed) passed->push_back(hitOf(row));
    }
    openCount = count;
  }

  /// Finds what the rays of open lines meet next; those stay open where that depends on media.
  void goOn() {
    const Arena::Frame frame(arena);
    RayTable next(arena, openCount, rays.source != nullptr);
    HitTable nextHits(arena, openCount);
    for (int k = 0; k < openCount; ++k) {
      const int row = rows[open[k]];
      next.setRow(k, rays.rayOf(row), rays.tmax[row], tmax);
    }
    batches.intersectAll(next, nextHits, arena);
    int count = 0;
    for (int k = 0; k < openCount; ++k) {
      const int row = rows[open[k]];
      rays.tmax[row] = next.tmax[k];
      hits.setRow(row, nextHits.hitOf(k, next.tmax[k]), nextHits.order[k]);
      if (hits.isFound(row) && dependsOnMedia(row)) open[count++] = open[k];
    }
    openCount = count;
  }

  void setTints(const ColorFilterTable& filters) {
    waveKernels(batches.simdLevel()).absorb(filters);
    std::vector<Vec3f> tints;
    for (int k = 0; k < filters.count;) {
      const int row = filters.row[k];
      tints.clear();
      for (; k < filters.count && filters.row[k] == row; ++k) {
        tints.emplace_back(rowOf(filters.color, k));
      }
      found[row].tint = productOf(tints);
    }
  }
};

bool Interfaces::intersect(const Ray& ray, double tmin, float index, Hit& hit, Interface& interface,
                           std::vector<Hit>* passed) const {
  if (!tracksMedia_) {
    if (!geometry_->intersect(ray, hit, tmin)) return false;
    interface = plainInterface(dot(hit.getNormal(), ray.getDirection()));
    if (shader_->followsIndex()) interface.before = {false, index};
    return true;
  }
  Arena arena;
  RayTable rays(arena, 1, true);
  rays.setRow(0, ray, tmin, hit.getT());
  HitTable hits(arena, 1);
  Walk{*this, BatchGeometry(*geometry_), rays, hits, &interface, arena, hit.getT(), passed}.run();
  if (!hits.isFound(0)) return false;
  hit = hits.hitOf(0, rays.tmax[0]);
  return true;
}

void Interfaces::intersectAll(const BatchGeometry& batches, const RayTable& rays, HitTable& hits,
                              Interface* found, Arena& arena) const {
  const Arena::Frame frame(arena);
  Walk{*this, batches, rays, hits, found, arena, Hit().getT(), nullptr}.run();
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
                  hit.getMagnitude() * Shader::kAdaptiveEpsilon);
}

/// Fills in `interface`, but for its tint, from the media along ray `row`, whose parameter is
/// `start` where `media` begins; the filters that make the tint are added. False where the surface
/// hit changes nothing: the medium before and behind is the same.
bool Interfaces::isThere(const Media& media, double start, const Hit& hit, int row,
                         Interface& interface, ColorFilterTable& filters) const {
  const RenderOptions& options = shader_->options();
  const double t = hit.getT() - start, reach = reachOf(hit);
  const double length = std::max(hit.getT(), 0.0);  // of the way here
  interface.isClosed = media.isClosed(hit.getObject());
  if (!options.nestedDielectrics) {
    media.addFilters(t - reach, hit.getIntersectionPoint(), length, row, filters);
    return true;
  }
  const Media::Medium before = media.mediumAt(t - reach), behind = media.mediumAt(t + reach);
  if (interface.isClosed) {
    if (before.object == behind.object) return false;
    interface.before = sideOf(before, hit);
    interface.behind = sideOf(behind, hit);
  }
  if (options.fresnel && before.material) {
    filters.add({transparencyAt(*before.material, hit.getIntersectionPoint()), length}, row);
  }
  return true;
}
