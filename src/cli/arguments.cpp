// Reading the words that follow an argument. A number must fill its whole word and lie within its
// limits; a message names the argument, says what was expected, and shows the word as it was found.
#include "cli/arguments.h"

#include <algorithm>
#include <sstream>

#include "image/picture_file.h"
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

/// The message has the limits and what the table calls the word.
int ArgumentWords::integer(std::size_t index, int least, int most) const {
  int value = 0;
  if (readInt(words_[index], value) && value >= least && value <= most) return value;
  fail(index, "a whole number from " + std::to_string(least) + " to " + std::to_string(most) +
                  " for " + nameOfWord(index));
}

/// `expected` names the limits, which are numbers of another kind each time.
double ArgumentWords::number(std::size_t index, double least, double most,
                             const std::string& expected) const {
  double value = 0;
  if (!readNumber(words_[index], value) || value < least || value > most) fail(index, expected);
  return value;
}

/// What looks like a number but is too large, 1e999, is told apart from what is none.
double ArgumentWords::anyNumber(std::size_t index, const std::string& what) const {
  double value = 0;
  if (readNumber(words_[index], value)) return value;
  fail(index, (isNumber(words_[index]) ? "a number within range for " : "a number for ") + what);
}

/// All choices are in the message.
std::size_t ArgumentWords::choice(bool proposes) const {
  const WordList choices = row_.action->choices;
  const auto found = std::find(choices.begin(), choices.end(), words_[0]);
  if (found != choices.end()) return std::size_t(found - choices.begin());
  const std::string nearest(proposes ? nearestWord(words_[0], choices) : "");
  failUsage("-", row_.name, ": expected ", listed(choices), ", found ", ::quoted(words_[0]),
            nearest.empty() ? "" : "; did you mean " + ::quoted(nearest) + "?");
}

const std::string& ArgumentWords::file(std::size_t index) const {
  if (words_[index].empty()) fail(index, "a file name");
  return words_[index];
}

const std::string& ArgumentWords::picture(std::size_t index) const {
  const std::string& name = file(index);
  if (!knownFormatOf(name)) {
    std::string endings;
    for (const char* const ending : kPictureEndings) {
      endings += std::string(endings.empty() ? "." : ", .") + ending;
    }
    fail(index, "a file name without ending or with one of " + endings);
  }
  return name;
}
