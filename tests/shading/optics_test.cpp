// mirrorDirection and transmittedDirection, in float and in double.
#include "shading/optics.h"

#include "random.h"
#include "vectors.h"

TEST("a mirror keeps the part along the surface and turns the other round") {
  CHECK_EQUAL(mirrorDirection(Vec3d(0, 1, 0), Vec3d(0.6, -0.8, 0)), Vec3d(0.6, 0.8, 0));
  CHECK_EQUAL(mirrorDirection(Vec3f(0, 0, 1), Vec3f(1, 2, -3)), Vec3f(1, 2, 3));
  CHECK_EQUAL(mirrorDirection(Vec3d(0, 1, 0), Vec3d(0, -1, 0)), Vec3d(0, 1, 0));
}

TEST("either side of a mirror will do") {
  CHECK_EQUAL(mirrorDirection(Vec3d(0, -1, 0), Vec3d(0.6, -0.8, 0)), Vec3d(0.6, 0.8, 0));
}

TEST("a mirror at 45 degrees sends a ray off at a right angle") {
  const double h = std::sqrt(0.5);
  CHECK_NEAR_VECTOR(mirrorDirection(Vec3d(h, h, 0), Vec3d(-1, 0, 0)), Vec3d(0, 1, 0), 1e-15);
}

TEST("index 1 lets a ray go straight on") {
  Vec3d through;
  CHECK(transmittedDirection(Vec3d(0, 1, 0), Vec3d(0.6, -0.8, 0), 1, 1, through));
  CHECK_NEAR_VECTOR(through, Vec3d(0.6, -0.8, 0), 1e-15);
}

TEST("a ray straight down is not bent") {
  Vec3d through;
  CHECK(transmittedDirection(Vec3d(0, 1, 0), Vec3d(0, -1, 0), 1, 2.5f, through));
  CHECK_EQUAL(through, Vec3d(0, -1, 0));
}

TEST("the sines are in the inverse ratio of the indices") {
  // sin 0.8 into index 2: sin 0.4, cos sqrt(1 - 0.16). Back out again: 0.8.
  const double cosine = std::sqrt(0.84);
  Vec3d in, out;
  CHECK(transmittedDirection(Vec3d(0, 1, 0), Vec3d(0.8, -0.6, 0), 1, 2, in));
  CHECK_NEAR_VECTOR(in, Vec3d(0.4, -cosine, 0), 1e-15);
  CHECK(transmittedDirection(Vec3d(0, 1, 0), in, 2, 1, out));
  CHECK_NEAR_VECTOR(out, Vec3d(0.8, -0.6, 0), 1e-15);
}

TEST("beyond the critical angle nothing is transmitted and the result is left alone") {
  // From index 2 to 1 the critical sine is 0.5.
  Vec3d result(7, 8, 9);
  CHECK(!transmittedDirection(Vec3d(0, 1, 0), Vec3d(0.6, -0.8, 0), 2, 1, result));
  CHECK_EQUAL(result, Vec3d(7, 8, 9));
  const double below = 0.4999, above = 0.5001;
  CHECK(transmittedDirection(Vec3d(0, 1, 0), Vec3d(below, -std::sqrt(1 - below * below), 0), 2, 1,
                             result));
  CHECK(!transmittedDirection(Vec3d(0, 1, 0), Vec3d(above, -std::sqrt(1 - above * above), 0), 2, 1,
                              result));
}

TEST("float answers agree with double ones") {
  Vec3f in;
  CHECK(transmittedDirection(Vec3f(0, 1, 0), Vec3f(0.8f, -0.6f, 0), 1, 2, in));
  CHECK_NEAR_VECTOR(in, Vec3d(0.4, -std::sqrt(0.84), 0), 2e-7);
}

TEST("random refractions obey Snell's law, stay in the plane of incidence and are unit vectors") {
  Random random(71);
  check::Cases cases;
  int reflected = 0;
  for (int i = 0; i < 50000; ++i) {
    const Vec3d normal = random.unitVector();
    Vec3d incoming = random.unitVector();
    if (dot(incoming, normal) > 0) incoming = -incoming;
    const float from = float(random.uniform(1, 3)), to = float(random.uniform(1, 3));
    const Vec3d sineIn = cross(normal, incoming);
    const double sine = length(sineIn) * double(from) / double(to);
    Vec3d out;
    const bool found = transmittedDirection(normal, incoming, from, to, out);
    reflected += !found;
    bool ok = found || sine > 1 - 1e-12;
    if (found) {
      const Vec3d sineOut = cross(normal, out);
      ok = sine < 1 + 1e-12 && std::fabs(length(out) - 1) < 1e-15 && dot(out, normal) <= 1e-7 &&
           length(sineOut * double(to) - sineIn * double(from)) < 1e-14;
    }
    cases.expect(ok, [&] { return check::show(incoming) + " at " + check::show(normal); });
  }
  CHECK(reflected > 1000);
  CHECK_EQUAL(cases.firstFailure(), "");
}

TEST("random mirror directions keep their length and angle") {
  Random random(72);
  check::Cases cases;
  for (int i = 0; i < 20000; ++i) {
    const Vec3d normal = random.unitVector(), incoming = random.unitVector();
    const Vec3d out = mirrorDirection(normal, incoming);
    const bool ok = std::fabs(dot(out, normal) + dot(incoming, normal)) < 1e-15 &&
                    length(cross(normal, out) - cross(normal, incoming)) < 2e-15;
    cases.expect(ok, [&] { return check::show(incoming) + " at " + check::show(normal); });
  }
  CHECK_EQUAL(cases.firstFailure(), "");
}

namespace {

using Real = long double;

double fresnelReflectance(double cosine, float from, float to) {
  return dielectricReflectance(cosine, double(to) / double(from));
}

/// Fresnel's equations in their other form, by angles: sin(i - t) / sin(i + t) and
/// tan(i - t) / tan(i + t).
Real reflectanceByAngles(Real angle, Real from, Real to) {
  const Real refracted = std::asin(from / to * std::sin(angle));
  const Real across = std::sin(angle - refracted) / std::sin(angle + refracted);
  const Real along = std::tan(angle - refracted) / std::tan(angle + refracted);
  return (across * across + along * along) / 2;
}

/// What is transmitted, from the amplitudes of the transmitted wave.
Real transmittedPart(Real cosine, Real from, Real to) {
  const Real sine = from / to * std::sqrt(1 - cosine * cosine);
  const Real inside = std::sqrt(1 - sine * sine);
  const Real across = 2 * from * cosine / (from * cosine + to * inside);
  const Real along = 2 * from * cosine / (to * cosine + from * inside);
  return to * inside / (from * cosine) * (across * across + along * along) / 2;
}

}  // namespace

TEST("random reflectances equal Fresnel's formula by angles, and with what passes sum to 1") {
  Random random(73);
  check::Cases cases;
  int totals = 0;
  for (int i = 0; i < 20000; ++i) {
    const float from = float(random.uniform(1, 3)), to = float(random.uniform(1, 3));
    const double angle = random.uniform(0.01, 1.55);
    const double found = fresnelReflectance(std::cos(angle), from, to);
    const Real sine = Real(from) / Real(to) * std::sin(Real(angle));
    totals += sine > 1;
    if (std::fabs(sine - 1) < 1e-6L) continue;  // the angle of total reflection, to its rounding
    const Real expected = sine > 1 ? 1 : reflectanceByAngles(angle, from, to);
    const Real passed = sine > 1 ? 0 : transmittedPart(std::cos(Real(angle)), from, to);
    const bool ok = std::fabs(found - expected) < 1e-11L && std::fabs(found + passed - 1) < 1e-11L;
    cases.expect(ok, [&] {
      return check::show(angle) + " from " + check::show(from) + " to " + check::show(to);
    });
  }
  CHECK(totals > 1000);
  CHECK_EQUAL(cases.firstFailure(), "");
}

TEST("straight on, the reflectance is ((n1 - n2) / (n1 + n2)) squared") {
  CHECK_NEAR(fresnelReflectance(1, 1, 1.5f), 0.04, 1e-16);
  CHECK_NEAR(fresnelReflectance(1, 1.5f, 1), 0.04, 1e-16);
  CHECK_NEAR(fresnelReflectance(1, 1, 3), 0.25, 1e-16);
}

TEST("at Brewster's angle only light across the plane of incidence is reflected") {
  // tan = n: the refracted ray is at a right angle to the mirrored one, and the other half is
  // ((n^2 - 1) / (n^2 + 1))^2 / 2. For n = 2: cos = 1 / sqrt(5), (3 / 5)^2 / 2.
  CHECK_NEAR(fresnelReflectance(std::sqrt(0.2), 1, 2), 0.18, 1e-15);
  CHECK_NEAR(fresnelReflectance(std::sqrt(0.8), 2, 1), 0.18, 1e-15);
}

TEST("a ray reflects as much on its way back") {
  // sin 0.8 outside, 0.4 in index 2.
  const double outside = fresnelReflectance(0.6, 1, 2);
  CHECK_NEAR(fresnelReflectance(std::sqrt(0.84), 2, 1), outside, 1e-15);
}

TEST("equal indices reflect nothing, a grazing ray and total reflection everything") {
  for (double cosine : {0.0, 1e-300, 0.3, 1.0, 1.0000001}) {
    CHECK_EQUAL(fresnelReflectance(cosine, 1.3f, 1.3f), 0.0);
  }
  CHECK_EQUAL(fresnelReflectance(0, 1, 1.5f), 1.0);
  CHECK_EQUAL(fresnelReflectance(0.6, 2, 1), 1.0);  // sin 0.8 > 0.5
  CHECK_EQUAL(fresnelReflectance(0.01, 2, 1), 1.0);
  CHECK(fresnelReflectance(1.0000001, 1, 1.5f) <= 1);
}

TEST("Schlick's glass mirrors R0 straight on, all at grazing and total reflection") {
  // Into an index of 3: R0 = (2 / 4)^2. At 60 degrees 1 - c is 1/2.
  CHECK_NEAR(blendedReflectance(-1.0, 1, 3), 0.25, 1e-15);
  CHECK_NEAR(blendedReflectance(-0.5, 1, 3), 0.25 + 0.75 / 32, 1e-15);
  CHECK_NEAR(blendedReflectance(-1e-20, 1, 3), 1, 1e-15);
  // Out of it the index behind is 1, so R0 is 0, and c that of the refracted ray: sine 1/5 inside
  // is 3/5 outside, cosine 4/5.
  CHECK_NEAR(blendedReflectance(1.0, 3, 1), 0, 1e-15);
  CHECK_NEAR(blendedReflectance(std::sqrt(1 - 0.04), 3, 1), 0.2 * 0.2 * 0.2 * 0.2 * 0.2, 1e-15);
  CHECK_EQUAL(blendedReflectance(0.5, 3, 1), 1.0);
}
