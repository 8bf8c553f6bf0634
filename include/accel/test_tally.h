// TestTally: adds up what it took to answer, for all threads at once.
#pragma once
#include <atomic>
#include <cstdint>
#include <functional>
#include <thread>

#include "accel/test_counts.h"

class TestTally {
 public:
  /// Any number of threads may add at once.
  void addNearest(std::uint64_t nodes, std::uint64_t primitives) { add(0, nodes, primitives); }
  void addShadow(std::uint64_t nodes, std::uint64_t primitives) { add(2, nodes, primitives); }

  /// The sum of what has been added. Whoever adds has to be done.
  RayTestCounts total() const {
    RayTestCounts sum;
    for (const Share& share : shares_) {
      sum.nearest.add({share.counts[0], share.counts[1]});
      sum.shadow.add({share.counts[2], share.counts[3]});
    }
    return sum;
  }

 private:
  static constexpr std::size_t kShares = 32;

  /// Threads seldom share one, so that they seldom wait for each other.
  struct alignas(128) Share {
    std::atomic<std::uint64_t> counts[4] = {};
  };

  void add(int first, std::uint64_t nodes, std::uint64_t primitives) {
    const std::size_t thread = std::hash<std::thread::id>{}(std::this_thread::get_id());
    std::atomic<std::uint64_t>* counts = shares_[thread % kShares].counts + first;
    counts[0].fetch_add(nodes, std::memory_order_relaxed);
    counts[1].fetch_add(primitives, std::memory_order_relaxed);
  }

  Share shares_[kShares];
};
