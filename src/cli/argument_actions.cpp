// What each argument does to a request: a function for each row of the table at the end, in the
// order of the list that -help prints.
//
// Most arguments set one member of one piece of the request. They share a few functions that are
// told which member that is, so that their rows say all: set, setIntegers, setFile, setChoice.
// Where several arguments speak of the same thing (patterns of samples, filters, -shadows and
// -no_shadows), the last one given wins, as it does among equal ones. What several arguments must
// fulfil together is no matter of theirs, but of request.cpp.
#include <algorithm>
#include <cassert>
#include <cstdint>
#include <limits>
#include <tuple>
#include <type_traits>

#include "cli/arguments.h"
#include "scene/number_reader.h"

namespace {

using Words = const ArgumentWords&;
using Mode = ArgumentAction::Mode;
using Kind = OutputRequest::Kind;
using Pattern = SamplingOptions::Pattern;
using FilterKind = SamplingOptions::FilterKind;
using CellPicture = Acceleration::CellPicture;

/// This member of the draft, or of the piece of the request that has it.
template <class Piece, class Value>
Value& memberOf(Draft& draft, Value Piece::*member) {
  Request& request = draft;
  PictureRequest& picture = request.render.picture;
  const auto pieces =
      std::tie(draft, request, picture, picture.render, picture.rules, picture.acceleration,
               request.render.results, request.run, request.compare);
  return std::get<Piece&>(pieces).*member;
}

/// An argument without words.
template <auto member, auto value = true>
void set(Words, Draft& draft) {
  memberOf(draft, member) = value;
}

/// Whole numbers from `least` to `most`, a word for each member.
template <int least, int most, auto... members>
void setIntegers(Words words, Draft& draft) {
  std::size_t index = 0;
  ((memberOf(draft, members) = words.integer(index++, least, most)), ...);
}

/// One file, "-" being standard input or output; with ArgumentWords::picture a picture's.
template <auto member, auto nameIn = &ArgumentWords::file>
void setFile(Words words, Draft& draft) {
  memberOf(draft, member) = (words.*nameIn)(0);
}

/// One of the choices of the row, which stand in the order of the member's values. Names of
/// instruction sets are so alike that none is proposed for another.
template <auto member, bool proposes = true>
void setChoice(Words words, Draft& draft) {
  auto& value = memberOf(draft, member);
  value = std::decay_t<decltype(value)>(words.choice(proposes));
}

/// Enters the output that the argument of `words` asks for, in place of one of the same kind, or
/// where its kind stands in the order.
void want(Words words, Draft& draft, OutputRequest output) {
  output.argument = "-" + words.name();
  std::vector<OutputRequest>& outputs = draft.render.results.outputs;
  const auto isBefore = [](const OutputRequest& a, const OutputRequest& b) {
    return a.kind < b.kind;
  };
  const auto [first, last] = std::equal_range(outputs.begin(), outputs.end(), output, isBefore);
  outputs.insert(outputs.erase(first, last), output);
}

/// A picture as large as the one that is rendered, or the file of a pixel's rays.
template <Kind kind>
void wantPicture(Words words, Draft& draft) {
  want(words, draft, {kind, kind == Kind::rays ? words.file(0) : words.picture(0)});
}

/// Whether the enlarged picture is too large shows when the size is known.
template <Kind kind>
void wantEnlarged(Words words, Draft& draft) {
  const int zoom = words.integer(1, 1, kMaxImageSide);
  want(words, draft, {kind, words.picture(0), 0, 0, zoom});
}

/// MIN MAX FILE, or FILE MIN MAX where the first word is no number.
void wantDepth(Words words, Draft& draft) {
  const std::size_t first = isNumber(words[0]) ? 0 : 1;
  constexpr const char* kOrders = " (MIN MAX FILE, or FILE MIN MAX)";
  const double depthMin = words.anyNumber(first, std::string("MIN") + kOrders);
  const double depthMax = words.anyNumber(first + 1, std::string("MAX") + kOrders);
  if (depthMin == depthMax) words.fail(first, "MIN and MAX to differ");
  want(words, draft, {Kind::depth, words.picture(first == 0 ? 2 : 0), depthMin, depthMax});
}

/// The course holds since before the first argument: startFrom. Here its name is checked.
void checkCourse(Words words, Draft&) { words.choice(false); }

/// Without effect, which is told.
void addIdle(Words words, Draft& draft) {
  draft.idle += (draft.idle.empty() ? "-" : ", -") + words.name();
}

/// The numbers must be right all the same.
void addTessellation(Words words, Draft& draft) {
  for (std::size_t i = 0; i < 2; ++i) words.integer(i, 1, std::numeric_limits<int>::max());
  addIdle(words, draft);
}

/// A number of at least 0; where it is none, `alternatives`, ", this or that", are told besides.
template <class Number>
void readAtLeastZero(Words words, const char* alternatives, Number& value) {
  if (readNumber(words[0], value) && value >= 0) return;
  const bool isTooLarge = isNumber(words[0]) && words[0][0] != '-';
  words.fail(0, std::string("a number of at least 0") + (isTooLarge ? " and within range" : "") +
                    alternatives);
}

void setWeight(Words words, Draft& draft) {
  readAtLeastZero(words, "", draft.render.picture.render.minWeight);
}

/// What -epsilon takes besides numbers.
constexpr std::string_view kEpsilons[] = {"course", "adaptive"};

/// Without -epsilon its kind stays automatic.
void setEpsilon(Words words, Draft& draft) {
  PictureRequest& picture = draft.render.picture;
  Epsilon& epsilon = picture.render.epsilon;
  epsilon = {Epsilon::Kind::fixed, picture.course->render.epsilon.value};
  if (words[0] == kEpsilons[1]) epsilon.kind = Epsilon::Kind::adaptive;
  if (words[0] == kEpsilons[0] || words[0] == kEpsilons[1]) return;
  readAtLeastZero(words, ", course or adaptive", epsilon.value);
}

/// Of several patterns the last one counts.
template <Pattern pattern>
void setPattern(Words words, Draft& draft) {
  SamplingOptions& sampling = draft.render.picture.render.sampling;
  sampling.samples = words.integer(0, 1, SamplingOptions::kMaxSamples);
  sampling.pattern = pattern;
}

/// Of a grid, unless the course says otherwise.
void setUniform(Words words, Draft& draft) {
  setPattern<Pattern::uniform>(words, draft);
  draft.render.picture.render.sampling.pattern = draft.render.picture.course->uniformSamples;
}

/// MIN MAX TOLERANCE: MAX is at least MIN.
void setAdaptive(Words words, Draft& draft) {
  SamplingOptions& sampling = draft.render.picture.render.sampling;
  sampling.samples = words.integer(0, 1, SamplingOptions::kMaxFirstSamples);
  sampling.maxSamples = words.integer(1, sampling.samples, SamplingOptions::kMaxSamples);
  sampling.tolerance = words.number(2, 0, 1, "a number from 0 to 1 for TOLERANCE");
  sampling.pattern = Pattern::adaptive;
}

/// Of several filters the last one counts. A gaussian reaches twice its sigma.
template <FilterKind filter>
void setFilter(Words words, Draft& draft) {
  constexpr int kMost = SamplingOptions::kMaxReach / (filter == FilterKind::gaussian ? 2 : 1);
  SamplingOptions& sampling = draft.render.picture.render.sampling;
  sampling.filterSize =
      words.number(0, std::numeric_limits<double>::min(), kMost,
                   "a number of pixels above 0 and up to " + std::to_string(kMost));
  sampling.filter = filter;
}

/// X Y W H, from the top left corner; the camera counts from the lower left one.
void setRegion(Words words, Draft& draft) {
  const int x = words.integer(0, 0, kMaxImageSide - 1), y = words.integer(1, 0, kMaxImageSide - 1);
  const int right = x + words.integer(2, 1, kMaxImageSide);
  const int bottom = y + words.integer(3, 1, kMaxImageSide);
  draft.region = [=](const PictureRequest& picture) -> PixelRectangle {
    refuseIf(right > picture.width || bottom > picture.height,
             "-region: expected a part of the image of ", picture.sizeText(),
             ", found one that ends ", right, " pixels from the left and ", bottom,
             " from the top");
    return {x, picture.height - bottom, right, picture.height - y};
  };
}

/// I N, where I counts from 1. No picture has more bands than rows. They are cut so that their
/// heights differ by one row at most.
void setBand(Words words, Draft& draft) {
  const int count = words.integer(1, 1, kMaxImageSide), number = words.integer(0, 1, count);
  draft.band = [=](const PictureRequest& picture) -> PixelRectangle {
    const int height = picture.height;
    refuseIf(count > height, "-tile: expected an N of at most ", height,
             ", the rows of an image of ", picture.sizeText(), ", found '", count, "'");
    const auto rowsAbove = [&](int bands) { return int(std::int64_t(bands) * height / count); };
    return {0, height - rowsAbove(number), picture.width, height - rowsAbove(number - 1)};
  };
}

/// The whole picture, then its parts; all are files.
void setMerge(Words words, Draft& draft) {
  for (std::size_t i = 0; i < words.all().size(); ++i) i == 0 ? words.picture(i) : words.file(i);
  draft.merge.output = words[0];
  draft.merge.parts.assign(words.all().begin() + 1, words.all().end());
}

/// A checkpoint is read again, which standard output cannot be.
void setCheckpoint(Words words, Draft& draft) {
  if (words[0] == "-") words.fail(0, "the name of a file");
  draft.run.checkpoint = words.file(0);
}

/// Each side has its limit, and all cells together, for which memory is asked.
void setGrid(Words words, Draft& draft) {
  Acceleration& acceleration = draft.render.picture.acceleration;
  int cells = 1;  // stays below 2^30
  for (int axis = 0; axis < 3; ++axis) {
    acceleration.gridSize[axis] = words.integer(std::size_t(axis), 1, kMaxGridSide);
    cells *= acceleration.gridSize[axis];
  }
  refuseIf(cells > kMaxGridCells, "-grid: expected at most ", kMaxGridCells,
           " cells in all, found ", cells);
  acceleration.kind = Acceleration::Kind::grid;
}

/// Both may be files or folders; what they are is found out by the comparison.
void setCompare(Words words, Draft& draft) {
  draft.compare.expected = words.notEmpty(0, "a file or folder");
  draft.compare.actual = words.notEmpty(1, "a file or folder");
}

void setFailPercent(Words words, Draft& draft) {
  draft.compare.failPercent = words.number(0, 0, 100, "a number from 0 to 100");
}

void setPixel(Words words, Draft& draft) {
  draft.render.results.pixel = {words.integer(0, 0, kMaxImageSide - 1),
                                words.integer(1, 0, kMaxImageSide - 1)};
}

/// A -progress that comes later insists.
void setQuiet(Words, Draft& draft) {
  draft.run.quiet = true;
  draft.run.progress = false;
}

/// Of several texts the first in the order of ProgramText counts.
template <ProgramText text>
void wantText(Words, Draft& draft) {
  draft.text = std::min(draft.text, text);
}

void wantHelp(Words words, Draft& draft) {
  wantText<ProgramText::help>(words, draft);
  if (!words.all().empty()) draft.topic = &helpTopics()[words.choice()];
}

/// One that changes no pixel, or only names a file.
constexpr ArgumentAction unseen(ArgumentAction action) {
  action.changesPixels = false;
  return action;
}

/// With groups apart as in the list; each row belongs to runs that render unless it says otherwise,
/// and is taken to change pixels.
constexpr ArgumentAction kActions[] = {
    unseen({"input", setFile<&PictureRequest::scene>}),
    {"course", checkCourse, Mode::rendering, kCourseNames},

    unseen({"output", wantPicture<Kind::color>}),
    {"size", setIntegers<1, kMaxImageSide, &PictureRequest::width, &PictureRequest::height>},
    unseen({"depth", wantDepth}),
    unseen({"normals", wantPicture<Kind::normals>}),
    unseen({"materials", wantPicture<Kind::materials>}),
    unseen({"heatmap", wantPicture<Kind::heatmap>}),

    {"bounces", setIntegers<0, kMaxBounces, &RenderOptions::maxBounces>},
    {"weight", setWeight},
    {"epsilon", setEpsilon, Mode::rendering, kEpsilons},

    {"random_samples", setPattern<Pattern::random>},
    {"uniform_samples", setUniform},
    {"regular_samples", setPattern<Pattern::uniform>},
    {"jittered_samples", setPattern<Pattern::jittered>},
    {"adaptive_samples", setAdaptive},
    {"box_filter", setFilter<FilterKind::box>},
    {"tent_filter", setFilter<FilterKind::tent>},
    {"gaussian_filter", setFilter<FilterKind::gaussian>},
    unseen({"render_samples", wantEnlarged<Kind::samples>}),
    unseen({"render_filter", wantEnlarged<Kind::filter>}),

    {"shadows", set<&RenderOptions::shadows>},
    {"no_shadows", set<&RenderOptions::shadows, false>},
    {"transparent_shadows", set<&RenderOptions::transparentShadows>},
    {"shade_back", set<&RenderOptions::shadeBack>},
    {"nested_dielectrics", set<&RenderOptions::nestedDielectrics>},
    {"specular_fix", set<&SceneRules::areHighlightsDimmed>},
    {"fresnel", set<&RenderOptions::fresnel>},

    {"region", setRegion},
    {"tile", setBand},
    {"merge", setMerge, Mode::merging},
    unseen({"checkpoint", setCheckpoint}),
    unseen({"memory_limit", setIntegers<1, kMaxMemoryLimit, &RunRequest::memoryLimit>, Mode::any}),

    unseen({"threads", setIntegers<1, kMaxThreads, &RunRequest::threads>, Mode::any}),
    unseen({"accel", setChoice<&Acceleration::kind>, Mode::rendering, kAcceleratorNames}),
    {"grid", setGrid},
    unseen({"simd", setChoice<&Acceleration::simd, false>, Mode::rendering, kSimdNames}),

    {"compare", setCompare, Mode::comparing},
    {"tolerance", setIntegers<0, 255, &CompareRequest::tolerance>, Mode::comparing},
    {"fail_percent", setFailPercent, Mode::comparing},
    {"diff", setFile<&CompareRequest::diff, &ArgumentWords::picture>, Mode::comparing},
    {"report", setFile<&CompareRequest::report>, Mode::comparing},
    {"csv", setFile<&CompareRequest::csv>, Mode::comparing},

    unseen({"check", set<&Request::check>}),
    unseen({"stats", set<&ResultRequest::stats>}),
    unseen({"pixel", setPixel}),
    unseen({"pixel_obj", wantPicture<Kind::rays>}),
    {"visualize_grid", set<&Acceleration::cellPicture, CellPicture::occupied>},
    {"visualize_grid_count", set<&Acceleration::cellPicture, CellPicture::counts>},

    {"jitter", set<&Draft::isJittered>},
    {"filter", set<&Draft::isFiltered>},

    unseen({"gui", addIdle}),
    unseen({"gouraud", addIdle}),
    unseen({"tessellation", addTessellation}),

    unseen({"progress", set<&RunRequest::progress>}),
    unseen({"preview", set<&ResultRequest::preview>}),
    unseen({"quiet", setQuiet, Mode::any}),
    unseen({"help", wantHelp, Mode::any, kTopicNames}),
    unseen({"version", wantText<ProgramText::version>, Mode::any}),
    unseen({"man", wantText<ProgramText::man>, Mode::any}),
    unseen({"completion", wantText<ProgramText::completion>, Mode::any}),
};

}  // namespace

const ArgumentAction& actionOf(const std::string& name) {
  const auto isOfName = [&](const ArgumentAction& action) { return name == action.name; };
  const auto found = std::find_if(std::begin(kActions), std::end(kActions), isOfName);
  assert(found != std::end(kActions));
  return *found;
}
