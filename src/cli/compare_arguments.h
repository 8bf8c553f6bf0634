// The arguments of -compare.
#pragma once
#include <vector>

#include "cli/option_table.h"

/// Their rows in the table of arguments.
std::vector<OptionRow> compareRows();
