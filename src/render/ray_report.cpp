// The tree of one ray as text, and the numbers of reports.
//
// The report follows the events of the recursion: a ray begins and the depth grows, facts are
// written as they come, the ray ends and the depth shrinks. It asks one thing more than it is told:
// a shadow ray ends at the first surface that it finds, so which one is nearest to the point is
// found by a search of its own.
//
// Numbers go through printf, which rounds to the nearest decimal number. For a float the digits are
// added one by one until reading them back gives the same float: 9 tell any two floats apart.
#include "render/ray_report.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>

#include "geometry/triangle_mesh.h"
#include "render/transmittance.h"

namespace {

constexpr int kFewestDigits = 1, kMostDigits = 9;

/// As %g prints it, with so many significant digits. Minus zero loses its sign.
std::string printed(double number, int digits) {
  if (number != number) return "nan";  // printf may give it a sign
  char text[32];
  std::snprintf(text, sizeof text, "%.*g", digits, number == 0 ? 0.0 : number);
  return text;
}

/// The tree of rays as text.
class RayReport : public RayObserver {
 public:
  RayReport(const RayTracer& tracer, const ObjectPlaces& places,
            std::function<void(const std::string& line)> writeLine)
      : tracer_(tracer), places_(places), writeLine_(std::move(writeLine)) {}

  // A ray: what it is, and one step further in where it starts, what it meets and what comes of it.
  void rayBegins(RayKind kind, int bounces, const TracedRay& ray) override {
    line(std::string(kKinds[int(kind)]) + " ray, bounces " + std::to_string(bounces) + ", weight " +
         textOf(ray.weight) + ", index " + textOf(ray.indexOfRefraction));
    ++depth_;
    line("origin " + textOf(ray.ray.getOrigin()));
    line("direction " + textOf(ray.ray.getDirection()) + ", t above " + textOf(ray.tmin));
    if (kind != RayKind::eye) line("factor " + textOf(ray.factor));
  }

  void surfaceIsPassed(const Hit& hit) override {
    line("passes " + nameOf(hit.getObject(), hit.getFace()) + ", at t " + textOf(hit.getT()) +
         ": the same medium on both sides");
  }

  // Indices matter only where something goes through, the tint only where there is one.
  void rayMeets(const Hit* hit, const Interface& interface) override {
    if (!hit) return line("hits nothing: background");
    const Material& material = *hit->getMaterial();
    line("hits " + nameOf(hit->getObject(), hit->getFace()));
    line("t " + textOf(hit->getT()) + ", point " + textOf(hit->getIntersectionPoint()) +
         ", normal " + textOf(hit->getNormal()));
    line(nameOf(material));
    if (material.isTransparent()) {
      line("index before " + textOf(interface.before.indexAt(material)) + ", behind " +
           textOf(interface.behind.indexAt(material)));
    }
    if (interface.tint != Vec3f(1, 1, 1)) line("dimmed on the way by " + textOf(interface.tint));
  }

  // A component of a texture, with all that follows for it, is one step further in too.
  void componentBegins(const Material& material, double share) override {
    line("part " + textOf(share) + " of " + nameOf(material));
    ++depth_;
  }

  void componentEnds(const Vec3f& color) override {
    line("color of the part " + textOf(color));
    --depth_;
  }

  void lightAnswers(int light, const LightSample& sample, const ShadowQuery* shadowRay,
                    const Vec3f& visible, const Vec3d& added) override {
    line("light " + std::to_string(light) + ", " + tracer_.scene().getLight(light)->getKind() +
         ", direction " + textOf(sample.direction) + ", distance " + textOf(sample.distance) +
         ": " +
         (sample.isInFront ? "in front, " + answerOf(shadowRay, visible) : "behind the surface"));
    if (visible != Vec3f()) line("  adds " + textOf(Vec3f(added)));
  }

  // Why a branch that the material asks for is not followed, with the limit that it has reached.
  void branchEnds(RayKind kind, Outcome why, float weight) override {
    const std::string reason =
        why == Outcome::tooManyBounces
            ? "bounces " + std::to_string(tracer_.options().maxBounces) + " is the most"
        : why == Outcome::tooFaint
            ? "weight " + textOf(weight) + " is below " + textOf(tracer_.options().minWeight)
            : std::string("total internal reflection");
    line("no " + std::string(kKinds[int(kind)]) + " ray: " + reason);
  }

  void termIsKnown(ColorTerm term, const Vec3d& color) override {
    line(std::string(kTerms[int(term)]) + " term " + textOf(Vec3f(color)));
  }

  void rayEnds(const Vec3f& color) override {
    line("color " + textOf(color));
    --depth_;
  }

 private:
  /// Deeper steps are not moved further to the right, so that a text of n lines has no n^2 blanks.
  static constexpr int kMostSteps = 60;

  void line(const std::string& text) const {
    writeLine_(std::string(std::size_t(2 * std::min(depth_, kMostSteps)), ' ') + text + "\n");
  }

  /// "Group 1 > Sphere 2, scene.txt:12"; of a mesh the triangle too, counted from 1.
  std::string nameOf(const Object3D* object, std::optional<std::uint32_t> face) const {
    const std::size_t line = places_.lineOf(object);
    if (line == 0) return "an object that is not in the scene file";
    const bool isMesh = dynamic_cast<const TriangleMesh*>(object) != nullptr;
    return places_.pathOf(object) + ", " + places_.file() + ":" + std::to_string(line) +
           (isMesh && face ? ", triangle " + std::to_string(std::uint64_t(*face) + 1) : "");
  }
  /// "material 0, PhongMaterial".
  static std::string nameOf(const Material& material) {
    if (material.getNumber() < 0) return "a material that is not in the scene file";
    return "material " + std::to_string(material.getNumber()) + ", " + material.getKind();
  }

  /// What came of a shadow ray, in words.
  std::string answerOf(const ShadowQuery* shadowRay, const Vec3f& visible) const {
    if (!shadowRay) return "no shadow ray";
    if (visible == Vec3f(1, 1, 1)) return "nothing in the way";
    // Crossings come in no order. The scene itself, which takes longer, tells those of several in
    // one place in its own, so that the first is named.
    const bool tinted = tracer_.options().transparentShadows;
    const auto blocker =
        findBlocker(tinted ? *tracer_.scene().getGroup() : tracer_.geometry(), *shadowRay, tinted);
    if (visible != Vec3f() || !blocker) return "tinted by " + textOf(visible);
    return "blocked by " + nameOf(blocker->object, blocker->face) + ", at t " + textOf(blocker->t);
  }

  static constexpr const char* kKinds[] = {"eye", "mirror", "refracted"};
  static constexpr const char* kTerms[] = {"ambient", "lights", "mirror", "transmitted"};

  const RayTracer& tracer_;
  const ObjectPlaces& places_;
  const std::function<void(const std::string& line)> writeLine_;
  int depth_ = 0;  // of rays and components of textures
};

}  // namespace

std::string textOf(float number) {
  int digits = kFewestDigits;
  while (digits < kMostDigits &&
         std::strtof(printed(double(number), digits).c_str(), nullptr) != number) {
    ++digits;
  }
  return printed(double(number), digits);
}

std::string textOf(double number) { return printed(number, kMostDigits); }

std::unique_ptr<RayObserver> makeRayReport(const RayTracer& tracer, const ObjectPlaces& places,
                                           std::function<void(const std::string& line)> writeLine) {
  return std::make_unique<RayReport>(tracer, places, std::move(writeLine));
}
