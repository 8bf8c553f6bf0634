// Batches of rays in a space: meshes take them together, other objects one by one.
#include <algorithm>

#include "accel/packet.h"
#include "accel/space.h"

namespace accel {
namespace {

using Bits = std::uint64_t;
constexpr int kMost = RayPacket::kMostRays;

const TriangleMesh& meshInside(const Entry& entry, const Transform& transform) {
  return static_cast<const TriangleMesh&>(
      entry.kind == Entry::Kind::movedMesh ? *transform.getObject() : *entry.object);
}

Bits nearestInMovedMesh(const Kernels& kernels, const Entry& entry, const Ray* rays, int count,
                        NearestQuery* queries) {
  const auto& transform = static_cast<const Transform&>(*entry.object);
  Ray moved[kMost];
  for (int i = 0; i < count; ++i) moved[i] = transform.toObject(rays[i]);
  const Bits found = nearestInMesh(kernels, *entry.mesh, meshInside(entry, transform), entry.order,
                                   moved, count, queries);
  for (int i = 0; i < count; ++i) {
    if ((found >> i & 1) != 0) transform.toParent(rays[i], *queries[i].hit);
  }
  return found;
}

Bits occludedByMovedMesh(const Kernels& kernels, const Entry& entry, const ShadowQuery* queries,
                         int count) {
  const auto& transform = static_cast<const Transform&>(*entry.object);
  ShadowQuery moved[kMost];
  for (int i = 0; i < count; ++i) {
    moved[i] = {transform.toObject(queries[i].ray), queries[i].tmin, queries[i].tmax};
  }
  return occludedByMesh(kernels, *entry.mesh, meshInside(entry, transform), moved, count);
}

}  // namespace

Bits Space::nearest(const Ray* rays, int count, NearestQuery* queries) const {
  Bits found = 0;
  for (const std::uint32_t id : direct_) {
    const Entry& entry = entries_[id];
    if (entry.kind == Entry::Kind::mesh) {
      found |=
          nearestInMesh(*kernels_, *entry.mesh, static_cast<const TriangleMesh&>(*entry.object),
                        entry.order, rays, count, queries);
    } else if (entry.kind == Entry::Kind::movedMesh) {
      found |= nearestInMovedMesh(*kernels_, entry, rays, count, queries);
    } else {
      for (int i = 0; i < count; ++i) {
        found |= Bits(nearestOf(entry, rays[i], queries[i])) << i;
      }
    }
  }
  for (int i = 0; i < count && !bvh_.isEmpty(); ++i) {
    found |= Bits(nearestInTree(rays[i], queries[i])) << i;
  }
  return found;
}

Bits Space::occluded(const ShadowQuery* queries, int count) const {
  ShadowQuery rest[kMost];  // those not known to be blocked, and their places
  int place[kMost];
  for (int i = 0; i < count; ++i) {
    rest[i] = queries[i];
    place[i] = i;
  }
  Bits blocked = 0;
  const auto drop = [&](Bits bits) {
    int kept = 0;
    for (int i = 0; i < count; ++i) {
      if ((bits >> i & 1) != 0) {
        blocked |= Bits(1) << place[i];
      } else {
        rest[kept] = rest[i];
        place[kept++] = place[i];
      }
    }
    count = kept;
  };
  const auto eachAlone = [&](const auto& isBlocked) {
    Bits bits = 0;
    for (int i = 0; i < count; ++i) bits |= Bits(isBlocked(rest[i])) << i;
    return bits;
  };
  for (const std::uint32_t id : direct_) {
    const Entry& entry = entries_[id];
    if (entry.kind == Entry::Kind::mesh) {
      drop(occludedByMesh(*kernels_, *entry.mesh, static_cast<const TriangleMesh&>(*entry.object),
                          rest, count));
    } else if (entry.kind == Entry::Kind::movedMesh) {
      drop(occludedByMovedMesh(*kernels_, entry, rest, count));
    } else {
      drop(eachAlone(
          [&](const ShadowQuery& q) { return occludedBy(entry, q.ray, q.tmin, q.tmax); }));
    }
  }
  drop(eachAlone([&](const ShadowQuery& q) { return occludedInTree(q.ray, q.tmin, q.tmax); }));
  return blocked;
}

}  // namespace accel
