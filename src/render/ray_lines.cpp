// Rays as OBJ lines.
#include "render/ray_lines.h"

#include <algorithm>
#include <cmath>

#include "render/blocker.h"
#include "render/report_words.h"

namespace {

struct Look {
  const char* name;
  const char* color;
};
/// By RayLines::Kind.
constexpr Look kLooks[] = {{"eye", "0.9 0.9 0.9"},         {"mirror", "0.2 0.6 1"},
                           {"refracted", "0.2 0.9 0.3"},   {"shadow_lit", "1 0.9 0.2"},
                           {"shadow_tinted", "1 0.5 0.1"}, {"shadow_blocked", "0.9 0.1 0.1"}};

bool isFinite(const Vec3d& v) {
  return std::isfinite(v.x()) && std::isfinite(v.y()) && std::isfinite(v.z());
}

}  // namespace

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
