// ObjectTree: the objects between two Transforms (or above the outermost one), in the space where
// they stand, with a tree of boxes over them.
#pragma once
#include <cstdint>
#include <vector>

#include "accel/transform_range.h"
#include "accel/traversal.h"
#include "accel/wide_bvh.h"
#include "geometry/object3d.h"
#include "geometry/transform.h"
#include "geometry/triangle_mesh.h"

namespace accel {

class MeshTree;
class ObjectTree;

/// The nearest hit found so far, on its way through the ObjectTrees.
struct NearestQuery {
  static constexpr std::uint32_t kNothing = 0xffffffffu;

  Hit* hit = nullptr;  ///< what has been recorded; while one mesh is asked its t may lag behind `t`
  double tmin = 0;
  double t;                        ///< the nearest t found, or the upper bound given
  std::uint32_t order = kNothing;  ///< of the object found, in the scene; kNothing: none found
  std::uint32_t face = 0;

  /// Of several surfaces at the same t the first one in the scene wins.
  bool accepts(double newT, std::uint32_t newOrder, std::uint32_t newFace) const {
    return newT < t || (newT == t && order != kNothing &&
                        (newOrder < order || (newOrder == order && newFace < face)));
  }
  /// Notes what was found and recorded in `hit`.
  void found(double newT, std::uint32_t newOrder, std::uint32_t newFace) {
    t = newT;
    order = newOrder;
    face = newFace;
  }
  /// An upper bound that lets equal t through, for functions that demand less.
  double inclusiveBound() const;
};

/// One object of a tree.
struct TreeMember {
  enum class Kind : std::uint32_t {
    plain,            ///< asked through its own virtual functions
    mesh,             ///< a TriangleMesh with a tree
    transformedMesh,  ///< a Transform of one
    transformedTree   ///< a Transform of what has an ObjectTree of its own
  };
  const Object3D* object;  // not owned
  union {
    const MeshTree* meshTree;      // not owned
    const ObjectTree* objectTree;  // not owned
  };
  std::uint32_t order;  ///< place in the scene
  Kind kind;

  /// The object, where it is a Transform; and the mesh, where a tree is asked for one.
  const Transform& transform() const { return static_cast<const Transform&>(*object); }
  const TriangleMesh& mesh() const {
    return static_cast<const TriangleMesh&>(kind == Kind::transformedMesh ? *transform().getObject()
                                                                          : *object);
  }
};

/// Kernels and ObjectTrees call each other; all are const while rays are traced.
class ObjectTree {
 public:
  explicit ObjectTree(const Kernels& kernels) : kernels_(&kernels) {}

  /// Appends a member; finish() then sorts all of them into the tree.
  void add(const TreeMember& member, const TransformError& error) {
    members_.push_back(member);
    error_.add(error);
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
  const TransformError& error() const { return error_; }
  const WideBvh& bvh() const { return bvh_; }
  std::size_t size() const { return members_.size(); }
  const TreeMember& member(std::uint32_t id) const { return members_[id]; }
  const Kernels& kernels() const { return *kernels_; }

  bool nearestOf(const TreeMember& member, const Ray& ray, NearestQuery& query) const;
  bool occludedBy(const TreeMember& member, const Ray& ray, double tmin, double tmax) const;
  void visitCrossingsOf(const TreeMember& member, const Ray& ray, CrossingVisitor& visitor) const;

 private:
  // With `r`, the ray as prepared for the tree.
  bool nearestInTree(const Ray& ray, NearestQuery& query, TraversalRay& r,
                     const ParameterMap& time) const;
  bool occludedInTree(const Ray& ray, double tmin, double tmax, TraversalRay& r) const;

  /// Counts `count` rays that ask `member` without a tree.
  void countPlain(void (TestTally::*addCounts)(const TestCounts&), const TreeMember& member,
                  int count) const {
    if (!kernels_->tally || member.kind != TreeMember::Kind::plain) return;
    (kernels_->tally->*addCounts)({0, std::uint64_t(count)});
  }

  const Kernels* kernels_;  // not owned
  std::vector<TreeMember> members_;
  std::vector<std::uint32_t> direct_;  // members that are asked one by one
  WideBvh bvh_;
  BoundingBox box_;
  TransformError error_;  // of all members
  bool bounded_ = true;
};

/// The tree of a mesh, asked on behalf of `mesh`, which stands at `order` in the scene.
bool nearestInMesh(const Kernels& kernels, const MeshTree& tree, const TriangleMesh& mesh,
                   std::uint32_t order, const Ray& ray, NearestQuery& query);
bool occludedByMesh(const Kernels& kernels, const MeshTree& tree, const TriangleMesh& mesh,
                    const Ray& ray, double tmin, double tmax);
void visitMeshCrossings(const Kernels& kernels, const MeshTree& tree, const TriangleMesh& mesh,
                        const Ray& ray, CrossingVisitor& visitor);

/// The same for up to RayPacket::kMostRays rays, as ObjectTree's.
std::uint64_t nearestInMesh(const Kernels& kernels, const MeshTree& tree, const TriangleMesh& mesh,
                            std::uint32_t order, const Ray* rays, int count, NearestQuery* queries);
std::uint64_t occludedByMesh(const Kernels& kernels, const MeshTree& tree, const TriangleMesh& mesh,
                             const ShadowQuery* queries, int count);

}  // namespace accel
