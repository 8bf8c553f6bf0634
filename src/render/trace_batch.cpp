// RayTracer::traceBatch: the same recursion for many rays at once, each generation in batches.
#include <algorithm>
#include <vector>

#include "render/ray_tracer.h"
#include "shading/solid_texture.h"

namespace {

void intersectTogether(const Object3D& geometry, const RayBatch& batch, Hit* hits) {
  if (const auto* batches = dynamic_cast<const BatchGeometry*>(&geometry)) {
    return batches->intersectBatch(batch.rays.data(), batch.tmins.data(), batch.size(), hits);
  }
  for (std::size_t i = 0; i < batch.rays.size(); ++i) {
    geometry.intersect(batch.rays[i], hits[i], batch.tmins[i]);
  }
}

void occludedTogether(const Object3D& geometry, const std::vector<ShadowQuery>& ways, int count,
                      bool* blocked) {
  if (const auto* batches = dynamic_cast<const BatchGeometry*>(&geometry)) {
    return batches->occludedBatch(ways.data(), count, blocked);
  }
  for (std::size_t i = 0; i < std::size_t(count); ++i) {
    blocked[i] = geometry.occluded(ways[i].ray, ways[i].tmin, ways[i].tmax);
  }
}

/// Fewer rays than this are traced one by one.
constexpr int kFewRays = 4;
/// After this many bounces rays go one by one, so that memory does not grow with -bounces.
constexpr int kMostGenerations = 64;

bool isFound(const Hit& hit) { return hit.getT() < Hit().getT(); }

bool isTextured(const Hit& hit) { return isFound(hit) && hit.getMaterial()->asTexture(); }

/// What lies on both sides of hit i; `passages` is empty where all of them are plain.
Passage passageAt(const std::vector<Passage>& passages, const std::vector<Ray>& rays,
                  const Hit* hits, std::size_t i) {
  if (!passages.empty()) return passages[i];
  return plainPassage(dot(hits[i].getNormal(), rays[i].getDirection()) < 0);
}

}  // namespace

/// The rays that continue those of a batch.
class RayTracer::Continued {
 public:
  explicit Continued(int capacity) : batch_(capacity + 1) {
    places_.reserve(std::size_t(capacity));
    addDraft();
  }

  /// A ray that does not count until it is kept.
  Ray& draft() { return batch_.rays.back(); }
  RayShare& draftShare() { return batch_.shares.back(); }
  /// Takes the draft as the ray that continues ray number `place`.
  void keep(double tmin, std::size_t place) {
    batch_.tmins.push_back(tmin);
    places_.push_back(place);
    addDraft();
  }

  /// All that were kept. Afterwards there is no draft any more.
  const RayBatch& finish() {
    batch_.rays.resize(places_.size());
    batch_.shares.resize(places_.size());
    return batch_;
  }
  /// Which rays they continue.
  const std::vector<std::size_t>& places() const { return places_; }

 private:
  void addDraft() {
    batch_.rays.emplace_back();
    batch_.shares.emplace_back();
  }

  RayBatch batch_;
  std::vector<std::size_t> places_;
};

/// Shades hits of which some are of textures: the parts of all of them together, a batch at a time.
class RayTracer::PartBatch {
 public:
  PartBatch(const RayTracer& tracer, int bounces, int count)
      : tracer_(tracer), bounces_(bounces), sums_(std::size_t(count)), batch_(count) {}

  /// Takes what ray number `place` of `batch` hit, if anything.
  void add(const RayBatch& batch, int place, const Hit& hit, const Passage& passage) {
    if (!isTextured(hit)) return addPart(batch, hit, passage, {place, 1});
    const SolidTexture& texture = *hit.getMaterial()->asTexture();
    for (const WeightedMaterial& part : texture.partsAt(hit.getIntersectionPoint())) {
      addPart(batch, hit.withMaterial(part.material), passage, {place, part.weight});
    }
  }

  /// Stores the colours of all rays.
  void finish(Vec3f* colors) {
    shadeParts();
    for (const Vec3d& sum : sums_) *colors++ = Vec3f(sum);
  }

 private:
  struct Part {
    int place;
    double weight;
  };

  void addPart(const RayBatch& batch, const Hit& hit, const Passage& passage, const Part& part) {
    if (parts_.size() == kBatchSize) shadeParts();
    const auto place = std::size_t(part.place);
    RayShare share = batch.shares[place];
    share.weight *= float(part.weight);
    batch_.add(batch.rays[place], batch.tmins[place], share);
    hits_.push_back(hit);
    passages_.push_back(passage);
    parts_.push_back(part);
  }

  void shadeParts() {
    std::vector<Vec3f> colors(parts_.size());
    tracer_.shadeBatch(batch_, hits_.data(), passages_, bounces_, colors.data());
    for (std::size_t k = 0; k < parts_.size(); ++k) {
      sums_[std::size_t(parts_[k].place)] += parts_[k].weight * Vec3d(colors[k]);
    }
    batch_.clear();
    hits_.clear();
    passages_.clear();
    parts_.clear();
  }

  const RayTracer& tracer_;
  int bounces_;
  std::vector<Vec3d> sums_;
  RayBatch batch_;
  std::vector<Hit> hits_;
  std::vector<Passage> passages_;
  std::vector<Part> parts_;  // whose they are
};

void RayTracer::traceBatch(const RayBatch& batch, int bounces, Hit* hits, Vec3f* colors) const {
  const int count = batch.size();
  if (count < kFewRays || bounces >= kMostGenerations) {
    for (int i = 0; i < count; ++i) {
      const RayShare& share = batch.shares[std::size_t(i)];
      Ray ray = batch.rays[std::size_t(i)];
      colors[i] = traceRay(ray, float(batch.tmins[std::size_t(i)]), bounces, share.weight,
                           share.indexOfRefraction, hits[i]);
    }
    return;
  }
  if (bounces == 0) reportEyeRays(batch);
  const std::vector<Passage> passages = findBatch(batch, hits);
  if (!hasTextures_ || std::none_of(hits, hits + count, isTextured)) {
    shadeBatch(batch, hits, passages, bounces, colors);
  } else {
    PartBatch parts(*this, bounces, count);
    for (int i = 0; i < count; ++i) {
      parts.add(batch, i, hits[i], passageAt(passages, batch.rays, hits, std::size_t(i)));
    }
    parts.finish(colors);
  }
  for (int i = 0; observer_ && i < count; ++i) observer_->rayEnds(colors[i]);
}

/// The second half of traceBatch, where no hit is of a texture.
void RayTracer::shadeBatch(const RayBatch& batch, const Hit* hits,
                           const std::vector<Passage>& passages, int bounces, Vec3f* colors) const {
  const int count = batch.size();
  std::vector<Vec3d> sums = localTerms(batch.rays, hits);
  Continued mirrors(count), behind(count);
  for (std::size_t i = 0; i < batch.rays.size(); ++i) {
    if (!isFound(hits[i])) continue;
    const Ray& ray = batch.rays[i];
    const RayShare& share = batch.shares[i];
    const Passage passage = passageAt(passages, batch.rays, hits, i);
    if (mirrored(ray, hits[i], passage, bounces, share.weight, share.indexOfRefraction,
                 mirrors.draft(), mirrors.draftShare())) {
      mirrors.keep(epsilonAt(hits[i]), i);
    }
    if (refracted(ray, hits[i], passage, bounces, share.weight, behind.draft(),
                  behind.draftShare())) {
      behind.keep(epsilonAt(hits[i]), i);
    }
  }
  addContinued(mirrors, bounces, sums);
  addContinued(behind, bounces, sums);
  for (std::size_t i = 0; i < sums.size(); ++i) {
    colors[i] = !isFound(hits[i])  ? scene_->getBackgroundColor()
                : passages.empty() ? Vec3f(sums[i])
                                   : Vec3f(sums[i] * Vec3d(passages[i].tint));
  }
}

void RayTracer::intersectBatch(const RayBatch& batch, Hit* hits) const {
  reportEyeRays(batch);
  findBatch(batch, hits);
}

void RayTracer::reportEyeRays(const RayBatch& batch) const {
  for (std::size_t i = 0; observer_ && i < batch.rays.size(); ++i) {
    reportBegin(RayKind::eye, batch.rays[i], batch.tmins[i], batch.shares[i], 0);
  }
}

/// Finds what the rays hit, and what lies on both sides of it.
std::vector<Passage> RayTracer::findBatch(const RayBatch& batch, Hit* hits) const {
  const int count = batch.size();
  intersectTogether(*geometry_, batch, hits);
  std::vector<Passage> passages(tracksMedia_ ? batch.rays.size() : 0);
  for (std::size_t i = 0; i < passages.size(); ++i) {
    if (isFound(hits[i])) settle(batch.rays[i], Hit().getT(), hits[i], passages[i]);
  }
  for (int i = 0; observer_ && i < count; ++i) {
    observer_->rayMeets(isFound(hits[i]) ? hits + i : nullptr);
  }
  return passages;
}

/// Ambient light and all lamps.
std::vector<Vec3d> RayTracer::localTerms(const std::vector<Ray>& rays, const Hit* hits) const {
  const bool plainShadows = options_.shadows && !options_.transparentShadows;
  std::vector<Vec3d> sums(rays.size());
  for (int light = 0; plainShadows && light < scene_->getNumLights(); ++light) {
    addLight(light, rays, hits, sums);
  }
  for (std::size_t i = 0; i < rays.size(); ++i) {
    if (!isFound(hits[i])) continue;
    if (!plainShadows) sums[i] = lights(rays[i], hits[i]);
    sums[i] += ambient(hits[i]);
  }
  return sums;
}

/// Adds to each sum what light `index` contributes there.
void RayTracer::addLight(int index, const std::vector<Ray>& rays, const Hit* hits,
                         std::vector<Vec3d>& sums) const {
  std::vector<LightSample> samples;  // and room for one more
  std::vector<ShadowQuery> ways;     // likewise
  std::vector<std::size_t> places;
  samples.reserve(rays.size() + 1);
  ways.reserve(rays.size() + 1);
  places.reserve(rays.size());
  samples.emplace_back();
  Hit turned;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    if (!isFound(hits[i])) continue;
    LightSample& light = samples.back();
    sampleLight(index, litSide(rays[i], hits[i], turned), light);
    if (!light.isInFront) reportLight(index, hits[i], light, Vec3f());
    if (!light.isInFront) continue;
    ways.emplace_back();
    setShadowQuery(hits[i], light, ways.back());
    places.push_back(i);
    samples.emplace_back();
  }
  bool blocked[kBatchSize];
  occludedTogether(*geometry_, ways, int(places.size()), blocked);
  for (std::size_t k = 0; k < places.size(); ++k) {
    const std::size_t i = places[k];
    reportLight(index, hits[i], samples[k], blocked[k] ? Vec3f() : Vec3f(1, 1, 1));
    if (blocked[k]) continue;
    const Hit& lit = litSide(rays[i], hits[i], turned);
    sums[i] += reflected(rays[i], lit, samples[k], Vec3f(1, 1, 1));
  }
}

/// Adds to each sum what the ray brings that continues there, if any.
void RayTracer::addContinued(Continued& next, int bounces, std::vector<Vec3d>& sums) const {
  const RayBatch& batch = next.finish();
  const std::vector<std::size_t>& places = next.places();
  std::vector<Hit> hits(places.size());
  std::vector<Vec3f> colors(places.size());
  traceBatch(batch, bounces + 1, hits.data(), colors.data());
  for (std::size_t k = 0; k < places.size(); ++k) {
    sums[places[k]] += Vec3d(batch.shares[k].factor) * Vec3d(colors[k]);
  }
}
