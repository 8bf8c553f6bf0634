// The arguments of every ordinary picture: what is read and written, how rays are traced and
// shaded.
#pragma once
#include <vector>

#include "cli/option_table.h"

std::vector<OptionRow> readingRows();
std::vector<OptionRow> pictureRows();
std::vector<OptionRow> tracingRows();
std::vector<OptionRow> shadingRows();
