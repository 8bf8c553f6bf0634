// Options: what the command line asks for. Every argument works with one dash or two, in any
// order; where one is given twice, the last one wins.
#pragma once
#include <stdexcept>
#include <string>
#include <vector>

#include "accel/compiled_scene.h"
#include "accel/grid/grid_frame.h"
#include "cli/compare_options.h"
#include "cli/part_options.h"
#include "render/render_options.h"

/// A mistake in the command line: what() says what was expected and what was found.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Limits of the arguments; TGA stores a side of the image in 16 bits.
inline constexpr int kMaxImageSide = 65535;
inline constexpr int kMaxThreads = 1024;
inline constexpr int kMaxMemoryLimit = 100000000;  // MB

/// One argument as it was given: its name without dashes and the words that follow it.
struct GivenOption {
  std::string name;
  std::vector<std::string> words;
};

struct Options {
  enum class Accel {
    fast,  ///< whatever is quickest
    tree,  ///< the plain object tree, for checking
    grid   ///< a uniform grid of gridSize cells
  };
  /// Whether standard error tells how far the picture is.
  enum class Progress {
    automatic,  ///< where it is a terminal
    on,
    off
  };
  /// Cells of the grid drawn in place of the scene.
  enum class GridPicture {
    none,   ///< the scene itself
    cells,  ///< occupied cells in white
    counts  ///< in colours that tell how many objects they hold
  };

  std::string input;  ///< scene file; "-" is standard input
  /// Image file; "-" is standard output; empty = not wanted, as for the other files.
  std::string output;
  int width = 100;          ///< pixels, 1..kMaxImageSide
  int height = 100;         ///< pixels, 1..kMaxImageSide
  std::string depthOutput;  ///< depth image file
  double depthMin = 0;      ///< distance that is drawn white
  double depthMax = 0;      ///< distance that is drawn black; never equal to depthMin
  std::string normalsOutput;
  std::string samplesOutput;  ///< picture of the samples, samplesZoom times as large
  int samplesZoom = 1;        ///< samplesZoom * width and * height are at most kMaxImageSide
  std::string filterOutput;   ///< picture of the filter's weights, filterZoom times as large
  int filterZoom = 1;         ///< likewise, with 1 pixel more each way

  std::string materialsOutput;  ///< picture of the materials
  std::string heatmapOutput;    ///< picture of how many rays each pixel takes
  bool tracesPixel = false;     ///< print the rays of pixel (pixelX, pixelY)
  int pixelX = 0, pixelY = 0;   ///< from the top left, within width x height
  std::string pixelObjOutput;   ///< the same rays as lines; only with tracesPixel
  PartOptions part;             ///< what of the picture is rendered
  CompareOptions compare;       ///< a mode of its own: there is then no scene
  MergeOptions merge;           ///< likewise

  RenderOptions render;
  int threads = 0;      ///< worker threads, 1..kMaxThreads; 0 = one for each core
  int memoryLimit = 0;  ///< MB (2^20 bytes) that the run may take, 1..kMaxMemoryLimit; 0 = no limit
  Accel accel = Accel::fast;
  GridSize gridSize{1, 1, 1};                   ///< with Accel::grid; at most kMaxGridCells cells
  GridPicture gridPicture = GridPicture::none;  ///< anything else only with Accel::grid
  SimdLevel simd = SimdLevel::automatic;        ///< the best that is wanted

  std::string checkpoint;  ///< where finished parts are kept; empty = nowhere
  /// All arguments, each name once: the last of equal ones, in the order in which these came.
  std::vector<GivenOption> given;

  bool quiet = false;  ///< no warnings
  Progress progress = Progress::automatic;
  bool preview = false;    ///< show the picture on standard output
  bool stats = false;      ///< print what was used and how long it took
  bool check = false;      ///< read the scene, report every mistake, render nothing
  bool shortHelp = false;  ///< no argument at all was given
  bool help = false;
  bool version = false;
  bool man = false;         ///< print the manual page
  bool completion = false;  ///< print the script for bash

  /// Whether a text about the program is all that is wanted.
  bool wantsText() const { return shortHelp || help || version || man || completion; }
};

/// Reads the command line `words`, without the program's own name. Throws UsageError at the first
/// mistake. Unless help or the version is asked for, the result names a scene and something to do
/// with it, or two things to compare, or parts to merge; that no two files are the same is left to
/// checkFiles.
Options parseOptions(const std::vector<std::string>& words);

/// Throws UsageError where two outputs name the same file, or an output is the scene, one of
/// `meshFiles` or a part to merge, or standard output (by whatever name) where lines are printed
/// there. Links are followed; a device such as /dev/null may be named more than once.
void checkFiles(const Options& options, const std::vector<std::string>& meshFiles = {});
