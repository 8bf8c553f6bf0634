// ComparedPair: two pictures that belong together, and what came of comparing them.
#pragma once
#include <optional>
#include <string>

#include "cli/request.h"
#include "image/bytes.h"
#include "image/comparison.h"

struct ComparedPair {
  enum class Result { same, different, missing, unexpected, unreadable };

  std::string name;              ///< what both are called
  std::string expected, actual;  ///< files; `actual` may be a command; empty where there is none
  Result result = Result::same;
  std::string fault;  ///< why it is missing, unexpected or unreadable, or how the sizes differ
  int expectedWidth = 0, expectedHeight = 0, actualWidth = 0, actualHeight = 0;
  std::optional<Comparison> figures;  ///< where both pictures have the same size
  /// The pictures as PNG, where a report is wanted and they could be read; those of `actual` and of
  /// the differences only where the pictures are not equal.
  Bytes expectedPng, actualPng, differencePng;

  /// Neither the same within the tolerance nor readable and different.
  bool isAtFault() const { return result != Result::same && result != Result::different; }
};

const char* nameOf(ComparedPair::Result result);

/// True where `a` is to come before `b` in a list of the worst first: unreadable or without
/// partner, other sizes, many pixels over the tolerance, a large error; then by name.
bool isWorse(const ComparedPair& a, const ComparedPair& b);

/// Compares two pictures of the given name and enters what came of it.
void comparePictures(const Image& expected, const Image& actual, const CompareRequest& options,
                     ComparedPair& pair);
