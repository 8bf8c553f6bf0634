// Where the pixels of a picture lie on the camera's image plane, by the rules of all courses. There
// a side of the picture that the camera's angle or size spans goes from -0.5 to 0.5.
#include "render/false_colors.h"
#include "render/pixel_trace.h"
#include "render/sampling.h"
#include "vectors.h"

namespace {

using Unit = PixelPlaces::Unit;

const PixelPlaces kCropped, kStretched = {Unit::bothSides, 1, 0},
                            kCorners = {Unit::bothSides, 0, 0.5}, kByHeight = {Unit::height, 0, 0};

/// The place of the middle of a pixel.
Vec2d placeOf(const PixelPlaces& places, int width, int height, Pixel at) {
  const OrthographicCamera camera({0, 0, 0}, {0, 0, -1}, {0, 1, 0}, 1);
  return PictureView(camera, places, width, height).pointOf({at, {0.5, 0.5}});
}

void checkPlace(const Vec2d& place, double x, double y, int line) {
  const bool isThere = std::fabs(place.x() - x) < 1e-15 && std::fabs(place.y() - y) < 1e-15;
  check::report(isThere, __FILE__, line,
                "a place at " + check::show(place.x()) + ", " + check::show(place.y()));
}

/// Half of everything: what lies to the left of x = `edge`, in the light of a lamp at the eye.
SceneParser litLeftOf(double edge) {
  return sampling::parseWhole(
      "OrthographicCamera { center 0 0 9 direction 0 0 -1 up 0 1 0 size 2 }"
      "Lights { numLights 1 DirectionalLight { direction 0 0 -1 color 1 1 1 } }"
      "Background { color 0 0 0 } Materials { numMaterials 1 PhongMaterial { } }"
      "Group { numObjects 1 MaterialIndex 0 " +
      sampling::leftOf(edge) + "}");
}

}  // namespace

TEST("pixels lie at 2 (i + 1/2) / W - 1 along the longer side, square") {
  checkPlace(placeOf(kCropped, 4, 4, {0, 3}), -0.375, 0.375, __LINE__);  // -3/4 and 3/4, halved
  checkPlace(placeOf(kCropped, 5, 5, {2, 2}), 0, 0, __LINE__);
  checkPlace(placeOf(kCropped, 8, 4, {7, 0}), 3.5 / 8, -1.5 / 8, __LINE__);
  checkPlace(placeOf(kCropped, 2, 4, {0, 3}), -0.5 / 4, 1.5 / 4, __LINE__);
  checkPlace(placeOf(kCropped, 1, 1, {0, 0}), 0, 0, __LINE__);
}

TEST("where the outermost pixels lie on the borders, pixel i does at 2 i / (W - 1) - 1") {
  checkPlace(placeOf(kStretched, 4, 4, {0, 0}), -0.5, -0.5, __LINE__);
  checkPlace(placeOf(kStretched, 4, 4, {3, 3}), 0.5, 0.5, __LINE__);
  checkPlace(placeOf(kStretched, 4, 4, {1, 2}), -1.0 / 6, 1.0 / 6, __LINE__);  // -1/3 and 1/3
  checkPlace(placeOf(kStretched, 5, 5, {2, 1}), 0, -0.25, __LINE__);
  // Both sides whatever their lengths; one of a single pixel shows the middle.
  checkPlace(placeOf(kStretched, 9, 3, {8, 2}), 0.5, 0.5, __LINE__);
  checkPlace(placeOf(kStretched, 9, 3, {2, 1}), -0.25, 0, __LINE__);
  checkPlace(placeOf(kStretched, 3, 9, {1, 2}), 0, -0.25, __LINE__);
  checkPlace(placeOf(kStretched, 1, 3, {0, 2}), 0, 0.5, __LINE__);
  checkPlace(placeOf(kStretched, 1, 1, {0, 0}), 0, 0, __LINE__);
}

TEST("where pixels lie at their corners, pixel i does at 2 i / W - 1") {
  checkPlace(placeOf(kCorners, 4, 4, {0, 3}), -0.5, 0.25, __LINE__);
  checkPlace(placeOf(kCorners, 4, 4, {2, 2}), 0, 0, __LINE__);
  checkPlace(placeOf(kCorners, 5, 2, {4, 1}), 0.3, 0, __LINE__);
  checkPlace(placeOf(kCorners, 1, 1, {0, 0}), -0.5, -0.5, __LINE__);
}

TEST("by the height a wide picture shows more, and a tall one less, at its sides") {
  checkPlace(placeOf(kByHeight, 4, 2, {3, 1}), 0.75, 0.25, __LINE__);  // 3/2 and 1/2, halved
  checkPlace(placeOf(kByHeight, 2, 4, {1, 3}), 0.125, 0.375, __LINE__);
  checkPlace(placeOf(kByHeight, 5, 3, {2, 1}), 0, 0, __LINE__);
}

TEST("a sample lies as far from its pixel's middle as it does in the pixel") {
  const OrthographicCamera camera({0, 0, 0}, {0, 0, -1}, {0, 1, 0}, 1);
  // 2 (i + o - 1/2) / (W - 1) - 1, halved: (1 + 0.75 - 0.5) / 4 - 0.5, and 2 / (3 - 1) - 0.5.
  const PictureView stretched(camera, kStretched, 5, 3);
  checkPlace(stretched.pointOf({{1, 2}, {0.75, 0.5}}), -0.1875, 0.5, __LINE__);
  // 2 (i + o - 1/2) / W - 1, halved: (1 + 0.75 - 0.5) / 5 - 0.5, and (2 - 0.5) / 3 - 0.5.
  const PictureView corners(camera, kCorners, 5, 3);
  checkPlace(corners.pointOf({{1, 2}, {0.75, 0}}), -0.25, 0, __LINE__);
}

TEST("cells of a pixel lie where the pixels of a picture of three times the size would") {
  PixelPlaces places = kStretched;
  places.inset /= 3;
  const OrthographicCamera camera({0, 0, 0}, {0, 0, -1}, {0, 1, 0}, 1);
  const PictureView view(camera, places, 4, 1);
  for (int cell = 0; cell < 12; ++cell) {
    const double offset = (cell % 3 + 0.5) / 3;
    checkPlace(view.pointOf({{cell / 3, 0}, {offset, 0.5}}), cell / 11.0 - 0.5, 0, __LINE__);
  }
}

TEST("all that sends rays through pixels keeps to these places") {
  // Of 5 pixels the leftmost lies at -1, at -0.8, or at -1 again; the second at -0.5, -0.4, -0.6.
  const struct {
    PixelPlaces places;
    double edge;
    std::uint32_t covered;
  } cases[] = {{kCropped, -0.9, 0},    {kCropped, -0.45, 1}, {kStretched, -0.9, 1},
               {kStretched, -0.45, 2}, {kCorners, -0.55, 2}, {kCorners, -0.25, 2}};
  for (const auto& [places, edge, covered] : cases) {
    const SceneParser scene = litLeftOf(edge);
    RenderOptions options;
    options.places = places;
    const RayTracer tracer(scene, *scene.getGroup(), options);
    const Image picture = sampling::renderColor(scene, 5, 1, options);
    // What is hit asks for the lamp, by a second ray.
    const auto rays = countRays(tracer, 1, 5, 1);
    for (std::uint32_t i = 0; i < 5; ++i) {
      const bool isHit = i < covered;
      CHECK_EQUAL(picture.getPixel(int(i), 0) != Rgb8(), isHit);
      CHECK_EQUAL(rays[i], isHit ? 2u : 1u);
      RayLines lines(tracer, 1);
      const Vec3f color = tracePixel(tracer, {int(i), 0, 5, 1}, {&lines});
      CHECK_EQUAL(color != Vec3f(), isHit);
      CHECK_EQUAL(lines.obj().find("shadow_lit") != std::string::npos, isHit);
    }
  }
}
