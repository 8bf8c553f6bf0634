// Picture files of every kind the program knows: TGA, PNG, PPM, PFM.
#pragma once
#include <string>

#include "image/float_image.h"
#include "image/image.h"

enum class PictureFormat { tga, png, ppm, pfm };

/// By the ending of the file's name, in capitals or not; TGA where it is missing or unknown.
PictureFormat formatOf(const std::string& path);

/// Writes the picture in the format of the file's ending, by OutputFile. A PFM of it has each byte
/// over 255. A PNG is compressed by `threads` >= 1 threads at most. Throws OutputError.
void writePicture(const Image& image, const std::string& path, int threads = 1);

/// Reads a picture, whatever the file is called: PNG, PPM or PFM where the content begins as these
/// do, else TGA. Throws ImageError.
Image readImage(const std::string& path);
