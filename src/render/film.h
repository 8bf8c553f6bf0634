// Film: the weighted sums of samples for a rectangle of pixels.
// A pixel's colour depends on the order in which the samples near it come (by rounding), on nothing
// else: whoever adds them keeps to one order for the whole picture.
#pragma once
#include <vector>

#include "math/vec2.h"
#include "math/vec3.h"
#include "render/filter.h"
#include "render/image_plane.h"

class Film {
 public:
  /// The filter is not owned.
  Film(const PixelRectangle& area, const Filter& filter);

  /// Adds a sample that lies at `offset` from the lower left corner of pixel `at`, which may be
  /// outside of the area, to all pixels that it counts for. Its weights are multiplied by `share`.
  void addSample(Pixel at, const Vec2d& offset, const Vec3f& color, double share);

  /// The filtered colour of a pixel in the area; the mean of the pixel's own samples where the
  /// filter gives none of those around it any weight.
  Vec3f getColor(Pixel at) const;

 private:
  struct Sum {
    Vec3d color;
    double weight = 0;
    void add(const Vec3f& sample, double sampleWeight) {
      color += Vec3d(sample) * sampleWeight;
      weight += sampleWeight;
    }
  };

  PixelRectangle area_;
  const Filter& filter_;  // not owned
  int reach_;
  std::vector<Sum> filtered_, own_;
};
