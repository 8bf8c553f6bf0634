// -grid and the pictures of its cells, on the command line.
#include "check.h"
#include "cli/request.h"
#include "desk.h"

using check::contains;
using check::Desk;

namespace {

using Words = std::vector<std::string>;

/// What a complete command that also has `words` wants of the scene's geometry.
Acceleration parse(const Words& words) {
  Words all = {"-input", "scene.txt", "-output", "out.tga"};
  all.insert(all.end(), words.begin(), words.end());
  return parseRequest(all).render.picture.acceleration;
}

/// The message for a wrong command; "" where it is right.
std::string mistake(const Words& words) {
  try {
    parse(words);
  } catch (const UsageError& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST("-grid takes three numbers within its limits, and the last of -grid and -accel counts") {
  const Acceleration o = parse({"-grid", "1024", "1", "16"});
  CHECK(o.kind == Acceleration::Kind::grid);
  CHECK(o.gridSize == (GridSize{1024, 1, 16}));
  CHECK(parse({"-grid", "2", "3", "4", "-accel", "tree"}).kind == Acceleration::Kind::tree);
  CHECK(parse({"-accel", "tree", "-grid", "2", "3", "4"}).kind == Acceleration::Kind::grid);
  CHECK(contains(mistake({"-grid", "2", "0", "4"}), "from 1 to 1024 for NY, found '0'"));
  CHECK(contains(mistake({"-grid", "2", "3", "1025"}), "from 1 to 1024 for NZ, found '1025'"));
  CHECK(contains(mistake({"-grid", "x", "3", "4"}), "for NX, found 'x'"));
  // 1024 * 1024 * 16 is the limit, 2^24.
  CHECK_EQUAL(mistake({"-grid", "1024", "1024", "16"}), "");
  CHECK(contains(mistake({"-grid", "1024", "1024", "17"}), "at most 16777216 cells in all"));
}

TEST("the cells of a grid can be drawn only where there is a grid") {
  using Picture = Acceleration::CellPicture;
  CHECK(parse({}).cellPicture == Picture::none);
  CHECK(parse({"-visualize_grid", "-grid", "2", "2", "2"}).cellPicture == Picture::occupied);
  CHECK(parse({"-grid", "2", "2", "2", "-visualize_grid_count"}).cellPicture == Picture::counts);
  const std::string wanted = ": expected a grid to draw, for example -grid 20 20 20, found none";
  CHECK_EQUAL(mistake({"-visualize_grid"}), "-visualize_grid" + wanted);
  CHECK_EQUAL(mistake({"-visualize_grid_count"}), "-visualize_grid_count" + wanted);
  CHECK_EQUAL(mistake({"-grid", "2", "2", "2", "-accel", "tree", "-visualize_grid"}),
              "-visualize_grid" + wanted + " but -accel tree");
}

TEST("-visualize_grid draws the cells, -visualize_grid_count in other colours where cells crowd") {
  const Desk desk;
  // Two balls of one place: cells of two objects, violet where others are white.
  desk.write("two.txt",
             check::smallScene() + "Group { numObjects 1 Sphere { center 0 0 0 radius 1 } }");
  const std::string in = " -size 31 31 -grid 1 1 1 -output ";
  CHECK_EQUAL(desk.run("-input scene.txt" + in + "scene.tga").status, 0);
  CHECK_EQUAL(desk.run("-input scene.txt -visualize_grid" + in + "cells.tga").status, 0);
  CHECK_EQUAL(desk.run("-input scene.txt -visualize_grid_count" + in + "counts.tga").status, 0);
  CHECK_EQUAL(desk.run("-input two.txt -visualize_grid" + in + "two_cells.tga").status, 0);
  CHECK_EQUAL(desk.run("-input two.txt -visualize_grid_count" + in + "two_counts.tga").status, 0);
  const auto content = [&](const char* name) { return check::contentOf(desk.file(name)); };
  CHECK(content("cells.tga") != content("scene.tga"));
  CHECK(content("cells.tga") == content("counts.tga"));
  CHECK(content("cells.tga") == content("two_cells.tga"));
  CHECK(content("cells.tga") != content("two_counts.tga"));
}
