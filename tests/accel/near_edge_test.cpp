// The float filter against the double functions, where it is hardest: rays that pass an edge, a
// vertex or a sphere's rim by next to nothing, and bounds next to the hit itself.
#include "check.h"
#include "comparison.h"
#include "patience.h"
#include "random_scene.h"

using accel_test::Comparison;
using accel_test::kInf;
using accel_test::moved;
using accel_test::Owner;

namespace {

/// From the last digit of a double to the whole size.
double anyFraction(Random& random) { return random.logUniform(1e-18, 1); }

/// A point on an edge of `face`, or a vertex, or next to one.
Vec3d nearEdge(Random& random, const Vec3d& a, const Vec3d& b) {
  const double along = random.index(3) ? random.uniform(0, 1) : random.index(2);
  const Vec3d on = a + (b - a) * along;
  if (random.index(4) == 0) return on;
  const double off = length(b - a) * anyFraction(random);
  return on + random.unitVector() * off;
}

Vec3d startOf(Random& random, const Vec3d& aim, double size) {
  const double away = random.index(3) ? random.uniform(0.01, 4) : random.logUniform(1e-6, 1e9);
  return aim + random.unitVector() * (size * away);
}

/// A ray towards `aim`, of any length.
Ray towards(Random& random, const Vec3d& from, const Vec3d& aim) {
  const Vec3d way = aim - from;
  return {from, random.index(2) ? normalize(way) : way * random.logUniform(1e-3, 1e3)};
}

/// Asks with bounds that are far, and with bounds next to the hit.
void askWithBounds(Random& random, Comparison& comparison, const Object3D& object, const Ray& ray) {
  comparison.ask(ray, 0, kInf);
  Hit hit;
  if (random.index(4) || !object.intersect(ray, hit, 0)) return;
  const double off = anyFraction(random);
  const double t = hit.getT() * (1 + (random.index(2) ? off : -off));
  comparison.ask(ray, 0, t);
  comparison.ask(ray, t, kInf);
  comparison.ask(ray, hit.getT(), kInf);
  comparison.ask(ray, 0, hit.getT());
}

struct Edge {
  Vec3d a, b;
};

/// Single rays, and packets of 64 from one point and to one point, past the edges of `edges`.
void askAboutEdges(Random& random, Comparison& comparison, const Object3D& object,
                   const std::vector<Edge>& edges, double size, int rays) {
  const auto aim = [&] {
    const Edge& edge = edges[std::size_t(random.index(int(edges.size())))];
    return nearEdge(random, edge.a, edge.b);
  };
  for (int i = 0; i < rays; ++i) {
    const Vec3d at = aim();
    askWithBounds(random, comparison, object, towards(random, startOf(random, at, size), at));
  }
  for (int batch = 0; batch < rays / 64; ++batch) {
    const Vec3d eye = startOf(random, aim(), size);
    std::vector<Ray> tile, mirrored;
    std::vector<ShadowQuery> shadows;
    for (int i = 0; i < 64; ++i) {
      const Vec3d at = aim();
      tile.push_back(towards(random, eye, at));
      const Ray& ray = tile.back();
      const double t =
          dot(at - eye, ray.getDirection()) / dot(ray.getDirection(), ray.getDirection());
      mirrored.emplace_back(ray.pointAtParameter(random.uniform(0.3, 0.9) * t), ray.getDirection());
      // The lamp is where the eye is; the surface is before, at or behind the edge.
      const Vec3d from = eye + (at - eye) * (random.index(2) ? 1.5 : 1 + anyFraction(random));
      const Vec3d way = eye - from;
      shadows.push_back({Ray(from, normalize(way)), 0, length(way)});
    }
    comparison.askBatch(tile, 0, kInf);
    comparison.askBatch(mirrored, 0, kInf);
    comparison.askShadows(shadows);
  }
}

}  // namespace

TEST("rays past edges and vertices of closed meshes hit what the double function says") {
  Random random(11);
  int tried = 0, hits = 0;
  std::string failure;
  for (int round = 0; round < casesFor(120) && failure.empty(); ++round) {
    Owner owner;
    const double size = random.index(3) ? 1 : random.logUniform(1e-15, 1e15);
    const double away = random.index(2) ? 0 : size * random.logUniform(1, 1e4);
    const MeshGeometry shape = round % 3 ? shapes::ball(round % 3 - 1) : shapes::cube(1);
    const auto& mesh = owner.make<TriangleMesh>(
        owner.geometry(moved(shape, float(size), Vec3f(random.unitVector() * away))),
        owner.material(0));
    std::vector<Edge> edges;
    for (std::uint32_t face = 0; face < mesh.getGeometry().faceCount(); ++face) {
      edges.push_back({mesh.getGeometry().corner(face, 0), mesh.getGeometry().corner(face, 1)});
    }
    Comparison comparison(mesh, "mesh " + std::to_string(round));
    askAboutEdges(random, comparison, mesh, edges, size, 1000);
    failure = comparison.firstFailure();
    tried += comparison.tried();
    hits += comparison.hits();
  }
  CHECK_EQUAL(failure, "");
  CHECK(tried > casesFor(1000000) && hits > casesFor(100000));
}

TEST("rays past edges and vertices of loose triangles hit what the double function says") {
  Random random(12);
  int tried = 0, hits = 0;
  std::string failure;
  for (int round = 0; round < casesFor(120) && failure.empty(); ++round) {
    Owner owner;
    Group group;
    const double size = random.index(3) ? 1 : random.logUniform(1e-18, 1e18);
    const Vec3d middle = random.index(2) ? Vec3d() : random.ofLogLength(1, 1e6);
    std::vector<Edge> edges;
    for (int i = 0; i < 12; ++i) {
      const double length = random.index(3) ? 1 : random.logUniform(1e-30, 1);
      const Vec3d a = (middle + random.inCube(-1, 1)) * size;
      const Vec3d b = a + random.inCube(-1, 1) * (length * size);
      const Vec3d c = a + random.inCube(-1, 1) * (length * size);
      group.addObject(&owner.make<Triangle>(a, b, c, owner.material(i)));
      for (const Edge& edge : {Edge{a, b}, Edge{b, c}, Edge{c, a}}) edges.push_back(edge);
    }
    Comparison comparison(group, "triangles " + std::to_string(round));
    askAboutEdges(random, comparison, group, edges, size, 1000);
    failure = comparison.firstFailure();
    tried += comparison.tried();
    hits += comparison.hits();
  }
  CHECK_EQUAL(failure, "");
  CHECK(tried > casesFor(800000) && hits > casesFor(100000));
}

TEST("rays past the rims of spheres hit what the double function says") {
  Random random(13);
  int tried = 0, hits = 0;
  std::string failure;
  for (int round = 0; round < casesFor(100) && failure.empty(); ++round) {
    Owner owner;
    Group group;
    const double size = random.index(3) ? 1 : random.logUniform(1e-18, 1e18);
    const Vec3d middle = random.index(2) ? Vec3d() : random.ofLogLength(1, 1e6);
    std::vector<const Sphere*> spheres;
    for (int i = 0; i < 12; ++i) {
      const double radius = random.index(3) ? random.uniform(0.1, 1) : random.logUniform(1e-25, 1);
      const Vec3d center = (middle + random.inCube(-1, 1)) * size;
      spheres.push_back(&owner.make<Sphere>(center, radius * size, owner.material(i)));
      group.addObject(spheres.back());
    }
    Comparison comparison(group, "spheres " + std::to_string(round));
    for (int i = 0; i < 1000; ++i) {
      const Sphere& sphere = *spheres[std::size_t(random.index(12))];
      const Vec3d start = startOf(random, sphere.getCenter(), sphere.getRadius());
      const Vec3d side = normalize(cross(start - sphere.getCenter(), random.unitVector()));
      const double by = random.index(2) ? anyFraction(random) : -anyFraction(random);
      const double away = random.index(8) ? sphere.getRadius() * (1 + by) : 0;
      // The tangent's own point lies a little nearer than the centre; both kinds are wanted.
      const Vec3d aim = sphere.getCenter() + side * away;
      askWithBounds(random, comparison, group, towards(random, start, aim));
      const Vec3d toStart = normalize(start - aim);
      const Vec3d across = normalize(side - toStart * dot(side, toStart));
      askWithBounds(random, comparison, group,
                    towards(random, start, sphere.getCenter() + across * away));
    }
    failure = comparison.firstFailure();
    tried += comparison.tried();
    hits += comparison.hits();
  }
  CHECK_EQUAL(failure, "");
  CHECK(tried > casesFor(600000) && hits > casesFor(100000));
}

TEST("of layers of triangles next to each other the nearest is found, and none behind a bound") {
  Random random(14);
  int tried = 0, hits = 0;
  std::string failure;
  for (int round = 0; round < casesFor(200) && failure.empty(); ++round) {
    Owner owner;
    Group group;
    std::vector<Vec3f> vertices;
    std::vector<MeshGeometry::Face> faces;
    const double gap = random.logUniform(1e-9, 1e-2);
    const Matrix turn = random.rotation();
    for (std::uint32_t i = 0; i < 16; ++i) {
      Vec3d corners[3] = {{-3, -3, 0}, {3, -3, 0}, {0, 4, 0}};
      for (Vec3d& corner : corners) corner[2] = random.uniform(-1, 1) * gap;
      if (i % 4 == 0) corners[0][2] = corners[1][2] = corners[2][2] = 0;  // some lie in one plane
      for (Vec3d& corner : corners) {
        corner = turn.transformPoint(corner);
        vertices.emplace_back(corner);
      }
      faces.push_back({3 * i, 3 * i + 1, 3 * i + 2});
      if (round % 2) {
        group.addObject(
            &owner.make<Triangle>(corners[0], corners[1], corners[2], owner.material(int(i))));
      }
    }
    if (round % 2 == 0) {
      group.addObject(&owner.make<TriangleMesh>(owner.geometry(MeshGeometry(vertices, faces)),
                                                owner.material(0)));
    }
    Comparison comparison(group, "layers " + std::to_string(round));
    for (int batch = 0; batch < 6; ++batch) {
      // Every other eye is close above the layers, where the error of the distance counts most.
      const double away = batch % 2 ? 9 : random.logUniform(1e-3, 0.3);
      const Vec3d eye = turn.transformPoint(
          Vec3d{random.uniform(-1, 1), random.uniform(-1, 1), random.logUniform(1e-6, 1)} * away);
      std::vector<Ray> tile;
      std::vector<Hit> bounds;
      std::vector<ShadowQuery> shadows;
      for (int i = 0; i < 64; ++i) {
        const Vec3d at =
            turn.transformPoint({random.uniform(-0.2, 0.2), random.uniform(-0.2, 0.2), 0});
        tile.push_back(Ray(eye, normalize(at - eye)));
        const double off = gap * random.logUniform(1e-9, 10);
        const double near = 1 + (random.index(2) ? off : -off);
        bounds.emplace_back(random.index(2) ? kInf : length(at - eye) * near);
        // To the same point as a lamp, from on, before or behind the layers.
        const Vec3d from = eye + (at - eye) * near;
        shadows.push_back({Ray(from, normalize(eye - from)), 0, length(eye - from)});
        comparison.ask(tile.back(), 0, bounds.back().getT());
        comparison.ask(shadows.back().ray, 0, shadows.back().tmax);
        comparison.ask(tile.back(), length(at - eye) * near, kInf);
      }
      comparison.askBatch(tile, 0, bounds);
      comparison.askBatch(tile, length(eye), kInf);
      comparison.askShadows(shadows);
    }
    failure = comparison.firstFailure();
    tried += comparison.tried();
    hits += comparison.hits();
  }
  CHECK_EQUAL(failure, "");
  CHECK(tried > casesFor(500000) && hits > casesFor(100000));
}
