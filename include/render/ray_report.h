// RayReport: an observer that prints the tree of rays as text, as traceRay goes along.
// One line for each fact, in plain ASCII, two blanks for each step down. README.txt explains them.
#pragma once
#include <functional>
#include <string>

#include "render/ray_observer.h"
#include "render/render_options.h"
#include "render/report_words.h"

class RayReport : public RayObserver {
 public:
  /// Takes one line after the other, each with its end.
  using Sink = std::function<void(const std::string& line)>;

  /// `names` and `geometry`, which answers for the scene's objects, are not owned; `options` are
  /// those of the tracer.
  RayReport(const SceneNames& names, const Object3D& geometry, const RenderOptions& options,
            Sink sink)
      : names_(names), geometry_(geometry), options_(options), sink_(std::move(sink)) {}

  void rayBegins(const RayBegin& ray) override;
  void surfaceIsPassed(const Hit& hit) override;
  void rayMeets(const Hit* hit) override;
  void interfaceIsKnown(const Interface& interface) override;
  void componentBegins(const Material& material, double share) override;
  void componentEnds(const Vec3f& color) override;
  void lightAnswers(const LightVerdict& verdict) override;
  void lightAdds(const Vec3d& color) override;
  void branchEnds(RayKind kind, Outcome why, float weight) override;
  void termIsKnown(ColorTerm term, const Vec3d& color) override;
  void rayEnds(const Vec3f& color) override;

 private:
  void line(const std::string& text) const;
  std::string wayOf(const LightVerdict& verdict) const;

  const SceneNames& names_;
  const Object3D& geometry_;
  const RenderOptions options_;
  const Sink sink_;
  int depth_ = 0;
  const Material* material_ = nullptr;  // of what was met last; not owned
};
