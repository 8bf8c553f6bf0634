// Batches of rays in a mesh's tree: packets where the rays pass one point, single rays elsewhere.
//
//   1. The first rays of the batch that share a point, or nearly, are taken as a beam: eye rays the
//      eye, a flat mirror's rays the eye's picture behind it, shadow rays the lamp.
//   2. Eight or more are worth a packet, which walks the tree once for all of them. What it proves
//      is kept: for most rays one triangle that is surely the nearest, or that nothing is hit.
//   3. Those hits are computed in double, several at a time, by the scalar function's operations.
//   4. Where a few triangles were left open for a ray, the double function decides among them;
//   where
//      more, and for all rays outside of the beam, the ray walks alone, as in mesh_queries.cpp.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "accel/mesh_query.h"
#include "accel/packet.h"
#include "accel/prepare_rays.h"
#include "geometry/triangle.h"

namespace accel {
namespace {

/// Fewer rays than this do not pay for a packet.
constexpr int kFewRays = 8;

/// A beam and the rays of it, which are the first ones of those given.
class BeamOfRays : public Beam {
 public:
  /// Takes rays into the beam until one does not belong to it. Eye rays start at the point of the
  /// beam. The rays that a flat mirror sends on come, when they are followed back, from a point
  /// behind it, that mirror's picture of the eye, up to rounding.
  BeamOfRays(const Ray* rays, int most, const NearestQuery* queries) {
    count = 0;
    spread = 0;
    point = rays[0].getOrigin();
    const bool startThere = most < 2 || rays[1].getOrigin() == point;
    if (!startThere && !findPoint(rays, most)) return;
    while (count < most && add(rays[count], queries[count], startThere)) ++count;
  }

 private:
  /// Sets the point to where the first ray comes nearest to another one.
  bool findPoint(const Ray* rays, int most) {
    const Ray &a = rays[0], &b = rays[std::min(most, kFewRays) - 1];
    const Vec3d &u = a.getDirection(), &v = b.getDirection();
    const Vec3d between = b.getOrigin() - a.getOrigin(), across = cross(u, v);
    const double size = dot(across, across);
    point = a.pointAtParameter(dot(cross(between, v), across) / size);
    largest_ = maxAbs(point);
    return size > 0 && largest_ <= std::numeric_limits<double>::max();
  }

  bool add(const Ray& ray, const NearestQuery& query, bool startThere) {
    const Vec3d& way = ray.getDirection();
    double start = 0;
    if (!startThere) {
      const Vec3d before = ray.getOrigin() - point;
      start = dot(before, way) / dot(way, way);
      const double distance = maxAbs(before - way * start);
      const double size = std::max(largest_, maxAbs(ray.getOrigin()));
      if (!(distance <= size * kFarthestBeside)) return false;
      spread = std::max(spread, distance + size * 0x1p-50);  // and its rounding
    } else if (ray.getOrigin() != point) {
      return false;
    }
    for (int axis = 0; axis < 3; ++axis) direction[axis][count] = way[axis];
    tmin[count] = query.tmin + start;
    tmax[count] = query.t + start;
    return true;
  }

  /// Rays that pass the point at no more than this part of the largest number are of its beam: a
  /// mirror's rays pass at a few times 2^-53 of it over the angle between them.
  static constexpr double kFarthestBeside = 0x1p-36;
  double largest_ = 0;
};

/// Shadow rays begin on surfaces, next to as many triangles as lie between their origins. Where
/// these are more than two a ray, the rays have little in common, and each alone is faster: 1.2
/// times with 10 M triangles, while packets are 1.5 times as fast with 1 M (1024 x 1024 rays).
bool areClose(const ShadowQuery* queries, int count, const MeshTree& tree) {
  BoundingBox box;
  for (int i = 0; i < count; ++i) box.extend(queries[i].ray.getOrigin());
  const double side = box.longestSide();
  return side * side <= 2 * count * tree.typicalArea();
}

/// The beam of shadow rays that end in one point; false where they do not.
bool beamOfShadows(const ShadowQuery* queries, int count, Beam& beam) {
  const ShadowQuery& first = queries[0];
  beam.point = first.ray.pointAtParameter(first.tmax);
  beam.spread = 0;
  beam.count = count;
  bool together = true;
  for (int i = 0; i < count; ++i) {
    const ShadowQuery& query = queries[i];
    const Vec3d& direction = query.ray.getDirection();
    const double largest = std::max(maxAbs(query.ray.getOrigin()), query.tmax * maxAbs(direction));
    const double distance = maxAbs(query.ray.pointAtParameter(query.tmax) - beam.point);
    // A lamp at infinity is at no place.
    together &= largest <= std::numeric_limits<double>::max() && distance <= largest * 0x1p-48;
    beam.spread = std::max(beam.spread, distance + largest * 0x1p-51);  // and its rounding
    beam.direction[0][i] = direction.x();
    beam.direction[1][i] = direction.y();
    beam.direction[2][i] = direction.z();
    beam.tmin[i] = query.tmin - query.tmax;
    beam.tmax[i] = 0;
  }
  return together;
}

std::uint32_t wordOf(float bits) {
  std::uint32_t word;
  std::memcpy(&word, &bits, sizeof word);
  return word;
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
      query.found(t, order, corners.face);
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
    const std::uint32_t leaf = wordOf(packet_.leafBits[i_]);
    if (leaf != 0 && decide(leaf, wordOf(packet_.laneBits[i_]))) return true;
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

/// The rays of a packet whose nearest triangle is proven, so that only the hit is to be computed.
class ProvenHits {
 public:
  ProvenHits(const MeshTree& tree, const TriangleMesh& mesh, std::uint32_t order)
      : tree_(tree), mesh_(mesh), order_(order) {}

  void add(const RayPacket& packet, int i, const Ray& ray) {
    const int place = hits_.count++;
    const MeshTree::Triangle corners = tree_.triangleAt(packet.leaves + wordOf(packet.leafBits[i]),
                                                        int(wordOf(packet.laneBits[i])));
    rays_[place] = i;
    faces_[place] = corners.face;
    put(corners.a, hits_.corner, place);
    put(corners.b, hits_.corner + 3, place);
    put(corners.c, hits_.corner + 6, place);
    put(ray.getOrigin(), hits_.origin, place);
    put(ray.getDirection(), hits_.direction, place);
  }

  /// Computes and records all hits; bit i of the result stands for ray i.
  std::uint64_t finish(const Kernels& kernels, NearestQuery* queries) {
    fillUp();
    kernels.computeHits(hits_);
    std::uint64_t found = 0;
    for (int k = 0; k < hits_.count; ++k) {
      NearestQuery& query = queries[rays_[k]];
      query.t = hits_.t[k];
      query.order = order_;
      query.face = faces_[k];
      query.hit->record(query.t, mesh_.getMaterial(), take(hits_.normal, k), take(hits_.point, k),
                        {&mesh_, query.face, hits_.magnitude[k]});
      found |= std::uint64_t(1) << rays_[k];
    }
    return found;
  }

 private:
  using Row = double[TriangleHits::kMost];
  static void put(const Vec3d& v, Row* rows, int place) {
    for (int axis = 0; axis < 3; ++axis) rows[axis][place] = v[axis];
  }
  static Vec3d take(const Row* rows, int place) {
    return {rows[0][place], rows[1][place], rows[2][place]};
  }
  /// The kernels take eight at a time: repeats the first up to there.
  void fillUp() {
    for (int k = hits_.count; hits_.count > 0 && k % 8 != 0; ++k) {
      for (auto& row : hits_.corner) row[k] = row[0];
      for (auto& row : hits_.origin) row[k] = row[0];
      for (auto& row : hits_.direction) row[k] = row[0];
    }
  }

  const MeshTree& tree_;
  const TriangleMesh& mesh_;
  const std::uint32_t order_;
  int rays_[TriangleHits::kMost];
  std::uint32_t faces_[TriangleHits::kMost];
  TriangleHits hits_;
};

}  // namespace

std::uint64_t nearestInMesh(const Kernels& kernels, const MeshTree& tree, const TriangleMesh& mesh,
                            std::uint32_t order, const Ray* rays, int count,
                            NearestQuery* queries) {
  if (tree.bvh().isEmpty()) return 0;
  RayPacket packet;
  const BeamOfRays beam(rays, count, queries);
  const int together =
      beam.count >= kFewRays && preparePacket(tree.bvh(), beam, packet) ? beam.count : 0;
  if (together > 0) {
    kernels.nearestOfPacket(packet);
    kernels.countNearest(packet);
  }
  ProvenHits proven(tree, mesh, order);
  SingleRays singles;
  std::uint64_t found = 0;
  for (int i = 0; i < count; ++i) {
    if (i >= together || (packet.open >> i & 1) != 0) {
      singles.add(i, rays[i], queries[i].tmin, queries[i].t);
    } else if (packet.doubtCount[i] != 0) {
      const PacketAnswer answer(tree, mesh, packet, i, rays[i]);
      found |= std::uint64_t(answer.nearest(order, queries[i])) << i;
    } else if (packet.leafBits[i] != 0) {
      proven.add(packet, i, rays[i]);
    }
  }
  found |= proven.finish(kernels, queries);
  return found | singles.forEach(
                     kernels, tree.bvh(), [&](int i, TraversalRay& r, const ParameterMap& time) {
                       return NearestInMesh{{&tree, &mesh, rays + i}, queries + i, order, time}.ask(
                           kernels, r);
                     });
}

std::uint64_t occludedByMesh(const Kernels& kernels, const MeshTree& tree, const TriangleMesh& mesh,
                             const ShadowQuery* queries, int count) {
  if (tree.bvh().isEmpty()) return 0;
  Beam beam;
  RayPacket packet;
  const bool together = count >= kFewRays && areClose(queries, count, tree) &&
                        beamOfShadows(queries, count, beam) &&
                        preparePacket(tree.bvh(), beam, packet);
  if (together) {
    kernels.anyOfPacket(packet);
    kernels.countShadow(packet);
  }
  std::uint64_t blocked = together ? packet.blocked : 0;
  SingleRays singles;
  for (int i = 0; i < count; ++i) {
    if ((blocked >> i & 1) != 0) continue;
    const ShadowQuery& query = queries[i];
    if (!together || (packet.open >> i & 1) != 0) {
      singles.add(i, query.ray, query.tmin, query.tmax);
    } else if (packet.doubtCount[i] != 0) {
      const PacketAnswer answer(tree, mesh, packet, i, query.ray);
      blocked |= std::uint64_t(answer.occluded(query.tmin, query.tmax)) << i;
    }
  }
  return blocked |
         singles.forEach(kernels, tree.bvh(), [&](int i, TraversalRay& r, const ParameterMap&) {
           const ShadowQuery& q = queries[i];
           return OccludedByMesh{{&tree, &mesh, &q.ray}, q.tmin, q.tmax}.ask(kernels, r);
         });
}

}  // namespace accel
