// Fresnel: against Snell's law and the reflection of the two polarisations, in long double.
#include "random.h"
#include "shading/optics.h"
#include "vectors.h"

namespace {

/// The mean of the reflectances across and along the plane of incidence, from the angles.
double expectedReflectance(double cosine, double index) {
  const long double n = index, c = cosine, sine = std::sqrt(1 - c * c) / n;
  if (sine >= 1) return 1;
  const long double inside = std::sqrt(1 - sine * sine);
  const long double across = (c - n * inside) / (c + n * inside);
  const long double along = (n * c - inside) / (n * c + inside);
  return double((across * across + along * along) / 2);
}

}  // namespace

TEST("at normal incidence a dielectric mirrors ((n - 1) / (n + 1))^2") {
  for (double index : {0.25, 0.75, 1.0, 1.001, 1.33, 1.5, 2.4, 100.0}) {
    const double root = (index - 1) / (index + 1);
    CHECK_NEAR(dielectricReflectance(1.0, index), root * root, 1e-15);
  }
  CHECK_NEAR(dielectricReflectance(1.0, 1.5), 0.04, 1e-16);
  CHECK_NEAR_VECTOR(Fresnel::ofIndex(1.5f).at(1), Vec3d(0.04, 0.04, 0.04), 1e-16);
}

TEST("random angles and indices equal the formula of the two polarisations") {
  Random random(501);
  check::Cases cases;
  for (int i = 0; i < 20000; ++i) {
    const double cosine = random.uniform(0, 1), index = random.logUniform(0.3, 4);
    const double found = dielectricReflectance(cosine, index);
    const double expected = expectedReflectance(cosine, index);
    // Next to the critical angle the reflectance has no bounded slope.
    if (std::fabs(index * index - 1 + cosine * cosine) < 1e-4) continue;
    cases.expect(std::fabs(found - expected) < 1e-11, [&] {
      return "cosine " + check::show(cosine) + ", index " + check::show(index) + ": " +
             check::show(found) + ", expected " + check::show(expected);
    });
  }
  CHECK(cases.tried() > 19000);
  CHECK_EQUAL(cases.firstFailure(), "");
}

TEST("everything is mirrored at grazing incidence and beyond the critical angle, but not by air") {
  CHECK_EQUAL(dielectricReflectance(0.0, 1.5), 1.0);
  CHECK_EQUAL(dielectricReflectance(0.0, 1 / 1.5), 1.0);
  // From inside glass the critical angle has the sine 1 / 1.5, the cosine 0.745.
  CHECK_EQUAL(dielectricReflectance(0.74, 1 / 1.5), 1.0);
  CHECK(dielectricReflectance(0.75, 1 / 1.5) < 0.8);
  for (double cosine : {0.0, 1e-9, 0.5, 1.0}) CHECK_EQUAL(dielectricReflectance(cosine, 1), 0.0);
}

TEST("at Brewster's angle only the light polarised across is mirrored") {
  // tan t = n = 3/4: cos t = 4/5, sin t = 3/5; inside sine and cosine change places. Across:
  // (4/5 - 3/4 3/5) / (4/5 + 3/4 3/5) = 7/25, along 0, so the mean is 49/1250.
  CHECK_NEAR(dielectricReflectance(0.8, 0.75), 49 / 1250.0, 1e-15);
}

TEST("Schlick's form goes from the colour to white with the fifth power") {
  const Vec3d color(0, 0.5, 1);
  CHECK_EQUAL(schlickReflectance(1, color), color);
  CHECK_EQUAL(schlickReflectance(0, color), Vec3d(1, 1, 1));
  // (1 - 1/2)^5 = 1/32, and 1/2 + 1/2 / 32 = 33/64.
  CHECK_EQUAL(schlickReflectance(0.5, color), Vec3d(1 / 32.0, 33 / 64.0, 1));
  CHECK_EQUAL(schlickReflectance(1.25, color), color);
  CHECK_EQUAL(Fresnel::ofColor({0, 0.5f, 1}).at(0.5), Vec3d(1 / 32.0, 33 / 64.0, 1));
}
