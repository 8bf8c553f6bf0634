// Closed meshes do not leak: at any angle, from 1e-6 to 1e6 of their size away, for single rays and
// for whole pictures.
#include "../accel/comparison.h"
#include "check.h"
#include "image/image.h"
#include "long_world.h"
#include "plain_scene_text.h"
#include "random_plain_mesh.h"
#include "render/renderer.h"

using numbers::LongTriangle;
using numbers::PlainMesh;
using numbers::PlainObject;
using numbers::PlainScene;
using numbers::PlainStep;

namespace {

Vec3d narrow(const numbers::Vec& v) { return {double(v.x()), double(v.y()), double(v.z())}; }

/// A white sky and sun, and white matter that shines only where the sun gets at it.
PlainScene whiteSky() {
  PlainScene scene;
  scene.background = {1, 1, 1};
  scene.materials.emplace_back();
  scene.lights.emplace_back();
  scene.lights[0].place = {-1, -2, -3};
  scene.lights[0].color = {1, 1, 1};
  scene.camera = {true, {0, 0, 0}, {0, 0, -1}, {0, 1, 0}, 100};
  return scene;
}

/// The same body as a mesh of float vertices or as a Group of triangles.
PlainObject body(PlainScene& scene, const PlainMesh& mesh, bool isMesh) {
  PlainObject object;
  object.kind = isMesh ? PlainObject::Kind::mesh : PlainObject::Kind::group;
  if (isMesh) {
    scene.meshes.push_back(mesh);
    return object;
  }
  const auto vertex = [&](int k) { return Vec3d(mesh.vertices[std::size_t(k)]); };
  for (const std::vector<int>& face : mesh.faces) {
    for (std::size_t k = 2; k < face.size(); ++k) {
      PlainObject triangle;
      triangle.kind = PlainObject::Kind::triangle;
      triangle.a = vertex(face[0]);
      triangle.b = vertex(face[k - 1]);
      triangle.c = vertex(face[k]);
      object.children.push_back(triangle);
    }
  }
  return object;
}

/// Turns, stretches and perhaps mirrors the body, and multiplies it by `size`.
PlainObject placed(const PlainObject& inner, double size, Random& random) {
  PlainObject object;
  object.kind = PlainObject::Kind::transform;
  object.steps.resize(3);
  object.steps[0].kind = PlainStep::Kind::uniformScale;
  object.steps[0].f = size;
  object.steps[1].kind = PlainStep::Kind::rotate;
  object.steps[1].v = random.unitVector();
  object.steps[1].f = random.uniform(0, 360);
  object.steps[2].kind = PlainStep::Kind::scale;
  object.steps[2].v = {1, random.uniform(0.3, 2), random.index(2) ? -1.0 : 1.0};
  object.children.push_back(inner);
  return object;
}

/// A ray towards a seam of a face, in a direction that grazes the face.
Ray grazing(const LongTriangle& face, double size, Random& random) {
  const Vec3d corners[3] = {narrow(face.a), narrow(face.a + face.ab), narrow(face.a + face.ac)};
  const int k = random.index(3);
  const double along = random.index(4) ? random.uniform(0, 1) : 0;
  const Vec3d seam = corners[k] + (corners[(k + 1) % 3] - corners[k]) * along;
  const Vec3d normal = narrow(face.normal);
  const Vec3d level = normalize(cross(normal, random.unitVector()));
  const double slope = random.logUniform(1e-15, 1);
  const Vec3d direction = normalize(level + normal * (random.index(2) ? slope : -slope));
  return {seam - direction * (size * random.logUniform(1e-6, 1e6)), direction};
}

/// How many more crossings lead out than in, and the nearest.
class Sum : public CrossingVisitor {
 public:
  Sum(const Object3D& object, const Ray& ray) { object.visitCrossings(ray, *this); }
  void visit(const Crossing& crossing) override {
    out += crossing.leaving ? 1 : -1;
    nearest = std::min(nearest, crossing.t);
  }
  int out = 0;
  double nearest = accel_test::kInf;
};

/// Whether the point is in the plane of a face, and near it, or so nearly that rounding decides on
/// which side.
bool isOnSurface(const numbers::LongWorld& world, const Vec3d& point, double size) {
  const numbers::Vec p = numbers::wide(point);
  for (const numbers::LongObject& object : world.objects()) {
    for (const LongTriangle& face : object.triangles) {
      const numbers::Real height = std::fabs(dot(face.normal, p - face.a));
      if (height < 1e-12L * size && length(p - face.a) < 10 * size) return true;
    }
  }
  return false;
}

/// Forwards, backwards and aside, a line leaves the body as often: never from outside of it, and
/// once from within. False where the ray begins on the surface.
bool expectNoLeak(const Object3D& object, const numbers::LongWorld& world, const Ray& ray,
                  double size, Random& random, check::Cases& cases) {
  const Ray aside(ray.getOrigin(), random.unitVector());
  if (isOnSurface(world, ray.getOrigin(), size)) return false;
  const Ray back(ray.getOrigin(), -ray.getDirection());
  const Sum ahead(object, ray), behind(object, back), beside(object, aside);
  const bool isOne = std::abs(ahead.out) <= 1 && ahead.out == behind.out && ahead.out == beside.out;
  cases.expect(isOne, [&] {
    return accel_test::describe(ray, 0, accel_test::kInf) + ": out " + check::show(ahead.out) +
           " times ahead, " + check::show(behind.out) + " behind, " + check::show(beside.out) +
           " towards " + check::show(aside.getDirection());
  });
  Hit hit;
  const bool found = object.intersect(ray, hit, 0);
  // A ray that only touches an edge meets the body without crossing it.
  cases.expect((ahead.nearest == accel_test::kInf || hit.getT() <= ahead.nearest) &&
                   object.occluded(ray, 0, accel_test::kInf) == found,
               [&] { return accel_test::describe(ray, 0, accel_test::kInf) + " hits elsewhere"; });
  return true;
}

/// Well inside what RandomPlainMesh makes: a ring's first section is its first five vertices.
Vec3d inside(const PlainMesh& mesh) {
  if (mesh.vertices.size() != 45) return {};
  Vec3d sum;
  for (std::size_t k = 0; k < 5; ++k) sum += Vec3d(mesh.vertices[k]) * 0.2;
  return sum;
}

/// Pixels that are not black, of a picture seen from inside with both sides of surfaces lit.
int brightPixels(const SceneParser& scene) {
  RenderOptions options;
  options.shadeBack = true;
  options.epsilon = {Epsilon::Kind::adaptive, 0};
  Image image(48, 48);
  RenderTargets targets;
  targets.color = &image;
  render(RayTracer(scene, CompiledScene(*scene.getGroup(), 2), options), 2, targets);
  int bright = 0;
  for (int i = 0; i < 48 * 48; ++i) bright += image.getPixel(i % 48, i / 48) != Rgb8();
  return bright;
}

}  // namespace

TEST("along any line a closed body is left as often as it is entered, however it is grazed") {
  Random random(61);
  check::Cases cases;
  for (int round = 0; round < 40; ++round) {
    const double size = random.logUniform(1e-6, 1e6);
    PlainScene scene = whiteSky();
    const PlainObject inner = body(scene, numbers::RandomPlainMesh(random).make(), round % 3 != 0);
    scene.objects.push_back(placed(inner, size, random));
    const numbers::SceneFiles files(scene);
    const SceneParser parsed(files.scene().c_str());
    const numbers::LongWorld world(scene);
    accel_test::Comparison comparison(*parsed.getGroup(), "body " + std::to_string(round));
    int asked = 0;
    for (int i = 0; i < 1000; ++i) {
      const auto& objects = world.objects();
      const auto& faces = objects[std::size_t(random.index(int(objects.size())))].triangles;
      const LongTriangle& face = faces[std::size_t(random.index(int(faces.size())))];
      const Ray ray = grazing(face, size, random);
      asked += expectNoLeak(*parsed.getGroup(), world, ray, size, random, cases);
      comparison.ask(ray, 0, accel_test::kInf);
      if (i % 4 == 0) comparison.askCrossings(ray);
    }
    CHECK(asked > 500);
    CHECK_EQUAL(comparison.firstFailure(), "");
  }
  CHECK_EQUAL(cases.firstFailure(), "");
}

TEST("from inside a closed body neither the sky nor the sun is seen, next to its walls either") {
  Random random(62);
  for (int round = 0; round < 40; ++round) {
    const double size = random.logUniform(1e-6, 1e6);
    PlainScene scene = whiteSky();
    const PlainMesh mesh = numbers::RandomPlainMesh(random).make();
    scene.objects.push_back(placed(body(scene, mesh, round % 3 != 0), size, random));
    const numbers::Vec eye =
        numbers::mapOf(scene.objects[0].steps).point(numbers::wide(inside(mesh)));
    const numbers::Vec way = numbers::wide(random.unitVector());
    const numbers::Real wall = numbers::LongWorld(scene).nearest({eye, way, {}}, 0).t;
    scene.camera.center = narrow(eye + way * (wall * (round % 2 ? 1 - 1e-6L : 0)));
    scene.camera.direction = random.unitVector();
    scene.camera.up = random.unitVector();
    const numbers::SceneFiles files(scene);
    CHECK_EQUAL(brightPixels(SceneParser(files.scene().c_str())), 0);
  }
}
