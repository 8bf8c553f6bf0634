// Reading the command line.
#include "cli/options.h"

#include <algorithm>
#include <string_view>

#include "cli/inspection.h"
#include "cli/option_table.h"
#include "cli/outputs.h"
#include "cli/part_arguments.h"
#include "cli/sampling_arguments.h"
#include "scene/wording.h"

namespace {

/// The name in "-name" or "--name"; "" where `word` is not of that form.
std::string nameOf(const std::string& word) {
  if (word.empty() || word[0] != '-') return "";
  return word.substr(word.compare(0, 2, "--") == 0 ? 2 : 1);
}

[[noreturn]] void failUnknown(const std::string& word) {
  if (nameOf(word).empty())
    throw UsageError("expected an argument such as -input, found " + ::quoted(word));
  std::vector<std::string_view> names;
  for (const OptionRow& row : optionTable()) {
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
                                        const OptionRow& row) {
  std::vector<std::string> found;
  for (int i = 1; i <= countWords(row); ++i) {
    const std::size_t next = at + std::size_t(i);
    const bool ended = next >= words.size();
    if (ended || findOption(nameOf(words[next])))
      throw UsageError(words[at] + ": expected " + row.words + ", found " +
                       (ended ? "the end of the command" : ::quoted(words[next])));
    found.push_back(words[next]);
  }
  if (!takesMore(row)) return found;
  for (std::size_t next = at + 1 + found.size(); next < words.size(); ++next) {
    if (!nameOf(words[next]).empty()) break;
    found.push_back(words[next]);
  }
  return found;
}

/// The last of equal arguments wins.
void note(const GivenOption& option, std::vector<GivenOption>& given) {
  const auto isSame = [&](const GivenOption& other) { return other.name == option.name; };
  given.erase(std::remove_if(given.begin(), given.end(), isSame), given.end());
  given.push_back(option);
}

void checkGridPicture(const Options& options) {
  if (options.gridPicture == Options::GridPicture::none) return;
  if (options.accel == Options::Accel::grid) return;
  const bool counts = options.gridPicture == Options::GridPicture::counts;
  throw UsageError(std::string(counts ? "-visualize_grid_count" : "-visualize_grid") +
                   ": expected a grid to draw, for example -grid 20 20 20, found none" +
                   (options.accel == Options::Accel::tree ? " but -accel tree" : ""));
}

/// -compare and -merge are modes of their own: what only renders has no place beside them, nor the
/// other way round. `given` are the rows of all arguments.
void checkMode(const Options& options, const std::vector<const OptionRow*>& given) {
  using Mode = OptionRow::Mode;
  const Mode mode = options.compare.isWanted() ? Mode::comparing
                    : options.merge.isWanted() ? Mode::merging
                                               : Mode::rendering;
  for (const OptionRow* row : given) {
    const std::string name = std::string("-") + row->name;
    if (row->mode == Mode::both || row->mode == mode) continue;
    if (mode == Mode::rendering)
      throw UsageError(name + ": expected -compare EXPECTED ACTUAL too, found none");
    throw UsageError(name + " cannot be given together with " +
                     (mode == Mode::comparing ? "-compare" : "-merge"));
  }
}

void checkComplete(const Options& options) {
  checkGridPicture(options);
  if (options.input.empty()) throw UsageError("expected a scene, found no -input FILE");
  const bool isAnyWanted = !wantedOutputs(options).empty() || options.tracesPixel ||
                           options.preview || options.stats || options.check;
  if (!isAnyWanted)
    throw UsageError(
        "expected something to do with the scene, found none of -output, -depth, -normals, "
        "-render_samples, -render_filter, -materials, -heatmap, -pixel, -preview, -stats and "
        "-check");
}

}  // namespace

Options parseOptions(const std::vector<std::string>& words) {
  Options options;
  options.shortHelp = words.empty();
  std::vector<const OptionRow*> given;
  std::size_t at = 0;
  while (at < words.size()) {
    const OptionRow* row = findOption(nameOf(words[at]));
    if (!row) failUnknown(words[at]);
    const std::vector<std::string> following = followingWords(words, at, *row);
    const GivenOption option = {row->name, following};
    row->apply(option, options);
    note(option, options.given);
    given.push_back(row);
    at += 1 + following.size();
  }
  if (options.wantsText()) return options;
  checkMode(options, given);
  if (options.compare.isWanted() || options.merge.isWanted()) return options;
  checkComplete(options);
  checkEnlargedSizes(options);
  checkPixel(options);
  checkPart(options);
  return options;
}
