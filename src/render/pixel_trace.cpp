// One pixel's rays, traced for those who watch them, and kept as lines.
//
// A line is added when its end is known: that of an eye ray or secondary ray where it meets
// something, that of a shadow ray at the light, or at what blocks it, which is found by a search of
// its own.
#include "render/pixel_trace.h"

#include <cmath>

#include "image/image.h"
#include "render/ray_report.h"
#include "render/sample_tracing.h"
#include "render/tiles.h"
#include "render/transmittance.h"

namespace {

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

/// The observers watch the ray through the centre, each on a tracer of its own; the colour is
/// another question, as samples around the pixel may have a share in it.
Vec3f tracePixel(const RayTracer& tracer, const PictureWindow& window,
                 const std::vector<RayObserver*>& observers) {
  const PictureView view(*tracer.scene().getCamera(), tracer.options().places, window.width,
                         window.height);
  runOnThreads(1, tracingStack(tracer.options()), [&](int) {
    for (RayObserver* const observer : observers) {
      traceAlone(view, WatchedTracer(tracer, *observer),
                 {{window.left, window.bottom}, {0.5, 0.5}});
    }
  });
  // The renderer gives a pixel of a window the very colour that it has in the whole picture.
  Image pixel(1, 1);
  FloatImage color(1, 1);
  RenderTargets targets;
  targets.color = &pixel;
  targets.exactColor = &color;
  targets.window = window;
  render(tracer, 1, targets);
  return color.getPixel(0, 0);
}

/// Keeps the stretch of a ray between two parameters.
void RayLines::add(Kind kind, const Ray& ray, double from, double to) {
  const Line line = {ray.pointAtParameter(from), ray.pointAtParameter(to)};
  if (isFinite(line.from) && isFinite(line.to)) lines_[std::size_t(kind)].push_back(line);
}

void RayLines::rayBegins(RayKind kind, int, const TracedRay& ray) {
  ray_ = ray.ray;
  kind_ = Kind(int(kind));
}

/// An orthographic camera sees behind its centre: there the line comes from further back.
void RayLines::rayMeets(const Hit* hit, const Interface&) {
  const double to = hit ? hit->getT() : escapeLength_;
  add(kind_, ray_, to < 0 ? to - escapeLength_ : 0, to);
}

void RayLines::lightAnswers(int, const LightSample&, const ShadowQuery* shadowRay,
                            const Vec3f& visible, const Vec3d&) {
  if (!shadowRay) return;
  const double whole = std::isfinite(shadowRay->tmax) ? shadowRay->tmax : escapeLength_;
  if (visible == Vec3f(1, 1, 1)) return add(lit, shadowRay->ray, 0, whole);
  if (visible != Vec3f()) return add(tinted, shadowRay->ray, 0, whole);
  const auto blocker =
      findBlocker(tracer_.geometry(), *shadowRay, tracer_.options().transparentShadows);
  add(blocked, shadowRay->ray, 0, blocker ? blocker->t : whole);
}

/// Vertices are numbered from 1 on through the whole file, two for each line.
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
