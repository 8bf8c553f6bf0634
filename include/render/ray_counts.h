// RayCounts: how many rays of each kind, and why branches ended. As an observer it counts what a
// WatchedTracer does; a WaveTracer adds the lengths of its lists. The sums are the same however the
// rays are shared out among threads, and whoever traces them.
#pragma once
#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <numeric>
#include <vector>

#include "render/watched_tracer.h"

class RayCounts : public RayObserver {
 public:
  /// Adds `count` rays that begin after `bounces` >= 0 others.
  void addRays(RayKind kind, int bounces, std::size_t count) {
    if (count == 0) return;  // no way of that length
    rays_[std::size_t(kind)] += count;
    if (std::size_t(bounces) >= byBounces_.size()) byBounces_.resize(std::size_t(bounces) + 1);
    byBounces_[std::size_t(bounces)] += count;
  }
  /// Adds `count` rays that meet nothing.
  void addMisses(std::size_t count) { misses_ += count; }
  /// Adds shadow rays, of which nothing gets through `blocked`.
  void addShadowRays(std::size_t cast, std::size_t blocked) {
    shadowRays_ += cast;
    blocked_ += blocked;
  }
  /// Adds `count` branches that ended so.
  void addEnds(Outcome why, std::size_t count) { ends_[std::size_t(why)] += count; }
  /// Adds what another one has counted.
  void add(const RayCounts& other) {
    addEach(other.rays_, rays_);
    addEach(other.ends_, ends_);
    byBounces_.resize(std::max(byBounces_.size(), other.byBounces_.size()));
    addEach(other.byBounces_, byBounces_);
    addShadowRays(other.shadowRays_, other.blocked_);
    addMisses(other.misses_);
  }

  void rayBegins(RayKind kind, int bounces, const TracedRay&) override {
    addRays(kind, bounces, 1);
  }
  void rayMeets(const Hit* hit, const Interface&) override { addMisses(hit ? 0 : 1); }
  void lightAnswers(int, const LightSample&, const ShadowQuery* shadowRay, const Vec3f& visible,
                    const Vec3d&) override {
    if (shadowRay) addShadowRays(1, visible == Vec3f() ? 1 : 0);
  }
  void branchEnds(RayKind, Outcome why, float) override { addEnds(why, 1); }

  std::uint64_t rays(RayKind kind) const { return rays_[std::size_t(kind)]; }
  std::uint64_t shadowRays() const { return shadowRays_; }
  /// Shadow rays that nothing gets through.
  std::uint64_t blockedShadowRays() const { return blocked_; }
  std::uint64_t misses() const { return misses_; }
  /// Branches that ended so: tooManyBounces, tooFaint or totalReflection.
  std::uint64_t ends(Outcome why) const { return ends_[std::size_t(why)]; }
  /// Rays of every kind, shadow rays too.
  std::uint64_t total() const { return std::accumulate(rays_.begin(), rays_.end(), shadowRays_); }
  /// How many rays came after 0, 1, 2 ... bounces, shadow rays not counted; as long as the longest
  /// way.
  const std::vector<std::uint64_t>& byBounces() const { return byBounces_; }

 private:
  /// Adds each of `added` to what stands at its place in `sums`, which is as long or longer.
  template <class Numbers>
  static void addEach(const Numbers& added, Numbers& sums) {
    std::transform(added.begin(), added.end(), sums.begin(), sums.begin(), std::plus<>());
  }

  std::array<std::uint64_t, kRayKinds> rays_{};
  std::array<std::uint64_t, kOutcomes> ends_{};
  std::uint64_t shadowRays_ = 0, blocked_ = 0, misses_ = 0;
  std::vector<std::uint64_t> byBounces_;
};
