// The lines of a ray tree.
#include "render/ray_report.h"

#include <algorithm>

#include "render/blocker.h"

namespace {

constexpr const char* kKinds[] = {"eye", "mirror", "refracted"};
constexpr const char* kTerms[] = {"ambient", "lights", "mirror", "transmitted"};
/// Deeper steps are not moved further to the right, so that a text of n lines has no n^2 blanks.
constexpr int kMostSteps = 60;

}  // namespace

void RayReport::line(const std::string& text) const {
  sink_(std::string(std::size_t(2 * std::min(depth_, kMostSteps)), ' ') + text + "\n");
}

void RayReport::rayBegins(const RayBegin& ray) {
  line(std::string(kKinds[int(ray.kind)]) + " ray, bounces " + std::to_string(ray.bounces) +
       ", weight " + textOf(ray.weight) + ", index " + textOf(ray.indexOfRefraction));
  ++depth_;
  line("origin " + textOf(ray.ray.getOrigin()));
  line("direction " + textOf(ray.ray.getDirection()) + ", t above " + textOf(ray.tmin));
  if (ray.kind != RayKind::eye) line("factor " + textOf(ray.factor));
}

void RayReport::surfaceIsPassed(const Hit& hit) {
  line("passes " + names_.ofObject(hit.getObject(), hit.getFace()) + ", at t " +
       textOf(hit.getT()) + ": the same medium on both sides");
}

void RayReport::rayMeets(const Hit* hit) {
  if (!hit) return line("hits nothing: background");
  material_ = hit->getMaterial();
  line("hits " + names_.ofObject(hit->getObject(), hit->getFace()));
  line("t " + textOf(hit->getT()) + ", point " + textOf(hit->getIntersectionPoint()) + ", normal " +
       textOf(hit->getNormal()));
  line(names_.ofMaterial(*material_));
}

void RayReport::interfaceIsKnown(const Interface& interface) {
  if (anyPositive(material_->getTransparentColor())) {
    line("index before " + textOf(interface.before.indexAt(*material_)) + ", behind " +
         textOf(interface.behind.indexAt(*material_)));
  }
  if (interface.tint != Vec3f(1, 1, 1)) line("dimmed on the way by " + textOf(interface.tint));
}

void RayReport::componentBegins(const Material& material, double share) {
  line("part " + textOf(share) + " of " + names_.ofMaterial(material));
  ++depth_;
}

void RayReport::componentEnds(const Vec3f& color) {
  line("color of the part " + textOf(color));
  --depth_;
}

/// What came of the shadow ray.
std::string RayReport::wayOf(const LightVerdict& verdict) const {
  if (!verdict.isInFront) return "behind the surface";
  if (!verdict.query) return "in front, no shadow ray";
  if (verdict.visible == Vec3f(1, 1, 1)) return "in front, nothing in the way";
  const auto blocker = findBlocker(geometry_, *verdict.query, options_.transparentShadows);
  if (verdict.visible != Vec3f() || !blocker) {
    return "in front, tinted by " + textOf(verdict.visible);
  }
  return "in front, blocked by " + names_.ofObject(blocker->object, blocker->part) + ", at t " +
         textOf(blocker->t);
}

void RayReport::lightAnswers(const LightVerdict& verdict) {
  line(names_.ofLight(verdict.light) + ", direction " + textOf(verdict.direction) + ", distance " +
       textOf(verdict.distance) + ": " + wayOf(verdict));
}

void RayReport::lightAdds(const Vec3d& color) { line("  adds " + textOf(Vec3f(color))); }

void RayReport::branchEnds(RayKind kind, Outcome why, float weight) {
  const std::string reason =
      why == Outcome::tooManyBounces ? "bounces " + std::to_string(options_.maxBounces) + " is the most"
      : why == Outcome::tooFaint
          ? "weight " + textOf(weight) + " is below " + textOf(options_.minWeight)
          : std::string("total internal reflection");
  line("no " + std::string(kKinds[int(kind)]) + " ray: " + reason);
}

void RayReport::termIsKnown(ColorTerm term, const Vec3d& color) {
  line(std::string(kTerms[int(term)]) + " term " + textOf(Vec3f(color)));
}

void RayReport::rayEnds(const Vec3f& color) {
  line("color " + textOf(color));
  --depth_;
}
