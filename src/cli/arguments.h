// The table of all arguments, from which come the parser, `-help`, the manual page and bash's
// completion; what each argument does; and the readers of the words that follow an argument.
#pragma once
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "cli/request.h"
#include "scene/wording.h"

/// A request whose arguments are being read. What it has beside the request waits until the size of
/// the picture is known; it is then done with, and cut off.
struct Draft : Request {
  /// The pixels of the picture that are wanted, which depend on its size. Throws UsageError where
  /// it has no such pixels.
  using AreaOf = std::function<PixelRectangle(const PictureRequest& picture)>;
  AreaOf region;            ///< of -region; empty where it is not given
  AreaOf band;              ///< of -tile, likewise
  bool isJittered = false;  ///< -jitter
  bool isFiltered = false;  ///< -filter
  std::string idle;  ///< arguments that were accepted and do nothing, "-gui, -gouraud"; or ""
};

class ArgumentWords;

/// What an argument does.
// NOLINTNEXTLINE(clang-analyzer-optin.performance.Padding): in the order in which rows read best
struct ArgumentAction {
  std::string_view name;  ///< the argument's
  /// Enters the argument in `draft`; throws UsageError where its words are wrong. Called with as
  /// many words as the argument takes.
  void (*apply)(const ArgumentWords& words, Draft& draft);
  /// What kind of run it belongs to.
  enum class Mode { rendering, comparing, merging, any };
  Mode mode = Mode::rendering;
  /// Words that its first word may be; that of -epsilon may be a number too.
  WordList choices{nullptr, 0};
  /// False where no words that it may have change a pixel, as those of -threads, and where they
  /// name files. The fingerprint of a picture passes over it then.
  bool changesPixels = true;
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
  std::vector<std::string> wordNames;         ///< the same, each for itself
  std::size_t leastWords = 0, mostWords = 0;  ///< how many must follow, and how many may
  /// What it does and what holds when it is not given: one sentence without a full stop, in one
  /// line.
  std::string help;
  const ArgumentAction* action = nullptr;
};

/// All rows, those of one group together.
const std::vector<ArgumentRow>& argumentTable();

/// The row with this name or other name (without dashes), or nullptr.
const ArgumentRow* findArgument(const std::string& name);

/// The words that follow an argument. Each reader reads word number `index`, from 0, and throws
/// UsageError, naming the argument, what was expected and what was found, where it is wrong.
class ArgumentWords {
 public:
  /// Neither is owned. There are as many words as the row asks for.
  ArgumentWords(const ArgumentRow& row, const std::vector<std::string>& words)
      : row_(row), words_(words) {}

  /// The argument's, without dashes.
  const std::string& name() const { return row_.name; }
  const std::string& operator[](std::size_t index) const { return words_[index]; }
  const std::vector<std::string>& all() const { return words_; }

  /// A whole number from `least` to `most`.
  int integer(std::size_t index, int least, int most) const;
  /// A number from `least` to `most`; `expected` says so in the message.
  double number(std::size_t index, double least, double most, const std::string& expected) const;
  /// Any finite number, which is called `what` in the message.
  double anyNumber(std::size_t index, const std::string& what) const;
  /// Anything but "", which `expected` names in the message.
  const std::string& notEmpty(std::size_t index, const char* expected) const;
  /// The name of a file: anything but "". "-" is standard input or output.
  const std::string& file(std::size_t index) const { return notEmpty(index, "a file name"); }

  /// The name of a picture that is written: likewise, with an ending that is known, or none.
  const std::string& picture(std::size_t index) const;

  /// Likewise of the first word: its number among the choices of the argument's action; in the
  /// message of a mistake the nearest one is proposed, unless not `proposes`.
  std::size_t choice(bool proposes = true) const;

  [[noreturn]] void fail(std::size_t index, const std::string& expected) const;

 private:
  const ArgumentRow& row_;
  const std::vector<std::string>& words_;
};

/// What is to be known beside the list of arguments. A text is plain ASCII in lines of at most 80
/// columns. A line in capitals is a heading, other lines that begin at the left are paragraphs, and
/// indented ones are shown as they stand (the manual page sets them so too).
struct HelpTopic {
  const char* name;     ///< one word, small letters
  const char* summary;  ///< what it is about, at most 60 columns, for the list of topics
  const char* text;     ///< ends with a line's end
};

/// The names of all topics of `-help TOPIC`, in the order in which a beginner may want them.
inline constexpr std::string_view kTopicNames[] = {"scene",      "course",  "materials", "samples",
                                                   "output",     "inside",  "grid",      "parts",
                                                   "checkpoint", "compare", "limits"};
/// The topics, in that order.
const std::vector<HelpTopic>& helpTopics();

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
