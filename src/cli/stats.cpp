// Stats: the lines that -stats prints.
#include "cli/stats.h"

#include <cstdio>

namespace {

std::string line(const char* name, const std::string& value) {
  return std::string(name) + ": " + value + "\n";
}

std::string seconds(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6f", value);
  return text;
}

}  // namespace

std::string Stats::text() const {
  return line("instruction set", simd) + line("tree", tree) +
         line("threads", std::to_string(threads)) + line("seconds reading", seconds(readSeconds)) +
         line("seconds building", seconds(buildSeconds)) +
         line("seconds tracing", seconds(traceSeconds)) +
         line("seconds writing", seconds(writeSeconds));
}
