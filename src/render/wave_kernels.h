// The stages of a wave that compute: each is a loop over columns, several rows at a time.
// They are compiled once for each instruction set; every formula is the one that the scalar classes
// use. Columns are read and written up to a multiple of eight rows (Arena leaves the room).
#pragma once
#include "camera/camera.h"
#include "math/simd_level.h"
#include "render/wave_tables.h"
#include "shading/light.h"
#include "shading/phong_material.h"

class PictureView;

/// A camera that has a wide form, see Camera, and the picture that it takes.
struct EyeFrame {
  bool isPerspective;
  double center[3], direction[3], right[3], up[3];
  double scale;  ///< of an image plane's unit: how long it is at distance 1, or in the world
  double middle[2], unit[2];  ///< of the picture, see eye_ray::coordinate
};

/// A light that has a wide form.
struct LightNumbers {
  bool isPoint;
  bool isSeenBehind;      ///< by surfaces that are turned away from it too
  double place[3];        ///< of a point light; else the unit direction to it
  double color[3];        ///< each a float
  double attenuation[3];  ///< of a point light
};

/// A PhongMaterial or a BlinnPhongMaterial.
struct PhongNumbers {
  bool isBlinn;
  phong_light::Highlight highlight;
  double diffuse[3], specular[3], exponent;
};

/// Store what the kernels need of a camera, a light, a material; false, and anything stored, where
/// it has no wide form. LightNumbers::isSeenBehind is left to the caller.
bool toNumbers(const PictureView& view, EyeFrame& eye);
bool toNumbers(const Light& light, LightNumbers& numbers);
bool toNumbers(const Material& material, PhongNumbers& numbers);

/// How rays go through listed surfaces.
struct RefractionNumbers {
  bool keepsStraight;  ///< between equal indices the ray goes straight on, to the last bit
  double index;        ///< of the material; 1 is that of the other side
  /// Indices before and behind each surface of the rays, where they are others; else null.
  const double *before, *behind;
};

/// Rays that continue at some surfaces, `count` rows behind the last of a table: their parents are
/// known there.
struct LeavingRays {
  const WaveSurfaces& surfaces;
  const WaveRays& rays;
  int count;

  int first() const { return rays.count; }
  RowList parents() const { return {rays.parent + first(), count}; }
};

struct WaveKernels {
  /// The origins and directions of `count` eye rays through (x, y), in pixels from the lower left
  /// corner of the picture.
  void (*eyeRays)(const EyeFrame& eye, const double* x, const double* y, int count,
                  const RayTable& rays);
  /// Fills in view, point and normal of the surfaces, and sums of 0.
  void (*takeSurfaces)(const RayTable& rays, const HitTable& hits, const WaveSurfaces& surfaces);
  /// Fills `light` with the rays from surfaces that are turned towards it, or from all; but for
  /// their sources.
  void (*sampleLight)(const LightNumbers& numbers, const WaveSurfaces& surfaces, WaveLight& light);
  /// Adds to the surfaces, all of one material, what they send back of the listed light.
  void (*reflect)(const PhongNumbers& material, const WaveLight& light, const RowList& list,
                  const WaveSurfaces& surfaces);
  /// Stores origin and direction of the mirrored rays.
  void (*mirror)(const LeavingRays& leaving);
  /// The same for refracted rays but those that are totally reflected, side by side: stores for
  /// each which of the rows it was, 0 for the first, and returns how many there are.
  int (*refract)(const RefractionNumbers& material, const LeavingRays& leaving,
                 std::uint16_t* places);
  /// Each filter's colour becomes its tint, ColorFilter::tint.
  void (*absorb)(const ColorFilterTable& filters);
};

/// One set of them for each SimdLevel; only for a processor that has it, see availableSimd.
namespace baseline {
WaveKernels waveKernels();
}
namespace avx2 {
WaveKernels waveKernels();
}
namespace avx512 {
WaveKernels waveKernels();
}

/// Those of a level that the processor has.
const WaveKernels& waveKernels(SimdLevel level);
