// Smooth meshes and texture coordinates: what the compiled scene and the grid give is what the
// plain objects give, bit for bit.
#include "check.h"
#include "comparison.h"
#include "random_scene.h"

using accel_test::Comparison;
using accel_test::kInf;
using accel_test::Owner;

namespace {

/// A ball with smooth normals, on a third of whose faces some corner has no texture coordinates.
MeshGeometry smoothBall() {
  MeshGeometry ball = shapes::ball(2);
  MeshShading shading;
  Random random(3);
  for (int i = 0; i < 50; ++i) {
    shading.coordinates.emplace_back(float(random.uniform(0, 1)), float(random.uniform(0, 1)));
  }
  for (std::uint32_t face = 0; face < ball.faceCount(); ++face) {
    MeshShading::Face& corners = shading.coordinateFaces.emplace_back();
    for (std::uint32_t& corner : corners) corner = std::uint32_t(random.index(50));
    if (face % 3 == 0) corners[face % 2] = MeshShading::kNone;
  }
  ball.setShading(std::move(shading));
  makeSmooth(ball, MeshNormals::byArea);
  return ball;
}

/// One geometry three times, under no, one and two Transforms, beside flat meshes and shapes. Some
/// stand inside of others.
class SmoothScene {
 public:
  SmoothScene() {
    const MeshGeometry* smooth = owner_.geometry(smoothBall());
    const MeshGeometry* flat = owner_.geometry(shapes::ball(1));
    MeshGeometry corner({{-2, 0, 0}, {0, -2, 0}, {0, 0, -2}}, {{0, 1, 2}});  // asked without a tree
    makeSmooth(corner, MeshNormals::equal);
    const auto mesh = [&](const MeshGeometry* geometry, int material) {
      return &owner_.make<TriangleMesh>(geometry, owner_.material(material));
    };
    const auto moved = [&](const Matrix& matrix, const Object3D* object) {
      return &owner_.make<Transform>(matrix, object);
    };
    Group& inner = owner_.make<Group>(0);
    inner.addObject(
        moved(Matrix::translation({1, 0, 0}) * Matrix::scale({0.5, 2, -1}), mesh(smooth, 1)));
    inner.addObject(mesh(flat, 2));
    root_.addObject(mesh(smooth, 0));
    root_.addObject(moved(Matrix::rotation({1, 2, 3}, 40) * Matrix::scale({1, 0.25, 3}), &inner));
    root_.addObject(moved(Matrix::scale({1.5, 1, 1}), mesh(flat, 3)));
    root_.addObject(mesh(owner_.geometry(std::move(corner)), 1));
    root_.addObject(&owner_.make<Sphere>(Vec3d(2, 1, 0), 0.5, owner_.material(2)));
  }
  const Group& root() const { return root_; }

 private:
  Owner owner_;
  Group root_;
};

Ray rayThrough(Random& random) {
  const Vec3d from = random.unitVector() * 5;
  return {from, random.inCube(-1.5, 1.5) - from};
}

}  // namespace

TEST("at smooth meshes all forms of a scene find the same normals and texture coordinates") {
  const SmoothScene scene;
  Comparison comparison(scene.root());
  Random random(5);
  int smooth = 0, placed = 0;
  std::vector<Ray> rays;
  for (int i = 0; i < 3000; ++i) {
    rays.push_back(rayThrough(random));
    comparison.ask(rays.back(), 0, kInf);
    Hit hit;
    if (!scene.root().intersect(rays.back(), hit, 0)) continue;
    placed += hit.getTextureCoordinates().x() > 0;
    const auto* mesh = dynamic_cast<const TriangleMesh*>(hit.getObject());
    smooth += mesh && !mesh->getGeometry().getShading().isEmpty();
    // On from there, with and without the face that is left.
    Ray next(hit.getIntersectionPoint(), random.unitVector());
    if (i % 2 == 0) next.setSource(hit.getObject(), hit.getFace());
    rays.push_back(next);
    comparison.ask(next, 0, kInf);
  }
  for (const std::size_t size : {2, 3, 500}) {
    for (std::size_t first = 0; first < rays.size(); first += size) {
      const std::size_t last = std::min(first + size, rays.size());
      comparison.askBatch({rays.begin() + long(first), rays.begin() + long(last)}, 0, kInf);
    }
  }
  CHECK_EQUAL(comparison.firstFailure(), "");
  CHECK(smooth > 500 && placed > 200 && placed < smooth);
}
