// Question::Walk: the rays of one stream among the leaves of one tree, and how candidates are
// decided.
//
// A stream has walked a tree and left candidates. The one double function of triangles, or that of
// spheres, decides them, on numbers that the leaf holds exactly or the scene is asked for. So t,
// face and normal are those of the plain objects, whatever the instruction set. Where more
// candidates come than are kept, they are decided while the walk goes on.
#pragma once
#include <algorithm>

#include "accel/object_tree.h"
#include "accel/question.h"
#include "geometry/sphere.h"
#include "geometry/triangle.h"

namespace accel {

/// The rays of one stream among the leaves of one tree.
class Question::Walk {
 public:
  Walk(Question& question, const AskedTree& tree, Stream& stream)
      : tree_(tree), stream_(stream), question_(question) {
    stream.attach(*this);
  }

  static void resolve(Stream& stream) {
    auto& self = *static_cast<Walk*>(stream.context);
    for (int k = 0; k < stream.candidateCount; ++k) self.decide(stream.candidates[k]);
    stream.candidateCount = 0;
  }
  static void askObject(Stream& stream, const std::uint32_t* words, const std::uint16_t* list,
                        int count) {
    auto& self = *static_cast<Walk*>(stream.context);
    const Arena::Frame frame(self.question_.arena_);
    auto* rows = self.question_.arena_.take<std::uint16_t>(std::size_t(count));
    std::transform(list, list + count, rows,
                   [&](int ray) { return std::uint16_t(stream.rowOf(ray)); });
    self.tree_.askObject(words, self.question_, self.question_.openOf({rows, count}));
    for (int k = 0; k < count; ++k) self.objectWasAsked(list[k]);
  }

 protected:
  virtual ~Walk() = default;
  virtual void decide(const Candidate& c) = 0;
  /// Takes notice of what an object may have changed for a ray.
  virtual void objectWasAsked(int /*ray*/) {}

  LeafPrimitive primitiveOf(const Candidate& c) const {
    return tree_.primitiveAt(stream_.words + c.leaf, c.lane);
  }
  /// The candidate's ray, in the space of the tree.
  Ray rayOf(const Candidate& c) const {
    const Ray ray = stream_.rays->rayOf(stream_.rowOf(c.ray));
    return tree_.inverse() ? ray.moved(*tree_.inverse()) : ray;
  }
  /// True where the ray hits the primitive, the first time above tmin at t.
  bool isHit(const Candidate& c, LeafPrimitive& p, double& t) const {
    const Ray ray = rayOf(c);
    const double tmin = stream_.rays->tmin[stream_.rowOf(c.ray)];
    const bool isLeft = ray.leaves(p.object, p.face);
    if (isLeft && !p.isSphere && !tree_.takesPlace(p)) return false;
    double numbers[9];
    tree_.getNumbers(stream_.words + c.leaf, c.lane, numbers, 1);
    const Vec3d a = Vec3d::of(numbers), b = Vec3d::of(numbers + 3);
    if (p.isSphere) {
      return sphere::nearestRoot(a, numbers[3], ray.getOrigin(), ray.getDirection(), tmin,
                                 Hit().getT(), isLeft, t);
    }
    return triangle::intersect(a, b, Vec3d::of(numbers + 6), ray, t) && t > tmin;
  }
  /// Appends the primitive's numbers.
  void add(std::uint32_t leaf, int lane, int row, LeafHits& list) const {
    tree_.getNumbers(stream_.words + leaf, lane, &list.numbers[0][list.count], LeafHits::kMost);
    list.rows[list.count++] = std::uint16_t(row);
  }

  const AskedTree& tree_;
  Stream& stream_;

 private:
  Question& question_;
};

}  // namespace accel
