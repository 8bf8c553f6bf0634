// Meshes of faces that are huge, far away, of very different sizes, or in one place: every answer
// is that of the plain mesh, and other faces cost no more than they do alone.
#include "comparison.h"
#include "patience.h"
#include "random_scene.h"

namespace {

using accel_test::Comparison;
using accel_test::kInf;
using accel_test::Owner;

/// Something of a mesh to look at.
struct Part {
  MeshGeometry shape;
  double size;
  Vec3d center;

  /// A point of it that is hard to hit, or any.
  Vec3d target(Random& random) const {
    const auto face = std::uint32_t(random.index(int(shape.faceCount())));
    const Vec3d a = shape.corner(face, 0), b = shape.corner(face, 1), c = shape.corner(face, 2);
    const int kind = random.index(3);
    if (kind == 0) return a;
    return a + (b - a) * random.uniform(0, 1) + (c - a) * (kind == 1 ? 0 : random.uniform(0, 0.5));
  }
};

/// Balls of 128 faces, and triangles, that become one mesh.
class Parts {
 public:
  void addBall(double size, const Vec3d& center) {
    add(accel_test::moved(shapes::ball(2), float(size), Vec3f(center)), size, center);
  }
  /// A square of two triangles, below all that is above `height`.
  void addGround(float half, float height) {
    const MeshGeometry square({{-half, height, -half},
                               {half, height, -half},
                               {half, height, half},
                               {-half, height, half}},
                              {{0, 2, 1}, {0, 3, 2}});
    add(square, half, {0, height, 0});
  }
  void add(const MeshGeometry& shape, double size, const Vec3d& center) {
    const auto first = std::uint32_t(vertices_.size());
    for (const Vec3f& v : shape.getVertices()) vertices_.push_back(v);
    for (const MeshGeometry::Face& face : shape.getFaces()) {
      faces_.push_back({face[0] + first, face[1] + first, face[2] + first});
    }
    parts_.push_back({shape, size, center});
  }
  MeshGeometry geometry() const { return MeshGeometry(vertices_, faces_); }
  int count() const { return int(parts_.size()); }
  const Part& operator[](int i) const { return parts_[std::size_t(i)]; }

 private:
  std::vector<Vec3f> vertices_;
  std::vector<MeshGeometry::Face> faces_;
  std::vector<Part> parts_;
};

/// A ray that aims at one part, from near it, or from another.
Ray rayAt(const Parts& parts, Random& random) {
  const Part& part = parts[random.index(parts.count())];
  const Vec3d to = part.target(random);
  Vec3d from = part.center + random.ofLength(0, 4) * part.size;
  if (random.index(3) == 0) from = parts[random.index(parts.count())].target(random);
  Vec3d direction = to - from;
  if (random.index(4) == 0) direction[random.index(3)] = 0;
  const double length = maxAbs(direction);
  return Ray(from, length > 0 ? direction * (1 / length) : Vec3d(0, 1, 0));
}

/// Asks all questions, ray by ray and many at once, of a mesh of the parts and of its Transform.
void expectAsPlain(const Parts& parts, const char* name, std::uint64_t seed) {
  Owner owner;
  const auto* geometry = owner.geometry(parts.geometry());
  const auto& mesh = owner.make<TriangleMesh>(geometry, owner.material(0));
  const Matrix matrix = Matrix::rotation({1, 2, 3}, 40) * Matrix::scale({1.5, -1, 0.75});
  const auto& transform = owner.make<Transform>(matrix, &mesh);
  const Object3D* const roots[] = {&mesh, &transform};
  for (const Object3D* root : roots) {
    Comparison comparison(*root, name);
    Random random(seed);
    std::vector<ShadowQuery> queries;
    for (int i = 0; i < casesFor(600); ++i) {
      Ray ray = rayAt(parts, random);
      const double reach = parts[random.index(parts.count())].size;
      if (root == &transform) {
        ray = Ray(matrix.transformPoint(ray.getOrigin()),
                  matrix.transformDirection(ray.getDirection()));
      } else if (random.index(8) == 0) {
        ray.setSource(&mesh, std::uint32_t(random.index(int(geometry->faceCount()))));
      }
      const double tmin = random.index(4) ? 0 : reach * random.uniform(-1, 1);
      const double tmax = random.index(3) ? kInf : reach * random.uniform(0, 5);
      queries.push_back({ray, tmin, tmax});
    }
    comparison.askAll(queries);
    CHECK(comparison.hits() > casesFor(600) / 2);
  }
}

/// What a table of rays towards the first part, from around it, takes.
RayTestCounts costOf(const Parts& parts) {
  const MeshGeometry geometry = parts.geometry();
  const PhongMaterial material = shapes::plainMaterial();
  const TriangleMesh mesh(&geometry, &material);
  TestTally tally;
  const CompiledScene scene(mesh, 1, SimdLevel::automatic, &tally);
  Random random(7);
  Arena arena;
  RayTable rays(arena, 1000, false);
  for (int i = 0; i < rays.count; ++i) {
    const Vec3d from = parts[0].center + random.unitVector() * (3 * parts[0].size);
    const Vec3d to = parts[0].target(random);
    rays.setRow(i, Ray(from, to - from), 0, kInf);
  }
  bool blocked[1000];
  scene.occludedAll(rays, blocked, arena);
  HitTable hits(arena, rays.count);
  scene.intersectAll(rays, hits, arena);
  return tally.total();
}

void expectAtMostTwice(const RayTestCounts& found, const RayTestCounts& alone) {
  // A ground in sight adds a box and two faces for each of the rays.
  const std::uint64_t base = 4000;
  CHECK(found.nearest.primitives <= 2 * alone.nearest.primitives + base);
  CHECK(found.shadow.primitives <= 2 * alone.shadow.primitives + base);
  CHECK(found.nearest.nodes <= 2 * alone.nearest.nodes + base);
  CHECK(found.shadow.nodes <= 2 * alone.shadow.nodes + base);
}

}  // namespace

TEST("a mesh on a ground of any size answers as the plain mesh") {
  for (const float half : {1e2f, 1e4f, 1e6f, 1e9f, 1e13f}) {
    Parts parts;
    parts.addBall(1, {0.5, 1, 0});
    parts.addGround(half, -0.25f);
    expectAsPlain(parts, "ground", std::uint64_t(half));
  }
}

TEST("clusters of all sizes in one mesh, beside and in one another, answer as the plain mesh") {
  Parts nested, beside;
  for (int k = 0; k < 6; ++k) {
    const double size = std::ldexp(1.0, -7 * k);
    nested.addBall(size, {0, 0, 0});
    beside.addBall(size, {3 * size, 0.5 * size, -2 * size});
  }
  expectAsPlain(nested, "nested", 1);
  expectAsPlain(beside, "beside", 2);
}

TEST("faces far from all others leave a mesh as it is") {
  Parts parts;
  parts.addBall(1, {1, 2, 3});
  parts.addBall(1e-3, {1e6, -2e6, 3e5});
  parts.addGround(0.01f, 1e8f);
  expectAsPlain(parts, "far", 3);
}

TEST("a huge, far or nested neighbour costs the faces of a ball no more tests") {
  Parts alone;
  alone.addBall(1, {0.5, 1, 0});
  const RayTestCounts cost = costOf(alone);
  CHECK(cost.nearest.primitives > 4000);
  for (const float half : {1e3f, 1e5f, 1e7f, 1e10f}) {
    Parts onGround = alone, far = alone, nested = alone;
    onGround.addGround(half, -0.25f);
    far.addBall(1, {half, -half, half});
    for (double size = 100; size < half; size *= 100) nested.addBall(size, {-2 * size, 0, 0});
    expectAtMostTwice(costOf(onGround), cost);
    expectAtMostTwice(costOf(far), cost);
    expectAtMostTwice(costOf(nested), cost);
  }
}

TEST("faces of equal corners answer as the plain mesh, to rays that leave one of them too") {
  Parts parts;
  parts.addBall(1, {0, 0, 0});
  const std::vector<Vec3f> corners = {{-1, -1, 0.25f}, {1, -1, 0.5f}, {0, 1, 0.25f}};
  for (std::uint32_t i = 0; i < 300; ++i) {
    // By turns the same, and turned; then another two.
    const std::uint32_t turn = i < 150 ? i % 2 : 0;
    const float higher = i < 200 ? 0.0f : i % 2 ? 0.5f : 0.75f;
    std::vector<Vec3f> own;
    for (const Vec3f& v : corners) own.push_back(v + Vec3f(0, 0, higher));
    parts.add(MeshGeometry(own, {{turn, (turn + 1) % 3, (turn + 2) % 3}}), 1, {0, 0, 0});
  }
  expectAsPlain(parts, "equal", 4);

  const MeshGeometry geometry = parts.geometry();
  const PhongMaterial material = shapes::plainMaterial();
  const TriangleMesh mesh(&geometry, &material);
  Comparison comparison(mesh, "leaving");
  Random random(5);
  for (std::uint32_t face = 128; face < geometry.faceCount(); face += face < 140 ? 1 : 13) {
    const Part& part = parts[int(face - 127)];
    for (int i = 0; i < 10; ++i) {
      Ray ray(part.target(random), random.unitVector());
      ray.setSource(&mesh, face);
      comparison.ask(ray, -1e-9, kInf);
      comparison.ask(ray, 0, kInf);
    }
  }
  CHECK_EQUAL(comparison.firstFailure(), "");
}

TEST("a thousand faces in one place cost what a few do") {
  // A ray that meets the square is tested against two faces once and the ball as often as alone.
  Parts few, many;
  few.addGround(1, 0);
  many.addGround(1, 0);
  for (int i = 0; i < 500; ++i) many.addGround(1, 0);
  few.addBall(1, {9, 0, 0});
  many.addBall(1, {9, 0, 0});
  expectAtMostTwice(costOf(many), costOf(few));
}
