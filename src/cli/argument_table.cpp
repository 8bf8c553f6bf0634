// The table of all arguments: a row for each, with its words, its help, and how it is entered in a
// request. The groups stand in the order of -help: from what every run needs to what few ask for.
#include <algorithm>
#include <iterator>
#include <limits>

#include "cli/arguments.h"

namespace {

using Words = const ArgumentWords&;
using Mode = ArgumentRow::Mode;
using Kind = OutputRequest::Kind;
using Pattern = SamplingOptions::Pattern;
using FilterKind = SamplingOptions::FilterKind;

constexpr const char* kReading = "Reading";
constexpr const char* kPictures = "Pictures";
constexpr const char* kTracing = "Tracing";
constexpr const char* kSampling = "Samples in a pixel";
constexpr const char* kShading = "Shadows and materials";
constexpr const char* kLarge = "Large pictures";
constexpr const char* kSpeed = "Speed";
constexpr const char* kComparing = "Comparing (a run of its own, without -input)";
constexpr const char* kInside = "Looking inside";
constexpr const char* kInformation = "Information";

RenderOptions& optionsOf(Draft& draft) { return draft.render.picture.render; }

/// Enters the output in place of one of the same kind, or where its kind stands in the order.
void want(Draft& draft, const OutputRequest& output) {
  std::vector<OutputRequest>& outputs = draft.render.results.outputs;
  const auto isBefore = [](const OutputRequest& a, const OutputRequest& b) {
    return a.kind < b.kind;
  };
  const auto at = std::lower_bound(outputs.begin(), outputs.end(), output, isBefore);
  if (at != outputs.end() && at->kind == output.kind) {
    *at = output;
  } else {
    outputs.insert(at, output);
  }
}

template <Kind kind>
void wantPicture(Words words, Draft& draft) {
  want(draft, {kind, words.file(0)});
}

template <Kind kind>
void wantEnlarged(Words words, Draft& draft) {
  const int zoom = words.integer(1, 1, kMaxImageSide);
  want(draft, {kind, words.file(0), 0, 0, zoom});
}

/// MIN MAX FILE, or FILE MIN MAX where the first word is no number.
void wantDepth(Words words, Draft& draft) {
  const std::size_t first = words.isNumber(0) ? 0 : 1;
  constexpr const char* kOrders = " (MIN MAX FILE, or FILE MIN MAX)";
  const double depthMin = words.anyNumber(first, std::string("MIN") + kOrders);
  const double depthMax = words.anyNumber(first + 1, std::string("MAX") + kOrders);
  if (depthMin == depthMax) words.fail(first, "MIN and MAX to differ");
  want(draft, {Kind::depth, words.file(first == 0 ? 2 : 0), depthMin, depthMax});
}

void setEpsilon(Words words, Draft& draft) {
  Epsilon& epsilon = optionsOf(draft).epsilon;
  epsilon = {Epsilon::Kind::fixed, Epsilon::kCourse};
  if (words[0] == "adaptive") {
    epsilon.kind = Epsilon::Kind::adaptive;
  } else if (words[0] != "course") {
    epsilon.value = words.atLeastZero<double>(0, ", course or adaptive");
  }
}

/// Of several patterns the last one counts.
template <Pattern pattern>
void setPattern(Words words, Draft& draft) {
  SamplingOptions& sampling = optionsOf(draft).sampling;
  sampling.samples = words.integer(0, 1, SamplingOptions::kMaxSamples);
  sampling.pattern = pattern;
}

void setAdaptive(Words words, Draft& draft) {
  SamplingOptions& sampling = optionsOf(draft).sampling;
  const int first = words.integer(0, 1, SamplingOptions::kMaxFirstSamples);
  sampling.maxSamples = words.integer(1, first, SamplingOptions::kMaxSamples);
  sampling.tolerance = words.number(2, 0, 1, "a number from 0 to 1 for TOLERANCE");
  sampling.samples = first;
  sampling.pattern = Pattern::adaptive;
}

/// Of several filters the last one counts. A gaussian reaches twice its sigma.
template <FilterKind filter>
void setFilter(Words words, Draft& draft) {
  constexpr int kMost = SamplingOptions::kMaxReach / (filter == FilterKind::gaussian ? 2 : 1);
  SamplingOptions& sampling = optionsOf(draft).sampling;
  sampling.filterSize =
      words.number(0, std::numeric_limits<double>::min(), kMost,
                   "a number of pixels above 0 and up to " + std::to_string(kMost));
  sampling.filter = filter;
}

void setRegion(Words words, Draft& draft) {
  constexpr int kMost = kMaxImageSide;
  draft.region = {words.integer(0, 0, kMost - 1), words.integer(1, 0, kMost - 1),
                  words.integer(2, 1, kMost), words.integer(3, 1, kMost)};
}

void setBand(Words words, Draft& draft) {
  const int count = words.integer(1, 1, kMaxImageSide);
  draft.band = {words.integer(0, 1, count), count};
}

void setMerge(Words words, Draft& draft) {
  for (std::size_t i = 0; i < words.all().size(); ++i) words.file(i);
  draft.merge.output = words[0];
  draft.merge.parts.assign(words.all().begin() + 1, words.all().end());
}

void setGrid(Words words, Draft& draft) {
  Acceleration& acceleration = draft.render.picture.acceleration;
  int cells = 1;  // stays below 2^30
  for (int axis = 0; axis < 3; ++axis) {
    acceleration.gridSize[axis] = words.integer(std::size_t(axis), 1, kMaxGridSide);
    cells *= acceleration.gridSize[axis];
  }
  if (cells > kMaxGridCells) {
    throw UsageError("-grid: expected at most " + std::to_string(kMaxGridCells) +
                     " cells in all, found " + std::to_string(cells));
  }
  acceleration.kind = Acceleration::Kind::grid;
}

template <Acceleration::CellPicture cells>
void drawCells(Words, Draft& draft) {
  draft.render.picture.acceleration.cellPicture = cells;
}

void setSimd(Words words, Draft& draft) {
  for (const SimdLevel level :
       {SimdLevel::automatic, SimdLevel::baseline, SimdLevel::avx2, SimdLevel::avx512}) {
    if (words[0] != nameOf(level)) continue;
    draft.render.picture.acceleration.simd = level;
    return;
  }
  words.fail(0, "auto, baseline, avx2 or avx512");
}

void setCompare(Words words, Draft& draft) {
  for (std::size_t i = 0; i < 2; ++i) {
    if (words[i].empty()) words.fail(i, "a file or folder");
  }
  draft.compare.expected = words[0];
  draft.compare.actual = words[1];
}

/// Of several texts the first in the order of ProgramText counts.
template <ProgramText text>
void wantText(Words, Draft& draft) {
  draft.text = std::min(draft.text, text);
}

void wantHelp(Words words, Draft& draft) {
  wantText<ProgramText::help>(words, draft);
  if (words.all().empty()) return;
  draft.topic = findTopic(words[0]);
  if (draft.topic) return;
  std::vector<std::string_view> names;
  for (const HelpTopic& topic : helpTopics()) names.push_back(topic.name);
  words.failChoice(0, WordList(names.data(), names.size()));
}

constexpr ArgumentRow kRows[] = {
    {kReading, "input", nullptr, "FILE", nullptr,
     "scene to read (needed but for -compare and -merge); - is standard input",
     [](Words words, Draft& draft) { draft.render.picture.scene = words.file(0); }},

    {kPictures, "output", nullptr, "FILE", nullptr, R"(
     image to write; the ending picks the format: .tga, .png, .ppm or .pfm, and TGA where it is
     missing or unknown; so it does for the other images; - is standard output, for one image of a
     run)",
     wantPicture<Kind::color>},
    {kPictures, "size", nullptr, "W H", "100 100", "image size, 1 to 65535 pixels each",
     [](Words words, Draft& draft) {
       draft.render.picture.width = words.integer(0, 1, kMaxImageSide);
       draft.render.picture.height = words.integer(1, 1, kMaxImageSide);
     }},
    {kPictures, "depth", nullptr, "MIN MAX FILE", nullptr, R"(
     write the depth image, white at distance MIN and black at MAX; FILE MIN MAX, where FILE does
     not look like a number, means the same)",
     wantDepth},
    {kPictures, "normals", "normal", "FILE", nullptr,
     "write the normal image: red, green, blue are |x|, |y|, |z| of the surface normal",
     wantPicture<Kind::normals>},
    {kPictures, "materials", nullptr, "FILE", nullptr,
     "write a picture with a colour for each material, and print which is which",
     wantPicture<Kind::materials>},
    {kPictures, "heatmap", nullptr, "FILE", nullptr,
     "write a picture of how many rays each pixel takes, and print its scale",
     wantPicture<Kind::heatmap>},

    {kTracing, "bounces", nullptr, "N", "5",
     "the most mirror or refracted rays in a row, 0 (none) to 10000",
     [](Words words, Draft& draft) {
       optionsOf(draft).maxBounces = words.integer(0, 0, kMaxBounces);
     }},
    {kTracing, "weight", nullptr, "W", "0.01", R"(
     mirror and refracted rays whose part in the pixel would be below W are not traced; W is at
     least 0)",
     [](Words words, Draft& draft) { optionsOf(draft).minWeight = words.atLeastZero<float>(0); }},
    {kTracing, "epsilon", nullptr, "E", nullptr, R"(
     how far from its origin a secondary or shadow ray starts looking: a number of at least 0;
     course, which is 0.001; or adaptive, from the size of the numbers at the hit (default: course
     where the bounded objects together span 1 to 1000 units, else adaptive))",
     setEpsilon, Mode::rendering, "course adaptive"},

    {kSampling, "random_samples", nullptr, "N", nullptr,
     "N rays at random places in each pixel, 1 to 65536", setPattern<Pattern::random>},
    {kSampling, "uniform_samples", nullptr, "N", nullptr,
     "N rays in each pixel, at the centres of a square grid; N is rounded up to a square",
     setPattern<Pattern::uniform>},
    {kSampling, "jittered_samples", nullptr, "N", nullptr,
     "N rays in each pixel, one at random in each cell of such a grid",
     setPattern<Pattern::jittered>},
    {kSampling, "adaptive_samples", nullptr, "MIN MAX TOLERANCE", nullptr, R"(
     MIN jittered rays in each pixel, 1 to 256, and up to MAX where colours differ by more than
     TOLERANCE, 0 to 1)",
     setAdaptive},
    {kSampling, "box_filter", nullptr, "R", "0.5", R"(
     a pixel is the mean of the samples up to R pixels to each side of its centre; R is above 0
     and up to 32)",
     setFilter<FilterKind::box>},
    {kSampling, "tent_filter", nullptr, "R", nullptr,
     "samples at distance d count 1 - d / R, up to R pixels away; R is up to 32",
     setFilter<FilterKind::tent>},
    {kSampling, "gaussian_filter", nullptr, "SIGMA", nullptr, R"(
     samples at distance d count exp(-d^2 / (2 SIGMA^2)), up to 2 SIGMA pixels away; SIGMA is up
     to 16)",
     setFilter<FilterKind::gaussian>},
    {kSampling, "render_samples", nullptr, "FILE ZOOM", nullptr,
     "write a picture of the samples, each a dot of its colour, ZOOM times as large as the image",
     wantEnlarged<Kind::samples>},
    {kSampling, "render_filter", nullptr, "FILE ZOOM", nullptr, R"(
     write a picture of the filter's weights for the middle pixel, ZOOM times as large as the
     image)",
     wantEnlarged<Kind::filter>},

    {kShading, "shadows", nullptr, "", "on", "cast shadow rays",
     [](Words, Draft& draft) { optionsOf(draft).shadows = true; }},
    {kShading, "no_shadows", nullptr, "", nullptr, "cast no shadow rays",
     [](Words, Draft& draft) { optionsOf(draft).shadows = false; }},
    {kShading, "transparent_shadows", nullptr, "", nullptr,
     "transparent objects tint and dim the light instead of blocking it",
     [](Words, Draft& draft) { optionsOf(draft).transparentShadows = true; }},
    {kShading, "shade_back", nullptr, "", nullptr, "light both sides of every surface",
     [](Words, Draft& draft) { optionsOf(draft).shadeBack = true; }},
    {kShading, "nested_dielectrics", nullptr, "", nullptr, R"(
     the index of refraction on either side follows from what a ray has entered and not left;
     where objects overlap, the larger priority of their materials holds)",
     [](Words, Draft& draft) { optionsOf(draft).nestedDielectrics = true; }},
    {kShading, "fresnel", nullptr, "", nullptr,
     "how much is reflected follows from index and angle; glass dims with the length inside",
     [](Words, Draft& draft) { optionsOf(draft).fresnel = true; }},

    {kLarge, "region", nullptr, "X Y W H", nullptr, R"(
     render W x H pixels only, of which the first is X from the left and Y from the top; the
     images are parts, for -merge)",
     setRegion},
    {kLarge, "tile", nullptr, "I N", nullptr, R"(
     render the I-th of N bands of rows only, counted from 1 at the top; N is at most the image's
     height)",
     setBand},
    {kLarge, "merge", nullptr, "OUT PART...", nullptr, R"(
     a run of its own, without -input: put an image together from all its parts, TGA files in any
     order)",
     setMerge, Mode::merging},
    {kLarge, "checkpoint", nullptr, "FILE", nullptr, R"(
     keep finished parts of the picture in FILE, from which the same command takes up after the
     program was ended; FILE is removed when the picture is done)",
     [](Words words, Draft& draft) { draft.run.checkpoint = words.plainFile(0); }},
    {kLarge, "memory_limit", nullptr, "MB", nullptr, R"(
     end the run with a message rather than take more than so many megabytes of memory (2^20 bytes
     each), 1 to 100000000 (default: no limit))",
     [](Words words, Draft& draft) {
       draft.run.memoryLimit = words.integer(0, 1, kMaxMemoryLimit);
     },
     Mode::any},

    {kSpeed, "threads", nullptr, "N", nullptr,
     "worker threads, 1 to 1024; the image never depends on it (default: all cores)",
     [](Words words, Draft& draft) { draft.run.threads = words.integer(0, 1, kMaxThreads); },
     Mode::any},
    {kSpeed, "accel", nullptr, "NAME", "fast", "fast, or tree: the plain object tree, for checking",
     [](Words words, Draft& draft) {
       const bool isFast = words.isFirstChoice(0, "fast", "tree");
       draft.render.picture.acceleration.kind =
           isFast ? Acceleration::Kind::fast : Acceleration::Kind::tree;
     },
     Mode::rendering, "fast tree"},
    {kSpeed, "grid", nullptr, "NX NY NZ", nullptr, R"(
     find hits through a uniform grid of so many cells, 1 to 1024 along each axis and at most
     16777216 in all, in place of -accel; the image never depends on it)",
     setGrid},
    {kSpeed, "simd", nullptr, "LEVEL", "auto", R"(
     instruction set: auto, baseline, avx2 or avx512; where the processor lacks it, the next best;
     the image never depends on it)",
     setSimd, Mode::rendering, "auto baseline avx2 avx512"},

    {kComparing, "compare", nullptr, "EXPECTED ACTUAL", nullptr, R"(
     tell how far two pictures are apart, or all those of two folders, or those of a folder and
     the ones that a table of commands gives)",
     setCompare, Mode::comparing},
    {kComparing, "tolerance", nullptr, "N", "1",
     "differences of up to N of 255 levels do not count",
     [](Words words, Draft& draft) { draft.compare.tolerance = words.integer(0, 0, 255); },
     Mode::comparing},
    {kComparing, "fail_percent", nullptr, "P", "0",
     "up to P percent of the pixels may differ by more",
     [](Words words, Draft& draft) {
       draft.compare.failPercent = words.number(0, 0, 100, "a number from 0 to 100");
     },
     Mode::comparing},
    {kComparing, "diff", nullptr, "FILE", nullptr,
     "write a picture of the differences of two pictures, 16 times as large",
     [](Words words, Draft& draft) { draft.compare.diff = words.file(0); }, Mode::comparing},
    {kComparing, "report", nullptr, "FILE", nullptr,
     "write an HTML page with all pictures, the worst first",
     [](Words words, Draft& draft) { draft.compare.report = words.file(0); }, Mode::comparing},
    {kComparing, "csv", nullptr, "FILE", nullptr,
     "add a row for each pair of pictures to a table of comma-separated values",
     [](Words words, Draft& draft) { draft.compare.csv = words.file(0); }, Mode::comparing},

    {kInside, "check", nullptr, "", nullptr,
     "render nothing: read the scene and its meshes and report every mistake",
     [](Words, Draft& draft) { draft.check = true; }},
    {kInside, "stats", nullptr, "", nullptr,
     "print what was used and how long it took, in lines of NAME: VALUE",
     [](Words, Draft& draft) { draft.render.results.stats = true; }},
    {kInside, "pixel", nullptr, "X Y", nullptr,
     "print all rays of one pixel, counted from the top left, and what becomes of them",
     [](Words words, Draft& draft) {
       draft.pixel = {words.integer(0, 0, kMaxImageSide - 1),
                      words.integer(1, 0, kMaxImageSide - 1)};
     }},
    {kInside, "pixel_obj", nullptr, "FILE", nullptr,
     "with -pixel: write the same rays as lines of an OBJ file", wantPicture<Kind::rays>},
    {kInside, "visualize_grid", nullptr, "", nullptr,
     "draw the cells of -grid that hold any object as white boxes",
     drawCells<Acceleration::CellPicture::occupied>},
    {kInside, "visualize_grid_count", nullptr, "", nullptr,
     "the same in colours, from white for one object in a cell to red for more than 32",
     drawCells<Acceleration::CellPicture::counts>},

    {kInformation, "progress", nullptr, "", nullptr,
     "tell on standard error how far the picture is, even where that is no terminal",
     [](Words, Draft& draft) { draft.run.progress = RunRequest::Progress::on; }},
    {kInformation, "preview", nullptr, "", nullptr, R"(
     show the picture on standard output, in coloured characters as large as the window; on a
     terminal from the first tile on)",
     [](Words, Draft& draft) { draft.render.results.preview = true; }},
    {kInformation, "quiet", nullptr, "", nullptr, "no warnings, no progress",
     [](Words, Draft& draft) {
       draft.run.quiet = true;
       draft.run.progress = RunRequest::Progress::off;
     },
     Mode::any},
    {kInformation, "help", "h", "[TOPIC]", nullptr,
     "print this list, or what is to be known of one of the topics at its end", wantHelp, Mode::any,
     "scene materials samples output inside grid parts checkpoint compare limits"},
    {kInformation, "version", nullptr, "", nullptr, "print the version",
     wantText<ProgramText::version>, Mode::any},
    {kInformation, "man", nullptr, "", nullptr, "print the manual page, to be read with man -l -",
     wantText<ProgramText::man>, Mode::any},
    {kInformation, "completion", nullptr, "", nullptr,
     "print a script for bash, which then completes arguments", wantText<ProgramText::completion>,
     Mode::any},
};

}  // namespace

const std::vector<ArgumentRow>& argumentTable() {
  static const std::vector<ArgumentRow> table(std::begin(kRows), std::end(kRows));
  return table;
}
