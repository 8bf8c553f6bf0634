// TGA: writes the one variant that the program puts out, reads all common ones.
// Source: Truevision TGA File Format Specification, version 2.0, 1991.
#pragma once
#include <string>

#include "image/bytes.h"
#include "image/image.h"

/// The file: 18 header bytes, all 0 but type 2, width and height (little-endian), 24 bits and
/// descriptor 0x20, then BGR bytes, top row first; no ID, no footer. Sides are 1..65535 pixels.
Bytes encodeTga(const Image& image);

/// Writes what encodeTga gives by OutputFile, piece by piece. Throws OutputError.
void writeTga(const Image& image, const std::string& path);

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
