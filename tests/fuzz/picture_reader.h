// What the fuzz targets of picture files demand: a picture that was read is one that can be
// written, and reading that gives the same picture again; an error is one line that prints.
#pragma once
#include "fuzz.h"
#include "image/comparison.h"
#include "image/picture_file.h"

namespace fuzz {

/// `decode(bytes)` reads a picture of the format, or of one that it can be written as.
template <class Decode>
void readAndReadAgain(const Bytes& input, PictureFormat format, const Decode& decode) {
  try {
    const ReadPicture picture{decode(input)};
    demand(picture.image.Width() >= 1 && picture.image.Height() >= 1, "a picture has pixels");
    const ReadPicture again{decode(encodePicture(picture.image, format))};
    demand(compare(picture, again, 0).maximum == 0,
           "writing and reading again gives the same picture");
  } catch (const ImageError& error) {
    demand(isPlainLine(error.what()), "an error is one line that prints");
  }
}

}  // namespace fuzz
