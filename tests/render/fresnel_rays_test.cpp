// -fresnel: how much is mirrored and how much passes, and how glass dims light on the way inside.
#include "ray_log.h"
#include "render/renderer.h"
#include "scene_text.h"
#include "vectors.h"

using scene_text::colorTowards;
using scene_text::parse;

namespace {

const Vec3d kSky(0.5, 0.25, 1);  // the background of every scene here

/// Things in no light but `ambient`, under the sky. Material 0 is black but for `fields`, material
/// 1 shows `ambient` itself.
class InDark {
 public:
  InDark(const std::string& fields, int count, const std::string& objects)
      : scene_(parse("Background { color 0.5 0.25 1 ambientLight 0.125 0.75 0.5 }"
                     "Lights { numLights 1 DirectionalLight { direction 0 -1 0 color 0 0 0 } }"
                     "Materials { numMaterials 2 Material { diffuseColor 0 0 0 " +
                     fields + " } Material { } } Group { numObjects " + std::to_string(count) +
                     " MaterialIndex 0 " + objects + " }")) {
    scene_.findSolids();
  }
  operator const SceneParser&() const { return scene_; }

 private:
  SceneParser scene_;
};

const Vec3d kShown(0.125, 0.75, 0.5);  // what material 1 looks like

RenderOptions fresnel(int maxBounces, float minWeight = 0, bool nested = false) {
  RenderOptions options = scene_text::bouncing(maxBounces);
  options.minWeight = minWeight;
  options.fresnel = true;
  options.nestedDielectrics = nested;
  return options;
}

const std::string kBall = " Sphere { center 0 0 0 radius 1 }";
const std::string kWhiteGlass = "transparentColor 1 1 1 indexOfRefraction 1.5";
const std::string kTinted = "transparentColor 0.5 0.25 1";

/// The closed cube [-1, 1]^3 as an OBJ file.
std::string cubeFile(int faces = 6) {
  const char* const sides[] = {"1 2 4 3", "5 7 8 6", "1 5 6 2", "3 4 8 7", "1 3 7 5", "2 6 8 4"};
  std::string text;
  for (int i = 0; i < 8; ++i) {
    text += "v " + std::to_string(i & 4 ? 1 : -1) + " " + std::to_string(i & 2 ? 1 : -1) + " " +
            std::to_string(i & 1 ? 1 : -1) + "\n";
  }
  for (int i = 0; i < faces; ++i) text += std::string("f ") + sides[i] + "\n";
  return scene_text::write(text, ".obj");
}

Vec3d dimmed(double length) { return {std::pow(0.5, length), std::pow(0.25, length), 1}; }

}  // namespace

TEST("glass mirrors the part F and lets through 1 - F") {
  const InDark scene(kWhiteGlass, 1, kBall);
  // Straight through the middle F = 0.04 at both surfaces. One bounce shows the mirrored part, two
  // bounces also what has passed both.
  CHECK_EQUAL(colorTowards(scene, {0, 0, 5}, {0, 0, 0}, fresnel(0)), Vec3f());
  CHECK_NEAR_VECTOR(colorTowards(scene, {0, 0, 5}, {0, 0, 0}, fresnel(1)), kSky * 0.04, 1e-7);
  CHECK_NEAR_VECTOR(colorTowards(scene, {0, 0, 5}, {0, 0, 0}, fresnel(2)),
                    kSky * (0.04 + 0.96 * 0.96), 1e-7);
  // At sin 0.6 of the normal, in index 1.5 sin 0.4; across (0.6 the other way: cos 0.8, inside
  // sqrt(0.84)): ((0.8 - 1.5 c) / (0.8 + 1.5 c))^2 and ((1.2 - c) / (1.2 + c))^2, halved.
  const double c = std::sqrt(0.84), across = (0.8 - 1.5 * c) / (0.8 + 1.5 * c),
               along = (1.2 - c) / (1.2 + c), f = (across * across + along * along) / 2;
  CHECK_NEAR_VECTOR(colorTowards(scene, {0.6, 0, 5}, {0.6, 0, 0}, fresnel(1)), kSky * f, 1e-7);
  CHECK_NEAR_VECTOR(colorTowards(scene, {0.6, 0, 5}, {0.6, 0, 0}, fresnel(2)),
                    kSky * (f + (1 - f) * (1 - f)), 1e-7);
}

TEST("no light is lost or made in clear glass of any shape") {
  const std::string shapes = kBall + "Transform { Translate 0 0 3 Scale 1 0.5 0.7 " + kBall +
                             " } Transform { Translate 0.4 0 -3 XRotate 30 YRotate 40 " +
                             scene_text::mesh(cubeFile()) + " }";
  const InDark scene(kWhiteGlass, 3, shapes);
  for (const bool nested : {false, true}) {
    for (double x : {0.0, 0.3, 0.55, 0.8, 0.95}) {
      const Vec3f found =
          colorTowards(scene, {x, 0.2, 9}, {x, 0.1, 0}, fresnel(400, 1e-5f, nested));
      CHECK_NEAR_VECTOR(found, kSky, 2e-3);  // 1e-5 in some hundred rays is not traced
    }
  }
}

TEST("light is dimmed by transparentColor to the power of the length inside") {
  const InDark scene(kTinted, 1, kBall);  // index 1: nothing is mirrored
  for (const bool nested : {false, true}) {
    const RenderOptions options = fresnel(2, 0, nested);
    CHECK_NEAR_VECTOR(colorTowards(scene, {0, 0, 5}, {0, 0, 0}, options), kSky * dimmed(2), 1e-6);
    CHECK_NEAR_VECTOR(colorTowards(scene, {0.6, 0, 5}, {0.6, 0, 0}, options), kSky * dimmed(1.6),
                      1e-6);
  }
}

TEST("the length inside is in world units under any Transforms") {
  const InDark scene(kTinted, 2,
                     "Transform { Scale 2 1 3 Transform { Translate 0.25 0 0"
                     "  YRotate 90 Scale 1 1 0.5 " +
                         kBall +
                         " } }"
                         "Transform { Translate 9 0 0 Scale 2 1 3 YRotate 30 " +
                         scene_text::mesh(cubeFile()) + " }");
  // Along z the ball's x, of half length 1, is tripled.
  CHECK_NEAR_VECTOR(colorTowards(scene, {0.5, 0, 9}, {0.5, 0, 0}, fresnel(2)), kSky * dimmed(6),
                    1e-6);
  // The cube's sides are 30 degrees from z before z is tripled: 2 / cos(30) * 3.
  CHECK_NEAR_VECTOR(colorTowards(scene, {9, 0.1, 9}, {9, 0.1, 0}, fresnel(2)),
                    kSky * dimmed(6 / std::sqrt(0.75)), 1e-6);
}

TEST("a surface that is not closed dims once where it is crossed") {
  const InDark scene(kTinted, 1, scene_text::mesh(cubeFile(5)));
  CHECK_NEAR_VECTOR(colorTowards(scene, {0.3, 5, 0.1}, {0.3, 0, 0.1}, fresnel(9)), kSky * dimmed(2),
                    1e-6);
  const InDark flat(kTinted + " indexOfRefraction 1.5", 1, "Plane { normal 0 0 1 offset 0 }");
  CHECK_NEAR_VECTOR(colorTowards(flat, {0, 0, 5}, {0, 0, 0}, fresnel(1)),
                    kSky * 0.04 + kSky * dimmed(1) * 0.96, 1e-7);
  // From behind, as from inside; the way there and beyond has no length that dims.
  CHECK_NEAR_VECTOR(colorTowards(flat, {0, 0, -5}, {0, 0, 0}, fresnel(1)),
                    kSky * 0.04 + kSky * dimmed(1) * 0.96, 1e-7);
}

TEST("total internal reflection mirrors everything") {
  // From below the plane, index 2, sin 0.8: nothing passes, and the ground is seen whole.
  const InDark scene(
      "transparentColor 1 1 1 indexOfRefraction 2", 2,
      "Plane { normal 0 1 0 offset 0 } MaterialIndex 1 Plane { normal 0 1 0 offset -3 }");
  CHECK_EQUAL(colorTowards(scene, {-4, -3, 0}, {0, 0, 0}, fresnel(1)), Vec3f(kShown));
  RenderOptions plain = fresnel(1);
  plain.fresnel = false;
  CHECK_EQUAL(colorTowards(scene, {-4, -3, 0}, {0, 0, 0}, plain), Vec3f());
}

TEST("reflectiveColor means nothing to a transparent material") {
  const InDark scene(kWhiteGlass + " reflectiveColor 1 1 1", 1, kBall);
  CHECK_NEAR_VECTOR(colorTowards(scene, {0, 0, 5}, {0, 0, 0}, fresnel(1)), kSky * 0.04, 1e-7);
  // One component above 0 makes it transparent.
  const InDark red("transparentColor 0.1 0 0 indexOfRefraction 1.5 reflectiveColor 1 1 1", 1,
                   kBall);
  CHECK_NEAR_VECTOR(colorTowards(red, {0, 0, 5}, {0, 0, 0}, fresnel(1)), kSky * 0.04, 1e-7);
}

TEST("an opaque mirror follows Schlick's term, and without reflectiveColor mirrors nothing") {
  const InDark scene("reflectiveColor 0.5 0.25 0.125", 1, "Plane { normal 0 1 0 offset 0 }");
  // cos 1/2 gives 1/32 of the rest; from either side.
  const Vec3d r(0.515625, 0.2734375, 0.15234375);
  const double slope = std::sqrt(3.0);
  for (double y : {1.0, -1.0}) {
    CHECK_NEAR_VECTOR(colorTowards(scene, {-slope, y, 0}, {0, 0, 0}, fresnel(1)), kSky * r, 1e-7);
  }
  CHECK_NEAR_VECTOR(colorTowards(scene, {0, 1, 0}, {0, 0, 0}, fresnel(1)),
                    kSky * Vec3d(0.5, 0.25, 0.125), 1e-7);
  const InDark dull("", 1, "Plane { normal 0 1 0 offset 0 }");
  CHECK_EQUAL(colorTowards(dull, {-9, 1, 0}, {0, 0, 0}, fresnel(1)), Vec3f());
}

TEST("a mirror inside glass is seen through the glass on both ways") {
  // The ray meets the opaque ball after 1, and comes back after another 1. Its own light is dimmed
  // on the way out as well.
  const InDark scene(kTinted, 2, "Sphere { center 0 0 0 radius 2 } MaterialIndex 1" + kBall);
  CHECK_NEAR_VECTOR(colorTowards(scene, {0, 0, 5}, {0, 0, 0}, fresnel(1)), kShown * dimmed(1),
                    1e-6);
  const SceneParser mirror = parse(
      "Background { color 0.5 0.25 1 } Materials { numMaterials 2"
      "  Material { diffuseColor 0 0 0 transparentColor 0.5 0.25 1 }"
      "  Material { diffuseColor 0 0 0 reflectiveColor 0.5 0.5 0.5 } } Group { numObjects 2"
      "  MaterialIndex 0 Sphere { center 0 0 0 radius 2 } MaterialIndex 1" +
      kBall + " }");
  CHECK_NEAR_VECTOR(colorTowards(mirror, {0, 0, 5}, {0, 0, 0}, fresnel(3)), kSky * dimmed(2) * 0.5,
                    1e-6);
}

TEST("an eye inside glass sees through the rest of it") {
  const InDark scene(kTinted, 1, kBall);
  CHECK_NEAR_VECTOR(colorTowards(scene, {0, 0, 0.5}, {0, 0, 0}, fresnel(1)), kSky * dimmed(1.5),
                    1e-6);
}

TEST("without -nested_dielectrics each closed object around dims on its own") {
  const InDark scene(kTinted, 2, kBall + "Sphere { center 0 0 -0.5 radius 1 }");
  // Along z: in one of them for 0.5, in both for 1.5, in the other for 0.5.
  CHECK_NEAR_VECTOR(colorTowards(scene, {0, 0, 5}, {0, 0, 0}, fresnel(4)), kSky * dimmed(4), 1e-6);
  CHECK_NEAR_VECTOR(colorTowards(scene, {0, 0, 5}, {0, 0, 0}, fresnel(4, 0, true)),
                    kSky * dimmed(2.5), 1e-6);
}

TEST("the weight of a mirrored ray is the length of (F, F, F), of a refracted one of (1 - F)") {
  const InDark scene(kWhiteGlass, 1, kBall);
  // sqrt(3) * 0.04 = 0.0693, sqrt(3) * 0.96 = 1.663.
  CHECK_NEAR_VECTOR(colorTowards(scene, {0, 0, 5}, {0, 0, 0}, fresnel(1, 0.069f)), kSky * 0.04,
                    1e-7);
  CHECK_EQUAL(colorTowards(scene, {0, 0, 5}, {0, 0, 0}, fresnel(1, 0.070f)), Vec3f());
  CHECK_NEAR_VECTOR(colorTowards(scene, {0, 0, 5}, {0, 0, 0}, fresnel(2, 1.66f)),
                    kSky * (0.96 * 0.96), 1e-7);
  CHECK_EQUAL(colorTowards(scene, {0, 0, 5}, {0, 0, 0}, fresnel(2, 1.67f)), Vec3f());
}

TEST("light that is dimmed on the way weighs less") {
  // Index 1: the ray in weighs sqrt(3), the ray out sqrt(3) |(0.5^2, 0.25^2, 0)| = 0.4463.
  const InDark scene("transparentColor 0.5 0.25 0", 1, kBall);
  const Vec3d seen = kSky * Vec3d(0.25, 0.0625, 0);
  CHECK_NEAR_VECTOR(colorTowards(scene, {0, 0, 5}, {0, 0, 0}, fresnel(2, 0.446f)), seen, 1e-6);
  CHECK_EQUAL(colorTowards(scene, {0, 0, 5}, {0, 0, 0}, fresnel(2, 0.447f)), Vec3f());
}

TEST("a white ball of index 1 vanishes to the last byte") {
  const auto picture = [](int balls, bool nested) {
    const std::string ball = "MaterialIndex 2 " + kBall;
    const SceneParser scene = parse(
        "Background { color 0.2 0.3 0.4 ambientLight 0.1 0.1 0.1 }"
        "Lights { numLights 2 DirectionalLight { direction -1 -2 -1 color 0.5 0.4 0.3 }"
        "  PointLight { position 3 4 5 color 0.3 0.4 0.5 } }"
        "Materials { numMaterials 3 Material { diffuseColor 0.8 0.3 0.2 specularColor 1 1 1"
        "  exponent 20 reflectiveColor 0.3 0.3 0.3 } Material { diffuseColor 0.3 0.5 0.2 }"
        "  Material { diffuseColor 0 0 0 transparentColor 1 1 1 } }"
        "Group { numObjects " +
        std::to_string(3 + balls) +
        " MaterialIndex 0 Sphere { center 0.5 0 -2 radius 1 }"
        "  MaterialIndex 1 Sphere { center 0 0 0 radius 0.3 } Plane { normal 0 1 0 offset -1.5 }" +
        (balls ? ball : "") + "}");
    // The ball takes bounces: in and out on the way there, and again behind the mirror.
    RenderOptions options = fresnel(8, 0, nested);
    options.transparentShadows = true;
    Image image(40, 40);
    RenderTargets targets;
    targets.color = &image;
    render(RayTracer(scene, *scene.getGroup(), options), 1, targets);
    return image;
  };
  const Image empty = picture(0, false);
  for (const bool nested : {false, true}) {
    const Image with = picture(1, nested);
    int different = 0;
    for (int k = 0; k < 1600; ++k) {
      different += empty.getPixel(k % 40, k / 40) != with.getPixel(k % 40, k / 40);
    }
    CHECK_EQUAL(different, 0);
  }
}
