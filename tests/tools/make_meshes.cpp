// Writes the meshes of scenes/: `g++ -std=c++17 -O2 tests/tools/make_meshes.cpp -o /tmp/make_meshes
// && /tmp/make_meshes scenes`. Not part of the build: its output is kept beside the scenes.
// Faces run counter-clockwise seen from outside; every mesh said to be solid is checked to be so.
#include <algorithm>

#include "mesh.h"

namespace {

Mesh cube() {
  Mesh mesh;
  for (int i = 0; i < 8; ++i) {
    mesh.add({i & 1 ? 0.5 : -0.5, i & 2 ? 0.5 : -0.5, i & 4 ? 0.5 : -0.5});
  }
  mesh.faces = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  return mesh;
}

std::size_t middle(Mesh& mesh, std::map<std::pair<std::size_t, std::size_t>, std::size_t>& known,
                   std::size_t a, std::size_t b) {
  const auto key = std::minmax(a, b);
  const auto found = known.find(key);
  if (found != known.end()) return found->second;
  const std::size_t made = mesh.add(normalize(mesh.points[a] + mesh.points[b]));
  known[key] = made;
  return made;
}

/// An icosahedron whose faces are split into four, `times` times.
Mesh icosphere(int times) {
  Mesh mesh;
  mesh.add({0, 1, 0});
  const double y = 1 / std::sqrt(5.0), r = 2 * y;
  const Face upper = addRing(mesh, 5, r, y, 0), lower = addRing(mesh, 5, r, -y, 0.5);
  const std::size_t bottom = mesh.add({0, -1, 0});
  joinRings(mesh, lower, upper);
  mesh.faces.clear();
  for (std::size_t i = 0; i < 5; ++i) {
    const std::size_t j = (i + 1) % 5;
    mesh.faces.push_back({0, upper[i], upper[j]});
    mesh.faces.push_back({upper[i], lower[i], upper[j]});
    mesh.faces.push_back({upper[j], lower[i], lower[j]});
    mesh.faces.push_back({bottom, lower[j], lower[i]});
  }
  for (int k = 0; k < times; ++k) {
    std::map<std::pair<std::size_t, std::size_t>, std::size_t> known;
    std::vector<Face> finer;
    for (const Face& f : mesh.faces) {
      const std::size_t a = middle(mesh, known, f[0], f[1]), b = middle(mesh, known, f[1], f[2]),
                        c = middle(mesh, known, f[2], f[0]);
      finer.insert(finer.end(), {{f[0], a, c}, {a, f[1], b}, {c, b, f[2]}, {a, b, c}});
    }
    mesh.faces = finer;
  }
  return mesh;
}

/// A round brilliant of girdle radius 1: 8 bezels between a table and the girdle, 8 stars, 16 upper
/// halves, 16 lower halves and 8 mains. Angles: crown 34.5 and pavilion 40.75 degrees.
Mesh brilliant() {
  const double crown = std::tan(34.5 * kPi / 180), pavilion = std::tan(40.75 * kPi / 180);
  const double table = 0.56, star = 0.78, lower = 0.25, girdle = 0.03, c = std::cos(kPi / 8);
  Mesh mesh;
  const Face t = addRing(mesh, 8, table, girdle + (1 - table) * crown, 0);
  const Face s = addRing(mesh, 8, star, girdle + (1 - star * c) * crown, 0.5);
  const Face g = addRing(mesh, 16, 1, girdle, 0), h = addRing(mesh, 16, 1, -girdle, 0);
  const Face l = addRing(mesh, 8, lower, -girdle - (1 - lower * c) * pavilion, 0.5);
  const std::size_t culet = mesh.add({0, -girdle - pavilion, 0});
  mesh.faces.push_back(t);
  joinRings(mesh, h, g);
  for (std::size_t i = 0; i < 8; ++i) {
    const std::size_t before = (i + 7) % 8, next = (i + 1) % 8;
    mesh.faces.push_back({t[i], s[i], t[next]});
    mesh.faces.push_back({t[i], s[before], g[2 * i], s[i]});
    mesh.faces.push_back({s[i], g[2 * i], g[2 * i + 1]});
    mesh.faces.push_back({s[i], g[2 * i + 1], g[2 * next]});
    mesh.faces.push_back({culet, l[i], h[2 * i], l[before]});
    mesh.faces.push_back({l[i], h[2 * i + 1], h[2 * i]});
    mesh.faces.push_back({l[i], h[2 * next], h[2 * i + 1]});
  }
  return mesh;
}

/// A cut-glass goblet: smooth foot, stem and inside, and a bowl cut into lozenges.
Mesh goblet() {
  return lathe(
      {{0.62, 0.00, 0},   {0.64, 0.04, 0}, {0.30, 0.12, 0},   {0.10, 0.24, 0},   {0.08, 0.50, 0},
       {0.17, 0.60, 0.5}, {0.08, 0.70, 0}, {0.09, 0.92, 0},   {0.30, 1.04, 0.5}, {0.52, 1.24, 0},
       {0.64, 1.50, 0.5}, {0.69, 1.76, 0}, {0.68, 2.02, 0.5}, {0.66, 2.14, 0},   {0.65, 2.42, 0},
       {0.60, 2.42, 0},   {0.61, 2.10, 0}, {0.62, 1.76, 0},   {0.56, 1.48, 0},   {0.42, 1.26, 0},
       {0.20, 1.14, 0}},
      20);
}

/// Adds to `profile` an upright ellipse about (0, 1.7), of half axes `across` and `along`, from the
/// angle `from` to `to` in degrees, measured from the horizontal.
void addBowl(std::vector<ProfilePoint>& profile, double across, double along, int from, int to) {
  const int steps = 20;
  for (int k = 0; k <= steps; ++k) {
    const double angle = (from + (to - from) * double(k) / steps) * kPi / 180;
    profile.push_back({across * std::cos(angle), 1.7 + along * std::sin(angle), 0});
  }
}

/// A plain wine glass with a wall 0.05 thick.
Mesh wineGlass() {
  std::vector<ProfilePoint> profile = {{0.5, 0, 0},     {0.5, 0.03, 0},   {0.3, 0.07, 0},
                                       {0.12, 0.13, 0}, {0.055, 0.25, 0}, {0.045, 0.5, 0},
                                       {0.05, 0.8, 0}};
  addBowl(profile, 0.6, 0.75, -84, 40);
  addBowl(profile, 0.55, 0.7, 40, -87);
  return lathe(profile, 64);
}

/// What fills it to half its height, and reaches halfway into the wall.
Mesh wine() {
  std::vector<ProfilePoint> profile;
  addBowl(profile, 0.575, 0.725, -87, 4);
  return lathe(profile, 64);
}

/// A vase whose wall turns as it rises, hollow, with a lip.
Mesh vase() {
  const std::vector<std::pair<double, double>> outside = {
      {0.45, 0.00}, {0.50, 0.06}, {0.62, 0.35}, {0.80, 0.70}, {0.90, 1.05}, {0.86, 1.40},
      {0.68, 1.75}, {0.46, 2.05}, {0.34, 2.30}, {0.32, 2.50}, {0.40, 2.70}, {0.52, 2.82}};
  std::vector<ProfilePoint> profile;
  for (const auto& [radius, y] : outside) profile.push_back({radius, y, 1.2 * y});
  for (std::size_t i = outside.size(); i-- > 1;) {
    const auto& [radius, y] = outside[i];
    profile.push_back({radius - 0.06, i + 1 == outside.size() ? y : y + 0.02, 1.2 * y});
  }
  return lathe(profile, 16);
}

/// A five-sided column that turns once half round.
Mesh twistedPrism() {
  std::vector<ProfilePoint> profile;
  for (int k = 0; k <= 24; ++k) profile.push_back({0.5, k / 12.0, 2.5 * k / 24.0});
  return lathe(profile, 5);
}

double hillHeight(double x, double z) {
  double sum = 0, size = 0.55, turn = 0.4;
  for (double scale = 1.3; scale < 14; scale *= 1.9, size *= 0.46, turn += 1.3) {
    const double u = x * std::cos(turn) + z * std::sin(turn) + turn;
    const double v = z * std::cos(turn) - x * std::sin(turn);
    sum += size * std::sin(scale * u + std::sin(scale * v)) * std::cos(scale * v);
  }
  return sum;
}

/// Hills over the square [-2, 2] of x and z, on a base at y = -1.
Mesh terrain(int cells) {
  Mesh mesh;
  const std::size_t n = std::size_t(cells) + 1;
  for (std::size_t k = 0; k < n * n; ++k) {
    const double x = 4.0 * double(k % n) / cells - 2, z = 4.0 * double(k / n) / cells - 2;
    mesh.add({x, hillHeight(x, z), z});
  }
  for (std::size_t j = 0; j + 1 < n; ++j) {
    for (std::size_t i = 0; i + 1 < n; ++i) {
      const std::size_t a = j * n + i;
      mesh.faces.push_back({a, a + n, a + 1});
      mesh.faces.push_back({a + 1, a + n, a + n + 1});
    }
  }
  Face rim, base;
  for (std::size_t i = 0; i + 1 < n; ++i) rim.push_back((n - 1) * n + i);
  for (std::size_t i = n; --i > 0;) rim.push_back(i * n + n - 1);
  for (std::size_t i = n; --i > 0;) rim.push_back(i);
  for (std::size_t i = 0; i + 1 < n; ++i) rim.push_back(i * n);
  for (const std::size_t i : rim)
    base.push_back(mesh.add({mesh.points[i][0], -1, mesh.points[i][2]}));
  joinRings(mesh, base, rim);
  const std::size_t center = mesh.add({0, -1, 0});  // a fan from a corner would have flat triangles
  for (std::size_t i = 0; i < base.size(); ++i) {
    mesh.faces.push_back({center, base[(i + 1) % base.size()], base[i]});
  }
  return mesh;
}

/// A curve that winds `wraps` times through the hole of a ring while it goes `turns` times round.
Curve torusKnot(int turns, int wraps, double ringRadius, double wrapRadius) {
  return [=](double t) -> CurvePoint {
    const double p = 2 * kPi * turns * t, q = 2 * kPi * wraps * t;
    const Point side = around(std::cos(q), std::sin(q), p);
    return {around(ringRadius, 0, p) + side * wrapRadius, side};
  };
}

/// A screw line of radius 0.5 that rises from 0 to 2.
Curve helix(double turns) {
  return [=](double t) -> CurvePoint {
    const Point side = around(1, 0, 2 * kPi * turns * t);
    return {side * 0.5 + Point{0, 2 * t, 0}, side};
  };
}

/// Every second unit square of a floor of 2 * half squares a side, facing up.
Mesh checkers(int half, int parity) {
  Mesh mesh;
  for (int i = -half; i < half; ++i) {
    for (int j = -half; j < half; ++j) {
      if (((i + j) & 1) != parity) continue;
      const double x = i, z = j;
      mesh.faces.push_back({mesh.add({x, 0, z}), mesh.add({x, 0, z + 1}),
                            mesh.add({x + 1, 0, z + 1}), mesh.add({x + 1, 0, z})});
    }
  }
  return mesh;
}

/// Adds the piece of a flat ring in the plane z, from angle a to b (radians), facing +z.
void addSector(Mesh& mesh, double inner, double outer, double a, double b, double z) {
  const auto at = [&](double radius, double angle) {
    return mesh.add({radius * std::cos(angle), radius * std::sin(angle), z});
  };
  mesh.faces.push_back({at(inner, a), at(outer, a), at(outer, b), at(inner, b)});
}

constexpr double kRoseRadii[] = {0.04, 0.26, 0.52, 0.80, 1.0};
constexpr int kRoseCells[] = {6, 12, 12, 24};

/// The panes of one of three colours of a rose window of radius 1.
Mesh rosePanes(int color) {
  Mesh mesh;
  for (int ring = 0; ring < 4; ++ring) {
    for (int k = 0; k < 48; ++k) {
      if ((k * kRoseCells[ring] / 48 + ring) % 3 != color) continue;
      const double step = 2 * kPi / 48;
      addSector(mesh, kRoseRadii[ring], kRoseRadii[ring + 1], k * step, (k + 1) * step, 0);
    }
  }
  return mesh;
}

/// The lead between the panes, a little in front of them.
Mesh roseLead() {
  const double half = 0.014, z = 0.02, step = 2 * kPi / 48;
  Mesh mesh;
  for (int ring = 0; ring <= 4; ++ring) {
    const double r = kRoseRadii[ring], inner = ring == 0 ? 0.001 : r - half;
    for (int k = 0; k < 48; ++k) addSector(mesh, inner, r + half, k * step, (k + 1) * step, z);
    for (int k = 0; ring < 4 && k < kRoseCells[ring]; ++k) {
      const double angle = 2 * kPi * k / kRoseCells[ring], outer = kRoseRadii[ring + 1];
      const double w = half / outer;
      addSector(mesh, r, outer, angle - w, angle + w, z);
    }
  }
  return mesh;
}

/// The wall around the rose window, out to `side` from its middle.
Mesh roseWall(double side) {
  Mesh mesh;
  const auto onSquare = [&](double angle) -> Point {
    const double c = std::cos(angle), s = std::sin(angle);
    const double r = side / std::max(std::fabs(c), std::fabs(s));
    return {r * c, r * s, 0};
  };
  for (int k = 0; k < 48; ++k) {
    const double a = 2 * kPi * k / 48, b = 2 * kPi * (k + 1) / 48;
    mesh.faces.push_back({mesh.add({std::cos(a), std::sin(a), 0}), mesh.add(onSquare(a)),
                          mesh.add(onSquare(b)), mesh.add({std::cos(b), std::sin(b), 0})});
  }
  return mesh;
}

void writeAll(const std::string& folder) {
  const auto solid = [&](const std::string& name, const std::string& remark, Mesh mesh) {
    makeSolid(mesh, name);
    write(folder + "/" + name, remark, mesh);
  };
  solid("cube.obj", "a cube of edge 1 around the origin", cube());
  solid("icosphere.obj", "a ball of 320 triangles, radius 1", icosphere(2));
  solid("brilliant.obj", "a brilliant-cut gem, girdle radius 1, table up", brilliant());
  solid("goblet.obj", "a cut-glass goblet, 2.42 high, standing on y = 0", goblet());
  solid("wine_glass.obj", "a wine glass, 2.18 high, standing on y = 0", wineGlass());
  solid("wine.obj", "the wine in wine_glass.obj, reaching into its wall", wine());
  solid("vase.obj", "a turned vase with walls, 2.82 high, standing on y = 0", vase());
  solid("twisted_prism.obj", "a twisted column, 2 high, standing on y = 0", twistedPrism());
  solid("terrain.obj", "hills over x, z in [-2, 2], base at y = -1", terrain(40));
  solid("torus.obj", "a ring in the plane y = 0: radius 1, thickness 0.3 each way",
        tube(torusKnot(1, 0, 1, 0), true, 48, 16, 0.3));
  solid("knot.obj", "a trefoil knot around the y axis",
        tube(torusKnot(2, 3, 1, 0.5), true, 120, 10, 0.22));
  solid("spring.obj", "a spring, 2 high", tube(helix(5), false, 120, 8, 0.09));
  write(folder + "/checkers_a.obj", "half of the unit squares of an 8 x 8 floor", checkers(4, 0));
  write(folder + "/checkers_b.obj", "the other half of the squares", checkers(4, 1));
  for (int k = 0; k < 3; ++k) {
    write(folder + "/rose_panes_" + "abc"[k] + ".obj", "panes of one colour of a rose window",
          rosePanes(k));
  }
  write(folder + "/rose_lead.obj", "the lead between the panes", roseLead());
  write(folder + "/rose_wall.obj", "a wall with a round hole of radius 1", roseWall(6));
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: make_meshes FOLDER\n");
    return 2;
  }
  try {
    writeAll(argv[1]);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "make_meshes: %s\n", error.what());
    return 1;
  }
}
