// Question: what is asked of many rays at once. ObjectTrees and the trees of meshes know where to
// look; a Question knows what becomes of what is found there.
//
// There are three: which surface is the nearest, whether anything is in the way, and all that is
// crossed. Each is asked of everything that can stand in a scene:
//
//   askObject   an object of a class that is not known here: by its own function, ray by ray
//   askShapes   planes and spheres, perhaps under a Transform each: several rays at a time
//   askTree     the primitives of a tree, perhaps under a Transform: the rays walk it in streams
//               (stream.h). Where floats prove that a triangle or sphere is missed, nothing more
//               happens; each other one becomes a Candidate, which the primitive's own double
//               function decides
//   askInside   a tree of objects under a Transform: the rays become a table of their own there,
//               by one multiplication each, and what is found comes back out. t means the same on
//               both sides
//
// Of equal t the first in the scene wins, whatever the order in which things are asked
// (NearestSoFar::accepts).
#pragma once
#include "accel/stream.h"
#include "geometry/transform.h"

namespace accel {

class Question;
struct TreeMember;

/// A tree, and what its leaves hold.
class AskedTree {
 public:
  virtual ~AskedTree() = default;
  virtual const WideBvh& bvh() const = 0;
  /// Of the Transform that it stands under, where the rays are not moved into its space before;
  /// else null.
  virtual const Matrix* inverse() const { return nullptr; }
  /// True where all that its leaves hold is one object of the scene.
  virtual bool isOneObject() const { return false; }
  /// The triangle or sphere in lane `lane` of the leaf at `words`.
  virtual LeafPrimitive primitiveAt(const std::uint32_t* words, int lane) const = 0;
  /// Stores its corners, or centre and radius, as the scene has them: numbers[k * stride] each.
  virtual void getNumbers(const std::uint32_t* words, int lane, double* numbers,
                          int stride) const = 0;
  /// A ray leaves `primitive`: true where another one of the same corners takes its place, which it
  /// then becomes.
  virtual bool takesPlace(LeafPrimitive& /*primitive*/) const { return false; }
  /// Shades hits on triangles (shadeHit), which so far have the normals of the triangles: the hits
  /// of the listed rows, which are in the space of the tree.
  virtual void shade(const RowList& /*rows*/, HitTable& /*hits*/) const {}
  /// Sets all of a crossing with that primitive but t and `leaving`.
  virtual void setCrossing(const std::uint32_t* words, int lane, Crossing& crossing) const {
    const LeafPrimitive p = primitiveAt(words, lane);
    crossing = {0, p.object, p.material, false, false};
  }
  /// Asks the object of the leaf at `words`, of which a mesh has none.
  virtual void askObject(const std::uint32_t* /*words*/, Question& /*question*/,
                         const RowList& /*rows*/) const {}
};

/// For one table of rays. Nothing is owned.
class Question {
 public:
  virtual ~Question() = default;

  /// Those of the rows that still want to know.
  virtual RowList openOf(const RowList& rows) const { return rows; }
  /// Those of them whose rays may meet the box.
  RowList rowsAt(const BoxNumbers& box, const RowList& rows) const;

  virtual void askObject(const Object3D& object, std::uint32_t order, const RowList& rows) = 0;
  /// The shapes are in the order of the scene.
  virtual void askShapes(const ShapeNumbers* shapes, int count, const RowList& rows) = 0;
  void askTree(const AskedTree& tree, const RowList& rows);
  /// One of these, by what it is.
  void askMember(const TreeMember& member, const RowList& rows);

  const RayTable& rays() const { return rays_; }
  Arena& arena() const { return arena_; }

  /// Adds to the tally, if there is one, what an answer has taken.
  virtual void count(const TestCounts& counts) const {
    if (kernels_.tally) kernels_.tally->addShadow(counts);
  }

 protected:
  Question(const Kernels& kernels, const RayTable& rays, Arena& arena)
      : kernels_(kernels), rays_(rays), arena_(arena) {}

  class Walk;
  /// The rays as they walk a tree.
  virtual const RayTable& raysFor(const AskedTree& /*tree*/) const { return rays_; }
  virtual void walk(const AskedTree& tree, Stream& stream) = 0;
  virtual void askInside(const TreeMember& member, const RowList& rows) = 0;

  /// The listed rays as they are inside of a Transform of this inverse, one row for each.
  RayTable movedBy(const Matrix& inverse, const RowList& rows) const;

  const Kernels& kernels_;
  const RayTable& rays_;
  Arena& arena_;

 private:
  /// askTree for a few rays, at least one, that walk together; the tree is not empty.
  void askStream(const AskedTree& tree, const RowList& rows);
};

/// Object3D::intersect: lowers tmax to the t of each new hit, and sets its row of `hits`.
class NearestQuestion : public Question {
 public:
  NearestQuestion(const Kernels& kernels, const RayTable& rays, HitTable& hits, Arena& arena)
      : Question(kernels, rays, arena), hits_(hits) {}
  void askObject(const Object3D& object, std::uint32_t order, const RowList& rows) override;
  void askShapes(const ShapeNumbers* shapes, int count, const RowList& rows) override;
  void count(const TestCounts& counts) const override {
    if (kernels_.tally) kernels_.tally->addNearest(counts);
  }

 private:
  class NearestWalk;
  void walk(const AskedTree& tree, Stream& stream) override;
  void askInside(const TreeMember& member, const RowList& rows) override;

  HitTable& hits_;
};

/// Object3D::occluded: sets blocked[row] where anything is hit between tmin and tmax, and leaves
/// the others as they are.
class OccludedQuestion : public Question {
 public:
  OccludedQuestion(const Kernels& kernels, const RayTable& rays, bool* blocked, Arena& arena)
      : Question(kernels, rays, arena), blocked_(blocked) {}
  RowList openOf(const RowList& rows) const override;
  void askObject(const Object3D& object, std::uint32_t order, const RowList& rows) override;
  void askShapes(const ShapeNumbers* shapes, int count, const RowList& rows) override;

 private:
  class OccludedWalk;
  void walk(const AskedTree& tree, Stream& stream) override;
  void askInside(const TreeMember& member, const RowList& rows) override;

  bool* blocked_;
};

/// BatchGeometry::visitAllCrossings. tmin is 0.
class CrossingsQuestion : public Question {
 public:
  CrossingsQuestion(const Kernels& kernels, const RayTable& rays, RowCrossingVisitor& visitor,
                    Arena& arena);
  void askObject(const Object3D& object, std::uint32_t order, const RowList& rows) override;
  void askShapes(const ShapeNumbers* shapes, int count, const RowList& rows) override;

 private:
  class CrossingsWalk;
  const RayTable& raysFor(const AskedTree& tree) const override {
    return tree.isOneObject() ? endless_ : rays_;
  }
  void walk(const AskedTree& tree, Stream& stream) override;
  void askInside(const TreeMember& member, const RowList& rows) override;

  RowCrossingVisitor& visitor_;
  RayTable endless_;  // the rays, with infinite tmax
};

}  // namespace accel
