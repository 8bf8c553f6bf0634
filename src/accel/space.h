// Space: a subtree of the scene compiled in one coordinate space, that of a Transform's inside.
#pragma once
#include <cstdint>
#include <vector>

#include "accel/map_noise.h"
#include "geometry/batch_geometry.h"
#include "accel/traversal.h"
#include "accel/wide_bvh.h"
#include "geometry/object3d.h"
#include "geometry/transform.h"
#include "geometry/triangle_mesh.h"

namespace accel {

class MeshTree;
class Space;

/// The nearest hit found so far, on its way through the spaces.
struct NearestQuery {
  static constexpr std::uint32_t kNothing = 0xffffffffu;

  Hit* hit = nullptr;  ///< what has been recorded; while one mesh is asked its t may lag behind `t`
  double tmin = 0;
  double t;                        ///< the nearest t found, or the upper bound given
  std::uint32_t order = kNothing;  ///< of the object found, in the scene; kNothing: none found
  std::uint32_t part = 0;

  /// Of several surfaces at the same t the first one in the scene wins.
  bool accepts(double newT, std::uint32_t newOrder, std::uint32_t newPart) const {
    return newT < t || (newT == t && order != kNothing &&
                        (newOrder < order || (newOrder == order && newPart < part)));
  }
  /// Notes what was found and recorded in `hit`.
  void found(double newT, std::uint32_t newOrder, std::uint32_t newPart) {
    t = newT;
    order = newOrder;
    part = newPart;
  }
  /// An upper bound that lets equal t through, for functions that demand less.
  double inclusiveBound() const;
};

/// One object of a space.
struct Entry {
  enum class Kind : std::uint32_t {
    plain,      ///< asked through its own virtual functions
    mesh,       ///< a TriangleMesh with a tree
    movedMesh,  ///< a Transform of one
    movedSpace  ///< a Transform of a compiled space
  };
  const Object3D* object;  // not owned
  union {
    const MeshTree* mesh;
    const Space* space;
  };
  std::uint32_t order;  ///< place in the scene
  Kind kind;
};

/// Kernels and spaces call each other; all are const while rays are traced.
class Space {
 public:
  explicit Space(const Kernels& kernels) : kernels_(&kernels) {}

  /// Appends an entry; finish() then sorts all entries into the tree.
  void add(const Entry& entry, const MapNoise& noise) {
    entries_.push_back(entry);
    noise_.add(noise);
  }
  void finish(int threads);

  bool nearest(const Ray& ray, NearestQuery& query) const;
  bool occluded(const Ray& ray, double tmin, double tmax) const;
  void visitCrossings(const Ray& ray, CrossingVisitor& visitor) const;

  /// Asks for up to RayPacket::kMostRays rays that run close together; bit i of the result says
  /// whether rays[i] found something (is blocked).
  std::uint64_t nearest(const Ray* rays, int count, NearestQuery* queries) const;
  std::uint64_t occluded(const ShadowQuery* queries, int count) const;

  bool isBounded() const { return bounded_; }
  const BoundingBox& box() const { return box_; }
  const MapNoise& noise() const { return noise_; }
  const WideBvh& bvh() const { return bvh_; }
  std::size_t size() const { return entries_.size(); }
  const Entry& entry(std::uint32_t id) const { return entries_[id]; }
  const Kernels& kernels() const { return *kernels_; }

  bool nearestOf(const Entry& entry, const Ray& ray, NearestQuery& query) const;
  bool occludedBy(const Entry& entry, const Ray& ray, double tmin, double tmax) const;
  void visitCrossingsOf(const Entry& entry, const Ray& ray, CrossingVisitor& visitor) const;

 private:
  // With `r`, the ray as prepared for the tree.
  bool nearestInTree(const Ray& ray, NearestQuery& query, TraversalRay& r,
                     const TimeMap& time) const;
  bool occludedInTree(const Ray& ray, double tmin, double tmax, TraversalRay& r) const;

  /// Notes that `count` rays ask `entry` without a tree.
  void tellDirect(void (TestTally::*told)(std::uint64_t, std::uint64_t), const Entry& entry,
                  int count) const {
    if (!kernels_->tally || entry.kind != Entry::Kind::plain) return;
    (kernels_->tally->*told)(0, std::uint64_t(count));
  }

  const Kernels* kernels_;  // not owned
  std::vector<Entry> entries_;
  std::vector<std::uint32_t> direct_;  // entries that are asked one by one
  WideBvh bvh_;
  BoundingBox box_;
  MapNoise noise_;  // of all entries
  bool bounded_ = true;
};

/// The tree of a mesh, asked on behalf of `mesh`, which stands at `order` in the scene.
bool nearestInMesh(const Kernels& kernels, const MeshTree& tree, const TriangleMesh& mesh,
                   std::uint32_t order, const Ray& ray, NearestQuery& query);
bool occludedByMesh(const Kernels& kernels, const MeshTree& tree, const TriangleMesh& mesh,
                    const Ray& ray, double tmin, double tmax);
void visitMeshCrossings(const Kernels& kernels, const MeshTree& tree, const TriangleMesh& mesh,
                        const Ray& ray, CrossingVisitor& visitor);

/// The same for up to RayPacket::kMostRays rays, as Space's.
std::uint64_t nearestInMesh(const Kernels& kernels, const MeshTree& tree, const TriangleMesh& mesh,
                            std::uint32_t order, const Ray* rays, int count, NearestQuery* queries);
std::uint64_t occludedByMesh(const Kernels& kernels, const MeshTree& tree, const TriangleMesh& mesh,
                             const ShadowQuery* queries, int count);

}  // namespace accel
