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
  return WordList(kSectionWords).contains(word) || WordList(kLightWords).contains(word) ||
         WordList(kStepsToMaterials).contains(word);
}

/// True for every word of the language.
bool isKnownWord(std::string_view word) {
  const auto isName = [&](std::string_view name) { return isWord(word, name); };
  return isBlockWord(word) || std::any_of(std::begin(kCountWords), std::end(kCountWords), isName) ||
         std::any_of(std::begin(kFields), std::end(kFields),
                     [&](const Field& field) { return isName(field.name); });
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

std::string FieldReader::quotedAt(const char* place) const {
  return quoted(Tokenizer(text_.bytes().substr(std::size_t(place - text_.bytes().data()))).next());
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
  if (word_ == "{") {
    skipBlock();
  } else if (!atEnd() && word_ != "}" && !isKnownWord(word_)) {
    advance();
  }
}

// Blocks.

bool FieldReader::openBlock(std::string_view owner) {
  if (word_ == "{") {
    advance();
    return true;
  }
  reportExpected("'{' after " + std::string(owner));
  return !atEnd() && word_ != "}" && !isAtBlock();
}

void FieldReader::closeBlock(std::string_view owner) {
  if (word_ != "}") reportExpected("'}' at the end of " + std::string(owner));
  while (!atEnd() && word_ != "}" && !isAtBlock()) {
    word_ == "{" ? skipBlock() : advance();
  }
  if (word_ == "}") advance();
}

/// Passes over a whole block, from its `{`.
void FieldReader::skipBlock() {
  std::size_t depth = 0;
  do {
    depth += word_ == "{";
    depth -= word_ == "}";
    advance();
  } while (depth > 0 && !atEnd());
}

void FieldReader::skipWordAndBlock() {
  advance();
  if (word_ == "{") skipBlock();
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
  if (word_ != "{") advance();
  while (!atEnd() && word_ != "}" && !isKnownWord(word_)) {
    if (word_ == "{") {
      skipBlock();
      return true;
    }
    advance();
  }
  return false;
}
