// Passage: what lies on both sides of the place where a ray hits a surface.
#pragma once
#include "math/vec3.h"
#include "shading/material.h"

struct Passage {
  /// The medium on one side of the surface: that of the surface's own material, or another.
  struct Side {
    bool isOwn = false;
    float index = 1;  ///< of refraction, where it is another

    float indexAt(const Material& surface) const {
      return isOwn ? surface.getIndexOfRefraction() : index;
    }
  };

  Side before;            ///< where the ray comes from
  Side behind;            ///< where it would go on straight
  bool isClosed = false;  ///< the surface encloses a volume; known with RenderOptions::fresnel
  Vec3f tint{1, 1, 1};    ///< what is left of the light from the surface where the ray began
};

/// Index 1 on one side and the material's own on the other; `isOutside` where the ray comes from
/// the side of index 1.
inline Passage plainPassage(bool isOutside) {
  Passage passage;
  passage.before.isOwn = !isOutside;
  passage.behind.isOwn = isOutside;
  return passage;
}
