// SceneRules: what the words of a scene file mean, where the years of the course differ. The parser
// makes the scene by them; nobody asks for them later.
#pragma once
#include <cstddef>
#include <string_view>

#include "geometry/mesh_shading.h"

/// The languages of scene files: which words there are. 2004 and aalto write that of 2003.
enum class Language : unsigned { of2003 = 1, of2012 = 2, of2016 = 4, of2020 = 8, ofThu = 16 };

/// Those of 2003, unless a course says otherwise.
struct SceneRules {
  Language language = Language::of2003;

  /// What a camera makes of the `up` that it is given, u; d is its direction, made unit.
  enum class CameraUp {
    turned,     ///< right = d x u, made unit; up = right x d, at right angles to both
    asWritten,  ///< right = d x u, made unit; up = u
    unit,       ///< the same with u made unit
    unscaled    ///< right = d x u, up = right x d, whatever their lengths
  };
  CameraUp cameraUp = CameraUp::turned;
  /// The light of a point at distance s is divided by this + falloff s^2, where there is a falloff.
  double nearFalloff = 1;

  /// PhongMaterial and Material have the highlight of a BlinnPhongMaterial.
  bool isHighlightHalfway = false;
  /// Highlights are multiplied by n.l too (PhongMaterial::Highlight::dimmed).
  bool areHighlightsDimmed = false;
  /// Highlights are seen of lights behind the surface too (PhongMaterial::Highlight::everywhere).
  bool areHighlightsEverywhere = false;
  /// False: materials have no highlights; a specular colour is only what leastMirror makes of it.
  bool haveHighlights = true;
  /// A specular colour longer than this is the reflective colour too, unless that is given; and,
  /// where there is an index of refraction, the transparent one.
  float leastMirror = kNoMirror;
  static constexpr float kNoMirror = 1e30f;

  double noiseSlope = 0.5;  ///< of Noise: the weight of its second material is 1/2 + slope N
  double marbleHeight = 1;  ///< of Marble's waves: 1, or -1, which exchanges its materials
  /// Of the six pictures of a cube map; those of other endings are taken where there are none.
  std::string_view cubeMapEnding = "bmp";
  bool isWoodGrained = false;  ///< Wood is a GrainedWood
  /// What the normals of meshes are made of that have more than mostFlatVertices vertices; the
  /// others are flat.
  MeshNormals meshNormals = MeshNormals::flat;
  std::size_t mostFlatVertices = 0;
  bool usesFileNormals = false;          ///< where a mesh file gives normals (vn), they come first
  bool keepsTextureCoordinates = false;  ///< the vt of mesh files reach hits
};
