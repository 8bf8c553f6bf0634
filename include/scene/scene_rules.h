// SceneRules: what the words of a scene file mean, where the years of the course differ. The parser
// makes materials by them; nobody asks for them later.
#pragma once
#include <cstddef>

#include "geometry/mesh_shading.h"

/// Those of 2003, unless a course says otherwise.
struct SceneRules {
  /// PhongMaterial and Material have the highlight of a BlinnPhongMaterial.
  bool isHighlightHalfway = false;
  /// Highlights are multiplied by n.l too (PhongMaterial::dimHighlight).
  bool areHighlightsDimmed = false;
  double noiseSlope = 0.5;     ///< of Noise: the weight of its second material is 1/2 + slope N
  double marbleHeight = 1;     ///< of Marble's waves: 1, or -1, which exchanges its materials
  bool isWoodGrained = false;  ///< Wood is a GrainedWood
  /// What the normals of meshes are made of that have more than mostFlatVertices vertices; the
  /// others are flat.
  MeshNormals meshNormals = MeshNormals::flat;
  std::size_t mostFlatVertices = 0;
  bool usesFileNormals = false;          ///< where a mesh file gives normals (vn), they come first
  bool keepsTextureCoordinates = false;  ///< the vt of mesh files reach hits
};
