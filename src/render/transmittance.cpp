// Transmittance: gathers all crossings of a shadow ray, then multiplies object by object.
#include "render/transmittance.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <tuple>
#include <vector>

#include "math/functions.h"
#include "shading/material.h"

namespace {

/// One object's part in the light: its colour to the power `exponent`.
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
  ShadowRay(double epsilon, double distance) : epsilon_(epsilon), distance_(distance) {}

  void visit(const Crossing& crossing) override {
    const bool between = crossing.t > epsilon_ && crossing.t < distance_;
    if (!anyPositive(crossing.material->getTransparentColor())) {
      blocked_ = blocked_ || between;
    } else if (crossing.closed || between) {
      crossings_.push_back(crossing);
    }
  }

  Vec3f result() {
    if (blocked_) return Vec3f();
    // Sums and products are taken in an order that does not depend on the order of visits.
    std::sort(crossings_.begin(), crossings_.end(), [](const Crossing& a, const Crossing& b) {
      if (a.object != b.object) return std::less<>()(a.object, b.object);
      return std::make_tuple(a.t, a.leaving) < std::make_tuple(b.t, b.leaving);
    });
    std::vector<Filter> filters;
    for (auto first = crossings_.begin(); first != crossings_.end();) {
      const auto last = std::find_if(first, crossings_.end(),
                                     [&](const Crossing& c) { return c.object != first->object; });
      filters.push_back(filterOf(first, last));
      first = last;
    }
    std::sort(filters.begin(), filters.end(), filterLess);
    Vec3f product(1, 1, 1);
    for (const Filter& filter : filters) product *= power(filter.color, filter.exponent);
    return product;
  }

 private:
  using Iterator = std::vector<Crossing>::const_iterator;

  /// The crossings of one object. The length inside is the sum of the places where the ray leaves
  /// less those where it enters, none counted beyond the light: an object that holds the light or
  /// the ray's origin comes out right as well, and one that is inside out differs in sign.
  Filter filterOf(Iterator first, Iterator last) const {
    const Vec3f color = first->material->getTransparentColor();
    if (!first->closed) return {color, double(last - first)};
    double inside = 0;
    for (Iterator c = first; c != last; ++c) {
      const double t = std::min(c->t, distance_);
      inside += c->leaving ? t : -t;
    }
    return {color, std::fabs(inside)};
  }

  static Vec3f power(const Vec3f& color, double exponent) {
    Vec3f result;
    for (int i = 0; i < 3; ++i) result[i] = float(math::pow(std::max(color[i], 0.0f), exponent));
    return result;
  }

  double epsilon_, distance_;
  bool blocked_ = false;
  std::vector<Crossing> crossings_;
};

}  // namespace

Vec3f transmittance(const Object3D& geometry, const Ray& ray, double epsilon, double distance) {
  ShadowRay visitor(epsilon, distance);
  geometry.visitCrossings(ray, visitor);
  return visitor.result();
}
