// What a comparison tells in text: lines to be read, and rows of a table. The lines of one pair and
// the page of the report show the same list of figures, which figuresOf makes; a row of the table
// has the bare numbers, each in a column of its own, so that a spreadsheet can work with them.
#include <cmath>
#include <cstdio>
#include <filesystem>

#include "cli/compared_pair.h"
#include "image/output_file.h"
#include "scene/source_text.h"
#include "system/files.h"

namespace {

namespace fs = std::filesystem;
using Result = ComparedPair::Result;

/// A table is known as ours by this line, which never changes: scripts name its columns.
constexpr const char* kCsvHeading =
    "name,expected,actual,result,expected_width,expected_height,actual_width,actual_height,"
    "maximum,mean,rms,psnr,pixels_over,percent_over,worst_x,worst_y,box_x,box_y,box_width,"
    "box_height\r\n";

/// How many pixels differ by more than the tolerance.
std::string overText(const Comparison& f) {
  return std::to_string(f.pixelsOver) + " of " + std::to_string(f.pixels) + " pixels (" +
         numberText(f.percentOver()) + " %)";
}

/// In decibels; equal pictures have no noise at all.
std::string psnrText(const Comparison& f) {
  return std::isinf(f.psnr) ? "inf" : numberText(f.psnr) + " dB";
}

/// A pair's verdict in a few words.
std::string verdict(const ComparedPair& pair) {
  if (pair.isAtFault() || !pair.comparison) return pair.fault;
  const Comparison& f = *pair.comparison;
  if (f.maximum == 0) return "equal";
  return "maximum " + std::to_string(f.maximum) + ", mean " + numberText(f.mean) + ", PSNR " +
         psnrText(f) + ", over the tolerance " + overText(f);
}

std::string pairText(const char* between, int a, int b) {
  return std::to_string(a) + between + std::to_string(b);
}

/// A field in double quotes where it holds a comma, a quote or the end of a line; quotes within are
/// doubled. RFC 4180, section 2.
std::string quotedField(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

/// A width or height, which is 0 where there is no picture.
std::string sizeField(int size) { return size == 0 ? "" : std::to_string(size); }

/// 20 fields, those of figures empty where there are none.
std::string csvRow(const ComparedPair& pair) {
  std::string row = quotedField(pair.name) + "," + quotedField(pair.expected) + "," +
                    quotedField(pair.actual) + "," + nameOf(pair.result);
  for (const int size :
       {pair.expectedWidth, pair.expectedHeight, pair.actualWidth, pair.actualHeight}) {
    row += "," + sizeField(size);
  }
  if (!pair.comparison) return row + std::string(12, ',') + "\r\n";
  const Comparison& f = *pair.comparison;
  row += "," + std::to_string(f.maximum) + "," + numberText(f.mean) + "," + numberText(f.rms) +
         "," + numberText(f.psnr) + "," + std::to_string(f.pixelsOver) + "," +
         numberText(f.percentOver());
  for (const int number : {f.worstX, f.worstY, f.boxX, f.boxY, f.boxWidth, f.boxHeight}) {
    row += "," + std::to_string(number);
  }
  return row + "\r\n";
}

/// What is in the table; "" where there is none.
std::string readTable(const std::string& path) {
  std::error_code ignored;
  std::string text, reason;
  if (fs::is_regular_file(path, ignored) && !readWholeFile(path, text, reason)) {
    throw OutputError(path, "what it holds cannot be read: " + reason);
  }
  return text;
}

/// The folder that holds the file, links followed.
std::string folderOf(const std::string& path) {
  std::error_code ignored;
  return fs::weakly_canonical(fs::absolute(path, ignored), ignored).parent_path().string();
}

}  // namespace

std::string numberText(double value) {
  if (std::isinf(value)) return "inf";
  char text[40];
  std::snprintf(text, sizeof text, "%.6g", value);
  return text;
}

/// A pair at fault has no sizes, and one of two sizes no figures that compare pixels.
std::vector<Figure> figuresOf(const ComparedPair& pair, const CompareRequest& request) {
  std::vector<Figure> figures = {{"expected", pair.expected}, {"actual", pair.actual}};
  const auto add = [&](const char* name, const std::string& value) {
    figures.push_back({name, value});
  };
  const std::string actualSize = pairText(" x ", pair.actualWidth, pair.actualHeight);
  if (pair.comparison) {
    const Comparison& f = *pair.comparison;
    const std::string box =
        pairText(" ", f.boxX, f.boxY) + " " + pairText(" ", f.boxWidth, f.boxHeight);
    add("size", actualSize);
    add("maximum", std::to_string(f.maximum));
    add("mean", numberText(f.mean));
    add("rms", numberText(f.rms));
    add("psnr", psnrText(f));
    add("tolerance", std::to_string(request.tolerance));
    add("over tolerance", overText(f));
    add("worst pixel", f.maximum == 0 ? "none" : pairText(" ", f.worstX, f.worstY));
    add("box", f.pixelsOver == 0 ? "none" : box);
  } else if (!pair.isAtFault()) {
    add("expected size", pairText(" x ", pair.expectedWidth, pair.expectedHeight));
    add("actual size", actualSize);
  }
  add("result", nameOf(pair.result));
  return figures;
}

std::string figureLines(const ComparedPair& pair, const CompareRequest& request) {
  std::string text;
  for (const Figure& figure : figuresOf(pair, request)) {
    text += figure.name + ": " + figure.value + "\n";
  }
  return text;
}

std::string pairLines(const std::vector<ComparedPair>& pairs) {
  std::string text;
  std::size_t same = 0, different = 0;
  for (const ComparedPair& pair : pairs) {
    text += std::string(nameOf(pair.result)) + ": " + pair.name + ": " + verdict(pair) + "\n";
    same += pair.result == Result::same;
    different += pair.result == Result::different;
  }
  const std::size_t others = pairs.size() - same - different;
  return text + std::to_string(pairs.size()) + " pairs: " + std::to_string(same) + " same, " +
         std::to_string(different) + " different, " + std::to_string(others) +
         " missing, unexpected or unreadable\n";
}

/// The table is read, added to and replaced as a whole. Two runs at once would each lose the
/// other's rows: each locks the folder meanwhile, for a lock on the file would go with the old one.
void addToCsv(const std::vector<ComparedPair>& pairs, const std::string& path) {
  const OpenFile folder(folderOf(path));
  folder.lock(true);
  std::string text = readTable(path);
  if (text.empty()) text = kCsvHeading;
  if (text.rfind(kCsvHeading, 0) != 0) {
    throw OutputError(path, "it does not begin with the heading of such a table");
  }
  if (text.back() != '\n') text += "\r\n";
  for (const ComparedPair& pair : pairs) text += csvRow(pair);
  writeFile(path, text.data(), text.size());
}
