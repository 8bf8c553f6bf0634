// Who takes part while the renderer goes from tile to tile: a TileStore keeps finished tiles, so
// that they need not be rendered again, and a TileListener is told how far the picture is. Both are
// called by all worker threads at once. For each tile the renderer asks the store whether it is
// finished, else renders it and hands it to the store; then it tells the listener.
#pragma once

struct PixelRectangle;
struct RenderTargets;

/// `targets` has the pictures that the tiles at hand belong to, and no other; `area` is in pixels
/// of the picture (not of an enlarged one), within it, its left and bottom multiples of kSide, its
/// right and top too unless they are the picture's. Tiles have other areas when the number of
/// threads is another.
class TileStore {
 public:
  static constexpr int kSide = 16;  ///< pixels; all tiles are made of such squares

  virtual ~TileStore() = default;
  TileStore() = default;
  TileStore(const TileStore&) = delete;
  TileStore& operator=(const TileStore&) = delete;

  /// True where the pictures already hold all these pixels, which are then not rendered.
  virtual bool isFinished(const RenderTargets& targets, const PixelRectangle& area) const = 0;
  /// The pictures now hold these pixels, and nobody writes to them any more.
  virtual void finish(const RenderTargets& targets, const PixelRectangle& area) = 0;
};

class TileListener {
 public:
  virtual ~TileListener() = default;

  /// Before the first tile; `eyeRays` is how many rays all tiles begin with.
  virtual void begins(double eyeRays) = 0;
  /// The pixels of `area` have their final values; its tile began with so many rays. Called by the
  /// thread that has set them.
  virtual void tileIsDone(const PixelRectangle& area, double eyeRays) = 0;
};
