// A table of commands.
#include "cli/command_table.h"

#include <filesystem>
#include <set>
#include <sstream>

#include "image/bytes.h"
#include "scene/wording.h"

namespace {

constexpr std::size_t kMostBytes = 64 << 20;

bool isBlank(char c) { return c == ' ' || c == '\t' || c == '\r'; }

/// The words of a line, quotes taken away. Throws UsageError where a quote is not closed.
std::vector<std::string> wordsOf(const std::string& line) {
  std::vector<std::string> words;
  for (std::size_t at = 0; at < line.size();) {
    if (isBlank(line[at])) {
      ++at;
      continue;
    }
    if (line[at] == '#') break;
    std::string word;
    for (; at < line.size() && !isBlank(line[at]); ++at) {
      if (line[at] != '\'' && line[at] != '"') {
        word += line[at];
        continue;
      }
      const std::size_t end = line.find(line[at], at + 1);
      if (end == std::string::npos) throw UsageError("expected a closing quote, found none");
      word += line.substr(at + 1, end - at - 1);
      at = end;
    }
    words.push_back(word);
  }
  return words;
}

std::string beside(const std::string& table, const std::string& file) {
  if (file.empty() || file == "-") return file;
  return (std::filesystem::path(table).parent_path() / file).string();
}

TableCommand readLine(const std::string& path, int number, const std::string& line,
                      std::vector<std::string> words, const RunRequest& defaults) {
  const std::string picture = words[0];
  if (picture[0] == '-' && picture != "-") {
    throw UsageError("expected the name of a picture before the arguments, found " +
                     ::quoted(picture));
  }
  words.erase(words.begin());
  if (picture != "-") words.insert(words.begin(), {"-output", picture});
  Request request = parseRequest(words, defaults);
  const ResultRequest& results = request.render.results;
  if (request.text != ProgramText::none || request.check || results.stats || results.pixel ||
      results.preview || request.compare.isWanted() || request.merge.isWanted()) {
    throw UsageError("expected arguments that only render pictures");
  }
  const OutputRequest* const output = results.find(OutputRequest::Kind::color);
  if (picture != "-" && output->file != picture) {
    throw UsageError("-output: the line begins with the picture's name already");
  }
  std::string& scene = request.render.picture.scene;
  if (scene == "-") throw UsageError("-input: expected a file, found '-'");
  scene = beside(path, scene);
  return {number, line, request.render, request.run};
}

}  // namespace

std::vector<TableCommand> readCommandTable(const std::string& path, const RunRequest& defaults) {
  const Bytes bytes = readBytes(path);
  if (bytes.size() > kMostBytes) throw ImageError(path, "expected a table of at most 64 MB");
  std::istringstream lines(std::string(bytes.begin(), bytes.end()));
  std::vector<TableCommand> commands;
  std::set<std::string> pictures;
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number) {
    try {
      const std::vector<std::string> words = wordsOf(line);
      if (words.empty()) continue;
      if (words[0].empty()) throw UsageError("expected the name of a picture, found ''");
      commands.push_back(readLine(path, number, line, words, defaults));
      for (const OutputRequest& output : commands.back().render.results.outputs) {
        if (!pictures.insert(output.file).second) {
          throw UsageError("expected a picture of a new name, found " + ::quoted(output.file));
        }
      }
    } catch (const UsageError& error) {
      throw UsageError(path + ":" + std::to_string(number) + ": " + error.what());
    }
  }
  return commands;
}
