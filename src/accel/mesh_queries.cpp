// Questions of one ray to a mesh's tree.
//
// A kernel walks the tree with floats (traversal.h). Triangles that its error bounds rule out are
// never looked at again; one that is surely hit nearer than all before lowers the ray's end; the
// rest become Candidates, up to 16 at a time. `resolve` decides those with the one double function
// of triangles, on corners that the leaf holds exactly or the mesh is asked for. So t, face and
// normal are those of the plain mesh, whatever the instruction set; the kernel only saves work.
//   nearest    the winner's hit is computed once, when the walk is over
//   occluded   any candidate between tmin and tmax ends the walk
//   crossings  nothing is ruled out by distance: every face that may be crossed is asked
#include <algorithm>
#include <limits>

#include "accel/mesh_query.h"
#include "geometry/triangle.h"

namespace accel {
namespace {

bool noObject(TraversalRay&, std::uint32_t) { return false; }

struct CrossingsOfMesh {
  const MeshTree& tree;
  const TriangleMesh& mesh;
  const Ray& ray;
  CrossingVisitor& visitor;

  static bool resolve(TraversalRay& r) {
    const auto& self = *static_cast<const CrossingsOfMesh*>(r.context);
    for (int i = 0; i < r.candidateCount; ++i) {
      const Candidate& c = r.candidates[i];
      self.mesh.visitFace(self.tree.triangleAt(c.words, c.lane).face, self.ray, self.visitor);
    }
    r.candidateCount = 0;
    return false;
  }
};

}  // namespace

bool MeshQuery::decide(const Candidate& c, MeshTree::Triangle& corners, double& t) const {
  corners = tree->triangleAt(c.words, c.lane);
  return !ray->leaves(mesh, corners.face) &&
         triangle::intersect(corners.a, corners.b, corners.c, *ray, t);
}

bool NearestInMesh::resolve(TraversalRay& r) {
  auto& self = *static_cast<NearestInMesh*>(r.context);
  for (int i = 0; i < r.candidateCount; ++i) {
    if (r.candidates[i].tLow <= r.tmaxUp) self.consider(r.candidates[i]);
  }
  r.candidateCount = 0;
  if (self.found) r.tmaxUp = std::min(r.tmaxUp, self.time.above(self.query->t));
  return false;
}

void NearestInMesh::consider(const Candidate& c) {
  MeshTree::Triangle corners;
  double t;
  if (!decide(c, corners, t) || !(t > query->tmin) || !query->accepts(t, order, corners.face)) {
    return;
  }
  query->found(t, order, corners.face);
  winner = c;
  found = true;
}

bool NearestInMesh::ask(const Kernels& kernels, TraversalRay& r) {
  r.resolve = resolve;
  r.askObject = noObject;
  r.context = this;
  kernels.nearest(r);
  kernels.countNearest(r);
  resolve(r);
  if (!found) return false;
  const MeshTree::Triangle corners = tree->triangleAt(winner.words, winner.lane);
  mesh->setHit(corners.face, corners.a, corners.b, corners.c, *ray, query->t, *query->hit);
  return true;
}

bool OccludedByMesh::ask(const Kernels& kernels, TraversalRay& r) {
  r.resolve = resolve;
  r.askObject = noObject;
  r.context = this;
  const bool isBlocked = kernels.any(r);
  kernels.countShadow(r);
  return isBlocked;
}

bool OccludedByMesh::resolve(TraversalRay& r) {
  const auto& self = *static_cast<const OccludedByMesh*>(r.context);
  const int count = r.candidateCount;
  r.candidateCount = 0;
  return std::any_of(r.candidates, r.candidates + count, [&](const Candidate& c) {
    MeshTree::Triangle corners;
    double t;
    return self.decide(c, corners, t) && t > self.tmin && t < self.tmax;
  });
}

bool nearestInMesh(const Kernels& kernels, const MeshTree& tree, const TriangleMesh& mesh,
                   std::uint32_t order, const Ray& ray, NearestQuery& query) {
  TraversalRay r;
  NearestInMesh self{{&tree, &mesh, &ray}, &query, order, {}};
  return !tree.bvh().isEmpty() &&
         prepareRay(kernels, tree.bvh(), ray, query.tmin, query.t, r, self.time) &&
         self.ask(kernels, r);
}

bool occludedByMesh(const Kernels& kernels, const MeshTree& tree, const TriangleMesh& mesh,
                    const Ray& ray, double tmin, double tmax) {
  TraversalRay r;
  ParameterMap time;
  return !tree.bvh().isEmpty() && prepareRay(kernels, tree.bvh(), ray, tmin, tmax, r, time) &&
         OccludedByMesh{{&tree, &mesh, &ray}, tmin, tmax}.ask(kernels, r);
}

void visitMeshCrossings(const Kernels& kernels, const MeshTree& tree, const TriangleMesh& mesh,
                        const Ray& ray, CrossingVisitor& visitor) {
  TraversalRay r;
  ParameterMap time;
  CrossingsOfMesh self{tree, mesh, ray, visitor};
  if (tree.bvh().isEmpty() ||
      !prepareRay(kernels, tree.bvh(), ray, 0, std::numeric_limits<double>::infinity(), r, time)) {
    return;
  }
  r.resolve = CrossingsOfMesh::resolve;
  r.askObject = noObject;
  r.context = &self;
  kernels.all(r);
  kernels.countShadow(r);
  CrossingsOfMesh::resolve(r);
}

}  // namespace accel
