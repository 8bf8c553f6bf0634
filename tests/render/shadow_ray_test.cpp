// Shadow rays end at the first thing in the way, and want to know no more.
#include "accel/test_tally.h"
#include "accel/grid/grid.h"
#include "check.h"
#include "geometry/group.h"
#include "geometry/sphere.h"
#include "geometry/transform.h"
#include "scene_text.h"

namespace {

/// A ball in the way of the light that counts what it is asked. It has no material: whoever asked
/// for that, or for a normal by way of intersect, would be noticed.
class Blocker : public Sphere {
 public:
  struct Asked {
    int nearest = 0, shadow = 0;
  };
  Blocker(const Vec3d& center, Asked& asked) : Sphere(center, 0.5, nullptr), asked_(&asked) {}

  bool intersect(const Ray& ray, Hit& hit, double tmin) const override {
    ++asked_->nearest;
    return Sphere::intersect(ray, hit, tmin);
  }
  bool occluded(const Ray& ray, double tmin, double tmax) const override {
    ++asked_->shadow;
    return Sphere::occluded(ray, tmin, tmax);
  }
  void visitCrossings(const Ray& ray, CrossingVisitor& visitor) const override {
    ++asked_->nearest;
    Sphere::visitCrossings(ray, visitor);
  }

 private:
  Asked* asked_;
};

/// A floor under a lamp 10 above it.
const char* const kFloor =
    "Lights { numLights 1 PointLight { position 0 10 0 color 1 1 1 } }\n"
    "Materials { numMaterials 1 PhongMaterial { } }\n"
    "Group { numObjects 1 MaterialIndex 0 Plane { normal 0 1 0 offset 0 } }\n";

}  // namespace

TEST("a shadow ray asks up to the first object in the way, and for neither normal nor material") {
  const SceneParser scene = scene_text::parse(kFloor);
  Blocker::Asked asked[3];
  const Blocker aside({5, 5, 0}, asked[0]), between({0, 3, 0}, asked[1]),
      above({0, 6, 0}, asked[2]);
  Group group;
  group.addObject(scene.getGroup());
  for (const Blocker* blocker : {&aside, &between, &above}) group.addObject(blocker);
  const RayTracer tracer(scene, group, RenderOptions());
  Hit hit;  // the floor at the origin
  Ray ray({1, 1, 0}, normalize(Vec3d(-1, -1, 0)));
  CHECK(tracer.traceRay(ray, 0, 0, 1, 1, hit) == Vec3f());
  // The first is asked and not in the way, the second is, and the third is asked no more.
  CHECK_EQUAL(asked[0].shadow, 1);
  CHECK_EQUAL(asked[1].shadow, 1);
  CHECK_EQUAL(asked[2].shadow, 0);
  // By the eye's ray alone.
  for (const Blocker::Asked& each : asked) CHECK_EQUAL(each.nearest, 1);
}

TEST("the plain tree tests every primitive for a hit, but up to the first for a shadow") {
  // Two balls in a group under a Transform, and two more: four primitives, two groups, one
  // Transform.
  Group inner, root;
  const Sphere left({-3, 5, 0}, 1, nullptr), middle({0, 5, 0}, 1, nullptr),
      right({3, 5, 0}, 1, nullptr), far({9, 5, 0}, 1, nullptr);
  inner.addObject(&left);
  inner.addObject(&middle);
  const Transform moved(Matrix::translation({0, 1, 0}), &inner);
  root.addObject(&moved);
  root.addObject(&right);
  root.addObject(&far);
  TestTally tally;
  const CountingTree tree(root, tally);
  const Ray up({0, 0, 0}, {0, 1, 0}), past({0, 0, 5}, {0, 1, 0});
  Hit hit;
  CHECK(tree.intersect(up, hit, 0));
  CHECK_EQUAL(hit.getT(), 5);
  CHECK_EQUAL(tally.total().nearest.primitives, 4u);
  CHECK_EQUAL(tally.total().nearest.nodes, 3u);
  CHECK(tree.occluded(up, 0, 10));  // left, then middle, which is in the way
  CHECK_EQUAL(tally.total().shadow.primitives, 2u);
  CHECK(!tree.occluded(past, 0, 10));  // all four
  CHECK_EQUAL(tally.total().shadow.primitives, 6u);
  CHECK_EQUAL(tally.total().shadow.nodes, 6u);
  CHECK_EQUAL(tally.total().nearest.primitives, 4u);
}

TEST("a grid counts the cells that a ray visits and the objects that they list") {
  // Four balls in a row, one to a cell of side 2 or so: a ray along the row stops in the first
  // cell.
  std::vector<Sphere> balls;
  for (int i = 0; i < 4; ++i) balls.emplace_back(Vec3d(2 * i, 0, 0), 0.5, nullptr);
  Group root;
  for (const Sphere& ball : balls) root.addObject(&ball);
  TestTally tally;
  const Grid counting(root, {4, 1, 1}, &tally);
  Hit hit;
  CHECK(counting.intersect(Ray({-5, 0, 0}, {1, 0, 0}), hit, 0));
  CHECK_EQUAL(tally.total().nearest.nodes, 1u);
  CHECK_EQUAL(tally.total().nearest.primitives, 1u);
  // Beside the balls through all cells: at y = 0.4, z = 0.4 a ball of radius 0.5 is missed.
  CHECK(!counting.occluded(Ray({-5, 0.4, 0.4}, {1, 0, 0}), 0, 100));
  CHECK_EQUAL(tally.total().shadow.nodes, 4u);
  CHECK_EQUAL(tally.total().shadow.primitives, 4u);
}
