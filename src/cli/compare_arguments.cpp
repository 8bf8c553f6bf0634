// The arguments of -compare.
#include "cli/compare_arguments.h"

#include "cli/option_values.h"

namespace {

using Given = const GivenOption&;

constexpr OptionRow::Mode kComparing = OptionRow::Mode::comparing;

void setPictures(Given given, Options& options) {
  for (const std::string& word : given.words) {
    if (word.empty()) throw UsageError("-compare: expected a file or folder, found ''");
  }
  options.compare.expected = given.words[0];
  options.compare.actual = given.words[1];
}

}  // namespace

std::vector<OptionRow> compareRows() {
  const char* group = "Comparing (a run of its own, without -input)";
  return {
      {group, "compare", nullptr, "EXPECTED ACTUAL", nullptr,
       "tell how far two pictures are apart, or all those of two folders, or those of a folder and "
       "the ones that a table of commands gives",
       setPictures, kComparing},
      {group, "tolerance", nullptr, "N", "1", "differences of up to N of 255 levels do not count",
       [](Given given, Options& o) { o.compare.tolerance = wholeNumber(given, 0, "N", 0, 255); },
       kComparing},
      {group, "fail_percent", nullptr, "P", "0", "up to P percent of the pixels may differ by more",
       [](Given given, Options& o) {
         o.compare.failPercent = numberInRange(given, 0, 0, 100, "a number from 0 to 100");
       },
       kComparing},
      {group, "diff", nullptr, "FILE", nullptr,
       "write a picture of the differences of two pictures, 16 times as large",
       [](Given given, Options& o) { o.compare.diff = outputName(given); }, kComparing},
      {group, "report", nullptr, "FILE", nullptr,
       "write an HTML page with all pictures, the worst first",
       [](Given given, Options& o) { o.compare.report = outputName(given); }, kComparing},
      {group, "csv", nullptr, "FILE", nullptr,
       "add a row for each pair of pictures to a table of comma-separated values",
       [](Given given, Options& o) { o.compare.csv = outputName(given); }, kComparing},
  };
}
