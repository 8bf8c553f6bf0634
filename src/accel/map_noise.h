// MapNoise: how far off hits may seem that are decided under Transforms.
//
// The double functions err by a few units in the last place of the largest number that they see.
// Under a Transform that is a number of its inside, and an error there, taken back outside, is as
// much larger as the map stretches: a map that squeezes one axis to 1/1000 and a rotation inside it
// make it 1000 times as large. Boxes outside have to be widened by that.
#pragma once
#include "geometry/transform.h"

namespace accel {

/// For rays whose origin has coordinates of at most x, errors are at most 48 roundings (2^-53 each)
/// of perSize * x + fixed, in the units of the space; 0 for what stands under no Transform, whose
/// errors the error bounds of the kernels hold anyway.
struct MapNoise {
  double perSize = 0, fixed = 0;

  /// Takes in what else stands in the space.
  void add(const MapNoise& other);
};

/// The noise outside of a Transform whose inside has `inner`.
MapNoise noiseThrough(const Transform& transform, const MapNoise& inner);

}  // namespace accel
