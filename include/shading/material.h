// Material: how a surface answers light. What every material has stands here; how it looks under
// one light is up to the kind of material.
#pragma once
#include "geometry/hit.h"
#include "geometry/ray.h"
#include "math/vec3.h"

class DiffuseMap;
class SolidTexture;

class Material {
 public:
  /// Colours are RGB factors, usually 0..1; black means "not at all". indexOfRefraction > 0 is that
  /// of the inside, against 1 outside.
  Material(const Vec3f& diffuseColor, const Vec3f& transparentColor, const Vec3f& reflectiveColor,
           float indexOfRefraction)
      : diffuseColor_(diffuseColor),
        transparentColor_(transparentColor),
        reflectiveColor_(reflectiveColor),
        indexOfRefraction_(indexOfRefraction) {}
  virtual ~Material() = default;

  /// The factor of ambient light, and of a light's that is scattered evenly.
  Vec3f getDiffuseColor() const { return diffuseColor_; }
  /// The factor of light from the other side, along the refracted ray.
  Vec3f getTransparentColor() const { return transparentColor_; }
  /// Whether any light comes through.
  bool isTransparent() const { return anyPositive(transparentColor_); }
  /// The factor of light along the mirrored ray.
  Vec3f getReflectiveColor() const { return reflectiveColor_; }
  /// Of the side that normals point away from; matters only where the material is transparent.
  float getIndexOfRefraction() const { return indexOfRefraction_; }

  /// Where closed transparent objects overlap, the one of the largest priority fills the place. Any
  /// number, 0 unless set; set only while the scene is being read, as all is const afterwards.
  int getPriority() const { return priority_; }
  void setPriority(int priority) { priority_ = priority; }

  /// As SceneParser::getMaterial counts; any below 0 where no scene has read it. Set likewise.
  int getNumber() const { return number_; }
  void setNumber(int number) { number_ = number; }

  /// The light that the surface sends back along the ray from one light: `dirToLight` is the unit
  /// direction to it in world space, `lightColor` what arrives. The ray's direction is a unit
  /// vector, and hit.getNormal(), n, is used as it stands. A white surface that scatters light L
  /// from direction l evenly sends back (n.l) L, without a division by pi: a BRDF f stands in the
  /// colour as pi f (n.l) L. Ambient light, shadows and secondary rays are the ray tracer's
  /// business.
  virtual Vec3f Shade(const Ray& ray, const Hit& hit, const Vec3f& dirToLight,
                      const Vec3f& lightColor) const = 0;

  /// What takes the place of the diffuse colour, which then differs from place to place: not owned;
  /// null where none does.
  virtual const DiffuseMap* getDiffuseMap() const { return nullptr; }

  /// This material as the solid texture that it is; null where it is the same at every point.
  virtual const SolidTexture* asTexture() const { return nullptr; }

  /// The word by which scene files call this kind of material.
  virtual const char* getKind() const { return "material"; }

 protected:
  /// A roughness below this counts as this much: directions to lights are in single precision.
  static constexpr double kLeastRoughness = 1e-4;
  /// Light and eye together at least so high above a rough surface, or there is no highlight: at
  /// grazing angles it grows as 1 / (roughness^2 height), up to 1e36 here, which a float can hold.
  static constexpr double kLeastHeight = 1e-28;

 private:
  Vec3f diffuseColor_, transparentColor_, reflectiveColor_;
  float indexOfRefraction_;
  int priority_ = 0, number_ = -1;
};
