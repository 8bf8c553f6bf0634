// Objects that are very small beside the space that they stand in: they cost what they do alone,
// and every answer is that of the plain objects.
#include "comparison.h"
#include "patience.h"
#include "random_scene.h"

namespace {

using accel_test::Comparison;
using accel_test::kInf;
using accel_test::Owner;

/// Appends 1000 balls and 1000 triangles in a cube of 2 from `corner` on.
void addTown(Owner& owner, const Vec3d& corner, Group& group) {
  Random random(11);
  for (int i = 0; i < 1000; ++i) {
    const Vec3d center = corner + random.inCube(0, 2);
    group.addObject(&owner.make<Sphere>(center, 0.02, owner.material(0)));
    group.addObject(&owner.make<Triangle>(center + Vec3d(0.1, 0, 0), center + Vec3d(0, 0.1, 0),
                                          center + Vec3d(0, 0, 0.1), owner.material(1)));
  }
}

/// Appends a cube of twelve triangles, its faces `distance` from the origin.
void addSky(Owner& owner, double distance, Group& group) {
  for (int axis = 0; axis < 3; ++axis) {
    for (const double side : {-distance, distance}) {
      Vec3d corners[4];
      for (int i = 0; i < 4; ++i) {
        corners[i][axis] = side;
        corners[i][(axis + 1) % 3] = i % 2 ? distance : -distance;
        corners[i][(axis + 2) % 3] = i / 2 ? distance : -distance;
      }
      for (const int middle : {1, 2}) {
        group.addObject(
            &owner.make<Triangle>(corners[0], corners[middle], corners[3], owner.material(2)));
      }
    }
  }
}

/// What rays through the town at the origin take.
RayTestCounts costOf(const Group& group) {
  TestTally tally;
  const CompiledScene scene(group, 1, SimdLevel::automatic, &tally);
  Random random(12);
  for (int i = 0; i < 4000; ++i) {
    const Vec3d to = random.inCube(0, 2);
    Hit hit;
    scene.intersect(Ray({1, 1, 9}, to - Vec3d(1, 1, 9)), hit, 0);
    scene.occluded(Ray(to, {0.3, 1, -0.6}), 0, kInf);
  }
  return tally.total();
}

/// What stands around adds at most 12 primitives, and as many nodes, for each of the 4000 rays.
void expectAtMostTwice(const RayTestCounts& found, const RayTestCounts& alone) {
  const std::uint64_t base = 12 * 4000;
  CHECK(found.nearest.primitives <= 2 * alone.nearest.primitives + base);
  CHECK(found.shadow.primitives <= 2 * alone.shadow.primitives + base);
  CHECK(found.nearest.nodes <= 2 * alone.nearest.nodes + base);
  CHECK(found.shadow.nodes <= 2 * alone.shadow.nodes + base);
}

/// Objects of all sizes from 2^-60 to 2^60, three of each, and among them many of size 1, in two
/// places; a triangle through all that touches balls of every size.
class Scales {
 public:
  Scales() {
    for (int k = -60; k <= 60; k += 2) {
      for (int i = 0; i < 3; ++i) add(std::ldexp(1.0, k), random_.inCube(-4, 4), i);
    }
    for (int i = 0; i < 40; ++i) add(1, random_.inCube(-9, 9), i);
    for (int i = 0; i < 40; ++i) add(1, random_.inCube(-9, 9) + Vec3d(1e9, -3e8, 2e8), i);
  }
  Group& root() { return root_; }
  Random& random() { return random_; }

  /// A ray at one of them, from near it or from another.
  Ray ray() {
    const Place &to = somePlace(), &other = somePlace();
    const Vec3d aim = to.center + random_.ofLength(0, 0.8) * to.size;
    const Vec3d near = to.center + random_.ofLength(1, 6) * to.size;
    const Vec3d from = random_.index(2) ? near : other.center;
    const double distance = maxAbs(aim - from);
    return Ray(from, distance > 0 ? (aim - from) * (1 / distance) : Vec3d(0, 1, 0));
  }
  double size() { return somePlace().size; }

 private:
  struct Place {
    Vec3d center;
    double size;
  };
  const Place& somePlace() { return places_[std::size_t(random_.index(int(places_.size())))]; }

  void add(double size, const Vec3d& place, int kind) {
    const Vec3d center = place * size;
    const Material* material = owner_.material(kind);
    places_.push_back({center, size});
    const auto* ball = &owner_.make<Sphere>(center, size, material);
    if (kind % 3 == 0) {
      root_.addObject(ball);
      // Touches it where it is lowest, and lies in one plane with what else does.
      root_.addObject(&owner_.make<Triangle>(center + Vec3d(-size, -size, -size),
                                             center + Vec3d(size, -size, -size),
                                             center + Vec3d(0, -size, size), material));
    } else if (kind % 3 == 1) {
      const Matrix turn = Matrix::translation(center) * Matrix::rotation({1, 2, 3}, 40) *
                          Matrix::scale({size, -size, size * 0.5});
      root_.addObject(&owner_.make<Transform>(turn, mesh_));
    } else {
      root_.addObject(ball);
      root_.addObject(&owner_.make<Sphere>(center, size, owner_.material(3)));  // the same t twice
    }
  }

  Owner owner_;
  Random random_{21};
  const TriangleMesh* mesh_ =
      &owner_.make<TriangleMesh>(owner_.geometry(shapes::ball(1)), owner_.material(0));
  Group root_;
  std::vector<Place> places_;
};

void expectAsPlain(Scales& scales, const Object3D& root, const Matrix& toWorld, const char* name) {
  Comparison comparison(root, name);
  std::vector<ShadowQuery> queries;
  for (int i = 0; i < casesFor(1500); ++i) {
    const Ray inside = scales.ray();
    const Ray ray(toWorld.transformPoint(inside.getOrigin()),
                  toWorld.transformDirection(inside.getDirection()));
    const double reach = scales.size();
    const double tmin = scales.random().index(4) ? 0 : -reach;
    const double tmax = scales.random().index(3) ? kInf : 5 * reach;
    queries.push_back({ray, tmin, tmax});
  }
  comparison.askAll(queries);
  CHECK(comparison.hits() > casesFor(1500));
}

}  // namespace

TEST("what is huge or far off costs the spheres and triangles of a town no more tests") {
  Owner owner;
  Group alone, underSun, underSky, two;
  for (Group* group : {&alone, &underSun, &underSky, &two}) addTown(owner, {0, 0, 0}, *group);
  const RayTestCounts cost = costOf(alone);
  CHECK(cost.nearest.primitives > 4000);

  underSun.addObject(&owner.make<Sphere>(Vec3d(0, -1e6, 0), 1e6, owner.material(2)));
  underSun.addObject(&owner.make<Sphere>(Vec3d(1e7, 3e7, -2e7), 1e4, owner.material(2)));
  expectAtMostTwice(costOf(underSun), cost);
  addSky(owner, 1e6, underSky);
  expectAtMostTwice(costOf(underSky), cost);
  addTown(owner, {1e6, 3, -1e6}, two);
  addTown(owner, {1e6, 3, 1e7}, two);
  expectAtMostTwice(costOf(two), cost);
}

TEST("objects of sizes from 2^-60 to 2^60 in one space answer as they do plain") {
  Scales scales;
  expectAsPlain(scales, scales.root(), Matrix(), "scales");
}

TEST("so they do under a Transform") {
  Scales scales;
  const Matrix matrix = Matrix::rotation({3, 1, 2}, 70) * Matrix::scale({2, -0.5, 1});
  const Transform transform(matrix, &scales.root());
  expectAsPlain(scales, transform, matrix, "moved scales");
}
