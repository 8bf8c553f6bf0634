// Gradient noise: at each corner of the unit cell around the point a gradient, picked by hashing
// the corner; their ramps are blended by a curve whose first two derivatives vanish at both ends.
//
//   1. Split the point into the cell's whole coordinates (i, j, k), modulo 256, and the place
//      (x, y, z) within it, 0..1.
//   2. For each of the eight corners look up a gradient: P[P[P[i] + j] + k] in a table of the
//      numbers 0..255 in random order. Its ramp is the scalar product of the gradient with the way
//      from the corner to the point: 0 at the corner.
//   3. Blend the eight ramps along x, then y, then z, by 6 t^5 - 15 t^4 + 10 t^3.
#include "math/perlin_noise.h"

#include <cassert>

namespace math {
namespace {

/// The permutation of Perlin's reference, a published constant.
constexpr std::uint8_t kPermutation[256] = {
    151, 160, 137, 91,  90,  15,  131, 13,  201, 95,  96,  53,  194, 233, 7,   225, 140, 36,  103,
    30,  69,  142, 8,   99,  37,  240, 21,  10,  23,  190, 6,   148, 247, 120, 234, 75,  0,   26,
    197, 62,  94,  252, 219, 203, 117, 35,  11,  32,  57,  177, 33,  88,  237, 149, 56,  87,  174,
    20,  125, 136, 171, 168, 68,  175, 74,  165, 71,  134, 139, 48,  27,  166, 77,  146, 158, 231,
    83,  111, 229, 122, 60,  211, 133, 230, 220, 105, 92,  41,  55,  46,  245, 40,  244, 102, 143,
    54,  65,  25,  63,  161, 1,   216, 80,  73,  209, 76,  132, 187, 208, 89,  18,  169, 200, 196,
    135, 130, 116, 188, 159, 86,  164, 100, 109, 198, 173, 186, 3,   64,  52,  217, 226, 250, 124,
    123, 5,   202, 38,  147, 118, 126, 255, 82,  85,  212, 207, 206, 59,  227, 47,  16,  58,  17,
    182, 189, 28,  42,  223, 183, 170, 213, 119, 248, 152, 2,   44,  154, 163, 70,  221, 153, 101,
    155, 167, 43,  172, 9,   129, 22,  39,  253, 19,  98,  108, 110, 79,  113, 224, 232, 178, 185,
    112, 104, 218, 246, 97,  228, 251, 34,  242, 193, 238, 210, 144, 12,  191, 179, 162, 241, 81,
    51,  145, 235, 249, 14,  239, 107, 49,  192, 214, 31,  181, 199, 106, 157, 184, 84,  204, 176,
    115, 121, 50,  45,  127, 4,   150, 254, 138, 236, 205, 93,  222, 114, 67,  29,  24,  72,  243,
    141, 128, 195, 78,  66,  215, 61,  156, 180};

int hashed(int i) { return kPermutation[i & 255]; }

/// The blending curve, 0 at 0 and 1 at 1.
double faded(double t) { return t * t * t * (t * (t * 6 - 15) + 10); }

/// a at t = 0, b at t = 1.
double between(double t, double a, double b) { return a + t * (b - a); }

/// The gradients: from the middle of a cube to the middles of its 12 edges; four come twice, to
/// make 16.
constexpr double kGradients[16][3] = {
    {1, 1, 0}, {-1, 1, 0}, {1, -1, 0}, {-1, -1, 0}, {1, 0, 1}, {-1, 0, 1}, {1, 0, -1}, {-1, 0, -1},
    {0, 1, 1}, {0, -1, 1}, {0, 1, -1}, {0, -1, -1}, {1, 1, 0}, {0, -1, 1}, {-1, 1, 0}, {0, -1, -1}};

/// The scalar product of a gradient and (x, y, z): products with 0 and 1 round nothing. A table and
/// no choices, which the processor cannot foresee: noise took 140 ns and takes 28.
double ramp(int hash, double x, double y, double z) {
  const double* g = kGradients[hash & 15];
  return g[0] * x + g[1] * y + g[2] * z;
}

}  // namespace

int floorBits(double x, int bits) {
  const double whole = std::floor(x);
  // From 2^60 on doubles are multiples of 2^8. Smaller ones fit in 64 bits; NaN compares false.
  if (!(std::fabs(whole) < 0x1p60)) return 0;
  return int(std::uint64_t(std::int64_t(whole)) & ((1u << bits) - 1));
}

double noise(const Vec3d& p) {
  if (dot(p, Vec3d()) != 0) return 0;  // 0 times what is infinite or NaN is NaN
  const double x = p.x() - std::floor(p.x()), y = p.y() - std::floor(p.y()),
               z = p.z() - std::floor(p.z());
  const double u = faded(x), v = faded(y), w = faded(z);
  const int i = floorBits(p.x(), 8), j = floorBits(p.y(), 8), k = floorBits(p.z(), 8);
  // What the ramps of the cell's edge along x at (y + dy, z + dz) come to, by what x and y hash to.
  const auto edge = [&](int left, int right, int dy, int dz) {
    return between(u, ramp(hashed(left + k + dz), x, y - dy, z - dz),
                   ramp(hashed(right + k + dz), x - 1, y - dy, z - dz));
  };
  const int left = hashed(i), right = hashed(i + 1);
  const int leftLow = hashed(left + j), rightLow = hashed(right + j);
  const int leftHigh = hashed(left + j + 1), rightHigh = hashed(right + j + 1);
  return between(w, between(v, edge(leftLow, rightLow, 0, 0), edge(leftHigh, rightHigh, 1, 0)),
                 between(v, edge(leftLow, rightLow, 0, 1), edge(leftHigh, rightHigh, 1, 1)));
}

double fractalNoise(const Vec3d& p, int octaves) {
  assert(octaves >= 0 && octaves <= kMaxOctaves);
  // The scale is a power of two: to multiply or divide by it rounds nothing.
  double sum = 0, scale = 1;
  for (int i = 0; i < octaves; ++i) {
    sum += noise(p * scale) / scale;
    scale *= 2;
  }
  return sum;
}

}  // namespace math
