// ObjectTree: the objects between two Transforms (or above the outermost one), in the space where
// they stand, with a tree of boxes over them.
//
// What has no box (planes, objects of unknown classes) and what is too few for a tree is asked one
// after the other, small ones first, each for all rays that may meet its box; planes and spheres
// among it all together. Then the rays walk the tree. A member that the kernels do not know is
// asked when the walk comes to its box, for the rays that meet it. A hit lowers the ray's bound, so
// that farther boxes are passed over.
#pragma once
#include <cstdint>
#include <deque>
#include <memory>
#include <vector>

#include "accel/mesh_tree.h"
#include "accel/question.h"
#include "accel/transform_range.h"
#include "geometry/transform.h"
#include "geometry/triangle_mesh.h"

namespace accel {

class ObjectTree;

/// A mesh in the scene, perhaps under a Transform, and the tree over its triangles. Nothing is
/// owned.
class AskedMesh : public AskedTree {
 public:
  AskedMesh(const TriangleMesh& mesh, const Matrix* inverse, const MeshTree& tree,
            std::uint32_t order)
      : mesh_(mesh), inverse_(inverse), tree_(tree), order_(order) {}
  const WideBvh& bvh() const override { return tree_.bvh(); }
  const Matrix* inverse() const override { return inverse_; }
  bool isOneObject() const override { return true; }
  LeafPrimitive primitiveAt(const std::uint32_t* words, int lane) const override;
  void getNumbers(const std::uint32_t* words, int lane, double* numbers,
                  int stride) const override {
    tree_.getCorners(words, lane, numbers, stride);
  }
  bool takesPlace(LeafPrimitive& face) const override;
  void shade(const RowList& rows, HitTable& hits) const override;
  void setCrossing(const std::uint32_t* words, int lane, Crossing& crossing) const override;

 private:
  const TriangleMesh& mesh_;
  const Matrix* const inverse_;
  const MeshTree& tree_;
  const std::uint32_t order_;  // number in the order of the scene
};

/// One object of a tree. A leaf of objects holds all of it, and a copy of the inverse behind it, if
/// there is one, so that both are prefetched with the leaf: by way of a list of members and the
/// Transform itself 10,000 meshes took 1.17 of the time.
struct TreeMember {
  enum class Kind : std::uint32_t {
    plain,  ///< asked through its own virtual functions
    shape,  ///< a plane or a sphere, or a Transform of one
    mesh,   ///< a TriangleMesh with a tree, or a Transform of one
    tree    ///< a Transform of what has an ObjectTree of its own, or several objects of this space
            ///< that have one: no object, no order
  };
  const Object3D* object;    // not owned
  const TriangleMesh* mesh;  // that has a tree; not owned
  const Matrix* inverse;     // of the Transform over what has a tree, else null; not owned
  union {
    const MeshTree* meshTree;      // not owned
    const ObjectTree* objectTree;  // not owned
    const ShapeNumbers* shape;     // not owned
  };
  std::uint32_t order;  ///< number in the order of the scene
  Kind kind;
};

/// A member and its box, which is empty where it has none.
struct BoxedMember {
  BoundingBox box;
  std::uint32_t id;
};

/// All is const while rays are traced.
class ObjectTree : public AskedTree {
 public:
  /// Appends a member; finish() then sorts all of them into the tree.
  void add(const TreeMember& member, const TransformError& error) {
    members_.push_back(member);
    error_.add(error);
  }
  void finish(int threads);

  /// Asks all members for the listed rays, which are in the space of the members.
  void ask(Question& question, const RowList& rows) const;

  bool isBounded() const { return bounded_; }
  const BoundingBox& box() const { return box_; }
  const TransformError& error() const { return error_; }
  /// True where the rays of a range can be told by all its trees.
  bool fits(const RayRange& range) const;
  /// The memory of all its trees.
  std::size_t bytes() const;
  const WideBvh& bvh() const override { return bvh_; }
  LeafPrimitive primitiveAt(const std::uint32_t* words, int lane) const override;
  void getNumbers(const std::uint32_t* words, int lane, double* numbers, int stride) const override;
  void askObject(const std::uint32_t* words, Question& question,
                 const RowList& rows) const override;

 private:
  const TreeMember& memberAt(const std::uint32_t* words, int lane) const;
  /// A member that is asked alone, for those rays that may meet its box.
  struct DirectMember {
    BoxNumbers box;
    double size;  // the longest side
    std::uint32_t id;
  };
  void askAlone(const BoxedMember& each);
  template <class IsOut>
  void leaveOut(std::vector<BoxedMember>& boxed, const IsOut& isOut);
  void gatherSmall(std::vector<BoxedMember>& boxed, int threads);
  /// Makes a tree of the members, and a member of the tree, which it returns.
  BoxedMember gather(const std::vector<std::uint32_t>& ids, int threads);
  void build(std::vector<BoxedMember> boxed, int threads);

  std::vector<TreeMember> members_;
  std::vector<ShapeNumbers> shapes_;  // of members outside of the tree, in scene order
  std::vector<DirectMember> direct_;  // the other members outside of it, small ones first
  std::deque<ShapeNumbers> inTree_;   // of Transforms in leaves of objects
  std::vector<std::unique_ptr<ObjectTree>> gathered_;  // of members small beside the whole space
  WideBvh bvh_;
  BoundingBox box_;
  TransformError error_;  // of all members
  bool bounded_ = true;
};

}  // namespace accel
