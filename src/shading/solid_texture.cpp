// SolidTexture: from a texture of textures to plain materials with weights; and the patterns.
//
// A texture is a node with two children, its components; many textures may share a child, so the
// whole is a graph without circles, and counting its paths would take exponential time. Instead
// every material waits until all that refers to it has been looked at. Since a texture refers only
// to materials of earlier places, taking the waiting one of the latest place does just that:
//
//   1. the texture itself waits, with weight 1;
//   2. the latest is taken out; a plain material goes to the answer, a texture passes w of its
//      weight on to its second component and 1 - w to its first, where their weights add up;
//   3. until none waits.
#include "shading/solid_texture.h"

#include <algorithm>
#include <cmath>

#include "math/functions.h"
#include "math/perlin_noise.h"

/// A weight of 0, as one that has become too small for a double, adds nobody to wait.
void SolidTexture::Mixture::add(const Component& component, double weight) {
  if (!(weight > 0)) return;
  waiting_.push_back({component, weight, arrivals_++});
  std::push_heap(waiting_.begin(), waiting_.end());
}

/// The waiting one of the latest place, with all its shares.
WeightedMaterial SolidTexture::Mixture::takeLatest() {
  const Component latest = waiting_.front().component;
  double weight = 0;
  while (!waiting_.empty() && waiting_.front().component.place == latest.place) {
    weight += waiting_.front().weight;
    std::pop_heap(waiting_.begin(), waiting_.end());
    waiting_.pop_back();
  }
  return {latest.material, weight};
}

SolidTexture::SolidTexture(const Matrix& toTexture, const Component& first, const Component& second)
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

void SolidTexture::mixAt(const Vec3d& point, Mixture& mixture) const {
  mixture.plain_.clear();
  WeightedMaterial current{this, 1};
  for (;;) {
    if (const SolidTexture* texture = current.material->asTexture()) {
      const double second = texture->clampedWeight(point);
      mixture.add(texture->first_, current.weight * (1 - second));
      mixture.add(texture->second_, current.weight * second);
    } else {
      mixture.plain_.push_back(current);
    }
    if (mixture.waiting_.empty()) return;
    current = mixture.takeLatest();
  }
}

/// Of two equal components the first has all, exactly: w + (1 - w) may round to something else.
double SolidTexture::clampedWeight(const Vec3d& point) const {
  if (first_.material == second_.material) return 0;
  const double weight = weightOfSecond(toTexture_.transformPoint(point));
  return weight > 0 ? std::min(weight, 1.0) : 0;
}

Vec3f SolidTexture::Shade(const Ray& ray, const Hit& hit, const Vec3f& dirToLight,
                          const Vec3f& lightColor) const {
  Vec3d sum;
  for (const auto& [material, weight] : materialsAt(hit.getIntersectionPoint())) {
    sum += weight * Vec3d(material->Shade(ray, hit, dirToLight, lightColor));
  }
  return Vec3f(sum);
}

/// A sum of whole numbers is odd where an odd number of them is, so the lowest bit of each will do,
/// however large they are.
double Checkerboard::weightOfSecond(const Vec3d& p) const {
  int parity = 0;
  for (int axis = 0; axis < 3; ++axis) parity ^= math::floorBits(p[axis] / size_, 1);
  return parity;
}

double Noise::weightOfSecond(const Vec3d& p) const {
  return 0.5 + slope_ * math::fractalNoise(p, octaves_);
}

double WaveTexture::weightOfSecond(const Vec3d& p) const {
  const double angle = frequency_ * distanceAt(p) + amplitude_ * math::fractalNoise(p, octaves_);
  return (1 + height_ * math::sin(angle)) / 2;
}

double Marble::distanceAt(const Vec3d& p) const { return p.x(); }
double Wood::distanceAt(const Vec3d& p) const { return std::sqrt(p.x() * p.x() + p.z() * p.z()); }

double GrainedWood::weightOfSecond(const Vec3d& p) const {
  const double rings = std::sqrt(p.x() * p.x() + p.z() * p.z()) + 0.05 * p.y();
  const double noise = math::fractalNoise({p.x(), 0.2 * p.y(), p.z()}, octaves_);
  const double wave = 0.5 + math::sin(frequency_ * rings + amplitude_ * noise);
  const double first = wave > 0 ? std::min(wave, 1.0) : 0;
  return 1 - first * first;
}
