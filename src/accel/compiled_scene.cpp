// CompiledScene: turns the tree of objects into ObjectTrees and MeshTrees, once, before tracing.
//
//   1. Groups are dissolved: what is above the outermost Transforms becomes the root's ObjectTree,
//      and what is inside a Transform, down to the next ones, an ObjectTree of its own. So matrices
//      stay apart, and a ray is moved by exactly the multiplications of the plain objects.
//   2. Each mesh gets a tree over its triangles, shared by all that have the same geometry; very
//      small ones stay plain. A Transform of just a mesh leads straight to the mesh's tree.
//   3. Members are numbered in scene order: of two hits at the same t the lower number wins.
//   4. Where a chain of Transforms takes rays to numbers that squares do not survive (RayRange), or
//      a ray starts further off than that, the plain objects are asked.
// The kernels are those of the widest instruction set that the processor has, or that is wanted.
#include "accel/compiled_scene.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <map>
#include <sstream>

#include "accel/mesh_tree.h"
#include "accel/object_tree.h"
#include "accel/transform_range.h"
#include "geometry/group.h"

namespace {

using accel::Kernels;
using accel::MeshTree;
using accel::ObjectTree;
using accel::Question;
using accel::RayRange;
using accel::TreeMember;

/// The rows of the rays that start near enough, or of the others.
RowList heldRows(const RayTable& rays, bool areHeld, Arena& arena) {
  auto* rows = arena.take<std::uint16_t>(std::size_t(rays.count));
  int count = 0;
  for (int row = 0; row < rays.count; ++row) {
    rows[count] = std::uint16_t(row);
    count += RayRange::holds(rays.originOf(row)) == areHeld ? 1 : 0;
  }
  return {rows, count};
}

/// For questions of one ray, whose caller gives none: one for each took 1.27 of the instructions of
/// a heatmap.
Arena& arenaOfThread() {
  thread_local Arena arena;
  return arena;
}

/// A mesh of fewer triangles is asked triangle by triangle: a walk takes longer than these few.
constexpr std::uint32_t kSmallMesh = 4;

Kernels kernelsOf(SimdLevel level) {
  if (level == SimdLevel::avx512) return accel::avx512::kernels();
  return level == SimdLevel::avx2 ? accel::avx2::kernels() : accel::baseline::kernels();
}

}  // namespace

struct CompiledScene::Trees {
  Trees(SimdLevel simd, int threadCount, TestTally* tally)
      : level(simd), kernels(kernelsOf(simd)), threads(threadCount) {
    kernels.tally = tally;
  }

  /// Asks everything for all rays; the plain objects for those that start too far off.
  void ask(Question& question, const Object3D& plain) const {
    const RayTable& rays = question.rays();
    Arena& arena = question.arena();
    const Arena::Frame frame(arena);
    if (kernels.areHeld(rays)) return root.ask(question, RowList::all(rays.count, arena));
    root.ask(question, heldRows(rays, true, arena));
    question.askObject(plain, 0, heldRows(rays, false, arena));
  }

  /// Adds `object` and all below it to `tree`, where rays are within `range`. The depth of
  /// recursion is the scene's nesting.
  void add(ObjectTree& tree, const Object3D* object, const RayRange& range) {
    if (const auto* group = exactly<Group>(object)) {
      for (const Object3D* member : group->getObjects()) {
        if (member) add(tree, member, range);
      }
      return;
    }
    TreeMember member{};
    member.object = object;
    member.order = nextOrder++;
    accel::TransformError error;
    if (const auto* mesh = exactly<TriangleMesh>(object)) {
      addMesh(member, *mesh);
    } else if (const auto* transform = exactly<Transform>(object)) {
      error = addTransform(member, *transform, range.inside(*transform));
    }
    tree.add(member, error);
  }

  void addMesh(TreeMember& member, const TriangleMesh& mesh) {
    if (mesh.getGeometry().faceCount() < kSmallMesh) return;
    member.kind = TreeMember::Kind::mesh;
    member.mesh = &mesh;
    const MeshGeometry& geometry = mesh.getGeometry();
    member.meshTree = &meshTrees.try_emplace(&geometry, geometry, threads).first->second;
  }

  /// Where the Transform takes rays out of `range`, it stays plain. Returns its error.
  accel::TransformError addTransform(TreeMember& member, const Transform& transform,
                                     const RayRange& range) {
    const Object3D* inside = transform.getObject();
    accel::TransformError error;
    if (const auto* mesh = exactly<TriangleMesh>(inside)) {
      addMesh(member, *mesh);
      const bool isTree = member.kind == TreeMember::Kind::mesh;
      if (isTree && !range.fits(member.meshTree->bvh().scale))
        member.kind = TreeMember::Kind::plain;
    } else if (exactly<Group>(inside) || exactly<Transform>(inside)) {
      ObjectTree& tree = objectTrees.emplace_back();
      add(tree, inside, range);
      tree.finish(threads);
      error = tree.error();
      if (tree.fits(range)) {
        member.kind = TreeMember::Kind::tree;
        member.objectTree = &tree;
      }
    }
    if (member.kind != TreeMember::Kind::plain) member.inverse = &transform.getInverse();
    return accel::errorThrough(transform, error);
  }

  const SimdLevel level;
  Kernels kernels;
  const int threads;
  std::uint32_t nextOrder = 0;
  std::map<const MeshGeometry*, MeshTree> meshTrees;
  std::deque<ObjectTree> objectTrees;  // those inside Transforms
  ObjectTree root;
};

CompiledScene::CompiledScene(const Object3D& root, int threads, SimdLevel simd, TestTally* tally)
    : BatchGeometry(root), root_(&root) {
  auto trees = std::make_unique<Trees>(availableSimd(simd), threads, tally);
  trees->add(trees->root, &root, {});
  trees->root.finish(threads);
  trees_ = std::move(trees);
}

CompiledScene::~CompiledScene() = default;

bool CompiledScene::intersect(const Ray& ray, Hit& hit, double tmin) const {
  Arena& arena = arenaOfThread();
  const Arena::Frame frame(arena);
  RayTable rays(arena, 1, true);
  rays.setRow(0, ray, tmin, hit.getT());
  HitTable hits(arena, 1);
  intersectAll(rays, hits, arena);
  if (!hits.isFound(0)) return false;
  hit = hits.hitOf(0, rays.tmax[0]);
  return true;
}

bool CompiledScene::occluded(const Ray& ray, double tmin, double tmax) const {
  Arena& arena = arenaOfThread();
  const Arena::Frame frame(arena);
  RayTable rays(arena, 1, true);
  rays.setRow(0, ray, tmin, tmax);
  bool isBlocked = false;
  occludedAll(rays, &isBlocked, arena);
  return isBlocked;
}

void CompiledScene::intersectAll(const RayTable& rays, HitTable& hits, Arena& arena) const {
  accel::NearestQuestion question(trees_->kernels, rays, hits, arena);
  trees_->ask(question, *root_);
}

void CompiledScene::occludedAll(const RayTable& rays, bool* blocked, Arena& arena) const {
  std::fill(blocked, blocked + rays.count, false);
  accel::OccludedQuestion question(trees_->kernels, rays, blocked, arena);
  trees_->ask(question, *root_);
}

void CompiledScene::visitCrossings(const Ray& ray, CrossingVisitor& visitor) const {
  struct FirstRow : RowCrossingVisitor {
    CrossingVisitor& visitor;
    explicit FirstRow(CrossingVisitor& v) : visitor(v) {}
    void visit(int, const Crossing& crossing) override { visitor.visit(crossing); }
  } first(visitor);
  Arena& arena = arenaOfThread();
  const Arena::Frame frame(arena);
  RayTable rays(arena, 1, true);
  rays.setRow(0, ray, 0, Hit().getT());
  visitAllCrossings(rays, first, arena);
}

void CompiledScene::visitAllCrossings(const RayTable& rays, RowCrossingVisitor& visitor,
                                      Arena& arena) const {
  const Arena::Frame frame(arena);
  // All crossings at t > 0 count.
  RayTable whole = rays;
  whole.tmin = arena.take<double>(std::size_t(rays.count));
  std::fill(whole.tmin, whole.tmin + rays.count, 0.0);
  accel::CrossingsQuestion question(trees_->kernels, whole, visitor, arena);
  trees_->ask(question, *root_);
}

SimdLevel CompiledScene::simdLevel() const { return trees_->level; }

std::size_t CompiledScene::treeBytes() const {
  std::size_t bytes = trees_->root.bytes();
  for (const auto& tree : trees_->meshTrees) bytes += tree.second.bvh().bytes();
  for (const ObjectTree& tree : trees_->objectTrees) bytes += tree.bytes();
  return bytes;
}

std::string CompiledScene::describe() const {
  std::ostringstream text;
  text << "eight-wide trees, " << nameOf(trees_->level) << "; " << trees_->meshTrees.size()
       << " mesh trees, " << trees_->objectTrees.size() + 1 << " object trees, " << treeBytes()
       << " bytes";
  return text.str();
}
