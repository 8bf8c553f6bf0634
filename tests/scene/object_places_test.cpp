// Where objects stand in their file.
#include "scene/object_places.h"

#include "check.h"
#include "geometry/transform.h"
#include "scene/scene_parser.h"
#include "scene_text.h"

namespace {

/// The scene reads the file once; afterwards it may go.
SceneParser parse(const std::string& path, ObjectPlaces* places) {
  return SceneParser(path.c_str(), places);
}

const char* const kScene =
    "PerspectiveCamera { center 0 0 5 direction 0 0 -1 up 0 1 0 angle 30 }\n"
    "# A comment.\n"
    "Materials { numMaterials 1 PhongMaterial { } }\n"
    "Group { numObjects 3 MaterialIndex 0\n"
    "  Sphere { center 0 0 0 radius 1 }  Plane { normal 0 1 0\n"
    "           offset 0 }\n"
    "  Transform { Translate 1 0 0\n"
    "    Group { numObjects 1\n"
    "      Triangle { vertex0 0 0 0 vertex1 1 0 0 vertex2 0 1 0 } } } }\n"
    "Group { numObjects 1 Transform { YRotate 3 Transform { XRotate 2\n"
    "  Sphere { center 0 0 0 radius 2 } } } }\n";

}  // namespace

TEST("each object is found on the line of its name, with the way to it from outside") {
  const std::string path = scene_text::write(kScene, ".txt");
  ObjectPlaces places;
  const SceneParser scene = parse(path, &places);
  std::remove(path.c_str());
  CHECK_EQUAL(places.file(), path);
  const auto group = [](const Object3D* object) {
    return dynamic_cast<const Group&>(*object).getObjects();
  };
  const auto inside = [](const Object3D* object) {
    return dynamic_cast<const Transform&>(*object).getObject();
  };
  const auto top = scene.getGroup()->getObjects();
  const auto first = group(top[0]);
  const Object3D* const inner = inside(first[2]);
  const Object3D* const triangle = group(inner)[0];
  const Object3D* const turned = group(top[1])[0];
  struct {
    const Object3D* object;
    std::size_t line;
    const char* path;
  } const expected[] = {
      {top[0], 4, "Group 1"},
      {first[0], 5, "Group 1 > Sphere 1"},
      {first[1], 5, "Group 1 > Plane 2"},
      {first[2], 7, "Group 1 > Transform 3"},
      {inner, 8, "Group 1 > Transform 3 > Group"},
      {triangle, 9, "Group 1 > Transform 3 > Group > Triangle 1"},
      {top[1], 10, "Group 2"},
      {inside(turned), 10, "Group 2 > Transform 1 > Transform"},
      {inside(inside(turned)), 11, "Group 2 > Transform 1 > Transform > Sphere"},
  };
  for (const auto& each : expected) {
    CHECK_EQUAL(places.lineOf(each.object), each.line);
    CHECK_EQUAL(places.pathOf(each.object), each.path);
  }
}

TEST("an object that is none of the scene's has no line and no path") {
  const std::string path = scene_text::write(kScene, ".txt");
  ObjectPlaces places;
  const SceneParser scene = parse(path, &places);
  std::remove(path.c_str());
  const Group other;
  CHECK_EQUAL(places.lineOf(&other), std::size_t(0));
  CHECK_EQUAL(places.pathOf(&other), "");
  CHECK_EQUAL(places.lineOf(scene.getGroup()), std::size_t(0));
  CHECK_EQUAL(ObjectPlaces().lineOf(&other), std::size_t(0));
}
