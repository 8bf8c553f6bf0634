// Questions to a mesh's tree.
//
// A kernel walks the tree with floats (stream.h) and leaves candidates. Here the one double
// function of triangles decides them, on corners that the leaf holds exactly or the mesh is asked
// for. So t, face and normal are those of the plain mesh, whatever the instruction set.
//   nearest    When the walk is over, what begins behind a ray's bound has dropped out. Where one
//              candidate is left and it is proven, nothing is to be decided; else each is asked.
//              The hits of all winners are then computed together.
//   occluded   Any candidate that is hit between tmin and tmax blocks its ray.
//   crossings  Nothing is ruled out by distance: every face that may be crossed is asked.
// Where more candidates come than are kept, they are decided while the walk goes on.
#include "accel/mesh_questions.h"

#include <algorithm>

#include "geometry/triangle.h"

namespace accel {
namespace {

/// The rays of one stream, asking one mesh.
class MeshQuestion {
 public:
  MeshQuestion(const MeshInScene& asked, Stream& stream) : asked_(asked), stream_(stream) {}
  /// A mesh has no leaves of objects.
  static void askObject(Stream&, std::uint32_t, const std::uint16_t*, int) {}

 protected:
  MeshTree::Triangle triangleOf(const Candidate& c) const {
    return asked_.tree.triangleAt(stream_.words + c.leaf, c.lane);
  }
  /// True where the ray hits the triangle at a t above tmin. Where it leaves the face, the next one
  /// with the same corners takes its place.
  bool isHit(const Candidate& c, MeshTree::Triangle& corners, double& t) const {
    const int row = stream_.rowOf(c.ray);
    const Ray ray = stream_.rays->rayOf(row);
    if (ray.leaves(&asked_.mesh, corners.face)) {
      const FaceCopies* copies = asked_.tree.copiesOf(corners.face);
      if (!copies) return false;
      corners.face = copies->next;
    }
    return triangle::intersect(corners.a, corners.b, corners.c, ray, t) &&
           t > stream_.rays->tmin[row];
  }

  const MeshInScene& asked_;
  Stream& stream_;
};

class NearestInMesh : public MeshQuestion {
 public:
  NearestInMesh(const MeshInScene& asked, Stream& stream, HitTable& hits, Arena& arena)
      : MeshQuestion(asked, stream), hits_(hits) {
    const auto count = std::size_t(stream.count);
    winners_ = arena.take<Winner>(count);
    std::fill(winners_, winners_ + count, Winner{0, 0, 0});
    survivors_ = arena.take<std::uint8_t>(count);
    std::fill(survivors_, survivors_ + count, std::uint8_t(0));
  }

  static void resolve(Stream& stream) {
    auto& self = *static_cast<NearestInMesh*>(stream.context);
    for (int k = 0; k < stream.candidateCount; ++k) self.consider(stream.candidates[k]);
    stream.candidateCount = 0;
    self.isUndecided_ = false;
  }

  /// Decides what the walk has left, and computes the hits.
  void finish(const Kernels& kernels) {
    Candidate* const end = stream_.candidates + stream_.candidateCount;
    for (const Candidate* c = stream_.candidates; c != end; ++c) {
      if (survives(*c) && survivors_[c->ray] < 2) ++survivors_[c->ray];
    }
    for (const Candidate* c = stream_.candidates; c != end; ++c) {
      if (isUndecided_ && survivors_[c->ray] == 1 && c->isProven && survives(*c)) {
        win(*c, triangleOf(*c).face);
      } else {
        consider(*c);
      }
    }
    computeHits(kernels);
  }

 private:
  struct Winner {
    std::uint32_t leaf;  // 0: none
    std::uint32_t face;
    std::uint8_t lane;
  };

  bool survives(const Candidate& c) const { return c.tLow <= stream_.boxRays[c.ray].tmaxUp; }

  void win(const Candidate& c, std::uint32_t face) {
    winners_[c.ray] = {c.leaf, face, c.lane};
    hits_.order[stream_.rowOf(c.ray)] = asked_.order;
  }

  void consider(const Candidate& c) {
    if (!survives(c)) return;
    MeshTree::Triangle corners = triangleOf(c);
    const int row = stream_.rowOf(c.ray);
    const NearestSoFar best{stream_.rays->tmax[row], hits_.order[row], winners_[c.ray].face};
    double t;
    if (!isHit(c, corners, t) || !best.accepts(t, asked_.order, corners.face)) return;
    win(c, corners.face);
    stream_.rays->tmax[row] = t;
    stream_.lowerBound(c.ray, t);
  }

  void computeHits(const Kernels& kernels) {
    TriangleHits triangles;
    for (int ray = 0; ray < stream_.count; ++ray) {
      const Winner& winner = winners_[ray];
      if (winner.leaf == 0) continue;
      const int row = stream_.rowOf(ray);
      hits_.material[row] = asked_.mesh.getMaterial();
      hits_.object[row] = &asked_.mesh;
      hits_.face[row] = winner.face;
      triangles.add(row, asked_.tree.triangleAt(stream_.words + winner.leaf, winner.lane));
      if (triangles.count == TriangleHits::kMost) computeHits(kernels, triangles);
    }
    if (triangles.count > 0) computeHits(kernels, triangles);
  }
  void computeHits(const Kernels& kernels, TriangleHits& triangles) {
    triangles.fillUp();
    kernels.computeHits(triangles, *stream_.rays, hits_);
    triangles.count = 0;
  }

  HitTable& hits_;
  Winner* winners_;          // of each ray
  std::uint8_t* survivors_;  // of each ray, two at most
  bool isUndecided_ = true;  // no ray has been decided yet
};

struct OccludedByMesh : MeshQuestion {
  using MeshQuestion::MeshQuestion;

  static void resolve(Stream& stream) {
    const auto& self = *static_cast<const OccludedByMesh*>(stream.context);
    for (int k = 0; k < stream.candidateCount; ++k) {
      const Candidate& c = stream.candidates[k];
      if (stream.hasEnded(c.ray)) continue;
      MeshTree::Triangle corners = self.triangleOf(c);
      double t;
      if (self.isHit(c, corners, t) && t < stream.rays->tmax[stream.rowOf(c.ray)]) {
        stream.end(c.ray);
      }
    }
    stream.candidateCount = 0;
  }
};

struct CrossingsOfMesh : MeshQuestion {
  CrossingsOfMesh(const MeshInScene& asked, Stream& stream, RowCrossingVisitor& crossings)
      : MeshQuestion(asked, stream), visitor(crossings) {}

  static void resolve(Stream& stream) {
    const auto& self = *static_cast<const CrossingsOfMesh*>(stream.context);
    for (int k = 0; k < stream.candidateCount; ++k) {
      const Candidate& c = stream.candidates[k];
      const int row = stream.rowOf(c.ray);
      CrossingsOfRow crossings(row, self.visitor);
      const std::uint32_t face = self.triangleOf(c).face;
      const FaceCopies* copies = self.asked_.tree.copiesOf(face);
      self.asked_.mesh.visitFace(face, stream.rays->rayOf(row), crossings,
                                 copies ? copies->count : 1);
    }
    stream.candidateCount = 0;
  }

  RowCrossingVisitor& visitor;
};

}  // namespace

void nearestInMesh(const Kernels& kernels, const MeshInScene& asked, const RayTable& rays,
                   const RowList& list, HitTable& hits, Arena& arena) {
  if (asked.tree.bvh().isEmpty()) return;
  const Arena::Frame frame(arena);
  Stream stream(asked.tree.bvh(), rays, list, arena);
  kernels.prepare(stream);
  if (stream.count == 0) return;
  NearestInMesh question(asked, stream, hits, arena);
  stream.attach(question);
  kernels.nearest(stream);
  kernels.countNearest(stream);
  question.finish(kernels);
}

void occludedByMesh(const Kernels& kernels, const MeshInScene& asked, const RayTable& rays,
                    const RowList& list, bool* blocked, Arena& arena) {
  if (asked.tree.bvh().isEmpty()) return;
  const Arena::Frame frame(arena);
  Stream stream(asked.tree.bvh(), rays, list, arena);
  kernels.prepare(stream);
  OccludedByMesh question(asked, stream);
  stream.attach(question);
  kernels.any(stream);
  kernels.countShadow(stream);
  OccludedByMesh::resolve(stream);
  stream.markEnded(blocked);
}

void visitMeshCrossings(const Kernels& kernels, const MeshInScene& asked, const RayTable& rays,
                        const RowList& list, RowCrossingVisitor& visitor, Arena& arena) {
  if (asked.tree.bvh().isEmpty()) return;
  const Arena::Frame frame(arena);
  Stream stream(asked.tree.bvh(), rays, list, arena);
  kernels.prepare(stream);
  CrossingsOfMesh question(asked, stream, visitor);
  stream.attach(question);
  kernels.all(stream);
  kernels.countShadow(stream);
  CrossingsOfMesh::resolve(stream);
}

}  // namespace accel
