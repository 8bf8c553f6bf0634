// TileStore: the renderer asks before each tile and tells after it.
#include <mutex>

#include "check.h"
#include "render/image_plane.h"
#include "render/renderer.h"
#include "sampling.h"

namespace {

constexpr int kWidth = 70, kHeight = 50;

/// Says that the tiles whose lower left corner is left of `border` are finished, and counts how
/// often each pixel is told of.
class Counter : public TileStore {
 public:
  explicit Counter(int border) : border_(border) {}

  bool isFinished(const PixelRectangle& area) const override { return area.left < border_; }
  void finish(const PixelRectangle& area) override {
    const std::lock_guard<std::mutex> lock(mutex_);
    areRight_ = areRight_ && area.left % 16 == 0 && area.bottom % 16 == 0 && area.left >= 0 &&
                area.bottom >= 0 && area.right <= kWidth && area.top <= kHeight &&
                (area.right % 16 == 0 || area.right == kWidth) &&
                (area.top % 16 == 0 || area.top == kHeight);
    for (int j = area.bottom; areRight_ && j < area.top; ++j) {
      for (int i = area.left; i < area.right; ++i) {
        ++told[std::size_t(j * kWidth + i)];
      }
    }
  }
  bool areRight() const { return areRight_; }

  std::vector<int> told = std::vector<int>(kWidth * kHeight);

 private:
  const int border_;
  std::mutex mutex_;
  bool areRight_ = true;
};

struct Pictures {
  Image color{kWidth, kHeight}, depth{kWidth, kHeight};

  void render(const RenderOptions& options, int threads, TileStore* store) {
    const SceneParser scene = sampling::variedScene();
    RenderTargets targets;
    targets.color = &color;
    targets.depth = &depth;
    targets.depthMax = 9;
    targets.store = store;
    ::render(RayTracer(scene, *scene.getGroup(), options), threads, targets);
  }
};

}  // namespace

TEST("each pixel is told of once, and what is finished already is left alone in all pictures") {
  const Rgb8 mark = {1, 2, 3};
  for (const RenderOptions& options :
       {RenderOptions(), sampling::sampled(sampling::Pattern::random, 2),
        sampling::sampled(sampling::Pattern::jittered, 4, sampling::FilterKind::tent, 2)}) {
    Pictures whole;
    whole.render(options, 1, nullptr);
    for (const int border : {0, 16, 33}) {
      Pictures pictures;
      for (Image* image : {&pictures.color, &pictures.depth}) {
        image->setAllPixels(Vec3f(0.0051f, 0.009f, 0.0130f));  // 1 2 3, see bytesFromColor
      }
      Counter counter(border);
      pictures.render(options, 1 + border % 3, &counter);
      CHECK(counter.areRight());
      int wrong = 0, kept = 0;
      for (int place = 0; place < kWidth * kHeight; ++place) {
        const int i = place % kWidth, j = place / kWidth;
        const int told = counter.told[std::size_t(place)];
        const bool isKept = told == 0;
        kept += isKept;
        wrong += pictures.color.getPixel(i, j) != (isKept ? mark : whole.color.getPixel(i, j));
        wrong += pictures.depth.getPixel(i, j) != (isKept ? mark : whole.depth.getPixel(i, j));
        wrong += told > 1;
        wrong += isKept && border == 0;
      }
      CHECK_EQUAL(wrong, 0);
      CHECK_EQUAL(kept > 0, border > 0);
    }
  }
}
