// What the scene language means: every section, field, default and older form.
#include "scene/scene_parser.h"

#include <sys/stat.h>

#include <thread>

#include "geometry/plane.h"
#include "geometry/sphere.h"
#include "geometry/transform.h"
#include "geometry/triangle.h"
#include "scene/scene_files.h"
#include "shading/phong_material.h"

using scenes::around;
using scenes::kStart;
using scenes::parse;

namespace {

const std::string kSphere = "Sphere { center 0 0 0 radius 1 }\n";

/// Object `index` of the first top-level Group.
template <class T>
const T& object(const SceneParser& scene, int index) {
  const auto& group = dynamic_cast<const Group&>(*scene.getGroup()->getObjects()[0]);
  return dynamic_cast<const T&>(*group.getObjects()[std::size_t(index)]);
}

const PhongMaterial& material(const SceneParser& scene, int index) {
  return dynamic_cast<const PhongMaterial&>(*scene.getMaterial(index));
}

/// Where the steps take the point (1, 2, 3).
Vec3d moved(const std::string& steps) {
  const auto scene = parse(around("Transform { " + steps + kSphere + "}"));
  return object<Transform>(*scene, 0).getMatrix().transformPoint({1, 2, 3});
}

void checkNear(const Vec3d& found, const Vec3d& expected, int line) {
  check::report(
      length(found - expected) <= 1e-12, __FILE__, line,
      check::show(found.x()) + " " + check::show(found.y()) + " " + check::show(found.z()));
}

}  // namespace

TEST("a perspective camera is read") {
  const auto scene = parse("PerspectiveCamera { center 1 2 3 direction 0 0 -2 up 0 5 1 angle 90 }");
  const auto& camera = dynamic_cast<const PerspectiveCamera&>(*scene->getCamera());
  checkNear(camera.getCenter(), {1, 2, 3}, __LINE__);
  // 90 degrees: the image's right edge, x = 1/2, is seen at 45 degrees.
  const double half = std::sqrt(0.5);
  checkNear(camera.generateRay({0.5, 0}).getDirection(), {half, 0, -half}, __LINE__);
}

TEST("an orthographic camera is read, its fields in any order") {
  const auto scene = parse("OrthographicCamera{size 6 up 0 1 0 center 1 2 3 direction 0 0 -1}");
  const auto& camera = dynamic_cast<const OrthographicCamera&>(*scene->getCamera());
  checkNear(camera.generateRay({0.5, -0.5}).getOrigin(), {4, -1, 3}, __LINE__);
}

TEST("a camera's directions may be of any length") {
  const auto scene =
      parse("OrthographicCamera { center 0 0 0 direction 0 0 -1e-200 up 0 1e300 0 size 2 }");
  checkNear(scene->getCamera()->generateRay({0.5, 0}).getOrigin(), {1, 0, 0}, __LINE__);
}

TEST("lights are read with and without attenuation") {
  const auto scene = parse(
      "OrthographicCamera { center 0 0 0 direction 0 0 -1 up 0 1 0 size 2 }"
      "Lights { numLights 3 DirectionalLight { direction 0 -2 0 color .1 .2 .3 }"
      "PointLight { position 1 2 3 color 1 1 1 attenuation 4 5 6 }"
      "PointLight { color 1 1 1 position 1 2 3 } }");
  CHECK_EQUAL(scene->getNumLights(), 3);
  const auto& first = dynamic_cast<const DirectionalLight&>(*scene->getLight(0));
  CHECK(first.getDirToLight() == Vec3d(0, 1, 0));
  CHECK(first.getColor() == Vec3f(.1f, .2f, .3f));
  const auto& second = dynamic_cast<const PointLight&>(*scene->getLight(1));
  CHECK(second.getPosition() == Vec3d(1, 2, 3));
  CHECK(second.getAttenuation() == Vec3d(4, 5, 6));
  const auto& third = dynamic_cast<const PointLight&>(*scene->getLight(2));
  CHECK(third.getAttenuation() == Vec3d(1, 0, 0));
}

TEST("the background has its colours, or grey and black") {
  const auto given = parse(kStart + "Background { ambientLight .1 .2 .3 color 1 2 -3 }");
  CHECK(given->getBackgroundColor() == Vec3f(1, 2, -3));
  CHECK(given->getAmbientLight() == Vec3f(.1f, .2f, .3f));
  for (const char* text : {"", "Background { }"}) {
    const auto scene = parse(kStart + text);
    CHECK(scene->getBackgroundColor() == Vec3f(.5f, .5f, .5f));
    CHECK(scene->getAmbientLight() == Vec3f(0, 0, 0));
  }
}

TEST("without lights the ambient light is white, with a warning") {
  const std::string camera =
      "OrthographicCamera { center 0 0 0 direction 0 0 -1 up 0 1 0 size 2 }\n"
      "Background { ambientLight .1 .1 .1 } Group { numObjects 0 }\n";
  for (const std::string& text : {camera, camera + "Lights { numLights 0 }"}) {
    const auto scene = parse(text);
    CHECK(scene->getAmbientLight() == Vec3f(1, 1, 1));
    CHECK_EQUAL(scene->getWarnings().size(), 1u);
  }
  CHECK(parse(kStart + "Group { numObjects 0 }")->getWarnings().empty());
}

TEST("materials take their fields in any order, the last of a name holding") {
  const auto scene = parse(
      kStart.substr(0, kStart.find("Materials")) +
      "Materials { numMaterials 2 PhongMaterial { indexOfRefraction 1.5 reflectiveColor .1 .2 .3"
      " transparentColor .4 .5 .6 exponent 7 specularColor .7 .8 .9 exponent 8"
      " diffuseColor 1 0 0 diffuseColor 0 1 0 } Material { } }");
  CHECK_EQUAL(scene->getNumMaterials(), 2);
  const PhongMaterial& full = material(*scene, 0);
  CHECK(full.getDiffuseColor() == Vec3f(0, 1, 0));
  CHECK(full.getSpecularColor() == Vec3f(.7f, .8f, .9f));
  CHECK(full.getTransparentColor() == Vec3f(.4f, .5f, .6f));
  CHECK(full.getReflectiveColor() == Vec3f(.1f, .2f, .3f));
  CHECK_EQUAL(full.getExponent(), 8.0f);
  CHECK_EQUAL(full.getIndexOfRefraction(), 1.5f);
  const PhongMaterial& plain = material(*scene, 1);
  CHECK(plain.getDiffuseColor() == Vec3f(1, 1, 1));
  CHECK(plain.getSpecularColor() == Vec3f() && plain.getTransparentColor() == Vec3f());
  CHECK(plain.getReflectiveColor() == Vec3f());
  CHECK_EQUAL(plain.getExponent(), 1.0f);
  CHECK_EQUAL(plain.getIndexOfRefraction(), 1.0f);
}

TEST("a material has the priority given, or 0") {
  const auto scene = parse(kStart.substr(0, kStart.find("Materials")) +
                           "Materials { numMaterials 3 Material { priority -7 } Material { }"
                           "  PhongMaterial { exponent 2 priority 2147483647 } }");
  CHECK_EQUAL(scene->getMaterial(0)->getPriority(), -7);
  CHECK_EQUAL(scene->getMaterial(1)->getPriority(), 0);
  CHECK_EQUAL(scene->getMaterial(2)->getPriority(), 2147483647);
}

TEST("objects are read in order, with comments and glued braces anywhere") {
  const auto scene =
      parse("\xEF\xBB\xBF# title\r\n" + kStart +
            "Group{numObjects 3 MaterialIndex 1 // one\r\nSphere{center 1 2 3 radius 4}\r\n"
            "Plane{normal 0 2 0 offset -1.5}Triangle{vertex0 0 0 0 vertex1 1 0 0 vertex2 0 1 0}}");
  const auto& sphere = object<Sphere>(*scene, 0);
  CHECK(sphere.getCenter() == Vec3d(1, 2, 3));
  CHECK_EQUAL(sphere.getRadius(), 4.0);
  CHECK(sphere.getMaterial() == scene->getMaterial(1));
  const auto& plane = object<Plane>(*scene, 1);
  CHECK(plane.getNormal() == Vec3d(0, 1, 0));
  CHECK_EQUAL(plane.getOffset(), -1.5);
  CHECK(object<Triangle>(*scene, 2).getVertex(1) == Vec3d(1, 0, 0));
}

TEST("a MaterialIndex holds through nested groups and after their ends") {
  const auto scene = parse(kStart + "Group { numObjects 3 MaterialIndex 1 " + kSphere +
                           "Group { numObjects 2 " + kSphere + "MaterialIndex 0 " + kSphere + "} " +
                           kSphere + "} Group { numObjects 1 " + kSphere + "}");
  const auto& inner = object<Group>(*scene, 1);
  const auto materialOf = [](const Object3D* sphere) {
    return dynamic_cast<const Sphere&>(*sphere).getMaterial();
  };
  CHECK(object<Sphere>(*scene, 0).getMaterial() == scene->getMaterial(1));
  CHECK(materialOf(inner.getObjects()[0]) == scene->getMaterial(1));
  CHECK(materialOf(inner.getObjects()[1]) == scene->getMaterial(0));
  CHECK(object<Sphere>(*scene, 2).getMaterial() == scene->getMaterial(0));
  CHECK_EQUAL(scene->getGroup()->getGroupSize(), 2);
  const auto& second = dynamic_cast<const Group&>(*scene->getGroup()->getObjects()[1]);
  CHECK(materialOf(second.getObjects()[0]) == scene->getMaterial(0));
}

TEST("the first step listed is the last one applied, braces or not") {
  // Scale first: (2, 4, 6); then the translation: (12, 4, 6). The other way round: (22, 4, 6).
  checkNear(moved("Translate 10 0 0 Scale 2 2 2 "), {12, 4, 6}, __LINE__);
  checkNear(moved("Scale { 2 2 2 } Translate{10 0 0}"), {22, 4, 6}, __LINE__);
  checkNear(moved("UniformScale { -2 } "), {-2, -4, -6}, __LINE__);
  checkNear(moved(""), {1, 2, 3}, __LINE__);
}

TEST("rotations turn counter-clockwise, in degrees, about axes of any length") {
  // About z: (x, y) -> (-y, x); about x: (y, z) -> (-z, y); about y: (z, x) -> (-x, z).
  checkNear(moved("ZRotate 90 "), {-2, 1, 3}, __LINE__);
  checkNear(moved("XRotate { 90 }"), {1, -3, 2}, __LINE__);
  checkNear(moved("YRotate 90 "), {3, 2, -1}, __LINE__);
  checkNear(moved("Rotate { 0 0 9e-200 90 }"), {-2, 1, 3}, __LINE__);
  // About (1, 1, 1) by 120 degrees the axes change places: x -> y -> z -> x.
  checkNear(moved("Rotate 5 5 5 120 "), {3, 1, 2}, __LINE__);
}

TEST("a Matrix lists rows") {
  // (1 + 4 + 0 + 4, 2 * 2 + 5, 3 - 6) = (9, 9, -3).
  checkNear(moved("Matrix { 1 2 0 4  0 2 0 5  0 0 1 -6  0 0 0 1 }"), {9, 9, -3}, __LINE__);
  checkNear(moved("Matrix 1 2 0 4  0 2 0 5  0 0 1 -6  0 0 0 1 "), {9, 9, -3}, __LINE__);
}

TEST("a Transform may hold a plane, a Group or another Transform") {
  const auto scene =
      parse(around("Transform { Scale 2 1 1 Transform { Translate 1 0 0 Group { numObjects 2 " +
                   kSphere + "Plane { normal 1 0 0 offset 1 } } } }"));
  const auto& outer = object<Transform>(*scene, 0);
  CHECK(dynamic_cast<const Transform*>(outer.getObject()) != nullptr);
  // The sphere spans x = -1 to 1, moved to 0 to 2, stretched to 0 to 4: longer than its height 2.
  CHECK_EQUAL(scene->getSpan(), 4.0);
}

TEST("the span is 0 where nothing has bounds") {
  CHECK_EQUAL(parse(around("Plane { normal 0 1 0 offset 0 }"))->getSpan(), 0.0);
  CHECK_EQUAL(parse(kStart)->getSpan(), 0.0);
}

TEST("the course's older forms are read: underscores, and materials inside a Group") {
  const auto scene = parse(
      "OrthographicCamera { center 0 0 9 direction 0 0 -1 up 0 1 0 size 5 }"
      "Background { color 0 0 0 ambient_light .5 .5 .5 }"
      "Group { num_objects 3 Material { diffuse_color 1 0 0 } " +
      kSphere + "PhongMaterial { diffuse_color 0 1 0 index_of_refraction 2 } " + kSphere + kSphere +
      "}");
  CHECK_EQUAL(scene->getNumMaterials(), 2);
  CHECK(object<Sphere>(*scene, 0).getMaterial()->getDiffuseColor() == Vec3f(1, 0, 0));
  CHECK(object<Sphere>(*scene, 1).getMaterial()->getDiffuseColor() == Vec3f(0, 1, 0));
  CHECK(object<Sphere>(*scene, 2).getMaterial() == scene->getMaterial(1));
  CHECK_EQUAL(scene->getMaterial(1)->getIndexOfRefraction(), 2.0f);
}

TEST("a material inside a Group comes behind the listed ones, and an index undoes it") {
  const auto scene =
      parse(around("Material { exponent 3 } " + kSphere + "MaterialIndex 1 " + kSphere, 2));
  CHECK_EQUAL(scene->getNumMaterials(), 3);
  CHECK(object<Sphere>(*scene, 0).getMaterial() == scene->getMaterial(2));
  CHECK(object<Sphere>(*scene, 1).getMaterial() == scene->getMaterial(1));
  for (int i = 0; i < 3; ++i) CHECK_EQUAL(scene->getMaterial(i)->getNumber(), i);
}

TEST("triangles without area are warned of by line, and many of them counted") {
  const std::string flat = "Triangle { vertex0 0 0 0 vertex1 1 1 1 vertex2 2 2 2 }\n";
  std::string text;
  for (int i = 0; i < 1000; ++i) text += flat;
  const auto scene = parse(around(text, 1000));
  CHECK_EQUAL(scene->getWarnings().size(), 12u);  // the first is of a material that is not used
  CHECK(scenes::contains(scene->getWarnings()[2], "scene.txt:6: the triangle has no area"));
  CHECK(scenes::contains(scene->getWarnings()[11], "990 more"));
}

TEST("1000 levels of Groups and Transforms are read") {
  std::string text = kStart + "Group { numObjects 1 MaterialIndex 0\n", end = "}";
  for (int i = 0; i < 999; ++i) {
    text += i % 2 == 0 ? "Transform {\n" : "Group { numObjects 1\n";
    end += "}";
  }
  CHECK_EQUAL(parse(text + kSphere + end)->getSpan(), 2.0);
}

TEST("a scene may come from a pipe") {
  const std::string path = scenes::write("pipe", "");
  std::remove(path.c_str());
  CHECK_EQUAL(mkfifo(path.c_str(), 0600), 0);
  std::thread writer([&] { std::ofstream(path) << around(kSphere) << std::string(300'000, ' '); });
  const SceneParser scene(path.c_str());
  writer.join();
  std::remove(path.c_str());
  CHECK_EQUAL(scene.getSpan(), 2.0);
}

TEST("a thousand words in a million bytes are read, and so is a long line") {
  CHECK_EQUAL(
      parse(around(std::string(1'000'000, ' ') + kSphere + "#" + std::string(1'000'000, 'x')))
          ->getSpan(),
      2.0);
}
