// Surfaces at the same place: the first in the scene is seen, neither shadows nor rays of any kind
// meet the other, and every way of computing the picture gives the same bytes.
#include "../accel/comparison.h"
#include "check.h"
#include "image/image.h"
#include "render/renderer.h"
#include "scene_text.h"

namespace {

const char* const kRing =
    "v 1 0 0\nv -0.3 0.9 0.2\nv -0.4 -0.8 0.1\nv 0.2 0.1 1.1\nv 0.1 -0.2 -0.9\n"
    "f 1 2 4\nf 2 3 4\nf 3 1 4\nf 2 1 5\nf 3 2 5\nf 1 3 5\n";

/// A camera above a floor of a material of its own, two lights, and `objects` in the materials 0
/// (`first`) and 1 (red, with a mirror).
std::string sceneOf(const std::string& first, const std::string& objects, int count) {
  return "PerspectiveCamera { center 1 2.2 4.5 direction -0.2 -0.4 -1 up 0 1 0 angle 50 }"
         "Lights { numLights 2 DirectionalLight { direction -1 -0.7 -0.3 color 0.6 0.6 0.5 }"
         "  PointLight { position 2 3 1 color 0.5 0.4 0.5 } }"
         "Background { color 0.3 0.5 0.7 ambientLight 0.1 0.1 0.1 }"
         "Materials { numMaterials 3 PhongMaterial { " +
         first +
         " } PhongMaterial { diffuseColor 1 0 0 reflectiveColor 0.5 0 0 }"
         "  PhongMaterial { diffuseColor 0.6 0.7 0.5 reflectiveColor 0.2 0.2 0.2 } }"
         "Group { numObjects " +
         std::to_string(count + 1) + " " + objects +
         " MaterialIndex 2 Plane { normal 0 1 0 offset -1.3 } }";
}

std::string bytesOf(const Image& image) {
  std::string bytes;
  for (int i = 0; i < image.Width() * image.Height(); ++i) {
    const Rgb8 p = image.getPixel(i % image.Width(), i / image.Width());
    for (const int byte : {int(p.r), int(p.g), int(p.b)}) bytes += char(byte);
  }
  return bytes;
}

std::string picture(const SceneParser& scene, const Object3D& geometry,
                    const RenderOptions& options, int threads) {
  Image image(40, 40);
  RenderTargets targets;
  targets.color = &image;
  render(RayTracer(scene, geometry, options), threads, targets);
  return bytesOf(image);
}

/// The picture, after every way of computing it has given the same.
std::string theOnePicture(const SceneParser& scene, const RenderOptions& options) {
  const std::string plain = picture(scene, *scene.getGroup(), options, 1);
  for (const SimdLevel level : accel_test::levels()) {
    const CompiledScene compiled(*scene.getGroup(), 2, level);
    for (const int threads : {1, 3}) CHECK(picture(scene, compiled, options, threads) == plain);
  }
  return plain;
}

/// Opaque, a mirror and glass.
const char* const kMatter[] = {
    "diffuseColor 0.8 0.9 1", "diffuseColor 0.2 0.2 0.2 reflectiveColor 0.7 0.8 0.7",
    "diffuseColor 0.1 0.1 0.1 transparentColor 0.9 0.8 0.9 indexOfRefraction 1.4"};

/// With an epsilon of either kind and in all three materials, `object` in two materials at the
/// same place looks like the first of them alone.
void expectFirstAlone(const std::string& object, const std::string& copy) {
  for (const char* material : kMatter) {
    const std::string lone = "MaterialIndex 0 " + object;
    const SceneParser once = scene_text::parseWhole(sceneOf(material, lone, 1));
    const SceneParser twice =
        scene_text::parseWhole(sceneOf(material, lone + " MaterialIndex 1 " + copy, 2));
    for (const Epsilon& epsilon :
         {Epsilon{Epsilon::Kind::adaptive, 0}, Epsilon{Epsilon::Kind::fixed, Epsilon::kCourse}}) {
      RenderOptions options;
      options.epsilon = epsilon;
      const bool same = theOnePicture(once, options) == theOnePicture(twice, options);
      check::report(same, __FILE__, __LINE__, object + " twice, of " + material);
    }
  }
}

int largestDifference(const std::string& a, const std::string& b) {
  int largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const int x = static_cast<unsigned char>(a[i]), y = static_cast<unsigned char>(b[i]);
    largest = std::max(largest, std::abs(x - y));
  }
  return largest;
}

}  // namespace

TEST("of two equal surfaces at one place only the first is seen, in shadows and mirrors too") {
  const std::string ring = scene_text::write(kRing, ".obj");
  const std::string mesh = scene_text::mesh(ring);
  for (const std::string& object :
       {std::string("Sphere { center 0.1 0.2 0.3 radius 0.9 }"),
        std::string("Plane { normal 0.2 1 0.3 offset -0.7 }"),
        std::string("Triangle { vertex0 -1.1 -0.7 0.9 vertex1 1.3 -0.4 0.7 vertex2 0.1 1.2 -0.6 }"),
        mesh, "Transform { Rotate { 1 2 3 40 } Scale 0.9 1.2 0.7" + mesh + "}",
        std::string(
            "Transform { YRotate 25 Scale 1 0.7 1.2 Sphere { center 0 0 0 radius 0.9 } }")}) {
    expectFirstAlone(object, object);
  }
  std::remove(ring.c_str());
}

TEST(
    "equal surfaces that are computed in different ways show no acne, and the same bytes each "
    "way") {
  // The places agree up to rounding only, and either may be met first: of one material it must not
  // matter.
  const std::string ring = scene_text::write(kRing, ".obj");
  const std::string mesh = scene_text::mesh(ring);
  const std::string ball = "Sphere { center 0.1 0.2 0.3 radius 0.9 }";
  const std::string pairs[][2] = {
      {ball,
       "Transform { Translate 0.1 0.2 0.3 UniformScale 0.9 Sphere { center 0 0 0 radius 1 } }"},
      {ball, "Transform { Rotate { 1 1 2 30 } Rotate { 1 1 2 -30 } " + ball + "}"},
      {mesh, "Transform { Rotate { 1 1 2 30 } Rotate { 1 1 2 -30 } " + mesh + "}"},
      {"Plane { normal 0.2 1 0.3 offset -0.7 }",
       "Transform { Translate 0 -0.7441102068914254 0 Plane { normal 2 10 3 offset 0 } }"},
      {"Plane { normal 0 1 0 offset -0.6 }",
       "Triangle { vertex0 -1.1 -0.6 0.9 vertex1 1.3 -0.6 0.7 vertex2 0.1 -0.6 -1.7 }"}};
  for (const auto& pair : pairs) {
    for (const char* material : kMatter) {
      const SceneParser once =
          scene_text::parseWhole(sceneOf(material, "MaterialIndex 0 " + pair[0], 1));
      const SceneParser twice = scene_text::parseWhole(
          sceneOf(material, "MaterialIndex 0 " + pair[0] + " " + pair[1], 2));
      for (const Epsilon& epsilon :
           {Epsilon{Epsilon::Kind::adaptive, 0}, Epsilon{Epsilon::Kind::fixed, Epsilon::kCourse}}) {
        RenderOptions options;
        options.epsilon = epsilon;
        const int by =
            largestDifference(theOnePicture(once, options), theOnePicture(twice, options));
        check::report(by <= 1, __FILE__, __LINE__,
                      pair[0] + " and " + pair[1] + " of " + material + ": " + std::to_string(by) +
                          " levels apart");
      }
    }
  }
  std::remove(ring.c_str());
}
