// TriangleMesh: nearest face, ties, no leaks at edges and vertices, and crossings that add up.
#include "geometry/triangle_mesh.h"

#include "geometry/shapes.h"
#include "patience.h"
#include "random.h"
#include "vectors.h"

using shapes::kInf;

namespace {

const PhongMaterial kMaterial = shapes::plainMaterial();

MeshGeometry closedBall() {
  MeshGeometry ball = shapes::ball(3);  // 512 faces
  ball.findWhetherClosed();
  return ball;
}

Vec3d outwardNormal(const MeshGeometry& geometry, std::uint32_t face) {
  const Vec3d a = geometry.corner(face, 0);
  return normalize(cross(geometry.corner(face, 1) - a, geometry.corner(face, 2) - a));
}

/// A point on an edge (in double, so it may be off by an ulp) or at a vertex of a random face.
Vec3d randomSeam(const MeshGeometry& geometry, std::uint32_t face, Random& random) {
  const int corner = random.index(3);
  const Vec3d a = geometry.corner(face, corner), b = geometry.corner(face, (corner + 1) % 3);
  const int kind = random.index(3);
  if (kind == 0) return a;
  return kind == 1 ? (a + b) * 0.5 : a + (b - a) * random.uniform(0, 1);
}

std::string describe(const Ray& ray) {
  return check::show(ray.getOrigin()) + " towards " + check::show(ray.getDirection());
}

/// Where the line enters and leaves the cube [-half, half]^3; low > high where it misses.
void slabs(const Ray& ray, double half, double& low, double& high) {
  low = -kInf;
  high = kInf;
  for (int axis = 0; axis < 3; ++axis) {
    const double o = ray.getOrigin()[axis], d = ray.getDirection()[axis];
    if (d == 0 && std::fabs(o) >= half) high = -kInf;  // beside or in a face: no clean answer
    if (d == 0) continue;
    low = std::max(low, std::min((-half - o) / d, (half - o) / d));
    high = std::min(high, std::max((-half - o) / d, (half - o) / d));
  }
}

}  // namespace

TEST("a mesh is hit on its nearest face, with that face's normal and number") {
  const MeshGeometry geometry = shapes::cube(2);
  const TriangleMesh mesh(&geometry, &kMaterial);
  Hit hit;
  CHECK(mesh.intersect(Ray({1, 0.5, 10}, {0, 0, -1}), hit, 0));
  CHECK_EQUAL(hit.getT(), 8.0);
  CHECK_EQUAL(hit.getNormal(), Vec3d(0, 0, 1));
  CHECK_EQUAL(hit.getMaterial(), &kMaterial);
  CHECK_EQUAL(hit.getObject(), &mesh);
  CHECK_EQUAL(hit.getFace(), 2u);  // face {4, 5, 7}: x above y
  Hit inside;
  CHECK(mesh.intersect(Ray({1, 0.5, 0}, {0, 0, -1}), inside, 0));
  CHECK_EQUAL(inside.getT(), 2.0);
  CHECK_EQUAL(inside.getNormal(), Vec3d(0, 0, -1));
}

TEST("on a shared edge the face that comes first in the file wins") {
  const MeshGeometry geometry = shapes::cube(2);
  const TriangleMesh mesh(&geometry, &kMaterial);
  Hit hit;
  CHECK(mesh.intersect(Ray({1, 1, 10}, {0, 0, -1}), hit, 0));  // on the diagonal from 4 to 7
  CHECK_EQUAL(hit.getFace(), 2u);
  const MeshGeometry reversed({{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}},
                              {{0, 2, 3}, {0, 1, 2}});
  Hit other;
  CHECK(TriangleMesh(&reversed, &kMaterial).intersect(Ray({0, 0, 1}, {0, 0, -1}), other, 0));
  CHECK_EQUAL(other.getFace(), 0u);
}

TEST("tmin and tmax are strict limits of a mesh") {
  const MeshGeometry geometry = shapes::cube(2);
  const TriangleMesh mesh(&geometry, &kMaterial);
  const Ray ray({1, 0.5, 10}, {0, 0, -1});  // t = 8 and 12
  Hit far, none, limited(8), behind;
  CHECK(mesh.intersect(ray, far, 8));
  CHECK_EQUAL(far.getT(), 12.0);
  CHECK(!mesh.intersect(ray, none, 12));
  CHECK(!mesh.intersect(ray, limited, 0));
  CHECK(mesh.occluded(ray, 8, 12.5));
  CHECK(!mesh.occluded(ray, 8, 12));
  CHECK(!mesh.occluded(ray, 0, 8));
  CHECK(mesh.intersect(Ray({1, 0.5, -10}, {0, 0, -1}), behind, -kInf));
  CHECK_EQUAL(behind.getT(), -12.0);
}

TEST("no ray from inside a closed mesh passes its edges or vertices") {
  const MeshGeometry geometry = closedBall();
  CHECK(geometry.isClosed());
  const TriangleMesh mesh(&geometry, &kMaterial);
  Random random(41);
  check::Cases cases;
  for (int i = 0; i < casesFor(100000); ++i) {
    const std::uint32_t face = std::uint32_t(random.index(int(geometry.faceCount())));
    const Vec3d target = randomSeam(geometry, face, random);
    const Vec3d origin = i % 8 == 0 ? Vec3d() : random.inCube(-0.5, 0.5);
    const Ray ray(origin, i % 2 ? normalize(target - origin) : target - origin);
    Hit hit;
    cases.expect(mesh.intersect(ray, hit, 0), [&] { return describe(ray); });
  }
  CHECK_EQUAL(cases.firstFailure(), "");
}

TEST("no ray from outside passes the edges or vertices of a closed mesh") {
  const MeshGeometry geometry = closedBall();
  const TriangleMesh mesh(&geometry, &kMaterial);
  Random random(42);
  check::Cases cases;
  while (cases.tried() < 100000) {
    const std::uint32_t face = std::uint32_t(random.index(int(geometry.faceCount())));
    const Vec3d target = randomSeam(geometry, face, random);
    const Vec3d toTarget = target - random.ofLogLength(1.5, 1000);
    // Steep enough that all faces around the target are met from their fronts.
    if (dot(normalize(toTarget), outwardNormal(geometry, face)) > -0.5) continue;
    const Ray ray(target - toTarget, toTarget);
    Hit hit;
    const bool ok = mesh.intersect(ray, hit, 0) && std::fabs(hit.getT() - 1) < 1e-12;
    cases.expect(ok, [&] { return describe(ray); });
  }
  CHECK_EQUAL(cases.firstFailure(), "");
}

TEST("crossings at the seams of a closed mesh alternate and sum to nothing from outside") {
  const MeshGeometry geometry = closedBall();
  const TriangleMesh mesh(&geometry, &kMaterial);
  Random random(43);
  check::Cases cases;
  for (int i = 0; i < casesFor(20000); ++i) {
    const std::uint32_t face = std::uint32_t(random.index(int(geometry.faceCount())));
    const Vec3d target = randomSeam(geometry, face, random);
    const Vec3d origin = random.ofLength(1.1, 10);
    const Ray ray(origin, target - origin);
    const shapes::CrossingList list(mesh, ray);
    const bool ok = list.surplusOfLeaving() == 0 && list.alternates(1e-12) && list.size() <= 4;
    cases.expect(ok, [&] { return describe(ray) + " crosses " + check::show(list.size()); });
  }
  CHECK_EQUAL(cases.firstFailure(), "");
}

TEST("from inside a closed mesh one more crossing leads out") {
  const MeshGeometry geometry = closedBall();
  const TriangleMesh mesh(&geometry, &kMaterial);
  Random random(44);
  check::Cases cases;
  for (int i = 0; i < casesFor(20000); ++i) {
    const std::uint32_t face = std::uint32_t(random.index(int(geometry.faceCount())));
    const Vec3d origin = random.inCube(-0.5, 0.5);
    const Ray ray(origin, randomSeam(geometry, face, random) - origin);
    const shapes::CrossingList list(mesh, ray);
    const bool ok = list.surplusOfLeaving() == 1 && list.size() == 1 && list[0].closed;
    cases.expect(ok, [&] { return describe(ray) + " crosses " + check::show(list.size()); });
  }
  CHECK_EQUAL(cases.firstFailure(), "");
}

// Whole numbers make edge functions exact, so rays go exactly through edges and vertices, along
// edges, and within faces.
TEST("every ray of a grid of whole numbers crosses a cube as slabs say") {
  MeshGeometry geometry = shapes::cube(2);
  geometry.findWhetherClosed();
  const TriangleMesh mesh(&geometry, &kMaterial);
  check::Cases cases;
  for (int code = 0; code < 9 * 9 * 9 * 125; ++code) {
    const Vec3d origin(code % 9 - 4, code / 9 % 9 - 4, code / 81 % 9 - 4);
    const int turn = code / 729;
    const Vec3d direction(turn % 5 - 2, turn / 5 % 5 - 2, turn / 25 - 2);
    if (direction == Vec3d() || maxAbs(origin) == 2) continue;
    const Ray ray(origin, direction);
    double low, high;
    slabs(ray, 2, low, high);
    const bool inside = maxAbs(origin) < 2, through = low < high && high > 0;
    const shapes::CrossingList list(mesh, ray);
    Hit hit;
    const bool found = mesh.intersect(ray, hit, 0);
    bool ok = list.surplusOfLeaving() == (inside ? 1 : 0) && list.alternates(1e-12);
    if (through) {
      const double t = inside ? high : low;
      ok = ok && found && std::fabs(hit.getT() - t) < 1e-14 && mesh.occluded(ray, 0, kInf) &&
           list.size() == (inside ? 1 : 2) && std::fabs(list[0].t - t) < 1e-14;
    } else if (low > high) {
      ok = ok && list.surplusOfLeaving() == 0;
    }
    cases.expect(ok, [&] { return describe(ray) + " crosses " + check::show(list.size()); });
  }
  CHECK(cases.tried() > 60000);
  CHECK_EQUAL(cases.firstFailure(), "");
}

TEST("a ray that leaves one face never meets that face, but may meet its neighbours") {
  const MeshGeometry geometry = shapes::cube(2);
  const TriangleMesh mesh(&geometry, &kMaterial);
  Ray down({1, 0.5, 2 + 1e-9}, {0, 0, -1});
  down.setSource(&mesh, 2);
  Hit bottom;
  CHECK(mesh.intersect(down, bottom, 0));
  CHECK_NEAR(bottom.getT(), 4, 1e-8);
  CHECK(!mesh.occluded(down, 0, 3));
  Ray across({1, 0.5, 2 + 1e-9}, {-1, 0.2, -1e-3});  // over the diagonal, down into face {4, 7, 6}
  across.setSource(&mesh, 2);
  Hit neighbour;
  across.set({0, 0.7, 2 + 1e-9}, {-1, 0, -1e-3});
  across.setSource(&mesh, 2);
  CHECK(mesh.intersect(across, neighbour, 0));
  CHECK_EQUAL(neighbour.getFace(), 3u);
  CHECK_NEAR(neighbour.getT(), 1e-6, 1e-12);  // 1e-9 down at a slope of 1e-3
}

TEST("one face can be asked alone") {
  const MeshGeometry geometry = shapes::cube(2);
  const TriangleMesh mesh(&geometry, &kMaterial);
  const Ray ray({1, 0.5, 10}, {0, 0, -1});
  double t;
  CHECK(!mesh.nearestRoot(3, ray, 0, kInf, t));
  CHECK(!mesh.nearestRoot(2, ray, 0, 8, t));
  CHECK(!mesh.nearestRoot(2, ray, 8, kInf, t));
  CHECK(mesh.nearestRoot(2, ray, 0, kInf, t));
  CHECK_EQUAL(t, 8.0);
}

TEST("flat faces of a mesh are never hit") {
  const MeshGeometry geometry({{0, 0, 0}, {1, 2, 3}, {2, 4, 6}}, {{0, 1, 2}, {0, 1, 1}, {2, 2, 2}});
  const TriangleMesh mesh(&geometry, &kMaterial);
  for (const Vec3d& target : {Vec3d(0, 0, 0), Vec3d(0.5, 1, 1.5), Vec3d(2, 4, 6)}) {
    Hit hit;
    CHECK(!mesh.intersect(Ray({5, 5, -5}, target - Vec3d(5, 5, -5)), hit, -kInf));
  }
}

TEST("an empty mesh is never hit") {
  const MeshGeometry geometry;
  const TriangleMesh mesh(&geometry, &kMaterial);
  Hit hit;
  CHECK(!mesh.intersect(Ray({0, 0, 1}, {0, 0, -1}), hit, -kInf));
  CHECK(!mesh.occluded(Ray({0, 0, 1}, {0, 0, -1}), -kInf, kInf));
}

TEST("the bounds of a mesh are those of the vertices that its faces name") {
  const MeshGeometry geometry({{0, 0, 0}, {1, 0, 0}, {0, 2, 0}, {0, 0, 1}}, {{0, 1, 2}, {0, 1, 3}});
  BoundingBox box;
  TriangleMesh(&geometry, &kMaterial).addBounds(Matrix::translation({10, 0, 0}), box);
  CHECK_EQUAL(box.low(), Vec3d(10, 0, 0));
  CHECK_EQUAL(box.high(), Vec3d(11, 2, 1));
  CHECK(TriangleMesh(&geometry, &kMaterial).isBounded());
}

TEST("a vertex that no face names does not stretch the bounds") {
  // spec.md: the span is that of the world box of all spheres and triangles.
  const MeshGeometry geometry({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1e6f, 0, 0}}, {{0, 1, 2}});
  BoundingBox box;
  TriangleMesh(&geometry, &kMaterial).addBounds(Matrix(), box);
  CHECK_EQUAL(box.longestSide(), 1.0);
}
