// Mistakes in a scene file: how FieldReader reports them and goes on behind them.
//
// What belongs to a mistake is guessed by the words that follow: all up to a word of the language,
// braces with all between them, the end of the block. A word that begins a block of its own is
// never passed over, so that one forgotten brace hides nothing of what follows.
#include <algorithm>

#include "scene/field_reader.h"
#include "scene/number_reader.h"

namespace {

bool isBlockWord(std::string_view word) {
  return isOneOf(word, kGroupWords) || isOneOf(word, kStepWords) || isOneOf(word, kLightWords) ||
         isOneOf(word, kSectionWords);
}

/// True for every word of the language.
bool isKnownWord(std::string_view word) {
  const auto isName = [&](std::string_view name) { return isWord(word, name); };
  const auto isField = [&](const Field& field) { return isName(field.name); };
  return isBlockWord(word) || std::any_of(kCountWords.begin(), kCountWords.end(), isName) ||
         std::any_of(std::begin(kFields), std::end(kFields), isField);
}

}  // namespace

FieldReader::FieldReader(const SourceText& text, MistakeLog& log)
    : text_(text), log_(log), tokenizer_(text.bytes()), lastEnd_(text.bytes().data()) {
  word_ = tokenizer_.next();
}

bool FieldReader::isAtBlock() const { return isBlockWord(word_); }

void FieldReader::advance() {
  if (word_.empty()) return;
  lastEnd_ = word_.data() + word_.size();
  word_ = tokenizer_.next();
}

// Reports.

void FieldReader::report(const char* place, const std::string& message) {
  ++mistakeCount_;
  if (isQuiet_ || place == lastMistakeAt_) return;
  lastMistakeAt_ = place;
  log_.add(std::size_t(place - text_.bytes().data()),
           InputError(text_.name(), text_.lineAt(place), message));
}

std::string FieldReader::found() const {
  return word_.empty() ? "the end of the file" : quoted(word_);
}

std::string_view FieldReader::wordAt(const char* place) const {
  return Tokenizer(text_.bytes().substr(std::size_t(place - text_.bytes().data()))).next();
}

void FieldReader::reportExpected(const std::string& expected) {
  report(at(), "expected " + expected + ", found " + found());
}

void FieldReader::reportFound(const char* place, const std::string& expected) {
  report(place, "expected " + expected + ", found " + quotedAt(place));
}

/// Reports the current word, which should be a number, and passes over it unless it plainly
/// belongs to what comes next.
void FieldReader::reportBadNumber(std::string_view what, const std::string& kind) {
  const std::string range = isNumber(word_) && kind == "a number" ? " within range" : "";
  reportExpected(kind + range + " for " + std::string(what));
  if (isAt('{')) {
    skipBlock();
  } else if (!atEnd() && !isAt('}') && !isKnownWord(word_)) {
    advance();
  }
}

// Blocks.

bool FieldReader::openBlock(std::string_view owner) {
  if (isAt('{')) {
    advance();
    return true;
  }
  reportExpected("'{' after " + std::string(owner));
  return !atEnd() && !isAt('}') && !isAtBlock();
}

void FieldReader::closeBlock(std::string_view owner) {
  if (!isAt('}')) reportExpected("'}' at the end of " + std::string(owner));
  while (!atEnd() && !isAt('}') && !isAtBlock()) {
    isAt('{') ? skipBlock() : advance();
  }
  if (isAt('}')) advance();
}

/// Passes over a whole block, from its `{`.
void FieldReader::skipBlock() {
  std::size_t depth = 0;
  do {
    depth += isAt('{');
    depth -= isAt('}');
    advance();
  } while (depth > 0 && !atEnd());
}

void FieldReader::skipWordAndBlock() {
  advance();
  if (isAt('{')) skipBlock();
}

bool FieldReader::skipUnknown(std::string_view owner, WordList allowed) {
  const std::string where = " in " + std::string(owner);
  const std::string_view meant = nearestWord(word_, allowed);
  if (isNumber(word_)) {
    report(at(), "a number too many" + where + ": expected a word or '}', found " + found());
  } else if (!meant.empty()) {
    report(at(), "unknown word " + found() + where + "; did you mean " + quoted(meant) + "?");
  } else {
    report(at(), "unknown word " + found() + where + "; expected " + listed(allowed));
  }
  if (!isAt('{')) advance();
  while (!atEnd() && !isAt('}') && !isKnownWord(word_)) {
    if (isAt('{')) {
      skipBlock();
      return true;
    }
    advance();
  }
  return false;
}
