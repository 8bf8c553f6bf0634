// Shader: what one surface does with light: each term of Whitted's sum as far as it needs no
// further ray, and the rays that the other terms need. It asks nothing of the scene's objects.
//
// The tracers share it, whatever the order in which they trace: each formula stands here once, and
// so does each rule by which recursion ends. All of it is const: any number of threads may ask.
// Source: Whitted, "An Improved Illumination Model for Shaded Display", 1980.
#pragma once
#include "geometry/object3d.h"
#include "render/render_options.h"
#include "render/surface.h"
#include "scene/scene_parser.h"

class Shader {
 public:
  /// Takes lights and ambient light from `scene`, which is not owned. Chooses an automatic epsilon,
  /// once.
  Shader(const SceneParser& scene, const RenderOptions& options);

  /// The ambient term: ambient light times diffuse colour. There may be none (hasAmbient).
  Vec3d ambient(const Surface& s) const;
  /// The same of any side. `hit` counts where ambientMap() is not null.
  Vec3d ambient(const Material& material, const Hit& hit) const;
  /// What gives the diffuse colour in the ambient term; null where it is the same everywhere.
  const DiffuseMap* ambientMap(const Material& material) const {
    return options_.isAmbientPlain ? nullptr : material.getDiffuseMap();
  }

  /// Light number `index` of the scene as the surface sees it. Made in place, as all that follows:
  /// a copy of what has just been written waits for the stores (0.88 of the time for a mesh of 1 M
  /// triangles).
  void sampleLight(int index, const Surface& s, LightSample& light) const;
  /// The question what stands between the surface and that light.
  void setShadowQuery(const Surface& s, const LightSample& light, ShadowQuery& query) const;
  /// What the surface sends back along the ray of that light, of which `visible` (0..1 in each
  /// component) arrives: attenuation and Material::Shade. Black for a black `visible`.
  Vec3d reflected(const Surface& s, const LightSample& light, const Vec3f& visible) const;

  /// The ray that a mirror sends on, or the one that goes through. `next` is set where it follows;
  /// where it would but for a limit, next.weight says what it would weigh.
  Outcome continued(RayKind kind, const Surface& s, TracedRay& next) const;

  // The same in pieces, for who does them for many surfaces.

  /// Whether lights see the surface's other side: with `shadeBack` the one that the ray sees.
  /// `approach` is n.v, below 0 where the ray comes from outside.
  bool isTurned(double approach) const { return options_.shadeBack && approach > 0; }
  /// Whether the side that the ray sees sends back no light of lamps; and whether ambient light.
  bool isDark(double approach) const { return hasDarkSides() && approach > 0; }
  bool hasAmbient(double approach) const { return !hasBlackSides() || !isDark(approach); }
  /// The normal on the side that lights see; 0 where it is dark.
  Vec3d litNormal(const Vec3d& normal, double approach) const {
    return isDark(approach) ? Vec3d() : isTurned(approach) ? -normal : normal;
  }
  /// Whether any side is so.
  bool hasDarkSides() const { return options_.backs != RenderOptions::Backs::litAsFront; }
  bool hasBlackSides() const { return options_.backs == RenderOptions::Backs::nothing; }
  /// False where no surface of the material sends a ray of that kind on.
  bool sends(RayKind kind, const Material& material) const;
  /// What of a mirrored, or of a refracted, ray's colour goes back along the ray that met the
  /// surface.
  Vec3f factorOf(RayKind kind, const Material& material, const Interface& interface,
                 double approach) const {
    return kind == RayKind::mirror ? mirrorFactor(material, interface, approach)
                                   : refractedFactor(material, interface, approach);
  }
  /// Whether a ray of that factor follows one of `weight` after so many bounces; unless the factor
  /// is black, stores in `nextWeight` what it weighs. Here recursion ends.
  Outcome outcomeOf(int bounces, float weight, const Vec3f& factor, const Vec3f& tint,
                    float& nextWeight) const;
  /// Whether a ray of that weight is too faint to follow.
  bool isFaint(float weight) const { return !(weight >= options_.minWeight); }
  /// Whether factors of transparent materials depend on the angle, and on the media.
  bool areFactorsAngular() const { return options_.fresnel || options_.blendsGlass; }
  /// With blended glass the index before a surface is that of the medium that the ray travels in,
  /// TracedRay::indexOfRefraction, wherever the surface's outside is.
  bool followsIndex() const {
    return options_.blendsGlass && !options_.fresnel && !options_.nestedDielectrics;
  }
  /// Between equal indices a refracted ray goes straight on, to the last bit, where media are
  /// looked after.
  bool keepsStraight() const { return options_.nestedDielectrics || options_.fresnel; }

  /// From which t on a unit ray that leaves a hit of that magnitude looks for surfaces.
  float epsilonAt(double magnitude) const {
    if (options_.epsilon.kind == Epsilon::Kind::fixed) return float(options_.epsilon.value);
    return float(magnitude * kAdaptiveEpsilon);
  }
  /// Relative to Hit::getMagnitude, 4.7e-10: far above rounding, below the promised 1e-9.
  static constexpr double kAdaptiveEpsilon = 0x1p-31;

  /// Those given, but the epsilon is never `automatic`, and no side is dark where `shadeBack`
  /// lights it.
  const RenderOptions& options() const { return options_; }

 private:
  bool isBlended(const Material& material) const {
    return options_.blendsGlass && !options_.fresnel && material.isTransparent();
  }
  double mirroredPart(const Material& material, const Interface& interface, double approach) const;
  Vec3f mirrorFactor(const Material& material, const Interface& interface, double approach) const;
  Vec3f refractedFactor(const Material& material, const Interface& interface,
                        double approach) const;
  bool refract(const Surface& s, Vec3d& direction, float& index) const;
  void setLeaving(const Hit& hit, const Vec3d& direction, Ray& ray) const;

  const SceneParser* scene_;  // not owned
  RenderOptions options_;
};
