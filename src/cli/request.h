// Request: what a command line asks for, in the pieces that the runs of the program take. What
// follows from several arguments together (the area that is rendered, the number of threads) is
// worked out once, by parseRequest, and kept here.
//
// Every argument works with one dash or two, in any order; where one is given twice, the last one
// wins.
#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "accel/grid/grid_frame.h"
#include "cli/course.h"
#include "cli/program.h"
#include "math/simd_level.h"
#include "render/image_plane.h"
#include "render/render_options.h"
#include "scene/scene_parser.h"

/// Limits of the arguments; TGA stores a side of the image in 16 bits.
inline constexpr int kMaxImageSide = SceneParser::kMostPixels;
inline constexpr int kMaxThreads = 1024;
inline constexpr int kMaxMemoryLimit = 100000000;  // MB

/// The first kinds of acceleration, as -accel has them; -grid asks for the last.
inline constexpr std::string_view kAcceleratorNames[] = {"fast", "tree"};

/// What finds the hits of rays. Never changes a pixel, unless cells are drawn.
struct Acceleration {
  enum class Kind {
    fast,  ///< whatever is quickest
    tree,  ///< the plain object tree, for checking
    grid   ///< a uniform grid of gridSize cells
  };
  /// Cells of the grid drawn in place of the scene.
  enum class CellPicture {
    none,      ///< the scene itself
    occupied,  ///< cells that hold any object, in white
    counts     ///< in colours that tell how many objects they hold
  };
  Kind kind = Kind::fast;
  GridSize gridSize{1, 1, 1};                   ///< of Kind::grid; at most kMaxGridCells cells
  CellPicture cellPicture = CellPicture::none;  ///< anything else only with Kind::grid
  SimdLevel simd = SimdLevel::automatic;        ///< the best that is wanted
};

/// What is rendered.
struct PictureRequest {
  std::string scene;              ///< scene file; "-" is standard input
  int width = 100, height = 100;  ///< of the whole picture, in pixels, 1..kMaxImageSide
  /// The pixels that are rendered, within the picture, counted from its lower left corner.
  PixelRectangle area{0, 0, 100, 100};
  bool isPart = false;  ///< -region or -tile: `area` is rendered as a part, for -merge
  const Course* course = &courseAt(0);  ///< not owned
  RenderOptions render;                 ///< the course's, as arguments change them
  SceneRules rules;                     ///< likewise
  std::vector<std::string> notes;       ///< on arguments that were accepted and do nothing
  Acceleration acceleration;

  /// "640 x 480 pixels", of the whole picture.
  std::string sizeText() const { return ::sizeText(width, height) + " pixels"; }
};

/// A file that rendering writes.
struct OutputRequest {
  enum class Kind {
    color,
    depth,
    normals,
    samples,    ///< where the samples lie, `zoom` times as large as the picture
    filter,     ///< the filter's weights, `zoom` times as large and 1 pixel more each way
    materials,  ///< a colour for each material
    heatmap,    ///< how many rays each pixel takes
    rays        ///< the rays of ResultRequest::pixel, as lines of an OBJ file
  };
  Kind kind = Kind::color;
  std::string file;     ///< "-" is standard output
  double depthMin = 0;  ///< of `depth`: the distance that is drawn white, or, by Course, black
  double depthMax = 0;  ///< likewise black, or white; never equal to depthMin
  int zoom = 1;  ///< of `samples` and `filter`: their pictures' sides are at most kMaxImageSide
  std::string argument{};  ///< that asks for it, with its dash
};

/// The one of this kind among some outputs, requested or made; null where there is none.
template <class Outputs>
auto findOutput(Outputs& outputs, OutputRequest::Kind kind) -> decltype(outputs.data()) {
  for (auto& output : outputs) {
    if (output.kind == kind) return &output;
  }
  return nullptr;
}

/// A pixel as users count: from the picture's top left corner, (0, 0).
struct PictureSpot {
  int x = 0, y = 0;
};

/// What becomes of the picture.
struct ResultRequest {
  std::vector<OutputRequest> outputs;  ///< at most one of a kind, in the order of Kind
  std::optional<PictureSpot> pixel;    ///< whose rays are printed
  bool preview = false;                ///< show the picture on standard output
  bool stats = false;                  ///< print what was used and how long it took

  /// The output of this kind, or null.
  const OutputRequest* find(OutputRequest::Kind kind) const { return findOutput(outputs, kind); }
};

/// How the program runs, whatever it does.
struct RunRequest {
  int threads = 0;      ///< worker threads, 1..kMaxThreads
  int memoryLimit = 0;  ///< MB (2^20 bytes) that it may take, 1..kMaxMemoryLimit; 0 = no limit
  bool quiet = false;   ///< no warnings
  /// Whether standard error tells how far the picture is; where nothing is said, a terminal does.
  std::optional<bool> progress;
  std::string checkpoint;  ///< where finished tiles are kept; empty = nowhere
};

/// One argument as it was given: its name without dashes and the words that follow it.
struct GivenArgument {
  std::string name;
  std::vector<std::string> words;
};

/// A scene rendered.
struct RenderRequest {
  PictureRequest picture;
  ResultRequest results;
  /// All arguments, each name once: the last of equal ones, in the order in which these came.
  std::vector<GivenArgument> given;
};

/// Pictures compared.
struct CompareRequest {
  std::string expected;    ///< a picture or a folder; empty: nothing is compared
  std::string actual;      ///< a picture, a folder, or a table of commands (see compare.h)
  int tolerance = 1;       ///< levels, 0..255: differences up to it do not count
  double failPercent = 0;  ///< pictures are different when more of their pixels than this differ
  std::string diff;        ///< picture of the differences; empty = not wanted, as for the others
  std::string report;      ///< HTML page
  std::string csv;         ///< table that rows are added to

  bool isWanted() const { return !expected.empty(); }
};

/// Parts of a picture put together.
struct MergeRequest {
  std::string output;
  std::vector<std::string> parts;

  bool isWanted() const { return !parts.empty(); }
};

struct HelpTopic;

/// The texts about the program. Of several that are wanted the first in this order is printed.
enum class ProgramText { shortHelp, help, version, man, completion, none };

/// One run of the program: what of the following is wanted first decides which.
struct Request {
  ProgramText text = ProgramText::none;
  const HelpTopic* topic = nullptr;  ///< of ProgramText::help; null: the list of all arguments
  bool check = false;      ///< read render.picture.scene, report every mistake, render nothing
  CompareRequest compare;  ///< a mode of its own: there is then no scene
  MergeRequest merge;      ///< likewise
  RenderRequest render;
  RunRequest run;  ///< of all modes
};

/// The same request under another course, of a scene that gives its picture that size (0, 0 where
/// it does not). What the arguments say wins over both. Throws UsageError where they do not fit the
/// size.
RenderRequest adapted(const RenderRequest& request, const Course& course,
                      const SceneParser::PictureSize& size);

/// Reads the command line `words`, without the program's own name. What it does not say of the run
/// is as in `defaults`; where neither says how many threads, there are as many as cores, or fewer
/// where memory is limited. Throws UsageError at the first mistake. Unless a text is asked for, the
/// result names a scene and something to do with it, or two things to compare, or parts to merge;
/// that no two files are the same is left to checkFiles and checkMergedFiles.
Request parseRequest(const std::vector<std::string>& words,
                     const RunRequest& defaults = RunRequest());
