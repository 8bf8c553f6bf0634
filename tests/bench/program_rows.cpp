#include "rows.h"
#include "child.h"
namespace bench {
void runProgramRows(const BenchOptions&) {}
void measurePhases(const std::string&, const std::string&, int, SimdLevel) {}
}
