// WaveTracer: one step of the recursion for all rays of a batch, then the next step.
//
//   trace    meet: what do the rays hit, and what lies on both sides of it?
//            each hit becomes a Surface; that of a solid texture one for each component
//            shade: the four terms, each for all surfaces
//              lights       a list of samples and shadow rays for one light, asked together
//              ambient
//              mirror       a list of the rays that continue; trace, one bounce deeper
//              transmitted  likewise
// The depth of this recursion is that of the tree of rays, and each level holds two lists at most:
// memory does not grow with the number of rays, 2^bounces.
#include "render/wave_tracer.h"

#include <algorithm>
#include <deque>

#include "shading/solid_texture.h"

namespace {

/// Fewer rays than this have too little in common.
constexpr std::size_t kFewRays = 4;
/// After this many bounces rays go one by one, so that memory does not grow with -bounces.
constexpr int kMostGenerations = 64;

bool isFound(const Hit& hit) { return hit.getT() < Hit().getT(); }

std::size_t missesAmong(const Hit* hits, std::size_t count) {
  return std::size_t(
      std::count_if(hits, hits + count, [](const Hit& hit) { return !isFound(hit); }));
}

}  // namespace

/// Rays that continue at the surfaces of a batch.
struct WaveTracer::Branches {
  RayKind kind;
  RayBatch rays;
  std::vector<std::size_t> surfaces;  // ray i continues surfaces[i]

  Branches(RayKind k, std::size_t capacity) : kind(k) {
    rays.reserve(capacity + 1);
    surfaces.reserve(capacity);
  }
  /// Keeps what ask(next) has made of a new ray, if it follows; its number is `surface`.
  template <class Ask>
  void add(std::size_t surface, RayCounts* counts, const Ask& ask) {
    const Outcome outcome = ask(rays.emplace_back());
    if (outcome == Outcome::follows) return surfaces.push_back(surface);
    if (counts && outcome != Outcome::none) counts->branchEnds(kind, outcome, rays.back().weight);
    rays.pop_back();
  }
};

/// What a batch of rays has met, as surfaces of plain materials: one for each hit, or one for each
/// component of a texture. As many as kBatchSize of them are shaded at once.
class WaveTracer::SurfaceBatch {
 public:
  /// For the colours of `count` rays. Nothing is owned.
  SurfaceBatch(const WaveTracer& tracer, std::size_t count, Vec3f* colors)
      : tracer_(tracer), count_(count), colors_(colors) {
    surfaces_.reserve(std::min(count, std::size_t(kBatchSize)));
    origins_.reserve(surfaces_.capacity());
  }

  /// Takes what ray number `ray` has met.
  void add(const Surface& s, std::size_t ray) {
    if (const SolidTexture* texture = s.hit.getMaterial()->asTexture()) {
      return addComponents(*texture, s, ray);
    }
    if (isFull()) flush();
    surfaces_.push_back(s);
    origins_.push_back({ray, 1, false});
  }

  /// Shades what has been taken, and stores the colours of its rays.
  void flush() {
    std::vector<Vec3f> colors(surfaces_.size());
    tracer_.shade(surfaces_, colors.data());
    for (std::size_t k = 0; k < colors.size(); ++k) addColor(origins_[k], colors[k]);
    surfaces_.clear();
    origins_.clear();
    componentHits_.clear();
  }

 private:
  /// Whose colour that of a surface belongs to, and its share there.
  struct Origin {
    std::size_t ray;
    double share;
    bool isComponent;  // of a texture
  };

  bool isFull() const { return surfaces_.size() == std::size_t(kBatchSize); }

  void addComponents(const SolidTexture& texture, const Surface& s, std::size_t ray) {
    sums_.resize(count_);
    for (const WeightedMaterial& each : texture.materialsAt(s.hit.getIntersectionPoint())) {
      if (isFull()) flush();
      componentHits_.push_back(s.hit.withMaterial(each.material));
      const float weight = s.weight * float(each.weight);
      surfaces_.push_back(
          {s.ray, componentHits_.back(), s.interface, s.bounces, weight, s.indexOfRefraction});
      origins_.push_back({ray, each.weight, true});
    }
  }

  void addColor(const Origin& origin, const Vec3f& color) {
    if (origin.isComponent) {
      Vec3d& sum = sums_[origin.ray];
      sum += origin.share * Vec3d(color);
      colors_[origin.ray] = Vec3f(sum);
    } else {
      colors_[origin.ray] = color;
    }
  }

  const WaveTracer& tracer_;
  const std::size_t count_;
  Vec3f* const colors_;
  std::vector<Surface> surfaces_;
  std::vector<Origin> origins_;  // as long
  std::deque<Hit> componentHits_;
  std::vector<Vec3d> sums_;  // of the rays' components; empty where there are none
};

WaveTracer::WaveTracer(const RayTracer& tracer, RayCounts* counts)
    : tracer_(tracer),
      batches_(dynamic_cast<const BatchGeometry*>(&tracer.geometry())),
      counts_(counts) {}

void WaveTracer::trace(const RayBatch& batch, int bounces, Hit* hits, Vec3f* colors) const {
  if (batch.size() < kFewRays || bounces >= kMostGenerations) {
    return traceOneByOne(batch, bounces, hits, colors);
  }
  if (counts_ && bounces == 0) counts_->addRays(RayKind::eye, 0, batch.size());
  const std::vector<Interface> interfaces = meet(batch, hits);
  SurfaceBatch surfaces(*this, batch.size(), colors);
  for (std::size_t i = 0; i < batch.size(); ++i) {
    if (!isFound(hits[i])) {
      colors[i] = tracer_.scene().getBackgroundColor();
      continue;
    }
    const TracedRay& ray = batch[i];
    const Interface& interface =
        interfaces.empty() ? Interfaces::plainInterface(ray.ray, hits[i]) : interfaces[i];
    surfaces.add({ray.ray, hits[i], interface, bounces, ray.weight, ray.indexOfRefraction}, i);
  }
  surfaces.flush();
}

void WaveTracer::traceOneByOne(const RayBatch& batch, int bounces, Hit* hits, Vec3f* colors) const {
  for (std::size_t i = 0; i < batch.size(); ++i) {
    Ray ray = batch[i].ray;
    colors[i] = tracer_.traceRay(ray, float(batch[i].tmin), bounces, batch[i].weight,
                                 batch[i].indexOfRefraction, hits[i]);
  }
}

void WaveTracer::intersect(const RayBatch& eyeRays, Hit* hits) const {
  if (counts_) counts_->addRays(RayKind::eye, 0, eyeRays.size());
  meet(eyeRays, hits);
}

/// Finds what the rays meet, and what lies on both sides of it; none where all of that is plain.
std::vector<Interface> WaveTracer::meet(const RayBatch& batch, Hit* hits) const {
  if (batches_) {
    // No more than there are: most batches are small, and an array would be cleared first.
    std::vector<Ray> rays;
    std::vector<double> tmins;
    rays.reserve(batch.size());
    tmins.reserve(batch.size());
    for (const TracedRay& traced : batch) {
      rays.push_back(traced.ray);
      tmins.push_back(traced.tmin);
    }
    batches_->intersectBatch(rays.data(), tmins.data(), int(rays.size()), hits);
  } else {
    for (std::size_t i = 0; i < batch.size(); ++i) {
      tracer_.geometry().intersect(batch[i].ray, hits[i], batch[i].tmin);
    }
  }
  const Interfaces& interfaces = tracer_.interfaces();
  std::vector<Interface> found(interfaces.arePlain() ? 0 : batch.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    if (isFound(hits[i])) interfaces.examine(batch[i].ray, Hit().getT(), hits[i], found[i]);
  }
  if (counts_) counts_->addMisses(missesAmong(hits, batch.size()));
  return found;
}

/// RayTracer::shade for many surfaces, none of a texture. Every sum grows in the same order: the
/// ambient term may follow the lights, as a + l is l + a to the last bit.
void WaveTracer::shade(const std::vector<Surface>& surfaces, Vec3f* colors) const {
  if (surfaces.empty()) return;
  const Shader& shader = tracer_.shader();
  const int bounces = surfaces[0].bounces;
  std::vector<Vec3d> sums(surfaces.size());
  for (int light = 0; light < tracer_.scene().getNumLights(); ++light) {
    addLight(light, surfaces, sums);
  }
  Branches mirrored(RayKind::mirror, surfaces.size());
  Branches refracted(RayKind::refracted, surfaces.size());
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    const Surface& s = surfaces[i];
    sums[i] += shader.ambient(s);
    mirrored.add(i, counts_, [&](TracedRay& next) { return shader.mirrored(s, next); });
    refracted.add(i, counts_, [&](TracedRay& next) { return shader.refracted(s, next); });
  }
  addBranches(mirrored, bounces, sums);
  addBranches(refracted, bounces, sums);
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    colors[i] = Vec3f(sums[i] * Vec3d(surfaces[i].interface.tint));
  }
}

/// Adds to each sum what light `index` brings there.
void WaveTracer::addLight(int index, const std::vector<Surface>& surfaces,
                          std::vector<Vec3d>& sums) const {
  const Shader& shader = tracer_.shader();
  std::vector<LightSample> samples;  // of the surfaces that are turned towards the light
  std::vector<std::size_t> places;   // which surfaces these are
  samples.reserve(surfaces.size() + 1);
  places.reserve(surfaces.size());
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    LightSample& light = samples.emplace_back();
    shader.sampleLight(index, surfaces[i], light);
    light.isInFront ? places.push_back(i) : samples.pop_back();
  }
  std::vector<Vec3f> visible(places.size());
  findVisible(surfaces, places, samples, visible.data());
  for (std::size_t k = 0; k < places.size(); ++k) {
    sums[places[k]] += shader.reflected(surfaces[places[k]], samples[k], visible[k]);
  }
}

/// RayTracer::visibility for sample k at surfaces[places[k]], for all k. What blocks or lets
/// through is found together; what tints is asked ray by ray.
void WaveTracer::findVisible(const std::vector<Surface>& surfaces,
                             const std::vector<std::size_t>& places,
                             const std::vector<LightSample>& samples, Vec3f* visible) const {
  const Shader& shader = tracer_.shader();
  const RenderOptions& options = shader.options();
  if (options.shadows && !options.transparentShadows && batches_) {
    std::vector<ShadowQuery> queries(places.size());
    for (std::size_t k = 0; k < places.size(); ++k) {
      shader.setShadowQuery(surfaces[places[k]], samples[k], queries[k]);
    }
    bool blocked[kBatchSize];
    batches_->occludedBatch(queries.data(), int(queries.size()), blocked);
    for (std::size_t k = 0; k < places.size(); ++k) {
      visible[k] = blocked[k] ? Vec3f() : Vec3f(1, 1, 1);
    }
  } else {
    for (std::size_t k = 0; k < places.size(); ++k) {
      visible[k] = tracer_.visibility(surfaces[places[k]], samples[k]);
    }
  }
  if (!counts_ || !options.shadows) return;
  const auto blocked = std::count(visible, visible + places.size(), Vec3f());
  counts_->addShadowRays(places.size(), std::size_t(blocked));
}

/// Adds to each sum what the ray brings that continues there, if any.
void WaveTracer::addBranches(const Branches& branches, int bounces,
                             std::vector<Vec3d>& sums) const {
  const RayBatch& rays = branches.rays;
  if (counts_) counts_->addRays(branches.kind, bounces + 1, rays.size());
  std::vector<Hit> hits(rays.size());
  std::vector<Vec3f> colors(rays.size());
  trace(rays, bounces + 1, hits.data(), colors.data());
  for (std::size_t k = 0; k < rays.size(); ++k) {
    sums[branches.surfaces[k]] += Vec3d(rays[k].factor) * Vec3d(colors[k]);
  }
}
