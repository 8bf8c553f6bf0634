// One pixel: the ray through its centre, and its samples where it has others.
#include "render/pixel_trace.h"

#include "render/sampled_renderer.h"
#include "render/tracing_stack.h"
#include "render/watched_tracer.h"
#include "system/worker_threads.h"

namespace {

/// Tells several observers, one after the other.
class Observers : public RayObserver {
 public:
  explicit Observers(const std::vector<RayObserver*>& all) : all_(all) {}

  void rayBegins(const RayBegin& ray) override {
    tell([&](RayObserver& one) { one.rayBegins(ray); });
  }
  void surfaceIsPassed(const Hit& hit) override {
    tell([&](RayObserver& one) { one.surfaceIsPassed(hit); });
  }
  void rayMeets(const Hit* hit) override {
    tell([&](RayObserver& one) { one.rayMeets(hit); });
  }
  void interfaceIsKnown(const Interface& interface) override {
    tell([&](RayObserver& one) { one.interfaceIsKnown(interface); });
  }
  void componentBegins(const Material& material, double share) override {
    tell([&](RayObserver& one) { one.componentBegins(material, share); });
  }
  void componentEnds(const Vec3f& color) override {
    tell([&](RayObserver& one) { one.componentEnds(color); });
  }
  void lightAnswers(const LightVerdict& verdict) override {
    tell([&](RayObserver& one) { one.lightAnswers(verdict); });
  }
  void lightAdds(const Vec3d& color) override {
    tell([&](RayObserver& one) { one.lightAdds(color); });
  }
  void branchEnds(RayKind kind, Outcome why, float weight) override {
    tell([&](RayObserver& one) { one.branchEnds(kind, why, weight); });
  }
  void termIsKnown(ColorTerm term, const Vec3d& color) override {
    tell([&](RayObserver& one) { one.termIsKnown(term, color); });
  }
  void rayEnds(const Vec3f& color) override {
    tell([&](RayObserver& one) { one.rayEnds(color); });
  }

 private:
  template <class Event>
  void tell(const Event& event) const {
    for (RayObserver* one : all_) event(*one);
  }

  const std::vector<RayObserver*>& all_;
};

/// What the picture has there: the weighted mean of all samples that count.
Vec3f sampledColor(const SampledScene& scene, const SamplingOptions& sampling, Pixel at) {
  const auto sampler = makeSampler(sampling);
  const auto filter = makeFilter(sampling);
  const PixelRectangle area = {at.i, at.j, at.i + 1, at.j + 1};
  Film film(area, *filter);
  takeSamples(scene, *sampler, sampling.tolerance, area.grown(filter->getSupportRadius()),
              [&](const Sample& sample, const Vec3f& color, double share) {
                film.addSample(sample.at, sample.offset, color, share);
              });
  return film.getColor(at);
}

}  // namespace

PixelColors tracePixel(const SceneParser& scene, const Object3D& geometry,
                       const RenderOptions& options, const PixelOfPicture& place,
                       const std::vector<RayObserver*>& observers) {
  const Camera& camera = *scene.getCamera();
  PixelColors colors;
  runOnThreads(1, tracingStack(options), [&](int) {
    Observers all(observers);
    Ray ray =
        camera.generateRay(imagePoint(place.i + 0.5, place.j + 0.5, place.width, place.height));
    Hit hit;
    colors.centralRay = WatchedTracer(scene, geometry, options, all)
                            .traceRay(ray, float(camera.getTMin()), 0, 1, 1, hit);
    const RayTracer tracer(scene, geometry, options);
    const WaveTracer waves(tracer);
    colors.pixel = options.sampling.isPlain()
                       ? colors.centralRay
                       : sampledColor({camera, waves, place.width, place.height}, options.sampling,
                                      {place.i, place.j});
  });
  return colors;
}
