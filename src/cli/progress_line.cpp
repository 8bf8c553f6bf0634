// ProgressLine: text, a carriage return before it, and what the last one had too much as blanks.
#include "cli/progress_line.h"

#include <algorithm>
#include <cstdio>

#include "image/output_file.h"

namespace {

std::string number(const char* format, double value) {
  char text[64];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

std::string duration(double seconds) {
  if (seconds < 10) return number("%.1f s", seconds);
  if (seconds < 100) return number("%.0f s", seconds);
  if (seconds < 6000) return number("%.0f min", seconds / 60);
  return number("%.1f h", seconds / 3600);
}

std::string rate(double perSecond) {
  if (perSecond < 1e3) return number("%.0f", perSecond);
  return perSecond < 1e6 ? number("%.1f k", perSecond / 1e3) : number("%.2f M", perSecond / 1e6);
}

}  // namespace

std::string progressText(double rays, double allRays, double seconds) {
  constexpr double kLeast = 1e-6;
  const double done = std::min(rays / allRays, 1.0);
  std::string text = number("%3.0f %%, ", done < 1 ? std::min(100 * done, 99.0) : 100) +
                     rate(rays / std::max(seconds, kLeast)) + " eye rays/s, ";
  if (done >= 1) return text + duration(seconds);
  return text + (done > 0 ? duration(seconds / done * (1 - done)) : "some time") + " left";
}

ProgressLine::~ProgressLine() {
  if (!isOpen_ || !isLineOpen()) return;
  std::fputc('\n', stderr);
  setLineOpen(false);
}

void ProgressLine::show(double rays, double allRays, double seconds) {
  if (isShown_) redraw(progressText(rays, allRays, seconds));
}

void ProgressLine::finish(double allRays, double seconds) {
  if (!isShown_) return;
  redraw(progressText(allRays, allRays, seconds));
  std::fputc('\n', stderr);
  setLineOpen(isOpen_ = false);
}

void ProgressLine::redraw(std::string text) {
  const std::size_t length = text.size();
  if (length < length_) text.append(length_ - length, ' ');
  length_ = length;
  setLineOpen(isOpen_ = true);
  text.insert(0, "\rraytracer: ");
  std::fwrite(text.data(), 1, text.size(), stderr);
  std::fflush(stderr);
}
