// The formulas of wide_formulas.h for avx512: compiled with flags of its own where the processor
// may have it; elsewhere never asked.
#include "wide_formulas.h"

wide::Lanes wide::avx512Lanes() { return ofThisUnit(); }
