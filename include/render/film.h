// How samples become pixels: a Filter says how much each sample counts, a Film adds them up.
//
// The colour of a pixel is the sum of weight times colour over the samples within the filter's
// reach, divided by the sum of their weights, so that only the shape of a filter matters and not
// its height. Lengths are in pixels. Two pictures show what happens: that of the filter's weights,
// and that of the samples.
#pragma once
#include <vector>

#include "image/image.h"
#include "math/vec3.h"
#include "render/image_plane.h"
#include "render/render_options.h"

/// The weight of a sample by where it lies from the centre of a pixel, and how far that goes.
class Filter {
 public:
  /// That of the options, and its size.
  explicit Filter(const SamplingOptions& options);

  /// The weight, from 0 to 1, of a sample at (x, y) from the pixel's centre.
  double getWeight(double x, double y) const;
  /// How many pixels to each side have samples that may count; 0: only the pixel's own do.
  int getSupportRadius() const { return supportRadius_; }
  /// True where samples in the cells along the picture's edges stand for the cells beyond too.
  bool repeatsEdges() const { return options_.filter == SamplingOptions::FilterKind::blurredCells; }

 private:
  SamplingOptions options_;
  int supportRadius_;
};

/// The weighted sums for a rectangle of pixels. A pixel's colour depends on the order in which the
/// samples near it come (by rounding), on nothing else: whoever adds them keeps to one order for
/// the whole picture.
class Film {
 public:
  /// `area` lies in `picture`, the whole one.
  Film(const PixelRectangle& area, const Filter& filter, const PixelRectangle& picture);

  /// Adds a sample, which may lie outside of the area, to all pixels that it counts for. Its
  /// weights are multiplied by `share` > 0. It lies in the picture where the filter repeats edges.
  void addSample(const Sample& sample, const Vec3f& color, double share);

  /// The filtered colour of a pixel in the area; the mean of the pixel's own samples where the
  /// filter gives none of those around it any weight. NaN where it has no samples either.
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

  void addAt(const Sample& sample, const Vec3f& color, double share);

  PixelRectangle area_, picture_;
  Filter filter_;
  std::vector<Sum> filtered_, own_;  // of the pixels in the area, row by row
};

/// The picture of a filter: in width x height pixels, each a square of `zoom` x `zoom`, the weight
/// that every place has for the pixel in the middle. Grey from 0 to 1 in the pixels that the filter
/// reaches, dark blue beyond, and a blue grid of one-pixel lines between the pixels. The result has
/// width * zoom + 1 by height * zoom + 1 pixels.
Image drawFilter(const Filter& filter, int width, int height, int zoom);

/// The picture of samples is `zoom` >= 1 times as large as the picture that they are of. This draws
/// its ground where the pixels of `area` are: squares in dark grey and black as on a chessboard.
void drawSamplesGround(Image& picture, int zoom, const PixelRectangle& area);
/// Draws one sample there, as one pixel of its colour at its place; of samples at the same place
/// the last one shows.
void drawSample(Image& picture, int zoom, const Sample& sample, const Vec3f& color);
