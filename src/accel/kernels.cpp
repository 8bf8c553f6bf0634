// The kernels of streams, compiled once for each instruction set; INSTRUCTION_SET names it.
//
// All but what is included first stands in the instruction set's own namespace. Of the functions
// from outside that are inline, it may call only templates over the vectors of math/lanes.h: of
// others the linker could keep another instruction set's copy.
#include <cstdint>

#if defined(__SSE2__)
#include <immintrin.h>
#endif

#include "accel/stream.h"
#include "accel/transform_range.h"
#include "geometry/plane.h"
#include "geometry/sphere.h"
#include "geometry/transform.h"
#include "geometry/triangle.h"
#include "math/lanes.h"

namespace accel::INSTRUCTION_SET {

#include "accel/simd.h"

using lanes::Floats;

#include "geometry/lane_columns.inc"

/// Of a component of a direction. One too small to divide by counts as `least`: that turns the ray
/// by far less than boxes are widened.
inline Doubles inverseOf(const Doubles& component, const Doubles& least) {
  return 1 / choose(absolute(component) < absolute(least), least, component);
}
inline Doubles mostOf(const DoubleVector& a) { return larger(larger(a.x(), a.y()), a.z()); }

/// Transform::toObject of some rays by its `inverse`; where that is null, the rays as they are.
struct RaysWithin {
  DoubleVector origin, direction;

  RaysWithin(const Matrix* inverse, const DoubleVector& o, const DoubleVector& d)
      : origin(inverse ? inverse->transformPoint(o) : o),
        direction(inverse ? inverse->transformDirection(d) : d) {}
};

/// f(origin, direction) of the same rays, which are not copied where they stay as they are: the
/// compiler copies vectors half by half, and to load what was stored so took 1.19 of the time of
/// nearestOfShapes.
template <class F>
inline auto within(const Matrix* inverse, const DoubleVector& o, const DoubleVector& d,
                   const F& f) {
  if (!inverse) return f(o, d);
  const RaysWithin at(inverse, o, d);
  return f(at.origin, at.direction);
}

#include "accel/leaf_filters.inc"
#include "accel/prepare_stream.inc"
#include "accel/shape_kernels.inc"
#include "accel/walk_stream.inc"

Kernels kernels() {
  return {areHeld,
          prepare,
          walk<Purpose::nearest>,
          walk<Purpose::any>,
          walk<Purpose::all>,
          hitsOfTriangles,
          hitsOfSpheres,
          crossTriangles,
          nearestOfShapes,
          occludedByShapes,
          shapesMet,
          rowsAtBox,
          moveRays,
          moveHits};
}

}  // namespace accel::INSTRUCTION_SET
