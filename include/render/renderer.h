// The renderer: casts rays through every pixel, in tiles, on several threads. One ray through the
// centre, unless RenderOptions::sampling says otherwise.
#pragma once
#include "image/image.h"
#include "render/image_plane.h"
#include "render/ray_counts.h"
#include "render/ray_tracer.h"

/// Keeps finished tiles, so that they need not be rendered again: for each tile the renderer asks
/// whether it is finished, else renders it and hands it over. Called by all worker threads at once.
/// `area` is in pixels of the targets (not of an enlarged one), within them, its left and bottom
/// multiples of kSide, its right and top too unless they are the targets'. Tiles have other areas
/// when the number of threads is another.
class TileStore {
 public:
  static constexpr int kSide = 16;  ///< pixels; all tiles are made of such squares

  virtual ~TileStore() = default;
  TileStore() = default;
  TileStore(const TileStore&) = delete;
  TileStore& operator=(const TileStore&) = delete;

  /// True where all targets already hold these pixels, which are then not rendered.
  virtual bool isFinished(const PixelRectangle& area) const = 0;
  /// The targets now hold these pixels, and nobody writes to them any more.
  virtual void finish(const PixelRectangle& area) = 0;
};

/// Is told how far the picture is, by all worker threads at once.
class TileListener {
 public:
  virtual ~TileListener() = default;

  /// Before the first tile; `eyeRays` is how many rays all tiles begin with.
  virtual void begins(double eyeRays) = 0;
  /// The pixels of `area` have their final values; its tile began with so many rays. Called by the
  /// thread that has set them.
  virtual void tileIsDone(const PixelRectangle& area, double eyeRays) = 0;
};

/// Which pixels of the whole picture the targets hold, where they are a part of it: those from
/// (left, bottom) on. A width and height of 0 mean that they are all of it.
struct PictureWindow {
  int left = 0, bottom = 0;   ///< in pixels from the lower left corner of the whole picture
  int width = 0, height = 0;  ///< of the whole picture
};

/// Pixels side by side in memory. Not owned.
struct PixelBytes {
  std::uint8_t* bytes;
  std::size_t size;
};

/// The pictures wanted. Null where one is not; at least one is given. All that are given have the
/// same size, at least 1 x 1, but `samples` is samplesZoom >= 1 times as wide and high; every pixel
/// is set. Not owned.
struct RenderTargets {
  Image* color = nullptr;
  Image* depth = nullptr;
  Image* normals = nullptr;
  Image* samples = nullptr;  ///< where the samples lie, and their colours
  int samplesZoom = 1;
  Image* materials = nullptr;  ///< each surface in the materialColor of its material
  /// Where the colours go besides before they become bytes, unclamped; each only where the target
  /// of the same name is given, and of its size.
  FloatImage* exactColor = nullptr;
  FloatImage* exactDepth = nullptr;
  FloatImage* exactNormals = nullptr;
  /// The t that is white and the t that is black in the depth image; they differ. Either may be the
  /// larger one. What is not hit is black, in every picture but `color` and where a normal of
  /// nothing has another colour; in exactDepth it lies behind every distance: -infinity, or
  /// infinity where depthMin is the larger one.
  double depthMin = 0, depthMax = 1;
  /// A normal n, 0 where nothing is hit, has the colour (n + 1) / 2, else |n|.
  bool hasSignedNormals = false;
  /// Every pixel is the same as in the whole picture. Without `samples` where it is a part.
  PictureWindow window{};
  TileListener* listener = nullptr;  ///< null: nobody wants to know of tiles
  TileStore* store = nullptr;        ///< null: nobody keeps tiles

  /// In pixels, `samples` counted as if it were not enlarged.
  Vec2<int> size() const;
  /// Which pictures there are, a bit for each.
  std::uint32_t pictureBits() const;
  /// Where the pixels of `area` lie, picture after picture in the order of the bits, rows from the
  /// bottom up: 3 bytes for each pixel, and for each one of an enlarged picture; 3 floats for one
  /// of exact colours.
  std::vector<PixelBytes> rowsOf(const PixelRectangle& area) const;
};

/// Fills the targets with the tracer's scene as its camera sees it. `threads` >= 1 never changes a
/// byte. At least one target must be given; a pixel's central ray is cast once however many there
/// are. Depth and normals are those of the central ray even where the colour comes from samples,
/// whose rays are then cast besides it, once for colour and samples together.
/// Where `counts` is not null, all rays are added to it.
/// Throws what a worker thread throws (std::bad_alloc, std::system_error).
void render(const RayTracer& tracer, int threads, const RenderTargets& targets,
            RayCounts* counts = nullptr);
