// Transform: t stays the world's, normals take the inverse transpose, mirrors and nesting.
#include "geometry/transform.h"

#include "geometry/group.h"
#include "geometry/plane.h"
#include "geometry/shapes.h"
#include "geometry/sphere.h"
#include "geometry/triangle.h"
#include "geometry/triangle_mesh.h"
#include "random.h"
#include "vectors.h"

using shapes::kInf;

namespace {

const PhongMaterial kMaterial = shapes::plainMaterial();

Matrix randomMap(Random& random) {
  const auto factor = [&] {
    const double size = random.uniform(0.2, 3);
    return random.index(2) ? size : -size;
  };
  const Matrix scale = Matrix::scale({factor(), factor(), factor()});
  const Matrix turn = random.rotation(), before = random.rotation();
  return Matrix::translation(random.inCube(-5, 5)) * turn * scale * before;
}

}  // namespace

TEST("t, point and normal of a stretched sphere are those of the world") {
  const Sphere sphere({0, 0, 0}, 1, &kMaterial);
  const Transform stretched(Matrix::translation({5, 0, 0}) * Matrix::scale({1, 1, 3}), &sphere);
  Hit hit;
  CHECK(stretched.intersect(Ray({5, 0, 10}, {0, 0, -1}), hit, 0));
  CHECK_NEAR(hit.getT(), 7, 1e-14);
  CHECK_NEAR_VECTOR(hit.getIntersectionPoint(), Vec3d(5, 0, 3), 1e-14);
  CHECK_NEAR_VECTOR(hit.getNormal(), Vec3d(0, 0, 1), 1e-15);
  CHECK_EQUAL(hit.getMaterial(), &kMaterial);
  CHECK_EQUAL(hit.getObject(), &sphere);
}

TEST("the normal of an ellipsoid is the gradient of its equation") {
  // (x/2)^2 + y^2 = 1 at x = 1: y = sqrt(3)/2; the gradient (x/2, 2y) = (1/2, sqrt(3)) has length
  // sqrt(13)/2, so the normal is (1, 2 sqrt(3)) / sqrt(13).
  const Sphere sphere({0, 0, 0}, 1, &kMaterial);
  const Transform squashed(Matrix::scale({2, 1, 1}), &sphere);
  Hit hit;
  CHECK(squashed.intersect(Ray({1, 5, 0}, {0, -1, 0}), hit, 0));
  CHECK_NEAR(hit.getT(), 5 - std::sqrt(3.0) / 2, 1e-14);
  CHECK_NEAR_VECTOR(hit.getNormal(), Vec3d(1, 2 * std::sqrt(3.0), 0) / std::sqrt(13.0), 1e-14);
}

TEST("a sheared plane keeps a unit normal that stands on it") {
  // x' = x + y takes the plane x = 0 to x' = y, whose normal is (1, -1, 0) / sqrt(2).
  const Plane plane({1, 0, 0}, 0, &kMaterial);
  const Transform sheared(Matrix({{1, 1, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}), &plane);
  Hit hit;
  CHECK(sheared.intersect(Ray({5, 2, 0}, {-1, 0, 0}), hit, 0));
  CHECK_NEAR(hit.getT(), 3, 1e-15);
  CHECK_NEAR_VECTOR(hit.getNormal(), Vec3d(1, -1, 0) / std::sqrt(2.0), 1e-15);
  CHECK(!sheared.isBounded());
}

TEST("a mirrored sphere's normal still points outwards") {
  const Sphere sphere({3, 0, 0}, 1, &kMaterial);
  const Transform mirrored(Matrix::scale({-1, 1, 1}), &sphere);
  Hit hit;
  CHECK(mirrored.intersect(Ray({-10, 0, 0}, {1, 0, 0}), hit, 0));
  CHECK_EQUAL(hit.getT(), 6.0);
  CHECK_EQUAL(hit.getNormal(), Vec3d(-1, 0, 0));
}

TEST("a mirrored triangle keeps its front at the front, whatever its winding becomes") {
  const Triangle triangle({0, 0, 0}, {4, 0, 0}, {0, 4, 0}, &kMaterial);  // normal +z
  const Transform mirrored(Matrix::scale({-1, 1, 1}), &triangle);
  Hit hit;
  CHECK(mirrored.intersect(Ray({-1, 1, 5}, {0, 0, -1}), hit, 0));
  CHECK_EQUAL(hit.getNormal(), Vec3d(0, 0, 1));
  const Transform turnedOver(Matrix::scale({1, 1, -1}), &triangle);
  Hit other;
  CHECK(turnedOver.intersect(Ray({1, 1, 5}, {0, 0, -1}), other, 0));
  CHECK_EQUAL(other.getNormal(), Vec3d(0, 0, -1));
}

TEST("nested transforms apply the inner one first") {
  const Sphere sphere({0, 0, 0}, 1, &kMaterial);
  const Transform inner(Matrix::translation({3, 0, 0}), &sphere);
  const Transform outer(Matrix::scale({2, 2, 2}), &inner);  // centre (6, 0, 0), radius 2
  Hit hit;
  CHECK(outer.intersect(Ray({0, 0, 0}, {1, 0, 0}), hit, 0));
  CHECK_EQUAL(hit.getT(), 4.0);
  CHECK_EQUAL(hit.getIntersectionPoint(), Vec3d(4, 0, 0));
  CHECK_EQUAL(hit.getNormal(), Vec3d(-1, 0, 0));
}

TEST("a miss leaves the hit as it was, and limits are in the world's t") {
  const Sphere sphere({0, 0, 0}, 1, &kMaterial);
  const Transform grown(Matrix::scale({4, 4, 4}), &sphere);
  const Ray ray({0, 0, 10}, {0, 0, -1});  // t = 6 and 14
  Hit limited(6), behindNear;
  CHECK(!grown.intersect(ray, limited, 0));
  CHECK_EQUAL(limited.getT(), 6.0);
  CHECK(grown.intersect(ray, behindNear, 6));
  CHECK_EQUAL(behindNear.getT(), 14.0);
  CHECK(grown.occluded(ray, 5, 7));
  CHECK(!grown.occluded(ray, 6, 14));
  CHECK(!grown.occluded(ray, 0, 6));
}

TEST("of a farther object in a Transform nothing is left in the hit") {
  const Sphere near({0, 0, 0}, 1, &kMaterial), far({0, 0, 0}, 1, &kMaterial);
  const Transform behind(Matrix::translation({0, 0, -5}), &far);
  Group group;
  group.addObject(&near);
  group.addObject(&behind);
  Hit hit;
  CHECK(group.intersect(Ray({0, 0.6, 9}, {0, 0, -1}), hit, 0));
  CHECK_EQUAL(hit.getObject(), &near);
  CHECK_NEAR_VECTOR(hit.getNormal(), Vec3d(0, 0.6, 0.8), 1e-15);
  CHECK_NEAR_VECTOR(hit.getIntersectionPoint(), Vec3d(0, 0.6, 0.8), 1e-14);
}

TEST("the normal of a hit deep in groups is moved by every Transform exactly once") {
  const Sphere sphere({0, 0, 0}, 1, &kMaterial), decoy({0, 50, 0}, 1, &kMaterial);
  Group inner, outer;
  inner.addObject(&decoy);
  inner.addObject(&sphere);
  const Transform turn(Matrix::rotation({0, 0, 1}, 90), &inner);
  outer.addObject(&turn);
  outer.addObject(&decoy);
  const Transform turnAgain(Matrix::rotation({0, 0, 1}, 90), &outer);
  Hit hit;
  CHECK(turnAgain.intersect(Ray({9, 0, 0}, {-1, 0, 0}), hit, 0));
  CHECK_EQUAL(hit.getNormal(), Vec3d(1, 0, 0));
}

TEST("a ray keeps its source on the way into a Transform") {
  const Plane plane({0, 0, 1}, 0, &kMaterial);
  const Transform moved(Matrix::translation({0, 0, 5}), &plane);
  Ray ray({0, 0, 6}, {0, 0, -1});
  CHECK(moved.occluded(ray, 0, kInf));
  ray.setSource(&plane, 0);
  CHECK(!moved.occluded(ray, 0, kInf));
  CHECK_EQUAL(moved.toObject(ray).getOrigin(), Vec3d(0, 0, 1));
  CHECK(moved.toObject(ray).leaves(&plane));
}

TEST("crossings in a Transform have the world's t") {
  const Sphere sphere({0, 0, 0}, 1, &kMaterial);
  const Transform grown(Matrix::scale({-4, 4, 4}), &sphere);
  const shapes::CrossingList list(grown, Ray({10, 0, 0}, {-1, 0, 0}));
  CHECK_EQUAL(list.size(), 2);
  CHECK_EQUAL(list[0].t, 6.0);
  CHECK_EQUAL(list[1].t, 14.0);
  CHECK(!list[0].leaving);
  CHECK(list[1].leaving);
}

TEST("a closed mesh in a mirrored Transform is still entered before it is left") {
  MeshGeometry geometry = shapes::cube(1);
  geometry.findWhetherClosed();
  const TriangleMesh mesh(&geometry, &kMaterial);
  const Transform mirrored(Matrix::scale({2, 2, -2}), &mesh);
  const shapes::CrossingList list(mirrored, Ray({0, 0, 10}, {0, 0, -1}));  // through the diagonals
  CHECK_EQUAL(list.size(), 2);
  CHECK_EQUAL(list[0].t, 8.0);
  CHECK_EQUAL(list[1].t, 12.0);
  CHECK(!list[0].leaving);
  CHECK(list[1].leaving);
}

TEST("bounds go through all transforms") {
  const Sphere sphere({1, 0, 0}, 1, &kMaterial);
  const Transform inner(Matrix::scale({1, 2, 3}), &sphere);
  const Transform outer(Matrix::rotation({0, 0, 1}, 90), &inner);
  BoundingBox box;
  outer.addBounds(Matrix::translation({0, 0, 10}), box);
  CHECK_NEAR_VECTOR(box.low(), Vec3d(-2, 0, 7), 1e-14);
  CHECK_NEAR_VECTOR(box.high(), Vec3d(2, 2, 13), 1e-14);
  CHECK(outer.isBounded());
}

TEST("a triangle hit through random nested transforms is the triangle of the moved vertices") {
  Random random(51);
  check::Cases cases;
  while (cases.tried() < 20000) {
    const Vec3d a = random.inCube(-2, 2), b = random.inCube(-2, 2), c = random.inCube(-2, 2);
    const Triangle triangle(a, b, c, &kMaterial);
    const Matrix outerMap = randomMap(random), innerMap = randomMap(random);
    const Transform inner(innerMap, &triangle), outer(outerMap, &inner);
    const Matrix map = outerMap * innerMap;
    const Vec3d p = map.transformPoint(a), q = map.transformPoint(b), r = map.transformPoint(c);
    const double u = random.uniform(0.05, 0.45), v = random.uniform(0.05, 0.45);
    const Vec3d target = p * u + q * v + r * (1 - u - v), origin = random.inCube(-20, 20);
    const Vec3d normal = normalize(cross(q - p, r - p));
    const Vec3d toTarget = target - origin;
    if (length(cross(q - p, r - p)) < 0.5 || std::fabs(dot(normal, normalize(toTarget))) < 0.1)
      continue;
    Hit hit;
    const bool found = outer.intersect(Ray(origin, toTarget), hit, 0);
    const double turned = dot(hit.getNormal(), normal);  // -1 where the map is mirrored
    const bool ok = found && std::fabs(hit.getT() - 1) < 1e-11 &&
                    std::fabs(std::fabs(turned) - 1) < 1e-11 &&
                    length(hit.getIntersectionPoint() - target) < 1e-9;
    cases.expect(ok, [&] { return check::show(origin) + " to " + check::show(target); });
  }
  CHECK_EQUAL(cases.firstFailure(), "");
}
