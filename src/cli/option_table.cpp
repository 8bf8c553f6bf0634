// The table of all arguments.
#include "cli/option_table.h"

#include "cli/compare_arguments.h"
#include "cli/option_values.h"
#include "cli/sampling_arguments.h"
#include "scene/wording.h"

namespace {

void setAccel(const GivenOption& given, Options& options) {
  static constexpr std::string_view kNames[] = {"fast", "tree"};
  const std::string& word = given.words[0];
  if (!WordList(kNames).contains(word)) failChoice(given, kNames);
  options.accel = word == "fast" ? Options::Accel::fast : Options::Accel::tree;
}

void setGrid(const GivenOption& given, Options& options) {
  static constexpr const char* kNames[] = {"NX", "NY", "NZ"};
  int cells = 1;  // stays below 2^30
  for (int axis = 0; axis < 3; ++axis) {
    options.gridSize[axis] = wholeNumber(given, std::size_t(axis), kNames[axis], 1, kMaxGridSide);
    cells *= options.gridSize[axis];
  }
  if (cells > kMaxGridCells) {
    throw UsageError("-grid: expected at most " + std::to_string(kMaxGridCells) +
                     " cells in all, found " + std::to_string(cells));
  }
  options.accel = Options::Accel::grid;
}

void setSimd(const GivenOption& given, Options& options) {
  for (const SimdLevel level :
       {SimdLevel::automatic, SimdLevel::baseline, SimdLevel::avx2, SimdLevel::avx512}) {
    if (given.words[0] != nameOf(level)) continue;
    options.simd = level;
    return;
  }
  throw UsageError("-simd: expected auto, baseline, avx2 or avx512, found " +
                   ::quoted(given.words[0]));
}

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

using Given = const GivenOption&;

std::vector<OptionRow> readingRows() {
  const char* group = "Reading";
  return {
      {group, "input", nullptr, "FILE", nullptr,
       "scene to read (needed but for -compare); - is standard input",
       [](Given given, Options& o) { o.input = inputName(given); }},
  };
}

std::vector<OptionRow> pictureRows() {
  const char* group = "Pictures";
  return {
      {group, "output", nullptr, "FILE", nullptr,
       "image to write; the ending picks the format: .tga, .png, .ppm or .pfm, and TGA where it is "
       "missing or unknown; so it does for the other images; - is standard output, for one image "
       "of "
       "a run",
       [](Given given, Options& o) { o.output = outputName(given); }},
      {group, "size", nullptr, "W H", "100 100", "image size, 1 to 65535 pixels each",
       [](Given given, Options& o) {
         o.width = wholeNumber(given, 0, "W", 1, kMaxImageSide);
         o.height = wholeNumber(given, 1, "H", 1, kMaxImageSide);
       }},
      {group, "checkpoint", nullptr, "FILE", nullptr,
       "keep finished parts of the picture in FILE, from which the same command takes up after the "
       "program was ended; FILE is removed when the picture is done",
       [](Given given, Options& o) { o.checkpoint = plainFileName(given); }},
      {group, "depth", nullptr, "MIN MAX FILE", nullptr,
       "write the depth image, white at distance MIN and black at MAX; FILE MIN MAX, where FILE "
       "does not look like a number, means the same",
       readDepth},
      {group, "normals", "normal", "FILE", nullptr,
       "write the normal image: red, green, blue are |x|, |y|, |z| of the surface normal",
       [](Given given, Options& o) { o.normalsOutput = outputName(given); }},
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

std::vector<OptionRow> speedRows() {
  const char* group = "Speed";
  return {
      {group, "threads", nullptr, "N", nullptr,
       "worker threads, 1 to 1024; the image never depends on it (default: all cores)",
       [](Given given, Options& o) { o.threads = wholeNumber(given, 0, "N", 1, kMaxThreads); },
       OptionRow::Mode::both},
      {group, "memory_limit", nullptr, "MB", nullptr,
       "end the run with a message rather than take more than so many megabytes of memory (2^20 "
       "bytes each), 1 to 100000000 (default: no limit)",
       [](Given given, Options& o) {
         o.memoryLimit = wholeNumber(given, 0, "MB", 1, kMaxMemoryLimit);
       },
       OptionRow::Mode::both},
      {group, "accel", nullptr, "NAME", "fast",
       "fast, or tree: the plain object tree, for checking", setAccel, OptionRow::Mode::rendering,
       "fast tree"},
      {group, "grid", nullptr, "NX NY NZ", nullptr,
       "find hits through a uniform grid of so many cells, 1 to 1024 along each axis and at most "
       "16777216 in all, in place of -accel; the image never depends on it",
       setGrid},
      {group, "simd", nullptr, "LEVEL", "auto",
       "instruction set: auto, baseline, avx2 or avx512; where the processor lacks it, the next "
       "best; the image never depends on it",
       setSimd, OptionRow::Mode::rendering, "auto baseline avx2 avx512"},
  };
}

std::vector<OptionRow> checkingRows() {
  const char* group = "Checking";
  return {
      {group, "check", nullptr, "", nullptr,
       "render nothing: read the scene and its meshes and report every mistake",
       [](Given, Options& o) { o.check = true; }},
      {group, "stats", nullptr, "", nullptr,
       "print what was used and how long it took, in lines of NAME: VALUE",
       [](Given, Options& o) { o.stats = true; }},
      {group, "visualize_grid", nullptr, "", nullptr,
       "draw the cells of -grid that hold any object as white boxes",
       [](Given, Options& o) { o.gridPicture = Options::GridPicture::cells; }},
      {group, "visualize_grid_count", nullptr, "", nullptr,
       "the same in colours, from white for one object in a cell to red for more than 32",
       [](Given, Options& o) { o.gridPicture = Options::GridPicture::counts; }},
  };
}

std::vector<OptionRow> informationRows() {
  const char* group = "Information";
  return {
      {group, "progress", nullptr, "", nullptr,
       "tell on standard error how far the picture is, even where that is no terminal",
       [](Given, Options& o) { o.progress = Options::Progress::on; }},
      {group, "preview", nullptr, "", nullptr,
       "show the picture on standard output, in coloured characters as large as the window; on a "
       "terminal from the first tile on",
       [](Given, Options& o) { o.preview = true; }},
      {group, "quiet", nullptr, "", nullptr, "no warnings, no progress",
       [](Given, Options& o) {
         o.quiet = true;
         o.progress = Options::Progress::off;
       },
       OptionRow::Mode::both},
      {group, "help", "h", "", nullptr, "print this list", [](Given, Options& o) { o.help = true; },
       OptionRow::Mode::both},
      {group, "version", nullptr, "", nullptr, "print the version",
       [](Given, Options& o) { o.version = true; }, OptionRow::Mode::both},
      {group, "man", nullptr, "", nullptr, "print the manual page, to be read with man -l -",
       [](Given, Options& o) { o.man = true; }, OptionRow::Mode::both},
      {group, "completion", nullptr, "", nullptr,
       "print a script for bash, which then completes arguments",
       [](Given, Options& o) { o.completion = true; }, OptionRow::Mode::both},
  };
}

/// The groups in the order of -help: from what every run needs to what few ask for.
std::vector<OptionRow> makeTable() {
  std::vector<OptionRow> table;
  for (const auto& rows : {
           readingRows(),
           pictureRows(),
           tracingRows(),
           samplingRows(),
           shadingRows(),
           speedRows(),
           compareRows(),
           checkingRows(),
           informationRows(),
       })
    table.insert(table.end(), rows.begin(), rows.end());
  return table;
}

}  // namespace

const std::vector<OptionRow>& optionTable() {
  static const std::vector<OptionRow> table = makeTable();
  return table;
}

const OptionRow* findOption(const std::string& name) {
  for (const OptionRow& row : optionTable())
    if (name == row.name || (row.otherName && name == row.otherName)) return &row;
  return nullptr;
}

int countWords(const OptionRow& row) {
  if (!*row.words) return 0;
  int count = 1;
  for (const char* c = row.words; *c; ++c) count += *c == ' ';
  return count;
}
