// -compare as a user meets it: pictures, folders, tables of commands, and what is written.
#include <sys/stat.h>

#include <algorithm>

#include "check.h"
#include "image/image.h"
#include "image/picture_file.h"
#include "run_program.h"

namespace {

using check::quoted;

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

/// 10 x 10 grey pixels, of which the first `count` in reading order are lighter by `more`.
Image greys(int count, int more) {
  Image image(10, 10);
  for (int i = 0; i < 100; ++i) {
    const auto level = std::uint8_t(100 + (i < count ? more : 0));
    image.setPixel(i % 10, 9 - i / 10, Rgb8{level, level, level});
  }
  return image;
}

struct Desk : check::ScratchFolder {
  void put(const std::string& name, const Image& image) const {
    std::filesystem::create_directories(std::filesystem::path(file(name)).parent_path());
    writePicture(image, file(name));
  }
  check::ProgramRun run(const std::string& arguments) const {
    return check::runProgram("-compare " + arguments, path());
  }
  int status(const std::string& arguments) const { return run(arguments).status; }
};

void checkContains(const std::string& text, const std::string& part) {
  check::report(contains(text, part), __FILE__, __LINE__, "'" + text + "' contains '" + part + "'");
}

}  // namespace

TEST("the status is 0 within the tolerance, 1 beyond, 2 for wrong usage, 3 for no picture") {
  const Desk desk;
  desk.put("a.tga", greys(0, 0));
  desk.put("b.png", greys(3, 1));
  desk.put("c.ppm", greys(3, 2));
  desk.put("d.pfm", Image(10, 11));
  desk.write("table", "");
  std::filesystem::create_symlink("x", desk.file("link"));  // to what is not there yet
  CHECK_EQUAL(desk.status("a.tga a.tga"), 0);
  CHECK_EQUAL(desk.status("a.tga b.png"), 0);  // the tolerance is 1
  CHECK_EQUAL(desk.status("a.tga b.png -tolerance 0"), 1);
  CHECK_EQUAL(desk.status("a.tga c.ppm"), 1);
  CHECK_EQUAL(desk.status("a.tga c.ppm -tolerance 2"), 0);
  CHECK_EQUAL(desk.status("a.tga c.ppm -fail_percent 3"), 0);  // 3 of 100 pixels
  CHECK_EQUAL(desk.status("a.tga c.ppm -fail_percent 2.9"), 1);
  CHECK_EQUAL(desk.status("a.tga d.pfm -tolerance 255 -fail_percent 100"), 1);  // another size
  CHECK_EQUAL(desk.status("a.tga none.tga"), 3);
  CHECK_EQUAL(desk.status("none.tga a.tga"), 3);
  CHECK_EQUAL(desk.status("a.tga ."), 3);
  for (const char* wrong :
       {"a.tga", "a.tga b.png -tolerance 256", "a.tga b.png -tolerance -1",
        "a.tga b.png -fail_percent 101", "a.tga b.png -input a.tga", "a.tga b.png -output o.tga",
        "a.tga b.png -size 1 1", "a.tga b.png -diff a.tga",
        "a.tga b.png -csv x -report ./x/../x -csv a.tga", ". . -diff d.png",
        "a.tga b.png -diff x -csv ./x", "a.tga b.png -csv x -report link", ". . -report a.tga",
        ". . -csv ./d.pfm", ". table -report b.png", "a.tga b.png -diff -", "a.tga b.png -csv -",
        "a.tga b.png -report /dev/stdout", "a.tga b.png -diff - -csv /dev/stdout -quiet"}) {
    check::report(desk.status(wrong) == 2, __FILE__, __LINE__, wrong);
  }
  CHECK_EQUAL(check::runProgram("-tolerance 1 -input a -output b", desk.path()).status, 2);
  CHECK(readImage(desk.file("a.tga")).Width() == 10);  // all pictures are still there
  CHECK_EQUAL(desk.status("a.tga d.pfm -diff - -quiet"), 1);
}

TEST("the figures of two pictures are printed by name, and nothing with -quiet") {
  const Desk desk;
  desk.put("a.tga", greys(0, 0));
  desk.put("b.tga", greys(25, 4));
  // Mean 4 x 25 / 100; RMS sqrt(16 / 4) = 2; PSNR 20 log10(127.5) = 42.1102; rows 0 to 2.
  CHECK_EQUAL(desk.run("a.tga b.tga").output,
              "expected: a.tga\nactual: b.tga\nsize: 10 x 10\nmaximum: 4\nmean: 1\nrms: 2\n"
              "psnr: 42.1102 dB\ntolerance: 1\nover tolerance: 25 of 100 pixels (25 %)\n"
              "worst pixel: 0 0\nbox: 0 0 10 3\nresult: different\n");
  const std::string equal = desk.run("a.tga a.tga").output;
  checkContains(equal, "\npsnr: inf\n");
  checkContains(equal, "\nworst pixel: none\nbox: none\nresult: same\n");
  desk.put("wide.tga", Image(11, 10));
  checkContains(desk.run("a.tga wide.tga").output,
                "expected size: 10 x 10\nactual size: 11 x 10\nresult: different\n");
  CHECK_EQUAL(desk.run("a.tga b.tga -quiet").output, "");
  CHECK_EQUAL(desk.run("a.tga a.tga > /dev/full").status, 1);
}

TEST("-diff writes the picture of differences") {
  const Desk desk;
  desk.put("a.tga", greys(0, 0));
  desk.put("b.tga", greys(1, 3));
  CHECK_EQUAL(desk.status("a.tga b.tga -diff d.png"), 1);
  const Image d = readImage(desk.file("d.png"));
  CHECK(d.getPixel(0, 9) == (Rgb8{48, 48, 48}));
  CHECK(d.getPixel(1, 9) == (Rgb8{0, 0, 0}));
}

TEST("an output that cannot be written is status 1, and costs neither figures nor other outputs") {
  const Desk desk;
  desk.put("a.tga", greys(0, 0));
  const std::string figures = desk.run("a.tga a.tga").output;
  for (const char* failing : {"-diff none/d", "-csv none/d", "-report none/d"}) {
    const check::ProgramRun run = desk.run(std::string("a.tga a.tga ") + failing);
    CHECK_EQUAL(run.status, 1);
    CHECK_EQUAL(run.output, figures);
    CHECK_EQUAL(run.errors, "raytracer: none/d: cannot be written: No such file or directory\n");
  }
  CHECK_EQUAL(desk.status("a.tga a.tga -diff none/d -csv t -report r"), 1);
  checkContains(check::contentOf(desk.file("t")), "a.tga,a.tga,a.tga,same,10,10,10,10,0,");
  CHECK(std::filesystem::exists(desk.file("r")));
}

TEST("folders are compared picture by picture, whatever their endings, and what is alone differs") {
  const Desk desk;
  desk.put("e/one.tga", greys(0, 0));
  desk.put("e/sub/two.png", greys(0, 0));
  desk.put("a/one.png", greys(0, 0));
  desk.put("a/sub/two.png", greys(1, 1));
  desk.write("e/notes.txt", "no picture");
  CHECK_EQUAL(
      desk.run("e a").output,
      "same: one.tga: equal\nsame: sub/two.png: maximum 1, mean 0.01, PSNR 68.1308 dB, over "
      "the tolerance 0 of 100 pixels (0 %)\n2 pairs: 2 same, 0 different, 0 missing, "
      "unexpected or unreadable\n");
  desk.put("e/three.tga", greys(0, 0));
  desk.put("a/four.tga", greys(0, 0));
  const check::ProgramRun run = desk.run("e a");
  CHECK_EQUAL(run.status, 1);
  checkContains(run.output, "missing: three.tga: no actual picture\n");
  checkContains(run.output, "unexpected: four.tga: no expected picture\n");
  desk.write("a/three.tga", "broken");
  CHECK_EQUAL(desk.status("e a"), 3);
  checkContains(desk.run("e a").errors, "a/three.tga: ");
  // A pipe in a folder has nobody who writes to it.
  desk.put("e/pipe.tga", greys(0, 0));
  CHECK_EQUAL(mkfifo(desk.file("a/pipe.tga").c_str(), 0600), 0);
  checkContains(desk.run("e a").errors, "a/pipe.tga: expected a file, found a pipe");
  std::filesystem::create_directory(desk.file("empty"));
  CHECK_EQUAL(desk.status("empty empty"), 3);
}

TEST("-csv adds a row for each pair below one heading, and refuses other files") {
  const Desk desk;
  desk.put("a,\"1\".tga", greys(0, 0));
  desk.put("b.tga", greys(25, 4));
  CHECK_EQUAL(desk.status("'a,\"1\".tga' b.tga -csv t.csv"), 1);
  CHECK_EQUAL(desk.status("b.tga b.tga -csv t.csv"), 0);
  const std::string table = check::contentOf(desk.file("t.csv"));
  CHECK_EQUAL(std::count(table.begin(), table.end(), '\n'), 3);
  checkContains(
      table,
      "\"a,\"\"1\"\".tga\",\"a,\"\"1\"\".tga\",b.tga,different,10,10,10,10,4,1,2,42.1102,25,"
      "25,0,0,0,0,10,3,b.tga\r\n");
  checkContains(table, "b.tga,b.tga,b.tga,same,10,10,10,10,0,0,0,inf,0,0,0,0,0,0,0,0,b.tga\r\n");
  desk.write("notes.txt", "my notes\n");
  CHECK_EQUAL(desk.status("b.tga b.tga -csv notes.txt"), 1);
  CHECK_EQUAL(check::contentOf(desk.file("notes.txt")), "my notes\n");
}

TEST("many runs at once add their rows to one table, and none is lost") {
  const Desk desk;
  desk.put("a.tga", greys(0, 0));
  std::filesystem::create_symlink("t.csv", desk.file("link"));
  std::string all = "a.tga a.tga -csv t.csv";
  for (int run = 1; run < 12; ++run) {
    all += " & " + quoted(check::programToTest()) + " -compare a.tga a.tga -csv " +
           (run % 2 == 0 ? "t.csv" : "link");
  }
  desk.run(all + "; wait");
  const std::string table = check::contentOf(desk.file("t.csv"));
  CHECK_EQUAL(std::count(table.begin(), table.end(), '\n'), 1 + 12);
  CHECK_EQUAL(desk.fileCount(), std::size_t(3));
}

TEST("-csv has every column for what is alone, of another size or unreadable") {
  const Desk desk;
  for (const char* name : {"e/alone.png", "e/size.png", "e/bad.png"}) desk.put(name, greys(0, 0));
  desk.put("a/size.png", Image(10, 11));
  desk.write("a/bad.png", "broken");
  CHECK_EQUAL(desk.status("e a -csv t.csv"), 3);
  const std::string table = check::contentOf(desk.file("t.csv"));
  checkContains(table, "\r\nalone.png,e/alone.png,,missing,,,,");
  checkContains(table, "\r\nbad.png,e/bad.png,a/bad.png,unreadable,");
  checkContains(table, "\r\nsize.png,e/size.png,a/size.png,different,10,10,10,11,,");
  CHECK_EQUAL(std::count(table.begin(), table.end(), ','), 4 * 20);  // 21 columns, four rows
  // Whose picture is missing.
  checkContains(table, ",a\r\nbad.png");
}

TEST("a report shows what is alone before other sizes, and these before other pixels") {
  const Desk desk;
  for (const char* name : {"e/1.png", "e/2.png", "e/3.png"}) desk.put(name, greys(0, 0));
  desk.put("a/1.png", greys(90, 90));
  desk.put("a/2.png", Image(10, 11));
  CHECK_EQUAL(desk.status("e a -report r.html"), 1);
  const std::string page = check::contentOf(desk.file("r.html"));
  checkContains(page, "3.png: missing</h2>");
  CHECK(page.find("3.png: missing</h2>") < page.find("2.png: different</h2>"));
  CHECK(page.find("2.png: different</h2>") < page.find("1.png: different</h2>"));
}

TEST("the report is one page with the worst first, names escaped, and nothing from outside") {
  const Desk desk;
  const std::string evil = "<img src=x onerror=alert(1)>&'\".png";
  desk.put("e/equal.png", greys(0, 0));
  desk.put("e/bad.png", greys(0, 0));
  desk.put("e/" + evil, greys(0, 0));
  desk.put("a/equal.png", greys(0, 0));
  desk.put("a/bad.png", greys(50, 50));
  desk.put("a/" + evil, greys(5, 5));
  CHECK_EQUAL(desk.status("e a -report r.html"), 1);
  const std::string page = check::contentOf(desk.file("r.html"));
  CHECK(!contains(page, "<img src=x"));
  checkContains(page.substr(page.find("<h2 id=\"pair2"), 200),
                "&lt;img src=x onerror=alert(1)&gt;&amp;&#39;&quot;.png: different</h2>");
  CHECK(page.find("bad.png: different") < page.find("&lt;img"));
  CHECK(page.find("&lt;img") < page.find("equal.png: same"));
  CHECK(!contains(page, "http:") && !contains(page, "https:") && !contains(page, "url("));
  for (std::size_t at = 0; (at = page.find("src=\"", at)) != std::string::npos; ++at) {
    CHECK_EQUAL(page.substr(at, 27), "src=\"data:image/png;base64,");
  }
}

TEST("a table of commands is rendered and compared with a folder") {
  const Desk desk;
  desk.write("scene.txt", check::smallScene());
  std::filesystem::create_directory(desk.file("t"));
  desk.write("t/table.txt",
             "# a comment\n\none.png -input ../scene.txt -size 20 10 # another\r\n"
             "- -input '../scene.txt' -size 20 10 -depth 4 5 \"two d.tga\"\n");
  std::filesystem::create_directory(desk.file("e"));
  const std::string in = "-input scene.txt -size 20 10 ";
  CHECK_EQUAL(
      check::runProgram(in + "-output e/one.tga -depth 4 5 'e/two d.png'", desk.path()).status, 0);
  const check::ProgramRun run = desk.run("e t/table.txt -tolerance 0 -report r.html");
  CHECK_EQUAL(
      run.output,
      "same: one.png: equal\nsame: two d.tga: equal\n2 pairs: 2 same, 0 different, 0 missing, "
      "unexpected or unreadable\n");
  CHECK_EQUAL(run.status, 0);
  CHECK(!std::filesystem::exists(desk.file("one.png")));
  desk.put("e/three.tga", greys(0, 0));
  CHECK_EQUAL(desk.status("e t/table.txt"), 1);
  desk.write("t/table.txt", "four.tga -input ../scene.txt\n");
  checkContains(desk.run("e t/table.txt").output, "unexpected: four.tga: no expected picture\n");
  desk.write("t/table.txt", "three.tga -input none.txt\n");
  CHECK_EQUAL(desk.status("e t/table.txt"), 3);
  for (const char* wrong :
       {"-input ../scene.txt\n", "a.png -input x -bounces x\n", "a.png 'b\n",
        "a.png -input x -stats\n", "a.png -input x -check\n", "a.png -input x -pixel 0 0\n",
        "a.png -input x -preview\n", "a.png -input -\n", "'' -input x\n", "a.png -compare x y\n",
        "a.png -input x\na.png -input x\n", "a.png -input x -output b\n"}) {
    desk.write("t/table.txt", wrong);
    const check::ProgramRun failed = desk.run("e t/table.txt");
    check::report(failed.status == 2, __FILE__, __LINE__, wrong);
    checkContains(failed.errors, "raytracer: t/table.txt:");
  }
}

TEST("warnings of a command of a table name the scene beside the table, whatever its course") {
  const Desk desk;
  std::filesystem::create_directory(desk.file("e"));
  std::filesystem::create_directory(desk.file("t"));
  const std::string camera = "PerspectiveCamera { center 0 0 5 direction 0 0 -1 up 0 1 0 angle 30 ";
  const std::string speck =
      " } }\nGroup { numObjects 1 MaterialIndex 0\n"
      "Sphere { center 0 0 0 radius 0.0001 } }\n";
  const std::string glass = "Materials { numMaterials 1 PhongMaterial { ";
  desk.write("t/2012.txt",
             camera + "}\n" + glass + "specularColor 1 1 1 refractionIndex 1.5" + speck);
  desk.write("t/thu.txt",
             camera + "width 3 height 2 }\n" + glass + "transparentColor 1 1 1" + speck);
  desk.write("t/table.txt",
             "a.ppm -course 2012 -input 2012.txt -size 3 2\n"
             "b.ppm -course thu -input thu.txt -epsilon course\n");
  const std::string errors = desk.run("e t/table.txt").errors;
  checkContains(errors, "warning: t/2012.txt:4: the transparent object is");
  checkContains(errors, "warning: t/thu.txt:4: the transparent object is");
}

TEST("our scenes give the pictures in tests/expected") {
  const std::string folder = check::testsFolder();
  const check::ProgramRun run =
      check::runProgram("-compare " + quoted(folder + "/expected") + " " +
                        quoted(folder + "/scene_commands.txt") + " -tolerance 0 -threads 2");
  std::istringstream lines(run.output);
  for (std::string line; std::getline(lines, line);) {
    const bool isEqual = contains(line, ": equal") || contains(line, " pairs: ");
    check::report(isEqual, __FILE__, __LINE__, line);
  }
  CHECK_EQUAL(run.status, 0);
}

TEST("-output, -depth and -normals follow the endings of their files") {
  const Desk desk;
  desk.write("scene.txt", check::smallScene());
  const auto render = [&](const std::string& arguments) {
    return check::runProgram("-input scene.txt -size 20 10 " + arguments, desk.path()).status;
  };
  CHECK_EQUAL(render("-output a.png -depth 4.5 5 b.pfm -normals c.ppm"), 0);
  CHECK_EQUAL(render("-output a.tga -depth 4.5 5 b.tga -normals c"), 0);
  CHECK_EQUAL(check::contentOf(desk.file("a.png")).substr(1, 3), "PNG");
  CHECK_EQUAL(check::contentOf(desk.file("c.ppm")).substr(0, 13), "P6\n20 10\n255\n");
  CHECK_EQUAL(check::contentOf(desk.file("b.pfm")).substr(0, 12), "PF\n20 10\n-1\n");
  CHECK_EQUAL(check::contentOf(desk.file("b.pfm")).size(), 12u + 20 * 10 * 12);
  for (const char* pair : {"a.tga a.png", "b.tga b.pfm", "c c.ppm"}) {
    CHECK_EQUAL(desk.status(std::string(pair) + " -tolerance 0"), 0);
  }
}

TEST("a PFM holds colours above 1") {
  const Desk desk;
  std::string scene = check::smallScene();
  scene.replace(scene.find("color 0.2 0.2 0.2"), 17, "color 3 0 -1");
  scene.replace(scene.find("center 0 0 0"), 12, "center 0 99 0");  // out of sight
  desk.write("scene.txt", scene);
  for (const char* sampling : {"", " -uniform_samples 4"}) {
    CHECK_EQUAL(check::runProgram(
                    "-input scene.txt -size 2 2 -output a.pfm" + std::string(sampling), desk.path())
                    .status,
                0);
    const std::string file = check::contentOf(desk.file("a.pfm"));
    // The corner shows the background; 3 is 40400000, -1 BF800000.
    CHECK(file.substr(10, 12) == std::string("\0\0\x40\x40\0\0\0\0\0\0\x80\xbf", 12));
  }
}

TEST("the report works with keys and clicks in a browser") {
  const Desk desk;
  desk.put("e/a.png", greys(0, 0));
  desk.put("e/b.png", greys(0, 0));
  desk.put("a/a.png", greys(9, 9));
  desk.put("a/b.png", greys(0, 0));
  CHECK_EQUAL(desk.status("e a -report r.html"), 1);
  const std::string command = "cd " + quoted(desk.path()) + " && timeout 60 python3 " +
                              quoted(check::testsFolder() + "/report_in_browser.py") +
                              " r.html shot.png >found 2>&1";
  const int result = std::system(command.c_str());
  const int status = WIFEXITED(result) ? WEXITSTATUS(result) : 255;
  if (status == 77 || status == 127) SKIP("no Chromium or no python3 is installed");
  CHECK_EQUAL(check::contentOf(desk.file("found")), "ok\n");
}
