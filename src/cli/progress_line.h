// ProgressLine: one line of a terminal that tells how far the picture is.
#pragma once
#include <cstddef>
#include <string>

class ProgressLine {
 public:
  /// Nothing is shown unless `isShown`.
  explicit ProgressLine(bool isShown) : isShown_(isShown) {}
  /// Ends the line where one is open.
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  /// Redraws the line on standard error: `rays` of `allRays` > 0 in so many seconds.
  void show(double rays, double allRays, double seconds);
  /// The same with everything done, and ends the line.
  void finish(double allRays, double seconds);

 private:
  void redraw(std::string text);

  bool isShown_, isOpen_ = false;
  std::size_t length_ = 0;
};

/// "42 %, 1.5 M eye rays/s, 12 s left", or, where all is done, the time it took.
std::string progressText(double rays, double allRays, double seconds);
