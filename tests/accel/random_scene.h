// Random scenes for comparing the compiled scene with the plain objects, and rays aimed at them.
#pragma once
#include <memory>
#include <vector>

#include "../geometry/shapes.h"
#include "geometry/group.h"
#include "geometry/plane.h"
#include "geometry/sphere.h"
#include "geometry/transform.h"
#include "geometry/triangle.h"
#include "geometry/triangle_mesh.h"
#include "random.h"

namespace accel_test {

/// Owns what a test makes.
class Owner {
 public:
  template <class T, class... Arguments>
  T& make(Arguments&&... arguments) {
    auto object = std::make_unique<T>(std::forward<Arguments>(arguments)...);
    T& made = *object;
    objects_.push_back(std::move(object));
    return made;
  }
  const MeshGeometry* geometry(MeshGeometry geometry) {
    geometries_.push_back(std::make_unique<MeshGeometry>(std::move(geometry)));
    return geometries_.back().get();
  }
  const Material* material(int i) const { return &materials_[i & 3]; }

 private:
  std::vector<std::unique_ptr<Object3D>> objects_;
  std::vector<std::unique_ptr<MeshGeometry>> geometries_;
  const PhongMaterial materials_[4] = {shapes::plainMaterial(), shapes::plainMaterial(),
                                       shapes::plainMaterial(), shapes::plainMaterial()};
};

/// Every vertex moved to scale * v + offset, in float.
inline MeshGeometry moved(const MeshGeometry& mesh, float scale, const Vec3f& offset) {
  std::vector<Vec3f> vertices;
  for (const Vec3f& v : mesh.getVertices()) vertices.push_back(v * scale + offset);
  return MeshGeometry(vertices, mesh.getFaces());
}

/// A scene of `count` objects at the top, about `size` large, around `center`.
class RandomScene {
 public:
  RandomScene(std::uint64_t seed, int count, double size, const Vec3d& center)
      : random_(seed), size_(size), center_(center) {
    for (int i = 0; i < count; ++i) root_.addObject(object(Matrix(), 0));
  }

  const Group& root() const { return root_; }
  Random& random() { return random_; }
  double size() const { return size_; }

  /// A random point in the scene.
  Vec3d somewhere() { return center_ + random_.inCube(-1, 1) * size_; }
  /// A point worth aiming at: a vertex, a point on an edge, the rim of a sphere, or near one.
  Vec3d target() {
    if (targets_.empty()) return somewhere();
    Vec3d point = targets_[std::size_t(random_.index(int(targets_.size())))];
    if (random_.index(2) == 0) {
      point += random_.ofLogLength(1e-17, 1e-3) * size_;
    }
    return point;
  }

  /// A ray of any of the kinds that are hard to get right.
  Ray ray() {
    const Vec3d aim = target();
    switch (random_.index(6)) {
      case 0: {
        const Vec3d from = somewhere();
        return along(from, somewhere() - center_);
      }
      case 1: {  // from far away
        const Vec3d far = center_ + random_.ofLogLength(1e3, 1e9) * size_;
        return along(far, aim - far);
      }
      case 2: {  // along an axis
        Vec3d direction;
        direction[random_.index(3)] = random_.index(2) ? 1 : -1;
        if (random_.index(2)) direction = -direction;  // zeros of both signs
        return {aim - direction * (size_ * random_.uniform(0, 4)), direction};
      }
      case 3: {  // in a plane of two axes
        Vec3d direction = random_.unitVector();
        direction[random_.index(3)] = 0;
        return along(aim - direction * size_, direction);
      }
      case 4: {  // from one vertex or rim to another
        const Vec3d from = target();
        return along(from, aim - from);
      }
      default: {
        const Vec3d from = somewhere();
        return along(from, aim - from);
      }
    }
  }

  double tmin() {
    switch (random_.index(4)) {
      case 0:
        return -kEndless;
      case 1:
        return size_ * random_.uniform(-1, 1);
      default:
        return 0;
    }
  }
  double tmax() { return random_.index(2) ? kEndless : size_ * random_.uniform(0, 5); }

 private:
  static constexpr double kEndless = std::numeric_limits<double>::infinity();
  static constexpr int kDeepest = 3;

  Ray along(const Vec3d& origin, const Vec3d& direction) {
    const double size = length(direction);
    if (!(size > 0)) return {origin, {0, 0, 1}};
    const double factor = random_.index(4) ? 1 : random_.logUniform(1e-6, 1e6);
    return {origin, direction * (factor / size)};
  }

  /// An object that stands under the map `toWorld`, at nesting `depth`.
  const Object3D* object(const Matrix& toWorld, int depth) {
    if (last_ && random_.index(6) == 0) return last_ = copyOf(*last_);  // the same t twice
    const int kind = random_.index(depth < kDeepest ? 12 : 7);
    return last_ = kind < 3    ? sphere(toWorld)
                   : kind < 6  ? triangle(toWorld)
                   : kind == 6 ? (random_.index(4) ? mesh(toWorld) : plane(toWorld))
                   : kind < 8  ? mesh(toWorld)
                   : kind < 9  ? group(toWorld, depth)
                               : transform(toWorld, depth);
  }
  /// The same shape in another material; `object` itself where it is of another kind.
  const Object3D* copyOf(const Object3D& object) {
    if (const auto* ball = dynamic_cast<const Sphere*>(&object)) {
      return &owner_.make<Sphere>(ball->getCenter(), ball->getRadius(), material());
    }
    if (const auto* flat = dynamic_cast<const Triangle*>(&object)) {
      return &owner_.make<Triangle>(flat->getVertex(0), flat->getVertex(1), flat->getVertex(2),
                                    material());
    }
    if (const auto* shape = dynamic_cast<const TriangleMesh*>(&object)) {
      return &owner_.make<TriangleMesh>(&shape->getGeometry(), material());
    }
    return &object;
  }
  const Material* material() { return owner_.material(random_.index(4)); }
  double extent() { return size_ * random_.logUniform(1e-3, 0.5); }
  /// In any direction, of a length as extent's.
  Vec3d stretch() { return random_.ofLogLength(1e-3, 0.5) * size_; }
  void aimAt(const Matrix& toWorld, const Vec3d& p) {
    targets_.push_back(toWorld.transformPoint(p));
  }

  const Object3D* sphere(const Matrix& toWorld) {
    const Vec3d center = somewhere();
    const double radius = extent();
    for (int i = 0; i < 4; ++i) aimAt(toWorld, center + random_.unitVector() * radius);
    aimAt(toWorld, center);
    return &owner_.make<Sphere>(center, radius, material());
  }
  const Object3D* triangle(const Matrix& toWorld) {
    const Vec3d a = somewhere(), b = a + stretch();
    // Some are flat or nearly so.
    const double width = random_.index(5) ? 1 : random_.index(2) ? 0 : 1e-12;
    const Vec3d c = a + (b - a) * 0.5 + stretch() * width;
    aimEdges(toWorld, a, b, c);
    return &owner_.make<Triangle>(a, b, c, material());
  }
  void aimEdges(const Matrix& toWorld, const Vec3d& a, const Vec3d& b, const Vec3d& c) {
    aimAt(toWorld, a);
    aimAt(toWorld, a + (b - a) * random_.uniform(0, 1));
    aimAt(toWorld, b + (c - b) * random_.uniform(0, 1));
    aimAt(toWorld, (a + b + c) * (1 / 3.0));
  }
  const Object3D* plane(const Matrix& toWorld) {
    const Vec3d normal = random_.unitVector(), on = somewhere();
    aimAt(toWorld, on);
    return &owner_.make<Plane>(normal, dot(normal, on), material());
  }
  const Object3D* mesh(const Matrix& toWorld) {
    const float scale = float(extent());
    const MeshGeometry shape = random_.index(2) ? shapes::ball(random_.index(2)) : shapes::cube(1);
    const MeshGeometry* geometry = owner_.geometry(moved(shape, scale, Vec3f(somewhere())));
    for (std::uint32_t face = 0; face < geometry->faceCount(); face += 5) {
      aimEdges(toWorld, geometry->corner(face, 0), geometry->corner(face, 1),
               geometry->corner(face, 2));
    }
    const auto& made = owner_.make<TriangleMesh>(geometry, material());
    return &made;
  }
  const Object3D* group(const Matrix& toWorld, int depth) {
    const int count = random_.index(8);
    Group& made = owner_.make<Group>(count);
    for (int i = 0; i < count; ++i) {
      if (random_.index(6) != 0) made.addObject(i, object(toWorld, depth + 1));
    }
    return &made;
  }
  const Object3D* transform(const Matrix& toWorld, int depth) {
    const Matrix toOrigin = Matrix::translation(-center_);
    const Vec3d factors{factor(), factor(), random_.index(2) ? factor() : 1};
    const Matrix turn = random_.rotation();
    const Matrix matrix = Matrix::translation(center_ + random_.inCube(-0.5, 0.5) * size_) * turn *
                          Matrix::scale(factors) * toOrigin;
    last_ = nullptr;  // an object stands in one space only, or a ray could not say which it leaves
    return &owner_.make<Transform>(matrix, object(toWorld * matrix, depth + 1));
  }
  double factor() {
    const double most = random_.index(4) ? 2 : 1e4, size = random_.logUniform(1 / most, most);
    return random_.index(3) ? size : -size;
  }

  Random random_;
  double size_;
  Vec3d center_;
  Owner owner_;
  Group root_;
  const Object3D* last_ = nullptr;
  std::vector<Vec3d> targets_;
};

}  // namespace accel_test
