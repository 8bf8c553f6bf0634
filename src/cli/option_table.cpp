// The table of all arguments, and the texts made from it.
#include "cli/option_table.h"

#include "cli/option_values.h"
#include "scene/wording.h"

namespace {

constexpr const char* kVersion = "1.0";
constexpr const char* kCourseCommand =
    "  raytracer -input scene.txt -output out.tga -bounces 5 -weight 0.01\n";
constexpr std::size_t kTextColumn = 25;  // where the help text begins
constexpr std::size_t kWidth = 80;

void setAccel(const GivenOption& given, Options& options) {
  if (given.words[0] != "fast" && given.words[0] != "tree")
    throw UsageError("-accel: expected fast or tree, found " + ::quoted(given.words[0]));
  options.accel = given.words[0] == "fast" ? Options::Accel::fast : Options::Accel::tree;
}

void setEpsilon(const GivenOption& given, Options& options) {
  Epsilon& epsilon = options.render.epsilon;
  epsilon.value = Epsilon::kCourse;
  if (given.words[0] == "adaptive") {
    epsilon.kind = Epsilon::Kind::adaptive;
    return;
  }
  epsilon.kind = Epsilon::Kind::fixed;
  if (given.words[0] == "course") return;
  epsilon.value = positiveNumber(given, ", course or adaptive");
}

std::vector<OptionRow> makeTable() {
  using Given = const GivenOption&;
  const char* group = "Files";
  std::vector<OptionRow> table = {
      {group, "input", nullptr, "FILE", nullptr,
       "scene to read (always needed); - is standard input",
       [](Given given, Options& o) { o.input = inputName(given); }},
      {group, "output", nullptr, "FILE", nullptr,
       "image to write; the ending picks the format, TGA where it is missing or unknown",
       [](Given given, Options& o) { o.output = outputName(given); }},
      {group, "size", nullptr, "W H", "100 100", "image size, 1 to 65535 pixels each",
       [](Given given, Options& o) {
         o.width = wholeNumber(given, 0, "W", 1, kMaxImageSide);
         o.height = wholeNumber(given, 1, "H", 1, kMaxImageSide);
       }},
      {group, "depth", nullptr, "MIN MAX FILE", nullptr,
       "write the depth image, white at distance MIN and black at MAX; FILE MIN MAX, where FILE "
       "does not look like a number, means the same",
       readDepth},
      {group, "normals", "normal", "FILE", nullptr,
       "write the normal image: red, green, blue are |x|, |y|, |z| of the surface normal",
       [](Given given, Options& o) { o.normalsOutput = outputName(given); }},
      {group, "check", nullptr, "", nullptr,
       "render nothing: read the scene and its meshes and report every mistake",
       [](Given, Options& o) { o.check = true; }},
  };

  group = "Light";
  const std::vector<OptionRow> light = {
      {group, "bounces", nullptr, "N", "5",
       "the most mirror or refracted rays in a row, 0 (none) to 10000",
       [](Given given, Options& o) {
         o.render.maxBounces = wholeNumber(given, 0, "N", 0, kMaxBounces);
       }},
      {group, "weight", nullptr, "W", "0.01",
       "mirror and refracted rays whose part in the pixel would be below W are not traced; W is at "
       "least 0",
       [](Given given, Options& o) { o.render.minWeight = positiveFloat(given); }},
      {group, "shadows", nullptr, "", "on", "cast shadow rays",
       [](Given, Options& o) { o.render.shadows = true; }},
      {group, "no_shadows", nullptr, "", nullptr, "cast no shadow rays",
       [](Given, Options& o) { o.render.shadows = false; }},
      {group, "transparent_shadows", nullptr, "", nullptr,
       "transparent objects tint and dim the light instead of blocking it",
       [](Given, Options& o) { o.render.transparentShadows = true; }},
      {group, "shade_back", nullptr, "", nullptr, "light both sides of every surface",
       [](Given, Options& o) { o.render.shadeBack = true; }},
      {group, "epsilon", nullptr, "E", nullptr,
       "how far from its origin a secondary or shadow ray starts looking: a number of at least 0; "
       "course, which is 0.001; or adaptive, from the size of the numbers at the hit (default: "
       "course where the bounded objects together span 1 to 1000 units, else adaptive)",
       setEpsilon},
  };

  group = "Running";
  const std::vector<OptionRow> running = {
      {group, "threads", nullptr, "N", nullptr,
       "worker threads, 1 to 1024; the image never depends on it (default: all cores)",
       [](Given given, Options& o) { o.threads = wholeNumber(given, 0, "N", 1, kMaxThreads); }},
      {group, "accel", nullptr, "NAME", "fast",
       "fast, or tree: the plain object tree, for checking", setAccel},
      {group, "quiet", nullptr, "", nullptr, "no warnings, no progress",
       [](Given, Options& o) { o.quiet = true; }},
      {group, "help", nullptr, "", nullptr, "print this list",
       [](Given, Options& o) { o.help = true; }},
      {group, "version", nullptr, "", nullptr, "print the version",
       [](Given, Options& o) { o.version = true; }},
  };
  table.insert(table.end(), light.begin(), light.end());
  table.insert(table.end(), running.begin(), running.end());
  return table;
}

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

std::string heading(const OptionRow& row) {
  const std::string words = *row.words ? std::string(" ") + row.words : "";
  std::string text = std::string("  -") + row.name + words;
  if (row.otherName) text += std::string(", -") + row.otherName + words;
  return text;
}

}  // namespace

const std::vector<OptionRow>& optionTable() {
  static const std::vector<OptionRow> table = makeTable();
  return table;
}

const OptionRow* findOption(const std::string& name) {
  for (const OptionRow& row : optionTable())
    if (name == row.name || (row.otherName && name == row.otherName)) return &row;
  return nullptr;
}

int countWords(const OptionRow& row) {
  if (!*row.words) return 0;
  int count = 1;
  for (const char* c = row.words; *c; ++c) count += *c == ' ';
  return count;
}

std::string optionList() {
  std::string list, group;
  for (const OptionRow& row : optionTable()) {
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
  return "raytracer: renders a scene file to an image, for example\n" +
         std::string(kCourseCommand) + "'raytracer -help' lists all arguments.\n";
}

std::string fullHelp() {
  return "raytracer: renders a scene file to an image, for example\n" +
         std::string(kCourseCommand) +
         "Arguments come in any order, with one dash or two; the last of two equal ones\n"
         "wins. At least one of -output, -depth, -normals or -check is needed.\n\n" +
         optionList() +
         "\nExit status: 0 done, 1 an output failed, 2 wrong usage, 3 the scene or a mesh\n"
         "is at fault.\n";
}

std::string versionText() { return std::string("raytracer ") + kVersion; }
