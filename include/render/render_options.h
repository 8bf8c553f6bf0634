// RenderOptions: everything that a picture depends on besides the scene.
#pragma once
#include "render/sampling_options.h"

/// How far along its unit direction a secondary or shadow ray starts looking.
struct Epsilon {
  enum class Kind {
    automatic,  ///< fixed 0.001 where the scene spans 1 to 1000 units, else adaptive
    fixed,      ///< `value`
    adaptive    ///< from the size of the numbers at the hit
  };
  static constexpr double kCourse = 0.001;

  Kind kind = Kind::automatic;
  double value = kCourse;  ///< used by `fixed` alone; >= 0
};

/// The most secondary rays in a row that any run may ask for.
inline constexpr int kMaxBounces = 10000;

struct RenderOptions {
  int maxBounces = 5;               ///< 0..kMaxBounces secondary rays in a row
  float minWeight = 0.01f;          ///< a secondary ray of less weight is not traced
  bool shadows = true;              ///< cast shadow rays
  bool transparentShadows = false;  ///< transparent objects tint the light instead of blocking it
  bool shadeBack = false;           ///< light both sides of every surface
  bool nestedDielectrics = false;   ///< indices follow from what a ray is inside of, by priority
  bool fresnel = false;             ///< reflection follows from index and angle
  Epsilon epsilon;
  SamplingOptions sampling;
};
