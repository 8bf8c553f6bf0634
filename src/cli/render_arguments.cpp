// The arguments of every ordinary picture.
#include "cli/render_arguments.h"

#include "cli/option_values.h"

namespace {

using Given = const GivenOption&;

void setEpsilon(const GivenOption& given, Options& options) {
  Epsilon& epsilon = options.render.epsilon;
  epsilon.value = Epsilon::kCourse;
  if (given.words[0] == "adaptive") {
    epsilon.kind = Epsilon::Kind::adaptive;
    return;
  }
  epsilon.kind = Epsilon::Kind::fixed;
  if (given.words[0] == "course") return;
  epsilon.value = positiveNumber(given, ", course or adaptive");
}

}  // namespace

std::vector<OptionRow> readingRows() {
  const char* group = "Reading";
  return {
      {group, "input", nullptr, "FILE", nullptr,
       "scene to read (needed but for -compare and -merge); - is standard input",
       [](Given given, Options& o) { o.input = inputName(given); }},
  };
}

std::vector<OptionRow> pictureRows() {
  const char* group = "Pictures";
  return {
      {group, "output", nullptr, "FILE", nullptr,
       "image to write; the ending picks the format: .tga, .png, .ppm or .pfm, and TGA where it is "
       "missing or unknown; so it does for the other images; - is standard output, for one image "
       "of a run",
       [](Given given, Options& o) { o.output = outputName(given); }},
      {group, "size", nullptr, "W H", "100 100", "image size, 1 to 65535 pixels each",
       [](Given given, Options& o) {
         o.width = wholeNumber(given, 0, "W", 1, kMaxImageSide);
         o.height = wholeNumber(given, 1, "H", 1, kMaxImageSide);
       }},
      {group, "depth", nullptr, "MIN MAX FILE", nullptr,
       "write the depth image, white at distance MIN and black at MAX; FILE MIN MAX, where FILE "
       "does not look like a number, means the same",
       readDepth},
      {group, "normals", "normal", "FILE", nullptr,
       "write the normal image: red, green, blue are |x|, |y|, |z| of the surface normal",
       [](Given given, Options& o) { o.normalsOutput = outputName(given); }},
      {group, "materials", nullptr, "FILE", nullptr,
       "write a picture with a colour for each material, and print which is which",
       [](Given given, Options& o) { o.materialsOutput = outputName(given); }},
      {group, "heatmap", nullptr, "FILE", nullptr,
       "write a picture of how many rays each pixel takes, and print its scale",
       [](Given given, Options& o) { o.heatmapOutput = outputName(given); }},
  };
}

std::vector<OptionRow> tracingRows() {
  const char* group = "Tracing";
  return {
      {group, "bounces", nullptr, "N", "5",
       "the most mirror or refracted rays in a row, 0 (none) to 10000",
       [](Given given, Options& o) {
         o.render.maxBounces = wholeNumber(given, 0, "N", 0, kMaxBounces);
       }},
      {group, "weight", nullptr, "W", "0.01",
       "mirror and refracted rays whose part in the pixel would be below W are not traced; W is at "
       "least 0",
       [](Given given, Options& o) { o.render.minWeight = positiveFloat(given); }},
      {group, "epsilon", nullptr, "E", nullptr,
       "how far from its origin a secondary or shadow ray starts looking: a number of at least 0; "
       "course, which is 0.001; or adaptive, from the size of the numbers at the hit (default: "
       "course where the bounded objects together span 1 to 1000 units, else adaptive)",
       setEpsilon, OptionRow::Mode::rendering, "course adaptive"},
  };
}

std::vector<OptionRow> shadingRows() {
  const char* group = "Shadows and materials";
  return {
      {group, "shadows", nullptr, "", "on", "cast shadow rays",
       [](Given, Options& o) { o.render.shadows = true; }},
      {group, "no_shadows", nullptr, "", nullptr, "cast no shadow rays",
       [](Given, Options& o) { o.render.shadows = false; }},
      {group, "transparent_shadows", nullptr, "", nullptr,
       "transparent objects tint and dim the light instead of blocking it",
       [](Given, Options& o) { o.render.transparentShadows = true; }},
      {group, "shade_back", nullptr, "", nullptr, "light both sides of every surface",
       [](Given, Options& o) { o.render.shadeBack = true; }},
      {group, "nested_dielectrics", nullptr, "", nullptr,
       "the index of refraction on either side follows from what a ray has entered and not left; "
       "where objects overlap, the larger priority of their materials holds",
       [](Given, Options& o) { o.render.nestedDielectrics = true; }},
      {group, "fresnel", nullptr, "", nullptr,
       "how much is reflected follows from index and angle; glass dims with the length inside",
       [](Given, Options& o) { o.render.fresnel = true; }},
  };
}
