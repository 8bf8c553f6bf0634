// Random plain scenes with a bit of everything: a floor, balls that rest on it, meshes, mirrors,
// glass, nested Groups and Transforms, both cameras, up to three lights.
#pragma once
#include "plain_scene.h"
#include "random_plain_mesh.h"

namespace numbers {

class RandomPlainScene {
 public:
  /// All lengths are about `unit` times 1 to 10.
  RandomPlainScene(std::uint64_t seed, double unit) : random_(seed), unit_(unit) {
    makeMaterials();
    makeLights();
    const int meshes = random_.index(3);
    for (int i = 0; i < meshes; ++i) scene_.meshes.push_back(mesh());
    if (random_.index(3)) makeFloor();
    const int count = 1 + random_.index(7);
    for (int i = 0; i < count; ++i) scene_.objects.push_back(object(0));
    makeCamera();
  }

  const PlainScene& scene() const { return scene_; }
  /// Moves everything by `distance` units in one direction: all objects together in a Transform.
  void moveAway(double distance) {
    const Vec3d way = random_.unitVector() * (distance * unit_);
    PlainObject contents, moved;
    contents.kind = PlainObject::Kind::group;
    contents.children.swap(scene_.objects);
    moved.kind = PlainObject::Kind::transform;
    moved.steps.emplace_back();
    moved.steps[0].v = way;
    moved.children.push_back(contents);
    scene_.objects.push_back(moved);
    scene_.camera.center += way;
    for (PlainLight& light : scene_.lights) {
      if (light.isPoint) light.place += way;
    }
  }

 private:
  Vec3f color(double low, double high) { return Vec3f(random_.inCube(low, high)); }
  Vec3d somewhere(double reach) { return random_.inCube(-reach, reach) * unit_; }
  bool oneIn(int n) { return random_.index(n) == 0; }

  void makeMaterials() {
    const int count = 1 + random_.index(5);
    for (int i = 0; i < count; ++i) {
      PlainMaterial material;
      material.diffuse = color(0, 0.8);
      if (oneIn(2)) material.specular = color(0, 1);
      material.exponent = oneIn(8) ? 0 : float(random_.logUniform(0.5, 5000));
      if (oneIn(3)) material.reflective = color(0, 0.9);
      if (oneIn(3)) material.transparent = color(0.2, 1);
      material.index = oneIn(4) ? 1 : float(random_.uniform(0.7, 2.5));
      scene_.materials.push_back(material);
    }
    scene_.background = color(0, 1);
    scene_.ambient = color(0, 0.3);
  }
  void makeLights() {
    const int count = random_.index(8) ? 1 + random_.index(3) : 0;
    for (int i = 0; i < count; ++i) {
      PlainLight light;
      light.isPoint = oneIn(2);
      light.place = light.isPoint ? somewhere(oneIn(3) ? 1 : 6) : random_.ofLength(0.1, 3);
      if (oneIn(3)) light.place[1] = light.isPoint ? 6 * unit_ : -2;
      light.color = color(0.1, 0.8);
      if (light.isPoint && oneIn(2)) {
        light.attenuation = Vec3f{float(random_.uniform(0.5, 1)), float(0.1 / unit_),
                                  float(random_.uniform(0, 0.02) / (unit_ * unit_))};
      }
      scene_.lights.push_back(light);
    }
  }
  void makeCamera() {
    PlainCamera& camera = scene_.camera;
    camera.isPerspective = !oneIn(3);
    const Vec3d aim = somewhere(0.5);
    Vec3d from = random_.ofLength(3, 8) * unit_;
    if (!oneIn(4)) from[1] = std::fabs(from[1]);
    camera.center = camera.isPerspective && oneIn(6) ? somewhere(1.5) : from;
    camera.direction = (aim - camera.center) * random_.uniform(0.1, 3);
    camera.up = random_.unitVector();
    const double size = random_.uniform(3, 7) * unit_;
    camera.extent = float(camera.isPerspective ? random_.uniform(20, 110) : size);
  }

  int material() { return random_.index(int(scene_.materials.size())); }

  /// A plane, mostly level, and balls whose lowest point is on it.
  void makeFloor() {
    PlainObject floor;
    floor.kind = PlainObject::Kind::plane;
    floor.material = material();
    floor.a = oneIn(4) ? random_.unitVector() * 3.0 : Vec3d(0, 2, 0);
    floor.f = random_.uniform(-2, -1) * unit_;
    scene_.objects.push_back(floor);
    const int balls = random_.index(4);
    for (int i = 0; i < balls; ++i) {
      PlainObject ball;
      ball.f = random_.uniform(0.2, 0.8) * unit_;
      ball.a = somewhere(2);
      ball.a += normalize(floor.a) * (floor.f + ball.f - dot(ball.a, normalize(floor.a)));
      ball.material = material();
      scene_.objects.push_back(ball);
    }
  }

  PlainObject object(int depth) {
    if (depth < 3 && oneIn(5)) return group(depth);
    if (depth < 4 && oneIn(3)) return transform(depth);
    return shape();
  }
  PlainObject shape() {
    PlainObject o;
    o.material = material();
    const int kind = random_.index(8);
    if (kind == 0 && oneIn(3)) {
      o.kind = PlainObject::Kind::plane;
      o.a = random_.inCube(-2, 2);
      o.f = random_.uniform(2, 5) * unit_;
    } else if (kind < 3) {
      o.kind = PlainObject::Kind::triangle;
      o.a = somewhere(2);
      o.b = o.a + somewhere(2);
      o.c = o.a + somewhere(2);
    } else if (kind < 6 && !scene_.meshes.empty()) {
      o.kind = PlainObject::Kind::mesh;
      o.mesh = random_.index(int(scene_.meshes.size()));
    } else {
      o.a = somewhere(2);
      o.f = random_.uniform(0.2, 1.2) * unit_;
    }
    return o;
  }
  PlainObject group(int depth) {
    PlainObject o;
    o.kind = PlainObject::Kind::group;
    const int count = random_.index(4);
    for (int i = 0; i < count; ++i) o.children.push_back(object(depth + 1));
    return o;
  }
  /// Its contents are of one material, whose words stand before the outermost Transform.
  PlainObject transform(int depth) {
    PlainObject o;
    o.kind = PlainObject::Kind::transform;
    o.material = material();
    const int count = 1 + random_.index(4);
    for (int i = 0; i < count; ++i) o.steps.push_back(step());
    o.children.push_back(depth < 3 && oneIn(3) ? transform(depth + 1) : shape());
    setMaterial(o, o.material);
    return o;
  }
  static void setMaterial(PlainObject& o, int material) {
    o.material = material;
    for (PlainObject& child : o.children) setMaterial(child, material);
  }
  PlainStep step() {
    PlainStep s;
    s.kind = PlainStep::Kind(random_.index(8));
    s.f = random_.uniform(-180, 180);
    s.v = somewhere(1.2);
    if (s.kind == PlainStep::Kind::uniformScale) s.f = random_.uniform(0.5, 1.3);
    if (s.kind == PlainStep::Kind::rotate) s.v = random_.inCube(-2, 2);
    if (s.kind == PlainStep::Kind::scale) {
      for (int k = 0; k < 3; ++k) {
        const double factor = random_.uniform(0.4, 1.4);
        s.v[k] = oneIn(4) ? -factor : factor;
      }
    }
    for (int i = 0; i < 12; ++i) {
      if (i % 4 == 3) s.rows[i] = random_.uniform(-1, 1) * unit_;
      if (i % 4 < 3) s.rows[i] = random_.uniform(-0.3, 0.3) + (i % 5 == 0 ? 1 : 0);
    }
    return s;
  }

  /// A quarter of the meshes lack a face.
  PlainMesh mesh() {
    PlainMesh made = RandomPlainMesh(random_).make();
    if (oneIn(4)) {
      made.faces.pop_back();
      made.closed = false;
    }
    const Vec3d away = somewhere(1);
    for (Vec3f& v : made.vertices) v = Vec3f(Vec3d(v) * unit_ + away);
    return made;
  }

  Random random_;
  double unit_;
  PlainScene scene_;
};

}  // namespace numbers
