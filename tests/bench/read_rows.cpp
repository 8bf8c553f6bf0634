// Reading OBJ files as the program does, against finding their line ends with memchr.
#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstring>
#include <fstream>
#include <stdexcept>

#include "measure.h"
#include "mesh.h"
#include "process.h"
#include "rows.h"
#include "scene/scene_parser.h"

namespace bench {
namespace {

/// Maps the file, counts its lines with memchr on one thread, and unmaps it.
std::size_t countLines(const std::string& path) {
  const int file = open(path.c_str(), O_RDONLY);
  struct stat status {};
  if (file < 0 || fstat(file, &status) != 0) throw std::runtime_error(path + ": cannot be read");
  const auto size = std::size_t(status.st_size);
  void* const data = mmap(nullptr, size, PROT_READ, MAP_PRIVATE, file, 0);
  close(file);
  if (data == MAP_FAILED) throw std::runtime_error(path + ": cannot be mapped");
  const char* place = static_cast<const char*>(data);
  const char* const end = place + size;
  std::size_t lines = 0;
  while (const void* found = std::memchr(place, '\n', std::size_t(end - place))) {
    place = static_cast<const char*>(found) + 1;
    ++lines;
  }
  munmap(data, size);
  return lines;
}

void runSize(const BenchOptions& options, const Size& size) {
  const ScratchFolder folder;
  const std::string obj = folder.file("mesh.obj"), scene = folder.file("scene.txt");
  const MeshGeometry mesh = displacedSphere(cutsForTriangles(size.triangles));
  writeObj(mesh, obj);
  std::ofstream(scene)
      << "PerspectiveCamera { center 0 0 5 direction 0 0 -1 up 0 1 0 angle 40 }\n"
         "Materials { numMaterials 1 PhongMaterial { diffuseColor 1 1 1 } }\n"
         "Group { numObjects 1 MaterialIndex 0 TriangleMesh { obj_file mesh.obj } }\n";
  const std::size_t expected = mesh.getVertices().size() + mesh.getFaces().size();
  const auto read = [&] {
    std::unique_ptr<SceneParser> parser;
    return secondsOf(Clock::wall, 1,
                     [&] { parser = std::make_unique<SceneParser>(scene.c_str()); });
  };
  const auto findLineEnds = [&] {
    std::size_t lines = 0;
    const double seconds = secondsOf(Clock::wall, 1, [&] { lines = countLines(obj); });
    if (lines != expected) throw std::runtime_error(obj + ": lines are missing");
    return seconds;
  };
  struct stat status {};
  stat(obj.c_str(), &status);
  const std::vector<Samples> seconds = inTurns(options.rounds, {read, findLineEnds});
  const double megabytes = double(status.st_size) / 1e6;
  printRow("read OBJ, " + size.name, "ms", seconds[0].scaled(1e3), "memchr", seconds[1].scaled(1e3),
           {3, 1.5});
  printRow("read OBJ, " + size.name, "MB/s", seconds[0].inverted(megabytes), "memchr",
           seconds[1].inverted(megabytes));
}

}  // namespace

void runReadRows(const BenchOptions& options) {
  printHeading("Reading");
  for (const Size& size : options.sizes) runSize(options, size);
}

}  // namespace bench
