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

void compare(const Row& row, const Image& ours, const Image& published) {
  const ImageDifference difference = compareImages(ours, published);
  const auto percentOver = [&](int level) {
    return 100.0 * double(difference.pixelsOver(level)) / double(difference.pixels());
  };
  std::printf("  %-28s %7.3f %% over 2, max %d\n", row.picture.c_str(), percentOver(2),
              difference.maximum());
  int level = 0;
  double percent = 0;
  if (std::sscanf(row.tolerance.c_str(), "%d,%lf", &level, &percent) != 2) return;
  if (row.nearness == "statistical" || row.nearness == "no") return;
  CHECK(percentOver(level) <= percent);
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
