// RayBatch: rays that go through the scene together, with what the recursion knows of each.
// Kept in arrays of their own, because most passes over a batch read only one of them.
#pragma once
#include <vector>

#include "geometry/ray.h"
#include "math/vec3.h"

/// What the recursion knows of a ray beside its way.
struct RayShare {
  float weight = 1;             ///< the part that its colour has in the pixel
  float indexOfRefraction = 1;  ///< of the medium it travels in
  Vec3f factor{1, 1, 1};  ///< of its colour in that of the ray it continues; white for an eye ray
};

struct RayBatch {
  std::vector<Ray> rays;
  std::vector<double> tmins;  ///< rays[i] meets what lies at t > tmins[i]
  std::vector<RayShare> shares;

  /// An empty batch with room for `capacity` rays.
  explicit RayBatch(int capacity) {
    rays.reserve(std::size_t(capacity));
    tmins.reserve(std::size_t(capacity));
    shares.reserve(std::size_t(capacity));
  }
  int size() const { return int(rays.size()); }
  void add(const Ray& ray, double tmin, const RayShare& share = RayShare()) {
    rays.push_back(ray);
    tmins.push_back(tmin);
    shares.push_back(share);
  }
  void clear() {
    rays.clear();
    tmins.clear();
    shares.clear();
  }
};
