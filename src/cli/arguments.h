// The table of all arguments, from which come the parser, `-help`, the manual page and bash's
// completion; and the readers of the words that follow an argument.
#pragma once
#include <string>
#include <vector>

#include "cli/request.h"
#include "scene/wording.h"

/// A request whose arguments are being read. Places on the picture stay as they were given, in
/// pixels from its top left corner, until its size is known.
struct Draft : Request {
  struct Region {
    int x = 0, y = 0, width = 0, height = 0;
  };
  struct Band {
    int number = 0, count = 0;  // 1 <= number <= count
  };
  std::optional<Region> region;  ///< -region
  std::optional<Band> band;      ///< -tile
  std::optional<Region> pixel;   ///< -pixel; of 1 x 1
};

class ArgumentWords;

struct ArgumentRow {
  const char* group;      ///< heading under which it is listed
  const char* name;       ///< without dashes
  const char* otherName;  ///< a second spelling, or nullptr
  /// The words that follow it, separated by single blanks; may be "". A last word that ends in
  /// "..." may be repeated, a single one in brackets be left out.
  const char* words;
  const char* defaultWords;  ///< what holds when it is not given, or nullptr where nothing does
  const char* help;          ///< see helpOf
  /// Enters the argument in `draft`; throws UsageError where its words are wrong. Called with as
  /// many words as `words` allows.
  void (*apply)(const ArgumentWords& words, Draft& draft);
  /// What kind of run it belongs to.
  enum class Mode { rendering, comparing, merging, any };
  Mode mode = Mode::rendering;
  /// The words that its first word may be, separated by single blanks, for completion.
  const char* choices = "";
};

/// All rows, those of one group together.
const std::vector<ArgumentRow>& argumentTable();

/// The row with this name or other name (without dashes), or nullptr.
const ArgumentRow* findArgument(const std::string& name);

/// What the argument does and what holds when it is not given: one sentence without a full stop, in
/// one line.
std::string helpOf(const ArgumentRow& row);

/// How many words must follow the argument, and how many may.
int leastWords(const ArgumentRow& row);
std::size_t mostWords(const ArgumentRow& row);

/// The words that follow an argument. Each reader reads word number `index`, from 0, and throws
/// UsageError, naming the argument, what was expected and what was found, where it is wrong.
class ArgumentWords {
 public:
  /// Neither is owned. There are as many words as the row asks for.
  ArgumentWords(const ArgumentRow& row, const std::vector<std::string>& words)
      : row_(row), words_(words) {}

  const std::string& operator[](std::size_t index) const { return words_[index]; }
  const std::vector<std::string>& all() const { return words_; }

  /// A whole number from `least` to `most`.
  int integer(std::size_t index, int least, int most) const;
  /// A number from `least` to `most`; `expected` says so in the message.
  double number(std::size_t index, double least, double most, const std::string& expected) const;
  /// A number of at least 0, rounded once to double or float; beyond its range is a mistake.
  /// `alternatives` names for the message what else the word might be, e.g. ", course or adaptive".
  template <class Real>
  Real atLeastZero(std::size_t index, const char* alternatives = "") const;
  /// Whether the word looks like a number, perhaps one out of range.
  bool isNumber(std::size_t index) const;
  /// Any finite number, which is called `what` in the message.
  double anyNumber(std::size_t index, const std::string& what) const;
  /// True where the word is `yes`, false where it is `no`: the row's choices.
  bool isFirstChoice(std::size_t index, std::string_view yes, std::string_view no) const;
  /// The name of a file: anything but "". "-" is standard input or output.
  const std::string& file(std::size_t index) const;
  /// The same but "-".
  const std::string& plainFile(std::size_t index) const;

  [[noreturn]] void fail(std::size_t index, const std::string& expected) const;
  /// The word is none of `choices`; the nearest of them is proposed.
  [[noreturn]] void failChoice(std::size_t index, WordList choices) const;

 private:
  std::string nameOfWord(std::size_t index) const;

  const ArgumentRow& row_;
  const std::vector<std::string>& words_;
};

/// The list of all arguments, at most 80 columns wide, as `-help` prints it.
std::string optionList();
/// The list of all topics of help, as `-help` prints it and README.txt shows.
std::string topicList();

/// What `raytracer` alone prints, and what `-help` prints.
std::string shortHelp();
std::string fullHelp();

/// The manual page in the macros of man(7), and the script with which bash completes arguments.
std::string manPage();
std::string completionScript();

/// "raytracer 1.0".
std::string versionText();
