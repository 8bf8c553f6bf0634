// SolidTexture: from a texture of textures to plain materials with weights.
//
// A texture is a node with two children, its components; many textures may share a child, so the
// whole is a graph without circles, and counting its paths would take exponential time. Instead
// every material waits until all that refers to it has been looked at. Since a texture refers only
// to materials of lower numbers, taking the waiting one of the highest number does just that:
//
//   1. the texture itself waits, with weight 1;
//   2. that one is taken out; a plain material goes to the answer, a texture passes w of its
//      weight on to its second component and 1 - w to its first, where their weights add up;
//   3. until none waits.
#include "shading/solid_texture.h"

#include <utility>

namespace {

/// A weight of 0, as one that has become too small for a double, lets nobody wait. The new one
/// finds its place from the end, where it mostly is: components are listed shortly before.
void addShare(const WeightedMaterial& share, std::vector<WeightedMaterial>& waiting) {
  if (!(share.weight > 0)) return;
  const int number = share.material->getNumber();
  auto at = waiting.end();
  while (at != waiting.begin() && (at - 1)->material->getNumber() > number) --at;
  if (at != waiting.begin() && (at - 1)->material == share.material) {
    (at - 1)->weight += share.weight;
  } else {
    waiting.insert(at, share);
  }
}

}  // namespace

SolidTexture::SolidTexture(const char* kind, const Matrix& toTexture, const Material* first,
                           const Material* second, Pattern weightOfSecond)
    : Material(largest(first->getDiffuseColor(), second->getDiffuseColor()),
               largest(first->getTransparentColor(), second->getTransparentColor()),
               largest(first->getReflectiveColor(), second->getReflectiveColor()),
               first->getIndexOfRefraction()),
      kind_(kind),
      toTexture_(toTexture),
      first_(first),
      second_(second),
      weightOfSecond_(std::move(weightOfSecond)) {
  setPriority(first->getPriority());
}

const std::vector<WeightedMaterial>& SolidTexture::mixAt(const Vec3d& point,
                                                         Mixture& mixture) const {
  auto& [plain, waiting] = mixture;
  plain.clear();
  WeightedMaterial current{this, 1};
  for (;;) {
    if (const SolidTexture* texture = current.material->asTexture()) {
      const double second = texture->clampedWeight(point);
      addShare({texture->first_, current.weight * (1 - second)}, waiting);
      addShare({texture->second_, current.weight * second}, waiting);
    } else {
      plain.push_back(current);
    }
    if (waiting.empty()) return plain;
    current = waiting.back();
    waiting.pop_back();
  }
}

/// Of two equal components the first has all, exactly: w + (1 - w) may round to something else.
double SolidTexture::clampedWeight(const Vec3d& point) const {
  if (first_ == second_) return 0;
  return withinUnit(weightOfSecond_(toTexture_.transformPoint(point)));
}

Vec3f SolidTexture::Shade(const Ray& ray, const Hit& hit, const Vec3f& dirToLight,
                          const Vec3f& lightColor) const {
  Vec3d sum;
  for (const auto& [material, weight] : materialsAt(hit.getIntersectionPoint())) {
    sum += weight * Vec3d(material->Shade(ray, hit, dirToLight, lightColor));
  }
  return Vec3f(sum);
}
