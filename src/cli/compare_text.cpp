// What a comparison tells in text: lines to be read, and rows of a table. The lines of one pair and
// the page of the report show the same list of figures, which figuresOf makes; a row of the table
// has the bare numbers, each in a column of its own, so that a spreadsheet can work with them.
#include <cmath>
#include <filesystem>

#include "cli/compare.h"
#include "image/output_file.h"
#include "scene/source_text.h"
#include "scene/wording.h"
#include "system/files.h"

namespace {

namespace fs = std::filesystem;
using Result = ComparedPair::Result;

/// A table is known as ours by this line, which never changes: scripts name its columns.
constexpr const char* kCsvHeading =
    "name,expected,actual,result,expected_width,expected_height,actual_width,actual_height,"
    "maximum,mean,rms,psnr,pixels_over,percent_over,worst_x,worst_y,box_x,box_y,box_width,"
    "box_height,given\r\n";

/// How many pixels differ by more than the tolerance.
std::string overText(const Comparison& f) {
  return joined(f.pixelsOver, " of ", f.pixels, " pixels (", f.percentOver(), " %)");
}

/// In decibels; equal pictures have no noise at all.
std::string psnrText(const Comparison& f) {
  return std::isinf(f.psnr) ? "inf" : joined(f.psnr, " dB");
}

/// A pair's verdict in a few words.
std::string verdict(const ComparedPair& pair) {
  if (pair.isAtFault() || !pair.comparison) return pair.fault;
  const Comparison& f = *pair.comparison;
  if (f.maximum == 0) return "equal";
  return joined("maximum ", f.maximum, ", mean ", f.mean, ", PSNR ", psnrText(f),
                ", over the tolerance ", overText(f));
}

/// A field in double quotes where it holds a comma, a quote or the end of a line; quotes within are
/// doubled. RFC 4180, section 2.
std::string quotedField(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted.append(c == '"' ? 2 : 1, c);
  return quoted + "\"";
}

/// Both fields of a size, empty where there is no picture.
std::string sizeFields(ComparedPair::Size size) {
  return size.width == 0 ? "," : joined(size.width, ',', size.height);
}

/// The 12 fields of figures, empty where there are none.
std::string figureFields(const ComparedPair& pair) {
  if (!pair.comparison) return std::string(11, ',');
  const Comparison& f = *pair.comparison;
  return joined(f.maximum, ',', f.mean, ',', f.rms, ',', f.psnr, ',', f.pixelsOver, ',',
                f.percentOver(), ',', f.worstX, ',', f.worstY, ',', f.boxX, ',', f.boxY, ',',
                f.boxWidth, ',', f.boxHeight);
}

/// 21 fields, in the order of kCsvHeading.
std::string csvRow(const ComparedPair& pair, const std::string& given) {
  return joined(quotedField(pair.name), ',', quotedField(pair.expected), ',',
                quotedField(pair.actual), ',', nameOf(pair.result), ',',
                sizeFields(pair.expectedSize), ',', sizeFields(pair.actualSize), ',',
                figureFields(pair), ',', quotedField(given), "\r\n");
}

}  // namespace

const char* nameOf(Result result) {
  static constexpr const char* kNames[] = {"same", "different", "missing", "unexpected",
                                           "unreadable"};
  return kNames[int(result)];
}

/// A pair at fault has no sizes, and one of two sizes no figures that compare pixels.
std::vector<Figure> figuresOf(const ComparedPair& pair, const CompareRequest& request) {
  std::vector<Figure> figures = {{"expected", pair.expected}, {"actual", pair.actual}};
  if (pair.comparison) {
    const Comparison& f = *pair.comparison;
    const std::string worst = joined(f.worstX, ' ', f.worstY);
    const std::string box = joined(f.boxX, ' ', f.boxY, ' ', f.boxWidth, ' ', f.boxHeight);
    figures.insert(figures.end(), {{"size", pair.actualSize.text()},
                                   {"maximum", joined(f.maximum)},
                                   {"mean", joined(f.mean)},
                                   {"rms", joined(f.rms)},
                                   {"psnr", psnrText(f)},
                                   {"tolerance", joined(request.tolerance)},
                                   {"over tolerance", overText(f)},
                                   {"worst pixel", f.maximum == 0 ? "none" : worst},
                                   {"box", f.pixelsOver == 0 ? "none" : box}});
  } else if (!pair.isAtFault()) {
    figures.push_back({"expected size", pair.expectedSize.text()});
    figures.push_back({"actual size", pair.actualSize.text()});
  }
  figures.push_back({"result", nameOf(pair.result)});
  return figures;
}

std::string figureLines(const ComparedPair& pair, const CompareRequest& request) {
  std::string text;
  for (const Figure& figure : figuresOf(pair, request)) {
    text += figure.name + ": " + figure.value + "\n";
  }
  return text;
}

/// What is neither the same nor different is counted in one: its own line says which it is.
std::string pairLines(const std::vector<ComparedPair>& pairs) {
  std::string text;
  std::size_t same = 0, different = 0;
  for (const ComparedPair& pair : pairs) {
    text += joined(nameOf(pair.result), ": ", pair.name, ": ", verdict(pair), "\n");
    same += pair.result == Result::same;
    different += pair.result == Result::different;
  }
  return text + joined(counted(pairs.size(), "pair"), ": ", same, " same, ", different,
                       " different, ", pairs.size() - same - different,
                       " missing, unexpected or unreadable\n");
}

/// The table is read, added to and replaced as a whole. Two runs at once would each lose the
/// other's rows: each locks the folder meanwhile, for a lock on the file would go with the old one.
void addToCsv(const std::vector<ComparedPair>& pairs, const CompareRequest& request) {
  const std::string& path = request.csv;
  const OpenFile folder(fs::path(outputTarget(path)).parent_path().string());
  folder.lock(true);
  std::error_code ignored;
  std::string text, reason;
  if (fs::is_regular_file(path, ignored) && !readWholeFile(path, text, reason)) {
    throw OutputError(path, "what it holds cannot be read: " + reason);
  }
  if (text.empty()) text = kCsvHeading;
  if (text.rfind(kCsvHeading, 0) != 0) {
    throw OutputError(path, "it does not begin with the heading of such a table");
  }
  if (text.back() != '\n') text += "\r\n";
  for (const ComparedPair& pair : pairs) text += csvRow(pair, request.actual);
  writeFile(path, text.data(), text.size());
}
