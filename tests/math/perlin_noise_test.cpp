// math::noise against published values, values derived by hand, and the definition written down a
// second time: a sum over eight corners in long double.
#include "math/perlin_noise.h"

#include <limits>

#include "check.h"
#include "random.h"
#include "vectors.h"

namespace {

constexpr double kInf = std::numeric_limits<double>::infinity();
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kLargest = std::numeric_limits<double>::max();

/// Perlin's permutation as published in 2002, typed once more: 16 entries a line.
const int kPublished[256] = {
    151, 160, 137, 91,  90,  15,  131, 13,  201, 95,  96,  53,  194, 233, 7,   225,  //
    140, 36,  103, 30,  69,  142, 8,   99,  37,  240, 21,  10,  23,  190, 6,   148,  //
    247, 120, 234, 75,  0,   26,  197, 62,  94,  252, 219, 203, 117, 35,  11,  32,   //
    57,  177, 33,  88,  237, 149, 56,  87,  174, 20,  125, 136, 171, 168, 68,  175,  //
    74,  165, 71,  134, 139, 48,  27,  166, 77,  146, 158, 231, 83,  111, 229, 122,  //
    60,  211, 133, 230, 220, 105, 92,  41,  55,  46,  245, 40,  244, 102, 143, 54,   //
    65,  25,  63,  161, 1,   216, 80,  73,  209, 76,  132, 187, 208, 89,  18,  169,  //
    200, 196, 135, 130, 116, 188, 159, 86,  164, 100, 109, 198, 173, 186, 3,   64,   //
    52,  217, 226, 250, 124, 123, 5,   202, 38,  147, 118, 126, 255, 82,  85,  212,  //
    207, 206, 59,  227, 47,  16,  58,  17,  182, 189, 28,  42,  223, 183, 170, 213,  //
    119, 248, 152, 2,   44,  154, 163, 70,  221, 153, 101, 155, 167, 43,  172, 9,    //
    129, 22,  39,  253, 19,  98,  108, 110, 79,  113, 224, 232, 178, 185, 112, 104,  //
    218, 246, 97,  228, 251, 34,  242, 193, 238, 210, 144, 12,  191, 179, 162, 241,  //
    81,  51,  145, 235, 249, 14,  239, 107, 49,  192, 214, 31,  181, 199, 106, 157,  //
    184, 84,  204, 176, 115, 121, 50,  45,  127, 4,   150, 254, 138, 236, 205, 93,   //
    222, 114, 67,  29,  24,  72,  243, 141, 128, 195, 78,  66,  215, 61,  156, 180};

/// From the middle of a cube to the middles of its edges; the last four make a tetrahedron.
const int kGradients[16][3] = {
    {1, 1, 0}, {-1, 1, 0}, {1, -1, 0}, {-1, -1, 0}, {1, 0, 1}, {-1, 0, 1}, {1, 0, -1}, {-1, 0, -1},
    {0, 1, 1}, {0, -1, 1}, {0, 1, -1}, {0, -1, -1}, {1, 1, 0}, {0, -1, 1}, {-1, 1, 0}, {0, -1, -1}};

const int* gradientAt(long i, long j, long k) {
  const auto hash = [](long n) { return long(kPublished[((n % 256) + 256) % 256]); };
  return kGradients[hash(hash(hash(i) + j) + k) % 16];
}

/// The sum over the cell's corners of (gradient . way from the corner) times a weight that falls
/// from 1 at the corner to 0 at the opposite faces.
long double defined(const Vec3d& p) {
  const long double base[3] = {std::floor(p.x()), std::floor(p.y()), std::floor(p.z())};
  long double sum = 0;
  for (int corner = 0; corner < 8; ++corner) {
    const int step[3] = {corner & 1, corner >> 1 & 1, corner >> 2};
    const int* gradient =
        gradientAt(long(base[0]) + step[0], long(base[1]) + step[1], long(base[2]) + step[2]);
    long double weight = 1, ramp = 0;
    for (int axis = 0; axis < 3; ++axis) {
      const long double way = (long double)(p[axis]) - base[axis] - step[axis];
      const long double t = 1 - std::fabs(way);
      weight *= 6 * t * t * t * t * t - 15 * t * t * t * t + 10 * t * t * t;
      ramp += gradient[axis] * way;
    }
    sum += weight * ramp;
  }
  return sum;
}

}  // namespace

TEST("the noise has the published values") {
  // Perlin's reference gives these two (Rosetta Code, "Perlin noise", shows the first).
  CHECK_NEAR(math::noise({3.14, 42, 7}), 0.13691995878400012, 1e-15);
  CHECK_EQUAL(math::noise({0.5, 0.5, 0.5}), -0.25);
}

TEST("the noise in the middle of a cell is the mean of its eight ramps") {
  // Hashes of the corners of the cell at 0: P[0] = 151, P[1] = 160; P[151] = 17, P[152] = 182,
  // P[160] = 119, P[161] = 248; then, for z = 0 and 1, P[17], P[18] = 36, 103; P[182], P[183] =
  // 108, 110; P[119], P[120] = 86, 164; P[248], P[249] = 128, 195. Their last four bits are 4, 7;
  // 12, 14; 6, 4; 0, 3: the gradients (1,0,1), (-1,0,-1); (1,1,0), (-1,1,0); (1,0,-1), (1,0,1);
  // (1,1,0), (-1,-1,0). Times the ways (+-1/2, +-1/2, +-1/2) from the corners: 1, 0; 0, -1; -1, -1;
  // -1, 1. Every weight is 1/8: -2 / 8.
  CHECK_EQUAL(math::noise({0.5, 0.5, 0.5}), -0.25);
  // On the cell's edge from 0 along x only two corners count, (1,0,1) and (1,0,-1), by 1/2 each:
  // (1/2 - 1/2) / 2.
  CHECK_EQUAL(math::noise({0.5, 0, 0}), 0.0);
  // Along y from 0: (1,0,1) . (0, 1/2, 0) = 0 and (1,1,0) . (0, -1/2, 0) = -1/2, by 1/2 each.
  CHECK_EQUAL(math::noise({0, 0.5, 0}), -0.25);
  // Along z from 0: (1,0,1) . (0, 0, 1/2) = 1/2 and (-1,0,-1) . (0, 0, -1/2) = 1/2.
  CHECK_EQUAL(math::noise({0, 0, 0.5}), 0.5);
}

TEST("the noise is zero wherever all coordinates are whole") {
  Random random(901);
  for (int i = 0; i < 2000; ++i) {
    const double range = random.logUniform(1, 1e300);
    const Vec3d p = random.inCube(-range, range);
    CHECK_EQUAL(math::noise({std::floor(p.x()), std::floor(p.y()), std::floor(p.z())}), 0.0);
  }
}

TEST("random noise equals its definition") {
  Random random(902);
  check::Cases cases;
  for (int i = 0; i < 20000; ++i) {
    const double range = random.logUniform(0.1, 1e6);
    const Vec3d p = random.inCube(-range, range);
    const double found = math::noise(p);
    cases.expect(std::fabs(found - double(defined(p))) < 1e-14,
                 [&] { return check::show(p) + " found " + check::show(found); });
  }
  CHECK_EQUAL(cases.firstFailure(), "");
}

TEST("the noise comes again after 256 units, to the left of 0 as well") {
  Random random(903);
  for (int i = 0; i < 1000; ++i) {
    // Multiples of 1/1024: moving them rounds nothing.
    const int x = random.index(4096), y = random.index(4096), z = random.index(4096);
    const Vec3d p = Vec3d(x, y, z) / 1024;
    for (const double move : {256.0, -256.0, -1024.0, 0x1p40}) {
      CHECK_EQUAL(math::noise(p + Vec3d(move, 0, -move)), math::noise(p));
    }
  }
}

TEST("the noise of points without bounds is finite") {
  for (const double x : {1e300, -1e300, kLargest, -kLargest, 0x1p52, 0x1p62, -0x1p63, 0x1p64}) {
    CHECK_EQUAL(math::noise({x, -x, x}), 0.0);
    CHECK_EQUAL(math::noise({x, 0.5, -x}), math::noise({0, 0.5, 0}));
  }
  for (const double x : {kInf, -kInf, kNan}) {
    for (int axis = 0; axis < 3; ++axis) {
      Vec3d p(0.25, 0.5, 0.5);
      p[axis] = x;
      CHECK_EQUAL(math::noise(p), 0.0);
      CHECK_EQUAL(math::fractalNoise(p, math::kMaxOctaves), 0.0);
    }
  }
  Random random(904);
  for (int i = 0; i < 3000; ++i) {
    const double range = random.logUniform(1e-300, 1e308);
    const double sum = math::fractalNoise(random.inCube(-range, range), math::kMaxOctaves);
    CHECK(std::fabs(sum) < 2.1);
  }
}

TEST("octaves are noise of half the size and half the strength, added up") {
  Random random(905);
  for (int i = 0; i < 200; ++i) {
    const Vec3d p = random.inCube(-20, 20);
    long double sum = 0;
    for (int octave = 0; octave < math::kMaxOctaves; ++octave) {
      const double scale = std::ldexp(1.0, octave);
      sum += (long double)(math::noise({scale * p.x(), scale * p.y(), scale * p.z()})) / scale;
      CHECK_NEAR(math::fractalNoise(p, octave + 1), double(sum), 1e-14);
    }
  }
}

TEST("the last bits of a floor are right for every double") {
  CHECK_EQUAL(math::floorBits(-0.5, 1), 1);
  CHECK_EQUAL(math::floorBits(-0.0, 1), 0);
  CHECK_EQUAL(math::floorBits(-1, 8), 255);
  CHECK_EQUAL(math::floorBits(-256, 8), 0);
  CHECK_EQUAL(math::floorBits(0x1p53 - 1, 1), 1);
  CHECK_EQUAL(math::floorBits(1 - 0x1p53, 1), 1);
  for (const double x : {kInf, -kInf, kNan, kLargest, -kLargest, 1e300, -0x1p63, 0x1p63}) {
    CHECK_EQUAL(math::floorBits(x, 8), 0);
  }
  Random random(906);
  for (int i = 0; i < 5000; ++i) {
    const double x = random.logUniform(1e-3, 1e30) * (i % 2 == 0 ? 1 : -1);
    double expected = std::fmod(std::floor(x), 256);  // exact
    if (expected < 0) expected += 256;
    CHECK_EQUAL(double(math::floorBits(x, 8)), expected);
    CHECK_EQUAL(math::floorBits(x, 1), int(expected) % 2);
  }
}
