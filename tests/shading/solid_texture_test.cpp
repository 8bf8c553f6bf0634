// Solid textures: what they are made of at a point, against their formulas, and textures of
// textures against the definition that splits each of them in two.
#include "shading/solid_texture.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "check.h"
#include "math/functions.h"
#include "math/perlin_noise.h"
#include "random.h"
#include "shading/phong_material.h"
#include "vectors.h"

namespace {

PhongMaterial plain(const Vec3f& diffuse) {
  return PhongMaterial(diffuse, Vec3f(), 1, Vec3f(), Vec3f(), 1);
}

/// Two materials to make textures of, numbers 0 and 1 of a scene.
struct Pair {
  Pair() {
    black.setNumber(0);
    white.setNumber(1);
  }
  PhongMaterial black = plain({0, 0, 0}), white = plain({1, 1, 1});
  const Material *first = &black, *second = &white;
};

/// A noise that is material number `number` of a scene.
std::unique_ptr<Noise> numbered(std::size_t number, const Material* first, const Material* second,
                                int octaves) {
  auto noise = std::make_unique<Noise>(Matrix(), first, second, octaves);
  noise->setNumber(int(number));
  return noise;
}

/// The weight of a material in a texture; 0 where it has no part.
double weightOf(const Material& material, const SolidTexture& texture, const Vec3d& point) {
  double weight = 0;
  for (const WeightedMaterial& part : texture.materialsAt(point)) {
    if (part.material == &material) weight += part.weight;
  }
  return weight;
}

}  // namespace

TEST("a checkerboard is of one material in each cube, by the parity of its floors") {
  const Pair pair;
  const Checkerboard board(Matrix(), pair.first, pair.second);
  const auto isSecond = [&](const Vec3d& p) {
    const auto parts = board.materialsAt(p);
    CHECK_EQUAL(parts.size(), std::size_t(1));
    CHECK_EQUAL(parts[0].weight, 1.0);
    return parts[0].material == &pair.white;
  };
  CHECK(!isSecond({0.5, 0.5, 0.5}));
  CHECK(isSecond({1.5, 0.5, 0.5}) && isSecond({0.5, 1.5, 0.5}) && isSecond({0.5, 0.5, 1.5}));
  CHECK(!isSecond({1.5, 1.5, 0.5}) && isSecond({1.5, 1.5, 1.5}));
  CHECK(isSecond({-0.5, 0.5, 0.5}) && !isSecond({-0.5, 0.5, -0.5}) && !isSecond({-1.5, 0.5, 0.5}));
  CHECK(!isSecond({0, 0, 0}) && isSecond({1, 0, 0}) && isSecond({-1e-9, 0, 0}));
  // 2^53 - 1 is odd; from 2^53 on all doubles are even.
  CHECK(isSecond({0x1p53 - 1, 0, 0}) && !isSecond({0x1p53, 0, 0}) && !isSecond({-1e300, 0, 0}));
}

TEST("the cubes of a checkerboard have the side that is asked for, in the texture's space") {
  const Pair pair;
  const Checkerboard large(Matrix(), pair.first, pair.second, 2.5);
  CHECK_EQUAL(weightOf(pair.white, large, {2.4, 1, 1}), 0.0);
  CHECK_EQUAL(weightOf(pair.white, large, {2.6, 1, 1}), 1.0);
  // p' = M p: a scale of 2 makes cubes half as large.
  const Checkerboard scaled(Matrix::scale({2, 2, 2}), pair.first, pair.second);
  CHECK_EQUAL(weightOf(pair.white, scaled, {0.4, 0.1, 0.1}), 0.0);
  CHECK_EQUAL(weightOf(pair.white, scaled, {0.6, 0.1, 0.1}), 1.0);
  // M first scales, then moves by 1: x = 0.1 comes to 1.2.
  const Matrix moved = Matrix::translation({1, 0, 0}) * Matrix::scale({2, 2, 2});
  CHECK_EQUAL(weightOf(pair.white, Checkerboard(moved, pair.first, pair.second), {0.1, 0, 0}), 1.0);
}

TEST("a texture under a singular map forgets a coordinate") {
  const Pair pair;
  const Checkerboard flat(Matrix::scale({1, 0, 1}), pair.first, pair.second);
  for (const double y : {-1e-9, 0.0, 1.5, -7.5}) {
    CHECK_EQUAL(weightOf(pair.white, flat, {0.5, y, 0.5}), 0.0);
    CHECK_EQUAL(weightOf(pair.white, flat, {1.5, y, 0.5}), 1.0);
  }
}

TEST("noise, marble and wood have the weights of their formulas") {
  const Pair pair;
  Random random(911);
  check::Cases cases;
  for (int i = 0; i < 3000; ++i) {
    const int octaves = 1 + random.index(6);
    const double frequency = random.uniform(-9, 9), amplitude = random.uniform(-9, 9);
    const Matrix move = Matrix::translation(random.inCube(-5, 5)), turn = random.rotation();
    const Matrix matrix = move * turn * Matrix::scale(random.inCube(0.1, 3));
    const Vec3d point = random.inCube(-10, 10), p = matrix.transformPoint(point);
    long double n = 0;
    for (int k = 0; k < octaves; ++k) n += math::noise(p * std::ldexp(1.0, k)) / std::ldexp(1.0, k);
    const long double radius = std::sqrt((long double)(p.x()) * p.x() + p.z() * p.z());
    const long double expected[] = {
        std::min(std::max((1 + n) / 2, 0.0L), 1.0L),
        (1 + std::sin(frequency * (long double)(p.x()) + amplitude * n)) / 2,
        (1 + std::sin(frequency * radius + amplitude * n)) / 2};
    const Noise noise(matrix, pair.first, pair.second, octaves);
    const Marble marble(matrix, pair.first, pair.second, {octaves, frequency, amplitude});
    const Wood wood(matrix, pair.first, pair.second, {octaves, frequency, amplitude});
    const SolidTexture* const textures[] = {&noise, &marble, &wood};
    for (int kind = 0; kind < 3; ++kind) {
      const double white = weightOf(pair.white, *textures[kind], point);
      const double black = weightOf(pair.black, *textures[kind], point);
      cases.expect(
          std::fabs(white - double(expected[kind])) < 1e-12 && std::fabs(black + white - 1) < 1e-15,
          [&] {
            return "kind " + check::show(kind) + " at " + check::show(p) + ": " +
                   check::show(white);
          });
    }
  }
  CHECK_EQUAL(cases.firstFailure(), "");
}

TEST("a weight below 0 counts as 0, above 1 as 1, and NaN as 0") {
  class Fixed : public SolidTexture {
   public:
    Fixed(const Pair& pair, double weight)
        : SolidTexture("Fixed", Matrix(), pair.first, pair.second,
                       [weight](const Vec3d&) { return weight; }) {}
  };
  const Pair pair;
  for (const double weight : {-0.5, -1e300, std::nan(""), 0.0}) {
    const auto parts = Fixed(pair, weight).materialsAt({0, 0, 0});
    CHECK_EQUAL(parts.size(), std::size_t(1));
    CHECK(parts[0].material == &pair.black && parts[0].weight == 1);
  }
  for (const double weight : {1.0, 1.5, 1e300}) {
    const auto parts = Fixed(pair, weight).materialsAt({0, 0, 0});
    CHECK_EQUAL(parts.size(), std::size_t(1));
    CHECK(parts[0].material == &pair.white && parts[0].weight == 1);
  }
  CHECK_EQUAL(weightOf(pair.white, Fixed(pair, 0.25), {0, 0, 0}), 0.25);
}

TEST("marble runs across x and wood around y, exactly at whole points, where the noise is 0") {
  const Pair pair;
  const double quarter = math::kPi / 2;
  const Marble marble(Matrix(), pair.first, pair.second, {3, quarter, 100});
  const Wood wood(Matrix(), pair.first, pair.second, {3, quarter, 100});
  // sin(0), sin(pi/2), sin(pi), sin(3 pi/2), whatever the other coordinates are.
  CHECK_NEAR(weightOf(pair.white, marble, {0, 7, 3}), 0.5, 1e-15);
  CHECK_NEAR(weightOf(pair.white, marble, {1, -2, 5}), 1.0, 1e-15);
  CHECK_NEAR(weightOf(pair.white, marble, {2, 1, 1}), 0.5, 1e-15);
  CHECK_NEAR(weightOf(pair.white, marble, {3, 1, 1}), 0.0, 1e-15);
  // Radius 5, as 3 and 4 are: sin(5 pi/2) = 1.
  CHECK_NEAR(weightOf(pair.white, wood, {3, 8, 4}), 1.0, 1e-15);
  CHECK_NEAR(weightOf(pair.white, wood, {0, 1, -3}), 0.0, 1e-15);
  CHECK_NEAR(weightOf(pair.white, wood, {0, 1, 0}), 0.5, 1e-15);
}

TEST("points beyond all bounds are of the first material, or of both where the noise fades out") {
  constexpr double kLargest = std::numeric_limits<double>::max();
  constexpr double kInf = std::numeric_limits<double>::infinity();
  const Pair pair;
  const Checkerboard board(Matrix(), pair.first, pair.second, 1e-300);
  const Noise noise(Matrix(), pair.first, pair.second, 32);
  const Marble marble(Matrix(), pair.first, pair.second, {32, 1e300, 1e300});
  const Wood wood(Matrix(), pair.first, pair.second, {32, 1e300, 1e300});
  for (const double x : {1e300, -1e300, kLargest, kInf, std::nan("")}) {
    CHECK_EQUAL(weightOf(pair.black, board, {x, -x, x}), 1.0);
    CHECK_EQUAL(weightOf(pair.black, noise, {x, -x, x}), 0.5);
    CHECK_EQUAL(weightOf(pair.black, marble, {x, -x, x}), 1.0);
    CHECK_EQUAL(weightOf(pair.black, wood, {x, -x, x}), 1.0);
  }
}

TEST("parts that are equal are one, with all their weight") {
  const Pair pair;
  const Noise same(Matrix(), pair.first, pair.first, 5);
  const auto parts = same.materialsAt({0.3, 0.4, 0.7});
  CHECK_EQUAL(parts.size(), std::size_t(1));
  CHECK_EQUAL(parts[0].weight, 1.0);
  // A texture of one material twice changes no bit of the weights above it.
  const Noise direct(Matrix(), pair.first, pair.second, 5);
  const auto twice = numbered(2, pair.second, pair.second, 3);
  const Noise outer(Matrix(), pair.first, twice.get(), 5);
  Random random(913);
  for (int i = 0; i < 300; ++i) {
    const Vec3d p = random.inCube(-9, 9);
    CHECK_EQUAL(weightOf(pair.white, outer, p), weightOf(pair.white, direct, p));
  }
  // At whole points every noise is a half: b = (black + white) / 2, c = (b + black) / 2.
  const auto b = numbered(2, pair.first, pair.second, 5);
  const Noise c(Matrix(), b.get(), pair.first, 5);
  CHECK_EQUAL(c.materialsAt({1, 2, 3}).size(), std::size_t(2));
  CHECK_EQUAL(weightOf(pair.black, c, {1, 2, 3}), 0.75);
  CHECK_EQUAL(weightOf(pair.white, c, {1, 2, 3}), 0.25);
}

namespace {

/// By the definition: each texture is split in two, however often it comes.
void splitInTwo(const Material& material, const std::vector<std::unique_ptr<Noise>>& noises,
                const std::vector<std::pair<int, int>>& halves,
                const std::vector<PhongMaterial>& leaves, const Vec3d& p, long double weight,
                std::vector<long double>& sums) {
  for (std::size_t i = 0; i < leaves.size(); ++i) {
    if (&leaves[i] == &material) sums[i] += weight;
  }
  for (std::size_t i = 0; i < noises.size(); ++i) {
    if (noises[i].get() != &material) continue;
    const long double second = (1 + (long double)(math::fractalNoise(p, 1 + int(i) % 3))) / 2;
    const auto at = [&](int number) -> const Material& {
      if (number < int(leaves.size())) return leaves[std::size_t(number)];
      return *noises[std::size_t(number) - leaves.size()];
    };
    splitInTwo(at(halves[i].first), noises, halves, leaves, p, weight * (1 - second), sums);
    splitInTwo(at(halves[i].second), noises, halves, leaves, p, weight * second, sums);
  }
}

}  // namespace

TEST("random textures of textures come down to what splitting each of them in two gives") {
  Random random(912);
  check::Cases cases;
  std::vector<PhongMaterial> leaves(3, plain({1, 1, 1}));
  for (std::size_t i = 0; i < 3; ++i) leaves[i].setNumber(int(i));
  for (int round = 0; round < 100; ++round) {
    std::vector<std::unique_ptr<Noise>> noises;
    std::vector<std::pair<int, int>> halves;
    const auto part = [&](int number) -> const Material* {
      if (number < 3) return &leaves[std::size_t(number)];
      return noises[std::size_t(number) - 3].get();
    };
    for (int i = 0; i < 8; ++i) {
      const int a = random.index(3 + i), b = random.index(3 + i);
      halves.push_back({a, b});
      noises.push_back(numbered(noises.size() + 3, part(a), part(b), 1 + i % 3));
    }
    const Vec3d p = random.inCube(-9, 9);
    std::vector<long double> expected(3, 0);
    splitInTwo(*noises.back(), noises, halves, leaves, p, 1, expected);
    for (std::size_t i = 0; i < 3; ++i) {
      const double found = weightOf(leaves[i], *noises.back(), p);
      cases.expect(std::fabs(found - double(expected[i])) < 1e-14,
                   [&] { return "round " + check::show(round) + ": " + check::show(found); });
    }
    const auto parts = noises.back()->materialsAt(p);
    for (std::size_t i = 1; i < parts.size(); ++i) {
      cases.expect(parts[i - 1].material > parts[i].material, [] { return "order of numbers"; });
    }
  }
  CHECK_EQUAL(cases.firstFailure(), "");
}

TEST("a hundred thousand textures, each of the two before it, come down to two parts at once") {
  const Pair pair;
  std::vector<std::unique_ptr<Noise>> noises;
  std::vector<const Material*> parts = {pair.first, pair.second};
  for (std::size_t i = 2; i < 100000; ++i) {
    noises.push_back(numbered(i, parts[i - 1], parts[i - 2], 1));
    parts.push_back(noises.back().get());
  }
  const auto found = noises.back()->materialsAt({1, 2, 3});
  // With halves throughout, the share that reaches number 1 is s(1) = 2/3: from above, the weight
  // that passes number k is 1/2 of that at k + 1 and 1/2 of that at k + 2, which tends to 2/3; of
  // what passes number 2 (2/3) half goes to 1 and half to 0, and of number 3 (2/3) half goes to 1.
  CHECK_EQUAL(found.size(), std::size_t(2));
  CHECK(found[0].material == &pair.white && found[1].material == &pair.black);
  CHECK_NEAR(found[0].weight, 2 / 3.0, 1e-12);
  CHECK_NEAR(found[1].weight, 1 / 3.0, 1e-12);
}

TEST("a deep chain of halves fades into its plain materials") {
  // Every texture is half of the next one below and half a plain material of its own.
  constexpr std::size_t kLevels = 3000;
  std::vector<PhongMaterial> leaves(kLevels + 1, plain({1, 1, 1}));
  std::vector<std::unique_ptr<Noise>> noises;
  const Material* below = &leaves[0];
  leaves[0].setNumber(0);
  for (std::size_t i = 1; i <= kLevels; ++i) {
    leaves[i].setNumber(int(2 * i));
    noises.push_back(numbered(2 * i + 1, below, &leaves[i], 1));
    below = noises.back().get();
  }
  const auto parts = noises.back()->materialsAt({0, 0, 0});
  CHECK(parts.size() > 1000 && parts.size() < 1080);  // 2^-1074 is the least double
  double expected = 0.5;
  for (std::size_t i = 0; i < 1000; ++i, expected /= 2) {
    CHECK(parts[i].material == &leaves[kLevels - i]);
    CHECK_EQUAL(parts[i].weight, expected);
  }
}

TEST("a texture sends back the mean of its parts' light, and has the largest of their colours") {
  PhongMaterial red({1, 0, 0.5f}, {0, 0, 0}, 1, {0.1f, 0.5f, 0}, {0.3f, 0, 0}, 1.5f);
  PhongMaterial blue({0, 0, 1}, {0, 0, 0}, 1, {0.2f, 0, 0}, {0, 0.4f, 0}, 2);
  red.setNumber(0);
  blue.setNumber(1);
  const auto inner = numbered(2, &red, &blue, 1);
  const Noise noise(Matrix(), &red, inner.get(), 1);
  CHECK_EQUAL(noise.getDiffuseColor(), Vec3f(1, 0, 1));
  CHECK_EQUAL(noise.getTransparentColor(), Vec3f(0.2f, 0.5f, 0));
  CHECK_EQUAL(noise.getReflectiveColor(), Vec3f(0.3f, 0.4f, 0));
  CHECK(noise.asTexture() == &noise && !red.asTexture());
  // Halves at the whole point (0, 0, 0): three quarters red, one quarter blue.
  const Ray ray({0, 5, 0}, {0, -1, 0});
  Hit hit;
  hit.record(5, &noise, {0, 1, 0}, ray.pointAtParameter(5), {});
  CHECK_NEAR_VECTOR(noise.Shade(ray, hit, {0, 1, 0}, {1, 1, 1}), Vec3d(0.75, 0, 0.625), 1e-7);
}

TEST("the slope of a noise says how fast its materials change, and into which") {
  const Pair pair;
  Random random(11);
  for (int i = 0; i < 100; ++i) {
    const Vec3d p = random.inCube(-9, 9);
    const double n = math::fractalNoise(p, 3);
    const double second = weightOf(pair.white, Noise(Matrix(), pair.first, pair.second, 3, -1), p);
    CHECK_NEAR(1 - second, std::clamp(n + 0.5, 0.0, 1.0), 1e-15);
  }
}

TEST("waves of height -1 exchange a marble's materials") {
  const Pair pair;
  const Marble marble(Matrix(), pair.first, pair.second, {1, math::kPi / 2, 0, -1});
  // At x = 1 the sine is 1, so that all is of the first material; at x = 3 all of the second.
  CHECK_NEAR(weightOf(pair.black, marble, {1, 0.3, 0.2}), 1, 1e-15);
  CHECK_NEAR(weightOf(pair.white, marble, {3, 0.3, 0.2}), 1, 1e-15);
  CHECK_NEAR(weightOf(pair.black, marble, {1 / 3.0, 5, 6}), 0.75, 1e-14);  // sin 30 degrees
}

TEST("grained wood is the square of a shifted sine of rings that lean") {
  const Pair pair;
  // Without noise: r = 5 from (3, y, 4), and y = 20 adds 1. sin(pi r / 2) = 1, 0, -1, 0 for r = 5
  // to 8: s = 1, 1/2, 0, 1/2.
  const GrainedWood rings(Matrix(), pair.first, pair.second, {2, math::kPi / 2, 0});
  const double expected[] = {1, 0.25, 0, 0.25};
  for (int k = 0; k < 4; ++k) {
    CHECK_NEAR(weightOf(pair.black, rings, {3, 20.0 * k, 4}), expected[k], 1e-14);
  }
  CHECK_NEAR(weightOf(pair.black, rings, {0, 1 / 0.15, 0}), 1, 1e-14);  // sin 30 degrees: s = 1
  // The noise is that of a place five times nearer along y.
  const GrainedWood grain(Matrix(), pair.first, pair.second, {3, 0, 1});
  const Vec3d p(0.3, 2.5, -1.7);
  const double s = 0.5 + std::sin(math::fractalNoise({0.3, 0.5, -1.7}, 3));
  CHECK_NEAR(weightOf(pair.black, grain, p), std::clamp(s, 0.0, 1.0) * std::clamp(s, 0.0, 1.0),
             1e-14);
}

TEST("without octaves there is no noise") {
  const Pair pair;
  CHECK_EQUAL(math::fractalNoise({0.3, 0.4, 0.5}, 0), 0.0);
  CHECK_EQUAL(weightOf(pair.white, Noise(Matrix(), pair.first, pair.second, 0), {0.3, 0.4, 0.5}),
              0.5);
}
