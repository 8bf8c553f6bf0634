// OrenNayarMaterial: against the published formula, Lambert's law, and its albedo.
#include "shading/oren_nayar_material.h"

#include "random.h"
#include "shading/hemisphere.h"
#include "shading/phong_material.h"
#include "vectors.h"

using hemisphere::answer;
using hemisphere::direction;

namespace {

const Vec3f kBlack(0, 0, 0), kWhite(1, 1, 1);

OrenNayarMaterial clay(float roughness, const Vec3f& diffuse = kWhite) {
  return OrenNayarMaterial(diffuse, roughness, kBlack, kBlack, 1);
}

/// A and B of the paper.
long double evenPart(long double s) { return 1 - 0.5L * s * s / (s * s + 0.33L); }
long double unevenPart(long double s) { return 0.45L * s * s / (s * s + 0.09L); }

/// What a white surface would send back at grazing view: with a = 90 degrees sin a tan b is tan t,
/// t the light's angle, and (1/pi) times the integral of cos p over the half circle (2) times that
/// of tan t cos t sin t over 0..90 degrees (pi/4) is 1/2.
double grazingAlbedo(double s) { return double(evenPart(s) + unevenPart(s) / 2); }

/// pi f (n.l) as published, by angles, n = z.
double published(const Vec3d& l, const Vec3d& u, long double s) {
  const long double t = std::acos((long double)(l.z())), o = std::acos((long double)(u.z()));
  const long double turn = std::atan2((long double)(l.y()), (long double)(l.x())) -
                           std::atan2((long double)(u.y()), (long double)(u.x()));
  const long double uneven =
      std::max(0.0L, std::cos(turn)) * std::sin(std::max(t, o)) * std::tan(std::min(t, o));
  return double(std::cos(t) * (evenPart(s) + unevenPart(s) * uneven));
}

}  // namespace

TEST("an Oren-Nayar material has the colours and the index that it was made with") {
  const OrenNayarMaterial material({0.5f, 0.25f, 1}, 0.75f, {0.1f, 0.2f, 0.3f}, {0.4f, 0.5f, 0.6f},
                                   1.5f);
  CHECK_EQUAL(material.getDiffuseColor(), Vec3f(0.5f, 0.25f, 1));
  CHECK_EQUAL(material.getTransparentColor(), Vec3f(0.1f, 0.2f, 0.3f));
  CHECK_EQUAL(material.getReflectiveColor(), Vec3f(0.4f, 0.5f, 0.6f));
  CHECK_EQUAL(material.getIndexOfRefraction(), 1.5f);
}

TEST("roughness 0 is Lambert's law, to the last bit") {
  Random random(541);
  const Vec3f diffuse(0.7f, 0.3f, 0.1f);
  const PhongMaterial lambert(diffuse, kBlack, 1, kBlack, kBlack, 1);
  check::Cases cases;
  for (int i = 0; i < 5000; ++i) {
    const Vec3d n = random.unitVector(), u = random.unitVector();
    const Vec3f l(random.unitVector());
    const Vec3d found = answer(clay(0, diffuse), u, l, n);
    cases.expect(found == answer(lambert, u, l, n), [&] { return check::show(found); });
  }
  CHECK_EQUAL(cases.firstFailure(), "");
}

TEST("random Oren-Nayar answers equal the published formula, divided where it exceeds 1") {
  Random random(542);
  check::Cases cases;
  int divided = 0;
  while (cases.tried() < 40000) {
    const Vec3d u = random.unitVector();
    const Vec3f l(random.unitVector());
    if (u.z() < 0.001 || l.z() < 0.001f) continue;
    const float s = float(random.logUniform(0.02, 3));
    divided += grazingAlbedo(s) > 1;
    const double expected = published(l, u, s) / std::max(1.0, grazingAlbedo(s));
    const double found = answer(clay(s), u, l).x();
    cases.expect(std::fabs(found - expected) < 1e-5, [&] {
      return "roughness " + check::show(s) + ", l " + check::show(l) + ", u " + check::show(u) +
             ": " + check::show(found) + ", expected " + check::show(expected);
    });
  }
  CHECK_EQUAL(cases.firstFailure(), "");
  CHECK(divided > 5000 && divided < 35000);
}

TEST("from roughness 0.327 on the formula is the published one, and never 1.6 % off") {
  // A + B / 2 - 1 = 0.225 x / (x + 0.09) - 0.5 x / (x + 0.33) with x = s^2: 0 at x = 0.10636, and
  // greatest where 0.165 / (x + 0.33)^2 = 0.02025 / (x + 0.09)^2, at x = 0.03941: 0.01518.
  CHECK(grazingAlbedo(0.326) > 1 && grazingAlbedo(0.327) < 1);
  CHECK_NEAR(grazingAlbedo(std::sqrt(0.03941)), 1.01518, 1e-5);
  CHECK_NEAR(answer(clay(0.5f), direction(0.9, 0), Vec3f(direction(0.6, 0.3))).x(),
             published(direction(0.6, 0.3), direction(0.9, 0), 0.5L), 1e-6);
}

TEST("with the light behind the eye a rough ball is nearly as bright at its edge") {
  // 60 degrees, s = 1: A = 1 - 0.5/1.33 = 0.62406, B = 0.45/1.09 = 0.41284, sin a tan b = 3/2, so
  // cos 60 (A + 3/2 B) = 0.62166: next to the 0.62406 of the middle. Lambert has 0.5 for 1.
  const Vec3d aside = direction(math::kPi / 3, 0.4);
  CHECK_NEAR(answer(clay(1), aside, Vec3f(aside)).x(), 0.62166, 1e-5);
  CHECK_NEAR(answer(clay(1), {0, 0, 1}, {0, 0, 1}).x(), 0.62406, 1e-5);
}

TEST("a white Oren-Nayar surface sends back A + B / 2 at grazing view, and never above 1") {
  check::Cases cases;
  for (double s : {0.0, 0.05, 0.17, 0.3, 0.5, 1.0, 10.0}) {
    const double most = grazingAlbedo(s) / std::max(1.0, grazingAlbedo(s));
    CHECK_NEAR(hemisphere::albedo(clay(float(s)), direction(1.5707, 1)), most, 1e-3);
    for (double angle = 0; angle < 1.57; angle += 0.2) {
      const double found = hemisphere::albedo(clay(float(s)), direction(angle, 1), 100);
      cases.expect(found > 0.4 && found <= 1.0001 && found <= most + 1e-4, [&] {
        return "roughness " + check::show(s) + ", angle " + check::show(angle) + ": " +
               check::show(found);
      });
    }
  }
  CHECK_EQUAL(cases.firstFailure(), "");
}

TEST("seen from behind a rough surface looks as from the mirrored place in front") {
  for (double angle : {0.3, 1.2}) {
    const Vec3f l(direction(0.7, 0.3));
    const Vec3d front = direction(angle, 0.7), behind(front.x(), front.y(), -front.z());
    CHECK_NEAR_VECTOR(answer(clay(0.6f), behind, l), answer(clay(0.6f), front, l), 1e-7);
  }
}
