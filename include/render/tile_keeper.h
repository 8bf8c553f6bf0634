// TileKeeper: whoever keeps finished tiles, so that they need not be rendered again.
#pragma once

struct PixelRectangle;
struct RenderTargets;

/// Called by all worker threads at once. `targets` has the pictures that the tiles at hand belong
/// to, and no other; `area` is in pixels of the picture (not of an enlarged one), within it, its
/// left and bottom multiples of 16, its right and top too unless they are the picture's. Tiles
/// have other areas when the number of threads is another.
class TileKeeper {
 public:
  virtual ~TileKeeper() = default;
  TileKeeper() = default;
  TileKeeper(const TileKeeper&) = delete;
  TileKeeper& operator=(const TileKeeper&) = delete;

  /// True where the pictures already hold all these pixels, which are then not rendered.
  virtual bool isFinished(const RenderTargets& targets, const PixelRectangle& area) const = 0;
  /// The pictures now hold these pixels, and nobody writes to them any more.
  virtual void finish(const RenderTargets& targets, const PixelRectangle& area) = 0;
};
