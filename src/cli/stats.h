// Stats: what -stats prints. One line for each entry, `name: value`, in a fixed order.
#pragma once
#include <chrono>
#include <string>

#include "accel/test_tally.h"
#include "render/ray_counts.h"

/// Seconds from one call of restart() to the next.
class Stopwatch {
 public:
  /// Seconds since the start, or since the last restart; begins anew.
  double restart() {
    const Clock::time_point now = Clock::now();
    const std::chrono::duration<double> passed = now - start_;
    start_ = now;
    return passed.count();
  }

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point start_ = Clock::now();
};

struct Stats {
  std::string simd;  ///< the instruction set in use, "none" for the plain object tree
  std::string tree;  ///< CompiledScene::describe(), or "plain object tree"
  int threads = 0;
  double readSeconds = 0, buildSeconds = 0, traceSeconds = 0, writeSeconds = 0;

  RayCounts rays;
  double pixels = 0;
  RayTestCounts tests;
  bool countsTests = false;  ///< whether what answered for the scene has filled `tests`

  /// All lines, each with its end.
  std::string text() const;
};
