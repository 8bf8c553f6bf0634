// What each argument does to a request. Most set one member of one piece of it.
#include <algorithm>
#include <cassert>
#include <limits>
#include <tuple>

#include "cli/arguments.h"
#include "scene/number_reader.h"

namespace {

using Words = const ArgumentWords&;
using Mode = ArgumentAction::Mode;
using Kind = OutputRequest::Kind;
using Pattern = SamplingOptions::Pattern;
using FilterKind = SamplingOptions::FilterKind;
using CellPicture = Acceleration::CellPicture;
using Progress = RunRequest::Progress;

/// This member of the piece of the request that has it.
template <class Piece, class Value>
Value& memberOf(Request& request, Value Piece::*member) {
  PictureRequest& picture = request.render.picture;
  const auto pieces = std::tie(request, picture, picture.render, picture.acceleration,
                               request.render.results, request.run, request.compare);
  return std::get<Piece&>(pieces).*member;
}

template <auto member, auto value = true>
void set(Words, Draft& draft) {
  memberOf(draft, member) = value;
}

template <auto member, int least, int most>
void setInteger(Words words, Draft& draft) {
  memberOf(draft, member) = words.integer(0, least, most);
}

template <auto member>
void setFile(Words words, Draft& draft) {
  memberOf(draft, member) = words.file(0);
}

/// Enters the output in place of one of the same kind, or where its kind stands in the order.
void want(Draft& draft, const OutputRequest& output) {
  std::vector<OutputRequest>& outputs = draft.render.results.outputs;
  const auto isBefore = [](const OutputRequest& a, const OutputRequest& b) {
    return a.kind < b.kind;
  };
  const auto [first, last] = std::equal_range(outputs.begin(), outputs.end(), output, isBefore);
  outputs.insert(outputs.erase(first, last), output);
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
  const std::size_t first = isNumber(words[0]) ? 0 : 1;
  constexpr const char* kOrders = " (MIN MAX FILE, or FILE MIN MAX)";
  const double depthMin = words.anyNumber(first, std::string("MIN") + kOrders);
  const double depthMax = words.anyNumber(first + 1, std::string("MAX") + kOrders);
  if (depthMin == depthMax) words.fail(first, "MIN and MAX to differ");
  want(draft, {Kind::depth, words.file(first == 0 ? 2 : 0), depthMin, depthMax});
}

void setSize(Words words, Draft& draft) {
  draft.render.picture.width = words.integer(0, 1, kMaxImageSide);
  draft.render.picture.height = words.integer(1, 1, kMaxImageSide);
}

/// The first word is no number of at least 0, nor one of the `alternatives`, ", this or that".
[[noreturn]] void failAtLeastZero(Words words, const char* alternatives) {
  const bool isTooLarge = isNumber(words[0]) && words[0][0] != '-';
  words.fail(0, std::string("a number of at least 0") + (isTooLarge ? " and within range" : "") +
                    alternatives);
}

void setWeight(Words words, Draft& draft) {
  float& weight = draft.render.picture.render.minWeight;
  if (!readFloat(words[0], weight) || weight < 0) failAtLeastZero(words, "");
}

void setEpsilon(Words words, Draft& draft) {
  Epsilon& epsilon = draft.render.picture.render.epsilon;
  epsilon = {Epsilon::Kind::fixed, Epsilon::kCourse};
  if (words[0] == "adaptive") epsilon.kind = Epsilon::Kind::adaptive;
  if (words[0] == "adaptive" || words[0] == "course") return;
  if (!readDouble(words[0], epsilon.value) || epsilon.value < 0) {
    failAtLeastZero(words, ", course or adaptive");
  }
}

/// Of several patterns the last one counts.
template <Pattern pattern>
void setPattern(Words words, Draft& draft) {
  SamplingOptions& sampling = draft.render.picture.render.sampling;
  sampling.samples = words.integer(0, 1, SamplingOptions::kMaxSamples);
  sampling.pattern = pattern;
}

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

void setCheckpoint(Words words, Draft& draft) {
  if (words[0] == "-") words.fail(0, "the name of a file");
  draft.run.checkpoint = words.file(0);
}

void setAccelerator(Words words, Draft& draft) {
  constexpr std::string_view kNames[] = {"fast", "tree"};
  if (!WordList(kNames).contains(words[0])) words.failChoice(0, kNames);
  draft.render.picture.acceleration.kind =
      words[0] == "fast" ? Acceleration::Kind::fast : Acceleration::Kind::tree;
}

void setGrid(Words words, Draft& draft) {
  Acceleration& acceleration = draft.render.picture.acceleration;
  int cells = 1;  // stays below 2^30
  for (int axis = 0; axis < 3; ++axis) {
    acceleration.gridSize[axis] = words.integer(std::size_t(axis), 1, kMaxGridSide);
    cells *= acceleration.gridSize[axis];
  }
  if (cells > kMaxGridCells) {
    failUsage("-grid: expected at most ", kMaxGridCells, " cells in all, found ", cells);
  }
  acceleration.kind = Acceleration::Kind::grid;
}

void setSimd(Words words, Draft& draft) {
  constexpr SimdLevel kLevels[] = {SimdLevel::automatic, SimdLevel::baseline, SimdLevel::avx2,
                                   SimdLevel::avx512};
  const auto isMeant = [&](SimdLevel level) { return words[0] == nameOf(level); };
  const auto level = std::find_if(std::begin(kLevels), std::end(kLevels), isMeant);
  if (level == std::end(kLevels)) words.fail(0, "auto, baseline, avx2 or avx512");
  draft.render.picture.acceleration.simd = *level;
}

void setCompare(Words words, Draft& draft) {
  for (std::size_t i = 0; i < 2; ++i) {
    if (words[i].empty()) words.fail(i, "a file or folder");
  }
  draft.compare.expected = words[0];
  draft.compare.actual = words[1];
}

void setFailPercent(Words words, Draft& draft) {
  draft.compare.failPercent = words.number(0, 0, 100, "a number from 0 to 100");
}

void setPixel(Words words, Draft& draft) {
  draft.render.results.pixel = {words.integer(0, 0, kMaxImageSide - 1),
                                words.integer(1, 0, kMaxImageSide - 1)};
}

void setQuiet(Words, Draft& draft) {
  draft.run.quiet = true;
  draft.run.progress = Progress::off;
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

constexpr ArgumentAction kActions[] = {
    {"input", setFile<&PictureRequest::scene>},

    {"output", wantPicture<Kind::color>},
    {"size", setSize},
    {"depth", wantDepth},
    {"normals", wantPicture<Kind::normals>},
    {"materials", wantPicture<Kind::materials>},
    {"heatmap", wantPicture<Kind::heatmap>},

    {"bounces", setInteger<&RenderOptions::maxBounces, 0, kMaxBounces>},
    {"weight", setWeight},
    {"epsilon", setEpsilon, Mode::rendering, "course adaptive"},

    {"random_samples", setPattern<Pattern::random>},
    {"uniform_samples", setPattern<Pattern::uniform>},
    {"jittered_samples", setPattern<Pattern::jittered>},
    {"adaptive_samples", setAdaptive},
    {"box_filter", setFilter<FilterKind::box>},
    {"tent_filter", setFilter<FilterKind::tent>},
    {"gaussian_filter", setFilter<FilterKind::gaussian>},
    {"render_samples", wantEnlarged<Kind::samples>},
    {"render_filter", wantEnlarged<Kind::filter>},

    {"shadows", set<&RenderOptions::shadows>},
    {"no_shadows", set<&RenderOptions::shadows, false>},
    {"transparent_shadows", set<&RenderOptions::transparentShadows>},
    {"shade_back", set<&RenderOptions::shadeBack>},
    {"nested_dielectrics", set<&RenderOptions::nestedDielectrics>},
    {"fresnel", set<&RenderOptions::fresnel>},

    {"region", setRegion},
    {"tile", setBand},
    {"merge", setMerge, Mode::merging},
    {"checkpoint", setCheckpoint},
    {"memory_limit", setInteger<&RunRequest::memoryLimit, 1, kMaxMemoryLimit>, Mode::any},

    {"threads", setInteger<&RunRequest::threads, 1, kMaxThreads>, Mode::any},
    {"accel", setAccelerator, Mode::rendering, "fast tree"},
    {"grid", setGrid},
    {"simd", setSimd, Mode::rendering, "auto baseline avx2 avx512"},

    {"compare", setCompare, Mode::comparing},
    {"tolerance", setInteger<&CompareRequest::tolerance, 0, 255>, Mode::comparing},
    {"fail_percent", setFailPercent, Mode::comparing},
    {"diff", setFile<&CompareRequest::diff>, Mode::comparing},
    {"report", setFile<&CompareRequest::report>, Mode::comparing},
    {"csv", setFile<&CompareRequest::csv>, Mode::comparing},

    {"check", set<&Request::check>},
    {"stats", set<&ResultRequest::stats>},
    {"pixel", setPixel},
    {"pixel_obj", wantPicture<Kind::rays>},
    {"visualize_grid", set<&Acceleration::cellPicture, CellPicture::occupied>},
    {"visualize_grid_count", set<&Acceleration::cellPicture, CellPicture::counts>},

    {"progress", set<&RunRequest::progress, Progress::on>},
    {"preview", set<&ResultRequest::preview>},
    {"quiet", setQuiet, Mode::any},
    {"help", wantHelp, Mode::any,
     "scene materials samples output inside grid parts checkpoint compare limits"},
    {"version", wantText<ProgramText::version>, Mode::any},
    {"man", wantText<ProgramText::man>, Mode::any},
    {"completion", wantText<ProgramText::completion>, Mode::any},
};

}  // namespace

const ArgumentAction& actionOf(const std::string& name) {
  const auto isOfName = [&](const ArgumentAction& action) { return name == action.name; };
  const auto found = std::find_if(std::begin(kActions), std::end(kActions), isOfName);
  assert(found != std::end(kActions));
  return *found;
}
