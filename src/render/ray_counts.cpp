// RayCounts: sums.
#include "render/ray_counts.h"

#include <algorithm>
#include <functional>
#include <numeric>

namespace {

/// Adds each of `added` to what stands at its place in `sums`, which is as long.
template <class Numbers>
void addEach(const Numbers& added, Numbers& sums) {
  std::transform(added.begin(), added.end(), sums.begin(), sums.begin(), std::plus<>());
}

}  // namespace

void RayCounts::addRays(RayKind kind, int bounces, std::size_t count) {
  if (count == 0) return;  // no way of that length
  rays_[std::size_t(kind)] += count;
  if (std::size_t(bounces) >= byBounces_.size()) byBounces_.resize(std::size_t(bounces) + 1);
  byBounces_[std::size_t(bounces)] += count;
}

void RayCounts::addShadowRays(std::size_t cast, std::size_t blocked) {
  shadowRays_ += cast;
  blocked_ += blocked;
}

void RayCounts::add(const RayCounts& other) {
  addEach(other.rays_, rays_);
  addEach(other.ends_, ends_);
  byBounces_.resize(std::max(byBounces_.size(), other.byBounces_.size()));
  addEach(other.byBounces_, byBounces_);
  addShadowRays(other.shadowRays_, other.blocked_);
  addMisses(other.misses_);
}

std::uint64_t RayCounts::total() const {
  return std::accumulate(rays_.begin(), rays_.end(), shadowRays_);
}
