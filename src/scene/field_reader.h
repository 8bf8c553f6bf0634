// FieldReader: reads the pieces that all blocks of a scene file are made of (braces, numbers,
// fields, lists with a count) and finds its way again after a mistake.
//
// There is one path for reading and for checking: a mistake is reported, and if the log does not
// throw, reading goes on behind it. How far a mistake reaches is guessed by the words around it: up
// to the block's }, or to a word that plainly begins something else. Every loop over words either
// consumes one or ends.
#pragma once
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

/// The table of a block's fields and the struct that their values go to. Nothing is owned.
struct FieldList {
  template <class Block>
  FieldList(Block& values)
      : first(Block::kFields), size(std::size(Block::kFields)), block(&values) {}

  const Field* first;
  std::size_t size;
  void* block;
};
/// All fields of a block, of one struct or more, in the order in which messages list them.
using FieldLists = std::initializer_list<FieldList>;

/// A block that begins with the count of what it holds.
struct CountedBlock {
  std::string_view owner;      // "Group"
  std::string_view countName;  // "numObjects"
  WordList items;              // what is counted
  WordList allowed;            // what may stand in the block
};

class FieldReader {
 public:
  /// Something noted at a place of the text.
  using Note = std::pair<const char*, std::string>;

  /// Both must outlive the reader.
  FieldReader(const SourceText& text, MistakeLog& log);

  /// The current word; empty at the end of the input.
  std::string_view word() const { return word_; }
  /// Where it stands; at the end of the input, where the last word ends.
  const char* at() const { return word_.empty() ? lastEnd_ : word_.data(); }
  bool atEnd() const { return word_.empty(); }
  /// True where the current word begins a block or a setting, so that it is part of no other one.
  bool isAtBlock() const;
  void advance();

  const SourceText& text() const { return text_; }
  std::size_t placeOf(const char* at) const { return std::size_t(at - text_.bytes().data()); }

  /// Reports a mistake at a place of the input: at most one for each place, as a word that one
  /// block cannot make sense of is of no use to the blocks around it either.
  void report(const char* at, const std::string& message);
  /// Reports "expected X, found the current word".
  void reportExpected(const std::string& expected);
  /// Reports "expected X, found the word that begins at `at`".
  void reportFound(const char* at, const std::string& expected);
  /// The word that begins at `at`, in quotes, for messages.
  std::string quotedAt(const char* at) const;
  /// While quiet, mistakes are counted but not reported.
  void setQuiet(bool isQuiet) { isQuiet_ = isQuiet; }
  std::size_t mistakeCount() const { return mistakeCount_; }

  /// Takes the `{` behind the name of a block, or reports. False where no block follows.
  bool openBlock(std::string_view owner);
  /// Takes the `}` of a block, or reports what stands there and passes over it as far as it does
  /// not begin something else.
  void closeBlock(std::string_view owner);
  /// Passes over a whole block, from its `{`.
  void skipBlock();
  /// Passes over the current word and over a block in braces behind it.
  void skipWordAndBlock();
  /// Reports a word that `owner` does not know, and passes over it and what belongs to it. True
  /// where that was a whole block in braces.
  bool skipUnknown(std::string_view owner, WordList allowed);

  /// Read one value for `what` and report what is wrong with it. False after a mistake.
  template <class T>
  bool readNumber(std::string_view what, T& value);
  bool readWholeNumber(std::string_view what, int& value);
  /// Reads `count` numbers behind the current word, with one blank before each, and goes to the
  /// word behind them. False, and nothing has changed, where they are written in any other way, or
  /// wrongly. (Cutting numbers into words first takes 1.6 times the instructions.)
  bool readPlainNumbers(double* values, std::size_t count);

  /// Reads `{ name value ... }`, in any order, each name as often as it comes; the last one holds.
  /// False where anything was reported, a required field that is missing included.
  bool readFields(std::string_view owner, FieldLists lists);
  /// Looks at the ranges of the values that were given, in the table's order; reports those that
  /// are out of theirs and returns false then.
  bool checkRanges(const FieldList& fields);
  /// The colours with a component above 1 that checkRanges has seen: their places and names.
  const std::vector<Note>& brightColors() const { return brightColors_; }

  /// Reads `{ countName N ... }`. `readItem` reads one counted item, whose name is the current
  /// word; `readOther` reads something that is not counted and returns true, or returns false where
  /// it is unknown. That there are as many as it says is checked where the list goes on or ends;
  /// the count is only compared with, so that a huge one costs nothing.
  void readCounted(const CountedBlock& block, const std::function<void()>& readItem,
                   const std::function<bool()>& readOther);

 private:
  std::string found() const;
  void reportBadNumber(std::string_view what, const std::string& kind);
  template <class T>
  bool readVector(std::string_view what, Vec3<T>& value);
  bool readName(std::string_view what, std::string_view& name);
  bool readChoice(std::string_view what, WordChoice& choice);
  void readField(const Field& field, void* block);
  bool readPlainField(FieldPlace place);
  void reportMissing(std::string_view owner, const char* start, FieldLists lists);
  bool checkRange(const Field& field, FieldPlace place);
  bool checkReflectance(std::string_view name, const Given<Vec3f>& color);
  bool readCount(const CountedBlock& block, int& count);

  const SourceText& text_;
  MistakeLog& log_;
  Tokenizer tokenizer_;
  std::string_view word_;
  const char* lastEnd_;
  bool isQuiet_ = false;
  const char* lastMistakeAt_ = nullptr;
  std::size_t mistakeCount_ = 0;
  std::vector<Note> brightColors_;
};
