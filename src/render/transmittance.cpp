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

#include "render/wave_kernels.h"
#include "shading/optics.h"
#include "shading/solid_texture.h"

namespace {

bool filterLess(const ColorFilter& a, const ColorFilter& b) {
  return std::make_tuple(a.exponent, a.color.r(), a.color.g(), a.color.b()) <
         std::make_tuple(b.exponent, b.color.r(), b.color.g(), b.color.b());
}

/// ::transparencyAt, for who asks for many points.
Vec3f transparencyAt(const Material& material, const Vec3d& point, SolidTexture::Mixture& mixture) {
  const SolidTexture* const texture = material.asTexture();
  if (!texture) return material.getTransparentColor();
  Vec3d sum;
  for (const WeightedMaterial& each : texture->mixAt(point, mixture)) {
    sum += each.weight * Vec3d(each.material->getTransparentColor());
  }
  return Vec3f(sum);
}

/// As many are computed together: enough for vectors, and they stay in the processor's first cache.
constexpr int kMostFilters = 256;

/// Finds the filters in the way of one shadow ray after the other.
class ShadowFilters final : public CrossingVisitor {
 public:
  /// The crossings of another ray follow.
  void begin(const Ray& ray, double epsilon, double distance) {
    ray_ = ray;
    epsilon_ = epsilon;
    distance_ = distance;
    blocked_ = false;
    crossings_.clear();
  }

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

  bool isBlocked() const { return blocked_; }

  /// In the order in which they are to be multiplied; valid until the next ray begins.
  const std::vector<ColorFilter>& filters() {
    filters_.clear();
    // Sums and products are taken in an order that does not depend on the order of visits.
    sortByObject(crossings_);
    forEachObject(crossings_, [&](CrossingPlace first, CrossingPlace last) {
      if (first->material->asTexture()) {
        addTextured(first, last);
      } else {
        filters_.push_back(filterOf(first, last));
      }
    });
    std::sort(filters_.begin(), filters_.end(), filterLess);
    return filters_;
  }

 private:
  /// The crossings of one object. The length inside is the sum of the places where the ray leaves
  /// less those where it enters, none counted beyond the light: an object that holds the light or
  /// the ray's origin comes out right as well, and one that is inside out differs in sign.
  ColorFilter filterOf(CrossingPlace first, CrossingPlace last) const {
    const Vec3f color = first->material->getTransparentColor();
    double inside = 0, count = 0;
    for (CrossingPlace c = first; c != last; ++c) count += c->count;
    if (!first->closed) return {color, count};
    for (CrossingPlace c = first; c != last; ++c) {
      const double t = std::min(c->t, distance_);
      inside += c->leaving ? t : -t;
    }
    return {color, lengthOf(std::fabs(inside))};
  }

  /// The crossings of one textured object: a filter for each stretch of the way inside it, or for
  /// each crossing where it is open. From the light's end of the ray on, a surface that the light
  /// leaves by ends the stretch that began last.
  void addTextured(CrossingPlace first, CrossingPlace last) {
    std::vector<CrossingPlace> begun;
    for (CrossingPlace c = last; c != first;) {
      --c;
      if (!c->closed) {
        filters_.insert(filters_.end(), c->count, {colorAt(*c), 1});
      } else if (begun.empty() || begun.back()->leaving == c->leaving) {
        begun.push_back(c);
      } else {
        addStretch(&*c, *begun.back());
        begun.pop_back();
      }
    }
    for (const CrossingPlace c : begun) addStretch(nullptr, *c);
  }

  /// The stretch between `near` (null where the ray begins inside) and `far`. Its colour is that of
  /// the place where the light enters, or where it leaves if the lamp is inside; where both ends
  /// of the way are inside, that of the surface behind the lamp. An opaque place filters nothing:
  /// that it does not block has been found out before.
  void addStretch(const Crossing* near, const Crossing& far) {
    const double start = near ? std::min(near->t, distance_) : 0;
    const Vec3f color = colorAt(far.t < distance_ || !near ? far : *near);
    if (anyPositive(color)) {
      filters_.push_back({color, lengthOf(std::min(far.t, distance_) - start)});
    }
  }

  /// Rounding puts the surface that the ray leaves before or behind its origin, so that a way of
  /// next to nothing may seem to be inside; a colour of 0 would take all of the light on it. As
  /// short as the ray is blind, it counts as none.
  double lengthOf(double inside) const { return inside > epsilon_ ? inside : 0; }

  Vec3f colorAt(const Crossing& crossing) {
    return transparencyAt(*crossing.material, ray_.pointAtParameter(crossing.t), mixture_);
  }

  Ray ray_;
  double epsilon_, distance_;
  bool blocked_;
  std::vector<Crossing> crossings_;
  std::vector<ColorFilter> filters_;
  SolidTexture::Mixture
      mixture_;  // kept: taking memory for each point made a picture take 1.15 times as long
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
  SolidTexture::Mixture mixture;
  return transparencyAt(material, point, mixture);
}

Vec3f ColorFilter::tint() const {
  const Vec3d base(color);
  return {float(absorption(base.x(), exponent)), float(absorption(base.y(), exponent)),
          float(absorption(base.z(), exponent))};
}

Vec3f transmittance(const Object3D& geometry, const Ray& ray, double epsilon, double distance) {
  ShadowFilters shadow;
  shadow.begin(ray, epsilon, distance);
  geometry.visitCrossings(ray, shadow);
  if (shadow.isBlocked()) return Vec3f();
  Vec3f product(1, 1, 1);
  for (const ColorFilter& filter : shadow.filters()) product *= filter.tint();
  return product;
}

void transmittances(const BatchGeometry& geometry, const RayTable& rays, Arena& arena,
                    Vec3f* visible) {
  CrossingTable crossings(rays.count);
  geometry.visitAllCrossings(rays, crossings, arena);
  const Arena::Frame frame(arena);
  ColorFilterTable filters(arena, kMostFilters);
  const auto multiply = [&] {
    waveKernels(geometry.simdLevel()).absorb(filters);
    for (int k = 0; k < filters.count; ++k) {
      visible[filters.row[k]] *= Vec3f(rowOf(filters.color, k));
    }
    filters.count = 0;
  };
  ShadowFilters shadow;
  for (int row = 0; row < rays.count; ++row) {
    shadow.begin(rays.rayOf(row), rays.tmin[row], rays.tmax[row]);
    crossings.tell(row, shadow);
    visible[row] = shadow.isBlocked() ? Vec3f() : Vec3f(1, 1, 1);
    if (shadow.isBlocked()) continue;
    for (const ColorFilter& filter : shadow.filters()) {
      if (filters.count == kMostFilters) multiply();
      filters.add(filter, row);
    }
  }
  multiply();
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
