// What every material of its own local model promises: reciprocity, black below the horizon, and
// finite colours however low the light or the eye is.
#include <memory>
#include <vector>

#include "random.h"
#include "shading/cook_torrance_material.h"
#include "shading/hemisphere.h"
#include "shading/oren_nayar_material.h"
#include "shading/phong_material.h"
#include "shading/ward_material.h"
#include "vectors.h"

using Distribution = CookTorranceMaterial::Distribution;
using hemisphere::answer;

namespace {

const Vec3f kBlack(0, 0, 0), kDiffuse(0.5f, 0.25f, 1), kSpecular(0.25f, 0.75f, 1);

using Materials = std::vector<std::unique_ptr<Material>>;

/// The models that are BRDFs, of one roughness.
Materials physicalMaterials(float roughness) {
  Materials all;
  for (Distribution distribution : {Distribution::ggx, Distribution::beckmann}) {
    for (const Fresnel& fresnel : {Fresnel::ofIndex(1.5f), Fresnel::ofColor(kSpecular)}) {
      all.push_back(std::make_unique<CookTorranceMaterial>(kDiffuse, fresnel, roughness,
                                                           distribution, kBlack, kBlack, 1.0f));
    }
  }
  const WardMaterial::Grain even{roughness, roughness, {1, 2, 3}};
  const WardMaterial::Grain uneven{roughness, roughness / 4, {1, 2, 3}};
  all.push_back(std::make_unique<WardMaterial>(kDiffuse, kSpecular, even, kBlack, kBlack, 1.0f));
  all.push_back(std::make_unique<WardMaterial>(kDiffuse, kSpecular, uneven, kBlack, kBlack, 1.0f));
  all.push_back(std::make_unique<OrenNayarMaterial>(kDiffuse, roughness, kBlack, kBlack, 1.0f));
  return all;
}

Materials allMaterials(float roughness) {
  Materials all = physicalMaterials(roughness);
  all.push_back(std::make_unique<BlinnPhongMaterial>(kDiffuse, kSpecular, 1 / roughness, kBlack,
                                                     kBlack, 1.0f));
  return all;
}

bool isFinite(const Vec3d& v) {
  return std::isfinite(v.x()) && std::isfinite(v.y()) && std::isfinite(v.z());
}

/// Unit vectors up to the given height above the surface z = 0, to all sides.
std::vector<Vec3f> lowDirections() {
  std::vector<Vec3f> all;
  for (float height : {0.0f, 1e-45f, 1e-38f, 1e-20f, 1e-9f, 1e-4f, 0.1f, 0.6f, 1.0f}) {
    const float wide = std::sqrt(1 - height * height);
    all.push_back({wide, 0, height});
    all.push_back({-wide, 0, height});
    all.push_back({0.6f * wide, -0.8f * wide, height});
  }
  return all;
}

}  // namespace

TEST("light and eye can change places: f(l, v) = f(v, l)") {
  Random random(551);
  check::Cases cases;
  while (cases.tried() < 20000) {
    const Vec3d n = random.unitVector();
    const Vec3f a(random.unitVector()), b(random.unitVector());
    const double low = dot(n, Vec3d(a)), high = dot(n, Vec3d(b));
    if (low < 0.01 || high < 0.01) continue;
    const Materials materials = physicalMaterials(float(random.logUniform(0.05, 2)));
    for (std::size_t i = 0; i < materials.size(); ++i) {
      // The answer is pi f times the cosine of the light.
      const Vec3d there = answer(*materials[i], b, a, n) / low;
      const Vec3d back = answer(*materials[i], a, b, n) / high;
      cases.expect(maxAbs(there - back) <= 1e-5 * maxAbs(there), [&] {
        return "material " + check::show(i) + ", l " + check::show(a) + ", v " + check::show(b) +
               ", n " + check::show(n) + ": " + check::show(there) + " and " + check::show(back);
      });
    }
  }
  CHECK_EQUAL(cases.firstFailure(), "");
}

TEST("light from below the horizon or along it gives black") {
  Random random(552);
  check::Cases cases;
  for (const auto& material : allMaterials(0.5f)) {
    for (int i = 0; i < 500; ++i) {
      const Vec3d n = random.unitVector(), u = random.unitVector();
      Vec3f l(random.unitVector());
      if (dot(n, Vec3d(l)) > 0) l = -l;
      const Vec3d found = answer(*material, u, l, n);
      cases.expect(found == Vec3d(), [&] { return check::show(found); });
    }
    CHECK_EQUAL(answer(*material, {0.6, 0, 0.8}, {1, 0, 0}), Vec3d());
  }
  CHECK(cases.tried() > 3000);
  CHECK_EQUAL(cases.firstFailure(), "");
}

TEST("colours are finite and not negative however low light and eye are, of any roughness") {
  check::Cases cases;
  for (float roughness : {1e-38f, 1e-10f, 1e-4f, 0.1f, 1.0f, 1e4f, 3e38f}) {
    for (const auto& material : allMaterials(roughness)) {
      for (const Vec3f& l : lowDirections()) {
        for (const Vec3f& u : lowDirections()) {
          for (float side : {1.0f, -1.0f}) {
            const Vec3d toEye(u.x(), u.y(), side * u.z());
            const Vec3d found = answer(*material, toEye, l);
            const bool isGood = isFinite(found) && std::min({found.x(), found.y(), found.z()}) >= 0;
            cases.expect(isGood, [&] {
              return "roughness " + check::show(roughness) + ", l " + check::show(l) + ", u " +
                     check::show(toEye) + ": " + check::show(found);
            });
          }
        }
      }
    }
  }
  CHECK(cases.tried() > 50000);
  CHECK_EQUAL(cases.firstFailure(), "");
}

TEST("roughness below 0.0001 counts as 0.0001, so that the highlight does not vanish") {
  // Of 1e-10 nothing would be seen where h is 1e-4 aside from the normal, as here.
  const Vec3d toEye(0, 0, 1);
  const Vec3f l(hemisphere::direction(2e-4, 0.5));
  const Materials least = allMaterials(1e-4f), less = allMaterials(1e-10f);
  for (std::size_t i = 0; i < 5; ++i) {
    const Vec3d expected = answer(*least[i], toEye, l);
    CHECK(expected.y() > 1e3);
    CHECK_NEAR_VECTOR(answer(*less[i], toEye, l), expected, 1e-2 * expected.y());
  }
}

TEST("the light's colour multiplies every local model by component") {
  const Vec3f l(0.6f, 0, 0.8f), light(2, 0.5f, 0);
  for (const auto& material : allMaterials(0.4f)) {
    const Ray ray({0, 0, 1}, {0, 0, -1});
    const Vec3f found = material->Shade(ray, Hit(1, material.get(), {0, 0, 1}), l, light);
    const Vec3d expected = answer(*material, {0, 0, 1}, l) * Vec3d(light);
    CHECK_NEAR_VECTOR(found, expected, 1e-6);
    CHECK(expected.x() > 0.1);
  }
}
