// The arguments about parts of pictures and long runs.
#include "cli/part_arguments.h"

#include <cstdint>

#include "cli/inspection.h"
#include "cli/option_values.h"

namespace {

using Given = const GivenOption&;

void setRegion(Given given, Options& options) {
  PartOptions& part = options.part;
  part.x = wholeNumber(given, 0, "X", 0, kMaxImageSide - 1);
  part.y = wholeNumber(given, 1, "Y", 0, kMaxImageSide - 1);
  part.width = wholeNumber(given, 2, "W", 1, kMaxImageSide);
  part.height = wholeNumber(given, 3, "H", 1, kMaxImageSide);
  part.isRegion = true;
}

void setTile(Given given, Options& options) {
  const int tiles = wholeNumber(given, 1, "N", 1, kMaxImageSide);
  options.part.tile = wholeNumber(given, 0, "I", 1, tiles);
  options.part.tiles = tiles;
}

void setMerge(Given given, Options& options) {
  for (const std::string& word : given.words) {
    if (word.empty()) throw UsageError("-merge: expected a file name, found ''");
  }
  options.merge.output = given.words[0];
  options.merge.parts.assign(given.words.begin() + 1, given.words.end());
}

std::string sizeText(const Options& options) {
  return std::to_string(options.width) + " x " + std::to_string(options.height) + " pixels";
}

/// The first row of tile `tile` + 1, from the top.
int firstRow(const Options& options, int tile) {
  return int(std::int64_t(tile) * options.height / options.part.tiles);
}

}  // namespace

std::vector<OptionRow> partRows() {
  const char* group = "Large pictures";
  return {
      {group, "region", nullptr, "X Y W H", nullptr,
       "render W x H pixels only, of which the first is X from the left and Y from the top; the "
       "images are parts, for -merge",
       setRegion},
      {group, "tile", nullptr, "I N", nullptr,
       "render the I-th of N bands of rows only, counted from 1 at the top; N is at most the "
       "image's height",
       setTile},
      {group, "merge", nullptr, "OUT PART...", nullptr,
       "a run of its own, without -input: put an image together from all its parts, TGA files in "
       "any order",
       setMerge, OptionRow::Mode::merging},
      {group, "checkpoint", nullptr, "FILE", nullptr,
       "keep finished parts of the picture in FILE, from which the same command takes up after the "
       "program was ended; FILE is removed when the picture is done",
       [](Given given, Options& o) { o.checkpoint = plainFileName(given); }},
      {group, "memory_limit", nullptr, "MB", nullptr,
       "end the run with a message rather than take more than so many megabytes of memory (2^20 "
       "bytes each), 1 to 100000000 (default: no limit)",
       [](Given given, Options& o) {
         o.memoryLimit = wholeNumber(given, 0, "MB", 1, kMaxMemoryLimit);
       },
       OptionRow::Mode::both},
  };
}

void checkPart(const Options& options) {
  const PartOptions& part = options.part;
  if (!part.isWanted()) return;
  if (part.isRegion && part.tiles > 0)
    throw UsageError("-region and -tile cannot be given together");
  const std::string name = part.isRegion ? "-region" : "-tile";
  if (!options.samplesOutput.empty() || !options.filterOutput.empty()) {
    throw UsageError(name + " cannot be given together with -render_samples or -render_filter");
  }
  if (!options.materialsOutput.empty() || wantsInspection(options)) {
    throw UsageError(name + " cannot be given together with -materials, -heatmap or -pixel");
  }
  if (part.tiles > options.height) {
    throw UsageError("-tile: expected an N of at most " + std::to_string(options.height) +
                     ", the rows of an image of " + sizeText(options) + ", found '" +
                     std::to_string(part.tiles) + "'");
  }
  if (part.x + part.width > options.width || part.y + part.height > options.height) {
    throw UsageError("-region: expected a part of the image of " + sizeText(options) +
                     ", found one that ends " + std::to_string(part.x + part.width) +
                     " pixels from the left and " + std::to_string(part.y + part.height) +
                     " from the top");
  }
}

PixelRectangle renderedArea(const Options& options) {
  const PartOptions& part = options.part;
  const int height = options.height;
  if (part.isRegion) {
    return {part.x, height - part.y - part.height, part.x + part.width, height - part.y};
  }
  if (part.tiles == 0) return {0, 0, options.width, height};
  return {0, height - firstRow(options, part.tile), options.width,
          height - firstRow(options, part.tile - 1)};
}
