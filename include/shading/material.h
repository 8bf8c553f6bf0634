// Material: how a surface answers light. What every material has stands here; how it looks under
// one light is up to the kind of material.
#pragma once
#include "geometry/hit.h"
#include "geometry/ray.h"
#include "math/vec3.h"

class SolidTexture;

class Material {
 public:
  /// Colours are RGB factors, usually 0..1; black means "not at all". indexOfRefraction is that of
  /// the inside, against 1 outside.
  Material(const Vec3f& diffuseColor, const Vec3f& transparentColor, const Vec3f& reflectiveColor,
           float indexOfRefraction)
      : diffuseColor_(diffuseColor),
        transparentColor_(transparentColor),
        reflectiveColor_(reflectiveColor),
        indexOfRefraction_(indexOfRefraction) {}
  virtual ~Material() = default;

  Vec3f getDiffuseColor() const { return diffuseColor_; }
  Vec3f getTransparentColor() const { return transparentColor_; }
  Vec3f getReflectiveColor() const { return reflectiveColor_; }
  float getIndexOfRefraction() const { return indexOfRefraction_; }
  /// Where closed transparent objects overlap, the one of the largest priority fills the place.
  int getPriority() const { return priority_; }
  void setPriority(int priority) { priority_ = priority; }

  /// The light that the surface sends back along the ray from one light: `dirToLight` is the unit
  /// direction to it, `lightColor` what arrives. hit.getNormal() is used as it stands. Ambient
  /// light, shadows and secondary rays are the ray tracer's business.
  virtual Vec3f Shade(const Ray& ray, const Hit& hit, const Vec3f& dirToLight,
                      const Vec3f& lightColor) const = 0;

  /// This material as the solid texture that it is; null where it is the same at every point.
  virtual const SolidTexture* asTexture() const { return nullptr; }

 private:
  Vec3f diffuseColor_, transparentColor_, reflectiveColor_;
  float indexOfRefraction_;
  int priority_ = 0;
};
