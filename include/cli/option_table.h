// The table of all arguments: the parser, `-help`, the manual page, bash's completion and the list
// in README.txt come from it alone.
#pragma once
#include <string>
#include <vector>

#include "cli/options.h"

struct OptionRow {
  const char* group;         ///< heading under which it is listed
  const char* name;          ///< without dashes
  const char* otherName;     ///< a second spelling, or nullptr
  const char* words;         ///< the words that follow it, separated by single blanks; may be ""
  const char* defaultWords;  ///< what holds when it is not given, or nullptr where nothing does
  const char* help;          ///< one sentence without a full stop
  /// Stores the argument in `options`; throws UsageError where its words are wrong. Called with as
  /// many words as `words` names, or more where it ends in "...".
  void (*apply)(const GivenOption& given, Options& options);
  /// What kind of run it belongs to.
  enum class Mode { rendering, comparing, merging, both };
  Mode mode = Mode::rendering;
  /// The words that its first word may be, separated by single blanks, for completion.
  const char* choices = "";
};

/// All rows, those of one group together.
const std::vector<OptionRow>& optionTable();

/// The row with this name or other name (without dashes), or nullptr.
const OptionRow* findOption(const std::string& name);

/// How many words follow the argument, at least where more may (see takesMore).
int countWords(const OptionRow& row);

/// True where any number of words may follow: "...".
bool takesMore(const OptionRow& row);

/// The list of all arguments, at most 80 columns wide, as `-help` prints it and README.txt shows.
std::string optionList();

/// What `raytracer` alone prints, and what `-help` prints.
std::string shortHelp();
std::string fullHelp();

/// The manual page in the macros of man(7), and the script with which bash completes arguments.
std::string manPage();
std::string completionScript();

/// "raytracer 1.0".
std::string versionText();
