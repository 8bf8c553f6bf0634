// RayCounts: one addition for each event.
#include "render/ray_counts.h"

#include <numeric>

void RayCounts::rayBegins(const RayBegin& ray) {
  ++rays_[std::size_t(ray.kind)];
  const auto bounces = std::size_t(ray.bounces);
  if (bounces >= byBounces_.size()) byBounces_.resize(bounces + 1);
  ++byBounces_[bounces];
}

void RayCounts::rayMeets(const Hit* hit) { misses_ += !hit; }

void RayCounts::lightAnswers(const LightVerdict& verdict) {
  shadowRays_ += verdict.castShadowRay;
  blocked_ += verdict.castShadowRay && verdict.visible == Vec3f();
}

void RayCounts::branchStops(RayKind, BranchStop why, float) { ++stops_[std::size_t(why)]; }

void RayCounts::add(const RayCounts& other) {
  for (std::size_t i = 0; i < rays_.size(); ++i) rays_[i] += other.rays_[i];
  for (std::size_t i = 0; i < stops_.size(); ++i) stops_[i] += other.stops_[i];
  shadowRays_ += other.shadowRays_;
  blocked_ += other.blocked_;
  misses_ += other.misses_;
  if (byBounces_.size() < other.byBounces_.size()) byBounces_.resize(other.byBounces_.size());
  for (std::size_t i = 0; i < other.byBounces_.size(); ++i) byBounces_[i] += other.byBounces_[i];
}

std::uint64_t RayCounts::total() const {
  return std::accumulate(rays_.begin(), rays_.end(), shadowRays_);
}
