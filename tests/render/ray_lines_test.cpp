// Rays as lines of an OBJ file.
#include "check.h"
#include "render/pixel_trace.h"
#include "render/watched_tracer.h"
#include "scene_text.h"

namespace {

std::string objOf(const std::string& sceneText, const Ray& eyeRay, double tmin,
                  const RenderOptions& options) {
  const SceneParser scene = scene_text::parse(sceneText);
  const RayTracer tracer(scene, *scene.getGroup(), options);
  RayLines lines(tracer, 20);
  Ray ray = eyeRay;
  Hit hit;
  WatchedTracer(tracer, lines).traceRay(ray, float(tmin), 0, 1, 1, hit);
  return lines.obj();
}

/// A mirror at z = 0 under a lamp at z = 4, a lamp behind glass at z = 8, and the sun behind a
/// black wall at z = 10 that the lower ones do not reach.
const char* const kScene =
    "Lights { numLights 3 PointLight { position 0 0 4 color 1 1 1 }\n"
    "                     PointLight { position 0 0 8 color 1 1 1 }\n"
    "                     DirectionalLight { direction 0 0 -1 color 1 1 1 } }\n"
    "Materials { numMaterials 3 PhongMaterial { reflectiveColor 1 1 1 }\n"
    "  PhongMaterial { transparentColor 0.5 0.5 0.5 } PhongMaterial { } }\n"
    "Group { numObjects 3 MaterialIndex 0 Plane { normal 0 0 1 offset 0 }\n"
    "  MaterialIndex 1 Plane { normal 0 0 -1 offset -6 }\n"
    "  MaterialIndex 2 Plane { normal 0 0 1 offset 10 } }\n";

}  // namespace

TEST("rays are lines from where they begin to where they end, an object for each kind") {
  // The eye ray comes down from z = 5 to the mirror; with no bounce allowed nothing continues it.
  RenderOptions options;
  options.maxBounces = 0;
  options.transparentShadows = true;
  CHECK_EQUAL(objOf(kScene, Ray({0, 0, 5}, {0, 0, -1}), 0, options),
              "# Rays that meet nothing are drawn 20 long.\n"
              "o eye\n"
              "v 0 0 5 0.9 0.9 0.9\nv 0 0 0 0.9 0.9 0.9\nl 1 2\n"
              "o shadow_lit\n"
              "v 0 0 0 1 0.9 0.2\nv 0 0 4 1 0.9 0.2\nl 3 4\n"
              "o shadow_tinted\n"
              "v 0 0 0 1 0.5 0.1\nv 0 0 8 1 0.5 0.1\nl 5 6\n"
              "o shadow_blocked\n"
              "v 0 0 0 0.9 0.1 0.1\nv 0 0 10 0.9 0.1 0.1\nl 7 8\n");
}

TEST("a mirrored ray is drawn to what it meets; what meets nothing has the stated length") {
  RenderOptions options;
  options.shadows = false;
  const std::string mirrored = objOf(
      "Materials { numMaterials 1 PhongMaterial { reflectiveColor 1 1 1 } }\n"
      "Group { numObjects 1 MaterialIndex 0 Plane { normal 0 0 1 offset 0 } }\n",
      Ray({0, 0, 5}, {0, 0, -1}), 0, options);
  CHECK(mirrored.find("o mirror\nv 0 0 0 0.2 0.6 1\nv 0 0 20 0.2 0.6 1\nl 3 4\n") !=
        std::string::npos);
}

TEST("a ray that hits behind its origin is drawn from as far behind as the stated length") {
  // An orthographic camera at z = -5 looks along -z and sees the plane z = 0 behind it, at t -5.
  RenderOptions options;
  options.maxBounces = 0;
  options.shadows = false;
  CHECK_EQUAL(objOf(kScene, Ray({0, 0, -5}, {0, 0, -1}), -7, options),
              "# Rays that meet nothing are drawn 20 long.\n"
              "o eye\nv 0 0 20 0.9 0.9 0.9\nv 0 0 0 0.9 0.9 0.9\nl 1 2\n");
}
