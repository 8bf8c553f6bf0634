// The tiles of a run's pictures, by number, and their pixels as bytes, for keeping.
//
// A tile is a square of TileStore::kSide pixels, or what of it lies in the pictures; tiles are
// numbered row by row from the lower left corner on. A set of pictures is a number whose bits name
// them: bit 0 stands for the colour, 1 depth, 2 normals, 3 samples, 4 to 6 for the exact floats of
// the first three, 7 for materials.
#pragma once
#include <cstdint>
#include <vector>

#include "image/bytes.h"
#include "render/image_plane.h"
#include "render/renderer.h"

/// Which pictures `targets` has.
std::uint32_t pictureBits(const RenderTargets& targets);

/// How many tiles the pictures of `targets` have, of which there is at least one.
std::size_t tileCount(const RenderTargets& targets);

/// The pixels of tile `number`, which is below tileCount.
PixelRectangle tileArea(const RenderTargets& targets, std::uint32_t number);

/// The numbers of the tiles that make up `area`, which is one of those a TileStore is told of.
std::vector<std::uint32_t> tilesIn(const RenderTargets& targets, const PixelRectangle& area);

/// How many bytes the pixels of `area` have in those pictures together.
std::size_t tileByteCount(const RenderTargets& targets, std::uint32_t pictures,
                          const PixelRectangle& area);

/// The pixels of `area` as they lie in memory: picture after picture in the order of the bits, rows
/// from the bottom up; 3 bytes for each pixel, and for each one of an enlarged picture; 3 floats
/// for one of exact colours. `targets` has all those pictures.
Bytes tileBytes(const RenderTargets& targets, std::uint32_t pictures, const PixelRectangle& area);

/// Sets the pixels of `area` to the tileByteCount bytes that tileBytes gave.
void setTileBytes(const RenderTargets& targets, std::uint32_t pictures, const PixelRectangle& area,
                  const std::uint8_t* bytes);
