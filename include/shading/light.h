// Light: where light comes from at a point, how much of it, and how far it has come.
#pragma once
#include "math/vec3.h"

class Light {
 public:
  virtual ~Light() = default;
  /// For a point in world space: stores the unit direction to the light, the colour that arrives
  /// where nothing is in the way, and the distance (infinity for a directional light).
  virtual void getIllumination(const Vec3d& point, Vec3d& dirToLight, Vec3f& color,
                               double& distanceToLight) const = 0;
};

/// Parallel light: the same direction and colour everywhere.
class DirectionalLight : public Light {
 public:
  /// `direction` is the way the light travels; any length but zero.
  DirectionalLight(const Vec3d& direction, const Vec3f& color)
      : dirToLight_(normalize(-direction)), color_(color) {}

  const Vec3d& getDirToLight() const { return dirToLight_; }
  const Vec3f& getColor() const { return color_; }
  void getIllumination(const Vec3d& point, Vec3d& dirToLight, Vec3f& color,
                       double& distanceToLight) const override;

 private:
  Vec3d dirToLight_;
  Vec3f color_;
};

/// Light from one point, dimmed by 1 / (a0 + a1 s + a2 s^2) at distance s.
class PointLight : public Light {
 public:
  /// `attenuation` holds a0, a1, a2; (1, 0, 0) does not dim at all.
  PointLight(const Vec3d& position, const Vec3f& color, const Vec3d& attenuation)
      : position_(position), color_(color), attenuation_(attenuation) {}

  const Vec3d& getPosition() const { return position_; }
  const Vec3f& getColor() const { return color_; }
  const Vec3d& getAttenuation() const { return attenuation_; }
  /// At the light's own position the direction is the zero vector: no surface is lit there.
  void getIllumination(const Vec3d& point, Vec3d& dirToLight, Vec3f& color,
                       double& distanceToLight) const override;

 private:
  Vec3d position_;
  Vec3f color_;
  Vec3d attenuation_;
};
