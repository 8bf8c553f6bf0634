// Reading the command line: first every argument in turn, then what several of them must fulfil
// together.
#include "cli/request.h"

#include <algorithm>
#include <cstdint>
#include <string_view>

#include "cli/arguments.h"
#include "scene/wording.h"
#include "system/worker_threads.h"

namespace {

using Kind = OutputRequest::Kind;
using Mode = ArgumentRow::Mode;

/// The name in "-name" or "--name"; "" where `word` is not of that form.
std::string nameOf(const std::string& word) {
  if (word.empty() || word[0] != '-') return "";
  return word.substr(word.compare(0, 2, "--") == 0 ? 2 : 1);
}

[[noreturn]] void failUnknown(const std::string& word) {
  if (nameOf(word).empty())
    throw UsageError("expected an argument such as -input, found " + ::quoted(word));
  std::vector<std::string_view> names;
  for (const ArgumentRow& row : argumentTable()) {
    names.push_back(row.name);
    if (row.otherName) names.push_back(row.otherName);
  }
  const std::string nearest(nearestWord(nameOf(word), WordList(names.data(), names.size())));
  throw UsageError(
      "unknown argument " + ::quoted(word) + "; " +
      (nearest.empty() ? "'raytracer -help' lists them all" : "did you mean '-" + nearest + "'?"));
}

/// The words that follow words[at], which names the argument of `row`.
std::vector<std::string> followingWords(const std::vector<std::string>& words, std::size_t at,
                                        const ArgumentRow& row) {
  std::vector<std::string> found;
  for (int i = 1; i <= leastWords(row); ++i) {
    const std::size_t next = at + std::size_t(i);
    const bool ended = next >= words.size();
    if (ended || findArgument(nameOf(words[next])))
      throw UsageError(words[at] + ": expected " + row.words + ", found " +
                       (ended ? "the end of the command" : ::quoted(words[next])));
    found.push_back(words[next]);
  }
  while (found.size() < mostWords(row)) {
    const std::size_t next = at + 1 + found.size();
    if (next >= words.size() || !nameOf(words[next]).empty()) break;
    found.push_back(words[next]);
  }
  return found;
}

/// The last of equal arguments wins.
void note(const GivenArgument& argument, std::vector<GivenArgument>& given) {
  const auto isSame = [&](const GivenArgument& other) { return other.name == argument.name; };
  given.erase(std::remove_if(given.begin(), given.end(), isSame), given.end());
  given.push_back(argument);
}

/// Enters all arguments in `draft`; the rows of them all, in their order.
std::vector<const ArgumentRow*> readArguments(const std::vector<std::string>& words, Draft& draft) {
  std::vector<const ArgumentRow*> rows;
  for (std::size_t at = 0; at < words.size();) {
    const ArgumentRow* row = findArgument(nameOf(words[at]));
    if (!row) failUnknown(words[at]);
    const GivenArgument argument = {row->name, followingWords(words, at, *row)};
    row->apply(ArgumentWords(*row, argument.words), draft);
    note(argument, draft.render.given);
    rows.push_back(row);
    at += 1 + argument.words.size();
  }
  return rows;
}

/// -compare and -merge are modes of their own: what only renders has no place beside them, nor the
/// other way round.
void checkMode(const Request& request, const std::vector<const ArgumentRow*>& given) {
  const Mode mode = request.compare.isWanted() ? Mode::comparing
                    : request.merge.isWanted() ? Mode::merging
                                               : Mode::rendering;
  for (const ArgumentRow* row : given) {
    const std::string name = std::string("-") + row->name;
    if (row->mode == Mode::any || row->mode == mode) continue;
    if (mode == Mode::rendering)
      throw UsageError(name + ": expected -compare EXPECTED ACTUAL too, found none");
    throw UsageError(name + " cannot be given together with " +
                     (mode == Mode::comparing ? "-compare" : "-merge"));
  }
}

void checkCellPicture(const Acceleration& acceleration) {
  if (acceleration.cellPicture == Acceleration::CellPicture::none) return;
  if (acceleration.kind == Acceleration::Kind::grid) return;
  const bool counts = acceleration.cellPicture == Acceleration::CellPicture::counts;
  throw UsageError(std::string(counts ? "-visualize_grid_count" : "-visualize_grid") +
                   ": expected a grid to draw, for example -grid 20 20 20, found none" +
                   (acceleration.kind == Acceleration::Kind::tree ? " but -accel tree" : ""));
}

void checkComplete(const Draft& draft) {
  const ResultRequest& results = draft.render.results;
  if (draft.render.picture.scene.empty()) {
    throw UsageError("expected a scene, found no -input FILE");
  }
  const bool isAnyWanted =
      !results.outputs.empty() || draft.pixel || results.preview || results.stats || draft.check;
  if (isAnyWanted) return;
  throw UsageError(
      "expected something to do with the scene, found none of -output, -depth, -normals, "
      "-render_samples, -render_filter, -materials, -heatmap, -pixel, -preview, -stats and "
      "-check");
}

std::string sizeText(const PictureRequest& picture) {
  return std::to_string(picture.width) + " x " + std::to_string(picture.height) + " pixels";
}

/// The picture is to be enlarged, by `more` pixels besides.
void checkEnlarged(const char* argument, const PictureRequest& picture, int zoom, int more) {
  const int most = (kMaxImageSide - more) / std::max(picture.width, picture.height);
  if (zoom <= most) return;
  throw UsageError(std::string(argument) + ": expected a ZOOM of at most " + std::to_string(most) +
                   " for an image of " + sizeText(picture) + ", found '" + std::to_string(zoom) +
                   "'");
}

void checkEnlargedSizes(const RenderRequest& render) {
  const OutputRequest* const samples = render.results.find(Kind::samples);
  const OutputRequest* const filter = render.results.find(Kind::filter);
  if (samples) checkEnlarged("-render_samples", render.picture, samples->zoom, 0);
  if (filter) checkEnlarged("-render_filter", render.picture, filter->zoom, 1);
}

void checkPixel(const Draft& draft) {
  const PictureRequest& picture = draft.render.picture;
  if (!draft.pixel && draft.render.results.find(Kind::rays)) {
    throw UsageError("-pixel_obj: expected a pixel to trace, for example -pixel 50 50, found none");
  }
  if (!draft.pixel) return;
  if (draft.pixel->x < picture.width && draft.pixel->y < picture.height) return;
  throw UsageError("-pixel: expected X below " + std::to_string(picture.width) + " and Y below " +
                   std::to_string(picture.height) + ", the size of the image, found '" +
                   std::to_string(draft.pixel->x) + " " + std::to_string(draft.pixel->y) + "'");
}

/// The part that is wanted lies in the picture, and nothing is wanted that has no parts.
void checkPart(const Draft& draft) {
  if (!draft.region && !draft.band) return;
  if (draft.region && draft.band) {
    throw UsageError("-region and -tile cannot be given together");
  }
  const PictureRequest& picture = draft.render.picture;
  const ResultRequest& results = draft.render.results;
  const std::string name = draft.region ? "-region" : "-tile";
  if (results.find(Kind::samples) || results.find(Kind::filter)) {
    throw UsageError(name + " cannot be given together with -render_samples or -render_filter");
  }
  if (results.find(Kind::materials) || results.find(Kind::heatmap) || draft.pixel) {
    throw UsageError(name + " cannot be given together with -materials, -heatmap or -pixel");
  }
  if (draft.band && draft.band->count > picture.height) {
    throw UsageError("-tile: expected an N of at most " + std::to_string(picture.height) +
                     ", the rows of an image of " + sizeText(picture) + ", found '" +
                     std::to_string(draft.band->count) + "'");
  }
  if (!draft.region) return;
  const int right = draft.region->x + draft.region->width;
  const int bottom = draft.region->y + draft.region->height;
  if (right <= picture.width && bottom <= picture.height) return;
  throw UsageError("-region: expected a part of the image of " + sizeText(picture) +
                   ", found one that ends " + std::to_string(right) + " pixels from the left and " +
                   std::to_string(bottom) + " from the top");
}

/// The pixels that are rendered, counted from the lower left corner; those of bands are cut so that
/// their heights differ by one row at most.
PixelRectangle areaOf(const Draft& draft) {
  const int width = draft.render.picture.width, height = draft.render.picture.height;
  if (draft.region) {
    const Draft::Region& region = *draft.region;
    const int top = height - region.y;
    return {region.x, top - region.height, region.x + region.width, top};
  }
  if (!draft.band) return {0, 0, width, height};
  const auto rowsAbove = [&](int bands) {
    return int(std::int64_t(bands) * height / draft.band->count);
  };
  return {0, height - rowsAbove(draft.band->number), width,
          height - rowsAbove(draft.band->number - 1)};
}

/// Under a limit only so many that their stacks, of 2 MB and more, leave room for the rest.
int threadCount(const RunRequest& run) {
  constexpr int kMegabytesEach = 8;
  const int wanted = run.threads > 0 ? run.threads : std::min(hardwareThreads(), kMaxThreads);
  if (run.memoryLimit == 0) return wanted;
  return std::min(wanted, std::max(1, run.memoryLimit / kMegabytesEach));
}

}  // namespace

const OutputRequest* ResultRequest::find(OutputRequest::Kind kind) const {
  for (const OutputRequest& output : outputs)
    if (output.kind == kind) return &output;
  return nullptr;
}

Request parseRequest(const std::vector<std::string>& words, const RunRequest& defaults) {
  Draft draft;
  draft.run = defaults;
  if (words.empty()) draft.text = ProgramText::shortHelp;
  const std::vector<const ArgumentRow*> given = readArguments(words, draft);
  draft.run.threads = threadCount(draft.run);
  if (draft.text != ProgramText::none) return draft;
  checkMode(draft, given);
  if (draft.compare.isWanted() || draft.merge.isWanted()) return draft;
  checkCellPicture(draft.render.picture.acceleration);
  checkComplete(draft);
  checkEnlargedSizes(draft.render);
  checkPixel(draft);
  checkPart(draft);
  draft.render.picture.area = areaOf(draft);
  draft.render.picture.isPart = draft.region || draft.band;
  if (draft.pixel) {
    draft.render.results.pixel = {draft.pixel->x, draft.render.picture.height - 1 - draft.pixel->y};
  }
  return draft;
}
