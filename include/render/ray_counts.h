// RayCounts: an observer that counts. The sums are the same however the rays are shared out among
// threads.
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "render/ray_observer.h"

class RayCounts : public RayObserver {
 public:
  void rayBegins(const RayBegin& ray) override;
  void rayMeets(const Hit* hit) override;
  void lightAnswers(const LightVerdict& verdict) override;
  void branchStops(RayKind kind, BranchStop why, float weight) override;

  /// Adds what another one has counted.
  void add(const RayCounts& other);

  std::uint64_t rays(RayKind kind) const { return rays_[std::size_t(kind)]; }
  std::uint64_t shadowRays() const { return shadowRays_; }
  /// Shadow rays that nothing gets through.
  std::uint64_t blockedShadowRays() const { return blocked_; }
  std::uint64_t misses() const { return misses_; }
  std::uint64_t stops(BranchStop why) const { return stops_[std::size_t(why)]; }
  /// Rays of every kind, shadow rays too.
  std::uint64_t total() const;
  /// How many rays came after 0, 1, 2 ... bounces, shadow rays not counted; as long as the longest
  /// way.
  const std::vector<std::uint64_t>& byBounces() const { return byBounces_; }

 private:
  std::array<std::uint64_t, kRayKinds> rays_{};
  std::array<std::uint64_t, kBranchStops> stops_{};
  std::uint64_t shadowRays_ = 0, blocked_ = 0, misses_ = 0;
  std::vector<std::uint64_t> byBounces_;
};
