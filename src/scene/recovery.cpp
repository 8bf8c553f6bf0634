// Mistakes in a scene file: how FieldReader reports them and goes on behind them.
//
// What belongs to a mistake is guessed by the words that follow: all up to a word of the language,
// braces with all between them, the end of the block. A word that begins a block of its own is
// never passed over, so that one forgotten brace hides nothing of what follows.
#include <algorithm>

#include "scene/field_reader.h"
#include "scene/number_reader.h"

namespace {

/// True for a word that begins a block or a setting in any language.
bool isBlockWord(std::string_view word) {
  const auto hasWord = [&](const auto& words) { return isOneOf(word, words.first); };
  const auto isNamed = [&](const Step& step) { return step.name == word; };
  return std::any_of(std::begin(kBlockWords), std::end(kBlockWords), hasWord) ||
         std::any_of(std::begin(kSteps), std::end(kSteps), isNamed);
}

/// The languages that have the word; 0 for a word of none.
Languages languagesOf(std::string_view word) {
  Languages languages = 0;
  for (const auto& [words, some] : kBlockWords) languages |= isOneOf(word, words) ? some : 0;
  for (const Step& step : kSteps) languages |= step.name == word ? step.languages : 0;
  for (const Field& field : kFields) languages |= isWord(word, field.name) ? field.languages : 0;
  for (const auto& name : kCountWords) languages |= isWord(word, name) ? kNot2020 : 0;
  return languages;
}

/// "falloff is a word of 2012 and 2016: add -course 2012 or -course 2016" for a word of other
/// languages: each reads some of them in its own way.
std::string otherCourses(std::string_view word, Languages languages, Language language) {
  if (languages == 0 || isIn(languages, language)) return {};
  std::vector<std::string_view> names;
  std::string options;
  for (const auto& [other, name] : kLanguageNames) {
    if (!isIn(languages, other)) continue;
    names.push_back(name);
    options += (options.empty() ? "-course " : " or -course ") + std::string(name);
  }
  return std::string(word) + " is a word of " + listed(names, "and") + ": add " + options;
}

}  // namespace

FieldReader::FieldReader(const SourceText& text, MistakeLog& log, Language language)
    : text_(text),
      log_(log),
      language_(language),
      tokenizer_(text.bytes()),
      lastEnd_(text.bytes().data()) {
  word_ = tokenizer_.next();
}

bool FieldReader::isAtBlock() const { return isBlockWord(word_); }

void FieldReader::advance() {
  if (word_.empty()) return;
  lastEnd_ = tokenizer_.place();
  word_ = tokenizer_.next();
}

// Reports.

void FieldReader::report(const char* place, const std::string& message) {
  ++mistakeCount_;
  if (isQuiet_ || place == lastMistakeAt_) return;
  lastMistakeAt_ = place;
  log_.add(text_.offsetOf(place), InputError(text_.name(), text_.lineAt(place), message));
}

std::string FieldReader::found() const {
  return word_.empty() ? "the end of the file" : quoted(word_);
}

std::string_view FieldReader::wordAt(const char* place) const {
  return Tokenizer(text_.from(place)).next();
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
  } else if (!atEnd() && !isAt('}') && languagesOf(word_) == 0) {
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

bool FieldReader::skipUnknown(std::string_view owner, WordList allowed, Languages languages) {
  const std::string where = " in " + std::string(owner);
  const std::string_view meant = nearestWord(word_, allowed);
  const Languages known = languagesOf(word_);
  const bool isKnown = languages != 0 && isIn(known, language_);  // in other blocks
  const std::string others = otherCourses(word_, isKnown ? languages : known, language_);
  if (!others.empty()) {
    report(at(), "unknown word " + found() + where + "; " + others);
  } else if (isNumber(word_)) {
    report(at(), "a number too many" + where + ": expected a word or '}', found " + found());
  } else if (!meant.empty()) {
    report(at(), "unknown word " + found() + where + "; did you mean " + quoted(meant) + "?");
  } else {
    report(at(), "unknown word " + found() + where + "; expected " + listed(allowed));
  }
  if (!isAt('{')) advance();
  while (!atEnd() && !isAt('}') && languagesOf(word_) == 0) {
    if (isAt('{')) {
      skipBlock();
      return true;
    }
    advance();
  }
  return false;
}
