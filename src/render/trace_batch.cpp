// RayTracer::traceBatch: the same recursion for many rays at once, each generation in batches.
#include <algorithm>
#include <vector>

#include "render/ray_tracer.h"
#include "shading/solid_texture.h"

namespace {

/// Fewer rays than this are traced one by one.
constexpr int kFewRays = 4;
/// After this many bounces rays go one by one, so that memory does not grow with -bounces.
constexpr int kMostGenerations = 64;

bool isFound(const Hit& hit) { return hit.getT() < Hit().getT(); }

bool isTextured(const Hit& hit) { return isFound(hit) && hit.getMaterial()->asTexture(); }

}  // namespace

/// Shades hits of which some are of textures: the parts of all of them together, a batch at a time.
class RayTracer::PartBatch {
 public:
  PartBatch(const RayTracer& tracer, int bounces, int count)
      : tracer_(tracer), bounces_(bounces), sums_(std::size_t(count)) {}

  /// Takes what ray number `place` hit, if anything.
  void add(const TracedRay& ray, const Hit& hit, const Passage& passage, int place) {
    if (!isTextured(hit)) return addPart(ray, hit, passage, {place, 1});
    const SolidTexture& texture = *hit.getMaterial()->asTexture();
    for (const WeightedMaterial& part : texture.partsAt(hit.getIntersectionPoint())) {
      TracedRay lighter = ray;
      lighter.weight *= float(part.weight);
      addPart(lighter, hit.withMaterial(part.material), passage, {place, part.weight});
    }
  }

  /// Stores the colours of all rays.
  void finish(Vec3f* colors) {
    shadeParts();
    for (const Vec3d& sum : sums_) *colors++ = Vec3f(sum);
  }

 private:
  struct Share {
    int place;
    double weight;
  };

  void addPart(const TracedRay& ray, const Hit& hit, const Passage& passage, const Share& share) {
    if (shares_.size() == Object3D::kBatchSize) shadeParts();
    rays_.push_back(ray);
    hits_.push_back(hit);
    passages_.push_back(passage);
    shares_.push_back(share);
  }

  void shadeParts() {
    std::vector<Vec3f> colors(shares_.size());
    tracer_.shadeBatch(rays_.data(), hits_.data(), passages_.data(), int(rays_.size()), bounces_,
                       colors.data());
    for (std::size_t k = 0; k < shares_.size(); ++k) {
      sums_[std::size_t(shares_[k].place)] += shares_[k].weight * Vec3d(colors[k]);
    }
    rays_.clear();
    hits_.clear();
    passages_.clear();
    shares_.clear();
  }

  const RayTracer& tracer_;
  int bounces_;
  std::vector<TracedRay> rays_;
  std::vector<Hit> hits_;
  std::vector<Passage> passages_;
  std::vector<Share> shares_;  // whose parts they are
  std::vector<Vec3d> sums_;
};

void RayTracer::traceBatch(const TracedRay* rays, int count, int bounces, Hit* hits,
                           Vec3f* colors) const {
  if (count < kFewRays || bounces >= kMostGenerations) {
    for (int i = 0; i < count; ++i) {
      Ray ray = rays[i].ray;
      colors[i] = traceRay(ray, float(rays[i].tmin), bounces, rays[i].weight,
                           rays[i].indexOfRefraction, hits[i]);
    }
    return;
  }
  if (bounces == 0) reportEyeRays(rays, count);
  const std::vector<Passage> passages = findBatch(rays, count, hits);
  if (std::none_of(hits, hits + count, isTextured)) {
    shadeBatch(rays, hits, passages.data(), count, bounces, colors);
  } else {
    PartBatch parts(*this, bounces, count);
    for (int i = 0; i < count; ++i) parts.add(rays[i], hits[i], passages[std::size_t(i)], i);
    parts.finish(colors);
  }
  for (int i = 0; observer_ && i < count; ++i) observer_->rayEnds(colors[i]);
}

/// The second half of traceBatch, where no hit is of a texture.
void RayTracer::shadeBatch(const TracedRay* rays, const Hit* hits, const Passage* passages,
                           int count, int bounces, Vec3f* colors) const {
  std::vector<Vec3d> sums = localTerms(rays, hits, count);
  addContinued(hits, count, bounces, sums, [&](int i) {
    return mirrored(rays[i].ray, hits[i], passages[i], bounces, rays[i].weight,
                    rays[i].indexOfRefraction);
  });
  addContinued(hits, count, bounces, sums, [&](int i) {
    return refracted(rays[i].ray, hits[i], passages[i], bounces, rays[i].weight);
  });
  for (int i = 0; i < count; ++i) {
    const Vec3d tint(passages[i].tint);
    colors[i] =
        isFound(hits[i]) ? Vec3f(sums[std::size_t(i)] * tint) : scene_->getBackgroundColor();
  }
}

void RayTracer::intersectBatch(const TracedRay* rays, int count, Hit* hits) const {
  reportEyeRays(rays, count);
  findBatch(rays, count, hits);
}

void RayTracer::reportEyeRays(const TracedRay* rays, int count) const {
  for (int i = 0; observer_ && i < count; ++i) begun(RayKind::eye, rays[i], 0);
}

/// Finds what the rays hit, and what lies on both sides of it.
std::vector<Passage> RayTracer::findBatch(const TracedRay* rays, int count, Hit* hits) const {
  std::vector<Ray> only;
  std::vector<double> tmins;
  only.reserve(std::size_t(count));
  tmins.reserve(std::size_t(count));
  for (int i = 0; i < count; ++i) {
    only.push_back(rays[i].ray);
    tmins.push_back(rays[i].tmin);
  }
  geometry_->intersectBatch(only.data(), tmins.data(), count, hits);
  std::vector<Passage> passages(only.size());
  for (int i = 0; i < count; ++i) {
    if (isFound(hits[i])) settle(rays[i].ray, Hit().getT(), hits[i], passages[std::size_t(i)]);
  }
  for (int i = 0; observer_ && i < count; ++i) {
    observer_->rayMeets(isFound(hits[i]) ? hits + i : nullptr);
  }
  return passages;
}

/// Ambient light and all lamps.
std::vector<Vec3d> RayTracer::localTerms(const TracedRay* rays, const Hit* hits, int count) const {
  const bool plainShadows = options_.shadows && !options_.transparentShadows;
  const auto size = std::size_t(count);
  std::vector<Vec3d> sums(size);
  for (int light = 0; plainShadows && light < scene_->getNumLights(); ++light) {
    addLight(light, rays, hits, count, sums);
  }
  for (int i = 0; i < count; ++i) {
    if (!isFound(hits[i])) continue;
    Vec3d& sum = sums[std::size_t(i)];
    sum = ambient(hits[i]) + (plainShadows ? sum : lights(rays[i].ray, hits[i]));
  }
  return sums;
}

/// Adds to each sum what light `index` contributes there.
void RayTracer::addLight(int index, const TracedRay* rays, const Hit* hits, int count,
                         std::vector<Vec3d>& sums) const {
  struct Asked {
    int place;
    LightSample light;
  };
  std::vector<Asked> asked;
  std::vector<ShadowQuery> ways;
  asked.reserve(std::size_t(count));
  ways.reserve(std::size_t(count));
  for (int i = 0; i < count; ++i) {
    if (!isFound(hits[i])) continue;
    std::optional<Hit> turned;
    const LightSample light = sampleLight(index, litSide(rays[i].ray, hits[i], turned));
    if (!light.isInFront) reportLight(index, light, Vec3f());
    if (!light.isInFront) continue;
    ways.push_back(shadowQuery(hits[i], light));
    asked.push_back({i, light});
  }
  bool blocked[Object3D::kBatchSize];
  geometry_->occludedBatch(ways.data(), int(ways.size()), blocked);
  for (std::size_t k = 0; k < asked.size(); ++k) {
    reportLight(index, asked[k].light, blocked[k] ? Vec3f() : Vec3f(1, 1, 1));
    if (blocked[k]) continue;
    const int i = asked[k].place;
    std::optional<Hit> turned;
    const Hit& lit = litSide(rays[i].ray, hits[i], turned);
    sums[std::size_t(i)] += reflected(rays[i].ray, lit, asked[k].light, Vec3f(1, 1, 1));
  }
}

/// Adds to each sum what the ray brings that continues ray i, where continued(i) gives one.
template <class Continue>
void RayTracer::addContinued(const Hit* hits, int count, int bounces, std::vector<Vec3d>& sums,
                             const Continue& continued) const {
  std::vector<TracedRay> next;
  std::vector<std::size_t> places;
  for (int i = 0; i < count; ++i) {
    const std::optional<TracedRay> ray = isFound(hits[i]) ? continued(i) : std::nullopt;
    if (!ray) continue;
    next.push_back(*ray);
    places.push_back(std::size_t(i));
  }
  std::vector<Hit> nextHits(next.size());
  std::vector<Vec3f> colors(next.size());
  traceBatch(next.data(), int(next.size()), bounces + 1, nextHits.data(), colors.data());
  for (std::size_t k = 0; k < next.size(); ++k) {
    sums[places[k]] += Vec3d(next[k].factor) * Vec3d(colors[k]);
  }
}
