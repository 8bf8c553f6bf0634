// Reading the command line.
#include "cli/options.h"

#include <filesystem>
#include <string_view>

#include "cli/option_table.h"
#include "scene/wording.h"

namespace {

namespace fs = std::filesystem;

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
  return found;
}

void checkComplete(const Options& options) {
  if (options.help || options.version || options.shortHelp) return;
  if (options.input.empty()) throw UsageError("expected a scene, found no -input FILE");
  const bool anyOutput = !options.output.empty() || !options.depthOutput.empty() ||
                         !options.normalsOutput.empty() || options.stats || options.check;
  if (!anyOutput)
    throw UsageError(
        "expected something to do with the scene, found none of -output, -depth, -normals, "
        "-stats and -check");
}

/// Where a file of this name is or would be created, links followed.
fs::path placeOf(const std::string& name) {
  constexpr int kMostLinks = 40;  // as Linux allows
  std::error_code error;
  fs::path place = fs::absolute(name, error);
  for (int i = 0; i < kMostLinks && fs::is_symlink(place, error) && !fs::exists(place, error); ++i)
    place = place.parent_path() / fs::read_symlink(place, error);
  const fs::path canonical = fs::weakly_canonical(place, error);
  return error ? place : canonical;
}

/// True when both names lead to the same place, whether or not there is a file yet.
bool sameFile(const std::string& a, const std::string& b) {
  std::error_code error;
  if (fs::is_character_file(a, error)) return false;
  return (fs::equivalent(a, b, error) && !error) || placeOf(a) == placeOf(b);
}

}  // namespace

Options parseOptions(const std::vector<std::string>& words) {
  Options options;
  options.shortHelp = words.empty();
  std::size_t at = 0;
  while (at < words.size()) {
    const OptionRow* row = findOption(nameOf(words[at]));
    if (!row) failUnknown(words[at]);
    const std::vector<std::string> following = followingWords(words, at, *row);
    row->apply({row->name, following}, options);
    at += 1 + following.size();
  }
  checkComplete(options);
  return options;
}

void checkFiles(const Options& options) {
  struct Named {
    const char* argument;
    const std::string& file;
  };
  const Named files[] = {{"-input", options.input},
                         {"-output", options.output},
                         {"-depth", options.depthOutput},
                         {"-normals", options.normalsOutput}};
  for (const Named& a : files) {
    for (const Named& b : files) {
      if (&a >= &b || a.file.empty() || b.file.empty() || a.file == "-") continue;
      if (sameFile(a.file, b.file))
        throw UsageError(std::string(a.argument) + " and " + b.argument +
                         ": expected different files, found '" + a.file + "' and '" + b.file + "'");
    }
  }
}
