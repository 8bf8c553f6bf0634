// Reading the words that follow an argument.
#include "cli/option_values.h"

#include "scene/number_reader.h"

namespace {

[[noreturn]] void fail(const GivenOption& given, const std::string& expected,
                       const std::string& found) {
  throw UsageError("-" + given.name + ": expected " + expected + ", found " + ::quoted(found));
}

std::string fileName(const GivenOption& given, const std::string& word) {
  if (word.empty()) fail(given, "a file name", word);
  return word;
}

/// What is wrong with a word that should have been a number of at least 0.
std::string atLeastZero(const std::string& word) {
  const bool isTooLarge = isNumber(word) && word[0] != '-';
  return isTooLarge ? "a number of at least 0 and within range" : "a number of at least 0";
}

double depthNumber(const GivenOption& given, const char* what, const std::string& word) {
  double value = 0;
  if (!readDouble(word, value))
    fail(given,
         std::string(isNumber(word) ? "a number within range for " : "a number for ") + what +
             " (MIN MAX FILE, or FILE MIN MAX)",
         word);
  return value;
}

}  // namespace

void failChoice(const GivenOption& given, WordList choices) {
  const std::string nearest(nearestWord(given.words[0], choices));
  throw UsageError("-" + given.name + ": expected " + listed(choices) + ", found " +
                   ::quoted(given.words[0]) +
                   (nearest.empty() ? "" : "; did you mean " + ::quoted(nearest) + "?"));
}

int wholeNumber(const GivenOption& given, std::size_t index, const char* what, int least,
                int most) {
  int value = 0;
  const std::string& word = given.words[index];
  if (!readInt(word, value) || value < least || value > most)
    fail(given,
         "a whole number from " + std::to_string(least) + " to " + std::to_string(most) + " for " +
             what,
         word);
  return value;
}

double positiveNumber(const GivenOption& given, const char* alternatives) {
  double value = 0;
  if (!readDouble(given.words[0], value) || value < 0)
    fail(given, atLeastZero(given.words[0]) + alternatives, given.words[0]);
  return value;
}

double numberInRange(const GivenOption& given, std::size_t index, double least, double most,
                     const std::string& expected) {
  double value = 0;
  const std::string& word = given.words[index];
  if (!readDouble(word, value) || value < least || value > most) fail(given, expected, word);
  return value;
}

float positiveFloat(const GivenOption& given) {
  float value = 0;
  if (!readFloat(given.words[0], value) || value < 0)
    fail(given, atLeastZero(given.words[0]), given.words[0]);
  return value;
}

std::string inputName(const GivenOption& given) { return fileName(given, given.words[0]); }
std::string outputName(const GivenOption& given) { return fileName(given, given.words[0]); }

std::string plainFileName(const GivenOption& given) {
  if (given.words[0] == "-") fail(given, "the name of a file", given.words[0]);
  return fileName(given, given.words[0]);
}

void readDepth(const GivenOption& given, Options& options) {
  const bool fileIsLast = isNumber(given.words[0]);
  const std::size_t first = fileIsLast ? 0 : 1;
  const double depthMin = depthNumber(given, "MIN", given.words[first]);
  const double depthMax = depthNumber(given, "MAX", given.words[first + 1]);
  if (depthMin == depthMax) fail(given, "MIN and MAX to differ", given.words[first]);
  options.depthOutput = fileName(given, given.words[fileIsLast ? 2 : 0]);
  options.depthMin = depthMin;
  options.depthMax = depthMax;
}
