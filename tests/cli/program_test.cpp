// The program as a user meets it: exit status, messages, and what becomes of the files.
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>

#include "check.h"
#include "desk.h"

namespace {

using check::contains;
using check::Desk;
using check::quoted;
using check::startsWith;

/// The run failed with `status` and said so in lines that all begin "raytracer: ".
void checkFailure(const check::ProgramRun& run, int status, const std::string& part) {
  CHECK_EQUAL(run.status, status);
  CHECK(!run.errors.empty());
  CHECK_EQUAL(run.output, "");
  std::istringstream lines(run.errors);
  std::string line;
  while (std::getline(lines, line)) CHECK(startsWith(line, "raytracer: "));
  check::report(contains(run.errors, part), __FILE__, __LINE__,
                "'" + run.errors + "' contains '" + part + "'");
}

/// Bytes of a TGA of w x h pixels: 18 of the header and 3 for each pixel.
std::size_t tgaSize(std::size_t w, std::size_t h) { return 18 + 3 * w * h; }

}  // namespace

TEST("the course's exact command writes a 100 x 100 image and says nothing") {
  const Desk desk;
  const check::ProgramRun run =
      desk.run("-input scene.txt -output out.tga -bounces 5 -weight 0.01");
  CHECK_EQUAL(run.status, 0);
  CHECK_EQUAL(run.output + run.errors, "");
  CHECK_EQUAL(check::contentOf(desk.file("out.tga")).size(), tgaSize(100, 100));
  CHECK_EQUAL(desk.fileCount(), std::size_t(2));
}

TEST("colour, depth and normal images come from one run and are the ones of three runs") {
  const Desk desk;
  const std::string in = "-input scene.txt -size 20 10 ";
  CHECK_EQUAL(desk.run(in + "-output a -depth 4 5 b -normals c").status, 0);
  CHECK_EQUAL(desk.run(in + "-output d").status, 0);
  CHECK_EQUAL(desk.run(in + "-depth e 4 5").status, 0);
  CHECK_EQUAL(desk.run(in + "-normal f").status, 0);
  for (const char* pair : {"ad", "be", "cf"}) {
    const std::string all = check::contentOf(desk.file(std::string(1, pair[0])));
    CHECK_EQUAL(all.size(), tgaSize(20, 10));
    CHECK(all == check::contentOf(desk.file(std::string(1, pair[1]))));
  }
  CHECK(check::contentOf(desk.file("a")) != check::contentOf(desk.file("b")));
  CHECK(check::contentOf(desk.file("a")) != check::contentOf(desk.file("c")));
}

TEST("any number of threads and either way to find a hit give the same bytes") {
  const Desk desk;
  const std::string in = "-input scene.txt -size 33 47 -output ";
  CHECK_EQUAL(desk.run(in + "a -threads 1").status, 0);
  CHECK_EQUAL(desk.run(in + "b -threads 3").status, 0);
  CHECK_EQUAL(desk.run(in + "c -threads 16").status, 0);
  CHECK_EQUAL(desk.run(in + "d -accel tree").status, 0);
  CHECK_EQUAL(desk.run(in + "e -grid 3 4 5").status, 0);
  const std::string first = check::contentOf(desk.file("a"));
  for (const char* other : {"b", "c", "d", "e"}) CHECK(first == check::contentOf(desk.file(other)));
}

TEST("the scene may come from standard input") {
  const Desk desk;
  CHECK_EQUAL(desk.run("-input - -output a < scene.txt").status, 0);
  CHECK_EQUAL(desk.run("-input scene.txt -output b").status, 0);
  CHECK(check::contentOf(desk.file("a")) == check::contentOf(desk.file("b")));
}

TEST("raytracer alone, -help and -version print to standard output and succeed") {
  const Desk desk;
  for (const char* arguments : {"", "-help", "--help", "-version", "--version"}) {
    const check::ProgramRun run = desk.run(arguments);
    CHECK_EQUAL(run.status, 0);
    CHECK_EQUAL(run.errors, "");
    CHECK(startsWith(run.output, "raytracer"));
  }
  CHECK(contains(desk.run("").output, "-help"));
  CHECK(contains(desk.run("-help").output, "-transparent_shadows"));
  CHECK_EQUAL(desk.run("-version").output, "raytracer 1.0\n");
}

TEST("text that cannot be printed is a failed output") {
  const Desk desk;
  if (access("/dev/full", W_OK) != 0) SKIP("there is no /dev/full");
  checkFailure(desk.run("-help >/dev/full"), 1, "standard output");
  checkFailure(desk.run("-check -input scene.txt >/dev/full"), 1, "standard output");
}

TEST("an output must not be a mesh of the scene") {
  const Desk desk;
  const std::string mesh = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
  desk.write("a mesh.obj", mesh);
  std::filesystem::create_symlink("a mesh.obj", desk.file("link.tga"));
  desk.write("mesh.txt",
             check::smallScene() + "Group { numObjects 1 TriangleMesh { obj_file link.tga } }\n");
  for (const char* output : {"-output ./link.tga", "-depth 1 2 link.tga", "-normals link.tga"}) {
    checkFailure(desk.run(std::string("-input mesh.txt ") + output), 2, "one of its meshes");
  }
  CHECK_EQUAL(check::contentOf(desk.file("a mesh.obj")), mesh);
}

TEST("wrong usage gives status 2 and leaves the old image alone") {
  const Desk desk;
  desk.write("out.tga", "old");
  const std::string in = "-input scene.txt -output out.tga ";
  checkFailure(desk.run(in + "-bounces"), 2, "-bounces: expected N, found the end");
  checkFailure(desk.run(in + "-bounces 10001"), 2, "found '10001'");
  checkFailure(desk.run(in + "-weight nan"), 2, "found 'nan'");
  checkFailure(desk.run(in + "-size 0 5"), 2, "found '0'");
  checkFailure(desk.run(in + "-shadow"), 2, "did you mean '-shadows'?");
  checkFailure(desk.run(in + "-depth 1 1 d.tga"), 2, "differ");
  checkFailure(desk.run(in + "-normals ./out.tga"), 2, "different files");
  desk.write("scene.tga", check::smallScene());
  checkFailure(desk.run("-input scene.tga -output scene.tga"), 2, "different files");
  checkFailure(desk.run("-input scene.txt -output out.jpg"), 2,
               "one of .tga, .png, .bmp, .ppm, .pfm");
  checkFailure(desk.run("-input scene.txt"), 2, "-output");
  checkFailure(desk.run("-output out.tga"), 2, "-input");
  CHECK_EQUAL(check::contentOf(desk.file("out.tga")), "old");
  CHECK_EQUAL(check::contentOf(desk.file("scene.txt")), check::smallScene());
  CHECK_EQUAL(desk.fileCount(), std::size_t(3));
}

TEST("a scene mistake gives status 3 with file and line and leaves the old image alone") {
  const Desk desk;
  desk.write("out.tga", "old");
  desk.write("bad.txt", "# line 1\nOrthographicCamera { center 0 0 x }\n");
  checkFailure(desk.run("-input bad.txt -output out.tga"), 3, "raytracer: bad.txt:2: ");
  checkFailure(desk.run("-input none.txt -output out.tga"), 3, "raytracer: none.txt: ");
  checkFailure(desk.run("-input . -output out.tga"), 3, "raytracer: .: ");
  std::string mesh = check::smallScene();
  mesh.replace(mesh.find("Sphere"), std::string::npos, "TriangleMesh { obj_file none.obj } }\n");
  desk.write("mesh.txt", mesh);
  checkFailure(desk.run("-input mesh.txt -output out.tga"), 3, "raytracer: mesh.txt:5: ");
  CHECK_EQUAL(check::contentOf(desk.file("out.tga")), "old");
  CHECK_EQUAL(desk.fileCount(), std::size_t(4));
}

TEST("-check reports every mistake with its line and renders nothing") {
  const Desk desk;
  desk.write("out.tga", "old");
  std::string scene = check::smallScene();
  scene.replace(scene.find("angle 40"), 8, "angle xx");
  scene.replace(scene.find("radius 1"), 8, "radius 0");
  desk.write("bad.txt", scene);
  const check::ProgramRun run = desk.run("-check -input bad.txt -output out.tga");
  checkFailure(run, 3, "raytracer: bad.txt:1: ");
  CHECK(contains(run.errors, "raytracer: bad.txt:5: "));
  CHECK_EQUAL(desk.run("-check -input scene.txt -output out.tga").status, 0);
  CHECK_EQUAL(desk.run("-check -input scene.txt").output, "scene.txt: no mistakes found\n");
  CHECK_EQUAL(check::contentOf(desk.file("out.tga")), "old");
}

TEST("warnings name file and line, leave the status at 0, and -quiet silences them") {
  const Desk desk;
  std::string scene = check::smallScene();
  const std::size_t start = scene.find("Lights"), end = scene.find("Background");
  scene.replace(start, end - start, "");
  desk.write("dark.txt", scene);
  const check::ProgramRun run = desk.run("-input dark.txt -output a");
  CHECK_EQUAL(run.status, 0);
  CHECK(startsWith(run.errors, "raytracer: warning: dark.txt:"));
  CHECK_EQUAL(desk.run("-quiet -input dark.txt -output b").errors, "");
  CHECK(check::contentOf(desk.file("a")) == check::contentOf(desk.file("b")));
}

TEST("an output folder that is missing gives status 1 before anything is rendered") {
  const Desk desk;
  // 65535 x 65535 pixels would take hours and 13 gigabytes.
  checkFailure(desk.run("-input scene.txt -size 65535 65535 -output none/out.tga"), 1,
               "none/out.tga: ");
  checkFailure(desk.run("-input scene.txt -size 65535 65535 -output ."), 1, "raytracer: .: ");
  checkFailure(desk.run("-input scene.txt -size 65535 65535 -output out.bmp"), 1,
               "a BMP image has at most 2^30 pixels here, this one is 65535 x 65535");
}

TEST("where one of several outputs fails the others are still written") {
  const Desk desk;
  checkFailure(desk.run("-input scene.txt -output none/out.tga -normals n.tga -depth 4 5 d.tga"), 1,
               "none/out.tga");
  CHECK_EQUAL(check::contentOf(desk.file("n.tga")).size(), tgaSize(100, 100));
  CHECK_EQUAL(check::contentOf(desk.file("d.tga")).size(), tgaSize(100, 100));
  if (access("/dev/full", W_OK) != 0) return;
  checkFailure(desk.run("-input scene.txt -output /dev/full -normals m.tga"), 1, "/dev/full");
  CHECK(check::contentOf(desk.file("m.tga")) == check::contentOf(desk.file("n.tga")));
}

TEST("a limit on the size of files leaves the old image and no litter") {
  const Desk desk;
  desk.write("out.tga", "old");
  // The image has 30018 bytes; the limit is one block of 512 or 1024.
  checkFailure(desk.run("-input scene.txt -output out.tga", "ulimit -f 1;"), 1, "out.tga: ");
  CHECK_EQUAL(check::contentOf(desk.file("out.tga")), "old");
  CHECK_EQUAL(desk.fileCount(), std::size_t(2));
}

TEST("a full disk leaves the old image and no litter") {
  const Desk desk;
  const std::string disk = desk.file("disk");
  std::filesystem::create_directory(disk);
  const std::string mount = "mount -t tmpfs -o size=64k tmpfs " + quoted(disk) + " 2>/dev/null";
  if (geteuid() != 0 || std::system(mount.c_str()) != 0) SKIP("cannot mount a small disk");
  check::writeFile(disk + "/out.tga", "old");
  // 200 x 200 pixels take 120018 bytes.
  const check::ProgramRun run = desk.run("-input scene.txt -size 200 200 -output disk/out.tga");
  const std::string content = check::contentOf(disk + "/out.tga");
  const auto files = std::distance(std::filesystem::directory_iterator(disk), {});
  CHECK_EQUAL(std::system(("umount " + quoted(disk)).c_str()), 0);
  checkFailure(run, 1, "disk/out.tga: ");
  CHECK_EQUAL(content, "old");
  CHECK_EQUAL(files, 1);
}

TEST("a signal ends a run and leaves the old image and no litter") {
  const Desk desk;
  desk.write("out.tga", "old");
  // One thread needs longer than a fifth of a second for 16 million rays.
  for (const char* signal : {"INT", "TERM", "HUP"}) {
    const std::string before = std::string("timeout --preserve-status -s ") + signal + " 0.2";
    CHECK(desk.run("-input scene.txt -size 4000 4000 -threads 1 -output out.tga", before).status >
          128);
    CHECK_EQUAL(check::contentOf(desk.file("out.tga")), "old");
    CHECK_EQUAL(desk.fileCount(), std::size_t(2));
  }
}

TEST("scenes nested to the limit are read and shown whatever the shell's limit for the stack") {
  const Desk desk;
  std::string scene = check::smallScene();
  const std::size_t sphere = scene.find("Sphere"), end = scene.find('}', sphere) + 1;
  scene.insert(end, std::string(999, '}'));
  for (int i = 0; i < 999; ++i) scene.insert(sphere, "Transform { ");
  desk.write("deep.txt", scene);
  CHECK_EQUAL(desk.run("-input deep.txt -output a", "ulimit -s 128;").status, 0);
  CHECK_EQUAL(desk.run("-input deep.txt -output b -accel tree", "ulimit -s 128;").status, 0);
  CHECK_EQUAL(desk.run("-input deep.txt -check", "ulimit -s 128;").status, 0);
  CHECK_EQUAL(desk.run("-input scene.txt -output c").status, 0);
  CHECK(check::contentOf(desk.file("a")) == check::contentOf(desk.file("c")));
  CHECK(check::contentOf(desk.file("b")) == check::contentOf(desk.file("c")));
}

TEST("an image that memory cannot hold gives status 1 and says what it was for") {
  const Desk desk;
  const std::string limit = "ulimit -v 1000000;";
  if (desk.run("-version", limit).status != 0) SKIP("the program does not start with so little");
  desk.write("out.tga", "old");
  // 20000 x 20000 pixels of 3 bytes are 1.2 gigabytes; one gigabyte is allowed.
  const check::ProgramRun run =
      desk.run("-input scene.txt -threads 1 -size 20000 20000 -output out.tga", limit);
  checkFailure(run, 1, "20000 x 20000");
  CHECK_EQUAL(check::contentOf(desk.file("out.tga")), "old");
  CHECK_EQUAL(desk.fileCount(), std::size_t(2));
}

TEST("an output that is a link replaces what the link points to") {
  const Desk desk;
  desk.write("real.tga", "old");
  std::filesystem::create_symlink("real.tga", desk.file("out.tga"));
  CHECK_EQUAL(desk.run("-input scene.txt -output out.tga").status, 0);
  CHECK(std::filesystem::is_symlink(desk.file("out.tga")));
  CHECK_EQUAL(check::contentOf(desk.file("real.tga")).size(), tgaSize(100, 100));
}
