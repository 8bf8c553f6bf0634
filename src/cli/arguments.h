// The table of all arguments, from which come the parser, `-help`, the manual page and bash's
// completion; what each argument does; and the readers of the words that follow an argument.
#pragma once
#include <sstream>
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
};

/// Throws UsageError with all the `pieces` in a row.
template <class... Pieces>
[[noreturn]] void failUsage(const Pieces&... pieces) {
  std::ostringstream message;
  (message << ... << pieces);
  throw UsageError(message.str());
}

class ArgumentWords;

/// What an argument does.
struct ArgumentAction {
  const char* name;  ///< the argument's
  /// Enters the argument in `draft`; throws UsageError where its words are wrong. Called with as
  /// many words as the argument takes.
  void (*apply)(const ArgumentWords& words, Draft& draft);
  /// What kind of run it belongs to.
  enum class Mode { rendering, comparing, merging, any };
  Mode mode = Mode::rendering;
  /// The words that its first word may be, separated by single blanks, for completion.
  const char* choices = "";
};

/// The action of the argument with this name, which is in the table.
const ArgumentAction& actionOf(const std::string& name);

/// An argument as the list of -help tells of it.
struct ArgumentRow {
  std::string group;      ///< heading under which it is listed
  std::string name;       ///< without dashes
  std::string otherName;  ///< a second spelling, or ""
  /// The words that follow it, separated by single blanks; may be "". A last word that ends in
  /// "..." may be repeated, a single one in brackets be left out.
  std::string words;
  /// What it does and what holds when it is not given: one sentence without a full stop, in one
  /// line.
  std::string help;
  const ArgumentAction* action = nullptr;
};

/// All rows, those of one group together.
const std::vector<ArgumentRow>& argumentTable();

/// The row with this name or other name (without dashes), or nullptr.
const ArgumentRow* findArgument(const std::string& name);

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
  /// Any finite number, which is called `what` in the message.
  double anyNumber(std::size_t index, const std::string& what) const;
  /// The name of a file: anything but "". "-" is standard input or output.
  const std::string& file(std::size_t index) const;

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
