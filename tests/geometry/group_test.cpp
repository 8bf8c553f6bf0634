// Group: nearest of several, ties, empty slots, and Object3D's answers for a shape of our own.
#include "geometry/group.h"

#include "geometry/plane.h"
#include "geometry/shapes.h"
#include "geometry/sphere.h"
#include "geometry/transform.h"
#include "vectors.h"

using shapes::kInf;

namespace {

const PhongMaterial kFirst = shapes::plainMaterial(), kSecond = shapes::plainMaterial(),
                    kThird = shapes::plainMaterial();

/// Two sheets, z = 1 and z = 3, normals upwards; only intersect is its own.
class TwoSheets : public Object3D {
 public:
  bool intersect(const Ray& ray, Hit& hit, double tmin) const override {
    bool found = false;
    for (double height : {1.0, 3.0}) {
      const double t = (height - ray.getOrigin().z()) / ray.getDirection().z();
      if (!(t > tmin && t < hit.getT())) continue;
      hit.record(t, &kFirst, {0, 0, 1}, ray.pointAtParameter(t), {});
      found = true;
    }
    return found;
  }
};

const Ray kDown({0, 0, 10}, {0, 0, -1});

}  // namespace

TEST("a group gives the nearest of its objects, whatever their order") {
  const Sphere low({0, 0, 0}, 1, &kFirst), high({0, 0, 5}, 1, &kSecond);
  for (bool lowFirst : {true, false}) {
    Group group(2);
    group.addObject(lowFirst ? 0 : 1, &low);
    group.addObject(lowFirst ? 1 : 0, &high);
    Hit hit;
    CHECK(group.intersect(kDown, hit, 0));
    CHECK_EQUAL(hit.getT(), 4.0);
    CHECK_EQUAL(hit.getMaterial(), &kSecond);
    CHECK_EQUAL(hit.getObject(), &high);
  }
}

TEST("at equal t the object that comes first in the scene wins") {
  const Sphere sphere({0, 0, 0}, 1, &kFirst);
  const Plane plane({0, 0, 1}, 1, &kSecond);
  const Sphere same({0, 0, -1}, 2, &kThird);
  const Object3D* const orders[3][3] = {
      {&sphere, &plane, &same}, {&plane, &same, &sphere}, {&same, &sphere, &plane}};
  const Material* const winners[3] = {&kFirst, &kSecond, &kThird};
  for (int i = 0; i < 3; ++i) {
    Group inner, outer;
    inner.addObject(orders[i][1]);
    inner.addObject(orders[i][2]);
    outer.addObject(orders[i][0]);
    outer.addObject(&inner);
    Hit hit;
    CHECK(outer.intersect(kDown, hit, 0));
    CHECK_EQUAL(hit.getT(), 9.0);
    CHECK_EQUAL(hit.getMaterial(), winners[i]);
  }
}

TEST("a slot may be filled beyond the end, and empty slots are passed over") {
  const Sphere sphere({0, 0, 0}, 1, &kFirst);
  Group group(2);
  CHECK_EQUAL(group.getGroupSize(), 2);
  group.addObject(5, &sphere);
  CHECK_EQUAL(group.getGroupSize(), 6);
  Hit hit;
  CHECK(group.intersect(kDown, hit, 0));
  CHECK_EQUAL(hit.getT(), 9.0);
  CHECK(group.occluded(kDown, 0, kInf));
  CHECK_EQUAL(shapes::CrossingList(group, kDown).size(), 2);
  BoundingBox box;
  group.addBounds(Matrix(), box);
  CHECK_EQUAL(box.high(), Vec3d(1, 1, 1));
  CHECK(group.isBounded());
}

TEST("an empty group is never hit") {
  Hit hit(5);
  CHECK(!Group().intersect(kDown, hit, -kInf));
  CHECK(!Group().occluded(kDown, -kInf, kInf));
  CHECK_EQUAL(shapes::CrossingList(Group(), kDown).size(), 0);
  CHECK_EQUAL(hit.getT(), 5.0);
}

TEST("a group keeps strictly to tmin and tmax") {
  const Sphere low({0, 0, 0}, 1, &kFirst), high({0, 0, 5}, 1, &kSecond);  // t = 4, 6, 9, 11
  Group group;
  group.addObject(&low);
  group.addObject(&high);
  Hit third;
  CHECK(group.intersect(kDown, third, 6));
  CHECK_EQUAL(third.getT(), 9.0);
  CHECK(group.occluded(kDown, 4, 6.5));
  CHECK(!group.occluded(kDown, 4, 6));
  CHECK(!group.occluded(kDown, 6, 9));
  CHECK(!group.occluded(kDown, 11, kInf));
}

TEST("a group reports the crossings of all its objects") {
  const Sphere low({0, 0, 0}, 1, &kFirst), high({0, 0, 5}, 1, &kSecond);
  const Plane plane({0, 0, 1}, 2, &kThird);
  Group group;
  group.addObject(&low);
  group.addObject(&plane);
  group.addObject(&high);
  const shapes::CrossingList list(group, kDown);
  CHECK_EQUAL(list.size(), 5);
  const double expected[5] = {4, 6, 8, 9, 11};
  for (int i = 0; i < 5; ++i) CHECK_EQUAL(list[i].t, expected[i]);
}

TEST("a group is bounded when all its objects are, and its box is around them") {
  const Sphere low({0, 0, 0}, 1, &kFirst), high({0, 0, 5}, 1, &kSecond);
  const Plane plane({0, 0, 1}, 2, &kThird);
  Group group;
  group.addObject(&low);
  group.addObject(&high);
  CHECK(group.isBounded());
  group.addObject(&plane);
  CHECK(!group.isBounded());
  BoundingBox box;
  group.addBounds(Matrix::translation({1, 0, 0}), box);
  CHECK_EQUAL(box.low(), Vec3d(0, -1, -1));
  CHECK_EQUAL(box.high(), Vec3d(2, 1, 6));
}

TEST("a shape that only knows intersect answers occluded through it") {
  const TwoSheets sheets;  // t = 7 and 9
  CHECK(sheets.occluded(kDown, 0, kInf));
  CHECK(sheets.occluded(kDown, 7, 9.5));
  CHECK(!sheets.occluded(kDown, 7, 9));
  CHECK(!sheets.occluded(kDown, 0, 7));
  CHECK(!sheets.occluded(kDown, 9, kInf));
  CHECK(sheets.occluded(Ray({0, 0, 0}, {0, 0, -1}), -kInf, 0));
}

TEST("a shape that only knows intersect reports every crossing in front, as an open surface") {
  const TwoSheets sheets;
  const shapes::CrossingList down(sheets, kDown);
  CHECK_EQUAL(down.size(), 2);
  CHECK_EQUAL(down[0].t, 7.0);
  CHECK_EQUAL(down[1].t, 9.0);
  for (int i : {0, 1}) {
    CHECK(!down[i].closed);
    CHECK(!down[i].leaving);
    CHECK_EQUAL(down[i].material, &kFirst);
  }
  const shapes::CrossingList up(sheets, Ray({0, 0, 2}, {0, 0, 1}));
  CHECK_EQUAL(up.size(), 1);
  CHECK(up[0].leaving);
}

TEST("a shape that says nothing of its extent has none") {
  BoundingBox box;
  TwoSheets().addBounds(Matrix(), box);
  CHECK(box.isEmpty());
  CHECK(!TwoSheets().isBounded());
}

TEST("a shape of our own works inside groups and transforms") {
  const TwoSheets sheets;
  const Transform moved(Matrix::translation({0, 0, 4}), &sheets);  // z = 5 and 7
  Group group;
  group.addObject(&moved);
  Hit hit;
  CHECK(group.intersect(kDown, hit, 0));
  CHECK_EQUAL(hit.getT(), 3.0);
  CHECK(group.occluded(kDown, 3.5, 5.5));
  CHECK_EQUAL(shapes::CrossingList(group, kDown).size(), 2);
}
