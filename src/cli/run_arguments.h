// The arguments about the run itself: its speed, what it tells of the scene and of the program.
#pragma once
#include <vector>

#include "cli/option_table.h"

std::vector<OptionRow> speedRows();
std::vector<OptionRow> insideRows();
std::vector<OptionRow> informationRows();
