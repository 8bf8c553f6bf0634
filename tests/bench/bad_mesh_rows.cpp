// Meshes that defeat a careless tree: whole runs at 400 x 400, against the same program on an
// ordinary mesh of as many triangles.
//   a huge quad     beside a small mesh: bounds that grow with the whole mesh are worth nothing
//   there needles         long thin triangles in all directions, whose boxes overlap identical ones
//   all of them are met at the same distance
#include <cmath>
#include <fstream>

#include "measure.h"
#include "mesh.h"
#include "process.h"
#include "rows.h"

namespace bench {
namespace {

/// Evenly spread over [-1, 1), the next one at each call.
class Spread {
 public:
  float operator()() {
    state_ = state_ * 6364136223846793005u + 1442695040888963407u;
    return float(std::int32_t(state_ >> 32)) * 0x1p-31f;
  }
  Vec3f point() {
    const float x = (*this)(), y = (*this)(), z = (*this)();
    return {x, y, z};
  }

 private:
  std::uint64_t state_ = 1;
};

/// Vertices and faces while they are put together.
struct Soup {
  std::vector<Vec3f> vertices;
  std::vector<MeshGeometry::Face> faces;

  /// A face with corners of its own.
  void add(const Vec3f& a, const Vec3f& b, const Vec3f& c) {
    const auto first = std::uint32_t(vertices.size());
    vertices.insert(vertices.end(), {a, b, c});
    faces.push_back({first, first + 1, first + 2});
  }
};

/// `count` triangles in a cube of side 20 around the origin, with edges up to `length` along one
/// direction of their own and up to `width` along the others.
MeshGeometry scattered(int count, float length, float width) {
  Soup soup;
  Spread spread;
  for (int i = 0; i < count; ++i) {
    const Vec3f corner = spread.point() * 10, along = spread.point() * length;
    soup.add(corner, corner + along, corner + along * 0.5f + spread.point() * width);
  }
  return MeshGeometry(soup.vertices, soup.faces);
}

MeshGeometry withHugeQuad(const MeshGeometry& mesh, float size) {
  Soup soup{mesh.getVertices(), mesh.getFaces()};
  const Vec3f a(-size, -12, -size), b(size, -12, -size), c(size, -12, size), d(-size, -12, size);
  soup.add(a, c, b);
  soup.add(a, d, c);
  return MeshGeometry(soup.vertices, soup.faces);
}

MeshGeometry identical(int count) {
  Soup soup;
  for (int i = 0; i < count; ++i) soup.add({-8, -8, 0}, {8, -8, 0}, {0, 8, 0});
  return MeshGeometry(soup.vertices, soup.faces);
}

constexpr const char* kScene = R"(
PerspectiveCamera { center 0 6 34  direction 0 -0.2 -1  up 0 1 0  angle 50 }
Lights { numLights 1 PointLight { position 25 30 25 color 0.9 0.9 0.9 } }
Background { color 0.3 0.4 0.6 ambientLight 0.1 0.1 0.1 }
Materials { numMaterials 1 PhongMaterial { diffuseColor 0.7 0.6 0.5 reflectiveColor 0.2 0.2 0.2 } }
Group { numObjects 1 MaterialIndex 0 TriangleMesh { obj_file mesh.obj } }
)";

/// The arguments of a run on `mesh`, written to a folder.
std::vector<std::string> runOn(const ScratchFolder& folder, const MeshGeometry& mesh, int side) {
  writeObj(mesh, folder.file("mesh.obj"));
  std::ofstream(folder.file("scene.txt")) << kScene;
  const std::string size = std::to_string(side);
  return {RAYTRACER_PROGRAM,
          "-input",
          folder.file("scene.txt"),
          "-output",
          folder.file("out.tga"),
          "-size",
          size,
          size,
          "-bounces",
          "3",
          "-weight",
          "0.01",
          "-quiet"};
}

void compare(const BenchOptions& options, const std::string& name, const MeshGeometry& bad,
             const MeshGeometry& ordinary) {
  const ScratchFolder badFolder, ordinaryFolder;
  const auto ours = runOn(badFolder, bad, 400), theirs = runOn(ordinaryFolder, ordinary, 400);
  const std::vector<Samples> seconds = inTurns(
      options.rounds,
      {[&] { return runProcess(ours).seconds; }, [&] { return runProcess(theirs).seconds; }});
  printRow(name, "ms", seconds[0].scaled(1e3), "ordinary", seconds[1].scaled(1e3), {3, 0});
}

}  // namespace

void runBadMeshRows(const BenchOptions& options) {
  printHeading("Meshes of bad shape, whole runs");
  const MeshGeometry ball = displacedSphere(17);
  for (const float size : {1e4f, 1e6f}) {
    compare(options, "5,780 triangles and a quad of +-" + std::to_string(int(size)),
            withHugeQuad(ball, size), ball);
  }
  for (const int count : {10000, 150000}) {
    const float edge = 20 / std::cbrt(float(count));
    compare(options, std::to_string(count) + " needles", scattered(count, 5, 0.01f),
            scattered(count, edge, edge));
  }
  const ScratchFolder folder;
  const auto words = runOn(folder, identical(150000), 100);
  printAlone("150,000 identical (at most 500)", "ms",
             inTurns(options.rounds, {[&] { return runProcess(words).seconds; }})[0].scaled(1e3));
}

}  // namespace bench
