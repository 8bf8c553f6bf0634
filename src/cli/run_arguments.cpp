// The arguments about the run itself.
#include "cli/run_arguments.h"

#include "cli/option_values.h"

namespace {

using Given = const GivenOption&;

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

}  // namespace

std::vector<OptionRow> speedRows() {
  const char* group = "Speed";
  return {
      {group, "threads", nullptr, "N", nullptr,
       "worker threads, 1 to 1024; the image never depends on it (default: all cores)",
       [](Given given, Options& o) { o.threads = wholeNumber(given, 0, "N", 1, kMaxThreads); },
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

std::vector<OptionRow> insideRows() {
  const char* group = "Looking inside";
  return {
      {group, "check", nullptr, "", nullptr,
       "render nothing: read the scene and its meshes and report every mistake",
       [](Given, Options& o) { o.check = true; }},
      {group, "stats", nullptr, "", nullptr,
       "print what was used and how long it took, in lines of NAME: VALUE",
       [](Given, Options& o) { o.stats = true; }},
      {group, "pixel", nullptr, "X Y", nullptr,
       "print all rays of one pixel, counted from the top left, and what becomes of them",
       [](Given given, Options& o) {
         o.pixelX = wholeNumber(given, 0, "X", 0, kMaxImageSide - 1);
         o.pixelY = wholeNumber(given, 1, "Y", 0, kMaxImageSide - 1);
         o.tracesPixel = true;
       }},
      {group, "pixel_obj", nullptr, "FILE", nullptr,
       "with -pixel: write the same rays as lines of an OBJ file",
       [](Given given, Options& o) { o.pixelObjOutput = outputName(given); }},
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
