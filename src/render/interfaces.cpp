// Interfaces: walks on from surface to surface until one changes the medium.
//
// For a hit that may depend on other objects, one line through the scene, beginning just before the
// hit, is asked for all its crossings (Media). What fills the line just before and just behind the
// hit are the two sides. Where both are the inside of one object, the surface is not there, and the
// ray is asked again for what lies behind it; its line stays the same.
// Rays of a table take each of these steps together.
#include "render/interfaces.h"

#include <algorithm>
#include <optional>
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

double approachOf(const Ray& ray, const Hit& hit) {
  return dot(hit.getNormal(), ray.getDirection());
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

bool Interfaces::intersect(const Ray& ray, double tmin, Hit& hit, Interface& interface,
                           std::vector<Hit>* passed) const {
  const double tmax = hit.getT();
  std::optional<Media> media;
  double start = 0;  // of the line, on the ray
  for (; geometry_->intersect(ray, hit, tmin); hit = Hit(tmax)) {
    interface = plainInterface(approachOf(ray, hit));
    if (!tracksMedia_ || !dependsOnMedia(hit)) return true;
    if (!media) {
      media.emplace(solids_);
      start = hit.getT() - reachOf(hit);
      geometry_->visitCrossings(Ray(ray.pointAtParameter(start), ray.getDirection()), *media);
      media->finish();
    }
    std::vector<ColorFilter> filters;
    if (isThere(*media, start, hit, interface, filters)) {
      std::vector<Vec3f> tints;
      for (const ColorFilter& filter : filters) tints.push_back(filter.tint());
      interface.tint = productOf(tints);
      return true;
    }
    if (passed) passed->push_back(hit);
    tmin = hit.getT();
  }
  return false;
}

/// The rays of a table on their way: line `k` belongs to ray rows_[k].
class Interfaces::Walk {
 public:
  Walk(const Interfaces& interfaces, const BatchGeometry& batches, const RayTable& rays,
       HitTable& hits, Interface* found, Arena& arena)
      : interfaces_(interfaces),
        batches_(batches),
        rays_(rays),
        hits_(hits),
        found_(found),
        arena_(arena),
        lines_(arena, rays.count, false),
        rows_(arena.take<std::uint16_t>(std::size_t(rays.count))),
        open_(arena.take<std::uint16_t>(std::size_t(rays.count))),
        media_(interfaces.solids_) {
    lines_.count = 0;
  }

  void run() {
    for (int row = 0; row < rays_.count; ++row) {
      if (hits_.isFound(row) && dependsOnMedia(row)) addLine(row);
    }
    // Objects count that reach as far as the places on both sides of the hit. Where the surface is
    // not there, all may count.
    for (const bool isWhole : {false, true}) {
      if (isWhole) keepOpenLines();
      if (lines_.count == 0) return;
      CrossingTable crossings(lines_.count);
      batches_.visitAllCrossings(lines_, crossings, arena_);
      ColorFilterTable filters(arena_, crossings.size());
      openCount_ = lines_.count;
      do {
        keepHidden(crossings, filters);
        goOn();
      } while (isWhole && openCount_ > 0);
      setTints(filters);
    }
  }

 private:
  Hit hitOf(int row) const { return hits_.hitOf(row, rays_.tmax[row]); }

  /// Whether more than the surface's own medium counts at what ray `row` has met; at first that
  /// alone is stored.
  bool dependsOnMedia(int row) {
    const Hit hit = hitOf(row);
    found_[row] = plainInterface(dot(hit.getNormal(), rays_.directionOf(row)));
    return interfaces_.dependsOnMedia(hit);
  }
  /// The line of ray `row` stands in lines_; its tmin tells where on the ray it starts.
  void addLine(int row) {
    const Hit hit = hitOf(row);
    const Ray ray = rays_.rayOf(row);
    const double reach = interfaces_.reachOf(hit), start = hit.getT() - reach;
    lines_.setRow(lines_.count, Ray(ray.pointAtParameter(start), ray.getDirection()), start,
                  4 * reach);
    open_[lines_.count] = std::uint16_t(lines_.count);
    rows_[lines_.count++] = std::uint16_t(row);
  }

  /// Leaves the open lines alone in lines_, for all that lies on them.
  void keepOpenLines() {
    for (int k = 0; k < openCount_; ++k) {
      const int line = open_[k];
      lines_.setRow(k, lines_.rayOf(line), lines_.tmin[line], Hit().getT());
      rows_[k] = rows_[line];
      open_[k] = std::uint16_t(k);
    }
    lines_.count = openCount_;
  }

  /// Finds what lies on both sides of what the open lines have met; those stay open on which it is
  /// not there.
  void keepHidden(const CrossingTable& crossings, ColorFilterTable& filters) {
    int count = 0;
    for (int k = 0; k < openCount_; ++k) {
      const int line = open_[k], row = rows_[line];
      media_.begin();
      crossings.tell(line, media_);
      media_.finish();
      ofOne_.clear();
      if (!interfaces_.isThere(media_, lines_.tmin[line], hitOf(row), found_[row], ofOne_)) {
        open_[count++] = std::uint16_t(line);
      } else {
        for (const ColorFilter& filter : ofOne_) filters.add(filter, row);
      }
    }
    openCount_ = count;
  }

  /// Finds what the rays of open lines meet next; those stay open where that depends on media.
  void goOn() {
    const Arena::Frame frame(arena_);
    RayTable next(arena_, openCount_, rays_.source != nullptr);
    HitTable hits(arena_, openCount_);
    for (int k = 0; k < openCount_; ++k) {
      const int row = rows_[open_[k]];
      next.setRow(k, rays_.rayOf(row), rays_.tmax[row], Hit().getT());
    }
    batches_.intersectAll(next, hits, arena_);
    int count = 0;
    for (int k = 0; k < openCount_; ++k) {
      const int row = rows_[open_[k]];
      rays_.tmax[row] = next.tmax[k];
      hits_.setRow(row, hits.hitOf(k, next.tmax[k]), hits.order[k]);
      if (hits_.isFound(row) && dependsOnMedia(row)) open_[count++] = open_[k];
    }
    openCount_ = count;
  }

  void setTints(const ColorFilterTable& filters) {
    waveKernels(batches_.simdLevel()).absorb(filters);
    for (int k = 0; k < filters.count;) {
      const int row = filters.row[k];
      std::vector<Vec3f> tints;
      for (; k < filters.count && filters.row[k] == row; ++k) {
        tints.emplace_back(rowOf(filters.color, k));
      }
      found_[row].tint = productOf(tints);
    }
  }

  const Interfaces& interfaces_;
  const BatchGeometry& batches_;
  const RayTable& rays_;
  HitTable& hits_;
  Interface* const found_;
  Arena& arena_;
  RayTable lines_;
  std::uint16_t *const rows_, *const open_;
  int openCount_ = 0;
  Media media_;                     // of one line after the other
  std::vector<ColorFilter> ofOne_;  // likewise
};

void Interfaces::intersectAll(const BatchGeometry& batches, const RayTable& rays, HitTable& hits,
                              Interface* found, Arena& arena) const {
  batches.intersectAll(rays, hits, arena);
  const Arena::Frame frame(arena);
  Walk(*this, batches, rays, hits, found, arena).run();
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

/// Fills in `interface`, but for its tint, from the media along the ray, whose parameter is `start`
/// where `media` begins; the filters that make the tint are appended. False where the surface hit
/// changes nothing: the medium before and behind is the same.
bool Interfaces::isThere(const Media& media, double start, const Hit& hit, Interface& interface,
                         std::vector<ColorFilter>& filters) const {
  const RenderOptions& options = shader_->options();
  const double t = hit.getT() - start, reach = reachOf(hit);
  const double length = std::max(hit.getT(), 0.0);  // of the way here
  interface.isClosed = media.isClosed(hit.getObject());
  if (!options.nestedDielectrics) {
    media.addFilters(t - reach, hit.getIntersectionPoint(), length, filters);
    return true;
  }
  const Media::Medium before = media.mediumAt(t - reach), behind = media.mediumAt(t + reach);
  if (options.fresnel && before.material) {
    filters.push_back({transparencyAt(*before.material, hit.getIntersectionPoint()), length});
  }
  if (!interface.isClosed) return true;
  interface.before = sideOf(before, hit);
  interface.behind = sideOf(behind, hit);
  return before.object != behind.object;
}
