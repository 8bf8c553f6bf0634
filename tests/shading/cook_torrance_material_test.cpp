// CookTorranceMaterial: against the published formula, and that it sends back no more than it gets.
#include "shading/cook_torrance_material.h"

#include "random.h"
#include "shading/hemisphere.h"
#include "vectors.h"

using Distribution = CookTorranceMaterial::Distribution;
using hemisphere::answer;
using hemisphere::direction;

namespace {

constexpr Distribution kBoth[] = {Distribution::ggx, Distribution::beckmann};
const Vec3f kBlack(0, 0, 0), kWhite(1, 1, 1);

CookTorranceMaterial rough(const Vec3f& diffuse, const Fresnel& fresnel, float roughness,
                           Distribution distribution) {
  return CookTorranceMaterial(diffuse, fresnel, roughness, distribution, kBlack, kBlack, 1);
}

/// D of the paper by the angle t between n and h.
long double density(long double t, long double m, Distribution distribution) {
  const long double pi = std::acos(-1.0L), c = std::cos(t), s = std::sin(t);
  if (distribution == Distribution::beckmann) {
    return std::exp(-std::pow(std::tan(t) / m, 2.0L)) / (pi * m * m * std::pow(c, 4.0L));
  }
  return m * m / (pi * std::pow(m * m * c * c + s * s, 2.0L));
}

/// The part of the mirrors in GGX that a direction at this angle's cosine sees.
long double seenFrom(long double cosine, long double alpha) {
  const long double tangent = std::sqrt(1 - std::min(1.0L, cosine * cosine)) / cosine;
  return 2 / (1 + std::hypot(1.0L, alpha * tangent));
}

/// Fresnel's reflectance by Snell's law for n > 1, or Schlick's for a colour.
long double reflectance(long double cosine, long double n) {
  const long double inside = std::sqrt(1 - (1 - cosine * cosine) / (n * n));
  const long double across = (cosine - n * inside) / (cosine + n * inside);
  const long double along = (n * cosine - inside) / (n * cosine + inside);
  return (across * across + along * along) / 2;
}
long double schlick(long double cosine, long double color) {
  return color + (1 - color) * std::pow(1 - cosine, 5.0L);
}

/// One surface, eye and light.
struct Case {
  Vec3d n, u;
  Vec3f l;
  float roughness;
  Distribution distribution;
};

/// pi f (n.l) with diffuseColor `diffuse`, F any function of the cosine.
template <class F>
double expectedAnswer(const Case& c, double diffuse, F fresnel) {
  const long double pi = std::acos(-1.0L), nl = dot(c.n, Vec3d(c.l)), nu = dot(c.n, c.u);
  const long double lu = dot(Vec3d(c.l), c.u), size = std::sqrt(2 + 2 * lu);
  const long double nh = std::min(1.0L, (nl + nu) / size), uh = (lu + 1) / size;
  const long double g = c.distribution == Distribution::ggx
                            ? seenFrom(nl, c.roughness) * seenFrom(nu, c.roughness)
                            : std::min({1.0L, 2 * nh * nu / uh, 2 * nh * nl / uh});
  const long double d = density(std::acos(nh), c.roughness, c.distribution);
  const long double f =
      diffuse / pi * (1 - fresnel(nl)) * (1 - fresnel(nu)) + d * fresnel(uh) * g / (4 * nl * nu);
  return double(pi * f * nl);
}

/// Of light from everywhere on a surface that mirrors all (F = 1), what goes straight up. With
/// x = tan^2 t the integral of D (n.h) G over h is that of p(x) G, p = exp(-x/a)/a for Beckmann and
/// a/(a+x)^2 for GGX, a the squared roughness; u = n, so u.h = n.h and, with
/// n.l = cos 2t = (1 - x) / (1 + x), G = min(1, 2 n.l) for Beckmann and seenFrom(n.l) for GGX, for
/// x < 1, beyond which l is below the surface.
double straightUp(double roughness, Distribution distribution) {
  const double a = roughness * roughness;
  double sum = 0;
  constexpr int kSteps = 100000;
  for (int i = 0; i < kSteps; ++i) {
    const double s = (i + 0.5) / kSteps, x = s * s * s;  // finest near 0
    const double nl = (1 - x) / (1 + x);
    const double seen = distribution == Distribution::beckmann
                            ? std::exp(-x / a) / a * std::min(1.0, 2 * nl)
                            : a / ((a + x) * (a + x)) * double(seenFrom(nl, roughness));
    sum += seen * (3 * s * s) / kSteps;
  }
  return sum;
}

}  // namespace

TEST("a Cook-Torrance material has the colours and the index that it was made with") {
  const CookTorranceMaterial material({0.5f, 0.25f, 1}, Fresnel::ofIndex(2), 0.125f,
                                      Distribution::beckmann, {0.1f, 0.2f, 0.3f},
                                      {0.4f, 0.5f, 0.6f}, 1.5f);
  CHECK_EQUAL(material.getDiffuseColor(), Vec3f(0.5f, 0.25f, 1));
  CHECK_EQUAL(material.getTransparentColor(), Vec3f(0.1f, 0.2f, 0.3f));
  CHECK_EQUAL(material.getReflectiveColor(), Vec3f(0.4f, 0.5f, 0.6f));
  CHECK_EQUAL(material.getIndexOfRefraction(), 1.5f);
}

TEST("seen and lit straight from above the highlight is F0 / (4 m^2)") {
  // h = n: pi D = 1 / m^2, G = 1, F0 = ((1.5 - 1) / (1.5 + 1))^2 = 0.04; m = 0.5 makes it 0.04. The
  // diffuse light goes through the surface twice: 0.96^2.
  for (Distribution distribution : kBoth) {
    const CookTorranceMaterial dark = rough(kBlack, Fresnel::ofIndex(1.5f), 0.5f, distribution);
    CHECK_NEAR(answer(dark, {0, 0, 1}, {0, 0, 1}).x(), 0.04, 1e-8);
    const CookTorranceMaterial light = rough(kWhite, Fresnel::ofIndex(1.5f), 0.5f, distribution);
    CHECK_NEAR(answer(light, {0, 0, 1}, {0, 0, 1}).x(), 0.04 + 0.9216, 1e-7);
    // A metal has its own colour, and no diffuse light where it mirrors everything.
    const CookTorranceMaterial metal =
        rough(kWhite, Fresnel::ofColor({1, 0.5f, 0}), 0.5f, distribution);
    CHECK_NEAR_VECTOR(answer(metal, {0, 0, 1}, {0, 0, 1}), Vec3d(1, 0.75, 1), 1e-7);
  }
}

TEST("random Cook-Torrance answers equal the published formula in long double") {
  Random random(521);
  check::Cases cases;
  while (cases.tried() < 40000) {
    const Case c{random.unitVector(), random.unitVector(), Vec3f(random.unitVector()),
                 float(random.logUniform(0.05, 2)), kBoth[random.index(2)]};
    if (dot(c.n, c.u) < 0.01 || dot(c.n, Vec3d(c.l)) < 0.01) continue;
    if (length(c.u + Vec3d(c.l)) < 0.2) continue;  // h would have few good digits
    const float index = float(random.uniform(1.01, 4)), color = float(random.uniform(0, 1));
    const bool hasIndex = random.index(2) == 0;
    const double diffuse = random.index(2) * 0.5;
    const CookTorranceMaterial material =
        rough(Vec3f(1, 1, 1) * float(diffuse),
              hasIndex ? Fresnel::ofIndex(index) : Fresnel::ofColor({color, color, color}),
              c.roughness, c.distribution);
    const double expected = expectedAnswer(c, diffuse, [&](long double cosine) {
      return hasIndex ? reflectance(cosine, index) : schlick(cosine, color);
    });
    const double found = answer(material, c.u, c.l, c.n).x();
    // A direction in single precision is off by 1e-7, which the steep sides of the smoothest
    // highlights make some 1e-4 of it.
    cases.expect(std::fabs(found - expected) < 2e-4 * expected + 1e-9, [&] {
      return "roughness " + check::show(c.roughness) + ", l " + check::show(c.l) + ", u " +
             check::show(c.u) + ", n " + check::show(c.n) + ": " + check::show(found) +
             ", expected " + check::show(expected);
    });
  }
  CHECK_EQUAL(cases.firstFailure(), "");
}

TEST("seen from behind there is no highlight, and the diffuse light is that of the front") {
  const CookTorranceMaterial material =
      rough(kWhite, Fresnel::ofIndex(1.5f), 0.3f, Distribution::ggx);
  const CookTorranceMaterial plain =
      rough(kWhite, Fresnel::ofIndex(1.5f), 1e-3f, Distribution::beckmann);
  // The second has a highlight too small to be seen at these angles: only diffuse light.
  const Vec3d behind = answer(material, {0.6, 0, -0.8}, {0.6f, 0, 0.8f});
  CHECK_NEAR_VECTOR(behind, answer(plain, {0.6, 0, 0.8}, {0.6f, 0, 0.8f}), 1e-7);
  CHECK(behind.x() > 0.7 && behind.x() < 0.8);
}

TEST("a surface of mirrors sends straight up what the mirrors' slopes say") {
  for (Distribution distribution : kBoth) {
    for (double roughness : {0.001, 0.1, 0.3, 0.7, 1.5}) {
      const CookTorranceMaterial mirrors =
          rough(kBlack, Fresnel::ofColor(kWhite), float(roughness), distribution);
      CHECK_NEAR(hemisphere::highlightAlbedo(mirrors, {0, 0, 1}, roughness),
                 straightUp(roughness, distribution), 2e-3);
    }
  }
}

TEST("no Cook-Torrance material sends back more light than it gets, at any angle") {
  const Fresnel kinds[] = {Fresnel::ofColor(kWhite), Fresnel::ofColor({0.5f, 0.5f, 0.5f}),
                           Fresnel::ofColor(kBlack), Fresnel::ofIndex(1.01f),
                           Fresnel::ofIndex(1.5f),   Fresnel::ofIndex(3)};
  check::Cases cases;
  for (const Fresnel& fresnel : kinds) {
    for (double angle : {0.0, 0.7, 1.2, 1.5, 1.56}) {
      const Vec3d toEye = direction(angle, 0.5);
      for (float roughness : {0.01f, 0.2f, 0.6f, 1.5f}) {
        // Diffuse light does not depend on roughness; at 1e-4 nothing else is seen by this grid.
        const double diffuse =
            hemisphere::albedo(rough(kWhite, fresnel, 1e-4f, kBoth[1]), toEye, 60);
        const auto mirrored = [&](Distribution distribution) {
          const CookTorranceMaterial dark = rough(kBlack, fresnel, roughness, distribution);
          return hemisphere::highlightAlbedo(dark, toEye, roughness, 200);
        };
        const double all = diffuse + std::max(mirrored(kBoth[0]), mirrored(kBoth[1]));
        cases.expect(all > 0.1 && all <= 1.002, [&] {
          return "reflectance " + check::show(fresnel.at(1)) + ", roughness " +
                 check::show(roughness) + ", angle " + check::show(angle) + ": " + check::show(all);
        });
      }
    }
  }
  CHECK_EQUAL(cases.tried(), 120);
  CHECK_EQUAL(cases.firstFailure(), "");
}
