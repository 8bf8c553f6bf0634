// PhongMaterial: what it keeps, and each term of its answer to one light.
#include "shading/phong_material.h"

#include "math/functions.h"
#include "random.h"
#include "vectors.h"

namespace {

const Vec3f kDiffuse(0.5f, 0.25f, 1), kSpecular(0.125f, 0.75f, 0.5f);

/// What comes back straight up from the plane y = 0 when light comes from `dirToLight`.
Vec3f shadeFromAbove(const Material& material, const Vec3f& dirToLight,
                     const Vec3f& lightColor = {1, 1, 1}, const Vec3d& normal = {0, 1, 0}) {
  const Ray ray({0, 5, 0}, {0, -1, 0});
  return material.Shade(ray, Hit(5, &material, normal), dirToLight, lightColor);
}

PhongMaterial phong(const Vec3f& diffuse, const Vec3f& specular, float exponent) {
  return PhongMaterial(diffuse, specular, exponent, Vec3f(), Vec3f(), 1);
}

}  // namespace

TEST("a material keeps what it was made of") {
  const PhongMaterial material(kDiffuse, kSpecular, 7, {0.1f, 0.2f, 0.3f}, {0.4f, 0.5f, 0.6f},
                               1.5f);
  CHECK_EQUAL(material.getDiffuseColor(), kDiffuse);
  CHECK_EQUAL(material.getSpecularColor(), kSpecular);
  CHECK_EQUAL(material.getExponent(), 7.0f);
  CHECK_EQUAL(material.getTransparentColor(), Vec3f(0.1f, 0.2f, 0.3f));
  CHECK_EQUAL(material.getReflectiveColor(), Vec3f(0.4f, 0.5f, 0.6f));
  CHECK_EQUAL(material.getIndexOfRefraction(), 1.5f);
}

TEST("diffuse light falls with the cosine") {
  const PhongMaterial material = phong(kDiffuse, {0, 0, 0}, 1);
  CHECK_NEAR_VECTOR(shadeFromAbove(material, {0, 1, 0}), kDiffuse, 1e-7);
  CHECK_NEAR_VECTOR(shadeFromAbove(material, {0.8f, 0.6f, 0}), kDiffuse * 0.6f, 1e-7);
}

TEST("the light's colour multiplies everything by component") {
  const PhongMaterial material = phong(kDiffuse, kSpecular, 3);
  const Vec3f light(2, 0.5f, 0.25f);
  CHECK_NEAR_VECTOR(shadeFromAbove(material, {0, 1, 0}, light), light * (kDiffuse + kSpecular),
                    1e-6);
}

TEST("light from behind the surface gives nothing at all") {
  const PhongMaterial material = phong(kDiffuse, kSpecular, 0);
  CHECK_EQUAL(shadeFromAbove(material, {0, -1, 0}), Vec3f());
  CHECK_EQUAL(shadeFromAbove(material, {1, 0, 0}), Vec3f());
  CHECK_EQUAL(shadeFromAbove(material, {0.6f, -0.8f, 0}), Vec3f());
}

TEST("the normal is taken as it stands, though the ray came from its other side") {
  const PhongMaterial material = phong(kDiffuse, {0, 0, 0}, 1);
  CHECK_EQUAL(shadeFromAbove(material, {0, 1, 0}, {1, 1, 1}, {0, -1, 0}), Vec3f());
  CHECK_NEAR_VECTOR(shadeFromAbove(material, {0, -1, 0}, {1, 1, 1}, {0, -1, 0}), kDiffuse, 1e-7);
}

TEST("the highlight is the power of the cosine to the mirror direction") {
  // The ray comes straight down, so r is straight up and r.l = l.y.
  for (float exponent : {0.5f, 1.0f, 2.0f, 10.0f, 200.0f}) {
    const PhongMaterial material = phong({0, 0, 0}, kSpecular, exponent);
    const double power = std::pow(double(0.6f), double(exponent));
    CHECK_NEAR_VECTOR(shadeFromAbove(material, {0.8f, 0.6f, 0}), Vec3d(kSpecular) * power, 1e-7);
  }
}

TEST("the highlight follows a slanted ray") {
  // v = (0.6, -0.8, 0) mirrors to (0.6, 0.8, 0); l = (0, 0.8, 0.6): r.l = 0.64, squared 0.4096.
  const PhongMaterial material = phong({0, 0, 0}, {1, 1, 1}, 2);
  const Ray ray({0, 0, 0}, {0.6, -0.8, 0});
  const Vec3f found = material.Shade(ray, Hit(1, &material, {0, 1, 0}), {0, 0.8f, 0.6f}, {1, 1, 1});
  CHECK_NEAR_VECTOR(found, Vec3d(0.4096, 0.4096, 0.4096), 1e-6);
}

TEST("exponent 0 makes a highlight of full strength wherever r.l is above 0") {
  const PhongMaterial material = phong({0, 0, 0}, kSpecular, 0);
  CHECK_EQUAL(shadeFromAbove(material, {0, 1, 0}), kSpecular);
  CHECK_EQUAL(shadeFromAbove(material, normalize(Vec3f(100, 1, 0))), kSpecular);
}

TEST("there is no highlight where r.l is 0 or less, even for exponent 0") {
  // v = (0.6, -0.8, 0): r = (0.6, 0.8, 0). l = (-0.8, 0.6, 0): r.l = 0 and n.l = 0.6.
  // l = (-0.96, 0.28, 0): r.l = -0.352 and n.l = 0.28.
  for (float exponent : {0.0f, 1.0f, 2.0f, 3.0f}) {
    const PhongMaterial material = phong({0, 0, 0}, {1, 1, 1}, exponent);
    const Hit hit(1, &material, {0, 1, 0});
    const Ray ray({0, 0, 0}, {0.6, -0.8, 0});
    CHECK_EQUAL(material.Shade(ray, hit, {-0.96f, 0.28f, 0}, {1, 1, 1}), Vec3f());
    const Ray level({0, 0, 0}, normalize(Vec3d(1, -1, 0)));  // r = (1, 1, 0) / sqrt(2)
    CHECK_EQUAL(material.Shade(level, hit, normalize(Vec3f(-1, 0.99f, 0)), {1, 1, 1}), Vec3f());
  }
}

TEST("random highlights equal the formula in long double") {
  Random random(61);
  check::Cases cases;
  for (int i = 0; i < 20000; ++i) {
    const Vec3d n = random.unitVector(), v = random.unitVector();
    const Vec3f l(random.unitVector());
    const float exponent = float(random.uniform(0, 100));
    const PhongMaterial material = phong(kDiffuse, kSpecular, exponent);
    const double nl = dot(n, Vec3d(l)), rl = dot(v - n * (2 * dot(v, n)), Vec3d(l));
    if (std::fabs(nl) < 1e-6 || std::fabs(rl) < 1e-3) continue;  // signs could differ
    const double power = rl > 0 ? double(std::pow((long double)(rl), (long double)(exponent))) : 0;
    const Vec3d expected = nl > 0 ? Vec3d(kDiffuse) * nl + Vec3d(kSpecular) * power : Vec3d();
    const Vec3f found = material.Shade(Ray({0, 0, 0}, v), Hit(1, &material, n), l, {1, 1, 1});
    cases.expect(maxAbs(Vec3d(found) - expected) < 2e-5, [&] {
      return "n.l " + check::show(nl) + ", r.l " + check::show(rl) + ", exponent " +
             check::show(exponent) + ": " + check::show(found);
    });
  }
  CHECK(cases.tried() > 15000);
  CHECK_EQUAL(cases.firstFailure(), "");
}

TEST("light that only grazes the surface gives no highlight") {
  // v = (0.6, -0.8, 0), l = (1, 0, 0): n.l = 0 although r.l = 0.6.
  const PhongMaterial material = phong(kDiffuse, kSpecular, 1);
  const Ray ray({0, 0, 0}, {0.6, -0.8, 0});
  CHECK_EQUAL(material.Shade(ray, Hit(1, &material, {0, 1, 0}), {1, 0, 0}, {1, 1, 1}), Vec3f());
}

TEST("a dimmed highlight is multiplied by the cosine of the light as diffuse light is") {
  // Light at 53.13 degrees: n.l = 0.6. Seen straight from above r.l = 0.6 too, and h lies halfway:
  // (n.h)^2 = (1 + 0.6) / 2 = 0.8.
  PhongMaterial mirrored = phong(kDiffuse, kSpecular, 2);
  mirrored.setHighlight(PhongMaterial::Highlight::dimmed);
  CHECK_NEAR_VECTOR(shadeFromAbove(mirrored, {0.8f, 0.6f, 0}),
                    kDiffuse * 0.6f + kSpecular * (0.36f * 0.6f), 1e-6);
  BlinnPhongMaterial halfway(kDiffuse, kSpecular, 2, Vec3f(), Vec3f(), 1);
  CHECK_NEAR_VECTOR(shadeFromAbove(halfway, {0.8f, 0.6f, 0}), kDiffuse * 0.6f + kSpecular * 0.8f,
                    1e-6);
  halfway.setHighlight(PhongMaterial::Highlight::dimmed);
  CHECK_NEAR_VECTOR(shadeFromAbove(halfway, {0.8f, 0.6f, 0}),
                    kDiffuse * 0.6f + kSpecular * (0.8f * 0.6f), 1e-6);
}

TEST("a highlight that is seen everywhere is seen of a light behind, and for exponent 0 it is 1") {
  using Highlight = PhongMaterial::Highlight;
  const Vec3f half(0.5f, 0.5f, 0.5f), specular(0.25f, 0.25f, 0.25f), white(1, 1, 1);
  // The ray comes along -z at 45 degrees to the surface, whose normal is n: it is mirrored to +x.
  const Vec3d n(std::sqrt(0.5), 0, std::sqrt(0.5));
  const Ray ray({0, 0, 0}, {0, 0, -1});
  const auto shaded = [&](float exponent, const Vec3f& l) {
    PhongMaterial material(half, specular, exponent, Vec3f(), Vec3f(), 1);
    material.setHighlight(Highlight::everywhere);
    return double(material.Shade(ray, Hit(1, &material, n), l, white).x());
  };
  // n.l = -0.2 / sqrt 2 and r.l = 0.6: no diffuse light, .25 times .6^2.
  CHECK_NEAR(shaded(2, {0.6f, 0, -0.8f}), 0.25 * 0.36, 1e-7);
  // n.l = 1.4 / sqrt 2, in front: both terms.
  CHECK_NEAR(shaded(2, {0.6f, 0, 0.8f}), 0.5 * 1.4 * std::sqrt(0.5) + 0.25 * 0.36, 1e-7);
  // r.l = -1: c is 0 there, and 0^0 is 1.
  CHECK_NEAR(shaded(0, {-1, 0, 0}), 0.25, 1e-7);
  CHECK_NEAR(shaded(1, {-1, 0, 0}), 0, 0);
}
