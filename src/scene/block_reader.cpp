// Braces, names and unknown words of a scene file.
#include "scene/block_reader.h"

#include "scene/number_reader.h"
#include "scene/scene_words.h"

BlockReader::BlockReader(const SourceText& text, MistakeLog& log)
    : text_(text), log_(log), tokenizer_(text.bytes()), lastEnd_(text.bytes().data()) {
  word_ = tokenizer_.next();
}

void BlockReader::advance() {
  if (word_.empty()) return;
  lastEnd_ = word_.data() + word_.size();
  word_ = tokenizer_.next();
}

void BlockReader::report(const char* place, const std::string& message) {
  ++mistakeCount_;
  if (isQuiet_ || place == lastMistakeAt_) return;
  lastMistakeAt_ = place;
  log_.add(placeOf(place), InputError(text_.name(), text_.lineAt(place), message));
}

std::string BlockReader::found() const {
  return word_.empty() ? "the end of the file" : quoted(word_);
}

std::string BlockReader::quotedAt(const char* place) const {
  return quoted(Tokenizer(text_.bytes().substr(placeOf(place))).next());
}

void BlockReader::reportExpected(const std::string& expected) {
  report(at(), "expected " + expected + ", found " + found());
}

bool BlockReader::openBlock(std::string_view owner) {
  if (word_ == "{") {
    advance();
    return true;
  }
  reportExpected("'{' after " + std::string(owner));
  return !atEnd() && word_ != "}" && !isBlockWord(word_);
}

void BlockReader::closeBlock(std::string_view owner) {
  if (word_ != "}") reportExpected("'}' at the end of " + std::string(owner));
  while (!atEnd() && word_ != "}" && !isBlockWord(word_)) {
    if (word_ == "{") {
      skipBlock();
    } else {
      advance();
    }
  }
  if (word_ == "}") advance();
}

void BlockReader::skipBlock() {
  std::size_t depth = 0;
  do {
    depth += word_ == "{";
    depth -= word_ == "}";
    advance();
  } while (depth > 0 && !atEnd());
}

bool BlockReader::skipUnknown(std::string_view owner, WordList allowed) {
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
