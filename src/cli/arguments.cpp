// Reading the words that follow an argument.
#include "cli/arguments.h"

#include <sstream>

#include "scene/number_reader.h"

void ArgumentWords::fail(std::size_t index, const std::string& expected) const {
  failUsage("-", row_.name, ": expected ", expected, ", found ", ::quoted(words_[index]));
}

/// As the table calls it.
std::string ArgumentWords::nameOfWord(std::size_t index) const {
  std::istringstream names(row_.words);
  std::string name;
  for (std::size_t i = 0; i <= index; ++i) names >> name;
  return name;
}

int ArgumentWords::integer(std::size_t index, int least, int most) const {
  int value = 0;
  if (readInt(words_[index], value) && value >= least && value <= most) return value;
  fail(index, "a whole number from " + std::to_string(least) + " to " + std::to_string(most) +
                  " for " + nameOfWord(index));
}

double ArgumentWords::number(std::size_t index, double least, double most,
                             const std::string& expected) const {
  double value = 0;
  if (!readDouble(words_[index], value) || value < least || value > most) fail(index, expected);
  return value;
}

double ArgumentWords::anyNumber(std::size_t index, const std::string& what) const {
  double value = 0;
  if (readDouble(words_[index], value)) return value;
  fail(index, (isNumber(words_[index]) ? "a number within range for " : "a number for ") + what);
}

void ArgumentWords::failChoice(std::size_t index, WordList choices) const {
  const std::string nearest(nearestWord(words_[index], choices));
  failUsage("-", row_.name, ": expected ", listed(choices), ", found ", ::quoted(words_[index]),
            nearest.empty() ? "" : "; did you mean " + ::quoted(nearest) + "?");
}

const std::string& ArgumentWords::file(std::size_t index) const {
  if (words_[index].empty()) fail(index, "a file name");
  return words_[index];
}
