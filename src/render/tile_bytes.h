// The pixels of a tile as bytes, for keeping.
#pragma once
#include "image/bytes.h"
#include "render/image_plane.h"
#include "render/renderer.h"

/// Which pictures `targets` has: bit 0 is set for the colour, 1 depth, 2 normals, 3 samples, and 4
/// to 6 for the exact floats of the first three, 7 materials.
std::uint32_t pictureBits(const RenderTargets& targets);
inline constexpr int kPictureKinds = 8;

/// `targets` with those pictures alone that `bits` names; bits of pictures that it does not have
/// change nothing.
RenderTargets withPictures(const RenderTargets& targets, std::uint32_t bits);

/// The pixels that the pictures have, enlarged ones counted as if they were not. There is at least
/// one picture that is no float image.
PixelRectangle wholeArea(const RenderTargets& targets);

/// How many bytes the pixels of `area` have in all pictures together.
std::size_t tileByteCount(const RenderTargets& targets, const PixelRectangle& area);

/// The pixels of `area`: picture after picture in the order of the bits, rows from the bottom up; 3
/// bytes for each pixel, and for each one of an enlarged picture; 3 floats (appendNumber of their
/// bits) for one of exact colours.
Bytes tileBytes(const RenderTargets& targets, const PixelRectangle& area);

/// Sets the pixels of `area` to the tileByteCount bytes that tileBytes gave.
void setTileBytes(const RenderTargets& targets, const PixelRectangle& area,
                  const std::uint8_t* bytes);

/// Appends a number as 4 bytes, the lowest first, and reads it back.
void appendNumber(std::uint32_t number, Bytes& bytes);
std::uint32_t numberAt(const std::uint8_t* bytes);
