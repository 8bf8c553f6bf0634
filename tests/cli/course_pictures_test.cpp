// The published pictures of other years, by the commands that are listed with them, where the
// reference folder is there.
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "check.h"
#include "cli/desk.h"
#include "image/picture_file.h"
#include "image_difference.h"

namespace {

/// A row of the list. Columns: picture, scene, arguments that reproduce it with OUT for the
/// picture, arguments on the page, kind, tolerance "difference,percent of pixels over it" or "-",
/// how near an independent tracer comes.
struct Row {
  std::string picture, scene, arguments, onPage, kind, tolerance, nearness;
};

std::vector<Row> readRows(const std::string& file) {
  std::vector<Row> rows;
  std::ifstream in(file);
  std::string line;
  std::getline(in, line);  // the heading
  while (std::getline(in, line)) {
    std::istringstream fields(line);
    Row row;
    for (std::string* field : {&row.picture, &row.scene, &row.arguments, &row.onPage, &row.kind,
                               &row.tolerance, &row.nearness}) {
      std::getline(fields, *field, '\t');
    }
    rows.push_back(row);
  }
  return rows;
}

std::string replaced(std::string text, const std::string& word, const std::string& by) {
  const std::size_t at = text.find(word);
  return at == std::string::npos ? text : text.replace(at, word.size(), by);
}

/// How many percent of the pixels differ by more than `level`; printed with the largest difference.
double percentOver(int level, const std::string& name, const ImageDifference& difference) {
  const double percent = 100.0 * double(difference.pixelsOver(level)) / double(difference.pixels());
  std::printf("  %-40s %7.3f %% over %d, max %d\n", name.c_str(), percent, level,
              difference.maximum());
  return percent;
}

void compare(const Row& row, const Image& ours, const Image& published) {
  const ImageDifference difference = compareImages(ours, published);
  int level = 0;
  double percent = 0;
  if (std::sscanf(row.tolerance.c_str(), "%d,%lf", &level, &percent) != 2) return;
  const double found = percentOver(level, row.picture, difference);
  if (row.nearness == "statistical" || row.nearness == "no") return;
  CHECK(found <= percent);
}

}  // namespace

TEST("the pictures of 2004 come out as published") {
  const std::string folder = check::referenceFolder() + "/courses/2004";
  if (!std::filesystem::is_directory(folder)) SKIP("no reference pictures here");
  const check::Desk desk;
  const std::vector<Row> rows = readRows(folder + "/commands.tsv");
  CHECK(rows.size() > 100);
  for (const Row& row : rows) {
    const std::string start = "-course 2004 -input " + folder + "/" + row.scene + " ";
    const check::ProgramRun run = desk.run(start + replaced(row.arguments, "OUT", "out.tga"));
    CHECK_EQUAL(run.status, 0);
    compare(row, readImage(desk.file("out.tga")), readImage(folder + "/pictures/" + row.picture));
    // As the page has it, only smaller; the scene named before is the one that was drawn.
    const std::size_t end = row.onPage.find(' ', std::string("-input ").size());
    CHECK_EQUAL(desk.run(start + row.onPage.substr(end) + " -size 9 9").status, 0);
  }
}

TEST("depths and normals of 2016 come out as published") {
  const std::string folder = check::referenceFolder() + "/courses/2016";
  if (!std::filesystem::is_directory(folder)) SKIP("no reference pictures here");
  const check::Desk desk;
  const struct {
    const char *scene, *picture;
  } rows[] = {{"scene01_plane", "a01d"}, {"scene02_cube", "a02n"}, {"scene03_sphere", "a03d"}};
  for (const auto& [scene, picture] : rows) {
    const std::string run = "-course 2016 -size 800 800 -input " + folder + "/" + scene + ".txt";
    CHECK_EQUAL(desk.run(run + " -normals n -depth 8 18 d").status, 0);
    const Image ours = readImage(desk.file({picture[3]}));
    const Image published = readImage(folder + "/pictures/" + picture + ".png");
    CHECK(percentOver(1, picture, compareImages(ours, published)) <= 0.02);
  }
}

TEST("the pictures of aalto come out as published by its list of commands") {
  const std::string folder = check::referenceFolder() + "/courses/aalto";
  if (!std::filesystem::is_directory(folder)) SKIP("no reference pictures here");
  const check::Desk desk;
  std::ifstream commands(folder + "/commands.txt");
  int count = 0;
  for (std::string line; std::getline(commands, line);) {
    // "call render_options assets\scenes\NAME.txt ARGUMENTS -depth MIN MAX"
    const std::size_t from = line.rfind('\\') + 1, to = line.find(".txt");
    if (from == 0 || to == std::string::npos) continue;
    const std::string name = line.substr(from, to - from);
    const std::string arguments = line.substr(to + 4, line.find('\r') - (to + 4));
    CHECK_EQUAL(desk.run("-course aalto -input '" + folder + "/scenes/" + name + ".txt'" +
                         arguments + " depth -output color -normals normals")
                    .status,
                0);
    for (const char* kind : {"color", "depth", "normals"}) {
      const std::string published = folder + "/pictures/" + name + "_" + kind + ".png";
      if (!std::filesystem::exists(published)) continue;
      // Rays along edges go either way: six of r9, 80 in the glass ball, one of its normals.
      const double most = name == "extra_glass_sphere" ? 0.2 : 0.02;
      const ImageDifference difference =
          compareImages(readImage(desk.file(kind)), readImage(published));
      CHECK(percentOver(1, name + "_" + kind, difference) <= most);
      ++count;
    }
  }
  CHECK(count > 30);
}

namespace {

/// A published picture: scene, arguments, and how much of it may be more than `level` off.
struct Published {
  const char *picture, *scene, *arguments;
  int level;
  double percent;
};

void checkPublished(const std::string& course, const std::string& folderName,
                    const std::vector<Published>& rows) {
  const std::string folder = check::referenceFolder() + "/courses/" + folderName;
  if (!std::filesystem::is_directory(folder)) SKIP("no reference pictures here");
  const check::Desk desk;
  for (const Published& row : rows) {
    const check::ProgramRun run = desk.run("-course " + course + " -input " + folder + "/" +
                                           row.scene + ".txt -output out.png " + row.arguments);
    CHECK_EQUAL(run.status, 0);
    const Image published = readImage(folder + "/pictures/" + row.picture + ".png");
    const ImageDifference difference = compareImages(readImage(desk.file("out.png")), published);
    CHECK(percentOver(row.level, row.picture, difference) <= row.percent);
  }
}

}  // namespace

TEST("the pictures of 2012's ray casting come out as published") {
  const char* const kSize = "-size 500 500";
  // The published ambient light of a texture is that of the pixel before.
  checkPublished("2012", "2012-casting",
                 {{"scene02", "scene02_cube", kSize, 1, 0.02},
                  {"scene04", "scene04_axes", kSize, 1, 0.02},
                  {"scene05", "scene05_bunny_200", kSize, 1, 0.02},
                  {"scene08", "scene08_c", kSize, 8, 0.5}});
}

TEST("the pictures of 2012's ray tracing come out as published") {
  const char* const kFirst = "-size 200 200 -bounces 0";
  const char* const kShadows = "-size 200 200 -bounces 0 -shadows";
  const char* const kOne = "-size 200 200 -bounces 1 -shadows";
  const char* const kFour = "-size 200 200 -bounces 4 -shadows";
  checkPublished("2012", "2012-tracing",
                 {{"scene10_sphere_b0", "scene10_sphere", kFirst, 1, 0.1},
                  {"scene10_sphere_b0s", "scene10_sphere", kShadows, 1, 0.1},
                  {"scene10_sphere_b1s", "scene10_sphere", kOne, 1, 0.1},
                  {"scene10_sphere_b4s", "scene10_sphere", kFour, 1, 0.11},
                  {"scene12_vase_b0", "scene12_vase", kFirst, 1, 0.1},
                  {"scene12_vase_b0s", "scene12_vase", kShadows, 1, 0.1},
                  {"scene12_vase_b1s", "scene12_vase", kOne, 1, 0.1},
                  {"scene12_vase_b4s", "scene12_vase", kFour, 1, 0.1}});
}

TEST("the colours of 2016 come out as published") {
  const char* const kSize = "-size 800 800";
  checkPublished("2016", "2016",
                 {{"a01", "scene01_plane", kSize, 1, 0.02},
                  {"a03", "scene03_sphere", kSize, 1, 0.02},
                  {"a04", "scene04_axes", kSize, 1, 0.02},
                  {"a05", "scene05_bunny_200", kSize, 1, 0.02},
                  {"a06", "scene06_bunny_1k", "-size 800 800 -bounces 4", 1, 0.02}});
}

TEST("the pictures of thu come out as published, in the size that the scene gives") {
  checkPublished("thu", "thu",
                 {{"scene01", "scene01_basic", "", 1, 0.02},
                  {"scene04", "scene04_axes", "", 1, 0.02},
                  {"scene07", "scene07_shine", "", 1, 0.02}});
}
