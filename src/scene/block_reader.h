// BlockReader: reads the pieces that all blocks of a scene file are made of (braces, numbers,
// fields) and finds its way again after a mistake.
// There is one path for reading and for checking: a mistake is reported, and if the log does not
// throw, reading goes on behind it. Every loop over words either consumes one or ends.
#pragma once
#include <functional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "math/vec3.h"
#include "scene/mistake_log.h"
#include "scene/source_text.h"
#include "scene/tokenizer.h"
#include "scene/wording.h"

/// One of several words: `index` becomes its place in the list.
struct WordChoice {
  WordList words;
  std::size_t* index;
};

/// A named value in a block, and where it goes; or a function that reads it from behind its name
/// and returns false after a mistake.
struct Field {
  std::string_view name;
  std::variant<double*, float*, int*, Vec3d*, Vec3f*, std::string_view*, WordChoice,
               const std::function<bool()>*>
      target;
  bool isRequired = true;
  const char* at = nullptr;  ///< where its value stands; null unless a good one was read
};

/// A row of fields, not owned.
struct FieldList {
  template <std::size_t length>
  FieldList(Field (&fields)[length]) : first(fields), size(length) {}
  FieldList(std::vector<Field>& fields) : first(fields.data()), size(fields.size()) {}
  Field* first;
  std::size_t size;
};

class BlockReader {
 public:
  /// Both must outlive the reader.
  BlockReader(const SourceText& text, MistakeLog& log);

  /// The current word; empty at the end of the input.
  std::string_view word() const { return word_; }
  /// Where it stands; at the end of the input, where the last word ends.
  const char* at() const { return word_.empty() ? lastEnd_ : word_.data(); }
  bool atEnd() const { return word_.empty(); }
  void advance();

  const SourceText& text() const { return text_; }
  MistakeLog& log() { return log_; }
  std::size_t placeOf(const char* at) const { return std::size_t(at - text_.bytes().data()); }

  /// Reports a mistake at a place of the input: at most one for each place, as a word that one
  /// block cannot make sense of is of no use to the blocks around it either.
  void report(const char* at, const std::string& message);
  /// The word that begins at `at`, in quotes, for messages.
  std::string quotedAt(const char* at) const;
  /// Reports "expected X, found the current word".
  void reportExpected(const std::string& expected);
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
  /// Reports a word that `owner` does not know, and passes over it and what belongs to it. True
  /// where that was a whole block in braces.
  bool skipUnknown(std::string_view owner, WordList allowed);

  /// Read one value for `what` and report what is wrong with it. False after a mistake.
  bool readNumber(std::string_view what, double& value);
  bool readNumber(std::string_view what, float& value);
  bool readWholeNumber(std::string_view what, int& value);
  template <class T>
  bool readVector(std::string_view what, Vec3<T>& value);
  /// Reads `count` numbers behind the current word, with one blank before each, and goes to the
  /// word behind them. False, and nothing has changed, where they are written in any other way, or
  /// wrongly. (Cutting numbers into words first takes 1.6 times the instructions.)
  bool readPlainNumbers(double* values, int count);

  /// Reads `{ name value ... }`, in any order, each name as often as it comes; the last one holds.
  /// False where anything was reported.
  bool readFields(std::string_view owner, FieldList fields);

 private:
  template <class T>
  bool readNumberOf(std::string_view what, T& value);
  void reportBadNumber(std::string_view what, const std::string& kind);
  bool readPlainField(Field& field);
  void readField(Field& field);
  bool readName(std::string_view what, std::string_view& name);
  bool readChoice(std::string_view what, const WordChoice& choice);
  void skipUnknownField(std::string_view owner, FieldList fields);
  std::string found() const;

  const SourceText& text_;
  MistakeLog& log_;
  Tokenizer tokenizer_;
  std::string_view word_;
  const char* lastEnd_;
  bool isQuiet_ = false;
  const char* lastMistakeAt_ = nullptr;
  std::size_t mistakeCount_ = 0;
};

template <class T>
bool BlockReader::readVector(std::string_view what, Vec3<T>& value) {
  bool isGood = true;
  for (int axis = 0; axis < 3; ++axis) {
    const char* const before = at();
    isGood &= readNumber(what, value[axis]);
    if (at() == before) return false;
  }
  return isGood;
}
