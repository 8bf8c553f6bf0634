// BlinnPhongMaterial: each term of its answer to one light.
#include "random.h"
#include "shading/hemisphere.h"
#include "shading/phong_material.h"
#include "vectors.h"

using hemisphere::answer;
using hemisphere::direction;

namespace {

const Vec3f kDiffuse(0.5f, 0.25f, 1), kSpecular(0.125f, 0.75f, 0.5f);

BlinnPhongMaterial blinn(const Vec3f& diffuse, const Vec3f& specular, float exponent) {
  return BlinnPhongMaterial(diffuse, specular, exponent, Vec3f(), Vec3f(), 1);
}

}  // namespace

TEST("a Blinn-Phong material keeps what it was made of") {
  const BlinnPhongMaterial material(kDiffuse, kSpecular, 7, {0.1f, 0.2f, 0.3f}, {0.4f, 0.5f, 0.6f},
                                    1.5f);
  CHECK_EQUAL(material.getDiffuseColor(), kDiffuse);
  CHECK_EQUAL(material.getSpecularColor(), kSpecular);
  CHECK_EQUAL(material.getExponent(), 7.0f);
  CHECK_EQUAL(material.getTransparentColor(), Vec3f(0.1f, 0.2f, 0.3f));
  CHECK_EQUAL(material.getReflectiveColor(), Vec3f(0.4f, 0.5f, 0.6f));
  CHECK_EQUAL(material.getIndexOfRefraction(), 1.5f);
}

TEST("the highlight is the power of the cosine to the halfway vector") {
  // From straight above with l at angle x, h is at x/2: cos x = 0.28 gives cos(x/2) = 0.8, as
  // (1 + 0.28) / 2 = 0.64.
  for (float exponent : {0.0f, 0.5f, 1.0f, 2.0f, 10.0f, 200.0f}) {
    const Vec3d found = answer(blinn(kDiffuse, kSpecular, exponent), {0, 0, 1}, {0.96f, 0, 0.28f});
    const double power = std::pow(0.8, double(exponent));
    CHECK_NEAR_VECTOR(found, Vec3d(kDiffuse) * 0.28 + Vec3d(kSpecular) * power, 1e-6);
  }
}

TEST("random Blinn-Phong answers equal the formula in long double") {
  Random random(511);
  check::Cases cases;
  for (int i = 0; i < 20000; ++i) {
    const Vec3d n = random.unitVector(), u = random.unitVector(), sum = random.unitVector();
    const Vec3f l(sum), light(2, 0.5f, 1);
    const float exponent = float(random.uniform(0, 100));
    const long double x = (long double)(l.x()) + u.x(), y = (long double)(l.y()) + u.y(),
                      z = (long double)(l.z()) + u.z();
    const long double rise = (n.x() * x + n.y() * y + n.z() * z) / std::sqrt(x * x + y * y + z * z);
    const double lit = dot(n, Vec3d(l));
    if (std::fabs(lit) < 1e-6 || std::fabs(double(rise)) < 1e-3) continue;  // signs could differ
    const double power = rise > 0 ? double(std::pow(rise, (long double)(exponent))) : 0;
    const Vec3d local = Vec3d(kDiffuse) * lit + Vec3d(kSpecular) * power;
    const Vec3d expected = lit > 0 ? local * Vec3d(light) : Vec3d();
    const BlinnPhongMaterial material = blinn(kDiffuse, kSpecular, exponent);
    const Vec3f found = material.Shade(Ray(u, -u), Hit(1, &material, n), l, light);
    cases.expect(maxAbs(Vec3d(found) - expected) < 1e-6, [&] {
      return "n.l " + check::show(lit) + ", exponent " + check::show(exponent) + ": " +
             check::show(found) + ", expected " + check::show(expected);
    });
  }
  CHECK(cases.tried() > 15000);
  CHECK_EQUAL(cases.firstFailure(), "");
}

TEST("the highlight is the same when light and eye change places") {
  const Vec3f a(direction(0.3, 0.2)), b(direction(1.2, 2));
  const BlinnPhongMaterial material = blinn({0, 0, 0}, {1, 1, 1}, 20);
  CHECK_NEAR_VECTOR(answer(material, a, b), answer(material, b, a), 1e-6);
}

TEST("four times Phong's exponent makes a highlight as large") {
  // With both seen from above and l at angle x, cos(x/2)^(4e) = (cos(x/2)^4)^e, and
  // cos(x/2)^4 = (1 + cos x)^2 / 4 = cos x + (1 - cos x)^2 / 4. While (1 - cos x)^2 / 4 is below
  // 1e-5, for x up to 0.11, the two differ by less than e 1e-5.
  for (double x : {0.0, 0.03, 0.07, 0.11}) {
    const PhongMaterial phong({0, 0, 0}, {1, 1, 1}, 50, Vec3f(), Vec3f(), 1);
    const Vec3f l(direction(x, 1));
    const double expected = answer(phong, {0, 0, 1}, l).x();
    CHECK_NEAR(answer(blinn({0, 0, 0}, {1, 1, 1}, 200), {0, 0, 1}, l).x(), expected, 5e-4);
  }
}

TEST("there is no Blinn-Phong highlight from or through the back, even for exponent 0") {
  const BlinnPhongMaterial material = blinn({0, 0, 0}, {1, 1, 1}, 0);
  CHECK_EQUAL(answer(material, {0, 0, 1}, {0.6f, 0, -0.8f}), Vec3d());
  CHECK_EQUAL(answer(material, {0, 0, 1}, {1, 0, 0}), Vec3d());
  // u = (0.6, 0, -0.8) and l = (0, 0.8, 0.6): n.h has the sign of 0.6 - 0.8.
  CHECK_EQUAL(answer(material, {0.6, 0, -0.8}, {0, 0.8f, 0.6f}), Vec3d());
  // l = -u exactly: there is no halfway vector.
  CHECK_EQUAL(answer(material, {0, 0, -1}, {0, 0, 1}), Vec3d());
}
