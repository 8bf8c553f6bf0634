// Looking arguments up, and reading the words that follow them.
#include "cli/arguments.h"

#include <limits>
#include <sstream>

#include "scene/number_reader.h"
#include "scene/wording.h"

const ArgumentRow* findArgument(const std::string& name) {
  for (const ArgumentRow& row : argumentTable())
    if (name == row.name || (row.otherName && name == row.otherName)) return &row;
  return nullptr;
}

std::string helpOf(const ArgumentRow& row) {
  std::istringstream words(row.help);
  std::string help, word;
  while (words >> word) help += (help.empty() ? "" : " ") + word;
  return row.defaultWords ? help + " (default: " + row.defaultWords + ")" : help;
}

int leastWords(const ArgumentRow& row) {
  if (!*row.words || row.words[0] == '[') return 0;
  int count = 1;
  for (const char* c = row.words; *c; ++c) count += *c == ' ';
  return count;
}

std::size_t mostWords(const ArgumentRow& row) {
  const std::string words = row.words;
  if (words.size() >= 3 && words.compare(words.size() - 3, 3, "...") == 0) {
    return std::numeric_limits<std::size_t>::max();
  }
  return words[0] == '[' ? 1 : std::size_t(leastWords(row));
}

void ArgumentWords::fail(std::size_t index, const std::string& expected) const {
  throw UsageError(std::string("-") + row_.name + ": expected " + expected + ", found " +
                   ::quoted(words_[index]));
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

static bool read(const std::string& word, float& value) { return readFloat(word, value); }
static bool read(const std::string& word, double& value) { return readDouble(word, value); }

template <class Real>
Real ArgumentWords::atLeastZero(std::size_t index, const char* alternatives) const {
  Real value = 0;
  const std::string& word = words_[index];
  if (read(word, value) && value >= 0) return value;
  const bool isTooLarge = ::isNumber(word) && word[0] != '-';
  fail(index, std::string("a number of at least 0") + (isTooLarge ? " and within range" : "") +
                  alternatives);
}

template double ArgumentWords::atLeastZero<double>(std::size_t, const char*) const;
template float ArgumentWords::atLeastZero<float>(std::size_t, const char*) const;

bool ArgumentWords::isNumber(std::size_t index) const { return ::isNumber(words_[index]); }

double ArgumentWords::anyNumber(std::size_t index, const std::string& what) const {
  double value = 0;
  if (readDouble(words_[index], value)) return value;
  fail(index, (isNumber(index) ? "a number within range for " : "a number for ") + what);
}

void ArgumentWords::failChoice(std::size_t index, WordList choices) const {
  const std::string nearest(nearestWord(words_[index], choices));
  throw UsageError(std::string("-") + row_.name + ": expected " + listed(choices) + ", found " +
                   ::quoted(words_[index]) +
                   (nearest.empty() ? "" : "; did you mean " + ::quoted(nearest) + "?"));
}

bool ArgumentWords::isFirstChoice(std::size_t index, std::string_view yes,
                                  std::string_view no) const {
  const std::string& word = words_[index];
  if (word == yes || word == no) return word == yes;
  const std::string_view choices[] = {yes, no};
  failChoice(index, choices);
}

const std::string& ArgumentWords::file(std::size_t index) const {
  if (words_[index].empty()) fail(index, "a file name");
  return words_[index];
}

const std::string& ArgumentWords::plainFile(std::size_t index) const {
  if (words_[index] == "-") fail(index, "the name of a file");
  return file(index);
}
