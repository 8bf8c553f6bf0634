// TileStore: the renderer asks before each tile and tells after it.
#include <mutex>

#include "check.h"
#include "render/image_plane.h"
#include "render/renderer.h"
#include "sampling.h"

namespace {

constexpr int kWidth = 70, kHeight = 50;

/// Says that the tiles whose lower left corner is left of `border` are finished, and counts how
/// often each pixel is told of, in the colour picture and in that of the depth.
class Counter : public TileStore {
 public:
  explicit Counter(int border) : border_(border) {}

  bool isFinished(const RenderTargets&, const PixelRectangle& area) const override {
    return area.left < border_;
  }
  void finish(const RenderTargets& targets, const PixelRectangle& area) override {
    const std::lock_guard<std::mutex> lock(mutex_);
    areRight_ = areRight_ && area.left % 16 == 0 && area.bottom % 16 == 0 && area.left >= 0 &&
                area.bottom >= 0 && area.right <= kWidth && area.top <= kHeight &&
                (area.right % 16 == 0 || area.right == kWidth) &&
                (area.top % 16 == 0 || area.top == kHeight);
    for (int j = area.bottom; areRight_ && j < area.top; ++j) {
      for (int i = area.left; i < area.right; ++i) {
        const auto place = std::size_t(j * kWidth + i);
        colorTold[place] += targets.color != nullptr;
        depthTold[place] += targets.depth != nullptr;
      }
    }
  }
  bool areRight() const { return areRight_; }

  std::vector<int> colorTold = std::vector<int>(kWidth * kHeight);
  std::vector<int> depthTold = colorTold;

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
    ::render(scene, *scene.getGroup(), options, threads, targets);
  }
};

}  // namespace

TEST("each pixel is told of once in each picture, and what is finished already is left alone") {
  const Rgb8 mark = {1, 2, 3};
  for (const RenderOptions& options :
       {RenderOptions(), sampling::sampled(sampling::Pattern::random, 2),
        sampling::sampled(sampling::Pattern::jittered, 4, sampling::FilterKind::tent, 2)}) {
    Pictures whole;
    whole.render(options, 1, nullptr);
    for (const int border : {0, 16, 33}) {
      Pictures pictures;
      pictures.color.setAllPixels(Vec3f(0.0051f, 0.009f, 0.0130f));  // 1 2 3, see bytesFromColor
      Counter counter(border);
      pictures.render(options, 1 + border % 3, &counter);
      CHECK(counter.areRight());
      int wrong = 0, kept = 0;
      for (int place = 0; place < kWidth * kHeight; ++place) {
        const int i = place % kWidth, j = place / kWidth;
        const int color = counter.colorTold[std::size_t(place)];
        const bool isKept = color == 0;
        kept += isKept;
        wrong += pictures.color.getPixel(i, j) != (isKept ? mark : whole.color.getPixel(i, j));
        wrong += color > 1 || counter.depthTold[std::size_t(place)] > 1;
        wrong += isKept && border == 0;
      }
      CHECK_EQUAL(wrong, 0);
      CHECK_EQUAL(kept > 0, border > 0);
    }
  }
}
