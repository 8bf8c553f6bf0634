// PPM and PFM: pictures behind a head of plain text.
// Sources: ppm(5) of Netpbm, 2016; Debevec, PFM: Portable FloatMap Image Format, 2001.
#pragma once
#include <string>

#include "image/bytes.h"
#include "image/float_image.h"
#include "image/image.h"

/// P6: "P6\nWIDTH HEIGHT\n255\n", then RGB bytes, top row first.
Bytes encodePpm(const Image& image);
/// Writes what encodePpm gives by OutputFile, piece by piece. Throws OutputError.
void writePpm(const Image& image, const std::string& path);

/// PF: "PF\nWIDTH HEIGHT\n-1\n", then RGB floats (IEEE 754, 32 bits, little-endian: that is what
/// the -1 says), bottom row first. Nothing is clamped; infinities and NaN are written as they are.
Bytes encodePfm(const FloatImage& image);
/// Writes what encodePfm gives by OutputFile, piece by piece. Throws OutputError.
void writePfm(const FloatImage& image, const std::string& path);

/// True where the bytes begin with P and a digit 1 to 7, or PF or Pf and white space.
bool isNetpbm(const Bytes& bytes);

/// Reads P6 and P3 (colours), P5 and P2 (greys) with a maximum of 1 to 65535 (above 255 a sample
/// has two bytes, high byte first), and PF and Pf (grey floats) of either byte order.
/// - A sample s becomes s * 255 / maximum, rounded to nearest; one above the maximum is an error.
/// - A float becomes a byte as a colour of the renderer does: times 255, truncated, clamped, NaN 0.
///   The size of the scale is not used.
/// - Comments (# to the end of the line) may stand in the head, except of PF. What follows the
///   pixels is ignored.
/// `name` is the file, for messages. Memory is asked for only when the input is long enough to hold
/// the picture. Throws ImageError, also for P1, P4 (bitmaps) and P7.
Image decodeNetpbm(const Bytes& bytes, const std::string& name);
