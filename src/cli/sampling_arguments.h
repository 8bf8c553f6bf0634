// The arguments about samples and filters.
#pragma once
#include <string>
#include <vector>

#include "cli/option_table.h"

/// Their rows in the table of arguments.
std::vector<OptionRow> samplingRows();

/// Throws UsageError where an enlarged picture that is wanted would have too long a side.
void checkEnlargedSizes(const Options& options);

/// Which numbers of samples are rounded up, and to what; "" where none is.
std::string roundingWarning(const Options& options);
