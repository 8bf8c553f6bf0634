// A second ray tracer, in long double, from the program's description alone. Besides the colour it
// gives a signature of all that was decided on the way: which surfaces were met, which lights.
#pragma once
#include <cstdint>

#include "long_world.h"

namespace numbers {

struct LongSettings {
  int bounces = 5;
  float weight = 0.01f;
  bool shadows = true, transparentShadows = false, shadeBack = false;
  /// Where secondary rays begin. Below 0 is adaptive: they leave their surface out, and begin at
  /// 1e-12 of the numbers at hand, where at most 1e-9 is allowed: of surfaces that coincide the
  /// others are passed too.
  Real epsilon = Real(0.001);
};

/// Folds what was decided into one number.
class Signature {
 public:
  void add(int value) {
    value_ = (value_ ^ std::uint64_t(value + 2)) * 1099511628211u;
    value_ ^= value_ >> 29;
  }
  void add(const Place& place) {
    add(place.object);
    add(place.part);
  }
  bool operator==(const Signature& other) const { return value_ == other.value_; }

 private:
  std::uint64_t value_ = 1469598103934665603u;
};

/// What an eye ray gives. `t` is infinite where nothing is hit.
struct LongPixel {
  Vec color, normal;
  Real t = kFar;
  Signature signature;
};

class LongTracer {
 public:
  LongTracer(const PlainScene& scene, const LongSettings& settings)
      : scene_(scene), settings_(settings), world_(scene) {}

  /// The settings may follow from what the world is like.
  LongSettings& settings() { return settings_; }
  const LongWorld& world() const { return world_; }

  /// The colour seen through the point (x, y) of a picture of width x height pixels, y upwards.
  LongPixel pixel(Real x, Real y, int width, int height) const {
    LongPixel result;
    Real tmin = 0;
    const LongRay ray = eyeRay((x - Real(width) / 2) / std::max(width, height),
                               (y - Real(height) / 2) / std::max(width, height), tmin);
    const Meeting met = world_.nearest(ray, tmin);
    result.t = met.t;
    if (met.place.object >= 0) {
      result.normal = world_.normalAt(met.place, ray.origin + ray.direction * met.t);
    }
    result.color = trace(ray, tmin, 0, 1, result.signature);
    return result;
  }

 private:
  LongRay eyeRay(Real x, Real y, Real& tmin) const {
    const PlainCamera& camera = scene_.camera;
    const Vec ahead = normalize(wide(camera.direction));
    const Vec right = normalize(cross(ahead, wide(camera.up))), up = cross(right, ahead);
    const Vec aside = right * x + up * y;
    if (!camera.isPerspective) {
      tmin = -kFar;
      return {wide(camera.center) + aside * Real(camera.extent), ahead, {}};
    }
    const Real spread = 2 * std::tan(radians(Real(camera.extent)) / 2);
    return {wide(camera.center), normalize(ahead + aside * spread), {}};
  }

  Vec trace(const LongRay& ray, Real tmin, int bounces, Real weight, Signature& signature) const {
    const Meeting met = world_.nearest(ray, tmin);
    signature.add(met.place);
    if (met.place.object < 0) return wide(scene_.background);
    const Vec p = ray.origin + ray.direction * met.t, n = world_.normalAt(met.place, p);
    const PlainMaterial& material = materialOf(met.place);
    const Vec& v = ray.direction;
    signature.add(dot(n, v) < 0);
    Vec color = ambient() * wide(material.diffuse) + lit(p, n, v, met.place, signature);
    const Vec mirror = wide(material.reflective), glass = wide(material.transparent);
    if (mayFollow(mirror, bounces, weight)) {
      const LongRay next = leaving(p, v - n * (2 * dot(v, n)), met.place);
      color += mirror * trace(next, start(next), bounces + 1, weight * length(mirror), signature);
    }
    Vec through;
    if (mayFollow(glass, bounces, weight) && refract(n, v, material.index, through)) {
      signature.add(7);
      const LongRay next = leaving(p, through, met.place);
      color += glass * trace(next, start(next), bounces + 1, weight * length(glass), signature);
    }
    return color;
  }

  const PlainMaterial& materialOf(const Place& place) const {
    return scene_.materials[std::size_t(world_.objects()[std::size_t(place.object)].material)];
  }
  Vec ambient() const { return scene_.lights.empty() ? Vec(1, 1, 1) : wide(scene_.ambient); }
  bool mayFollow(const Vec& color, int bounces, Real weight) const {
    return maxAbs(color) > 0 && bounces < settings_.bounces &&
           weight * length(color) >= Real(settings_.weight);
  }
  Real start(const LongRay& ray) const {
    return settings_.epsilon < 0 ? maxAbs(ray.origin) * Real(1e-12) : settings_.epsilon;
  }
  LongRay leaving(const Vec& p, const Vec& direction, const Place& place) const {
    return {p, normalize(direction), settings_.epsilon < 0 ? place : Place()};
  }

  /// Snell: the part of the direction along the surface changes by the ratio of the indices.
  static bool refract(Vec n, const Vec& v, Real index, Vec& through) {
    Real ratio = 1 / index;
    if (!(dot(n, v) < 0)) {
      n = -n;
      ratio = index;
    }
    const Vec along = (v - n * dot(v, n)) * ratio;
    const Real rest = 1 - dot(along, along);
    if (rest < 0) return false;
    through = along - n * std::sqrt(rest);
    return true;
  }

  /// The sum over the lights.
  Vec lit(const Vec& p, Vec n, const Vec& v, const Place& place, Signature& signature) const {
    if (settings_.shadeBack && dot(n, v) > 0) n = -n;
    const PlainMaterial& material = materialOf(place);
    const Vec r = v - n * (2 * dot(v, n));
    Vec sum;
    for (const PlainLight& light : scene_.lights) {
      const Vec way = light.isPoint ? wide(light.place) - p : -wide(light.place);
      const Real s = light.isPoint ? length(way) : kFar;
      const Vec l = normalize(way), a = wide(light.attenuation);
      Vec color = wide(light.color);
      if (light.isPoint) color = color / (a.x() + a.y() * s + a.z() * s * s);
      const Real diffuse = dot(n, l), specular = dot(r, l);
      signature.add((diffuse > 0 ? 1 : 0) + (specular > 0 ? 2 : 0));
      if (!(diffuse > 0)) continue;
      Vec share = wide(material.diffuse) * diffuse;
      if (specular > 0) {
        share += wide(material.specular) * std::pow(specular, Real(material.exponent));
      }
      sum += share * color * arriving(leaving(p, l, place), s, signature);
    }
    return sum;
  }

  /// The part of the light that comes down the ray from distance s.
  Vec arriving(const LongRay& ray, Real s, Signature& signature) const {
    Vec part(1, 1, 1);
    if (!settings_.shadows) return part;
    for (int i = 0; i < int(world_.objects().size()); ++i) {
      const Vec glass = wide(materialOf({i, 0}).transparent);
      std::vector<Meeting> met;
      world_.meet(ray, i, [&](const Meeting& m) {
        if (m.t > start(ray)) met.push_back(m);
      });
      const bool isMet =
          std::any_of(met.begin(), met.end(), [&](const Meeting& m) { return m.t < s; });
      if (!isMet && met.size() % 2 == 0) continue;
      if (!settings_.transparentShadows || !(maxAbs(glass) > 0)) {
        if (!isMet) continue;
        signature.add(-2);
        return Vec();
      }
      part *= tint(i, glass, met, s, signature);
    }
    return part;
  }

  /// What the transparent object lets pass: by length where it encloses something (inside is where
  /// an odd number of meetings is still ahead), else once for each meeting.
  Vec tint(int index, const Vec& glass, std::vector<Meeting>& met, Real s,
           Signature& signature) const {
    std::sort(met.begin(), met.end(), [](const Meeting& a, const Meeting& b) { return a.t < b.t; });
    Real inside = 0, since = 0;
    Vec part(1, 1, 1);
    for (std::size_t i = 0; i < met.size(); ++i) {
      if ((met.size() - i) % 2 == 1) inside += std::min(met[i].t, s) - std::min(since, s);
      since = met[i].t;
      if (met[i].t < s) part *= glass;
      signature.add(met[i].place);
    }
    if (!world_.objects()[std::size_t(index)].closed) return part;
    for (int k = 0; k < 3; ++k) part[k] = std::pow(glass[k], inside);
    return part;
  }

  const PlainScene& scene_;
  LongSettings settings_;
  LongWorld world_;
};

/// The byte of a colour's component.
inline int byteOf(Real component) {
  const Real scaled = component * 255;
  return scaled >= 255 ? 255 : scaled > 0 ? int(scaled) : 0;
}

}  // namespace numbers
