// Inputs of a gigabyte: read in time and memory that go with their size.
#include <fstream>

#include "cli/hostile_desk.h"

namespace {

using hostile::Desk;
using hostile::kCamera;

/// A gigabyte where memory and disk have room for three of them, else a tenth of that.
std::uintmax_t largeSize(const std::string& folder) {
  constexpr std::uintmax_t kGigabyte = std::uintmax_t(1) << 30;
  std::ifstream in("/proc/meminfo");
  std::uintmax_t kilobytes = 0;
  for (std::string word; in >> word;) {
    if (word == "MemAvailable:") in >> kilobytes;
  }
  const bool hasRoom =
      kilobytes * 1024 > 3 * kGigabyte && std::filesystem::space(folder).available > 3 * kGigabyte;
  return hasRoom && !kHasSanitizer ? kGigabyte : kGigabyte / 10;
}

}  // namespace

TEST("a word of a gigabyte is a mistake on its line, in a scene and in a mesh") {
  const Desk desk;
  const std::uintmax_t size = largeSize(desk.path());
  desk.write("long.txt", kCamera + "\n");
  std::filesystem::resize_file(desk.file("long.txt"), size);  // filled up with zeros
  desk.checkFault(desk.run("-input long.txt -output out.tga", 1500), "long.txt:3", "...");
  desk.write("mesh.txt",
             kCamera + "Group { numObjects 1 Material { }\nTriangleMesh { obj_file long.obj } }");
  desk.write("long.obj", "v 0 0 0\nf ");
  std::filesystem::resize_file(desk.file("long.obj"), size);
  desk.checkFault(desk.run("-input mesh.txt -output out.tga", 4000), "long.obj:2", "\\x00");
}

TEST("a line of a gigabyte of blanks is passed over") {
  const Desk desk;
  const std::uintmax_t size = largeSize(desk.path());
  const auto run =
      check::runProgram("-quiet -threads 2 -input - -output blanks.tga", desk.path(),
                        "{ head -c " + std::to_string(size) +
                            " /dev/zero | tr '\\0' ' '; cat scene.txt; } | timeout 100");
  CHECK_EQUAL(run.status, 0);
  CHECK_EQUAL(desk.run("-input scene.txt -output plain.tga").status, 0);
  CHECK(check::contentOf(desk.file("blanks.tga")) == check::contentOf(desk.file("plain.tga")));
}
