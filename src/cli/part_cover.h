// Whether parts make up a whole picture.
#pragma once
#include <string>
#include <vector>

#include "cli/part_file.h"

/// What is wrong with the parts of a picture of width x height pixels: which files overlap and
/// where, which pixels no part holds and the argument that would render them. Empty where each
/// pixel is in one part. `parts` are in the order of their y, those of the same y of their x, and
/// lie in the picture. Rows and pixels are counted from 0 at the top and left.
std::vector<std::string> coverMistakes(const std::vector<PartFile>& parts, int width, int height);
