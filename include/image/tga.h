// TGA: writes the one variant that the program puts out, reads all common ones.
// Source: Truevision TGA File Format Specification, version 2.0, 1991.
#pragma once
#include <string>

#include "image/bytes.h"
#include "image/image.h"

/// The file: 18 header bytes, all 0 but type 2, width and height (little-endian), 24 bits and
/// descriptor 0x20, then BGR bytes, top row first; no ID, no footer. Sides are 1..65535 pixels.
Bytes encodeTga(const Image& image);

/// Writes encodeTga(image) by OutputFile. Throws OutputError.
void writeTga(const Image& image, const std::string& path);
