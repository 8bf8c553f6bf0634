// Batches of rays in a mesh's tree: packets where the rays pass one point, single rays elsewhere.
#include <algorithm>
#include <cmath>
#include <limits>

#include "accel/mesh_tree.h"
#include "accel/packet.h"
#include "accel/prepare_packet.h"
#include "accel/space.h"
#include "geometry/triangle_test.h"

namespace accel {
namespace {

/// Fewer rays than this do not pay for a packet.
constexpr int kFewRays = 8;

/// The beam of rays from one point; false where they do not start from one.
bool beamOfRays(const Ray* rays, int count, const NearestQuery* queries, Beam& beam) {
  beam.point = rays[0].getOrigin();
  beam.spread = 0;
  beam.count = count;
  for (int i = 0; i < count; ++i) {
    if (rays[i].getOrigin() != beam.point) return false;
    beam.directions[i] = rays[i].getDirection();
    beam.tmin[i] = queries[i].tmin;
    beam.tmax[i] = queries[i].t;
  }
  return true;
}

/// The beam of shadow rays that end in one point; false where they do not.
bool beamOfShadows(const ShadowQuery* queries, int count, Beam& beam) {
  const ShadowQuery& first = queries[0];
  beam.point = first.ray.pointAtParameter(first.tmax);
  beam.spread = 0;
  beam.count = count;
  for (int i = 0; i < count; ++i) {
    const ShadowQuery& query = queries[i];
    const Vec3d& origin = query.ray.getOrigin();
    const Vec3d& direction = query.ray.getDirection();
    const double largest = std::max(maxAbs(origin), query.tmax * maxAbs(direction));
    if (!(largest <= std::numeric_limits<double>::max())) return false;  // a lamp at no place
    const double distance = maxAbs(query.ray.pointAtParameter(query.tmax) - beam.point);
    if (!(distance <= largest * 0x1p-48)) return false;
    beam.spread = std::max(beam.spread, distance + largest * 0x1p-51);  // and its rounding
    beam.directions[i] = direction;
    beam.tmin[i] = query.tmin - query.tmax;
    beam.tmax[i] = 0;
  }
  return true;
}

/// Decides in double what a packet has found for one ray: a triangle that is proven to be hit,
/// and others that may be.
class PacketAnswer {
 public:
  PacketAnswer(const MeshTree& tree, const TriangleMesh& mesh, const RayPacket& packet, int i,
               const Ray& ray)
      : tree_(tree), mesh_(mesh), packet_(packet), i_(i), ray_(ray) {}

  bool nearest(std::uint32_t order, NearestQuery& query) const {
    MeshTree::Triangle winner{};
    bool found = false;
    forEach([&](const MeshTree::Triangle& corners, double t) {
      if (!(t > query.tmin) || !query.accepts(t, order, corners.face)) return false;
      query.t = t;
      query.order = order;
      query.part = corners.face;
      winner = corners;
      found = true;
      return false;
    });
    if (found) {
      mesh_.setHit(winner.face, winner.a, winner.b, winner.c, ray_, query.t, *query.hit);
    }
    return found;
  }

  bool occluded(double tmin, double tmax) const {
    return forEach([&](const MeshTree::Triangle&, double t) { return t > tmin && t < tmax; });
  }

 private:
  /// Calls use(triangle, t) for each triangle that is hit, until one call returns true.
  template <class Use>
  bool forEach(const Use& use) const {
    const auto decide = [&](std::uint32_t leaf, std::uint32_t lane) {
      const MeshTree::Triangle corners = tree_.triangleAt(packet_.leaves + leaf, int(lane));
      double t;
      return !ray_.leaves(&mesh_, corners.face) &&
             triangle::intersect(corners.a, corners.b, corners.c, ray_, t) && use(corners, t);
    };
    if (packet_.leafOf[i_] != 0 && decide(packet_.leafOf[i_], packet_.laneOf[i_])) return true;
    for (int k = 0; k < packet_.doubtCount[i_]; ++k) {
      const RayPacket::Doubt& doubt = packet_.doubts[i_][k];
      if (doubt.tLow <= packet_.tmaxUp[i_] && decide(doubt.leaf, doubt.lane)) return true;
    }
    return false;
  }

  const MeshTree& tree_;
  const TriangleMesh& mesh_;
  const RayPacket& packet_;
  const int i_;
  const Ray& ray_;
};

}  // namespace

std::uint64_t nearestInMesh(const Kernels& kernels, const MeshTree& tree, const TriangleMesh& mesh,
                            std::uint32_t order, const Ray* rays, int count,
                            NearestQuery* queries) {
  Beam beam;
  RayPacket packet;
  const bool together = count >= kFewRays && !tree.bvh().isEmpty() &&
                        beamOfRays(rays, count, queries, beam) &&
                        preparePacket(tree.bvh(), beam, packet);
  if (together) kernels.nearestOfPacket(packet);
  std::uint64_t found = 0;
  for (int i = 0; i < count; ++i) {
    bool hit;
    if (!together || (packet.open >> i & 1) != 0) {
      hit = nearestInMesh(kernels, tree, mesh, order, rays[i], queries[i]);
    } else {
      hit = (packet.leafOf[i] != 0 || packet.doubtCount[i] != 0) &&
            PacketAnswer(tree, mesh, packet, i, rays[i]).nearest(order, queries[i]);
    }
    found |= std::uint64_t(hit) << i;
  }
  return found;
}

std::uint64_t occludedByMesh(const Kernels& kernels, const MeshTree& tree, const TriangleMesh& mesh,
                             const ShadowQuery* queries, int count) {
  Beam beam;
  RayPacket packet;
  const bool together = count >= kFewRays && !tree.bvh().isEmpty() &&
                        beamOfShadows(queries, count, beam) &&
                        preparePacket(tree.bvh(), beam, packet);
  if (together) kernels.anyOfPacket(packet);
  std::uint64_t blocked = together ? packet.blocked : 0;
  for (int i = 0; i < count; ++i) {
    if ((blocked >> i & 1) != 0) continue;
    const ShadowQuery& query = queries[i];
    bool hit;
    if (!together || (packet.open >> i & 1) != 0) {
      hit = occludedByMesh(kernels, tree, mesh, query.ray, query.tmin, query.tmax);
    } else {
      hit = packet.doubtCount[i] != 0 &&
            PacketAnswer(tree, mesh, packet, i, query.ray).occluded(query.tmin, query.tmax);
    }
    blocked |= std::uint64_t(hit) << i;
  }
  return blocked;
}

}  // namespace accel
