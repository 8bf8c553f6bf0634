// One pixel's rays, as text and as lines.
//
// The report follows the events of the recursion: a ray begins and the depth grows, facts are
// written as they come, the ray ends and the depth shrinks. The two observers ask one thing more
// than they are told: a shadow ray ends at the first surface that it finds, so which one is nearest
// to the point is found by a search of its own.
#include "render/pixel_trace.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>

#include "image/image.h"
#include "render/renderer.h"
#include "render/sample_tracing.h"
#include "render/tiles.h"
#include "render/transmittance.h"
#include "render/watched_tracer.h"

namespace {

/// What stands in the way of a light.
struct Blocker {
  const Object3D* object;             // not owned
  std::optional<std::uint32_t> face;  // of a mesh, where that is known
  double t;                           // along the shadow ray
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

/// The nearest surface on the way to the light that lets nothing of it through, where there is one:
/// any surface, or with `transparentShadows` only one that is opaque where it is crossed.
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

/// The tree of rays as text.
class RayReport : public RayObserver {
 public:
  RayReport(const SceneNames& names, const Object3D& geometry, const RenderOptions& options,
            std::function<void(const std::string& line)> writeLine)
      : names_(names), geometry_(geometry), options_(options), writeLine_(std::move(writeLine)) {}

  void rayBegins(const RayBegin& ray) override {
    line(std::string(kKinds[int(ray.kind)]) + " ray, bounces " + std::to_string(ray.bounces) +
         ", weight " + textOf(ray.weight) + ", index " + textOf(ray.indexOfRefraction));
    ++depth_;
    line("origin " + textOf(ray.ray.getOrigin()));
    line("direction " + textOf(ray.ray.getDirection()) + ", t above " + textOf(ray.tmin));
    if (ray.kind != RayKind::eye) line("factor " + textOf(ray.factor));
  }

  void surfaceIsPassed(const Hit& hit) override {
    line("passes " + names_.ofObject(hit.getObject(), hit.getFace()) + ", at t " +
         textOf(hit.getT()) + ": the same medium on both sides");
  }

  void rayMeets(const Hit* hit) override {
    if (!hit) return line("hits nothing: background");
    material_ = hit->getMaterial();
    line("hits " + names_.ofObject(hit->getObject(), hit->getFace()));
    line("t " + textOf(hit->getT()) + ", point " + textOf(hit->getIntersectionPoint()) +
         ", normal " + textOf(hit->getNormal()));
    line(names_.ofMaterial(*material_));
  }

  void interfaceIsKnown(const Interface& interface) override {
    if (anyPositive(material_->getTransparentColor())) {
      line("index before " + textOf(interface.before.indexAt(*material_)) + ", behind " +
           textOf(interface.behind.indexAt(*material_)));
    }
    if (interface.tint != Vec3f(1, 1, 1)) line("dimmed on the way by " + textOf(interface.tint));
  }

  void componentBegins(const Material& material, double share) override {
    line("part " + textOf(share) + " of " + names_.ofMaterial(material));
    ++depth_;
  }

  void componentEnds(const Vec3f& color) override {
    line("color of the part " + textOf(color));
    --depth_;
  }

  void lightAnswers(const LightVerdict& verdict) override {
    line(names_.ofLight(verdict.light) + ", direction " + textOf(verdict.direction) +
         ", distance " + textOf(verdict.distance) + ": " + answerOf(verdict));
  }

  void lightAdds(const Vec3d& color) override { line("  adds " + textOf(Vec3f(color))); }

  void branchEnds(RayKind kind, Outcome why, float weight) override {
    const std::string reason =
        why == Outcome::tooManyBounces
            ? "bounces " + std::to_string(options_.maxBounces) + " is the most"
        : why == Outcome::tooFaint
            ? "weight " + textOf(weight) + " is below " + textOf(options_.minWeight)
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

  /// What came of a light, in words.
  std::string answerOf(const LightVerdict& verdict) const {
    if (!verdict.isInFront) return "behind the surface";
    if (!verdict.query) return "in front, no shadow ray";
    if (verdict.visible == Vec3f(1, 1, 1)) return "in front, nothing in the way";
    const auto blocker = findBlocker(geometry_, *verdict.query, options_.transparentShadows);
    if (verdict.visible != Vec3f() || !blocker) {
      return "in front, tinted by " + textOf(verdict.visible);
    }
    return "in front, blocked by " + names_.ofObject(blocker->object, blocker->face) + ", at t " +
           textOf(blocker->t);
  }

  static constexpr const char* kKinds[] = {"eye", "mirror", "refracted"};
  static constexpr const char* kTerms[] = {"ambient", "lights", "mirror", "transmitted"};

  const SceneNames& names_;
  const Object3D& geometry_;
  const RenderOptions options_;
  const std::function<void(const std::string& line)> writeLine_;
  int depth_ = 0;                       // of rays and components of textures
  const Material* material_ = nullptr;  // of what was met last; not owned
};

/// How a kind of line looks, by RayLines::Kind.
struct Look {
  const char* name;
  const char* color;
};
constexpr Look kLooks[] = {{"eye", "0.9 0.9 0.9"},         {"mirror", "0.2 0.6 1"},
                           {"refracted", "0.2 0.9 0.3"},   {"shadow_lit", "1 0.9 0.2"},
                           {"shadow_tinted", "1 0.5 0.1"}, {"shadow_blocked", "0.9 0.1 0.1"}};

bool isFinite(const Vec3d& v) {
  return std::isfinite(v.x()) && std::isfinite(v.y()) && std::isfinite(v.z());
}

}  // namespace

Vec3f tracePixel(const SceneParser& scene, const Object3D& geometry, const RenderOptions& options,
                 const PixelOfPicture& place, const std::vector<RayObserver*>& observers) {
  const PictureView view = {*scene.getCamera(), place.width, place.height};
  runOnThreads(1, tracingStack(options), [&](int) {
    for (RayObserver* const observer : observers) {
      const WatchedTracer watched(scene, geometry, options, *observer);
      traceAlone(view, watched, {{place.i, place.j}, {0.5, 0.5}});
    }
  });
  // The renderer gives a pixel of a window the very colour that it has in the whole picture.
  Image pixel(1, 1);
  FloatImage color(1, 1);
  RenderTargets targets;
  targets.color = &pixel;
  targets.exactColor = &color;
  targets.window = {place.i, place.j, place.width, place.height};
  render(scene, geometry, options, 1, targets);
  return color.getPixel(0, 0);
}

std::unique_ptr<RayObserver> makeRayReport(const SceneNames& names, const Object3D& geometry,
                                           const RenderOptions& options,
                                           std::function<void(const std::string& line)> writeLine) {
  return std::make_unique<RayReport>(names, geometry, options, std::move(writeLine));
}

void RayLines::add(Kind kind, const Ray& ray, double from, double to) {
  const Line line = {ray.pointAtParameter(from), ray.pointAtParameter(to)};
  if (isFinite(line.from) && isFinite(line.to)) lines_[std::size_t(kind)].push_back(line);
}

void RayLines::rayBegins(const RayBegin& ray) {
  ray_ = ray.ray;
  kind_ = Kind(int(ray.kind));
}

/// An orthographic camera sees behind its centre: there the line comes from further back.
void RayLines::rayMeets(const Hit* hit) {
  const double to = hit ? hit->getT() : escapeLength_;
  add(kind_, ray_, to < 0 ? to - escapeLength_ : 0, to);
}

void RayLines::lightAnswers(const LightVerdict& verdict) {
  if (!verdict.query) return;
  const ShadowQuery& query = *verdict.query;
  const double whole = std::isfinite(query.tmax) ? query.tmax : escapeLength_;
  if (verdict.visible == Vec3f(1, 1, 1)) return add(lit, query.ray, 0, whole);
  if (verdict.visible != Vec3f()) return add(tinted, query.ray, 0, whole);
  const auto blocker = findBlocker(geometry_, query, options_.transparentShadows);
  add(blocked, query.ray, 0, blocker ? blocker->t : whole);
}

std::string RayLines::obj() const {
  std::string text = "# Rays that meet nothing are drawn " + textOf(escapeLength_) + " long.\n";
  std::size_t vertices = 0;
  for (std::size_t kind = 0; kind < lines_.size(); ++kind) {
    if (lines_[kind].empty()) continue;
    const Look& look = kLooks[kind];
    text += std::string("o ") + look.name + "\n";
    for (const Line& line : lines_[kind]) {
      for (const Vec3d& end : {line.from, line.to}) {
        text += "v " + textOf(end) + " " + look.color + "\n";
      }
      text += "l " + std::to_string(vertices + 1) + " " + std::to_string(vertices + 2) + "\n";
      vertices += 2;
    }
  }
  return text;
}
