// ComparedPair.
#include "cli/compared_pair.h"

#include <tuple>

#include "image/picture_file.h"

namespace {

using Result = ComparedPair::Result;

std::string sizeText(const Image& image) {
  return std::to_string(image.Width()) + " x " + std::to_string(image.Height());
}

void keepPictures(const Image& expected, const Image& actual, ComparedPair& pair) {
  pair.expectedPng = encodePicture(expected, PictureFormat::png);
  if (pair.figures && pair.figures->maximum == 0) return;
  pair.actualPng = encodePicture(actual, PictureFormat::png);
  pair.differencePng = encodePicture(differencePicture(expected, actual), PictureFormat::png);
}

/// Greater is worse.
auto badnessOf(const ComparedPair& pair) {
  const int kind = pair.result == Result::same ? 0 : pair.result == Result::different ? 1 : 2;
  const bool otherSize = !pair.figures && !pair.isAtFault();
  return std::make_tuple(kind, otherSize, pair.figures ? pair.figures->percentOver() : 0.0,
                         pair.figures ? pair.figures->rms : 0.0);
}

}  // namespace

const char* nameOf(Result result) {
  switch (result) {
    case Result::same:
      return "same";
    case Result::different:
      return "different";
    case Result::missing:
      return "missing";
    case Result::unexpected:
      return "unexpected";
    default:
      return "unreadable";
  }
}

bool isWorse(const ComparedPair& a, const ComparedPair& b) {
  const auto p = badnessOf(a), q = badnessOf(b);
  return p != q ? p > q : a.name < b.name;
}

void comparePictures(const Image& expected, const Image& actual, const CompareRequest& options,
                     ComparedPair& pair) {
  pair.expectedWidth = expected.Width();
  pair.expectedHeight = expected.Height();
  pair.actualWidth = actual.Width();
  pair.actualHeight = actual.Height();
  if (expected.Width() != actual.Width() || expected.Height() != actual.Height()) {
    pair.result = Result::different;
    pair.fault = "expected " + sizeText(expected) + " pixels, found " + sizeText(actual);
  } else {
    pair.figures = compare(expected, actual, options.tolerance);
    const bool isOver = pair.figures->percentOver() > options.failPercent;
    pair.result = isOver ? Result::different : Result::same;
  }
  if (!options.report.empty()) keepPictures(expected, actual, pair);
}
