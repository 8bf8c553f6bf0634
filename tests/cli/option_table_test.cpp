// The table of all arguments, and the texts that list them.
#include "check.h"
#include "cli/arguments.h"
#include "cli/command_words.h"
#include "run_program.h"

using check::contains, check::mistake, check::split, check::Words;

namespace {

/// The words that must be given beside an argument.
Words companionsOf(const ArgumentRow& row) {
  const bool drawsGrid = row.name.rfind("visualize_grid", 0) == 0;
  const bool isIdle = row.name == "gui" || row.name == "gouraud" || row.name == "tessellation";
  if (isIdle) return {"-course", "2004"};
  if (row.name == "jitter" || row.name == "filter") return {"-course", "2012"};
  if (row.name == "pixel_obj") return {"-pixel", "1", "1"};
  return drawsGrid ? Words{"-grid", "2", "2", "2"} : Words();
}

/// Right words for an argument, from the names that the table gives them.
Words sampleWords(const ArgumentRow& row) {
  Words words = split(row.words);
  for (std::string& word : words) {
    if (word == "FILE") word = "file";
    if (word == "[TOPIC]") word = "scene";
    if (word == "NAME") word = "tree";
    if (word == "LEVEL") word = "avx2";
    if (word == "COURSE") word = "2004";
    const std::string numbers = " MB MIN N I W H E NX NY NZ P R SIGMA TOLERANCE ZOOM A B ";
    if (numbers.find(" " + word + " ") != std::string::npos) word = "1";
    if (word == "X" || word == "Y") word = "0";
    if (word == "NX" || word == "NY" || word == "NZ") word = "3";
    if (word == "MAX") word = "2";
  }
  return words;
}

}  // namespace

TEST("limits in the help are the limits of the parser") {
  CHECK(contains(findArgument("bounces")->help, "to " + std::to_string(kMaxBounces)));
  CHECK(contains(findArgument("threads")->help, "to " + std::to_string(kMaxThreads)));
  CHECK(contains(findArgument("size")->help, "to " + std::to_string(kMaxImageSide)));
  CHECK(contains(findArgument("grid")->help, "to " + std::to_string(kMaxGridSide)));
  CHECK(contains(findArgument("grid")->help, "most " + std::to_string(kMaxGridCells)));
}

TEST("the table is what the list of -help says") {
  const std::string list = optionList();
  std::size_t entries = 0;
  for (std::size_t at = 0; (at = list.find("\n  -", at)) != std::string::npos; ++at) ++entries;
  CHECK_EQUAL(argumentTable().size(), entries);
  for (const ArgumentRow& row : argumentTable()) {
    CHECK(!row.help.empty() && row.help.back() != ' ' && !contains(row.help, "  "));
    CHECK_EQUAL(row.action->name, row.name);
    CHECK_EQUAL(findArgument(row.name), &row);
  }
  // The text begins in the line below, behind one blank, and behind a second spelling.
  const ArgumentRow& adaptive = *findArgument("adaptive_samples");
  CHECK_EQUAL(adaptive.words, "MIN MAX TOLERANCE");
  CHECK_EQUAL(adaptive.help.substr(0, 17), "MIN jittered rays");
  const ArgumentRow& gaussian = *findArgument("gaussian_filter");
  CHECK_EQUAL(gaussian.words, "SIGMA");
  CHECK_EQUAL(gaussian.help.substr(0, 7), "samples");
  CHECK_EQUAL(gaussian.group, "Samples in a pixel");
  const ArgumentRow& normals = *findArgument("normal");
  CHECK_EQUAL(normals.name + "|" + normals.otherName + "|" + normals.words, "normals|normal|FILE");
  CHECK_EQUAL(normals.help.substr(0, 9), "write the");
  CHECK_EQUAL(findArgument("stats")->words, "");
}

TEST("every argument of the contract is in the table") {
  for (const char* name : {"input",
                           "output",
                           "size",
                           "depth",
                           "normals",
                           "normal",
                           "bounces",
                           "weight",
                           "shadows",
                           "no_shadows",
                           "transparent_shadows",
                           "shade_back",
                           "nested_dielectrics",
                           "fresnel",
                           "epsilon",
                           "threads",
                           "accel",
                           "grid",
                           "visualize_grid",
                           "visualize_grid_count",
                           "simd",
                           "stats",
                           "quiet",
                           "check",
                           "help",
                           "version",
                           "compare",
                           "tolerance",
                           "fail_percent",
                           "csv",
                           "region",
                           "tile",
                           "merge"})
    CHECK(findArgument(name) != nullptr);
}

TEST("every argument of the table is read under each name with one dash or two") {
  for (const ArgumentRow& row : argumentTable()) {
    for (const std::string& name : {row.name, row.otherName}) {
      if (name.empty()) continue;
      for (const char* dashes : {"-", "--"}) {
        Words words = sampleWords(row);
        words.insert(words.begin(), std::string(dashes) + name);
        for (const std::string& word : companionsOf(row)) words.push_back(word);
        CHECK_EQUAL(mistake(words), "");
      }
    }
  }
}

TEST("every argument that misses its last word is a mistake that names it") {
  for (const ArgumentRow& row : argumentTable()) {
    if (row.leastWords == 0) continue;
    Words words = sampleWords(row);
    words.insert(words.begin(), std::string("-") + row.name);
    words.pop_back();
    CHECK(contains(mistake(words), std::string("-") + row.name + ": expected " + row.words));
    words.push_back("-quiet");
    CHECK(contains(mistake(words), "found '-quiet'"));
  }
}

TEST("the list of arguments has lines of at most 80 columns and names every argument once") {
  const std::string list = optionList();
  std::istringstream lines(fullHelp());
  std::string line;
  while (std::getline(lines, line)) CHECK(line.size() <= 80);
  for (const ArgumentRow& row : argumentTable()) {
    const std::string name = std::string("\n  -") + row.name;
    const std::string entry = name + (row.words.empty() ? "" : " " + row.words);
    CHECK(contains(list, entry));
    CHECK(contains(fullHelp(), entry));
    if (!row.otherName.empty()) CHECK(contains(list, std::string(", -") + row.otherName));
  }
}

TEST("the short help has lines of at most 80 columns and names every argument and group once") {
  std::istringstream lines(shortHelp());
  std::string line;
  while (std::getline(lines, line)) CHECK(line.size() <= 80);
  // Between the first paragraph, an example, and the last, which names more help.
  const std::size_t start = shortHelp().find("\n\n");
  const Words words = split(shortHelp().substr(start, shortHelp().rfind("\n\n") - start));
  for (const ArgumentRow& row : argumentTable()) {
    CHECK_EQUAL(std::count(words.begin(), words.end(), std::string("-") + row.name), 1);
    CHECK(contains(shortHelp(), std::string("\n  ") + row.group));
  }
}

TEST("the rows of one group stand together") {
  std::vector<std::string> groups;
  for (const ArgumentRow& row : argumentTable()) {
    if (groups.empty() || groups.back() != row.group) groups.push_back(row.group);
  }
  std::sort(groups.begin(), groups.end());
  CHECK(std::adjacent_find(groups.begin(), groups.end()) == groups.end());
}

TEST("README.txt and -help list the same topics, and the course's command") {
  const std::string readme = check::contentOf(check::testsFolder() + "/../README.txt");
  for (const std::string& text : {readme, fullHelp()}) {
    CHECK(contains(text, topicList()));
    CHECK(contains(text, "raytracer -input scene.txt -output out.tga -bounces 5 -weight 0.01"));
  }
  CHECK(contains(fullHelp(), optionList()));
}

TEST("README.txt has at most 300 lines") {
  const std::string readme = check::contentOf(check::testsFolder() + "/../README.txt");
  CHECK(std::count(readme.begin(), readme.end(), '\n') <= 300);
}

TEST("both README.txt are plain ASCII with lines of at most 80 columns") {
  const auto isPlain = [](char c) { return c >= ' ' && c <= '~'; };
  for (const char* file : {"/README.txt", "/../README.txt"}) {
    std::istringstream lines(check::contentOf(check::testsFolder() + file));
    std::string line;
    while (std::getline(lines, line)) {
      const bool isGood = line.size() <= 80 && std::all_of(line.begin(), line.end(), isPlain);
      CHECK_EQUAL(isGood ? "" : line, "");
    }
  }
}

TEST("the version is that of CMakeLists.txt") {
  const std::string build = check::contentOf(check::testsFolder() + "/../CMakeLists.txt");
  CHECK(contains(build, "project(raytracer VERSION " + split(versionText())[1] + " "));
}
