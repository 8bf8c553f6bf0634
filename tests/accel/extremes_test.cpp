// The compiled scene where numbers or counts are extreme, and with objects that it does not know.
#include "check.h"
#include "comparison.h"
#include "patience.h"
#include "random_scene.h"

using accel_test::Comparison;
using accel_test::kInf;
using accel_test::levels;
using accel_test::moved;
using accel_test::Owner;

namespace {

/// A box-shaped object that the compiled scene knows nothing of: it is met where the ray enters
/// the cube [-half, half]^3.
class Block : public Object3D {
 public:
  Block(double half, bool bounded, const Material* material)
      : half_(half), bounded_(bounded), material_(material) {}

  bool intersect(const Ray& ray, Hit& hit, double tmin) const override {
    double enter = -kInf, leave = kInf;
    int enterAxis = 0;
    for (int axis = 0; axis < 3; ++axis) {
      const double o = ray.getOrigin()[axis], d = ray.getDirection()[axis];
      if (d == 0 && std::fabs(o) > half_) return false;
      if (d == 0) continue;
      const double a = (-half_ - o) / d, b = (half_ - o) / d;
      if (std::min(a, b) > enter) enterAxis = axis;
      enter = std::max(enter, std::min(a, b));
      leave = std::min(leave, std::max(a, b));
    }
    if (!(enter <= leave && enter > tmin && enter < hit.getT())) return false;
    Vec3d normal;
    normal[enterAxis] = ray.getDirection()[enterAxis] > 0 ? -1 : 1;
    const Vec3d point = ray.pointAtParameter(enter);
    hit.record(enter, material_, normal, point, {this, 7, magnitudeOf(enter, point, ray, half_)});
    return true;
  }
  void addBounds(const Matrix& toWorld, BoundingBox& box) const override {
    for (int corner = 0; corner < 8 && bounded_; ++corner) {
      box.extend(toWorld.transformPoint(
          {corner & 1 ? half_ : -half_, corner & 2 ? half_ : -half_, corner & 4 ? half_ : -half_}));
    }
  }
  bool isBounded() const override { return bounded_; }

 private:
  double half_;
  bool bounded_;
  const Material* material_;
};

/// A sphere that is seen as twice as large.
class DoubledSphere : public Sphere {
 public:
  using Sphere::Sphere;
  bool intersect(const Ray& ray, Hit& hit, double tmin) const override {
    if (!doubled().intersect(ray, hit, tmin)) return false;
    const Vec3d& point = hit.getIntersectionPoint();
    hit.record(hit.getT(), hit.getMaterial(), hit.getNormal(), point,
               {this, 0, magnitudeOf(hit.getT(), point, ray, 1)});
    return true;
  }
  bool occluded(const Ray& ray, double tmin, double tmax) const override {
    return doubled().occluded(ray, tmin, tmax);
  }
  void addBounds(const Matrix& toWorld, BoundingBox& box) const override {
    doubled().addBounds(toWorld, box);
  }

 private:
  Sphere doubled() const { return {getCenter(), 2 * getRadius(), getMaterial()}; }
};

/// Of a group only its first object is seen.
class FirstOnly : public Group {
 public:
  bool intersect(const Ray& ray, Hit& hit, double tmin) const override {
    return getObjects()[0]->intersect(ray, hit, tmin);
  }
  bool occluded(const Ray& ray, double tmin, double tmax) const override {
    return getObjects()[0]->occluded(ray, tmin, tmax);
  }
};

Ray rayTo(Random& random, const Vec3d& aim, double size) {
  const Vec3d direction = random.unitVector();
  return {aim - direction * (size * random.uniform(0.1, 3)), direction};
}

void expectSame(const Comparison& comparison, int leastHits) {
  CHECK_EQUAL(comparison.firstFailure(), "");
  CHECK(comparison.hits() >= casesFor(leastHits));
}

/// A row of `count` balls along x, two apart.
void addRow(Owner& owner, Group& group, int count) {
  for (int i = 0; i < count; ++i) {
    group.addObject(&owner.make<Sphere>(Vec3d(2.0 * i, 0, 0), 0.5, owner.material(i)));
  }
}

}  // namespace

TEST("an object of a class of its own works, bounded or not, alone, among many and transformed") {
  for (const bool bounded : {true, false}) {
    Owner owner;
    Group group;
    const Block& block = owner.make<Block>(0.7, bounded, owner.material(1));
    group.addObject(&block);
    addRow(owner, group, 20);
    for (int i = 0; i < 20; ++i) {
      const Matrix place = Matrix::translation({2.0 * i, 3, 0}) *
                           Matrix::rotation({1, 2, 3}, 17.0 * i) * Matrix::scale({1, -2, 0.5});
      group.addObject(&owner.make<Transform>(place, &block));
    }
    Comparison comparison(group, "blocks");
    Random random(31);
    for (int i = 0; i < casesFor(3000); ++i) {
      const Vec3d aim{random.uniform(0, 40), random.uniform(-1, 5), 0};
      const Ray ray = rayTo(random, aim, 3);
      comparison.ask(ray, 0, kInf);
      comparison.askCrossings(ray);
      comparison.askBatch(std::vector<Ray>(9, ray), 0, kInf);
    }
    expectSame(comparison, 1000);
  }
}

TEST("a class derived from a known one is asked through its own functions") {
  Owner owner;
  Group group;
  addRow(owner, group, 5);
  for (int i = 0; i < 5; ++i) {
    group.addObject(&owner.make<DoubledSphere>(Vec3d(2.0 * i, 4, 0), 0.4, owner.material(i)));
  }
  FirstOnly& some = owner.make<FirstOnly>();
  some.addObject(&owner.make<Sphere>(Vec3d(0, 8, 0), 0.5, owner.material(0)));
  some.addObject(&owner.make<Sphere>(Vec3d(2, 8, 0), 0.5, owner.material(0)));
  group.addObject(&some);
  group.addObject(&owner.make<Transform>(Matrix::translation({5, 0, 0}), &some));
  Comparison comparison(group, "derived");
  Random random(32);
  for (int i = 0; i < casesFor(3000); ++i) {
    comparison.ask(rayTo(random, {random.uniform(-1, 11), random.uniform(-1, 9), 0}, 3), 0, kInf);
  }
  expectSame(comparison, 500);
}

TEST("triangles and spheres of 1e-20 and of 1e20 stand in one scene") {
  Random random(33);
  for (int round = 0; round < casesFor(20); ++round) {
    Owner owner;
    Group group;
    std::vector<std::pair<Vec3d, double>> places;  // what to aim at, and its size
    for (int i = 0; i < 30; ++i) {
      const double size = random.logUniform(1e-24, 1e22);
      const Vec3d at = random.index(2) ? Vec3d() : random.inCube(-1, 1) * size * 3;
      const Vec3d a = at + random.inCube(-1, 1) * size, b = at + random.inCube(-1, 1) * size,
                  c = at + random.inCube(-1, 1) * size;
      if (random.index(2)) {
        group.addObject(&owner.make<Triangle>(a, b, c, owner.material(i)));
        places.emplace_back((a + b + c) * (1 / 3.0), size);
      } else {
        group.addObject(&owner.make<Sphere>(a, size, owner.material(i)));
        places.emplace_back(a, size);
      }
    }
    Comparison comparison(group, "sizes " + std::to_string(round));
    for (int i = 0; i < 600; ++i) {
      const auto& [aim, size] = places[std::size_t(random.index(30))];
      comparison.ask(rayTo(random, aim, size), 0, kInf);
      comparison.askCrossings(rayTo(random, aim, size * 1e3));
    }
    expectSame(comparison, 300);
  }
}

TEST("a mesh of triangles from 1e-24 to 1 is hit wherever the double function says") {
  Random random(34);
  for (int round = 0; round < casesFor(20); ++round) {
    Owner owner;
    std::vector<Vec3f> vertices;
    std::vector<MeshGeometry::Face> faces;
    for (std::uint32_t i = 0; i < 60; ++i) {
      const double size = i ? random.logUniform(1e-24, 1) : 1;
      for (int k = 0; k < 3; ++k) vertices.emplace_back(random.inCube(-1, 1) * size);
      faces.push_back({3 * i, 3 * i + 1, 3 * i + 2});
    }
    const auto& mesh =
        owner.make<TriangleMesh>(owner.geometry(MeshGeometry(vertices, faces)), owner.material(0));
    Comparison comparison(mesh, "mesh of sizes " + std::to_string(round));
    for (int i = 0; i < 300; ++i) {
      const std::uint32_t face = std::uint32_t(random.index(60));
      const MeshGeometry& g = mesh.getGeometry();
      const Vec3d aim = (g.corner(face, 0) + g.corner(face, 1) + g.corner(face, 2)) * (1 / 3.0);
      const double size = length(g.corner(face, 0) - aim);
      comparison.ask(rayTo(random, aim, size), 0, kInf);
      const Vec3d eye = aim + random.unitVector() * size;
      std::vector<Ray> rays;
      for (int k = 0; k < 16; ++k)
        rays.emplace_back(eye, aim - eye + random.inCube(-0.1, 0.1) * size);
      comparison.askBatch(rays, 0, kInf);
    }
    expectSame(comparison, 1000);
  }
}

TEST("rays from beyond all measure, with odd directions and numbers, neither crash nor differ") {
  Owner owner;
  Group group;
  addRow(owner, group, 6);
  group.addObject(&owner.make<TriangleMesh>(owner.geometry(shapes::ball(2)), owner.material(0)));
  for (int i = 0; i < 6; ++i) {
    const Vec3d at(0, 2.0 * i, 0);
    group.addObject(
        &owner.make<Triangle>(at, at + Vec3d(1, 0, 0), at + Vec3d(0, 1, 1), owner.material(2)));
  }
  Comparison comparison(group, "far");
  Random random(35);
  const double odd[] = {0, -0.0, 1, 1e-300, 5e-324, 1e100, kInf, -kInf, std::nan("")};
  for (int i = 0; i < casesFor(4000); ++i) {
    const Vec3d aim{random.uniform(0, 10), random.index(2) ? 0 : random.uniform(0, 10), 0};
    const double away = random.logUniform(1e3, 1e280);
    Vec3d direction = random.index(2) ? random.unitVector() : Vec3d();
    if (direction == Vec3d()) direction[random.index(3)] = random.index(2) ? 1 : -1;
    Ray ray(aim - direction * away, direction);
    comparison.ask(ray, 0, kInf);
    comparison.ask(ray, -kInf, kInf);
    ray = Ray(aim, direction * random.logUniform(1e-140, 1e140));
    comparison.ask(ray, 0, kInf);
    Vec3d o = aim, d = direction;
    (random.index(2) ? o : d)[random.index(3)] = odd[random.index(9)];
    if (maxAbs(d) < 1e-140) d[2] = 1;  // squares of directions must not underflow
    comparison.ask(Ray(o, d), 0, kInf);
    comparison.askBatch(std::vector<Ray>(16, Ray(o, d)), 0, kInf);
    comparison.askShadows(std::vector<ShadowQuery>(16, {Ray(o, d), 0, odd[random.index(9)]}));
  }
  expectSame(comparison, 3000);
}

TEST("a mesh of flat faces is never hit, nor does a ray through its origin do harm") {
  Owner owner;
  const std::vector<Vec3f> vertices = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}};
  const auto& mesh = owner.make<TriangleMesh>(
      owner.geometry(MeshGeometry(
          vertices, {{0, 1, 2}, {1, 2, 3}, {0, 0, 1}, {2, 2, 2}, {0, 2, 3}, {3, 2, 1}})),
      owner.material(0));
  Group group;
  group.addObject(&mesh);
  group.addObject(&owner.make<Transform>(Matrix::translation({1, 0, 0}), &mesh));
  Comparison comparison(group, "flat");
  const Ray through({-1, -1, -1}, {1, 1, 1}), along({-1, 0, 0}, {1, 0, 0});
  for (const Ray& ray : {through, along}) {
    comparison.ask(ray, 0, kInf);
    comparison.askCrossings(ray);
    comparison.askBatch(std::vector<Ray>(20, ray), 0, kInf);
    comparison.askShadows(std::vector<ShadowQuery>(20, {ray, 0, 10}));
  }
  expectSame(comparison, 0);
  CHECK_EQUAL(comparison.hits(), 0);
}

TEST("nothing at all is compiled and never hit") {
  const Group nothing(3);
  Comparison comparison(nothing, "nothing");
  comparison.ask(Ray({0, 0, 0}, {0, 0, 1}), -kInf, kInf);
  comparison.askBatch(std::vector<Ray>(64, Ray({0, 0, 0}, {0, 0, 1})), -kInf, kInf);
  expectSame(comparison, 0);
}

TEST("one object under 200 nested Transforms") {
  Owner owner;
  Random random(36);
  const Object3D* mesh =
      &owner.make<TriangleMesh>(owner.geometry(shapes::ball(1)), owner.material(0));
  const Object3D* ball = &owner.make<Sphere>(Vec3d(), 0.5, owner.material(1));
  for (int i = 0; i < 100; ++i) {
    // Each pair of steps leaves things nearly where they were.
    const Vec3d offset = random.inCube(-5, 5);
    const double angle = random.uniform(0, 360);
    for (const Object3D** object : {&mesh, &ball}) {
      *object = &owner.make<Transform>(
          Matrix::translation(offset) * Matrix::rotation({1, 1, 0}, angle), *object);
      *object = &owner.make<Transform>(
          Matrix::rotation({1, 1, 0}, -angle) * Matrix::translation(-offset), *object);
    }
  }
  Group group;
  group.addObject(mesh);
  group.addObject(ball);
  addRow(owner, group, 8);
  Comparison comparison(group, "nested");
  for (int i = 0; i < casesFor(1500); ++i) {
    const double distance = random.index(2) ? 0.5 : random.uniform(0, 1.2);
    const Vec3d aim = random.unitVector() * distance;
    comparison.ask(rayTo(random, aim, 3), 0, kInf);
    if (i < 100) comparison.askCrossings(rayTo(random, aim, 3));
  }
  expectSame(comparison, 500);
}

TEST("Transforms that go far away and come back are hit where the plain objects are") {
  Random random(37);
  for (int round = 0; round < casesFor(60); ++round) {
    Owner owner;
    Group group;
    const double away = random.logUniform(1e3, 1e13);
    for (int i = 0; i < 8; ++i) {
      const Vec3d offset = random.unitVector() * away;
      const Matrix turn = random.rotation();
      const Matrix squeeze = Matrix::scale({1, random.logUniform(1e-5, 1e5), 1});
      Matrix back;
      (Matrix::translation(offset) * turn * squeeze).inverse(back);
      const Object3D& ball = owner.make<Sphere>(Vec3d(2.0 * i, 0, 0), 0.5, owner.material(i));
      const Object3D& inner = owner.make<Transform>(back, &ball);
      group.addObject(&owner.make<Transform>(Matrix::translation(offset) * turn * squeeze, &inner));
    }
    Comparison comparison(group, "away " + check::show(away));
    for (int i = 0; i < 300; ++i) {
      const Vec3d center(2.0 * random.index(8), 0, 0);
      const Vec3d rim = center + random.ofLength(0.999, 1.001) * 0.5;
      comparison.ask(rayTo(random, random.index(2) ? rim : center, 2), 0, kInf);
    }
    expectSame(comparison, 100);
  }
}
