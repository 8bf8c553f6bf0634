// The kinds of material as a scene file gives them: fields, defaults, places and mistakes.
#include <algorithm>

#include "geometry/sphere.h"
#include "random.h"
#include "scene/scene_files.h"
#include "shading/cook_torrance_material.h"
#include "shading/hemisphere.h"
#include "shading/oren_nayar_material.h"
#include "shading/phong_material.h"
#include "shading/ward_material.h"

using scenes::around;
using scenes::kStart;
using scenes::parse;

namespace {

const std::string kSphere = "Sphere { center 0 0 0 radius 1 }\n";

/// The fields that every kind has, with values of their own.
const std::string kBase =
    " indexOfRefraction 1.25 reflectiveColor .1 .2 .3 transparentColor .4 .5 .6"
    " diffuseColor .7 .8 .9 ";
const Vec3f kBaseDiffuse(.7f, .8f, .9f);

std::string listOf(const std::string& material) {
  return kStart.substr(0, kStart.find("Materials")) + "Materials { numMaterials 1\n" + material +
         " }\n";
}

/// The scene with one listed material, which must be a T.
template <class T>
struct Listed {
  explicit Listed(const std::string& block)
      : scene(parse(listOf(block))), material(dynamic_cast<const T&>(*scene->getMaterial(0))) {}
  std::unique_ptr<SceneParser> scene;
  const T& material;
};

bool hasBase(const Material& material) {
  return material.getDiffuseColor() == kBaseDiffuse &&
         material.getTransparentColor() == Vec3f(.4f, .5f, .6f) &&
         material.getReflectiveColor() == Vec3f(.1f, .2f, .3f) &&
         material.getIndexOfRefraction() == 1.25f;
}

bool hasDefaultBase(const Material& material) {
  return material.getDiffuseColor() == Vec3f(1, 1, 1) &&
         material.getTransparentColor() == Vec3f() && material.getReflectiveColor() == Vec3f() &&
         material.getIndexOfRefraction() == 1;
}

/// Whether both answer light alike, wherever it, the eye and the normal are; within a rounding of a
/// tangent's length.
bool shadesAs(const Material& material, const Material& expected) {
  Random random(77);
  double farthest = 0;
  for (int i = 0; i < 200; ++i) {
    const Vec3d normal = random.unitVector(), toEye = random.unitVector();
    const Vec3f toLight(random.unitVector());
    const Vec3d found = hemisphere::answer(material, toEye, toLight, normal);
    const Vec3d wanted = hemisphere::answer(expected, toEye, toLight, normal);
    farthest = std::max(farthest, maxAbs(found - wanted) / (1 + maxAbs(wanted)));
  }
  return farthest < 1e-6;
}

}  // namespace

TEST("a BlinnPhongMaterial is read, and has PhongMaterial's defaults") {
  const Listed<BlinnPhongMaterial> full("BlinnPhongMaterial { exponent 7 specularColor 1 .5 0" +
                                        kBase + "}");
  CHECK(hasBase(full.material));
  CHECK(full.material.getSpecularColor() == Vec3f(1, .5f, 0));
  CHECK_EQUAL(full.material.getExponent(), 7.0f);
  const Listed<BlinnPhongMaterial> plain("BlinnPhongMaterial { }");
  CHECK(hasDefaultBase(plain.material));
  CHECK(plain.material.getSpecularColor() == Vec3f());
  CHECK_EQUAL(plain.material.getExponent(), 1.0f);
}

TEST("a CookTorranceMaterial is read, with index or specularColor") {
  using Distribution = CookTorranceMaterial::Distribution;
  const auto make = [](const Vec3f& diffuse, const Fresnel& fresnel, float roughness,
                       Distribution distribution) {
    return CookTorranceMaterial(diffuse, fresnel, roughness, distribution, {}, {}, 1);
  };
  const Listed<CookTorranceMaterial> full(
      "CookTorranceMaterial { distribution Beckmann roughness 0.5 index 2" + kBase + "}");
  CHECK(hasBase(full.material));
  CHECK(shadesAs(full.material,
                 make(kBaseDiffuse, Fresnel::ofIndex(2), 0.5f, Distribution::beckmann)));
  const Listed<CookTorranceMaterial> metal(
      "CookTorranceMaterial { specularColor 1 .5 .25 distribution GGX }");
  CHECK(shadesAs(metal.material,
                 make({1, 1, 1}, Fresnel::ofColor({1, .5f, .25f}), 0.2f, Distribution::ggx)));
  const Listed<CookTorranceMaterial> plain("CookTorranceMaterial { }");
  CHECK(hasDefaultBase(plain.material));
  CHECK(shadesAs(plain.material, make({1, 1, 1}, Fresnel::ofIndex(1.5f), 0.2f, Distribution::ggx)));
}

TEST("a WardMaterial is read, its tangent of any length") {
  const Listed<WardMaterial> full(
      "WardMaterial { tangent 0 3e-200 4e-200 roughnessY .5 roughness_x .25"
      " specularColor 1 .5 0" +
      kBase + "}");
  CHECK(hasBase(full.material));
  CHECK(shadesAs(full.material,
                 WardMaterial(kBaseDiffuse, {1, .5f, 0}, {.25f, .5f, {0, 3, 4}}, {}, {}, 1)));
  const Listed<WardMaterial> plain("WardMaterial { }");
  CHECK(hasDefaultBase(plain.material));
  const WardMaterial::Grain grain = {0.2f, 0.2f, {1, 0, 0}};
  CHECK(shadesAs(plain.material, WardMaterial({1, 1, 1}, {}, grain, {}, {}, 1)));
  const Listed<WardMaterial> shiny("WardMaterial { specularColor 1 1 1 }");
  CHECK(shadesAs(shiny.material, WardMaterial({1, 1, 1}, {1, 1, 1}, grain, {}, {}, 1)));
}

TEST("an OrenNayarMaterial is read") {
  const Listed<OrenNayarMaterial> full("OrenNayarMaterial { roughness 0" + kBase + "}");
  CHECK(hasBase(full.material));
  CHECK(shadesAs(full.material, OrenNayarMaterial(kBaseDiffuse, 0, {}, {}, 1)));
  const Listed<OrenNayarMaterial> plain("OrenNayarMaterial { }");
  CHECK(hasDefaultBase(plain.material));
  CHECK(shadesAs(plain.material, OrenNayarMaterial({1, 1, 1}, 0.5f, {}, {}, 1)));
}

TEST("every kind of material may stand inside a Group") {
  for (const std::string kind : {"PhongMaterial", "Material", "BlinnPhongMaterial",
                                 "CookTorranceMaterial", "WardMaterial", "OrenNayarMaterial"}) {
    const auto scene = parse(around(kind + " { diffuse_color 0 1 0 } " + kSphere));
    CHECK_EQUAL(scene->getNumMaterials(), 3);
    const auto& group = dynamic_cast<const Group&>(*scene->getGroup()->getObjects()[0]);
    const auto& ball = dynamic_cast<const Sphere&>(*group.getObjects()[0]);
    CHECK(ball.getMaterial() == scene->getMaterial(2));
    CHECK(ball.getMaterial()->getDiffuseColor() == Vec3f(0, 1, 0));
  }
}

TEST("values out of range are mistakes with their line") {
  CHECK_MISTAKE(listOf("BlinnPhongMaterial {\nexponent -1 }"), 5,
                "expected exponent of at least 0, found '-1'");
  CHECK_MISTAKE(listOf("CookTorranceMaterial {\nroughness 0 }"), 5,
                "expected roughness above 0, found '0'");
  CHECK_MISTAKE(listOf("CookTorranceMaterial {\nindex -1.5 }"), 5,
                "expected index above 0, found '-1.5'");
  CHECK_MISTAKE(listOf("CookTorranceMaterial {\nspecularColor 1\n0.5\n1.5 }"), 7,
                "expected specularColor from 0 to 1 in each component, found '1.5'");
  CHECK_MISTAKE(listOf("CookTorranceMaterial { specularColor # red\n-.5 0 0 }"), 5, "'-.5'");
  CHECK_MISTAKE(listOf("WardMaterial { roughnessX 1\nroughnessY 0 }"), 5,
                "expected roughnessY above 0, found '0'");
  CHECK_MISTAKE(listOf("WardMaterial {\nroughnessX -1 }"), 5, "expected roughnessX above 0");
  CHECK_MISTAKE(listOf("WardMaterial {\n\ntangent 0 0 0 }"), 6, "tangent that is not zero");
  CHECK_MISTAKE(listOf("OrenNayarMaterial { roughness\n-0.1 }"), 5,
                "expected roughness of at least 0, found '-0.1'");
  for (const char* kind : {"PhongMaterial", "BlinnPhongMaterial", "CookTorranceMaterial",
                           "WardMaterial", "OrenNayarMaterial"}) {
    CHECK_MISTAKE(listOf(std::string(kind) + " {\nindexOfRefraction 0 }"), 5,
                  "expected indexOfRefraction above 0, found '0'");
  }
}

TEST("index and specularColor exclude each other, whichever comes first") {
  const std::string both = "expected index or specularColor in CookTorranceMaterial, found both";
  CHECK_MISTAKE(listOf("CookTorranceMaterial { index 1.5\nspecularColor\n1 1 1 }"), 6, both);
  CHECK_MISTAKE(listOf("CookTorranceMaterial { specularColor 1 1 1\nindex 1.5 }"), 5, both);
}

TEST("a distribution must be one of the two words") {
  CHECK_MISTAKE(listOf("CookTorranceMaterial {\ndistribution ggx }"), 5,
                "expected GGX or Beckmann for distribution, found 'ggx'; did you mean 'GGX'?");
  CHECK_MISTAKE(listOf("CookTorranceMaterial { distribution\nBekmann }"), 5, "'Beckmann'?");
  CHECK_MISTAKE(listOf("CookTorranceMaterial { distribution }"), 4,
                "expected GGX or Beckmann for distribution, found '}'");
  CHECK_MISTAKE(listOf("CookTorranceMaterial { distribution 3 }"), 4,
                "expected GGX or Beckmann for distribution, found '3'");
  CHECK_MISTAKE(listOf("CookTorranceMaterial { distribution\nroughness 1 }"), 5,
                "expected GGX or Beckmann for distribution, found 'roughness'");
  const std::string cut = kStart + "Group { numObjects 1\nCookTorranceMaterial { distribution";
  CHECK_MISTAKE(cut, 5, "expected GGX or Beckmann for distribution, found the end of the file");
  // One slip is told once, and what follows is still read.
  CHECK_EQUAL(scenes::mistakesIn(listOf("CookTorranceMaterial { distribution x roughness 1 }")),
              "4: expected GGX or Beckmann for distribution, found 'x'\n");
}

TEST("reading finds its way again at every field behind an unknown one") {
  const char* const fields[] = {"roughness x", "index x", "distribution x", "specularColor x 0 0"};
  for (const std::string field : fields) {
    const std::string mistakes =
        scenes::mistakesIn(listOf("CookTorranceMaterial { shine 1 gloss\n" + field + " }"));
    check::report(scenes::contains(mistakes, "5: expected "), __FILE__, __LINE__, mistakes);
  }
  for (const std::string field : {"roughnessX x", "roughnessY x", "tangent x 0 0"}) {
    const std::string mistakes =
        scenes::mistakesIn(listOf("WardMaterial { shine 1\n" + field + " }"));
    check::report(scenes::contains(mistakes, "5: expected "), __FILE__, __LINE__, mistakes);
  }
}

TEST("misspelt kinds and fields of others are named with the word that was meant") {
  CHECK_MISTAKE(listOf("BlinPhongMaterial { }"), 4, "did you mean 'BlinnPhongMaterial'?");
  CHECK_MISTAKE(listOf("CookTorrance { }"), 4, "unknown word 'CookTorrance' in Materials");
  CHECK_MISTAKE(around("WardMatrial { } " + kSphere), 5, "did you mean 'WardMaterial'?");
  CHECK_MISTAKE(around("OrenNayerMaterial { } " + kSphere), 5, "did you mean 'OrenNayarMaterial'?");
  CHECK_MISTAKE(listOf("WardMaterial { roughness 1 }"), 4,
                "unknown word 'roughness' in WardMaterial; did you mean 'roughnessX'?");
  CHECK_MISTAKE(listOf("OrenNayarMaterial { exponent 1 }"), 4, "in OrenNayarMaterial");
  CHECK_MISTAKE(listOf("PhongMaterial { tangent 1 0 0 }"), 4,
                "unknown word 'tangent' in PhongMaterial; expected specularColor");
}
