// NearestQuestion: when the walk is over, what begins behind a ray's bound has dropped out. Where
// one triangle is left and it is proven, nothing is to be decided; else each is asked. The hits of
// all winners are then computed together.
#include <algorithm>

#include "accel/question_walk.h"

namespace accel {

class NearestQuestion::NearestWalk : public Walk {
 public:
  NearestWalk(NearestQuestion& question, const AskedTree& tree, Stream& stream)
      : Walk(question, tree, stream), hits_(question.hits_) {
    const auto count = std::size_t(stream.count);
    winners_ = question.arena_.take<Winner>(count);
    std::fill(winners_, winners_ + count, Winner{});
  }

  /// Decides what the walk has left, and computes the hits.
  void finish(const Kernels& kernels) {
    Candidate* const end = stream_.candidates + stream_.candidateCount;
    for (const Candidate* c = stream_.candidates; c != end; ++c) {
      std::uint8_t& survivors = winners_[c->ray].survivors;
      if (survives(*c) && survivors < 2) ++survivors;
    }
    for (const Candidate* c = stream_.candidates; c != end; ++c) {
      consider(*c, isUndecided_ && winners_[c->ray].survivors == 1);
    }
    computeHits(kernels);
  }

 private:
  struct Winner {
    std::uint32_t leaf;  // 0: none
    std::uint32_t face;
    std::uint8_t lane;
    std::uint8_t survivors;  // candidates that the walk has left, two at most
  };

  void decide(const Candidate& c) override {
    isUndecided_ = false;
    consider(c, false);
  }
  void objectWasAsked(int ray) override {
    isUndecided_ = false;
    stream_.lowerBound(ray, stream_.rays->tmax[stream_.rowOf(ray)]);
  }
  bool survives(const Candidate& c) const { return c.tLow <= stream_.boxRays[c.ray].tmaxUp; }

  /// Lets the candidate win where it is the nearest so far; `isOnly` where no other is left and
  /// nothing was hit before. Spheres are decided always, for their t.
  void consider(const Candidate& c, bool isOnly) {
    if (!survives(c)) return;
    LeafPrimitive primitive = primitiveOf(c);
    const int row = stream_.rowOf(c.ray);
    if (!(isOnly && c.isProven) || primitive.isSphere) {
      const NearestSoFar best{stream_.rays->tmax[row], hits_.order[row], winners_[c.ray].face};
      double t;
      if (!isHit(c, primitive, t) || !best.accepts(t, primitive.order, primitive.face)) return;
      stream_.rays->tmax[row] = t;
      stream_.lowerBound(c.ray, t);
    }
    Winner& winner = winners_[c.ray];
    winner = {c.leaf, primitive.face, c.lane, winner.survivors};
    hits_.order[row] = primitive.order;
  }

  void computeHits(const Kernels& kernels) {
    LeafHits triangles, spheres;
    for (int ray = 0; ray < stream_.count; ++ray) {
      const Winner& winner = winners_[ray];
      if (winner.leaf == 0) continue;
      const LeafPrimitive primitive = tree_.primitiveAt(stream_.words + winner.leaf, winner.lane);
      const int row = stream_.rowOf(ray);
      if (hits_.order[row] != primitive.order) continue;  // another member was nearer
      hits_.material[row] = primitive.material;
      hits_.object[row] = primitive.object;
      hits_.face[row] = winner.face;
      LeafHits& list = primitive.isSphere ? spheres : triangles;
      add(winner.leaf, winner.lane, row, list);
      if (list.count == LeafHits::kMost) computeHits(kernels, triangles, spheres);
    }
    computeHits(kernels, triangles, spheres);
  }
  void computeHits(const Kernels& kernels, LeafHits& triangles, LeafHits& spheres) {
    if (triangles.count > 0) {
      const RowList hit = {triangles.rows, triangles.count};
      triangles.fillUp();
      kernels.hitsOfTriangles(triangles, *stream_.rays, stream_.inverse, hits_);
      tree_.shade(hit, hits_);
      if (stream_.inverse) kernels.moveHits(*stream_.inverse, *stream_.rays, hit, hits_);
    }
    if (spheres.count > 0) {
      spheres.fillUp();
      kernels.hitsOfSpheres(spheres, *stream_.rays, hits_);
    }
    triangles.count = spheres.count = 0;
  }

  HitTable& hits_;
  Winner* winners_;          // of each ray
  bool isUndecided_ = true;  // no ray has been decided yet
};

void NearestQuestion::walk(const AskedTree& tree, Stream& stream) {
  NearestWalk walk(*this, tree, stream);
  kernels_.nearest(stream);
  walk.finish(kernels_);
}

void NearestQuestion::askObject(const Object3D& object, std::uint32_t order, const RowList& rows) {
  for (const int row : rows) {
    const NearestSoFar best{rays_.tmax[row], hits_.order[row]};
    // What comes later in the scene has to be nearer.
    Hit hit(best.order < order ? best.t : best.inclusiveBound());
    if (!object.intersect(rays_.rayOf(row), hit, rays_.tmin[row])) continue;
    if (!best.accepts(hit.getT(), order)) continue;
    rays_.tmax[row] = hit.getT();
    hits_.setRow(row, hit, order);
  }
}

void NearestQuestion::askShapes(const ShapeNumbers* shapes, int count, const RowList& rows) {
  kernels_.nearestOfShapes(shapes, count, rays_, rows, hits_);
}

void NearestQuestion::askInside(const TreeMember& member, const RowList& rows) {
  const RayTable inside = movedBy(*member.inverse, rows);
  HitTable found(arena_, rows.count);
  for (int k = 0; k < rows.count; ++k) found.order[k] = hits_.order[rows.rows[k]];
  NearestQuestion within(kernels_, inside, found, arena_);
  member.objectTree->ask(within, RowList::all(rows.count, arena_));
  auto* hit = arena_.take<std::uint16_t>(std::size_t(rows.count));
  const bool areCoordinatesGiven = found.hasTextureCoordinates || hits_.hasTextureCoordinates;
  int count = 0;
  for (int k = 0; k < rows.count; ++k) {
    const int row = rows.rows[k];
    if (found.order[k] == hits_.order[row]) continue;
    rays_.tmax[row] = inside.tmax[k];
    hits_.material[row] = found.material[k];
    hits_.object[row] = found.object[k];
    hits_.face[row] = found.face[k];
    if (areCoordinatesGiven) hits_.setTextureCoordinates(row, found.textureCoordinatesOf(k));
    hits_.order[row] = found.order[k];
    hits_.magnitude[row] = found.magnitude[k];
    setRowOf(hits_.normal, row, rowOf(found.normal, k));
    hit[count++] = std::uint16_t(row);
  }
  kernels_.moveHits(*member.inverse, rays_, {hit, count}, hits_);
}

}  // namespace accel
