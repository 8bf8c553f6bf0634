// Mesh building blocks of make_meshes.cpp: rings, solids of revolution, tubes, check and output.
#pragma once
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <fstream>
#include <functional>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

inline constexpr double kPi = 3.14159265358979323846;

using Point = std::array<double, 3>;
using Face = std::vector<std::size_t>;

struct Mesh {
  std::vector<Point> points;
  std::vector<Face> faces;

  std::size_t add(const Point& p) {
    points.push_back(p);
    return points.size() - 1;
  }
};

inline Point operator+(const Point& a, const Point& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
inline Point operator*(const Point& a, double s) { return {a[0] * s, a[1] * s, a[2] * s}; }
inline Point cross(const Point& a, const Point& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline double dot(const Point& a, const Point& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
inline Point normalize(const Point& a) { return a * (1 / std::sqrt(dot(a, a))); }
/// The point at `angle` radians around the y axis.
inline Point around(double radius, double y, double angle) {
  return {radius * std::cos(angle), y, -radius * std::sin(angle)};
}

/// Six times the volume; negative where the faces run the wrong way round.
inline double signedVolume(const Mesh& mesh) {
  double sum = 0;
  for (const Face& f : mesh.faces) {
    for (std::size_t i = 2; i < f.size(); ++i) {
      sum += dot(mesh.points[f[0]], cross(mesh.points[f[i - 1]], mesh.points[f[i]]));
    }
  }
  return sum;
}

/// Turns all faces of a solid outwards. Throws unless every edge has one face on either side.
inline void makeSolid(Mesh& mesh, const std::string& name) {
  std::map<std::pair<std::size_t, std::size_t>, int> uses;
  for (const Face& f : mesh.faces) {
    for (std::size_t i = 0; i < f.size(); ++i) ++uses[{f[i], f[(i + 1) % f.size()]}];
  }
  for (const auto& [edge, count] : uses) {
    const auto opposite = uses.find({edge.second, edge.first});
    if (count != 1 || opposite == uses.end()) throw std::runtime_error(name + " is not closed");
  }
  if (signedVolume(mesh) > 0) return;
  for (Face& f : mesh.faces) f = Face(f.rbegin(), f.rend());
}

inline void write(const std::string& path, const std::string& remark, const Mesh& mesh) {
  std::ofstream file(path);
  file << "# " << remark << "\n# written by tests/tools/make_meshes.cpp\n";
  for (const Point& p : mesh.points) {
    char line[100];
    std::snprintf(line, sizeof line, "v %.5g %.5g %.5g\n", p[0] + 0.0, p[1] + 0.0, p[2] + 0.0);
    file << line;
  }
  for (const Face& f : mesh.faces) {
    file << 'f';
    for (const std::size_t i : f) file << ' ' << i + 1;
    file << '\n';
  }
  if (!file.flush()) throw std::runtime_error("cannot write " + path);
}

/// Two rings of the same size, joined by triangles.
inline void joinRings(Mesh& mesh, const Face& a, const Face& b) {
  for (std::size_t i = 0, n = a.size(); i < n; ++i) {
    const std::size_t j = (i + 1) % n;
    mesh.faces.push_back({a[i], a[j], b[i]});
    mesh.faces.push_back({b[i], a[j], b[j]});
  }
}

/// A ring around the axis; `turn` counts in steps from corner to corner.
inline Face addRing(Mesh& mesh, int sides, double radius, double y, double turn) {
  Face ring;
  for (int i = 0; i < sides; ++i) {
    ring.push_back(mesh.add(around(radius, y, (i + turn) * 2 * kPi / sides)));
  }
  return ring;
}

struct ProfilePoint {
  double radius, y, turn;
};

/// A solid of revolution: the profile runs from below along the outside to the axis again.
inline Mesh lathe(const std::vector<ProfilePoint>& profile, int sides) {
  Mesh mesh;
  std::vector<Face> rings;
  for (const ProfilePoint& p : profile) {
    rings.push_back(addRing(mesh, sides, p.radius, p.y, p.turn));
    if (rings.size() > 1) joinRings(mesh, rings[rings.size() - 2], rings.back());
  }
  mesh.faces.push_back(Face(rings.front().rbegin(), rings.front().rend()));
  mesh.faces.push_back(rings.back());
  return mesh;
}

/// A point of a curve, and the direction there (perpendicular to the curve) where a tube's first
/// corner lies.
struct CurvePoint {
  Point point, side;
};
using Curve = std::function<CurvePoint(double)>;

/// A round tube along curve(0..1); an open one gets flat ends.
inline Mesh tube(const Curve& curve, bool isLoop, int steps, int sides, double radius) {
  Mesh mesh;
  std::vector<Face> rings;
  for (int k = 0; k < (isLoop ? steps : steps + 1); ++k) {
    const double t = double(k) / steps, h = 1e-4;
    const CurvePoint here = curve(t);
    const Point along = normalize(curve(t + h).point + curve(t - h).point * -1);
    const Point other = cross(along, here.side);
    Face ring;
    for (int i = 0; i < sides; ++i) {
      const double angle = 2 * kPi * i / sides;
      ring.push_back(mesh.add(here.point + here.side * (radius * std::cos(angle)) +
                              other * (radius * std::sin(angle))));
    }
    if (k > 0) joinRings(mesh, rings.back(), ring);
    rings.push_back(ring);
  }
  if (isLoop) {
    joinRings(mesh, rings.back(), rings.front());
  } else {
    mesh.faces.push_back(Face(rings.front().rbegin(), rings.front().rend()));
    mesh.faces.push_back(rings.back());
  }
  return mesh;
}
