// Which pictures of two folders belong together.
#pragma once
#include <string>
#include <vector>

/// A file of each folder; empty where there is none.
struct PicturePair {
  std::string name;  ///< path below the folder, of the expected picture where there is one
  std::string expected, actual;
};

/// All files below `folder`, however deep, whose endings are those of pictures (tga, png, ppm, pgm,
/// pfm, in capitals or not), as paths relative to it, sorted. Links to folders are not followed.
/// Throws ImageError where a folder cannot be read.
std::vector<std::string> picturesIn(const std::string& folder);

/// Each expected picture with the actual one at the same path, else with the first one whose path
/// is the same but for the ending (out.tga and out.png). Then the actual pictures without partner.
/// Sorted by name.
std::vector<PicturePair> pairsIn(const std::string& expectedFolder,
                                 const std::string& actualFolder);

/// The picture in `pictures` (sorted paths) that belongs to `name`, as above; "" where none does.
std::string partnerOf(const std::string& name, const std::vector<std::string>& pictures);
