// TileListener: who wants to know how far a picture is; nobody by default.
#pragma once

struct PixelRectangle;

class TileListener {
 public:
  virtual ~TileListener() = default;

  /// Before the first tile; `eyeRays` is how many rays all tiles begin with.
  virtual void begins(double eyeRays) = 0;
  /// The pixels of `area` have their final values. Called by the thread that has set them, by
  /// several at once.
  virtual void tileIsDone(const PixelRectangle& area, double eyeRays) = 0;
};
