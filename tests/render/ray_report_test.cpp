// The tree of rays in words.
#include "render/ray_report.h"

#include "check.h"
#include "scene_text.h"

namespace {

/// The report on the ray from (0, 0, 5) along -z. In it "FILE" stands for the scene's file.
std::string reportOf(const std::string& text, const RenderOptions& options = {}) {
  const std::string path = scene_text::write(
      "PerspectiveCamera { center 0 0 5 direction 0 0 -1 up 0 1 0 angle 30 }\n" + text, ".txt");
  ObjectPlaces places;
  SceneParser scene(path.c_str(), &places);
  std::remove(path.c_str());
  scene.findSolids();
  std::string report;
  const RayTracer tracer(scene, *scene.getGroup(), options);
  const auto observer =
      makeRayReport(tracer, places, [&](const std::string& line) { report += line; });
  Ray ray({0, 0, 5}, {0, 0, -1});
  Hit hit;
  WatchedTracer(tracer, *observer).traceRay(ray, 0, 0, 1, 1, hit);
  for (std::size_t at; (at = report.find(path)) != std::string::npos;) {
    report.replace(at, path.size(), "FILE");
  }
  return report;
}

void contains(const std::string& text, const std::string& part) {
  const bool isThere = text.find(part) != std::string::npos;
  check::report(isThere, __FILE__, __LINE__, "'" + part + "' in\n" + text);
}

RenderOptions starting(double epsilon) {
  RenderOptions options;
  options.epsilon = {Epsilon::Kind::fixed, epsilon};
  return options;
}

const char* const kLightsAndMirror =
    "Lights { numLights 3 DirectionalLight { direction 0 0 -1 color 0.5 0.5 0.5 }\n"
    "                     PointLight { position 0 0 -9 color 1 1 1 }\n"
    "                     PointLight { position 0 0 4 color 1 1 1 } }\n"
    "Background { color 0.25 0.5 0.75 ambientLight 0.5 0.5 0.5 }\n"
    "Materials { numMaterials 2\n"
    "  PhongMaterial { diffuseColor 0.5 0.5 0.5 reflectiveColor 0.5 0.5 0.5 }\n"
    "  PhongMaterial { } }\n"
    "Group { numObjects 2 MaterialIndex 0 Plane { normal 0 0 1 offset 0 }\n"
    "  MaterialIndex 1 Transform { Translate 0 0 10\n"
    "    Sphere { center 0 0 0 radius 1 } } }\n";

}  // namespace

TEST("the report tells rays, hits, lights, what blocks them, and every term of the sum") {
  // Down to the plane z = 0, at t 5; back up to the ball at z = 10, which begins at z = 9. The sun
  // shines down on the ball; the lamp at z = -9 is behind the plane; that at z = 4 is between both.
  // The plane: 0.5 * 0.5 from ambient light, 1 * 0.5 from the lamp between. The ball is white:
  // 0.5 and 1. The mirror is as heavy as (0.5, 0.5, 0.5) is long, the root of 3/4.
  CHECK_EQUAL(reportOf(kLightsAndMirror, starting(0.25)),
              "eye ray, bounces 0, weight 1, index 1\n"
              "  origin 0 0 5\n"
              "  direction 0 0 -1, t above 0\n"
              "  hits Group 1 > Plane 1, FILE:9\n"
              "  t 5, point 0 0 0, normal 0 0 1\n"
              "  material 0, PhongMaterial\n"
              "  ambient term 0.25 0.25 0.25\n"
              "  light 0, DirectionalLight, direction 0 0 1, distance inf: in front, blocked by "
              "Group 1 > Transform 2 > Sphere, FILE:11, at t 9\n"
              "  light 1, PointLight, direction 0 0 -1, distance 9: behind the surface\n"
              "  light 2, PointLight, direction 0 0 1, distance 4: in front, nothing in the way\n"
              "    adds 0.5 0.5 0.5\n"
              "  lights term 0.5 0.5 0.5\n"
              "  mirror ray, bounces 1, weight 0.8660254, index 1\n"
              "    origin 0 0 0\n"
              "    direction 0 0 1, t above 0.25\n"
              "    factor 0.5 0.5 0.5\n"
              "    hits Group 1 > Transform 2 > Sphere, FILE:11\n"
              "    t 9, point 0 0 9, normal 0 0 -1\n"
              "    material 1, PhongMaterial\n"
              "    ambient term 0.5 0.5 0.5\n"
              "    light 0, DirectionalLight, direction 0 0 1, distance inf: behind the surface\n"
              "    light 1, PointLight, direction 0 0 -1, distance 18: in front, blocked by "
              "Group 1 > Plane 1, FILE:9, at t 9\n"
              "    light 2, PointLight, direction 0 0 -1, distance 5: in front, nothing in the "
              "way\n"
              "      adds 1 1 1\n"
              "    lights term 1 1 1\n"
              "    mirror term 0 0 0\n"
              "    transmitted term 0 0 0\n"
              "    color 1.5 1.5 1.5\n"
              "  mirror term 0.75 0.75 0.75\n"
              "  transmitted term 0 0 0\n"
              "  color 1.5 1.5 1.5\n");
}

TEST("the report tells why a branch is not followed") {
  RenderOptions options = starting(0.25);
  options.maxBounces = 0;
  contains(reportOf(kLightsAndMirror, options), "\n  no mirror ray: bounces 0 is the most\n");
  options.maxBounces = 5;
  options.minWeight = 0.875f;
  contains(reportOf(kLightsAndMirror, options),
           "\n  no mirror ray: weight 0.8660254 is below 0.875\n");
  // From inside water, through a slope of 45 degrees: sin 45 = 0.7 is above 1 / 1.5.
  contains(reportOf("Materials { numMaterials 1 PhongMaterial { transparentColor 1 1 1 "
                    "indexOfRefraction 1.5 } }\n"
                    "Group { numObjects 1 MaterialIndex 0 Plane { normal 0 1 -1 offset 0 } }\n"),
           "\n  no refracted ray: total internal reflection\n");
}

TEST("the report tells of the background, of shadows that are off, and of tinted ones") {
  contains(reportOf("Background { color 0.25 0.5 0.75 }\n"),
           "  hits nothing: background\n  color 0.25 0.5 0.75\n");
  RenderOptions options = starting(0.25);
  options.shadows = false;
  contains(reportOf(kLightsAndMirror, options),
           "light 0, DirectionalLight, direction 0 0 1, distance inf: in front, no shadow ray\n"
           "    adds 0.25 0.25 0.25\n");
  // An open pane of (0.5, 0.25, 0) above the eye, under the sun, and a black one above that: the
  // former tints, and of both the latter blocks.
  const std::string pane =
      "Lights { numLights 1 DirectionalLight { direction 0 0 -1 color 1 1 1 } }\n"
      "Materials { numMaterials 2 PhongMaterial { transparentColor 0.5 0.25 0 }\n"
      "  PhongMaterial { } }\n"
      "Group { numObjects 2 MaterialIndex 1 Plane { normal 0 0 1 offset 0 }\n"
      "  MaterialIndex 0 Plane { normal 0 0 1 offset 8 } }\n";
  RenderOptions tinting = starting(0.25);
  tinting.transparentShadows = true;
  contains(reportOf(pane, tinting), ": in front, tinted by 0.5 0.25 0\n    adds 0.5 0.25 0\n");
  contains(reportOf(pane + "Group { numObjects 1 MaterialIndex 1 Plane { normal 0 0 1 offset 9 } }",
                    tinting),
           ": in front, blocked by Group 2 > Plane 1, FILE:7, at t 9\n");
  contains(reportOf(pane, starting(0.25)),
           ": in front, blocked by Group 1 > Plane 2, FILE:6, at t 8\n");
}

TEST("the report tells of the parts of a texture, of media, of what is passed and what dims") {
  // 0.75 of the way up the first cube of a chessboard of 2: cube (0, 0, 0), even: the first part.
  contains(reportOf("Background { ambientLight 1 1 1 }\n"
                    "Materials { numMaterials 2 PhongMaterial { diffuseColor 0.5 0.5 0.5 }\n"
                    "  Checkerboard { materialIndex 0 materialIndex 0 size 2 } }\n"
                    "Group { numObjects 1 MaterialIndex 1 Plane { normal 0 0 1 offset 0.75 } }\n"),
           "  material 1, Checkerboard\n"
           "  part 1 of material 0, PhongMaterial\n"
           "    ambient term 0.5 0.5 0.5\n");
  // A ball of index 1.5 and priority 1 inside one of index 2 with priority 2, so it is not there:
  // into the large one at t 2, past the small one at 4 and 6, out at 8.
  RenderOptions options = starting(0.001);
  options.nestedDielectrics = options.fresnel = true;
  const std::string balls = reportOf(
      "Materials { numMaterials 2\n"
      "  PhongMaterial { transparentColor 0.5 0.5 0.5 indexOfRefraction 2 priority 2 }\n"
      "  PhongMaterial { transparentColor 1 1 1 indexOfRefraction 1.5 priority 1 } }\n"
      "Group { numObjects 2 MaterialIndex 0 Sphere { center 0 0 0 radius 3 }\n"
      "  MaterialIndex 1 Sphere { center 0 0 0 radius 1 } }\n",
      options);
  contains(balls,
           "  t 2, point 0 0 3, normal 0 0 1\n"
           "  material 0, PhongMaterial\n"
           "  index before 1, behind 2\n");
  contains(balls,
           "    passes Group 1 > Sphere 2, FILE:6, at t 2: the same medium on both sides\n"
           "    passes Group 1 > Sphere 2, FILE:6, at t 4: the same medium on both sides\n"
           "    hits Group 1 > Sphere 1, FILE:5\n"
           "    t 6, point 0 0 -3, normal 0 0 -1\n"
           "    material 0, PhongMaterial\n"
           "    index before 2, behind 1\n"
           "    dimmed on the way by 0.015625 0.015625 0.015625\n");  // 1 / 2^6
}

TEST("the report names a mesh's triangle, counted from 1") {
  const std::string mesh = scene_text::write(
      "v 8 8 0\nv 9 8 0\nv 8 9 0\nv -1 -1 0\nv 1 -1 0\nv 0 1 0\nf 1 2 3\nf 4 5 6\n", ".obj");
  contains(reportOf("Materials { numMaterials 1 PhongMaterial { } }\n"
                    "Group { numObjects 1 MaterialIndex 0\n" +
                    scene_text::mesh(mesh) + "}\n"),
           "  hits Group 1 > TriangleMesh 1, FILE:4, triangle 2\n");
  std::remove(mesh.c_str());
}

TEST("with blended glass the report tells the index that the ray carries") {
  // Into glass of index 1.5, and in it onto a ball whose outside would be air.
  RenderOptions options = starting(0.001);
  options.blendsGlass = true;
  const std::string report = reportOf(
      "Background { color 1 1 1 }\n"
      "Materials { numMaterials 2\n"
      "  Material { transparentColor 1 1 1 indexOfRefraction 1.5 }\n"
      "  Material { transparentColor 1 1 1 indexOfRefraction 2 } }\n"
      "Group { numObjects 2 MaterialIndex 0 Sphere { center 0 0 0 radius 2 }\n"
      "  MaterialIndex 1 Sphere { center 0 0 0 radius 1 } }\n",
      options);
  contains(report, "index before 1, behind 1.5");
  contains(report, "index before 1.5, behind 2");
}
