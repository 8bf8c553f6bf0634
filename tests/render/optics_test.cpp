// mirrorDirection and transmittedDirection, in float and in double.
#include "render/optics.h"

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
