// Tables of rays that walk a tree together: each row's answer is that of the plain objects for the
// ray alone, whatever the other rows are.
#include "accel/stream.h"

#include "comparison.h"
#include "patience.h"
#include "random_scene.h"

namespace {

using accel_test::CrossingSet;
using accel_test::kInf;
using accel_test::Owner;
using accel_test::RandomScene;
using accel_test::sameBits;

/// A row of a table.
struct Question {
  Ray ray;
  double tmin = 0, tmax = kInf;
};

/// All crossings of each row, as CrossingSet sorts them.
class CrossingsOfRows : public RowCrossingVisitor {
 public:
  explicit CrossingsOfRows(std::size_t rows) : rows_(rows) {}
  void visit(int row, const Crossing& c) override {
    const CrossingSet::Row found = {c.t, c.object, c.material, c.closed, c.leaving};
    rows_[std::size_t(row)].insert(rows_[std::size_t(row)].end(), c.count, found);
  }
  std::vector<CrossingSet::Row> sorted(std::size_t row) const {
    std::vector<CrossingSet::Row> crossings = rows_[row];
    std::sort(crossings.begin(), crossings.end());
    return crossings;
  }

 private:
  std::vector<std::vector<CrossingSet::Row>> rows_;
};

/// What has to be told of the crossings `all`, where `told` was: of what is crossed at t < tmax
/// all, of anything else all or nothing.
std::vector<CrossingSet::Row> wanted(const std::vector<CrossingSet::Row>& all,
                                     const std::vector<CrossingSet::Row>& told, double tmax) {
  std::vector<CrossingSet::Row> rows;
  for (const CrossingSet::Row& crossing : all) {
    const Object3D* const object = std::get<1>(crossing);
    const auto isOfIt = [&](const CrossingSet::Row& row) { return std::get<1>(row) == object; };
    const auto isNear = [&](const auto& row) { return isOfIt(row) && std::get<0>(row) < tmax; };
    if (std::any_of(told.begin(), told.end(), isOfIt) ||
        std::any_of(all.begin(), all.end(), isNear)) {
      rows.push_back(crossing);
    }
  }
  return rows;
}

/// Asks a compiled scene of each instruction set the questions of a table, all together.
class Streams {
 public:
  explicit Streams(const Object3D& root) : root_(root) {
    for (const SimdLevel level : accel_test::levels()) {
      forms_.push_back(std::make_unique<CompiledScene>(root, 1, level));
    }
  }

  void ask(const std::vector<Question>& questions) {
    for (const auto& form : forms_) {
      const Arena::Frame frame(arena_);
      askNearest(*form, questions);
      askBlocked(*form, questions);
      askCrossings(*form, questions);
    }
  }
  int hits() const { return hits_; }
  /// Crossings that nobody had to be told of.
  int leftOut() const { return leftOut_; }
  const std::string& firstFailure() const { return cases_.firstFailure(); }

 private:
  RayTable tableOf(const std::vector<Question>& questions) {
    RayTable rays(arena_, int(questions.size()), true);
    for (int i = 0; i < rays.count; ++i) {
      const Question& q = questions[std::size_t(i)];
      rays.setRow(i, q.ray, q.tmin, q.tmax);
    }
    return rays;
  }
  void expect(bool ok, const CompiledScene& form, const char* what, const Question& q, int row,
              int rows) {
    cases_.expect(ok, [&] {
      return std::string(what) + ", " + nameOf(form.simdLevel()) + ", row " + std::to_string(row) +
             " of " + std::to_string(rows) + ": " + accel_test::describe(q.ray, q.tmin, q.tmax);
    });
  }
  void askNearest(const CompiledScene& form, const std::vector<Question>& questions) {
    const RayTable rays = tableOf(questions);
    HitTable hits(arena_, rays.count);
    form.intersectAll(rays, hits, arena_);
    for (int i = 0; i < rays.count; ++i) {
      const Question& q = questions[std::size_t(i)];
      Hit expected(q.tmax);
      const bool found = root_.intersect(q.ray, expected, q.tmin);
      hits_ += found;
      const bool ok = found ? hits.isFound(i) && sameBits(hits.hitOf(i, rays.tmax[i]), expected)
                            : !hits.isFound(i) && sameBits(rays.tmax[i], q.tmax);
      expect(ok, form, "nearest", q, i, rays.count);
    }
  }
  void askBlocked(const CompiledScene& form, const std::vector<Question>& questions) {
    const RayTable rays = tableOf(questions);
    bool* const blocked = arena_.take<bool>(questions.size());
    form.occludedAll(rays, blocked, arena_);
    for (int i = 0; i < rays.count; ++i) {
      const Question& q = questions[std::size_t(i)];
      expect(blocked[i] == root_.occluded(q.ray, q.tmin, q.tmax), form, "any", q, i, rays.count);
    }
  }
  void askCrossings(const CompiledScene& form, const std::vector<Question>& questions) {
    const RayTable rays = tableOf(questions);
    CrossingsOfRows crossings(questions.size());
    form.visitAllCrossings(rays, crossings, arena_);
    for (std::size_t i = 0; i < questions.size(); ++i) {
      const CrossingSet all(root_, questions[i].ray);
      const auto told = crossings.sorted(i);
      leftOut_ += int(all.size() - told.size());
      expect(told == wanted(all.rows(), told, questions[i].tmax), form, "all", questions[i], int(i),
             rays.count);
    }
  }

  const Object3D& root_;
  std::vector<std::unique_ptr<CompiledScene>> forms_;
  Arena arena_;
  check::Cases cases_;
  int hits_ = 0, leftOut_ = 0;
};

/// Directions of all octants, some with components that are zeros of either sign.
Vec3d anyDirection(Random& random) {
  for (;;) {
    Vec3d direction = random.unitVector();
    for (int axis = 0; axis < 3; ++axis) {
      if (random.index(4) == 0) direction[axis] = random.index(2) ? 0.0 : -0.0;
    }
    if (direction != Vec3d()) return direction;
  }
}

/// One that may look at the scene, away from it, or for nothing at all.
Question anyQuestion(RandomScene& scene) {
  Random& random = scene.random();
  const Vec3d way = anyDirection(random);
  const Vec3d from = scene.target() - way * (scene.size() * random.uniform(-1, 3));
  Question q{Ray(from, way), scene.tmin(), scene.tmax()};
  if (random.index(8) == 0) q.tmax = q.tmin - random.uniform(0, 1);  // nothing counts
  return q;
}

/// As many equal triangles in z = 0, one by one or as the faces of one mesh.
const Object3D& equalTriangles(int count, bool isMesh, Owner& owner, Group& group) {
  const Vec3f corners[] = {{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}};
  if (!isMesh) {
    for (int i = 0; i < count; ++i) {
      group.addObject(&owner.make<Triangle>(Vec3d(corners[0]), Vec3d(corners[1]), Vec3d(corners[2]),
                                            owner.material(i)));
    }
    return group;
  }
  const std::vector<MeshGeometry::Face> faces(std::size_t(count), MeshGeometry::Face{{0, 1, 2}});
  const MeshGeometry* const mesh =
      owner.geometry(MeshGeometry({corners[0], corners[1], corners[2]}, faces));
  group.addObject(&owner.make<TriangleMesh>(mesh, owner.material(0)));
  return group;
}

}  // namespace

TEST("rows of all octants, with zeros in their directions, do not disturb each other") {
  int hits = 0, leftOut = 0;
  for (int i = 0; i < casesFor(40); ++i) {
    RandomScene scene(std::uint64_t(7000 + i), 1 + i % 30, 1, Vec3d());
    Streams streams(scene.root());
    for (const int count : {1, 3, 4, 63, 64, 65, 255, 256, 513, RayTable::kMost}) {
      if (count > 256 && i % 8 != 0) continue;
      std::vector<Question> questions;
      for (int k = 0; k < count; ++k) questions.push_back(anyQuestion(scene));
      streams.ask(questions);
    }
    hits += streams.hits();
    leftOut += streams.leftOut();
    CHECK_EQUAL(streams.firstFailure(), "");
  }
  CHECK(hits > casesFor(2000) && leftOut > casesFor(100));
}

TEST("a ray that is asked many times in one table finds the same each time") {
  RandomScene scene(71, 20, 1, Vec3d());
  Streams streams(scene.root());
  for (int i = 0; i < 20; ++i) {
    std::vector<Question> questions(100, anyQuestion(scene));
    questions[50] = anyQuestion(scene);
    streams.ask(questions);
  }
  CHECK_EQUAL(streams.firstFailure(), "");
}

TEST("a table of rays that all miss, or of which none wants anything, finds nothing") {
  Owner owner;
  Group group;
  Streams streams(equalTriangles(100, true, owner, group));
  std::vector<Question> missing, wanting;
  for (int i = 0; i < RayTable::kMost; ++i) {
    missing.push_back({Ray({3 + i * 0.01, 0, 5}, {0, 0, -1})});
    wanting.push_back({Ray({0, 0, 5}, {0, 0, -1}), 9, 1});  // tmax lies below tmin
  }
  streams.ask(missing);
  streams.ask(wanting);
  CHECK_EQUAL(streams.hits(), 0);
  CHECK_EQUAL(streams.firstFailure(), "");
}

TEST("more triangles at one place than candidates find room are all decided") {
  constexpr int kTriangles = 2000;
  static_assert(kTriangles > accel::Stream::kMostCandidates);
  for (const bool isMesh : {false, true}) {
    Owner owner;
    Group group;
    Streams streams(equalTriangles(kTriangles, isMesh, owner, group));
    // One ray in eight through an edge or a vertex, where no filter can decide.
    Random random(72);
    std::vector<Question> questions;
    const int rays = casesFor(RayTable::kMost);
    for (int i = 0; i < rays; ++i) {
      const Vec3d at = i % 8 ? Vec3d(random.uniform(-1, 1), random.uniform(-1, 1), 0)
                             : Vec3d(i % 16 ? random.uniform(-1, 1) : 1, -1, 0);
      const Vec3d from(random.uniform(-1, 1), random.uniform(-1, 1), i % 2 ? 3 : -3);
      questions.push_back({Ray(from, at - from)});
    }
    streams.ask(questions);
    CHECK(streams.hits() > rays / 4);
    CHECK_EQUAL(streams.firstFailure(), "");
  }
}

TEST("of spheres at one place, plain or under Transforms, each ray meets the first that it can") {
  // Few are asked without a tree, sixteen at a time; with forty more spheres all stand in one.
  for (const int others : {0, 16, 40}) {
    for (int first = 0; first < 4; ++first) {
      Owner owner;
      Group group;
      std::vector<const Object3D*> same;
      for (int i = 0; i < 4; ++i) {
        const int kind = (first + i) % 4;
        const auto& ball = owner.make<Sphere>(Vec3d(), 1, owner.material(i));
        same.push_back(&ball);
        Group& inner = owner.make<Group>();
        inner.addObject(&ball);
        const Object3D& within = kind == 2 ? static_cast<const Object3D&>(inner) : ball;
        const auto& seen = owner.make<Transform>(Matrix(), &within);
        group.addObject(kind == 0 ? static_cast<const Object3D*>(&ball) : &seen);
      }
      group.addObject(&owner.make<Plane>(Vec3d(0, 0, 1), -1, owner.material(0)));  // touches them
      for (int i = 0; i < others; ++i) {
        const auto& ball = owner.make<Sphere>(Vec3d(i % 7 - 3, i % 5 - 2, 3), 0.5, nullptr);
        group.addObject(i % 2 ? static_cast<const Object3D*>(&ball)
                              : &owner.make<Transform>(Matrix::scale({1, 2, 1}), &ball));
      }
      Streams streams(group);
      Random random(73);
      std::vector<Question> questions;
      for (int i = 0; i < casesFor(300); ++i) {
        const Vec3d from = random.unitVector() * (i % 3 == 0 ? 1 : random.uniform(0, 4));
        const Vec3d aim = i % 8 ? random.inCube(-1, 1) : Vec3d(0, 0, -1);
        Ray ray(from, aim - from);
        if (i % 3 == 0) ray.setSource(same[std::size_t(random.index(4))], 0);
        questions.push_back({ray, random.index(4) ? 0.0 : -1.0, random.index(4) ? kInf : 1.0});
      }
      streams.ask(questions);
      CHECK(streams.hits() > casesFor(100));
      CHECK_EQUAL(streams.firstFailure(), "");
    }
  }
}
