// TestTally: what it takes to answer for the objects of a scene, in nodes entered and primitives
// tested.
//
// There is one way to count. Whatever answers for a scene (a CompiledScene, a Grid, the plain
// objects as a CountingTree) may be given a TestTally; it then counts for each ray on its own stack
// and adds the sums when the ray has its answer. Threads share one tally.
#pragma once
#include <atomic>
#include <cstdint>
#include <functional>
#include <thread>

#include "geometry/object3d.h"

struct TestCounts {
  std::uint64_t nodes = 0;       ///< of trees, groups and Transforms entered, or cells visited
  std::uint64_t primitives = 0;  ///< spheres, planes, triangles and faces of meshes tested
};

/// What all the rays of a run took.
struct RayTestCounts {
  TestCounts nearest;  ///< for nearest hits
  TestCounts shadow;   ///< for what stands in the way of light: shadow rays and crossings
};

class TestTally {
 public:
  /// Any number of threads may add at once.
  void addNearest(const TestCounts& counts) { add(0, counts); }
  void addShadow(const TestCounts& counts) { add(2, counts); }

  /// The sum of what has been added. Whoever adds has to be done.
  RayTestCounts total() const {
    std::uint64_t sums[4] = {};
    for (const Share& share : shares_) {
      for (int i = 0; i < 4; ++i) sums[i] += share.sums[i];
    }
    return {{sums[0], sums[1]}, {sums[2], sums[3]}};
  }

 private:
  static constexpr std::size_t kShares = 32;  // more than usual machines have threads

  /// Threads seldom share one, so that they seldom wait for each other.
  struct alignas(128) Share {
    std::atomic<std::uint64_t> sums[4] = {};
  };

  void add(int first, const TestCounts& counts) {
    const std::size_t thread = std::hash<std::thread::id>{}(std::this_thread::get_id());
    std::atomic<std::uint64_t>* sums = shares_[thread % kShares].sums + first;
    sums[0].fetch_add(counts.nodes, std::memory_order_relaxed);
    sums[1].fetch_add(counts.primitives, std::memory_order_relaxed);
  }

  Share shares_[kShares];
};

/// The plain objects, telling a TestTally what each ray takes. A mesh is one primitive for each of
/// its faces: all of them for a nearest hit and for crossings, those up to the first hit for a
/// shadow.
class CountingTree : public Object3D {
 public:
  /// Answers as `root` does and tells `tally`; neither is owned. Any number of threads may ask.
  CountingTree(const Object3D& root, TestTally& tally) : root_(&root), tally_(&tally) {}

  bool intersect(const Ray& ray, Hit& hit, double tmin) const override;
  bool occluded(const Ray& ray, double tmin, double tmax) const override;
  void visitCrossings(const Ray& ray, CrossingVisitor& visitor) const override;

 private:
  const Object3D* root_;  // not owned
  TestTally* tally_;      // not owned
};
