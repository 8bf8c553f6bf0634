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
#include <deque>
#include <map>
#include <sstream>

#include "accel/exact_type.h"
#include "accel/mesh_tree.h"
#include "accel/object_tree.h"
#include "accel/packet.h"
#include "accel/transform_range.h"
#include "geometry/group.h"

namespace {

using accel::Kernels;
using accel::MeshTree;
using accel::ObjectTree;
using accel::RayRange;
using accel::TreeMember;

/// A mesh of fewer triangles is asked triangle by triangle.
constexpr std::uint32_t kSmallMesh = 4;

Kernels kernelsOf(SimdLevel level) {
  if (level == SimdLevel::avx512) return accel::avx512Kernels();
  return level == SimdLevel::avx2 ? accel::avx2Kernels() : accel::baselineKernels();
}

}  // namespace

struct CompiledScene::Trees {
  Trees(SimdLevel level, int threadCount, TestTally* tally)
      : kernels(kernelsOf(level)), threads(threadCount), root(kernels) {
    kernels.tally = tally;
  }

  /// Adds `object` and all below it to `space`, where rays are within `range`. The depth of
  /// recursion is the scene's nesting.
  void add(ObjectTree& tree, const Object3D* object, const RayRange& range) {
    if (const auto* group = accel::exactly<Group>(object)) {
      for (const Object3D* member : group->getObjects()) {
        if (member) add(tree, member, range);
      }
      return;
    }
    TreeMember member{};
    member.object = object;
    member.order = nextOrder++;
    accel::TransformError error;
    if (const auto* mesh = accel::exactly<TriangleMesh>(object)) {
      addMesh(member, *mesh, TreeMember::Kind::mesh);
    } else if (const auto* transform = accel::exactly<Transform>(object)) {
      error = addTransform(member, *transform, range.inside(*transform));
    }
    tree.add(member, error);
  }

  void addMesh(TreeMember& member, const TriangleMesh& mesh, TreeMember::Kind kind) {
    if (mesh.getGeometry().faceCount() < kSmallMesh) return;
    member.kind = kind;
    const MeshGeometry& geometry = mesh.getGeometry();
    member.meshTree = &meshTrees.try_emplace(&geometry, geometry, threads).first->second;
  }

  /// Where the Transform takes rays out of `range`, it stays plain. Returns its error.
  accel::TransformError addTransform(TreeMember& member, const Transform& transform,
                                     const RayRange& range) {
    const Object3D* inside = transform.getObject();
    accel::TransformError error;
    if (const auto* mesh = accel::exactly<TriangleMesh>(inside)) {
      addMesh(member, *mesh, TreeMember::Kind::transformedMesh);
      const bool isTree = member.kind == TreeMember::Kind::transformedMesh;
      if (isTree && !range.fits(member.meshTree->bvh().scale))
        member.kind = TreeMember::Kind::plain;
    } else if (accel::exactly<Group>(inside) || accel::exactly<Transform>(inside)) {
      ObjectTree& tree = objectTrees.emplace_back(kernels);
      add(tree, inside, range);
      tree.finish(threads);
      error = tree.error();
      if (range.fits(tree.bvh().scale)) {
        member.kind = TreeMember::Kind::transformedTree;
        member.objectTree = &tree;
      }
    }
    return accel::errorThrough(transform, error);
  }

  Kernels kernels;
  const int threads;
  std::uint32_t nextOrder = 0;
  std::map<const MeshGeometry*, MeshTree> meshTrees;
  std::deque<ObjectTree> objectTrees;  // those inside Transforms
  ObjectTree root;
};

SimdLevel availableSimd(SimdLevel wanted) {
  SimdLevel best = SimdLevel::baseline;
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") &&
      __builtin_cpu_supports("bmi") && __builtin_cpu_supports("bmi2")) {
    best = SimdLevel::avx2;
  }
  if (best == SimdLevel::avx2 && __builtin_cpu_supports("avx512f") &&
      __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512dq") &&
      __builtin_cpu_supports("avx512bw")) {
    best = SimdLevel::avx512;
  }
#endif
  return wanted == SimdLevel::automatic || wanted > best ? best : wanted;
}

const char* nameOf(SimdLevel level) {
  constexpr const char* kNames[] = {"auto", "baseline", "avx2", "avx512"};
  return kNames[int(level)];
}

CompiledScene::CompiledScene(const Object3D& root, int threads, SimdLevel simd, TestTally* tally)
    : root_(&root) {
  auto trees = std::make_unique<Trees>(availableSimd(simd), threads, tally);
  trees->add(trees->root, &root, {});
  trees->root.finish(threads);
  trees_ = std::move(trees);
}

CompiledScene::~CompiledScene() = default;

bool CompiledScene::intersect(const Ray& ray, Hit& hit, double tmin) const {
  if (!RayRange::holds(ray)) return root_->intersect(ray, hit, tmin);
  accel::NearestQuery query{&hit, tmin, hit.getT()};
  return trees_->root.nearest(ray, query);
}

bool CompiledScene::occluded(const Ray& ray, double tmin, double tmax) const {
  if (!RayRange::holds(ray)) return root_->occluded(ray, tmin, tmax);
  return trees_->root.occluded(ray, tmin, tmax);
}

void CompiledScene::intersectBatch(const Ray* rays, const double* tmins, int count,
                                   Hit* hits) const {
  constexpr int kMost = accel::RayPacket::kMostRays;
  for (int first = 0; first < count; first += kMost) {
    accel::NearestQuery queries[kMost];
    const int some = std::min(kMost, count - first);
    bool allHeld = true;
    for (int i = 0; i < some; ++i) {
      queries[i] = {hits + first + i, tmins[first + i], hits[first + i].getT()};
      allHeld &= RayRange::holds(rays[first + i]);
    }
    if (allHeld) {
      trees_->root.nearest(rays + first, some, queries);
      continue;
    }
    for (int i = first; i < first + some; ++i) intersect(rays[i], hits[i], tmins[i]);
  }
}

void CompiledScene::occludedBatch(const ShadowQuery* queries, int count, bool* blocked) const {
  constexpr int kMost = accel::RayPacket::kMostRays;
  for (int first = 0; first < count; first += kMost) {
    const int some = std::min(kMost, count - first);
    const bool allHeld =
        std::all_of(queries + first, queries + first + some,
                    [](const ShadowQuery& query) { return RayRange::holds(query.ray); });
    if (allHeld) {
      const std::uint64_t bits = trees_->root.occluded(queries + first, some);
      for (int i = 0; i < some; ++i) blocked[first + i] = (bits >> i & 1) != 0;
      continue;
    }
    for (int i = first; i < first + some; ++i) {
      blocked[i] = occluded(queries[i].ray, queries[i].tmin, queries[i].tmax);
    }
  }
}

void CompiledScene::visitCrossings(const Ray& ray, CrossingVisitor& visitor) const {
  if (!RayRange::holds(ray)) return root_->visitCrossings(ray, visitor);
  trees_->root.visitCrossings(ray, visitor);
}

std::size_t CompiledScene::treeBytes() const {
  std::size_t bytes = trees_->root.bvh().bytes();
  for (const auto& tree : trees_->meshTrees) bytes += tree.second.bvh().bytes();
  for (const ObjectTree& tree : trees_->objectTrees) bytes += tree.bvh().bytes();
  return bytes;
}

std::string CompiledScene::describe() const {
  std::ostringstream text;
  text << "eight-wide trees, " << trees_->kernels.name << "; " << trees_->meshTrees.size()
       << " mesh trees, " << trees_->objectTrees.size() + 1 << " spaces, " << treeBytes()
       << " bytes";
  return text.str();
}
