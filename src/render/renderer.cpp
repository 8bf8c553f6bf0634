// The renderer: tiles are handed out one by one, so that no thread waits for a slow one.
#include "render/renderer.h"

#include <algorithm>
#include <atomic>
#include <cmath>

#include "render/ray_tracer.h"
#include "system/worker_threads.h"

namespace {

constexpr int kTileSize = 16;
/// Stack for the deepest scene, and for each bounce that the options allow (measured: below 1 kB a
/// bounce, 3 kB with sanitizers).
constexpr std::size_t kBaseStack = 2 << 20, kStackPerBounce = 4096;

const Image& anyOf(const RenderTargets& targets) {
  return targets.color ? *targets.color : targets.depth ? *targets.depth : *targets.normals;
}

class TileRenderer {
 public:
  TileRenderer(const SceneParser& scene, const Object3D& geometry, const RayTracer& tracer,
               const RenderTargets& targets)
      : camera_(*scene.getCamera()),
        background_(scene.getBackgroundColor()),
        geometry_(geometry),
        tracer_(tracer),
        targets_(targets),
        width_(anyOf(targets).Width()),
        height_(anyOf(targets).Height()) {}

  int tileCount() const { return columns() * rows(); }

  void renderTile(int tile) const {
    const int left = tile % columns() * kTileSize, bottom = tile / columns() * kTileSize;
    for (int j = bottom; j < std::min(bottom + kTileSize, height_); ++j) {
      for (int i = left; i < std::min(left + kTileSize, width_); ++i) renderPixel(i, j);
    }
  }

 private:
  int columns() const { return (width_ + kTileSize - 1) / kTileSize; }
  int rows() const { return (height_ + kTileSize - 1) / kTileSize; }

  /// The centre of pixel (i, j) on the image plane.
  Vec2d imagePoint(int i, int j) const {
    const double longer = std::max(width_, height_);
    return {(i + 0.5 - width_ / 2.0) / longer, (j + 0.5 - height_ / 2.0) / longer};
  }

  void renderPixel(int i, int j) const {
    Ray ray = camera_.generateRay(imagePoint(i, j));
    Hit hit;
    const bool found = geometry_.intersect(ray, hit, camera_.getTMin());
    if (targets_.color) {
      targets_.color->setPixel(i, j, found ? tracer_.shade(ray, hit, 0, 1, 1) : background_);
    }
    if (targets_.depth) targets_.depth->setPixel(i, j, found ? depthColor(hit) : Vec3f());
    if (targets_.normals) targets_.normals->setPixel(i, j, found ? normalColor(hit) : Vec3f());
  }

  Vec3f depthColor(const Hit& hit) const {
    const double grey = (targets_.depthMax - hit.getT()) / (targets_.depthMax - targets_.depthMin);
    const float clamped = float(std::clamp(grey, 0.0, 1.0));
    return {clamped, clamped, clamped};
  }

  static Vec3f normalColor(const Hit& hit) {
    const Vec3f n(hit.getNormal());
    return {std::fabs(n.x()), std::fabs(n.y()), std::fabs(n.z())};
  }

  const Camera& camera_;
  const Vec3f background_;
  const Object3D& geometry_;
  const RayTracer tracer_;
  const RenderTargets targets_;
  const int width_, height_;
};

}  // namespace

void render(const SceneParser& scene, const Object3D& geometry, const RenderOptions& options,
            int threads, const RenderTargets& targets) {
  const RayTracer tracer(scene, geometry, options);
  const TileRenderer renderer(scene, geometry, tracer, targets);
  std::atomic<int> next{0};
  const std::size_t stack = kBaseStack + std::size_t(options.maxBounces) * kStackPerBounce;
  runOnThreads(std::min(threads, renderer.tileCount()), stack, [&](int) {
    for (int tile; (tile = next++) < renderer.tileCount();) renderer.renderTile(tile);
  });
}
