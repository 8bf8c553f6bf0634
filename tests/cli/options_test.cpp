// The command line: every argument, its limits, and the texts that list them.
#include "cli/options.h"

#include <algorithm>
#include <filesystem>
#include <sstream>

#include "check.h"
#include "cli/option_table.h"
#include "run_program.h"

namespace {

using Words = std::vector<std::string>;

/// Parses a complete command that also has `words`.
Options parse(const Words& words) {
  const std::string name =
      words.empty() ? ""
                    : words[0].substr(std::min(words[0].size(), words[0].find_first_not_of('-')));
  const OptionRow* row = findOption(name);
  Words all = {"-input", "scene.txt", "-output", "out.tga"};
  if (row && row->mode == OptionRow::Mode::comparing) all = {"-compare", "a.tga", "b.tga"};
  all.insert(all.end(), words.begin(), words.end());
  return parseOptions(all);
}

/// The message for a wrong command that begins with `words`; "" where it is right.
std::string mistake(const Words& words) {
  try {
    parse(words);
  } catch (const UsageError& error) {
    return error.what();
  }
  return "";
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

Words split(const std::string& text) {
  std::istringstream in(text);
  return {std::istream_iterator<std::string>(in), std::istream_iterator<std::string>()};
}

/// The words that must be given beside an argument.
Words companionsOf(const OptionRow& row) {
  const bool drawsGrid = std::string(row.name).rfind("visualize_grid", 0) == 0;
  return drawsGrid ? Words{"-grid", "2", "2", "2"} : Words();
}

/// Right words for an argument, from the names that the table gives them.
Words sampleWords(const OptionRow& row) {
  Words words = split(row.words);
  for (std::string& word : words) {
    if (word == "FILE") word = "file";
    if (word == "NAME") word = "tree";
    if (word == "LEVEL") word = "avx2";
    const std::string numbers = " MB MIN N W H E NX NY NZ P R SIGMA TOLERANCE ZOOM ";
    if (numbers.find(" " + word + " ") != std::string::npos) word = "1";
    if (word == "MAX") word = "2";
  }
  return words;
}

}  // namespace

TEST("the course's exact command") {
  const Options o = parseOptions(split("-input scene.txt -output out.tga -bounces 5 -weight 0.01"));
  CHECK_EQUAL(o.input, "scene.txt");
  CHECK_EQUAL(o.output, "out.tga");
  CHECK_EQUAL(o.render.maxBounces, 5);
  CHECK_EQUAL(o.render.minWeight, 0.01f);
}

TEST("defaults are those of the contract, and those that the table tells") {
  const Options o = parse({});
  CHECK_EQUAL(o.width, 100);
  CHECK_EQUAL(o.height, 100);
  CHECK(o.depthOutput.empty() && o.normalsOutput.empty());
  CHECK_EQUAL(o.render.maxBounces, 5);
  CHECK_EQUAL(o.render.minWeight, 0.01f);
  CHECK(o.render.shadows && !o.render.transparentShadows && !o.render.shadeBack);
  CHECK(o.render.epsilon.kind == Epsilon::Kind::automatic);
  CHECK_EQUAL(o.threads, 0);
  CHECK(o.accel == Options::Accel::fast);
  CHECK(o.simd == SimdLevel::automatic);
  CHECK(!o.quiet && !o.stats && !o.check && !o.help && !o.version);
  CHECK_EQUAL(findOption("size")->defaultWords, std::string("100 100"));
  CHECK_EQUAL(findOption("bounces")->defaultWords, std::string("5"));
  CHECK_EQUAL(findOption("weight")->defaultWords, std::string("0.01"));
  CHECK_EQUAL(findOption("accel")->defaultWords, std::string("fast"));
  CHECK_EQUAL(findOption("simd")->defaultWords, std::string("auto"));
}

TEST("limits in the help are the limits of the parser") {
  CHECK(contains(findOption("bounces")->help, "to " + std::to_string(kMaxBounces)));
  CHECK(contains(findOption("threads")->help, "to " + std::to_string(kMaxThreads)));
  CHECK(contains(findOption("size")->help, "to " + std::to_string(kMaxImageSide)));
  CHECK(contains(findOption("grid")->help, "to " + std::to_string(kMaxGridSide)));
  CHECK(contains(findOption("grid")->help, "most " + std::to_string(kMaxGridCells)));
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
                           "csv"})
    CHECK(findOption(name) != nullptr);
}

TEST("every argument of the table is read under each name with one dash or two") {
  for (const OptionRow& row : optionTable()) {
    for (const char* name : {row.name, row.otherName}) {
      if (!name) continue;
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
  for (const OptionRow& row : optionTable()) {
    if (countWords(row) == 0) continue;
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
  std::istringstream lines(list);
  std::string line;
  while (std::getline(lines, line)) CHECK(line.size() <= 80);
  for (const OptionRow& row : optionTable()) {
    const std::string name = std::string("\n  -") + row.name;
    const std::string entry = name + (*row.words ? std::string(" ") + row.words : "");
    CHECK(contains(list, entry));
    CHECK(contains(fullHelp(), entry));
    if (row.otherName) CHECK(contains(list, std::string(", -") + row.otherName));
  }
}

TEST("the short help has lines of at most 80 columns and names every argument and group once") {
  std::istringstream lines(shortHelp());
  std::string line;
  while (std::getline(lines, line)) CHECK(line.size() <= 80);
  const Words words = split(shortHelp().substr(shortHelp().find("\n\n")));
  for (const OptionRow& row : optionTable()) {
    CHECK_EQUAL(std::count(words.begin(), words.end(), std::string("-") + row.name), 1);
    CHECK(contains(shortHelp(), std::string("\n  ") + row.group));
  }
}

TEST("the rows of one group stand together") {
  std::vector<std::string> groups;
  for (const OptionRow& row : optionTable()) {
    if (groups.empty() || groups.back() != row.group) groups.push_back(row.group);
  }
  std::sort(groups.begin(), groups.end());
  CHECK(std::adjacent_find(groups.begin(), groups.end()) == groups.end());
}

TEST("README.txt shows the same list of arguments as -help") {
  const std::string readme = check::contentOf(check::testsFolder() + "/../README.txt");
  CHECK(contains(readme, optionList()));
  CHECK(contains(fullHelp(), optionList()));
  CHECK(contains(readme, "raytracer -input scene.txt -output out.tga -bounces 5 -weight 0.01"));
}

TEST("README.txt is plain ASCII with lines of at most 80 columns") {
  std::istringstream lines(check::contentOf(check::testsFolder() + "/../README.txt"));
  std::string line;
  const auto isPlain = [](char c) { return c >= ' ' && c <= '~'; };
  while (std::getline(lines, line)) {
    const bool isGood = line.size() <= 80 && std::all_of(line.begin(), line.end(), isPlain);
    CHECK_EQUAL(isGood ? "" : line, "");
  }
}

TEST("the version is that of CMakeLists.txt") {
  const std::string build = check::contentOf(check::testsFolder() + "/../CMakeLists.txt");
  CHECK(contains(build, "project(raytracer VERSION " + split(versionText())[1] + " "));
}

TEST("arguments come in any order and the last of two equal ones wins") {
  const Options o =
      parseOptions(split("-bounces 1 -output a --size 3 4 -input b -bounces 2 -size 5 6"));
  CHECK_EQUAL(o.input, "b");
  CHECK_EQUAL(o.output, "a");
  CHECK_EQUAL(o.render.maxBounces, 2);
  CHECK_EQUAL(o.width, 5);
  CHECK_EQUAL(o.height, 6);
  CHECK(!parse({"-shadows", "-no_shadows"}).render.shadows);
  CHECK(parse({"-no_shadows", "-shadows"}).render.shadows);
  CHECK(parse(split("-epsilon 1 -epsilon adaptive")).render.epsilon.kind ==
        Epsilon::Kind::adaptive);
}

TEST("whole numbers are accepted from the first to the last of their range and not beyond") {
  CHECK_EQUAL(parse({"-bounces", "0"}).render.maxBounces, 0);
  CHECK_EQUAL(parse({"-bounces", "10000"}).render.maxBounces, 10000);
  CHECK_EQUAL(parse({"-threads", "1"}).threads, 1);
  CHECK_EQUAL(parse({"-threads", "1024"}).threads, 1024);
  CHECK_EQUAL(parse({"-size", "1", "65535"}).width, 1);
  CHECK_EQUAL(parse({"-size", "1", "65535"}).height, 65535);
  for (const char* wrong :
       {"-bounces -1", "-bounces 10001", "-threads 0", "-threads 1025", "-size 0 1", "-size 1 0",
        "-size 65536 1", "-size 1 65536", "-bounces 99999999999999999999", "-bounces 4294967296"})
    CHECK(contains(mistake(split(wrong)), "expected a whole number from"));
}

TEST("a number must fill its whole word") {
  for (const std::string wrong : {"5x", "x", "", " 5", "5 ", "nan", "inf", "0x10", "5..1", "--5"}) {
    CHECK(contains(mistake({"-bounces", wrong}), "found '" + wrong + "'"));
    CHECK(contains(mistake({"-weight", wrong}), "found '" + wrong + "'"));
    CHECK(contains(mistake({"-epsilon", wrong}), "found '" + wrong + "'"));
    CHECK(contains(mistake({"-depth", "1", wrong, "f"}), "found '" + wrong + "'"));
  }
  CHECK(contains(mistake({"-bounces", "1.5"}), "a whole number"));
}

TEST("weights are at least 0, overflow is a mistake and underflow gives 0") {
  CHECK_EQUAL(parse({"-weight", "0"}).render.minWeight, 0.0f);
  CHECK_EQUAL(parse({"-weight", "2.5e1"}).render.minWeight, 25.0f);
  CHECK_EQUAL(parse({"-weight", "1e-999"}).render.minWeight, 0.0f);
  CHECK(contains(mistake({"-weight", "-0.1"}), "at least 0"));
  CHECK(contains(mistake({"-weight", "1e39"}), "found '1e39'"));  // float ends at 3.4e38
  CHECK(contains(mistake({"-epsilon", "1e309"}), "found '1e309'"));
}

TEST("epsilon is a number, course or adaptive") {
  CHECK(parse({"-epsilon", "course"}).render.epsilon.kind == Epsilon::Kind::fixed);
  CHECK_EQUAL(parse({"-epsilon", "course"}).render.epsilon.value, 0.001);
  CHECK(parse({"-epsilon", "adaptive"}).render.epsilon.kind == Epsilon::Kind::adaptive);
  CHECK(parse({"-epsilon", "0.25"}).render.epsilon.kind == Epsilon::Kind::fixed);
  CHECK_EQUAL(parse({"-epsilon", "0.25"}).render.epsilon.value, 0.25);
  CHECK_EQUAL(parse({"-epsilon", "0"}).render.epsilon.value, 0.0);
  CHECK(contains(mistake({"-epsilon", "-1"}), "adaptive"));
  CHECK(contains(mistake({"-epsilon", "corse"}), "found 'corse'"));
}

TEST("the depth image takes MIN MAX FILE or FILE MIN MAX") {
  for (const char* order : {"-depth -8 12.5 d.tga", "-depth d.tga -8 12.5"}) {
    const Options o = parse(split(order));
    CHECK_EQUAL(o.depthOutput, "d.tga");
    CHECK_EQUAL(o.depthMin, -8.0);
    CHECK_EQUAL(o.depthMax, 12.5);
  }
  CHECK_EQUAL(parse(split("-depth 1 2 3")).depthOutput, "3");
  CHECK_EQUAL(parse(split("-depth 1x 2 3")).depthOutput, "1x");
  CHECK_EQUAL(parse(split("-depth 12 8 d.tga")).depthMin, 12.0);
  CHECK(contains(mistake(split("-depth 8 8.0 d.tga")), "differ"));
  CHECK(contains(mistake(split("-depth d.tga 8 8")), "differ"));
  CHECK(contains(mistake(split("-depth d.tga e.tga 8")), "found 'e.tga'"));
  CHECK(contains(mistake(split("-depth 8 d.tga 12")), "found 'd.tga'"));
  CHECK(contains(mistake(split("-depth 1e999 8 d.tga")), "for MIN"));  // too large, but a number
}

TEST("accel is fast or tree") {
  CHECK(parse({"-accel", "tree"}).accel == Options::Accel::tree);
  CHECK(parse({"-accel", "tree", "-accel", "fast"}).accel == Options::Accel::fast);
  CHECK(contains(mistake({"-accel", "slow"}), "expected fast or tree, found 'slow'"));
  CHECK(contains(mistake({"-accel", "fsat"}), "found 'fsat'; did you mean 'fast'?"));
}

TEST("simd is auto, baseline, avx2 or avx512") {
  CHECK(parse({"-simd", "baseline"}).simd == SimdLevel::baseline);
  CHECK(parse({"-simd", "avx2"}).simd == SimdLevel::avx2);
  CHECK(parse({"-simd", "avx512"}).simd == SimdLevel::avx512);
  CHECK(parse({"-simd", "avx2", "-simd", "auto"}).simd == SimdLevel::automatic);
  CHECK(contains(mistake({"-simd", "sse"}),
                 "-simd: expected auto, baseline, avx2 or avx512, found 'sse'"));
}

TEST("an unknown argument is answered with the nearest one") {
  CHECK(contains(mistake({"-bounce", "5"}), "did you mean '-bounces'?"));
  CHECK(contains(mistake({"--noshadows"}), "did you mean '-no_shadows'?"));
  CHECK(contains(mistake({"-wieght", "1"}), "did you mean '-weight'?"));
  CHECK(contains(mistake({"-szie", "4", "4"}), "did you mean '-size'?"));
  CHECK(contains(mistake({"-zzzzzzzz"}), "unknown argument '-zzzzzzzz'; 'raytracer -help'"));
  CHECK(contains(mistake({"---quiet"}), "unknown argument"));
  CHECK(contains(mistake({"scene.txt"}), "found 'scene.txt'"));
  CHECK(contains(mistake({""}), "found ''"));
  CHECK(contains(mistake({"-"}), "found '-'"));
}

TEST("a scene and something to do with it are needed") {
  const auto message = [](const char* words) {
    try {
      parseOptions(split(words));
    } catch (const UsageError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  CHECK(contains(message("-output out.tga"), "-input"));
  CHECK(contains(message("-input scene.txt"),
                 "-output, -depth, -normals, -render_samples, -render_filter, -preview, -stats and -check"));
  for (const char* enough : {"-check", "-stats", "-output a", "-depth 1 2 a", "-normals a",
                             "-normal a", "-render_samples a 2", "-render_filter a 2"})
    CHECK_EQUAL(message((std::string("-input scene.txt ") + enough).c_str()), "");
  CHECK_EQUAL(message(""), "");
  CHECK_EQUAL(message("-help"), "");
  CHECK_EQUAL(message("--help"), "");
  CHECK_EQUAL(message("-version"), "");
  CHECK(parseOptions({}).shortHelp);
}

TEST("file names must not be empty, and a dash is standard input or output") {
  CHECK(contains(mistake({"-input", ""}), "a file name"));
  CHECK(contains(mistake({"-output", ""}), "a file name"));
  CHECK(contains(mistake({"-depth", "", "1", "2"}), "a file name"));
  CHECK(contains(mistake({"-checkpoint", ""}), "a file name"));
  CHECK(contains(mistake({"-checkpoint", "-"}), "found '-'"));
  CHECK_EQUAL(parse({"-output", "-"}).output, "-");
  CHECK_EQUAL(parse({"-normals", "-"}).normalsOutput, "-");
  CHECK_EQUAL(parse({"-depth", "-", "1", "2"}).depthOutput, "-");
  CHECK_EQUAL(parse({"-input", "-"}).input, "-");
  CHECK_EQUAL(parse({"-output", "-strange"}).output, "-strange");
}

TEST("two arguments must not name the same file") {
  const check::ScratchFolder folder;
  const std::string scene = folder.write("scene.txt", ""), dir = folder.path() + "/";
  std::filesystem::create_symlink("scene.txt", folder.file("link.txt"));
  std::filesystem::create_symlink("new", folder.file("to_new"));
  std::filesystem::create_hard_link(scene, folder.file("other_name"));
  const auto clash = [&](const std::string& input, const Words& words) {
    Words all = {"-input", input};
    all.insert(all.end(), words.begin(), words.end());
    const Options options = parseOptions(all);
    try {
      checkFiles(options);
    } catch (const UsageError&) {
      return true;
    }
    return false;
  };
  CHECK(
      !clash(scene, {"-output", dir + "a", "-normals", dir + "b", "-depth", "1", "2", dir + "c"}));
  CHECK(clash(scene, {"-output", scene}));
  CHECK(clash(scene, {"-output", dir + "./scene.txt"}));
  CHECK(clash(scene, {"-normals", dir + "link.txt"}));
  CHECK(clash(scene, {"-normals", dir + "other_name"}));
  CHECK(clash(scene, {"-output", dir + "a", "-normals", dir + "a"}));
  CHECK(clash(scene, {"-output", dir + "new", "-normals", dir + "to_new"}));
  CHECK(clash("-", {"-depth", "a", "1", "2", "-normals", "./a"}));
  CHECK(!clash(scene, {"-output", "/dev/null", "-normals", "/dev/null"}));
  CHECK(clash(scene, {"-output", "-", "-normals", "-"}));
  CHECK(!clash("-", {"-output", "-"}));
  CHECK(clash(scene, {"-output", dir + "a", "-checkpoint", dir + "a"}));
  CHECK(clash(scene, {"-output", dir + "a", "-checkpoint", scene}));
}
