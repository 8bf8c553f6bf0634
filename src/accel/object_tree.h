// ObjectTree: the objects between two Transforms (or above the outermost one), in the space where
// they stand, with a tree of boxes over them.
#pragma once
#include <cstdint>
#include <vector>

#include "accel/transform_range.h"
#include "accel/mesh_questions.h"
#include "accel/wide_bvh.h"
#include "geometry/object3d.h"
#include "geometry/transform.h"
#include "geometry/triangle_mesh.h"

namespace accel {

class MeshTree;
class ObjectTree;

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
  MeshInScene meshInScene() const { return {mesh(), *meshTree, order}; }
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

  /// Object3D::intersect for the listed rays, which are in the space of the members: rays.tmax is
  /// lowered to the t of each new hit, and its row of `hits` set.
  void nearest(const RayTable& rays, const RowList& list, HitTable& hits, Arena& arena) const;
  /// Object3D::occluded: sets blocked[row] where anything is hit between tmin and tmax.
  void occluded(const RayTable& rays, const RowList& list, bool* blocked, Arena& arena) const;
  /// Object3D::visitCrossings. tmin is 0 and tmax infinite.
  void visitCrossings(const RayTable& rays, const RowList& list, RowCrossingVisitor& visitor,
                      Arena& arena) const;

  bool isBounded() const { return bounded_; }
  const BoundingBox& box() const { return box_; }
  const TransformError& error() const { return error_; }
  const WideBvh& bvh() const { return bvh_; }
  std::size_t size() const { return members_.size(); }
  const TreeMember& member(std::uint32_t id) const { return members_[id]; }
  const Kernels& kernels() const { return *kernels_; }

  /// The same questions to one member.
  void nearestOf(const TreeMember& member, const RayTable& rays, const RowList& list,
                 HitTable& hits, Arena& arena) const;
  void occludedBy(const TreeMember& member, const RayTable& rays, const RowList& list,
                  bool* blocked, Arena& arena) const;
  void visitCrossingsOf(const TreeMember& member, const RayTable& rays, const RowList& list,
                        RowCrossingVisitor& visitor, Arena& arena) const;

 private:
  bool takeShape(std::uint32_t id);
  void nearestShapes(const RayTable& rays, const RowList& list, HitTable& hits,
                     Arena& arena) const;

  /// Counts `count` rays that ask `member` without a tree.
  void countPlain(void (TestTally::*addCounts)(const TestCounts&), const TreeMember& member,
                  int count) const {
    if (!kernels_->tally || member.kind != TreeMember::Kind::plain) return;
    (kernels_->tally->*addCounts)({0, std::uint64_t(count)});
  }

  const Kernels* kernels_;  // not owned
  std::vector<TreeMember> members_;
  std::vector<ShapeNumbers> shapes_;   // planes and spheres that are asked together
  std::vector<std::uint32_t> direct_;  // members that are asked one by one
  WideBvh bvh_;
  BoundingBox box_;
  TransformError error_;  // of all members
  bool bounded_ = true;
};

}  // namespace accel
