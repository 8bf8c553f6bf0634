// PartFile: a part of a picture, as -region and -tile write it.
#pragma once
#include <string>

#include "cli/part_id.h"
#include "image/bytes.h"

struct PartFile {
  std::string path;
  PartId id;
  int x = 0, y = 0, width = 0, height = 0;  ///< in the whole picture, from its top left corner

  /// Reads all but the pixels, and checks that these are all there. Throws InputError where the
  /// file cannot be read, is no part, or is cut off.
  static PartFile read(const std::string& path);

  /// Copies row `row` of the part (0 is its top one) to `target`: 3 * width bytes, BGR. The file is
  /// open at `descriptor`. Throws InputError where it cannot be read.
  void readRow(int descriptor, int row, std::uint8_t* target) const;
};
