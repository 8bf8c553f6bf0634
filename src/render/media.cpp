// Media: gathers all crossings, then sweeps along the line.
//
//   1. Crossings with closed transparent objects are gathered, and sorted by object and then by t.
//   2. Those of one object are gone through from the far end of the line, which nothing contains:
//      each that leaves the object counts 1, each that enters it -1, and the line is inside where
//      the sum is not 0. A stretch inside is a stay.
//   3. The ends of all stays are sorted by t. From one to the next a set, ordered by strength,
//   holds
//      the stays that the line is in; the strongest fills the layer up to the next end.
//   4. What fills a place is the layer that begins last before it.
//
// All that is summed or multiplied is sorted first, by what it is and not by when it was visited,
// so that the result is the same whichever tree the crossings come from.
#include "render/media.h"

#include <algorithm>
#include <functional>
#include <set>
#include <tuple>

#include "math/functions.h"
#include "shading/solid_texture.h"

namespace {

constexpr double kInf = std::numeric_limits<double>::infinity();

/// How a crossing counts in the number of times that an object is left.
int countOf(const Crossing& crossing) { return crossing.leaving ? 1 : -1; }

std::tuple<float, float, float, float> opticsOf(const Material& material) {
  const Vec3f color = material.getTransparentColor();
  return {material.getIndexOfRefraction(), color.r(), color.g(), color.b()};
}

}  // namespace

void Media::finish() {
  sortByObject(crossings_);
  std::vector<Stay> stays;
  forEachObject(crossings_, [&](CrossingPlace first, CrossingPlace last) {
    const std::vector<Stay> found = staysIn(first, last);
    stays.insert(stays.end(), found.begin(), found.end());
  });
  findLayers(stays);
}

void Media::visit(const Crossing& crossing) {
  if (!crossing.closed || !anyPositive(crossing.material->getTransparentColor())) return;
  crossings_.push_back(crossing);
}

/// From the last crossing backwards, as nothing contains the line's far end. A mesh that is inside
/// out counts with the other sign.
std::vector<Media::Stay> Media::staysIn(CrossingPlace first, CrossingPlace last) const {
  const Medium medium = {first->object, first->material};
  const double volume = solids_ ? solids_->volumeOf(first->object) : kInf;
  std::vector<Stay> stays;
  double to = kInf;
  int count = 0;
  while (last != first) {
    const Crossing& crossing = *--last;
    const int behind = count;
    count += countOf(crossing);
    if (behind == 0) to = crossing.t;
    if (count == 0) stays.push_back({medium, volume, crossing.t, to});
  }
  if (count != 0) stays.push_back({medium, volume, -kInf, to});
  return stays;
}

/// What is the same to the eye may come in any order, which no picture can show.
bool Media::isStronger(const Stay& a, const Stay& b) {
  const Material& first = *a.medium.material;
  const Material& second = *b.medium.material;
  const int priorityA = first.getPriority(), priorityB = second.getPriority();
  if (priorityA != priorityB) return priorityA > priorityB;
  if (a.volume != b.volume) return a.volume < b.volume;
  if (a.to != b.to) return a.to < b.to;
  if (a.from != b.from) return a.from > b.from;
  const auto opticsA = opticsOf(first), opticsB = opticsOf(second);
  return opticsA != opticsB ? opticsA < opticsB : std::less<>()(a.medium.object, b.medium.object);
}

void Media::findLayers(const std::vector<Stay>& stays) {
  struct End {
    double t;
    const Stay* stay;
    bool isEntered;
  };
  // Both ends of every stay, along the line.
  std::vector<End> ends;
  for (const Stay& stay : stays) {
    ends.push_back({stay.from, &stay, true});
    ends.push_back({stay.to, &stay, false});
  }
  std::sort(ends.begin(), ends.end(), [](const End& a, const End& b) { return a.t < b.t; });
  // The stays around the place that the sweep has come to, the strongest first.
  const auto stronger = [](const Stay* a, const Stay* b) { return isStronger(*a, *b); };
  std::set<const Stay*, decltype(stronger)> around(stronger);
  for (const End& end : ends) {
    if (end.isEntered) {
      around.insert(end.stay);
    } else {
      around.erase(end.stay);
    }
    layers_.push_back({end.t, around.empty() ? Medium() : (*around.begin())->medium});
  }
}

/// The layer before the first that begins beyond t; outside of all where there is none.
Media::Medium Media::mediumAt(double t) const {
  const auto next =
      std::upper_bound(layers_.begin(), layers_.end(), t,
                       [](double value, const Layer& layer) { return value < layer.from; });
  return next == layers_.begin() ? Medium() : std::prev(next)->medium;
}

/// Crossings are sorted by object, and only those of closed transparent ones are kept.
bool Media::isClosed(const Object3D* object) const {
  const auto less = [](const Crossing& crossing, const Object3D* wanted) {
    return std::less<>()(crossing.object, wanted);
  };
  const auto found = std::lower_bound(crossings_.begin(), crossings_.end(), object, less);
  return found != crossings_.end() && found->object == object;
}

/// How often the line is inside an object at t is the sum of what its crossings beyond t count.
Vec3f Media::tintOfAll(double t, const Vec3d& end, double length) const {
  std::vector<Vec3f> tints;
  forEachObject(crossings_, [&](CrossingPlace first, CrossingPlace last) {
    int count = 0;
    for (CrossingPlace c = first; c != last; ++c) count += c->t > t ? countOf(*c) : 0;
    const Vec3f color = transparencyAt(*first->material, end);
    if (count != 0) tints.push_back(absorption(color, std::abs(count) * length));
  });
  // Multiplied in an order that does not depend on the order of visits.
  std::sort(tints.begin(), tints.end(), [](const Vec3f& a, const Vec3f& b) {
    return std::make_tuple(a.r(), a.g(), a.b()) < std::make_tuple(b.r(), b.g(), b.b());
  });
  Vec3f product(1, 1, 1);
  for (const Vec3f& tint : tints) product *= tint;
  return product;
}

float Media::Medium::indexAt(const Vec3d& point) const {
  if (!material) return 1;
  const SolidTexture* const texture = material->asTexture();
  if (!texture) return material->getIndexOfRefraction();
  double sum = 0, weights = 0;
  for (const WeightedMaterial& each : texture->materialsAt(point)) {
    if (!anyPositive(each.material->getTransparentColor())) continue;
    sum += each.weight * double(each.material->getIndexOfRefraction());
    weights += each.weight;
  }
  return weights > 0 ? float(sum / weights) : material->getIndexOfRefraction();
}
