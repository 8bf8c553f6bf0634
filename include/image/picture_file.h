// Picture files: TGA, PNG, BMP, PPM and PFM, any of them, and each one by itself.
// A writer hands its file to a sink piece by piece, so that a picture stands in memory once. A
// reader takes the whole file. It asks for the memory of a picture only when the file is long
// enough to hold that picture, and is told the file's name for messages.
#pragma once
#include <functional>
#include <optional>
#include <string>

#include "image/bytes.h"
#include "image/image.h"

enum class PictureFormat { tga, png, bmp, ppm, pfm };

/// The endings of names by which formats are chosen, without dot, in the order of PictureFormat.
inline constexpr const char* kPictureEndings[] = {"tga", "png", "bmp", "ppm", "pfm"};

/// By the ending of the file's name, in capitals or not; `unnamed` where there is none.
/// std::nullopt where the ending is none of kPictureEndings.
std::optional<PictureFormat> formatOf(const std::string& path,
                                      PictureFormat unnamed = PictureFormat::tga);

/// What a picture that is part of another says of that: where it lies in it, and a text of at most
/// 255 bytes. (TGA's specification counts origins from the lower left of a screen; like POV-Ray's
/// parts, ours begin at the corner that comes first in the file.)
struct TgaPart {
  int x = 0, y = 0;  ///< of the first pixel, from the top left corner of the whole, 0..65535
  std::string id;
};

/// Throws OutputError for a TGA of a side of more than 65535 pixels, and for a BMP of more than
/// 2^30 pixels: writePicture could not write it.
void checkPictureSize(const std::string& path, PictureFormat format, int width, int height);
/// Writes the picture by OutputFile in formatOf(path, unnamed), where the ending is unknown as a
/// TGA. A PFM of it has each byte over 255; `part` is for a TGA only. A PNG is compressed by
/// `threads` >= 1 threads at most. Throws OutputError, also where checkPictureSize does.
void writePicture(const Image& image, const std::string& path, int threads = 1,
                  const TgaPart& part = {}, PictureFormat unnamed = PictureFormat::tga);
/// Writes a PFM, whatever the ending. Throws OutputError.
void writePicture(const FloatImage& image, const std::string& path);
/// Writes a TGA from rows of BGR bytes: row(y) is asked once for each y, from the top one, 0, on.
/// Nothing but the row at hand is kept. Throws OutputError and what row(y) throws.
void writeTgaRows(int width, int height, const std::function<Bytes(int y)>& row,
                  const std::string& path);

/// The file that writePicture would write by one thread. A TGA's sides are at most 65535 pixels.
Bytes encodePicture(const Image& image, PictureFormat format);

/// Reads a picture, whatever the file is called: PNG, BMP, PPM or PFM where the content begins as
/// these do, else TGA. Where `exact` is not null and the file has more than 8 bits a sample (PFM,
/// PNG and PPM of 16), it becomes the picture in floats, else a picture without pixels. Throws
/// ImageError, which names formats that are known but not read (JPEG, GIF, TIFF, WebP).
Image readImage(const std::string& path, FloatImage* exact = nullptr);

/// Takes a file piece by piece, in its order.
using Sink = std::function<void(const Bytes& piece)>;

// TGA. Source: Truevision TGA File Format Specification, version 2.0, 1991.

/// What stands before the pixels, which are BGR bytes, top row first, with nothing behind them: 18
/// bytes, all 0 but type 2, width and height (little-endian), 24 bits and descriptor 0x20. Sides
/// are 1..65535 pixels. A part has its origin in the fields for that, and its ID.
Bytes tgaHead(int width, int height, const TgaPart& part);

/// Reads types 1, 2, 3, 9, 10 and 11 (colour map, true colour, grey; the latter three run-length
/// encoded), the first pixel in any corner.
/// - Colours have 15, 16, 24 or 32 bits, directly or in the colour map; indices 8 or 16; grey 8,
///   or 16 of which 8 are alpha. Alpha is ignored.
/// - A component v of 5 bits becomes v * 255 / 31, rounded to nearest.
/// - A colour map begins at its first-entry number; an index outside it is an error.
/// - The image ID, and what follows the pixels (a footer), are skipped. A packet may go on in the
///   next row, but not beyond the last one.
/// Throws ImageError.
Image decodeTga(const Bytes& bytes, const std::string& name);

// PNG. Source: Boutell et al., PNG Specification, version 1.0 (RFC 2083), 1997.

/// 8 bits per sample, not interlaced: with a palette where there are at most 256 colours (and the
/// palette costs less than it saves), else RGB. Besides the picture, memory is asked for some 10 MB
/// of it at a time. The work is shared among `threads` >= 1 threads at most; the bytes depend on
/// nothing but the picture.
void encodePng(const Image& image, const Sink& sink, int threads);

/// True where the bytes begin with PNG's signature.
bool isPng(const Bytes& bytes);

/// Reads every colour type, depth and interlacing: grey and palettes of 1, 2, 4 and 8 bits, grey,
/// RGB and both with alpha of 8 and 16, interlaced by Adam7 or not. A sample of other than 8 bits
/// becomes the nearest byte; where `exact` is not null and samples have 16 bits, it becomes the
/// picture in floats from 0 to 1. Alpha (and tRNS) is dropped, gamma and other ancillary chunks are
/// skipped. CRC-32, Adler-32, chunk order and lengths are checked; what follows IEND is ignored.
/// Errors: an unknown critical chunk, a palette index out of range, more or less data than the
/// picture needs; and a picture that takes more than 128 MB of memory and more than 256 times what
/// it is compressed to, for deflate may expand 1032 : 1. Throws ImageError.
Image decodePng(const Bytes& bytes, const std::string& name, FloatImage* exact = nullptr);

// BMP. Source: Microsoft, "Bitmap Storage" (BITMAPINFOHEADER), 2021.

/// What stands before the pixels, which are BGR bytes, not compressed, the bottom row first, each
/// row filled up to a multiple of four; of at most 4 GB.
Bytes bmpHead(int width, int height);

/// True where the bytes begin with BM and the length of a head that is known.
bool isBmp(const Bytes& bytes);

/// Reads 24 and 32 bits a pixel, and 8 with a palette; not compressed (32 bits with the usual
/// masks too); the bottom or, where the height is below 0, the top row first. The fourth byte of 32
/// bits is dropped. Throws ImageError.
Image decodeBmp(const Bytes& bytes, const std::string& name);

// PPM and PFM: pictures behind a head of plain text.
// Sources: ppm(5) of Netpbm, 2016; Debevec, PFM: Portable FloatMap Image Format, 2001.

/// P6: "P6\nWIDTH HEIGHT\n255\n", before RGB bytes, top row first.
Bytes ppmHead(int width, int height);

/// PF: "PF\nWIDTH HEIGHT\n-1\n", then RGB floats (IEEE 754, 32 bits, little-endian: that is what
/// the -1 says), bottom row first. Nothing is clamped; infinities and NaN are written as they are.
void encodePfm(int width, int height, const std::function<Vec3f(int x, int y)>& colorOf,
               const Sink& sink);

/// True where the bytes begin with P and a digit 1 to 7, or PF or Pf and white space.
bool isNetpbm(const Bytes& bytes);

/// Reads P6 and P3 (colours), P5 and P2 (greys) with a maximum of 1 to 65535 (above 255 a sample
/// has two bytes, high byte first), and PF and Pf (grey floats) of either byte order.
/// - A sample s becomes s * 255 / maximum, rounded to nearest; one above the maximum is an error.
/// - A float becomes a byte as a colour of the renderer does: times 255, truncated, clamped, NaN 0.
///   The size of the scale is not used.
/// - Comments (# to the end of the line) may stand in the head, except of PF. What follows the
///   pixels is ignored.
/// Where `exact` is not null and samples have more than 8 bits, it becomes the picture in floats, 1
/// for a maximum. Throws ImageError, also for P1, P4 (bitmaps) and P7.
Image decodeNetpbm(const Bytes& bytes, const std::string& name, FloatImage* exact = nullptr);
