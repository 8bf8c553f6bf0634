// Text and comma-separated values of a comparison.
#include "cli/compare_output.h"

#include <cmath>
#include <cstdio>

namespace {

using Result = ComparedPair::Result;

std::string line(const char* name, const std::string& value) {
  return std::string(name) + ": " + value + "\n";
}

std::string place(int x, int y) { return std::to_string(x) + " " + std::to_string(y); }

std::string overText(const Comparison& figures) {
  return std::to_string(figures.pixelsOver) + " of " + std::to_string(figures.pixels) +
         " pixels (" + numberText(figures.percentOver()) + " %)";
}

std::string psnrText(const Comparison& figures) {
  return std::isinf(figures.psnr) ? "inf" : numberText(figures.psnr) + " dB";
}

/// In double quotes where a field needs them, RFC 4180.
std::string field(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

std::string figureFields(const Comparison& f) {
  std::string text;
  for (const std::string& value :
       {std::to_string(f.maximum), numberText(f.mean), numberText(f.rms), numberText(f.psnr),
        std::to_string(f.pixelsOver), numberText(f.percentOver()), std::to_string(f.worstX),
        std::to_string(f.worstY), std::to_string(f.boxX), std::to_string(f.boxY),
        std::to_string(f.boxWidth), std::to_string(f.boxHeight)}) {
    text += "," + value;
  }
  return text;
}

std::string sizeFields(int width, int height) {
  return width == 0 ? ",," : "," + std::to_string(width) + "," + std::to_string(height);
}

}  // namespace

std::string numberText(double value) {
  if (std::isinf(value)) return "inf";
  char text[40];
  std::snprintf(text, sizeof text, "%.6g", value);
  return text;
}

std::string verdict(const ComparedPair& pair) {
  if (pair.isAtFault() || !pair.figures) return pair.fault;
  const Comparison& f = *pair.figures;
  if (f.maximum == 0) return "equal";
  return "maximum " + std::to_string(f.maximum) + ", mean " + numberText(f.mean) + ", PSNR " +
         psnrText(f) + ", over the tolerance " + overText(f);
}

std::string figureLines(const ComparedPair& pair, const CompareRequest& options) {
  std::string text = line("expected", pair.expected) + line("actual", pair.actual);
  if (pair.isAtFault()) return text + line("result", nameOf(pair.result));
  const auto size = [](int w, int h) { return std::to_string(w) + " x " + std::to_string(h); };
  if (!pair.figures) {
    return text + line("expected size", size(pair.expectedWidth, pair.expectedHeight)) +
           line("actual size", size(pair.actualWidth, pair.actualHeight)) +
           line("result", nameOf(pair.result));
  }
  const Comparison& f = *pair.figures;
  const bool isEqual = f.maximum == 0, isOver = f.pixelsOver > 0;
  return text + line("size", size(pair.actualWidth, pair.actualHeight)) +
         line("maximum", std::to_string(f.maximum)) + line("mean", numberText(f.mean)) +
         line("rms", numberText(f.rms)) + line("psnr", psnrText(f)) +
         line("tolerance", std::to_string(options.tolerance)) +
         line("over tolerance", overText(f)) +
         line("worst pixel", isEqual ? "none" : place(f.worstX, f.worstY)) +
         line("box",
              isOver ? place(f.boxX, f.boxY) + " " + place(f.boxWidth, f.boxHeight) : "none") +
         line("result", nameOf(pair.result));
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

std::string csvHeading() {
  return "name,expected,actual,result,expected_width,expected_height,actual_width,actual_height,"
         "maximum,mean,rms,psnr,pixels_over,percent_over,worst_x,worst_y,box_x,box_y,box_width,"
         "box_height\r\n";
}

std::string csvRow(const ComparedPair& pair) {
  std::string row = field(pair.name) + "," + field(pair.expected) + "," + field(pair.actual) + "," +
                    nameOf(pair.result) + sizeFields(pair.expectedWidth, pair.expectedHeight) +
                    sizeFields(pair.actualWidth, pair.actualHeight);
  row += pair.figures ? figureFields(*pair.figures) : std::string(12, ',');
  return row + "\r\n";
}
