// SolidTexture: from a texture of textures to plain materials with weights.
#include "shading/solid_texture.h"

#include <algorithm>
#include <iterator>
#include <map>

namespace {

Vec3f largest(const Vec3f& a, const Vec3f& b) {
  return {std::max(a.r(), b.r()), std::max(a.g(), b.g()), std::max(a.b(), b.b())};
}

/// Materials that wait for their turn, by place.
using Waiting = std::map<std::size_t, WeightedMaterial>;

void add(Waiting& waiting, const SolidTexture::Part& part, double weight) {
  if (weight > 0)
    waiting.try_emplace(part.place, WeightedMaterial{part.material, 0}).first->second.weight +=
        weight;
}

}  // namespace

SolidTexture::SolidTexture(const Matrix& toTexture, const Part& first, const Part& second)
    : Material(
          largest(first.material->getDiffuseColor(), second.material->getDiffuseColor()),
          largest(first.material->getTransparentColor(), second.material->getTransparentColor()),
          largest(first.material->getReflectiveColor(), second.material->getReflectiveColor()),
          first.material->getIndexOfRefraction()),
      toTexture_(toTexture),
      first_(first),
      second_(second) {
  setPriority(first.material->getPriority());
}

/// In descending order of place everything that refers to a material comes before it, so its weight
/// is complete when its turn comes.
std::vector<WeightedMaterial> SolidTexture::partsAt(const Vec3d& point) const {
  std::vector<WeightedMaterial> parts;
  Waiting waiting;
  WeightedMaterial current{this, 1};
  for (;;) {
    if (const SolidTexture* texture = current.material->asTexture()) {
      const double second = texture->clampedWeight(point);
      add(waiting, texture->first_, current.weight * (1 - second));
      add(waiting, texture->second_, current.weight * second);
    } else {
      parts.push_back(current);
    }
    if (waiting.empty()) return parts;
    const auto latest = std::prev(waiting.end());
    current = latest->second;
    waiting.erase(latest);
  }
}

/// Of two equal parts the first has all, exactly.
double SolidTexture::clampedWeight(const Vec3d& point) const {
  if (first_.material == second_.material) return 0;
  const double weight = weightOfSecond(toTexture_.transformPoint(point));
  return weight > 0 ? std::min(weight, 1.0) : 0;
}

Vec3f SolidTexture::Shade(const Ray& ray, const Hit& hit, const Vec3f& dirToLight,
                          const Vec3f& lightColor) const {
  Vec3d sum;
  for (const WeightedMaterial& part : partsAt(hit.getIntersectionPoint())) {
    sum += part.weight * Vec3d(part.material->Shade(ray, hit, dirToLight, lightColor));
  }
  return Vec3f(sum);
}
