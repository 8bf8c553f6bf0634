// TestCounts: what it took to answer for the objects of a scene.
#pragma once
#include <cstdint>

struct TestCounts {
  std::uint64_t nodes = 0;       ///< of trees, groups and Transforms entered, or cells visited
  std::uint64_t primitives = 0;  ///< spheres, planes, triangles and faces of meshes tested

  void add(const TestCounts& other) {
    nodes += other.nodes;
    primitives += other.primitives;
  }
};

/// What all the rays of one thread took.
struct RayTestCounts {
  TestCounts nearest;  ///< for nearest hits
  TestCounts shadow;   ///< for what stands in the way of light

  void add(const RayTestCounts& other) {
    nearest.add(other.nearest);
    shadow.add(other.shadow);
  }
};
