// The objects of a plain scene in long double, and every point where a ray meets them. Nothing is
// accelerated but for a ball around each mesh; nothing is shared with the program's geometry.
#pragma once
#include <algorithm>
#include <limits>

#include "long_map.h"

namespace numbers {

inline constexpr Real kFar = std::numeric_limits<Real>::infinity();

/// A place on a surface: which object of the scene, counted in the order of the file, and which
/// triangle of it. {-1, 0} is none.
struct Place {
  int object = -1, part = 0;
  bool operator==(const Place& o) const { return object == o.object && part == o.part; }
};

struct LongRay {
  Vec origin, direction;
  /// The place where the ray begins: its meeting with that place is left out.
  Place source;
};

/// A triangle of the world. `normal` is a unit vector.
struct LongTriangle {
  Vec a, ab, ac, normal;
};

struct LongObject {
  PlainObject::Kind kind = PlainObject::Kind::sphere;
  int material = 0;
  bool closed = false;
  Map inward;  ///< from the world to the object
  Vec a;       ///< centre, or unit normal
  Real f = 0;  ///< radius, or offset along the unit normal
  std::vector<LongTriangle> triangles;
  Vec middle;  ///< of the triangles, and how far they reach from there
  Real reach = 0;
};

/// Where a line meets something: t counts in lengths of its direction.
struct Meeting {
  Real t = kFar;
  Place place;
};

class LongWorld {
 public:
  explicit LongWorld(const PlainScene& scene) : scene_(scene) {
    for (const PlainObject& object : scene.objects) add(object, Map());
  }

  const std::vector<LongObject>& objects() const { return objects_; }
  /// The longest side of the box around all that is bounded.
  Real span() const { return high_.x() < low_.x() ? 0 : maxAbs(high_ - low_); }

  /// Calls visit(Meeting) for all meetings of `ray` with object `index`, at any t, in no order.
  template <class Visit>
  void meet(const LongRay& ray, int index, const Visit& visit) const {
    const LongObject& object = objects_[std::size_t(index)];
    switch (object.kind) {
      case PlainObject::Kind::sphere:
        return meetSphere(ray, index, visit);
      case PlainObject::Kind::plane: {
        const Real slope = dot(object.a, object.inward.direction(ray.direction));
        if (slope == 0 || ray.source == Place{index, 0}) return;
        visit({(object.f - dot(object.a, object.inward.point(ray.origin))) / slope, {index, 0}});
        return;
      }
      default:
        return meetTriangles(ray, index, visit);
    }
  }
  /// The nearest one with t > tmin; of equal ones the first in the scene.
  Meeting nearest(const LongRay& ray, Real tmin) const {
    Meeting best;
    for (int i = 0; i < int(objects_.size()); ++i) {
      meet(ray, i, [&](const Meeting& m) {
        if (m.t > tmin && m.t < best.t) best = m;
      });
    }
    return best;
  }

  /// The unit normal at a point of the place.
  Vec normalAt(const Place& place, const Vec& point) const {
    const LongObject& object = objects_[std::size_t(place.object)];
    if (!object.triangles.empty()) return object.triangles[std::size_t(place.part)].normal;
    const bool isSphere = object.kind == PlainObject::Kind::sphere;
    const Vec inner = isSphere ? object.inward.point(point) - object.a : object.a;
    return normalize(object.inward.transposed(inner));
  }

 private:
  /// |o + t d - center|^2 = r^2 in the sphere's own space. The root of a ray that begins on the
  /// sphere which is nearest to 0 is where it begins.
  template <class Visit>
  void meetSphere(const LongRay& ray, int index, const Visit& visit) const {
    const LongObject& sphere = objects_[std::size_t(index)];
    const Vec o = sphere.inward.point(ray.origin) - sphere.a;
    const Vec d = sphere.inward.direction(ray.direction);
    const Real middle = -dot(o, d) / dot(d, d);
    const Vec closest = o + d * middle;
    const Real rest = (sphere.f * sphere.f - dot(closest, closest)) / dot(d, d);
    if (rest < 0) return;
    const Real t0 = middle - std::sqrt(rest), t1 = middle + std::sqrt(rest);
    const bool begins = ray.source == Place{index, 0};
    if (!begins || std::fabs(t0) > std::fabs(t1)) visit({t0, {index, 0}});
    if (!begins || std::fabs(t0) <= std::fabs(t1)) visit({t1, {index, 0}});
  }
  /// By Cramer's rule for a + u ab + v ac = o + t d.
  template <class Visit>
  void meetTriangles(const LongRay& ray, int index, const Visit& visit) const {
    const LongObject& object = objects_[std::size_t(index)];
    const Vec toMiddle = object.middle - ray.origin;
    const Vec aside = cross(toMiddle, ray.direction);
    if (dot(aside, aside) > object.reach * object.reach * dot(ray.direction, ray.direction)) return;
    for (int part = 0; part < int(object.triangles.size()); ++part) {
      const LongTriangle& triangle = object.triangles[std::size_t(part)];
      const Vec across = cross(ray.direction, triangle.ac);
      const Real determinant = dot(triangle.ab, across);
      if (determinant == 0 || ray.source == Place{index, part}) continue;
      const Vec from = ray.origin - triangle.a;
      const Real u = dot(from, across) / determinant;
      if (u < 0 || u > 1) continue;
      const Vec turned = cross(from, triangle.ab);
      const Real v = dot(ray.direction, turned) / determinant;
      if (v < 0 || u + v > 1) continue;
      visit({dot(triangle.ac, turned) / determinant, {index, part}});
    }
  }

  void add(const PlainObject& object, const Map& outward) {
    switch (object.kind) {
      case PlainObject::Kind::transform:
        return add(object.children[0], outward.after(mapOf(object.steps)));
      case PlainObject::Kind::group:
        for (const PlainObject& child : object.children) add(child, outward);
        return;
      case PlainObject::Kind::sphere:
      case PlainObject::Kind::plane:
        return addRound(object, outward);
      default:
        return addTriangles(object, outward);
    }
  }
  LongObject begin(const PlainObject& object, const Map& outward) const {
    LongObject made;
    made.kind = object.kind;
    made.material = object.material;
    made.inward = outward.inverse();
    return made;
  }
  /// A sphere or a plane. An ellipsoid reaches as far along an axis as that row of its map is long.
  void addRound(const PlainObject& object, const Map& outward) {
    LongObject made = begin(object, outward);
    made.a = wide(object.a);
    made.f = object.f;
    if (object.kind == PlainObject::Kind::plane) {
      made.a = normalize(made.a);
    } else {
      made.closed = true;
      const Vec center = outward.point(made.a);
      Vec reach;
      for (int axis = 0; axis < 3; ++axis) reach[axis] = length(outward.rows[axis]) * made.f;
      extend(center - reach);
      extend(center + reach);
    }
    objects_.push_back(made);
  }
  void addTriangles(const PlainObject& object, const Map& outward) {
    LongObject made = begin(object, outward);
    if (object.kind == PlainObject::Kind::triangle) {
      addTriangle(made, outward, {wide(object.a), wide(object.b), wide(object.c)});
    } else {
      const PlainMesh& mesh = scene_.meshes[std::size_t(object.mesh)];
      made.closed = mesh.closed;
      const auto vertex = [&](int k) { return wide(mesh.vertices[std::size_t(k)]); };
      for (const std::vector<int>& face : mesh.faces) {
        for (std::size_t k = 2; k < face.size(); ++k) {
          addTriangle(made, outward, {vertex(face[0]), vertex(face[k - 1]), vertex(face[k])});
        }
      }
    }
    encircle(made);
    objects_.push_back(made);
  }
  /// The normal is that of the object, moved as normals are: a reflection leaves it on its side.
  void addTriangle(LongObject& object, const Map& outward, const std::vector<Vec>& inner) {
    const Vec a = outward.point(inner[0]), b = outward.point(inner[1]), c = outward.point(inner[2]);
    const Vec normal = cross(inner[1] - inner[0], inner[2] - inner[0]);
    object.triangles.push_back({a, b - a, c - a, normalize(object.inward.transposed(normal))});
    for (const Vec& corner : {a, b, c}) extend(corner);
  }
  static void encircle(LongObject& object) {
    for (const LongTriangle& t : object.triangles) {
      object.middle += t.a / Real(object.triangles.size());
    }
    for (const LongTriangle& t : object.triangles) {
      for (const Vec& corner : {t.a, t.a + t.ab, t.a + t.ac}) {
        object.reach = std::max(object.reach, length(corner - object.middle) * Real(1.001));
      }
    }
  }
  void extend(const Vec& point) {
    for (int axis = 0; axis < 3; ++axis) {
      low_[axis] = std::min(low_[axis], point[axis]);
      high_[axis] = std::max(high_[axis], point[axis]);
    }
  }

  const PlainScene& scene_;
  std::vector<LongObject> objects_;
  Vec low_{kFar, kFar, kFar}, high_{-kFar, -kFar, -kFar};
};

}  // namespace numbers
