// PNG: reads and writes pictures of 8 bits per sample, not interlaced.
// Source: Boutell et al., PNG Specification, version 1.0 (RFC 2083), 1997; RFC 1950 and 1951.
#pragma once
#include <string>

#include "image/bytes.h"
#include "image/image.h"

/// True where the bytes begin with PNG's signature.
bool isPng(const Bytes& bytes);

/// Reads 8 bits per sample of every colour type: grey, RGB, palette, grey and alpha, RGBA. Alpha
/// (and tRNS) is dropped, gamma and other ancillary chunks are skipped. CRC-32, Adler-32, chunk
/// order and lengths are checked; what follows IEND is ignored. Errors: 1, 2, 4 and 16 bits and
/// interlaced pictures ("not supported"), an unknown critical chunk, a palette index out of range,
/// more or less data than the picture needs.
/// `name` is the file, for messages. Memory is asked for only when the input is long enough to
/// hold the picture (deflate expands at most 1032 : 1), and grows as it is decoded; a picture of
/// more than 2^26 pixels of which a byte of the file holds more than 256 is refused.
/// Throws ImageError.
Image decodePng(const Bytes& bytes, const std::string& name);

/// Reads a file by decodePng. Throws ImageError.
Image readPng(const std::string& path);

/// A PNG file of 8 bits per sample, not interlaced: with a palette where there are at most 256
/// colours (and the palette costs less than it saves), else RGB. Rows are filtered so that they
/// compress well. With PngEffort::automatic the filter of each row is found by trial up to 2^19
/// pixels, which takes one thread about 2.5 microseconds a pixel; beyond that one filter is tried
/// for a megabyte at a time, and copies are searched for less far, which takes about 1.2. With
/// PngEffort::quick filters are chosen by the least sum of differences. Besides the picture, memory
/// is asked for a few megabytes of it at a time. The work is shared among `threads` >= 1 threads at
/// most; the bytes do not depend on them, nor on anything but the picture and the effort. Sides are
/// at least 1.
enum class PngEffort { automatic, quick };
Bytes encodePng(const Image& image, PngEffort effort = PngEffort::automatic, int threads = 1);

/// Writes what encodePng gives by OutputFile, piece by piece. Throws OutputError.
void writePng(const Image& image, const std::string& path, int threads = 1);
