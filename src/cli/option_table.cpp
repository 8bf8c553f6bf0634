// The table of all arguments.
#include "cli/option_table.h"

#include "cli/compare_arguments.h"
#include "cli/part_arguments.h"
#include "cli/render_arguments.h"
#include "cli/run_arguments.h"
#include "cli/sampling_arguments.h"

namespace {

/// The groups in the order of -help: from what every run needs to what few ask for.
std::vector<OptionRow> makeTable() {
  std::vector<OptionRow> table;
  for (const auto& rows :
       {readingRows(), pictureRows(), tracingRows(), samplingRows(), shadingRows(), partRows(),
        speedRows(), compareRows(), insideRows(), informationRows()}) {
    table.insert(table.end(), rows.begin(), rows.end());
  }
  return table;
}

}  // namespace

const std::vector<OptionRow>& optionTable() {
  static const std::vector<OptionRow> table = makeTable();
  return table;
}

const OptionRow* findOption(const std::string& name) {
  for (const OptionRow& row : optionTable())
    if (name == row.name || (row.otherName && name == row.otherName)) return &row;
  return nullptr;
}

int countWords(const OptionRow& row) {
  if (!*row.words) return 0;
  int count = 1;
  for (const char* c = row.words; *c; ++c) count += *c == ' ';
  return count;
}

bool takesMore(const OptionRow& row) {
  const std::string words = row.words;
  return words.size() >= 3 && words.compare(words.size() - 3, 3, "...") == 0;
}
