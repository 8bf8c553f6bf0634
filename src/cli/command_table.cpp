// A table of commands: each line is split into words as a shell would, and read as if the program
// had been called with them, -output and the picture's name before. So a line may say all that a
// command can, and is refused with the same words; what does more than render pictures is refused
// here. Every mistake is told with its line.
#include <filesystem>
#include <set>
#include <sstream>

#include "cli/compare.h"
#include "image/bytes.h"
#include "scene/wording.h"

namespace {

constexpr std::size_t kMostBytes = 64 << 20;  // more than anyone writes: a wrong file
constexpr std::string_view kBlanks = " \t\r";

/// The words of a line, quotes taken away. These may begin and end within a word, as in a shell:
/// a"b c"d is ab cd. There are no escapes. Throws UsageError where a quote is not closed.
std::vector<std::string> wordsOf(const std::string& line) {
  std::vector<std::string> words;
  std::size_t at = 0;
  while ((at = line.find_first_not_of(kBlanks, at)) != std::string::npos && line[at] != '#') {
    std::string& word = words.emplace_back();
    // Character by character up to a blank, but what is quoted as a whole.
    while (at < line.size() && kBlanks.find(line[at]) == std::string_view::npos) {
      const char c = line[at++];
      if (c != '\'' && c != '"') {
        word += c;
        continue;
      }
      const std::size_t end = line.find(c, at);
      refuseIf(end == std::string::npos, "expected a closing quote, found none");
      word += line.substr(at, end - at);
      at = end + 1;
    }
  }
  return words;
}

/// The command of a line with these words, in the table `path`. Scenes are looked up beside it,
/// wherever the program is called. Throws UsageError.
TableCommand readLine(const std::string& path, const std::string& line,
                      std::vector<std::string> words, const RunRequest& defaults) {
  const std::string picture = words[0];
  refuseIf(picture.empty(), "expected the name of a picture, found ''");
  refuseIf(picture[0] == '-' && picture != "-",
           "expected the name of a picture before the arguments, found ", ::quoted(picture));
  words.erase(words.begin());
  // Read as what it stands for; an -output that comes later would win over it, and is refused.
  if (picture != "-") words.insert(words.begin(), {"-output", picture});
  Request request = parseRequest(words, defaults);
  const ResultRequest& results = request.render.results;
  refuseIf(request.text != ProgramText::none || request.check || results.stats || results.pixel ||
               results.preview || request.compare.isWanted() || request.merge.isWanted(),
           "expected arguments that only render pictures");
  const OutputRequest* const output = results.find(OutputRequest::Kind::color);
  refuseIf(picture != "-" && output->file != picture,
           "-output: the line begins with the picture's name already");
  std::string& scene = request.render.picture.scene;
  refuseIf(scene == "-", "-input: expected a file, found '-'");
  scene = (std::filesystem::path(path).parent_path() / scene).string();
  return {line, request.render, request.run};
}

}  // namespace

std::vector<TableCommand> readCommandTable(const std::string& path, const RunRequest& defaults) {
  const Bytes bytes = readBytes(path);
  if (bytes.size() > kMostBytes) throw ImageError(path, "expected a table of at most 64 MB");
  std::istringstream lines(std::string(bytes.begin(), bytes.end()));
  std::vector<TableCommand> commands;
  std::set<std::string> pictures;  // of all lines: two of one name would have one partner
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number) {
    try {
      const std::vector<std::string> words = wordsOf(line);
      if (words.empty()) continue;
      commands.push_back(readLine(path, line, words, defaults));
      for (const OutputRequest& output : commands.back().render.results.outputs) {
        refuseIf(!pictures.insert(output.file).second, "expected a picture of a new name, found ",
                 ::quoted(output.file));
      }
    } catch (const UsageError& error) {
      throw UsageError(path + ":" + std::to_string(number) + ": " + error.what());
    }
  }
  return commands;
}
