// Every formula that is a template over its number type, as a function from a row of numbers to a
// row of numbers, so that lanes can be compared with doubles; see lanes_test.cpp.
#pragma once
#include "camera/camera.h"
#include "geometry/plane.h"
#include "geometry/sphere.h"
#include "geometry/triangle.h"
#include "math/functions.h"
#include "math/lanes.h"
#include "math/matrix.h"
#include "shading/light.h"
#include "shading/optics.h"
#include "shading/phong_material.h"

namespace wide {

constexpr int kInputs = 20, kOutputs = 7, kFormulas = 20;

/// The number of a formula as a sentence could name it.
constexpr const char* kNames[kFormulas] = {
    "arithmetic",  "comparisons", "masks",   "choice", "rounding",
    "log and exp", "pow",         "vectors", "sphere", "plane",
    "triangle",    "magnitude",   "mirror",  "Snell",  "Fresnel",
    "Schlick",     "point light", "Phong",   "Blinn",  "camera and matrix"};

template <class Number>
Number numberOf(const MaskOf<Number>& mask) {
  return choose(mask, Number(1), Number(0));
}

template <class Number>
void put(const Vec3<Number>& v, Number* out) {
  out[0] = v.x();
  out[1] = v.y();
  out[2] = v.z();
}

/// Where the mask is false the formula may have stored anything.
template <class Number>
void putWhere(const MaskOf<Number>& mask, const Vec3<Number>& v, Number* out) {
  put(choose(mask, v, Vec3<Number>()), out);
  out[3] = numberOf<Number>(mask);
}

template <class Number>
void putMagnitude(const Matrix& matrix, const Vec3<Number>& v, Number* out) {
  out[0] = matrix.magnitudeAt(v);
}

/// Applies formula 0 .. kFormulas - 1; `matrix` is for the last one.
template <class Number>
void apply(int formula, const Matrix& matrix, const Number* in, Number* out) {
  using Vector = Vec3<Number>;
  const Number &a = in[0], &b = in[1], &c = in[2], &d = in[3];
  const Vector u(in[0], in[1], in[2]), v(in[3], in[4], in[5]), w(in[6], in[7], in[8]),
      x(in[9], in[10], in[11]), y(in[12], in[13], in[14]);
  const MaskOf<Number> leaves = in[15] > 0;
  Number t = 0, s = 0;
  Vector first, second;
  switch (formula) {
    case 0:
      out[0] = a + b;
      out[1] = a - b;
      out[2] = a * b;
      out[3] = a / b;
      out[4] = -a;
      out[5] = a + 2;
      out[6] = 1 / a;
      break;
    case 1:
      out[0] = numberOf<Number>(a < b);
      out[1] = numberOf<Number>(a <= b);
      out[2] = numberOf<Number>(a > b);
      out[3] = numberOf<Number>(a >= b);
      out[4] = numberOf<Number>(a == b);
      out[5] = numberOf<Number>(a != b);
      break;
    case 2:
      out[0] = numberOf<Number>((a < b) & (c < d));
      out[1] = numberOf<Number>((a < b) | (c < d));
      out[2] = numberOf<Number>(!(a < b));
      out[3] = numberOf<Number>(MaskOf<Number>(true) & (a < b));
      out[4] = numberOf<Number>(MaskOf<Number>(false) | (a < b));
      break;
    case 3:
      out[0] = choose(a < b, c, d);
      out[1] = smaller(a, b);
      out[2] = larger(a, b);
      out[3] = absolute(a);
      break;
    case 4:
      out[0] = squareRoot(a);
      out[1] = roundedDown(a);
      out[2] = roundedToFloat(a);
      out[3] = fromBits<Number>(bitsOf(a) >> 1);
      break;
    case 5:
      out[0] = math::log(a);
      out[1] = math::exp(a);
      break;
    case 6:
      out[0] = math::pow(a, b);
      out[1] = math::pow(a, 2.5);
      break;
    case 7:
      put(normalize(u), out);
      out[3] = maxAbs(u);
      out[4] = length(u);
      put(largest(least(u, v), w), out + 4);
      break;
    case 8: {
      const MaskOf<Number> meets =
          sphere::nearestRoot(u, absolute(in[16]), v, w, in[17], in[18], leaves, t);
      out[0] = numberOf<Number>(meets);
      out[1] = choose(meets, t, Number(0));
      break;
    }
    case 9: {
      const MaskOf<Number> meets = plane::nearestRoot(u, in[16], v, w, in[17], in[18], leaves, t);
      out[0] = numberOf<Number>(meets);
      out[1] = choose(meets, t, Number(0));
      break;
    }
    case 10: {
      const MaskOf<Number> isHit = triangle::distance(u, v, w, triangle::areaNormal(u, v, w), x, t);
      out[0] = numberOf<Number>(isHit);
      out[1] = choose(isHit, t, Number(0));
      break;
    }
    case 11:
      out[0] = magnitudeOf(in[16], u, v, w, triangle::extent(x, y, u));
      break;
    case 12:
      put(mirrorDirection(u, v), out);
      break;
    case 13: {
      const MaskOf<Number> passes = refractedDirection(u, v, in[16], first);
      putWhere<Number>(passes, first, out);
      break;
    }
    case 14:
      out[0] = dielectricReflectance(a, b);
      out[1] = dielectricReflectance(a, 1.0);
      break;
    case 15:
      put(schlickReflectance(in[16], u), out);
      break;
    case 16:
      illuminate(u, v, w, x, first, second, s);
      put(first, out);
      put(second, out + 3);
      out[6] = s;
      break;
    case 17:
    case 18:
      t = formula == 17 ? phong_light::mirroredCosine(u, v, w)
                        : phong_light::halfwayCosine(u, v, w);
      put(phong_light::reflectedLight(v, w, t, x, y, Vector(in[16], in[17], in[18]), in[19],
                                      phong_light::Highlight::lit),
          out);
      break;
    case 19:
      put(eye_ray::direction(u, v, w, in[16], in[17], in[18]), out);
      put(Vector(eye_ray::origin(u, v, w, in[16], in[17], in[18]) +
                 matrix.transformPoint(u) * matrix.transformDirection(v) +
                 matrix.transposeTransformDirection(w)),
          out + 3);
      putMagnitude(matrix, u, out + 6);
      break;
  }
}

/// Formulas for rows of numbers: in[k] and out[k] are columns of kRows numbers.
constexpr int kRows = 8;
struct Lanes {
  void (*apply)(int formula, const Matrix& matrix, const double (*in)[kRows], double (*out)[kRows]);
  /// Packs the numbers and the row numbers whose bits are set; returns how many.
  int (*compress)(const double* numbers, const std::uint16_t* rows, unsigned bits, double* out,
                  std::uint16_t* rowsOut);
  /// Gathers the rows of a column, and sets the first lane of each vector to the last one's number.
  void (*gather)(const double* column, const std::uint16_t* rows, double* out);
};

/// Of this translation unit's instruction set: a template, so that each has its own.
template <class Number>
struct OfLanes {
  static constexpr int kWidth = int(sizeof(Number) / sizeof(double));

  static void apply(int formula, const Matrix& matrix, const double (*in)[kRows],
                    double (*out)[kRows]) {
    for (int row = 0; row < kRows; row += kWidth) {
      Number numbers[kInputs], results[kOutputs] = {};
      for (int k = 0; k < kInputs; ++k) numbers[k] = Number::load(in[k] + row);
      for (int k = 0; k < kOutputs; ++k) results[k] = 0;
      wide::apply(formula, matrix, numbers, results);
      for (int k = 0; k < kOutputs; ++k) results[k].store(out[k] + row);
    }
  }
  static int compress(const double* numbers, const std::uint16_t* rows, unsigned bits, double* out,
                      std::uint16_t* rowsOut) {
    const double* const begin = out;
    for (int row = 0; row < kRows; row += kWidth) {
      const unsigned some = bits >> row & ((1u << kWidth) - 1);
      out = lanes::compress(Number::load(numbers + row), some, out);
      rowsOut = lanes::compressRows(rows + row, some, rowsOut);
    }
    return int(out - begin);
  }
  static void gather(const double* column, const std::uint16_t* rows, double* out) {
    for (int row = 0; row < kRows; row += kWidth) {
      Number::gather(column, rows + row).store(out + row);
    }
  }
};

inline namespace {
Lanes ofThisUnit() {
  using Of = OfLanes<lanes::Doubles>;
  return {Of::apply, Of::compress, Of::gather};
}
}  // namespace

Lanes avx2Lanes();
Lanes avx512Lanes();

}  // namespace wide
