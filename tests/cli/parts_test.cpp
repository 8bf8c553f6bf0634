// Parts of pictures: -region and -tile give the whole picture's bytes, -merge puts them together.
#include <algorithm>
#include <cstring>
#include <filesystem>
#include <limits>

#include "check.h"
#include "cli/arguments.h"
#include "cli/desk.h"
#include "image/picture_file.h"

namespace {

using check::contains;
using check::Desk;
using check::ProgramRun;

constexpr const char* kSize = "-input scene.txt -size 20 13 ";

/// What a wrong command line is told.
std::string mistake(const std::vector<std::string>& words) {
  try {
    std::vector<std::string> all = {"-input", "scene.txt", "-output", "out.tga"};
    all.insert(all.end(), words.begin(), words.end());
    parseRequest(all);
  } catch (const UsageError& error) {
    return error.what();
  }
  return "";
}

void renderTiles(const Desk& desk, int count, const std::string& arguments = "") {
  for (int i = 1; i <= count; ++i) {
    const std::string number = std::to_string(i);
    CHECK_EQUAL(desk.run(kSize + arguments + " -output p" + number + ".tga -tile " + number + " " +
                         std::to_string(count))
                    .status,
                0);
  }
}

/// A run of -merge that must fail with status 3 and write nothing; gives its message.
std::string refusal(const Desk& desk, const std::string& parts) {
  check::writeFile(desk.file("old.tga"), "old");
  const ProgramRun run = desk.run("-merge old.tga " + parts);
  CHECK_EQUAL(run.status, 3);
  CHECK_EQUAL(check::contentOf(desk.file("old.tga")), "old");
  return run.errors;
}

}  // namespace

TEST("tiles of any number, merged in any order, are the whole picture") {
  const Desk desk;
  CHECK_EQUAL(desk.run(std::string(kSize) + "-output whole.tga").status, 0);
  for (const int count : {1, 2, 5, 13}) {
    renderTiles(desk, count);
    std::string parts;
    for (int i = 1; i <= count; ++i) parts = "p" + std::to_string(i) + ".tga " + parts;
    CHECK_EQUAL(desk.run("-merge merged.tga " + parts).errors, "");
    CHECK(check::contentOf(desk.file("merged.tga")) == check::contentOf(desk.file("whole.tga")));
  }
}

TEST("a part may be found through a grid, which changes no pixel but where it is drawn") {
  const Desk desk;
  CHECK_EQUAL(desk.run(std::string(kSize) + "-output whole.tga").status, 0);
  renderTiles(desk, 2);
  const std::string second = std::string(kSize) + "-output p2.tga -tile 2 2 -grid 3 4 5 ";
  CHECK_EQUAL(desk.run(second).status, 0);
  CHECK_EQUAL(desk.run("-merge merged.tga p1.tga p2.tga").errors, "");
  CHECK(check::contentOf(desk.file("merged.tga")) == check::contentOf(desk.file("whole.tga")));
  CHECK_EQUAL(desk.run(second + "-visualize_grid").status, 0);
  CHECK(contains(refusal(desk, "p1.tga p2.tga"), "expected a part of the same picture"));
}

TEST("regions give the whole picture's bytes with every kind of sample and filter") {
  const Desk desk;
  for (const std::string arguments :
       {"", "-tent_filter 3", "-jittered_samples 4 -gaussian_filter 1.5",
        "-random_samples 3 -box_filter 1", "-adaptive_samples 4 64 0.01 -tent_filter 2"}) {
    const std::string all = kSize + arguments;
    CHECK_EQUAL(desk.run(all + " -output whole.tga").status, 0);
    CHECK_EQUAL(desk.run(all + " -output a.tga -region 0 0 7 13 -threads 1").status, 0);
    CHECK_EQUAL(desk.run(all + " -output b.tga -region 7 0 13 4 -accel tree").status, 0);
    CHECK_EQUAL(desk.run(all + " -output c.tga -region 7 4 13 9").status, 0);
    CHECK_EQUAL(desk.run("-merge merged.tga c.tga a.tga b.tga").errors, "");
    CHECK(check::contentOf(desk.file("merged.tga")) == check::contentOf(desk.file("whole.tga")));
  }
}

TEST("parts of depth and normals are of their own kind, rendered together or singly") {
  const Desk desk;
  const std::string depth = "-depth 1 9 ", normals = " -normals ";
  CHECK_EQUAL(desk.run(kSize + depth + "d.tga" + normals + "n.tga").status, 0);
  CHECK_EQUAL(desk.run(kSize + depth + "d1.tga" + normals + "n1.tga -tile 1 2").status, 0);
  CHECK_EQUAL(desk.run(kSize + depth + "d2.tga -tile 2 2").status, 0);
  CHECK_EQUAL(desk.run(kSize + normals + "n2.tga -output c2.tga -tile 2 2").status, 0);
  CHECK_EQUAL(desk.run("-merge md.tga d1.tga d2.tga").errors, "");
  CHECK_EQUAL(desk.run("-merge mn.tga n1.tga n2.tga").errors, "");
  CHECK(check::contentOf(desk.file("md.tga")) == check::contentOf(desk.file("d.tga")));
  CHECK(check::contentOf(desk.file("mn.tga")) == check::contentOf(desk.file("n.tga")));
  CHECK(contains(refusal(desk, "d1.tga n2.tga"),
                 "n2.tga: expected a part of the same picture as "
                 "d1.tga, found one of its normals instead"));
  CHECK_EQUAL(desk.run(std::string(kSize) + "-depth 1 8 d3.tga -tile 2 2").status, 0);
  CHECK(contains(refusal(desk, "d1.tga d3.tga"), "or arguments"));
}

TEST("a part's header holds its place from the top left, and an image ID") {
  const Desk desk;
  CHECK_EQUAL(desk.run("-input scene.txt -size 300 280 -output p.tga -region 258 260 3 2").status,
              0);
  const std::string part = check::contentOf(desk.file("p.tga"));
  // 258 = 2 + 256, 260 = 4 + 256, low byte first; 24 bits, top row first.
  const char expected[] = {0, 2, 0, 0, 0, 0, 0, 2, 1, 4, 1, 3, 0, 2, 0, 24, 0x20};
  CHECK(part.substr(1, 17) == std::string(expected, sizeof expected));
  const std::string id = "raytracer part 1 color 300 280 ";
  CHECK_EQUAL(part.substr(18, id.size()), id);
  CHECK_EQUAL(std::size_t(static_cast<unsigned char>(part[0])), id.size() + 64);  // 256 bits
  CHECK_EQUAL(part.size(), 18 + id.size() + 64 + 3 * 3 * 2);
}

TEST("a merged picture has the format of its ending") {
  const Desk desk;
  CHECK_EQUAL(desk.run(std::string(kSize) + "-output whole.png").status, 0);
  CHECK_EQUAL(desk.run(std::string(kSize) + "-output whole.ppm").status, 0);
  renderTiles(desk, 2);
  for (const std::string ending : {".png", ".ppm"}) {
    CHECK_EQUAL(desk.run("-merge merged" + ending + " p1.tga p2.tga").errors, "");
    CHECK(check::contentOf(desk.file("merged" + ending)) ==
          check::contentOf(desk.file("whole" + ending)));
  }
}

TEST("missing rows are named, at both ends and between, and nothing is written") {
  const Desk desk;
  renderTiles(desk, 13);  // a row each
  CHECK(contains(refusal(desk, "p2.tga p1.tga p3.tga p4.tga"),
                 "no part holds rows 4 to 12; -region 0 4 20 9 renders them"));
  const std::string message = refusal(desk, "p2.tga p3.tga p5.tga p11.tga p12.tga p13.tga");
  CHECK(contains(message, "no part holds row 0; -region 0 0 20 1 renders it"));
  CHECK(contains(message, "no part holds row 3;"));
  CHECK(contains(message, "no part holds rows 5 to 9;"));
}

TEST("missing pixels and overlaps are named with their files") {
  const Desk desk;
  CHECK_EQUAL(desk.run(std::string(kSize) + "-output a.tga -region 0 0 20 9").status, 0);
  CHECK_EQUAL(desk.run(std::string(kSize) + "-output b.tga -region 3 7 10 6").status, 0);
  const std::string message = refusal(desk, "b.tga a.tga");
  CHECK(contains(message,
                 "a.tga and b.tga: expected parts that do not overlap, found pixels 3 to "
                 "12 of rows 7 to 8 in both"));
  CHECK(contains(message, "no part holds pixels 0 to 2 of rows 9 to 12; -region 0 9 3 4 renders"));
  CHECK(contains(message, "no part holds pixels 13 to 19 of rows 9 to 12; -region 13 9 7 4"));
  CHECK(contains(refusal(desk, "a.tga a.tga"), "found rows 0 to 8 in both"));
}

TEST("missing pixels beside several parts are named once") {
  const Desk desk;
  CHECK_EQUAL(desk.run(std::string(kSize) + "-output a.tga -region 0 0 7 5").status, 0);
  CHECK_EQUAL(desk.run(std::string(kSize) + "-output b.tga -region 0 5 7 8").status, 0);
  CHECK_EQUAL(refusal(desk, "a.tga b.tga"),
              "raytracer: no part holds pixels 7 to 19 of rows 0 to 12; -region 7 0 13 13 renders "
              "them\n");
}

TEST("of many mistakes twenty are named and the others counted") {
  const Desk desk;
  std::string parts;
  for (int i = 0; i < 25; ++i) parts += " none" + std::to_string(i) + ".tga";
  const std::string message = refusal(desk, parts);
  CHECK(contains(message, "none19.tga: cannot be read"));
  CHECK(!contains(message, "none20.tga"));
  CHECK(contains(message, "raytracer: and 5 more mistakes\n"));
}

TEST("parts of another picture are refused: another scene, mesh, argument or size") {
  const Desk desk;
  desk.write("mesh.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  std::string scene = check::smallScene();
  scene.replace(scene.find("Sphere"), std::string::npos, "TriangleMesh { obj_file mesh.obj } }\n");
  desk.write("scene.txt", scene);
  renderTiles(desk, 2);
  const std::string second = " -output q.tga -tile 2 2";
  const auto message = [&] { return refusal(desk, "p1.tga q.tga"); };
  CHECK_EQUAL(desk.run(kSize + second + " -threads 3 -accel tree -quiet").status, 0);
  CHECK_EQUAL(desk.run("-merge m.tga p1.tga q.tga").errors, "");  // these change no pixel
  CHECK_EQUAL(desk.run(kSize + second + " -bounces 4").status, 0);
  CHECK(contains(message(),
                 "q.tga: expected a part of the same picture as p1.tga, found one of "
                 "another scene, other meshes, pictures or arguments"));
  CHECK_EQUAL(desk.run("-input scene.txt -size 20 12 " + second).status, 0);
  CHECK(contains(message(), "found one of 20 x 12 pixels instead of 20 x 13 pixels"));
  desk.write("mesh.obj", "v 0 0 0\nv 1 0 0\nv 0 2 0\nf 1 2 3\n");
  CHECK_EQUAL(desk.run(kSize + second).status, 0);
  CHECK(contains(message(), "other meshes"));
  desk.write("mesh.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  desk.write("scene.txt", scene + " ");
  CHECK_EQUAL(desk.run(kSize + second).status, 0);
  CHECK(contains(message(), "another scene"));
}

TEST("what is no whole part is refused, and every such file is named") {
  const Desk desk;
  renderTiles(desk, 2);
  CHECK_EQUAL(desk.run(std::string(kSize) + "-output plain.tga").status, 0);
  const std::string part = check::contentOf(desk.file("p2.tga"));
  // 13 rows: the second half has 7 of 20 pixels.
  const std::size_t size = 18 + 29 + 64 + 3 * 20 * 7;
  CHECK_EQUAL(part.size(), size);
  for (std::size_t cut = 0; cut < part.size(); cut += cut < 130 ? 1 : 97) {
    desk.write("cut.tga", part.substr(0, cut));
    CHECK(contains(refusal(desk, "p1.tga cut.tga"), "raytracer: cut.tga: "));
  }
  CHECK(contains(refusal(desk, "p1.tga cut.tga"), "cut off: expected " + std::to_string(size)));
  desk.write("long.tga", part + "x");
  std::string moved = part;
  moved[10] = 7;  // rows 7 to 13 of 13
  desk.write("moved.tga", moved);
  const std::string message = refusal(desk, "long.tga plain.tga none.tga moved.tga . p1.tga");
  CHECK(contains(message, "long.tga: expected " + std::to_string(size) + " bytes, found"));
  CHECK(contains(message, "plain.tga: expected a TGA that -region or -tile has written"));
  CHECK(contains(message, "none.tga: cannot be read: No such file"));
  CHECK(contains(message, "moved.tga: damaged"));
  CHECK(contains(message, "raytracer: .: "));
}

TEST("an output that cannot be written is status 1, wrong usage 2") {
  const Desk desk;
  renderTiles(desk, 1);
  CHECK_EQUAL(desk.run("-merge none/m.tga p1.tga").status, 1);
  CHECK_EQUAL(desk.run("-merge p1.tga p1.tga").status, 2);
  CHECK_EQUAL(desk.run("-merge m.tga").status, 2);
  CHECK_EQUAL(desk.run("-merge m.tga ''").status, 2);
  CHECK_EQUAL(desk.run("-merge m.tga p1.tga -bounces 3").status, 2);
  CHECK_EQUAL(desk.run("-quiet -merge m.tga p1.tga -threads 2").status, 0);
}

TEST("a checkpoint of a part belongs to that part") {
  const Desk desk;
  const std::string start = std::string(kSize) + "-checkpoint c -output p2.tga -normals no/n.tga";
  renderTiles(desk, 2);
  const std::string expected = check::contentOf(desk.file("p2.tga"));
  std::filesystem::remove(desk.file("p2.tga"));
  // A run that cannot write one of its pictures leaves its checkpoint behind.
  CHECK_EQUAL(desk.run(start + " -tile 2 2").status, 1);
  CHECK(contains(desk.run(start + " -tile 1 2").errors, "was made from another scene"));
  std::filesystem::create_directory(desk.file("no"));
  std::filesystem::remove(desk.file("p2.tga"));
  CHECK_EQUAL(desk.run(start + " -tile 2 2").errors,
              "raytracer: c: taken up with 100 % done\n");  // both pictures
  CHECK(check::contentOf(desk.file("p2.tga")) == expected);
}

TEST("a region lies in the picture, and a picture has no more tiles than rows") {
  CHECK_EQUAL(mistake({"-region", "99", "0", "1", "100"}), "");
  CHECK_EQUAL(mistake({"-region", "0", "0", "100", "100"}), "");
  CHECK(contains(mistake({"-region", "99", "0", "2", "1"}),
                 "expected a part of the image of 100 x 100 pixels, found one that ends 101"));
  CHECK(contains(mistake({"-region", "0", "50", "1", "51"}), "and 101 from the top"));
  CHECK(contains(mistake({"-region", "0", "0", "0", "1"}), "for W"));
  CHECK(contains(mistake({"-region", "-1", "0", "1", "1"}), "for X"));
  CHECK_EQUAL(mistake({"-tile", "100", "100"}), "");
  CHECK(contains(mistake({"-tile", "1", "101"}), "expected an N of at most 100"));
  CHECK(contains(mistake({"-tile", "0", "4"}), "a whole number from 1 to 4 for I"));
  CHECK(contains(mistake({"-tile", "5", "4"}), "a whole number from 1 to 4 for I"));
  CHECK(contains(mistake({"-tile", "1", "1", "-region", "0", "0", "1", "1"}), "together"));
  CHECK(contains(mistake({"-tile", "1", "1", "-render_samples", "s", "2"}), "-render_samples"));
  CHECK(contains(mistake({"-tile", "1", "1", "-render_filter", "f", "2"}), "-render_filter"));
  for (const std::vector<std::string>& inspection : std::vector<std::vector<std::string>>{
           {"-materials", "m"}, {"-heatmap", "h"}, {"-pixel", "0", "0"}}) {
    std::vector<std::string> words = {"-region", "0", "0", "1", "1"};
    words.insert(words.end(), inspection.begin(), inspection.end());
    CHECK(contains(mistake(words), "-region cannot be given together with -materials"));
  }
}

TEST("most parts say which picture it is, and the odd one is named, be it the first") {
  const Desk desk;
  for (int i = 1; i <= 4; ++i) {
    const std::string k = std::to_string(i);
    const std::string bounces = i == 1 ? " -bounces 4" : "";
    CHECK_EQUAL(desk.run(kSize + bounces + " -output p" + k + ".tga -tile " + k + " 4").status, 0);
  }
  const std::string message = refusal(desk, "p1.tga p2.tga p3.tga p4.tga");
  CHECK(contains(message, "p1.tga: expected a part of the same picture as p2.tga"));
  CHECK_EQUAL(std::count(message.begin(), message.end(), '\n'), 1);
}

TEST("a miss in a depth picture of floats lies behind every distance") {
  const Desk desk;
  CHECK_EQUAL(desk.run("-input scene.txt -size 4 4 -depth 1 9 d.pfm -quiet").status, 0);
  CHECK_EQUAL(desk.run("-input scene.txt -size 4 4 -depth 9 1 e.pfm -quiet").status, 0);
  // A corner pixel misses the ball; floats stand behind the head, low byte first.
  const auto firstFloat = [&](const char* name) {
    const std::string bytes = check::contentOf(desk.file(name));
    float value = 0;
    std::memcpy(&value, bytes.data() + bytes.find("-1\n") + 3, sizeof value);
    return value;
  };
  CHECK_EQUAL(firstFloat("d.pfm"), -std::numeric_limits<float>::infinity());
  CHECK_EQUAL(firstFloat("e.pfm"), std::numeric_limits<float>::infinity());
  CHECK_EQUAL(desk.run("-compare d.pfm d.pfm").status, 0);
  CHECK_EQUAL(desk.run("-compare d.pfm e.pfm").status, 1);
}
