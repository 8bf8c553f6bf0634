// The pixels of a tile as bytes, for keeping.
#pragma once
#include "image/bytes.h"
#include "render/image_plane.h"
#include "render/renderer.h"

/// Which pictures `targets` has: bit 0 is set for the colour, 1 depth, 2 normals, 3 samples, and 4
/// to 6 for the exact floats of the first three.
unsigned pictureBits(const RenderTargets& targets);
inline constexpr int kPictureKinds = 7;

/// `targets` with those pictures alone that `bits` names; bits of pictures that it does not have
/// change nothing.
RenderTargets withPictures(const RenderTargets& targets, unsigned bits);

/// How many bytes the pixels of `area` have in all pictures together.
std::size_t tileByteCount(const RenderTargets& targets, const PixelRectangle& area);

/// Appends the pixels of `area`: picture after picture in the order of the bits, rows from the
/// bottom up; 3 bytes for each pixel, and for each one of an enlarged picture; 3 floats of 4 bytes
/// for one of exact colours, the lowest byte first.
void appendTileBytes(const RenderTargets& targets, const PixelRectangle& area, Bytes& bytes);

/// Sets the pixels of `area` to the tileByteCount bytes that appendTileBytes gave.
void setTileBytes(const RenderTargets& targets, const PixelRectangle& area,
                  const std::uint8_t* bytes);
