// Transmittance: gathers all crossings of a shadow ray, then multiplies object by object. A blocker
// is looked for apart: a shadow ray ends at the first surface that it finds, which need not be the
// nearest one.
//
// Crossings come in no order. A surface that is opaque where the ray crosses it ends all: the
// answer is black. Of the others each object is a filter: to the power of the way inside where it
// is closed, of the number of crossings where it is open. A texture differs from place to place, so
// it is a filter for each stretch of the way. Filters are sorted by what they are before they are
// multiplied, so that the last bit does not depend on the order of visits.
#include "render/transmittance.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <tuple>

#include "math/functions.h"
#include "shading/solid_texture.h"

namespace {

/// One object's share in the light: its colour to the power `exponent`.
struct Filter {
  Vec3f color;
  double exponent;  // length inside a closed object, number of crossings of an open one
};

bool filterLess(const Filter& a, const Filter& b) {
  return std::make_tuple(a.exponent, a.color.r(), a.color.g(), a.color.b()) <
         std::make_tuple(b.exponent, b.color.r(), b.color.g(), b.color.b());
}

class ShadowRay : public CrossingVisitor {
 public:
  ShadowRay(const Ray& ray, double epsilon, double distance)
      : ray_(ray), epsilon_(epsilon), distance_(distance) {}

  void visit(const Crossing& crossing) override {
    const bool between = crossing.t > epsilon_ && crossing.t < distance_;
    if (blocked_ || !(crossing.closed || between)) return;
    // An opaque material has no inside; a texture may have one elsewhere.
    if (!anyPositive(crossing.material->getTransparentColor()) ||
        (between && !anyPositive(colorAt(crossing)))) {
      blocked_ = between;
    } else {
      crossings_.push_back(crossing);
    }
  }

  Vec3f result() {
    if (blocked_) return Vec3f();
    // Sums and products are taken in an order that does not depend on the order of visits.
    sortByObject(crossings_);
    std::vector<Filter> filters;
    forEachObject(crossings_, [&](CrossingPlace first, CrossingPlace last) {
      if (first->material->asTexture()) {
        addTextured(first, last, filters);
      } else {
        filters.push_back(filterOf(first, last));
      }
    });
    std::sort(filters.begin(), filters.end(), filterLess);
    Vec3f product(1, 1, 1);
    for (const Filter& filter : filters) product *= absorption(filter.color, filter.exponent);
    return product;
  }

 private:
  /// The crossings of one object. The length inside is the sum of the places where the ray leaves
  /// less those where it enters, none counted beyond the light: an object that holds the light or
  /// the ray's origin comes out right as well, and one that is inside out differs in sign.
  Filter filterOf(CrossingPlace first, CrossingPlace last) const {
    const Vec3f color = first->material->getTransparentColor();
    double inside = 0, count = 0;
    for (CrossingPlace c = first; c != last; ++c) count += c->count;
    if (!first->closed) return {color, count};
    for (CrossingPlace c = first; c != last; ++c) {
      const double t = std::min(c->t, distance_);
      inside += c->leaving ? t : -t;
    }
    return {color, std::fabs(inside)};
  }

  /// The crossings of one textured object: a filter for each stretch of the way inside it, or for
  /// each crossing where it is open. From the light's end of the ray on, a surface that the light
  /// leaves by ends the stretch that began last.
  void addTextured(CrossingPlace first, CrossingPlace last, std::vector<Filter>& filters) const {
    std::vector<CrossingPlace> begun;
    for (CrossingPlace c = last; c != first;) {
      --c;
      if (!c->closed) {
        filters.insert(filters.end(), c->count, {colorAt(*c), 1});
      } else if (begun.empty() || begun.back()->leaving == c->leaving) {
        begun.push_back(c);
      } else {
        addStretch(&*c, *begun.back(), filters);
        begun.pop_back();
      }
    }
    for (const CrossingPlace c : begun) addStretch(nullptr, *c, filters);
  }

  /// The stretch between `near` (null where the ray begins inside) and `far`. Its colour is that of
  /// the place where the light enters, or where it leaves if the lamp is inside; where both ends
  /// of the way are inside, that of the surface behind the lamp. An opaque place filters nothing:
  /// that it does not block has been found out before.
  void addStretch(const Crossing* near, const Crossing& far, std::vector<Filter>& filters) const {
    const double start = near ? std::min(near->t, distance_) : 0;
    const Vec3f color = colorAt(far.t < distance_ || !near ? far : *near);
    if (anyPositive(color)) filters.push_back({color, std::min(far.t, distance_) - start});
  }

  Vec3f colorAt(const Crossing& crossing) const {
    return transparencyAt(*crossing.material, ray_.pointAtParameter(crossing.t));
  }

  Ray ray_;
  double epsilon_, distance_;
  bool blocked_ = false;
  std::vector<Crossing> crossings_;
};

/// Keeps the nearest crossing of a shadow ray with a surface that is opaque there.
class OpaqueCrossing : public CrossingVisitor {
 public:
  explicit OpaqueCrossing(const ShadowQuery& query) : query_(query) {}

  void visit(const Crossing& crossing) override {
    const double nearest = found_ ? found_->t : query_.tmax;
    if (!(crossing.t > query_.tmin && crossing.t < nearest)) return;
    const Vec3d point = query_.ray.pointAtParameter(crossing.t);
    if (anyPositive(transparencyAt(*crossing.material, point))) return;
    found_ = Blocker{crossing.object, std::nullopt, crossing.t};
  }
  const std::optional<Blocker>& found() const { return found_; }

 private:
  const ShadowQuery& query_;
  std::optional<Blocker> found_;
};

}  // namespace

Vec3f transparencyAt(const Material& material, const Vec3d& point) {
  const SolidTexture* const texture = material.asTexture();
  if (!texture) return material.getTransparentColor();
  Vec3d sum;
  for (const WeightedMaterial& each : texture->materialsAt(point)) {
    sum += each.weight * Vec3d(each.material->getTransparentColor());
  }
  return Vec3f(sum);
}

Vec3f transmittance(const Object3D& geometry, const Ray& ray, double epsilon, double distance) {
  ShadowRay visitor(ray, epsilon, distance);
  geometry.visitCrossings(ray, visitor);
  return visitor.result();
}

void transmittances(const BatchGeometry& geometry, const RayTable& rays, Arena& arena,
                    Vec3f* visible) {
  struct ShadowRays : RowCrossingVisitor {
    std::vector<ShadowRay> rows;
    void visit(int row, const Crossing& crossing) override {
      rows[std::size_t(row)].visit(crossing);
    }
  } shadows;
  shadows.rows.reserve(std::size_t(rays.count));
  for (int row = 0; row < rays.count; ++row) {
    shadows.rows.emplace_back(rays.rayOf(row), rays.tmin[row], rays.tmax[row]);
  }
  geometry.visitAllCrossings(rays, shadows, arena);
  for (ShadowRay& ray : shadows.rows) *visible++ = ray.result();
}

Vec3f absorption(const Vec3f& transparentColor, double length) {
  Vec3f result;
  for (int axis = 0; axis < 3; ++axis) {
    result[axis] = float(math::pow(double(std::max(transparentColor[axis], 0.0f)), length));
  }
  return result;
}

std::optional<Blocker> findBlocker(const Object3D& geometry, const ShadowQuery& query,
                                   bool transparentShadows) {
  if (transparentShadows) {
    OpaqueCrossing visitor(query);
    geometry.visitCrossings(query.ray, visitor);
    return visitor.found();
  }
  Hit hit(query.tmax);
  if (!geometry.intersect(query.ray, hit, query.tmin)) return std::nullopt;
  return Blocker{hit.getObject(), hit.getFace(), hit.getT()};
}

void sortByObject(std::vector<Crossing>& crossings) {
  std::sort(crossings.begin(), crossings.end(), [](const Crossing& a, const Crossing& b) {
    if (a.object != b.object) return std::less<>()(a.object, b.object);
    return std::make_tuple(a.t, a.leaving) < std::make_tuple(b.t, b.leaving);
  });
}
