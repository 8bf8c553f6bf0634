// The texts that are made from the table of arguments.
#include "cli/arguments.h"

namespace {

constexpr const char* kVersion = "1.0";
constexpr const char* kCourseCommand =
    "  raytracer -input scene.txt -output out.tga -bounces 5 -weight 0.01\n";
constexpr std::size_t kTextColumn = 25;  // where the help text begins
constexpr std::size_t kWidth = 80;

/// Appends `text` to `list`, whose last line has `column` columns, broken at blanks so that every
/// line starts at kTextColumn and ends by kWidth.
void appendWrapped(std::string& list, std::size_t column, const std::string& text) {
  if (column + 1 > kTextColumn) {
    list += '\n';
    column = 0;
  }
  list.append(kTextColumn - column, ' ');
  std::size_t start = 0;
  while (text.size() - start > kWidth - kTextColumn) {
    const std::size_t end = text.rfind(' ', start + kWidth - kTextColumn);
    list += text.substr(start, end - start) + "\n" + std::string(kTextColumn, ' ');
    start = end + 1;
  }
  list += text.substr(start) + "\n";
}

std::string heading(const ArgumentRow& row) {
  const std::string words = *row.words ? std::string(" ") + row.words : "";
  std::string text = std::string("  -") + row.name + words;
  if (row.otherName) text += std::string(", -") + row.otherName + words;
  return text;
}

}  // namespace

std::string optionList() {
  std::string list, group;
  for (const ArgumentRow& row : argumentTable()) {
    if (group != row.group) list += (group.empty() ? "" : "\n") + std::string(row.group) + ":\n";
    group = row.group;
    const std::string left = heading(row);
    list += left;
    const std::string ending =
        row.defaultWords ? std::string(" (default: ") + row.defaultWords + ")" : "";
    appendWrapped(list, left.size(), row.help + ending);
  }
  return list;
}

std::string shortHelp() {
  std::string text =
      "raytracer: renders a scene file to an image, for example\n" + std::string(kCourseCommand);
  const std::vector<ArgumentRow>& table = argumentTable();
  for (auto row = table.begin(); row != table.end();) {
    const std::string group = row->group;
    std::string names;
    for (; row != table.end() && group == row->group; ++row) {
      names += (names.empty() ? "-" : " -") + std::string(row->name);
    }
    text += "\n  " + group;
    appendWrapped(text, group.size() + 2, names);
    text.pop_back();
  }
  return text + "\n\n'raytracer -help' explains them all.\n";
}

std::string fullHelp() {
  return "raytracer: renders a scene file to an image, for example\n" +
         std::string(kCourseCommand) +
         "Arguments come in any order, with one dash or two; the last of two equal ones\n"
         "wins. -input, -compare or -merge is needed, and with -input at least one of\n"
         "-output, -depth, -normals, -render_samples, -render_filter, -materials,\n"
         "-heatmap, -pixel, -preview, -stats and -check.\n\n" +
         optionList() +
         "\nExit status: 0 done, 1 an output failed, 2 wrong usage, 3 the scene or a mesh\n"
         "is at fault. Of -compare: 0 the same, 1 different, 2 wrong usage, 3 unreadable.\n"
         "Of -merge: 3 a part is at fault or missing.\n";
}

std::string versionText() { return std::string("raytracer ") + kVersion; }
