// Media: gathers all crossings, then looks which stretches of the line contain a place.
//
//   1. Crossings with closed transparent objects are gathered, and sorted by object and then by t.
//   2. Those of one object are gone through from the far end of the line, which nothing contains:
//      each that leaves the object counts 1, each that enters it -1, and the line is inside where
//      the sum is not 0. A stretch inside is a stay.
//   3. What fills a place is the strongest of the stays around it. There are few: to sort their
//      ends took longer than to look at all of them.
//
// What is the same whichever tree the crossings come from does not depend on the order of visits.
#include "render/media.h"

#include <algorithm>
#include <cstdint>
#include <tuple>

#include "shading/solid_texture.h"

namespace {

constexpr double kInf = std::numeric_limits<double>::infinity();

/// How a crossing counts in the number of times that an object is left.
int countOf(const Crossing& crossing) { return crossing.leaving ? 1 : -1; }

}  // namespace

void Media::finish() {
  stays_.clear();
  sortByObject(crossings_);
  forEachObject(crossings_,
                [this](CrossingPlace first, CrossingPlace last) { addStays(first, last); });
}

void Media::visit(const Crossing& crossing) {
  if (!crossing.closed || !anyPositive(crossing.material->getTransparentColor())) return;
  crossings_.push_back(crossing);
}

/// From the last crossing backwards, as nothing contains the line's far end. A mesh that is inside
/// out counts with the other sign.
void Media::addStays(CrossingPlace first, CrossingPlace last) {
  const Medium medium = {first->object, first->material};
  double to = kInf;
  int count = 0;
  while (last != first) {
    const Crossing& crossing = *--last;
    const int behind = count;
    count += countOf(crossing);
    if (behind == 0) to = crossing.t;
    if (count == 0) stays_.push_back({medium, crossing.t, to});
  }
  if (count != 0) stays_.push_back({medium, -kInf, to});
}

/// By priority, then by rank, which takes longer to find out. Two textures may look different where
/// all this is equal: the first of the scene's materials is taken. Objects of one material may come
/// in any order, which no picture can show.
bool Media::isStronger(const Stay& a, const Stay& b) const {
  const auto rankOf = [this](const Stay& stay) {
    const auto [object, material] = stay.medium;
    const Vec3f color = material->getTransparentColor();
    return std::make_tuple(solids_ ? solids_->volumeOf(object) : kInf, stay.to, -stay.from,
                           material->getIndexOfRefraction(), color.r(), color.g(), color.b(),
                           material->getNumber(), reinterpret_cast<std::uintptr_t>(object));
  };
  const int priorityA = a.medium.material->getPriority();
  const int priorityB = b.medium.material->getPriority();
  return priorityA != priorityB ? priorityA > priorityB : rankOf(a) < rankOf(b);
}

Media::Medium Media::mediumAt(double t) const {
  const Stay* strongest = nullptr;
  for (const Stay& stay : stays_) {
    const bool isAround = stay.from <= t && t < stay.to;
    if (isAround && (!strongest || isStronger(stay, *strongest))) strongest = &stay;
  }
  return strongest ? strongest->medium : Medium();
}

/// Only crossings of closed transparent objects are kept.
bool Media::isClosed(const Object3D* object) const {
  return std::any_of(crossings_.begin(), crossings_.end(),
                     [object](const Crossing& crossing) { return crossing.object == object; });
}

/// How often the line is inside an object at t is the sum of what its crossings beyond t count.
void Media::addFilters(double t, const Vec3d& end, double length, int row,
                       ColorFilterTable& filters) const {
  forEachObject(crossings_, [&](CrossingPlace first, CrossingPlace last) {
    int count = 0;
    for (CrossingPlace c = first; c != last; ++c) count += c->t > t ? countOf(*c) : 0;
    if (count == 0) return;
    filters.add({transparencyAt(*first->material, end), std::abs(count) * length}, row);
  });
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
