// The words for pictures and noise in materials and behind the scene: what they make, and what is
// said of them where they are wrong.
#include <filesystem>

#include "check.h"
#include "image/picture_file.h"
#include "math/functions.h"
#include "scene/scene_files.h"
#include "scene_text.h"
#include "shading/diffuse_map.h"
#include "vectors.h"

using scene_text::parse, scenes::contains;

namespace {

/// Pictures of one pixel in a folder beside the scenes of this process: a.png, which is green, and
/// the faces of a cube map, which are blue.
class Pictures {
 public:
  Pictures() {
    std::filesystem::create_directories(path());
    write("a.png", {0, 255, 0});
    for (const std::string_view face : CubeMap::kFaces) {
      write(std::string(face) + ".png", {0, 0, 255});
    }
  }
  ~Pictures() { std::filesystem::remove_all(path()); }

  static std::string name() { return "map_words_" + std::to_string(getpid()); }
  static std::string path() { return check::temporaryFolder() + "/" + name(); }

 private:
  static void write(const std::string& file, Rgb8 color) {
    Image image(1, 1);
    image.setPixel(0, 0, color);
    writePicture(image, path() + "/" + file);
  }
};

SceneRules rulesOf(Language language) {
  SceneRules rules;
  rules.language = language;
  return rules;
}
const SceneRules kOf2012Rules = rulesOf(Language::of2012);

std::string material(const std::string& words) {
  return "Materials { numMaterials 1 Material { diffuseColor 1 0 0\n" + words + "\n} }\n";
}
std::string noise(const std::string& words) { return material("Noise { " + words + " }"); }

/// "LINE: message" with the camera's line counted; "" where there is none.
std::string mistakeOf(const std::string& text, const SceneRules& rules = kOf2012Rules) {
  try {
    parse(text, rules);
  } catch (const InputError& mistake) {
    const std::string message = mistake.what();
    return message.substr(message.find(".txt:") + 5);
  }
  return "";
}

}  // namespace

TEST("a material's texture is a picture in place of its diffuse colour") {
  const Pictures pictures;
  const SceneParser scene = parse(material("texture " + Pictures::name() + "/a.png"), kOf2012Rules);
  const DiffuseMap* const map = scene.getMaterial(0)->getDiffuseMap();
  CHECK(map != nullptr);
  CHECK_EQUAL(dynamic_cast<const ImageTexture&>(*map).colorAt(0, 0), Vec3d(0, 1, 0));
  CHECK_EQUAL(scene.getMaterial(0)->getDiffuseColor(), Vec3f(1, 0, 0));
  CHECK_EQUAL(scene.getPictureBytes(), std::size_t(3));
  CHECK_EQUAL(scene.getInputFiles().size(), std::size_t(1));
}

TEST("materials of one picture have one map") {
  const Pictures pictures;
  const std::string words = "Material { texture " + Pictures::name() + "/a.png }";
  const SceneParser scene =
      parse("Materials { numMaterials 2 " + words + words + " }", kOf2012Rules);
  CHECK(scene.getMaterial(0)->getDiffuseMap() == scene.getMaterial(1)->getDiffuseMap());
  CHECK_EQUAL(scene.getPictureBytes(), std::size_t(3));
}

TEST("a material's noise is of two colours, the first one where the sine is highest") {
  const SceneParser scene =
      parse(noise("color 1 0 .5 color 0 1 .25 octaves 0 frequency 2 amplitude 3"), kOf2012Rules);
  const DiffuseMap& map = *scene.getMaterial(0)->getDiffuseMap();
  const auto colorAt = [&](double x) {
    Hit hit;
    hit.record(1, nullptr, {0, 0, 1}, {x, 7, 8}, {});
    return map.colorAt(hit, Vec3f());
  };
  // Without octaves the sine is that of 2 x.
  CHECK_NEAR_VECTOR(colorAt(math::radians(45)), Vec3d(1, 0, 0.5), 1e-15);
  CHECK_NEAR_VECTOR(colorAt(math::radians(-45)), Vec3d(0, 1, 0.25), 1e-15);
  CHECK_EQUAL(scene.getWarnings().size(), parse(material(""), kOf2012Rules).getWarnings().size());
}

TEST("mistakes in noise are told where they stand") {
  const std::string rest = " octaves 1 frequency 1 amplitude 1";
  CHECK(contains(mistakeOf(noise("color 1 1 1" + rest)), "3: expected two color in Noise"));
  CHECK(contains(mistakeOf(noise("color 1 1 1 color 0 0 0\ncolor .5 1 1" + rest)),
                 "4: expected two color in Noise, found '.5'"));
  CHECK(contains(mistakeOf(noise("color 1 1 1 color 0 0 0 octaves 33 frequency 1 amplitude 1")),
                 "octaves from 0 to 32"));
  CHECK(contains(mistakeOf(noise("color 1 1 1 color 0 0 0 octaves 3 amplitude 1")),
                 "expected frequency in Noise"));
  CHECK(contains(mistakeOf(noise("color 1 1 color 0 0 0" + rest)), "number for color"));
  CHECK(contains(mistakeOf(noise("size 3")), "unknown word 'size' in Noise"));
}

TEST("a texture that is missing or broken is a mistake in the line of its name") {
  const Pictures pictures;
  CHECK(contains(mistakeOf(material("shininess 3\ntexture no.bmp")),
                 "4: cannot read the picture 'no.bmp'; looked for"));
  std::ofstream(Pictures::path() + "/bad.bmp") << "BM";
  CHECK(contains(mistakeOf(material("\ntexture " + Pictures::name() + "/bad.bmp")),
                 "4: cannot read the picture '" + Pictures::name() + "/bad.bmp'; "));
}

TEST("a material has a texture or noise, not both") {
  const Pictures pictures;
  const std::string both =
      "Noise { color 1 1 1 color 0 0 0 octaves 1 frequency 1 amplitude 1 }\n"
      "texture " +
      Pictures::name() + "/a.png";
  CHECK(contains(mistakeOf(material(both)), "4: expected texture or Noise in a material"));
}

TEST("bump is passed over with a warning, whether or not there is such a file") {
  for (const Language language : {Language::of2012, Language::of2016}) {
    const SceneParser scene = parse(material("bump no_such.bmp"), rulesOf(language));
    CHECK(scene.getMaterial(0)->getDiffuseMap() == nullptr);
    std::string warnings;
    for (const std::string& warning : scene.getWarnings()) warnings += warning;
    CHECK(contains(warnings, ":3: bump is passed over"));
    CHECK(contains(warnings, "no_such.bmp"));
  }
}

TEST("a cube map stands behind the scene, and its colour where the word is missing") {
  const Pictures pictures;
  const std::string color = "Background { color 1 0 0 ";
  for (const Language language : {Language::of2012, Language::of2016}) {
    const SceneParser scene =
        parse(color + "cubeMap " + Pictures::name() + " }", rulesOf(language));
    CHECK_EQUAL(scene.getBackground().colorAt({1, 2, 3}), Vec3f(0, 0, 1));
    CHECK_EQUAL(scene.getBackgroundColor(), Vec3f(1, 0, 0));
    CHECK_EQUAL(scene.getPictureBytes(), std::size_t(18));
    CHECK_EQUAL(scene.getInputFiles().size(), std::size_t(6));
    CHECK_EQUAL(parse(color + "}", rulesOf(language)).getBackground().colorAt({1, 2, 3}),
                Vec3f(1, 0, 0));
  }
  const SceneParser nodes =
      scene_text::parseWhole("Camera { center 0 0 5 direction 0 0 -1 up 0 1 0 fov 30 } " + color +
                                 "cube_map " + Pictures::name() + " } Scene { }",
                             rulesOf(Language::of2020));
  CHECK_EQUAL(nodes.getBackground().colorAt({1, 2, 3}), Vec3f(0, 0, 1));
}

TEST("a cube map without one of its faces is a mistake that names it") {
  const Pictures pictures;
  std::filesystem::remove(Pictures::path() + "/up.png");
  CHECK(contains(mistakeOf("Background {\ncubeMap " + Pictures::name() + " }"),
                 "3: cannot read the picture '" + Pictures::name() + "/up.bmp'; looked for"));
}

TEST("in scenes of 2003 a word for pictures names the course that has it") {
  const SceneRules of2003;
  CHECK(contains(mistakeOf(material("texture a.bmp"), of2003),
                 "3: unknown word 'texture' in Material; texture is a word of 2012"));
  CHECK(contains(mistakeOf("Background {\ncubeMap church }", of2003),
                 "3: unknown word 'cubeMap' in Background; cubeMap is a word of 2012"));
  CHECK(contains(mistakeOf(material("bump a.bmp"), of2003), "add -course 2012"));
}
