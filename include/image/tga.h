// TGA: writes the one variant that the program puts out, reads all common ones.
// Source: Truevision TGA File Format Specification, version 2.0, 1991.
#pragma once
#include <functional>
#include <string>

#include "image/bytes.h"
#include "image/image.h"

/// Where a picture that is part of another lies in that one, and a text of at most 255 bytes. (The
/// specification counts origins from the lower left of a screen; like POV-Ray's parts, ours begin
/// at the corner that comes first in the file.)
struct TgaPlace {
  int x = 0, y = 0;  ///< of the first pixel, from the top left corner of the whole, 0..65535
  std::string id;
};

/// The file: 18 header bytes, all 0 but type 2, width and height (little-endian), 24 bits and
/// descriptor 0x20, then BGR bytes, top row first; no ID, no footer. Sides are 1..65535 pixels.
/// A part has its place in the origin fields besides, and its ID.
Bytes encodeTga(const Image& image, const TgaPlace& place = {});

/// Writes what encodeTga gives by OutputFile, piece by piece. Throws OutputError.
void writeTga(const Image& image, const std::string& path, const TgaPlace& place = {});

/// Writes the same from rows of BGR bytes: row(y) is asked once for each y, from the top one, 0,
/// on. Nothing but the row at hand is kept. Throws OutputError and what row(y) throws.
void writeTgaRows(int width, int height, const std::function<const Bytes&(int y)>& row,
                  const std::string& path);

/// Reads types 1, 2, 3, 9, 10 and 11 (colour map, true colour, grey; the latter three run-length
/// encoded), the first pixel in any corner.
/// - Colours have 15, 16, 24 or 32 bits, directly or in the colour map; indices 8 or 16; grey 8,
///   or 16 of which 8 are alpha. Alpha is ignored.
/// - A component v of 5 bits becomes v * 255 / 31, rounded to nearest.
/// - A colour map begins at its first-entry number; an index outside it is an error.
/// - The image ID, and what follows the pixels (a footer), are skipped. A packet may go on in the
///   next row, but not beyond the last one.
/// `name` is the file, for messages. Memory is asked for only when the input is long enough to
/// hold so many pixels (a packet of 2 to 5 bytes has at most 128). Throws ImageError.
Image decodeTga(const Bytes& bytes, const std::string& name);

/// Reads a file by decodeTga. Throws ImageError.
Image readTga(const std::string& path);
