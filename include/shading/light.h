// Light: where light comes from at a point, how much of it, and how far it has come.
// A light has no size and is never seen itself. Whether something is in the way is the ray
// tracer's question, which it asks with the direction and distance that it gets here.
#pragma once
#include <limits>

#include "math/vec3.h"

class Light {
 public:
  virtual ~Light() = default;
  /// For a point in world space: stores the unit direction to the light, the colour that arrives
  /// where nothing is in the way (RGB, no upper bound), and the distance in units of the world
  /// (infinity for a directional light).
  virtual void getIllumination(const Vec3d& point, Vec3d& dirToLight, Vec3f& color,
                               double& distanceToLight) const = 0;
};

/// Parallel light: the same direction and colour everywhere.
class DirectionalLight : public Light {
 public:
  /// `direction` is the way the light travels, in world space; any length but zero.
  DirectionalLight(const Vec3d& direction, const Vec3f& color)
      : dirToLight_(normalize(-direction)), color_(color) {}

  /// A unit vector, against the direction that the light was made with.
  const Vec3d& getDirToLight() const { return dirToLight_; }
  const Vec3f& getColor() const { return color_; }

  void getIllumination(const Vec3d&, Vec3d& dirToLight, Vec3f& color,
                       double& distanceToLight) const override {
    dirToLight = dirToLight_;
    color = color_;
    distanceToLight = std::numeric_limits<double>::infinity();
  }

 private:
  Vec3d dirToLight_;
  Vec3f color_;
};

/// Light from one point, dimmed by 1 / (a0 + a1 s + a2 s^2) at distance s.
class PointLight : public Light {
 public:
  /// `attenuation` holds a0, a1, a2; (1, 0, 0) does not dim at all. Where the sum is 0 the
  /// colour is infinite, or NaN in a channel that is black.
  PointLight(const Vec3d& position, const Vec3f& color, const Vec3d& attenuation)
      : position_(position), color_(color), attenuation_(attenuation) {}

  /// In world space.
  const Vec3d& getPosition() const { return position_; }
  /// Before it is dimmed.
  const Vec3f& getColor() const { return color_; }
  const Vec3d& getAttenuation() const { return attenuation_; }

  /// At the light's own position the direction is the zero vector: no surface is lit there.
  void getIllumination(const Vec3d& point, Vec3d& dirToLight, Vec3f& color,
                       double& distanceToLight) const override {
    const Vec3d way = position_ - point;
    const double s = length(way);
    dirToLight = s > 0 ? way / s : Vec3d();
    const double dimming = attenuation_.x() + attenuation_.y() * s + attenuation_.z() * (s * s);
    color = Vec3f(Vec3d(color_) / dimming);
    distanceToLight = s;
  }

 private:
  Vec3d position_;
  Vec3f color_;
  Vec3d attenuation_;
};
