// CompiledScene: turns the tree of objects into spaces, each with a tree of boxes.
#include "accel/compiled_scene.h"

#include <algorithm>
#include <deque>
#include <map>
#include <sstream>

#include "accel/exact_type.h"
#include "accel/mesh_tree.h"
#include "accel/packet.h"
#include "accel/ray_range.h"
#include "accel/space.h"
#include "geometry/group.h"

namespace {

using accel::Entry;
using accel::Kernels;
using accel::MeshTree;
using accel::RayRange;
using accel::Space;

/// A mesh of fewer triangles is asked triangle by triangle.
constexpr std::uint32_t kSmallMesh = 4;

const Kernels& kernelsOf(SimdLevel level) {
  switch (level) {
    case SimdLevel::avx512:
      return accel::avx512Kernels();
    case SimdLevel::avx2:
      return accel::avx2Kernels();
    default:
      return accel::baselineKernels();
  }
}

}  // namespace

struct CompiledScene::Content {
  Content(SimdLevel level, int threadCount, TestTally* tally)
      : kernels(kernelsOf(level)), threads(threadCount), root(kernels) {
    kernels.tally = tally;
  }

  /// Adds `object` and all below it to `space`, where rays are within `range`. The depth of
  /// recursion is the scene's nesting.
  void add(Space& space, const Object3D* object, const RayRange& range) {
    if (const auto* group = accel::exactly<Group>(object)) {
      for (const Object3D* member : group->getObjects()) {
        if (member) add(space, member, range);
      }
      return;
    }
    Entry entry{};
    entry.object = object;
    entry.order = nextOrder++;
    accel::MapNoise noise;
    if (const auto* mesh = accel::exactly<TriangleMesh>(object)) {
      addMesh(entry, *mesh, Entry::Kind::mesh);
    } else if (const auto* transform = accel::exactly<Transform>(object)) {
      noise = addTransform(entry, *transform, range.inside(*transform));
    }
    space.add(entry, noise);
  }

  void addMesh(Entry& entry, const TriangleMesh& mesh, Entry::Kind kind) {
    if (mesh.getGeometry().faceCount() < kSmallMesh) return;
    entry.kind = kind;
    entry.mesh = &treeOf(mesh.getGeometry());
  }

  /// Where the Transform takes rays out of `range`, it stays plain. Returns its noise.
  accel::MapNoise addTransform(Entry& entry, const Transform& transform, const RayRange& range) {
    const Object3D* inside = transform.getObject();
    accel::MapNoise noise;
    if (const auto* mesh = accel::exactly<TriangleMesh>(inside)) {
      addMesh(entry, *mesh, Entry::Kind::movedMesh);
      const bool isTree = entry.kind == Entry::Kind::movedMesh;
      if (isTree && !range.fits(entry.mesh->bvh().scale)) entry.kind = Entry::Kind::plain;
    } else if (accel::exactly<Group>(inside) || accel::exactly<Transform>(inside)) {
      Space& space = spaces.emplace_back(kernels);
      add(space, inside, range);
      space.finish(threads);
      noise = space.noise();
      if (range.fits(space.bvh().scale)) {
        entry.kind = Entry::Kind::movedSpace;
        entry.space = &space;
      }
    }
    return accel::noiseThrough(transform, noise);
  }

  const MeshTree& treeOf(const MeshGeometry& geometry) {
    const auto found = meshTrees.find(&geometry);
    if (found != meshTrees.end()) return found->second;
    return meshTrees.emplace(&geometry, MeshTree(geometry, threads)).first->second;
  }

  Kernels kernels;
  const int threads;
  std::uint32_t nextOrder = 0;
  std::map<const MeshGeometry*, MeshTree> meshTrees;
  std::deque<Space> spaces;  // those inside Transforms
  Space root;
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
  auto content = std::make_unique<Content>(availableSimd(simd), threads, tally);
  content->add(content->root, &root, {});
  content->root.finish(threads);
  content_ = std::move(content);
}

CompiledScene::~CompiledScene() = default;

bool CompiledScene::intersect(const Ray& ray, Hit& hit, double tmin) const {
  if (!RayRange::holds(ray)) return root_->intersect(ray, hit, tmin);
  accel::NearestQuery query{&hit, tmin, hit.getT()};
  return content_->root.nearest(ray, query);
}

bool CompiledScene::occluded(const Ray& ray, double tmin, double tmax) const {
  if (!RayRange::holds(ray)) return root_->occluded(ray, tmin, tmax);
  return content_->root.occluded(ray, tmin, tmax);
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
      content_->root.nearest(rays + first, some, queries);
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
      const std::uint64_t bits = content_->root.occluded(queries + first, some);
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
  content_->root.visitCrossings(ray, visitor);
}

void CompiledScene::addBounds(const Matrix& toWorld, BoundingBox& box) const {
  root_->addBounds(toWorld, box);
}

bool CompiledScene::isBounded() const { return root_->isBounded(); }

std::size_t CompiledScene::treeBytes() const {
  std::size_t bytes = content_->root.bvh().bytes();
  for (const auto& tree : content_->meshTrees) bytes += tree.second.bvh().bytes();
  for (const Space& space : content_->spaces) bytes += space.bvh().bytes();
  return bytes;
}

std::string CompiledScene::describe() const {
  std::ostringstream text;
  text << "eight-wide trees, " << content_->kernels.name << "; " << content_->meshTrees.size()
       << " mesh trees, " << content_->spaces.size() + 1 << " spaces, " << treeBytes() << " bytes";
  return text.str();
}
