// The kernels of a wave, compiled once for each instruction set; INSTRUCTION_SET names it.
//
// Every formula is a template of the scalar classes, here over as many doubles as one instruction
// takes. Nothing here may call an inline function that computes with plain doubles: the linker
// could keep another instruction set's copy.
#include "render/wave_kernels.h"

#include "math/lanes.h"
#include "shading/optics.h"

namespace INSTRUCTION_SET {

#include "geometry/lane_columns.inc"

inline DoubleVector all(const double (&numbers)[3]) { return DoubleVector::of(numbers); }

inline void eyeRays(const EyeFrame& eye, const double* x, const double* y, int count,
                    const RayTable& rays) {
  DoubleVector origin = all(eye.center), direction = all(eye.direction);
  const DoubleVector right = all(eye.right), up = all(eye.up);
  for (int k = 0; k < count; k += kDoubles) {
    const Doubles across =
        eye_ray::coordinate(Doubles::load(x + k), Doubles(eye.middle[0]), Doubles(eye.unit[0]));
    const Doubles upwards =
        eye_ray::coordinate(Doubles::load(y + k), Doubles(eye.middle[1]), Doubles(eye.unit[1]));
    if (eye.isPerspective) {
      direction =
          eye_ray::direction(all(eye.direction), right, up, Doubles(eye.scale), across, upwards);
    } else {
      origin = eye_ray::origin(all(eye.center), right, up, Doubles(eye.scale), across, upwards);
    }
    store(origin, rays.origin, k);
    store(direction, rays.direction, k);
  }
}

inline void takeSurfaces(const RayTable& rays, const HitTable& hits, const WaveSurfaces& surfaces) {
  for (int k = 0; k < surfaces.count; k += kDoubles) {
    const SomeRows some({surfaces.ray, surfaces.count}, k);
    store(some.gather(rays.direction), surfaces.view, k);
    store(some.gather(hits.point), surfaces.point, k);
    store(some.gather(hits.normal), surfaces.normal, k);
    store(DoubleVector(0, 0, 0), surfaces.sum, k);
  }
}

inline void sampleLight(const LightNumbers& numbers, const WaveSurfaces& surfaces,
                        WaveLight& light) {
  DoubleVector direction = all(numbers.place), color = all(numbers.color);
  Doubles distance = __builtin_inf();
  for (int k = 0; k < surfaces.count; k += kDoubles) {
    if (numbers.isPoint) {
      illuminate(all(numbers.place), all(numbers.color), all(numbers.attenuation),
                 load(surfaces.point, k), direction, color, distance);
    }
    const DoubleVector lit = load(surfaces.lit, k);  // 0 on a dark side, which no light reaches
    const Mask isReached = isLit(lit, direction, numbers.isSeenBehind);
    unsigned bits = lanesOf(surfaces.count - k) & isReached.bits();
    compressRow(load(surfaces.point, k), bits, light.origin, light.count);
    compressRow(direction, bits, light.direction, light.count);
    compressRow(color, bits, light.color, light.count);
    lanes::compress(Doubles::load(surfaces.tmin + k), bits, light.tmin + light.count);
    lanes::compress(distance, bits, light.tmax + light.count);
    for (; bits != 0; bits &= bits - 1) {
      light.surface[light.count++] = std::uint16_t(k + __builtin_ctz(bits));
    }
  }
}

inline void reflect(const PhongNumbers& material, const WaveLight& light, const RowList& list,
                    const WaveSurfaces& surfaces) {
  const DoubleVector diffuse = all(material.diffuse), specular = all(material.specular);
  for (int first = 0; first < list.count; first += kDoubles) {
    const SomeRows some(list, first);
    std::uint16_t rows[kDoubles];
    for (int lane = 0; lane < kDoubles; ++lane) rows[lane] = light.surface[some.rows[lane]];
    const SomeRows surface({rows, some.count}, 0);
    const DoubleVector v = surface.gather(surfaces.view), n = surface.gather(surfaces.lit);
    const DoubleVector l = roundedToFloat(some.gather(light.direction));
    const Doubles c = material.isBlinn ? phong_light::halfwayCosine(v, n, l)
                                       : phong_light::mirroredCosine(v, n, l);
    surface.add(phong_light::reflectedLight(n, l, c, some.gather(light.color), diffuse, specular,
                                            Doubles(material.exponent), material.highlight),
                surfaces.sum);
  }
}

inline void mirror(const LeavingRays& leaving) {
  const WaveSurfaces& surfaces = leaving.surfaces;
  const RowList parents = leaving.parents();
  for (int first = 0; first < parents.count; first += kDoubles) {
    const SomeRows some(parents, first);
    const int row = leaving.first() + first;
    store(some.gather(surfaces.point), leaving.rays.origin, row);
    store(mirrorDirection(some.gather(surfaces.normal), some.gather(surfaces.view)),
          leaving.rays.direction, row);
  }
}

inline int refract(const RefractionNumbers& material, const LeavingRays& leaving,
                   std::uint16_t* places) {
  const WaveSurfaces& surfaces = leaving.surfaces;
  int kept = 0;
  const RowList parents = leaving.parents();
  for (int first = 0; first < parents.count; first += kDoubles) {
    const SomeRows some(parents, first);
    const DoubleVector incoming = some.gather(surfaces.view);
    const DoubleVector outwards = some.gather(surfaces.normal);
    const Mask isEntering = dot(outwards, incoming) < 0;
    Doubles before = choose(isEntering, Doubles(1), Doubles(material.index));
    Doubles behind = choose(isEntering, Doubles(material.index), Doubles(1));
    if (material.before) {
      before = Doubles::load(material.before + first);
      behind = Doubles::load(material.behind + first);
    }
    DoubleVector direction;
    Mask isSent = refractedDirection(choose(isEntering, outwards, -outwards), incoming,
                                     before / behind, direction);
    if (material.keepsStraight) {
      const Mask isStraight = before == behind;
      direction = choose(isStraight, incoming, direction);
      isSent = isSent | isStraight;
    }
    unsigned bits = isSent.bits() & lanesOf(parents.count - first);
    compressRow(some.gather(surfaces.point), bits, leaving.rays.origin, leaving.first() + kept);
    compressRow(direction, bits, leaving.rays.direction, leaving.first() + kept);
    for (; bits != 0; bits &= bits - 1) {
      places[kept++] = std::uint16_t(first + __builtin_ctz(bits));
    }
  }
  return kept;
}

inline void absorb(const ColorFilterTable& filters) {
  for (int k = 0; k < filters.count; k += kDoubles) {
    const Doubles exponent = Doubles::load(filters.exponent + k);
    for (double* const column : filters.color) {
      roundedToFloat(absorption(Doubles::load(column + k), exponent)).store(column + k);
    }
  }
}

WaveKernels waveKernels() {
  return {eyeRays, takeSurfaces, sampleLight, reflect, mirror, refract, absorb};
}

}  // namespace INSTRUCTION_SET
