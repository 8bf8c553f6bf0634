// The pixels of a run's pictures as bytes, for keeping.
#pragma once
#include <cstdint>

#include "image/bytes.h"
#include "render/renderer.h"

/// Which pictures `targets` has, a bit for each.
std::uint32_t pictureBits(const RenderTargets& targets);

/// How many bytes the pixels of `area` have in all pictures together.
std::size_t tileByteCount(const RenderTargets& targets, const PixelRectangle& area);

/// The pixels of `area` as they lie in memory: picture after picture in the order of the bits, rows
/// from the bottom up; 3 bytes for each pixel, and for each one of an enlarged picture; 3 floats
/// for one of exact colours.
Bytes tileBytes(const RenderTargets& targets, const PixelRectangle& area);

/// Sets the pixels of `area` to the tileByteCount bytes that tileBytes gave.
void setTileBytes(const RenderTargets& targets, const PixelRectangle& area,
                  const std::uint8_t* bytes);
