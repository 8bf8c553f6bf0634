// RenderOptions: everything that a picture depends on besides the scene.
#pragma once

/// How far along its unit direction a secondary or shadow ray starts looking.
struct Epsilon {
  enum class Kind {
    automatic,  ///< fixed 0.001 where the scene spans 1 to 1000 units, else adaptive
    fixed,      ///< `value`
    adaptive    ///< from the size of the numbers at the hit
  };
  static constexpr double kCourse = 0.001;

  Kind kind = Kind::automatic;
  double value = kCourse;  ///< used by `fixed` alone; >= 0
};

/// The most secondary rays in a row that any run may ask for.
inline constexpr int kMaxBounces = 10000;

/// Where in a pixel rays are sent, and how their colours become the pixel's.
struct SamplingOptions {
  enum class Pattern {
    center,    ///< one sample, at the pixel's centre
    random,    ///< anywhere in the pixel
    uniform,   ///< the centres of a square grid of cells
    jittered,  ///< one anywhere in each cell of a square grid
    adaptive   ///< jittered, with more samples where colours differ
  };
  enum class FilterKind {
    box,          ///< 1 where |x| and |y| are at most the radius
    tent,         ///< falls evenly with the distance, to 0 at the radius
    gaussian,     ///< exp(-d^2 / (2 sigma^2)), cut off at gaussianCut sigma
    blurredCells  ///< the pixel's kCells x kCells cells, after all cells were blurred: film.cpp
  };
  /// Cells along the side of a pixel that blurredCells takes a pixel for.
  static constexpr int kCells = 3;
  /// Where random and jittered samples take their numbers from.
  enum class Numbers {
    hashed,   ///< from a hash of the pixel and the sample
    sequence  ///< from one sequence for the whole picture: math::sequenceNumber
  };

  /// Limits of the numbers below. A filter reaches at most kMaxReach pixels.
  static constexpr int kMaxSamples = 65536, kMaxFirstSamples = 256, kMaxReach = 32;

  Pattern pattern = Pattern::center;
  /// Samples wanted in each pixel, 1..kMaxSamples; all but `random` round it up to a square.
  /// `adaptive` begins with as many (1..kMaxFirstSamples) and goes up to maxSamples.
  int samples = 1;
  int maxSamples = 1;  ///< samples..kMaxSamples, rounded up to the squared grid times a power of 4
  /// Colours, as shown, that differ by more in some component call for more samples: `adaptive`
  /// alone; 0..1. Below 0 every pixel gets maxSamples.
  double tolerance = 0;

  FilterKind filter = FilterKind::box;
  /// In pixels, above 0: the radius of box or tent, at most kMaxReach, or the gaussian's sigma, at
  /// most half of that.
  double filterSize = 0.5;

  // How the course of a year samples and filters.
  Numbers numbers = Numbers::hashed;
  /// Uniform samples stand at multiples of 2^-30 of a pixel, so that sums with them are exact: what
  /// lies on an edge through the picture's middle stays on it.
  bool isGridExact = false;
  /// In sigmas: 2, or infinite, where it goes on as far as whole pixels within 2 sigma do.
  double gaussianCut = 2;
  bool isFilterSingle = false;   ///< a box compares places in single precision
  bool hasBorderSamples = true;  ///< pixels around the picture have samples, which count in it

  /// True where each pixel is the colour of the ray through its centre.
  bool isPlain() const {
    return pattern == Pattern::center && filter == FilterKind::box && filterSize == 0.5;
  }
};

/// How the pixels of a picture lie on the camera's image plane, whose middle is (0, 0).
struct PixelPlaces {
  /// What is 1 long there.
  enum class Unit {
    longerSide,  ///< of the picture; pixels are squares
    height,      ///< of the picture; pixels are squares
    bothSides    ///< the picture is a square, whatever its pixels are
  };
  Unit unit = Unit::longerSide;
  /// In pixels, 0..1: that side counts as so much shorter. At 1 it goes from the centre of its
  /// first pixel to that of the last; one of a single pixel is 1 long then.
  double inset = 0;
  /// In pixels: all lie so much further to the left and down. At 0.5 the centre of a pixel lies
  /// where its lower left corner would.
  double shift = 0;
};

struct RenderOptions {
  int maxBounces = 5;               ///< 0..kMaxBounces secondary rays in a row
  float minWeight = 0.01f;          ///< a secondary ray of less weight is not traced
  bool shadows = true;              ///< cast shadow rays
  bool transparentShadows = false;  ///< transparent objects tint the light instead of blocking it
  bool shadeBack = false;           ///< light both sides of every surface
  /// What a side sends back that is seen from behind, unless `shadeBack` lights it.
  enum class Backs {
    litAsFront,  ///< the light of lamps before the surface, which shine on its other side
    ambient,     ///< ambient light alone
    nothing      ///< no light of its own; what it mirrors and lets through
  };
  Backs backs = Backs::litAsFront;
  bool isAmbientPlain = false;     ///< ambient light meets the diffuse colour, not what replaces it
  bool nestedDielectrics = false;  ///< indices follow from what a ray is inside of, by priority
  bool fresnel = false;            ///< reflection follows from index and angle
  /// What a transparent material mirrors and what it lets through are parts of its colours, by
  /// Schlick's formula; `fresnel` comes before it.
  bool blendsGlass = false;
  Epsilon epsilon;
  PixelPlaces places;
  SamplingOptions sampling;
};
