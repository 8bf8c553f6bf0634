// FieldReader: reads the pieces that all blocks of a scene file are made of (braces, numbers,
// fields, lists with a count) and finds its way again after a mistake.
//
// There is one path for reading and for checking: a mistake is reported, and if the log does not
// throw, reading goes on behind it. How far a mistake reaches is guessed by the words around it: up
// to the block's }, or to a word that plainly begins something else. Every loop over words either
// consumes one or ends. A `const char*` called `at` or `start` is a place in the text.
#pragma once
#include <array>
#include <functional>
#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "math/vec3.h"
#include "scene/input_error.h"
#include "scene/scene_grammar.h"
#include "scene/source_text.h"
#include "scene/wording.h"

/// The value of a field, at first its default. What it is follows from the field's kind: the caller
/// asks for that. Floats and whole numbers are kept as doubles, which hold each of them exactly;
/// the name of a file is the word that stands where the value does.
struct Value {
  double number() const { return numbers[0]; }
  float single() const { return float(numbers[0]); }
  int whole() const { return int(numbers[0]); }
  Vec3d vector() const { return {numbers[0], numbers[1], numbers[2]}; }
  Vec3f color() const { return Vec3f(vector()); }
  /// Of a vector that is not zero: brought to a length near 1 by a power of two. The direction
  /// stays exactly the same, and its squares neither overflow nor vanish.
  Vec3d direction() const;

  const Field* field;
  std::array<double, 3> numbers;
  const char* at;  ///< where it stands; null unless a good one was given
};

/// The values of one block's fields: its own and those that it shares with others.
class Fields {
 public:
  /// The defaults of all fields that kFields lists for these in that language. In this order
  /// messages list them.
  Fields(Language language, std::initializer_list<std::string_view> blocks);

  /// Whether the block was read without a mistake.
  bool areGood = false;

  /// Whether the block has a field of that meaning in this language.
  bool has(std::string_view meaning) const;
  /// The value of that meaning, which must be one of the table's; its default where this language
  /// has no such field.
  Value operator[](std::string_view meaning) const;
  /// The value that `word` names, be it in the older form; end() where there is none. `next` is
  /// looked at first: the one behind the last that was found, as most blocks are in this order.
  Value* find(std::string_view word, Value* next);
  std::vector<std::string_view> names() const;
  /// The languages in which the block has a field of that name.
  Languages languagesOfField(std::string_view name) const;

  Value* begin() { return values_.data(); }
  Value* end() { return values_.data() + count_; }
  const Value* begin() const { return values_.data(); }
  const Value* end() const { return values_.data() + count_; }

 private:
  std::array<Value, kMostFields> values_;  // without a value behind the count
  std::size_t count_ = 0;
};

/// A block that begins with the count of what it holds.
struct CountedBlock {
  std::string_view owner;      // "Group"
  std::string_view countName;  // "numObjects"; empty in 2020, where nothing is counted
  WordList items;              // what is counted
  WordList allowed;            // what may stand in the block
};

class FieldReader {
 public:
  /// Something noted at a place of the text.
  using Note = std::pair<const char*, std::string>;
  /// Reads the value of such a field of Form::ownReader; false after a mistake.
  using OwnReader = std::function<bool(std::string_view name)>;

  /// Both must outlive the reader.
  FieldReader(const SourceText& text, MistakeLog& log, Language language);

  /// In which the text is written.
  Language language() const { return language_; }
  /// Whether objects stand in nodes there, in place of Groups: 2020.
  bool hasNodes() const { return language_ == Language::of2020; }

  /// The words that begin sections there.
  WordList sectionWords() const { return hasNodes() ? WordList(kNodeSectionWords) : kSectionWords; }

  /// The current word; empty at the end of the input.
  std::string_view word() const { return word_; }
  /// Where it stands; at the end of the input, where the last word ends.
  const char* at() const { return word_.empty() ? lastEnd_ : word_.data(); }
  bool atEnd() const { return word_.empty(); }
  /// True where the current word is this brace.
  bool isAt(char brace) const { return !word_.empty() && word_[0] == brace; }
  /// True where the current word begins a block or a setting, so that it belongs to no other one.
  bool isAtBlock() const;
  void advance();
  const SourceText& text() const { return text_; }

  // Mistakes, and the way on behind them: recovery.cpp.

  /// Reports a mistake at a place of the input: at most one for each place, as a word that one
  /// block cannot make sense of is of no use to the blocks around it either.
  void report(const char* at, const std::string& message);
  /// Reports "expected X, found the current word".
  void reportExpected(const std::string& expected);
  /// Reports "expected X, found the word that begins at `at`".
  void reportFound(const char* at, const std::string& expected);
  /// The word that begins at `at`; and in quotes, for messages.
  std::string_view wordAt(const char* at) const;
  std::string quotedAt(const char* at) const { return quoted(wordAt(at)); }
  /// Whether all mistakes are collected, as for -check.
  bool isChecking() const { return log_.mode() == MistakeLog::Mode::collect; }
  /// The file name that begins at `at`, with the quotes around it where it has some; empty where
  /// the second one is missing.
  std::string_view fileNameAt(const char* at) const;
  /// While quiet, mistakes are counted but not reported.
  void setQuiet(bool isQuiet) { isQuiet_ = isQuiet; }
  std::size_t mistakeCount() const { return mistakeCount_; }

  /// Takes the `{` behind the name of a block, or reports. False where no block follows.
  bool openBlock(std::string_view owner);
  /// Takes the `}` of a block, or reports what stands there and passes over it as far as it does
  /// not begin something else.
  void closeBlock(std::string_view owner);
  /// Passes over the current word and over a block in braces behind it.
  void skipWordAndBlock();
  /// Reports a word that `owner` does not know, and passes over it and what belongs to it. True
  /// where that was a whole block in braces. `languages`, where not 0, are those in which the block
  /// has such a field.
  bool skipUnknown(std::string_view owner, WordList allowed, Languages languages = 0);

  // Values: field_reader.cpp. Each function reports what is wrong and returns false then.

  /// Reads `count` numbers from the current word on, as doubles or rounded to floats.
  bool readNumbers(std::string_view what, double* values, std::size_t count, bool areSingle);
  /// Reads `count` numbers behind the current word, with one blank before each, and goes to the
  /// word behind them. False, and nothing has changed, where they are written in any other way, or
  /// wrongly. (Cutting numbers into words first takes 1.6 times the instructions.)
  bool readPlainNumbers(double* values, std::size_t count);
  bool readWholeNumber(std::string_view what, int& value);
  /// Reads one of `choices` and tells which.
  bool readChoice(std::string_view what, WordList choices, std::size_t& index);

  // Blocks of fields (fields.cpp), and lists.

  /// Reads `{ name value ... }`, in any order, each name as often as it comes; the last one holds.
  /// The fields are those of the `blocks` of the table. A required field that is missing is a
  /// mistake too, and so is a value out of its range. Where the `{` has been taken already, `start`
  /// is the block's place for messages.
  Fields readFields(std::string_view owner, std::initializer_list<std::string_view> blocks,
                    const OwnReader& readOwn = {}, const char* start = nullptr);
  /// The fields that were given more than once in their block: where again, their names and where
  /// before.
  struct Repeat {
    const char* at;
    std::string_view name;
    const char* before;
  };
  const std::vector<Repeat>& repeats() const { return repeats_; }
  /// The colours with a component above 1 of fields that may have one: their places and names.
  const std::vector<Note>& brightColors() const { return brightColors_; }

  /// Reads `{ countName N ... }`. `readItem` reads one counted item, whose name is the current
  /// word; `readOther`, where given, reads something that is not counted and returns true, or
  /// returns false where it is unknown. That there are as many as it says is checked where the list
  /// goes on or ends; the count is only compared with, so that a huge one costs nothing.
  void readCounted(const CountedBlock& block, const std::function<void()>& readItem,
                   const std::function<bool()>& readOther = {});

 private:
  std::string found() const;
  void skipBlock();
  void reportBadNumber(std::string_view what, const std::string& kind);
  bool readNumber(double& value, bool isSingle);
  bool readFileName(std::string_view what);
  bool readNames(std::string_view owner, Fields& fields, const OwnReader& readOwn);
  void readField(Value& value, const OwnReader& readOwn);
  bool readValue(Value& value, const OwnReader& readOwn);
  void reportMissing(std::string_view owner, const char* start, const Fields& fields);
  bool checkRange(const Value& value);
  bool checkReflectance(const Value& value);
  bool readCount(const CountedBlock& block, int& count);

  const SourceText& text_;
  MistakeLog& log_;
  const Language language_;
  Tokenizer tokenizer_;
  std::string_view word_;
  const char* lastEnd_;
  bool isQuiet_ = false;
  const char* lastMistakeAt_ = nullptr;
  std::size_t mistakeCount_ = 0;
  std::vector<Note> brightColors_;
  std::vector<Repeat> repeats_;
};

/// True when `word` is `name`, or `name` as the course's older scenes write it: num_objects for
/// numObjects. Names that begin with a capital have only one form.
bool isWord(std::string_view word, std::string_view name);
