// WardMaterial: against the published formula, its tangent, and that its albedo is bounded.
#include "shading/ward_material.h"

#include "random.h"
#include "shading/cook_torrance_material.h"
#include "shading/hemisphere.h"
#include "vectors.h"

using hemisphere::answer;
using hemisphere::direction;

namespace {

const Vec3f kBlack(0, 0, 0), kWhite(1, 1, 1);

WardMaterial brushed(float roughnessX, float roughnessY, const Vec3d& tangent = {1, 0, 0},
                     const Vec3f& diffuse = kBlack, const Vec3f& specular = kWhite) {
  return WardMaterial(diffuse, specular, {roughnessX, roughnessY, tangent}, kBlack, kBlack, 1);
}

/// pi f (n.l) of the highlight by the angles of the paper: t of l, o of u, d of h with the normal,
/// and p of h with the tangent x, along the surface; n = z, x the tangent.
double expectedHighlight(const Vec3d& l, const Vec3d& u, long double ax, long double ay) {
  const long double t = std::acos((long double)(l.z())), o = std::acos((long double)(u.z()));
  const long double turn = std::atan2((long double)(l.y()), (long double)(l.x())) -
                           std::atan2((long double)(u.y()), (long double)(u.x()));
  const long double hx = (long double)(l.x()) + u.x(), hy = (long double)(l.y()) + u.y(),
                    hz = (long double)(l.z()) + u.z();
  const long double p = std::atan2(hy, hx), tangent = std::sqrt(hx * hx + hy * hy) / hz;
  const long double slope = std::pow(std::cos(p) / ax, 2.0L) + std::pow(std::sin(p) / ay, 2.0L);
  const long double falloff = std::exp(-tangent * tangent * slope) / (ax * ay);
  const long double alike =
      1 + std::cos(t) * std::cos(o) + std::sin(t) * std::sin(o) * std::cos(turn);
  return double(falloff * 2 * alike / std::pow(std::cos(t) + std::cos(o), 4.0L) * std::cos(t));
}

}  // namespace

TEST("a Ward material has the colours and the index that it was made with") {
  const WardMaterial material({0.5f, 0.25f, 1}, {0.125f, 0.5f, 1}, {0.25f, 0.5f, {0, 3, 4}},
                              {0.1f, 0.2f, 0.3f}, {0.4f, 0.5f, 0.6f}, 1.5f);
  CHECK_EQUAL(material.getDiffuseColor(), Vec3f(0.5f, 0.25f, 1));
  CHECK_EQUAL(material.getTransparentColor(), Vec3f(0.1f, 0.2f, 0.3f));
  CHECK_EQUAL(material.getReflectiveColor(), Vec3f(0.4f, 0.5f, 0.6f));
  CHECK_EQUAL(material.getIndexOfRefraction(), 1.5f);
}

TEST("the tangent is projected on the surface") {
  const WardMaterial material = brushed(0.1f, 0.3f, {2, 0, 2});
  CHECK_NEAR_VECTOR(material.tangentAt({0, 0, 1}), Vec3d(1, 0, 0), 1e-15);
  CHECK_NEAR_VECTOR(material.tangentAt({1, 0, 0}), Vec3d(0, 0, 1), 1e-15);
  CHECK_NEAR_VECTOR(material.tangentAt({0, 1, 0}), Vec3d(std::sqrt(0.5), 0, std::sqrt(0.5)), 1e-15);
}

TEST("where the tangent is parallel to the normal the axis farthest from it takes its place") {
  // Of (0, 0, 1) the x and y axes are as far: x comes first. Of (0.6, 0, 0.8) y is the farthest,
  // and of (0.48, 0.6, 0.64) x: (1, 0, 0) - 0.48 n has the squared length 1 - 0.48^2.
  CHECK_EQUAL(brushed(0.1f, 0.3f, {0, 0, -5}).tangentAt({0, 0, 1}), Vec3d(1, 0, 0));
  CHECK_EQUAL(brushed(0.1f, 0.3f, {1, 0, 0}).tangentAt({1, 0, 0}), Vec3d(0, 1, 0));
  CHECK_EQUAL(brushed(0.1f, 0.3f, {3, 0, 4}).tangentAt({-0.6, 0, -0.8}), Vec3d(0, 1, 0));
  const Vec3d slanted = brushed(0.1f, 0.3f, {12, 15, 16}).tangentAt({0.48, 0.6, 0.64});
  CHECK_NEAR_VECTOR(slanted, (Vec3d(0.7696, -0.288, -0.3072) / std::sqrt(0.7696)), 1e-15);
}

TEST("seen and lit straight from above the Ward highlight is 1 / (4 ax ay)") {
  // H = 2 n: (H.H) / (H.n)^4 = 4 / 16.
  const WardMaterial material = brushed(0.5f, 0.25f, {1, 2, 0}, {0.5f, 0.25f, 0}, {1, 0.5f, 0});
  CHECK_NEAR_VECTOR(answer(material, {0, 0, 1}, {0, 0, 1}), Vec3d(2.5, 1.25, 0), 1e-6);
}

TEST("seen from behind a Ward surface has its diffuse light alone") {
  const WardMaterial material = brushed(0.5f, 0.5f, {1, 0, 0}, {0.5f, 0.25f, 1});
  CHECK_NEAR_VECTOR(answer(material, {0.8, 0, -0.6}, {0, 0, 1}), Vec3d(0.5, 0.25, 1), 1e-7);
  CHECK(answer(material, {0.8, 0, 0.6}, {0, 0, 1}).x() > 0.6);
}

TEST("random Ward answers equal the published formula in long double") {
  Random random(531);
  check::Cases cases;
  while (cases.tried() < 40000) {
    const Vec3d u = random.unitVector();
    const Vec3f l(random.unitVector());
    if (u.z() < 0.01 || l.z() < 0.01f) continue;
    const float ax = float(random.logUniform(0.05, 2)), ay = float(random.logUniform(0.05, 2));
    const double expected = expectedHighlight(l, u, ax, ay);
    // The projection on the surface is +x whatever the tangent has along the normal.
    const WardMaterial material = brushed(ax, ay, {1, 0, random.uniform(-3, 3)});
    const double found = answer(material, u, l).x();
    cases.expect(std::fabs(found - expected) < 5e-4 * expected + 1e-9, [&] {
      return "ax " + check::show(ax) + ", ay " + check::show(ay) + ", l " + check::show(l) +
             ", u " + check::show(u) + ": " + check::show(found) + ", expected " +
             check::show(expected);
    });
  }
  CHECK_EQUAL(cases.firstFailure(), "");
}

TEST("the highlight is long across the smooth direction's own, and turns with the tangent") {
  // Straight from above; the light 0.4 to one side, so that h is at 0.2, tan 0.2 = 0.2027: the
  // falloff is exp(-(0.2027/0.1)^2) = 0.0164 along the smooth x and exp(-(0.2027/0.5)^2) = 0.848
  // along the rough y.
  const WardMaterial along = brushed(0.1f, 0.5f, {1, 0, 0}),
                     turned = brushed(0.1f, 0.5f, {0, 1, 0});
  const Vec3f toX(direction(0.4, 0)), toY(direction(0.4, math::kPi / 2));
  const double ratio = answer(along, {0, 0, 1}, toX).x() / answer(along, {0, 0, 1}, toY).x();
  const double steep = std::tan(0.2) * std::tan(0.2);
  CHECK_NEAR(ratio, std::exp(-steep * (100 - 4)), 1e-5);
  CHECK_NEAR(answer(turned, {0, 0, 1}, toY).x(), answer(along, {0, 0, 1}, toX).x(), 1e-5);
  CHECK_NEAR(answer(turned, {0, 0, 1}, toX).x(), answer(along, {0, 0, 1}, toY).x(), 1e-5);
}

TEST("with equal roughness both ways the tangent makes no difference") {
  Random random(532);
  check::Cases cases;
  while (cases.tried() < 5000) {
    const Vec3d n = random.unitVector(), u = random.unitVector();
    const Vec3f l(random.unitVector());
    if (dot(n, u) < 0.05 || dot(n, Vec3d(l)) < 0.05) continue;
    const float roughness = float(random.logUniform(0.1, 2));
    const double one = answer(brushed(roughness, roughness, random.unitVector()), u, l, n).x();
    const double other = answer(brushed(roughness, roughness, random.unitVector()), u, l, n).x();
    cases.expect(std::fabs(one - other) <= 1e-6 * one, [&] {
      return "roughness " + check::show(roughness) + ", l " + check::show(l) + ", u " +
             check::show(u) + ": " + check::show(one) + " and " + check::show(other);
    });
  }
  CHECK_EQUAL(cases.firstFailure(), "");
}

TEST("with equal roughness both ways it is the isotropic model, Beckmann's D / (4 (l.h)^2)") {
  // As (H.n)^2 / (H.H) is cos^2 d and H.H is 4 (l.h)^2. Cook-Torrance with F = 1 has G / (n.l n.u)
  // in place of 1 / (l.h)^2, and the same Beckmann's D.
  Random random(533);
  check::Cases cases;
  while (cases.tried() < 5000) {
    const Vec3d u = random.unitVector();
    const Vec3f l(random.unitVector());
    if (u.z() < 0.05 || l.z() < 0.05f) continue;
    const float roughness = float(random.logUniform(0.1, 2));
    const CookTorranceMaterial mirrors(kBlack, Fresnel::ofColor(kWhite), roughness,
                                       CookTorranceMaterial::Distribution::beckmann, kBlack, kBlack,
                                       1);
    const Vec3d h = normalize(u + Vec3d(l));
    const double slant = dot(u, h), nh = h.z();
    const double g = std::min({1.0, 2 * nh * u.z() / slant, 2 * nh * l.z() / slant});
    const double expected = answer(mirrors, u, l).x() * (l.z() * u.z()) / (g * slant * slant);
    const double found = answer(brushed(roughness, roughness), u, l).x();
    cases.expect(std::fabs(found - expected) <= 1e-4 * expected + 1e-12, [&] {
      return "roughness " + check::show(roughness) + ", l " + check::show(l) + ", u " +
             check::show(u) + ": " + check::show(found) + ", expected " + check::show(expected);
    });
  }
  CHECK_EQUAL(cases.firstFailure(), "");
}

TEST("an isotropic white Ward surface sends straight up 1 - a (1 - exp(-1/a)), a = roughness^2") {
  // With x = tan^2 d the integral of D (n.l) / (l.h) over h is that of exp(-x/a)/a (1 - x) for x in
  // 0..1, beyond which l is below the surface.
  for (double roughness : {0.001, 0.1, 0.4, 1.0, 2.0}) {
    const WardMaterial material = brushed(float(roughness), float(roughness));
    const double a = roughness * roughness, expected = 1 - a * (1 - std::exp(-1 / a));
    CHECK_NEAR(hemisphere::highlightAlbedo(material, {0, 0, 1}, roughness), expected, 2e-3);
  }
}

TEST("no white Ward surface sends back more light than it gets, at any angle") {
  check::Cases cases;
  double most = 0;
  for (double angle : {0.0, 0.7, 1.2, 1.4, 1.5, 1.55}) {
    for (double roughX : {0.05, 0.2, 0.6, 1.5}) {
      for (double stretch : {1.0, 0.25, 3.0}) {
        const WardMaterial material = brushed(float(roughX), float(roughX * stretch), {1, 0.5, 0});
        const double found = hemisphere::highlightAlbedo(material, direction(angle, 1),
                                                         roughX * std::max(1.0, stretch));
        most = std::max(most, found);
        cases.expect(found > 0.01 && found <= 1.003, [&] {
          return "angle " + check::show(angle) + ", ax " + check::show(roughX) + ", ay " +
                 check::show(roughX * stretch) + ": " + check::show(found);
        });
      }
    }
  }
  CHECK_EQUAL(cases.firstFailure(), "");
  CHECK(most > 0.95);
}
