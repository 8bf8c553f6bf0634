// Light: where light comes from at a point, how much of it, and how far it has come.
// A light has no size and is never seen itself. Whether something is in the way is the ray
// tracer's question, which it asks with the direction and distance that it gets here.
#pragma once
#include <limits>

#include "math/vec3.h"

/// The formula of a point light at `position`, for any number of places (see math/number.h): stores
/// the unit direction to it, 0 at the light itself, the colour that arrives, dimmed by
/// 1 / (a0 + a1 s + a2 s^2) at distance s and rounded to float, and s. `attenuation` is a0, a1, a2;
/// where the sum is not above 0, nothing arrives. No component is larger than a float can hold.
template <class Number>
void illuminate(const Vec3<Number>& position, const Vec3<Number>& color,
                const Vec3<Number>& attenuation, const Vec3<Number>& point,
                Vec3<Number>& dirToLight, Vec3<Number>& arriving, Number& distance) {
  const Vec3<Number> way = position - point;
  const Number s = length(way);
  dirToLight = choose(s > 0, way / s, Vec3<Number>());
  const Number dimming = attenuation.x() + attenuation.y() * s + attenuation.z() * (s * s);
  const Vec3<Number> dimmed = color / dimming;
  const Number most = 0x1.fffffep127;  // the largest float
  for (int k = 0; k < 3; ++k) {
    arriving[k] = choose(dimming > 0, larger(-most, smaller(dimmed[k], most)), Number(0));
  }
  arriving = roundedToFloat(arriving);
  distance = s;
}

class Light {
 public:
  virtual ~Light() = default;
  /// For a point in world space: stores the unit direction to the light, the colour that arrives
  /// where nothing is in the way (RGB, no upper bound), and the distance in units of the world
  /// (infinity for a directional light).
  virtual void getIllumination(const Vec3d& point, Vec3d& dirToLight, Vec3f& color,
                               double& distanceToLight) const = 0;
  /// The word by which scene files call this kind of light.
  virtual const char* getKind() const = 0;
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
  const char* getKind() const override { return "DirectionalLight"; }

 private:
  Vec3d dirToLight_;
  Vec3f color_;
};

/// Light from one point, dimmed by 1 / (a0 + a1 s + a2 s^2) at distance s.
class PointLight : public Light {
 public:
  /// `attenuation` holds a0, a1, a2; (1, 0, 0) does not dim at all. Where the sum is not above 0
  /// the light adds nothing.
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
    Vec3d arriving;
    illuminate(position_, Vec3d(color_), attenuation_, point, dirToLight, arriving,
               distanceToLight);
    color = Vec3f(arriving);
  }
  const char* getKind() const override { return "PointLight"; }

 private:
  Vec3d position_;
  Vec3f color_;
  Vec3d attenuation_;
};
