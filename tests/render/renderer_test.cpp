// The renderer: where the pixels' rays go, the three kinds of picture, and threads.
#include "render/renderer.h"

#include "scene_text.h"
#include "vectors.h"

static std::ostream& operator<<(std::ostream& out, Rgb8 value) {
  return out << int(value.r) << ' ' << int(value.g) << ' ' << int(value.b);
}

namespace {

/// A scene without the camera that scene_text::parse brings.
SceneParser parseWhole(const std::string& text) {
  const std::string path = scene_text::write(text, ".txt");
  struct Remover {
    const std::string& path;
    ~Remover() { std::remove(path.c_str()); }
  } remover{path};
  return SceneParser(path.c_str());
}

/// White shapes on black before an orthographic camera that shows `size` units.
SceneParser whiteShapes(double size, int count, const std::string& shapes) {
  return parseWhole("OrthographicCamera { center 0 0 9 direction 0 0 -1 up 0 1 0 size" +
                    scene_text::word(size) +
                    "} Background { color 0 0 0 } Materials { numMaterials 1 PhongMaterial { } }"
                    "Group { numObjects " +
                    std::to_string(count) + " MaterialIndex 0 " + shapes + "}");
}

Image renderColor(const SceneParser& scene, int width, int height, int threads = 1) {
  Image image(width, height);
  RenderTargets targets;
  targets.color = &image;
  render(RayTracer(scene, *scene.getGroup(), RenderOptions()), threads, targets);
  return image;
}

/// The pixels that are not black, as "x,y" each.
std::string litPixels(const Image& image) {
  std::string list;
  for (int y = 0; y < image.Height(); ++y)
    for (int x = 0; x < image.Width(); ++x)
      if (image.getPixel(x, y) != Rgb8()) list += std::to_string(x) + "," + std::to_string(y) + " ";
  return list;
}

std::string ballAt(double x, double y) {
  return "Sphere { center" + scene_text::word(Vec3d(x, y, 0)) + "radius 0.001 }";
}

bool isSame(const Image& a, const Image& b) {
  if (a.Width() != b.Width() || a.Height() != b.Height()) return false;
  for (int y = 0; y < a.Height(); ++y)
    for (int x = 0; x < a.Width(); ++x)
      if (a.getPixel(x, y) != b.getPixel(x, y)) return false;
  return true;
}

}  // namespace

TEST("pixels are sampled at their centres, and y counts upwards") {
  // 4 x 4 pixels of 1 unit over [-2, 2]: pixel (3, 0) has its centre at (1.5, -1.5).
  const SceneParser corner = whiteShapes(4, 1, ballAt(1.5, -1.5));
  CHECK_EQUAL(litPixels(renderColor(corner, 4, 4)), "3,0 ");
  const SceneParser beside = whiteShapes(4, 1, ballAt(1.45, -1.5));
  CHECK_EQUAL(litPixels(renderColor(beside, 4, 4)), "");
  // Pixel (1, 2) of 5 x 5 over [-2.5, 2.5]: (-1, 0).
  const SceneParser odd = whiteShapes(5, 1, ballAt(-1, 0));
  CHECK_EQUAL(litPixels(renderColor(odd, 5, 5)), "1,2 ");
}

TEST("a wide image crops top and bottom") {
  // 8 x 4 over [-4, 4] x [-2, 2]: corners at (-3.5, 1.5) and (3.5, -1.5); (0.5, 2.5) is outside.
  const SceneParser scene =
      whiteShapes(8, 3, ballAt(-3.5, 1.5) + ballAt(3.5, -1.5) + ballAt(0.5, 2.5));
  CHECK_EQUAL(litPixels(renderColor(scene, 8, 4)), "7,0 0,3 ");
}

TEST("a tall image crops left and right") {
  const SceneParser scene =
      whiteShapes(8, 3, ballAt(-1.5, 3.5) + ballAt(1.5, -3.5) + ballAt(2.5, 0.5));
  CHECK_EQUAL(litPixels(renderColor(scene, 4, 8)), "3,0 0,7 ");
}

TEST("a perspective camera's angle spans the longer side") {
  // 90 degrees at distance 4: [-4, 4] across 8 pixels; 2 high.
  const SceneParser scene = parseWhole(
      "PerspectiveCamera { center 0 0 4 direction 0 0 -1 up 0 1 0 angle 90 }"
      "Background { color 0 0 0 } Materials { numMaterials 1 PhongMaterial { } }"
      "Group { numObjects 2 MaterialIndex 0 " +
      ballAt(3.5, 0.5) + ballAt(-2.5, -0.5) + "}");
  CHECK_EQUAL(litPixels(renderColor(scene, 8, 2)), "1,0 7,1 ");
}

TEST("a single pixel looks along the camera's direction") {
  const SceneParser scene = whiteShapes(4, 1, ballAt(0, 0));
  CHECK_EQUAL(litPixels(renderColor(scene, 1, 1)), "0,0 ");
}

TEST("an orthographic camera sees what lies behind it, a perspective one does not") {
  const std::string behind = "Sphere { center 0 0 50 radius 1 }";
  CHECK_EQUAL(litPixels(renderColor(whiteShapes(1, 1, behind), 1, 1)), "0,0 ");
  const SceneParser perspective = parseWhole(
      "PerspectiveCamera { center 0 0 9 direction 0 0 -1 up 0 1 0 angle 30 }"
      "Background { color 0 0 0 } Materials { numMaterials 1 PhongMaterial { } }"
      "Group { numObjects 1 MaterialIndex 0 " +
      behind + "}");
  CHECK_EQUAL(litPixels(renderColor(perspective, 1, 1)), "");
}

TEST("bytes are truncated, clamped and in the order red, green, blue") {
  const SceneParser scene = parseWhole(
      "OrthographicCamera { center 0 0 9 direction 0 0 -1 up 0 1 0 size 1 }"
      "Background { color 0.999 2 -1 } Materials { numMaterials 1 PhongMaterial { } }"
      "Group { numObjects 1 MaterialIndex 0 Sphere { center 9 9 9 radius 1 } }");
  CHECK_EQUAL(renderColor(scene, 1, 1).getPixel(0, 0), (Rgb8{254, 255, 0}));  // 254.7 is cut
}

TEST("depth is white at MIN, black at MAX, truncated between, black on a miss") {
  // Tops at z = 8, 4, 0.5, -1 and -2 seen from z = 9: t = 1, 5, 8.5, 10 and 11.
  const SceneParser scene = whiteShapes(
      6, 5,
      "Sphere { center -2.5 0 7.75 radius 0.25 } Sphere { center -1.5 0 3.75 radius 0.25 }"
      "Sphere { center -0.5 0 0.25 radius 0.25 } Sphere { center 0.5 0 -1.25 radius 0.25 }"
      "Sphere { center 1.5 0 -2.25 radius 0.25 }");
  Image depth(6, 1);
  RenderTargets targets;
  targets.depth = &depth;
  targets.depthMin = 2;
  targets.depthMax = 10;
  render(RayTracer(scene, *scene.getGroup(), RenderOptions()), 1, targets);
  // (10 - t) / 8 x 255: above 255, 159.4, 47.8, 0, below 0, none.
  const int expected[6] = {255, 159, 47, 0, 0, 0};
  for (int x = 0; x < 6; ++x) {
    const auto grey = std::uint8_t(expected[x]);
    CHECK_EQUAL(depth.getPixel(x, 0), (Rgb8{grey, grey, grey}));
  }
}

TEST("depth with MIN beyond MAX is turned round") {
  const SceneParser scene = whiteShapes(4, 1, "Sphere { center -1 0 3 radius 1 }");  // t = 5
  Image depth(2, 1);
  RenderTargets targets;
  targets.depth = &depth;
  targets.depthMin = 9;
  targets.depthMax = 4;
  render(RayTracer(scene, *scene.getGroup(), RenderOptions()), 1, targets);
  // (4 - 5) / (4 - 9) = 0.2: 51 less rounding.
  CHECK_NEAR(depth.getPixel(0, 0).r, 51, 1);
  CHECK_EQUAL(depth.getPixel(1, 0), Rgb8());  // a miss is black all the same
}

TEST("depth counts along the unit ray, not along the camera's axis") {
  // The right pixel of 2 x 1 looks along (0.25 x 2 tan 45, 0, -1): the wall 4 away is met at
  // t = 4 sqrt(1.25) = 4.4721, (8 - t) / 8 x 255 = 112.45.
  const SceneParser scene = parseWhole(
      "PerspectiveCamera { center 0 0 4 direction 0 0 -5 up 0 1 0 angle 90 }"
      "Materials { numMaterials 1 PhongMaterial { } }"
      "Group { numObjects 1 MaterialIndex 0 Plane { normal 0 0 1 offset 0 } }");
  Image depth(2, 1);
  RenderTargets targets;
  targets.depth = &depth;
  targets.depthMin = 0;
  targets.depthMax = 8;
  render(RayTracer(scene, *scene.getGroup(), RenderOptions()), 1, targets);
  CHECK_EQUAL(int(depth.getPixel(1, 0).r), 112);
  CHECK_EQUAL(int(depth.getPixel(0, 0).r), 112);
}

TEST("the normal image holds absolute components in world space, black on a miss") {
  // A sphere hit at height 0.6 has the normal (0, 0.6, 0.8); the plane is turned by its Transform.
  const SceneParser sphere = whiteShapes(2, 1, "Sphere { center 0.5 -0.6 0 radius 1 }");
  Image normals(2, 1);
  RenderTargets targets;
  targets.normals = &normals;
  render(RayTracer(sphere, *sphere.getGroup(), RenderOptions()), 1, targets);
  CHECK_EQUAL(normals.getPixel(1, 0), (Rgb8{0, 153, 204}));  // 0.6 x 255 and 0.8 x 255
  const SceneParser plane = whiteShapes(
      2, 1, "Transform { XRotate 180 YRotate 53.13010235415598 Plane { normal 0 0 1 offset 0 } }");
  Image turned(2, 1);
  targets.normals = &turned;
  render(RayTracer(plane, *plane.getGroup(), RenderOptions()), 1, targets);
  CHECK_NEAR(turned.getPixel(0, 0).r, 204, 1);  // sin 53.13 = 0.8, and its sign is dropped
  CHECK_NEAR(turned.getPixel(0, 0).b, 153, 1);
  const SceneParser nothing = whiteShapes(2, 1, ballAt(50, 50));
  Image missed(2, 1);
  missed.setAllPixels({1, 1, 1});
  targets.normals = &missed;
  render(RayTracer(nothing, *nothing.getGroup(), RenderOptions()), 1, targets);
  CHECK_EQUAL(missed.getPixel(0, 0), Rgb8());
}

TEST("signed normals are (n + 1) / 2, and 1/2 on a miss") {
  const SceneParser sphere = whiteShapes(4, 1, "Sphere { center 1 0.28 0 radius 1 }");
  Image normals(2, 1);
  FloatImage exact(2, 1);
  RenderTargets targets;
  targets.normals = &normals;
  targets.exactNormals = &exact;
  targets.hasSignedNormals = true;
  // The sphere is hit at height -0.28, where its normal is (0, -0.28, 0.96).
  render(RayTracer(sphere, *sphere.getGroup(), RenderOptions()), 1, targets);
  CHECK_EQUAL(normals.getPixel(1, 0), (Rgb8{127, 91, 249}));  // 0.36 and 0.98
  CHECK_EQUAL(normals.getPixel(0, 0), (Rgb8{127, 127, 127}));
  CHECK_EQUAL(exact.getPixel(0, 0), Vec3f(0.5f, 0.5f, 0.5f));
}

TEST("three pictures in one run are those of three runs, for any number of threads") {
  const SceneParser scene = parseWhole(
      "PerspectiveCamera { center 0 1 6 direction 0 -0.1 -1 up 0 1 0 angle 40 }"
      "Lights { numLights 1 PointLight { position 3 5 4 color 1 1 1 } }"
      "Background { color 0.2 0.3 0.5 ambientLight 0.1 0.1 0.1 }"
      "Materials { numMaterials 2 PhongMaterial { reflectiveColor 0.5 0.5 0.5 }"
      "  PhongMaterial { transparentColor 0.8 0.8 0.8 indexOfRefraction 1.5 } }"
      "Group { numObjects 3 MaterialIndex 0 Plane { normal 0 1 0 offset -1 }"
      "  Sphere { center 1 0 0 radius 1 } MaterialIndex 1 Sphere { center -1 0 1 radius 1 } }");
  const int width = 117, height = 83;  // no multiple of any tile
  Image color(width, height), depth(width, height), normals(width, height);
  RenderTargets all;
  all.color = &color;
  all.depth = &depth;
  all.normals = &normals;
  all.depthMin = 4;
  all.depthMax = 9;
  render(RayTracer(scene, *scene.getGroup(), RenderOptions()), 1, all);
  CHECK(isSame(color, renderColor(scene, width, height)));
  for (int threads : {2, 3, 16}) {
    Image oneColor(width, height), oneDepth(width, height), oneNormals(width, height);
    RenderTargets alone[3] = {all, all, all};
    alone[0].color = &oneColor;
    alone[0].depth = alone[0].normals = alone[1].color = alone[1].normals = nullptr;
    alone[1].depth = &oneDepth;
    alone[2].normals = &oneNormals;
    alone[2].color = alone[2].depth = nullptr;
    for (const RenderTargets& targets : alone)
      render(RayTracer(scene, *scene.getGroup(), RenderOptions()), threads, targets);
    CHECK(isSame(oneColor, color));
    CHECK(isSame(oneDepth, depth));
    CHECK(isSame(oneNormals, normals));
  }
}

TEST("more threads than pixels are no harm") {
  const SceneParser scene = whiteShapes(4, 1, ballAt(1.5, -1.5));
  CHECK_EQUAL(litPixels(renderColor(scene, 4, 4, 64)), "3,0 ");
}
