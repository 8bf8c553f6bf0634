// Reading the values and lists of a scene file by the tables of scene_grammar.h. (Whole blocks of
// fields: fields.cpp.)
//
// Values are read by their kinds; most are plain numbers, which are tried at a stretch before any
// word is cut. Ranges are looked at when the block has ended.
#include "scene/field_reader.h"

#include <algorithm>
#include <cmath>

#include "math/perlin_noise.h"
#include "scene/decimal.h"
#include "scene/number_reader.h"
#include "scene/scene_parser.h"

namespace {

/// How many numbers such a value has.
std::size_t countOf(Form form) { return form == Form::vector || form == Form::color ? 3 : 1; }

/// What one number must be, where it is not; "" where it is.
std::string expectedOf(const Value& value) {
  const std::string name(value.field->name);
  const double number = value.number();
  const auto between = [&](int least, int most) {
    if (number >= least && number <= most) return std::string();
    return name + " from " + std::to_string(least) + " to " + std::to_string(most);
  };
  switch (value.field->range) {
    case Range::atLeastZero:
      return number < 0 ? name + " of at least 0" : "";
    case Range::side:
      return between(1, SceneParser::kMostPixels);
    case Range::octaves:
      return between(0, math::kMaxOctaves);
    default:
      if (number <= 0) return name + " above 0";
      const bool isTooWide = value.field->range == Range::angle && number >= 180;
      return isTooWide ? "an angle below 180 degrees" : "";
  }
}

}  // namespace

// Values.

Vec3d Value::direction() const {
  Vec3d direction = vector();
  int exponent = 0;
  std::frexp(maxAbs(direction), &exponent);
  for (int axis = 0; axis < 3; ++axis) direction[axis] = std::ldexp(direction[axis], -exponent);
  return direction;
}

bool FieldReader::readNumbers(std::string_view what, double* values, std::size_t count,
                              bool areSingle) {
  bool isGood = true;
  for (std::size_t i = 0; i < count; ++i) {
    if (readNumber(values[i], areSingle)) continue;
    isGood = false;
    const char* const place = at();
    reportBadNumber(what, "a number");
    if (at() == place) break;
  }
  return isGood;
}

/// What stands behind the word, up to the text's end, is not of the number, but lets it be read
/// eight bytes at a time.
bool FieldReader::readNumber(double& value, bool isSingle) {
  const char* const start = word_.data();
  double found = 0;
  float single = 0;
  const char* const stop = atEnd()    ? nullptr
                           : isSingle ? scanNumber(start, tokenizer_.end(), single)
                                      : scanNumber(start, tokenizer_.end(), found);
  if (!stop || stop != start + word_.size()) return false;
  value = isSingle ? double(single) : found;
  advance();
  return true;
}

bool FieldReader::readPlainNumbers(double* values, std::size_t count) {
  const char* p = tokenizer_.place();
  for (std::size_t i = 0; i < count; ++i) {
    p = decimal::scanBehindBlank(p, tokenizer_.end(), values[i]);
    if (!p) return false;
  }
  tokenizer_.moveTo(p);
  advance();
  return true;
}

bool FieldReader::readWholeNumber(std::string_view what, int& value) {
  const bool isGood = readInt(word_, value);
  isGood ? advance() : reportBadNumber(what, "a whole number");
  return isGood;
}

bool FieldReader::readChoice(std::string_view what, WordList choices, std::size_t& index) {
  const std::string_view* const chosen = std::find(choices.begin(), choices.end(), word_);
  if (chosen != choices.end()) {
    index = std::size_t(chosen - choices.begin());
    advance();
    return true;
  }
  const std::string_view meant = nearestWord(word_, choices);
  report(at(), "expected " + listed(choices) + " for " + std::string(what) + ", found " + found() +
                   (meant.empty() ? "" : "; did you mean " + quoted(meant) + "?"));
  return false;
}

/// A word, or what stands in double quotes on one line. Behind a plain name another word may be the
/// rest of it: then quotes are what is missing.
bool FieldReader::readFileName(std::string_view what) {
  if (atEnd() || isAt('{') || isAt('}')) {
    reportExpected("a file name for " + std::string(what));
    return false;
  }
  const char* const start = at();
  if (*start == '"') {
    const std::string_view name = fileNameAt(start);
    if (name.empty()) {
      report(start, "expected a file name that ends in '\"' on the same line, found none");
      advance();
      return false;
    }
    tokenizer_.moveTo(name.data() + name.size());
    advance();
    return true;
  }
  advance();
  const bool isRest = !atEnd() && !isAt('{') && !isAt('}') && !isAtBlock() &&
                      word_.find('.') != word_.npos && text_.lineAt(start) == text_.lineAt(at());
  if (!isRest) return true;
  report(at(), "expected '}' behind the file name " + quoted(wordAt(start)) + ", found " + found() +
                   "; a name with blanks stands in quotes: \"a b.obj\"");
  while (!atEnd() && !isAt('{') && !isAt('}') && !isAtBlock()) advance();
  return false;
}

std::string_view FieldReader::fileNameAt(const char* at) const {
  if (*at != '"') return wordAt(at);
  const char* const end = text_.bytes().data() + text_.bytes().size();
  for (const char* p = at + 1; p != end && *p != '\n' && *p != '\r'; ++p) {
    if (*p == '\\' && p + 1 != end && p[1] == '"') {
      ++p;
    } else if (*p == '"') {
      return {at, std::size_t(p + 1 - at)};
    }
  }
  return {};
}

// The value of a field.

/// Reads a field from its name on.
void FieldReader::readField(Value& value, const OwnReader& readOwn) {
  const Form form = value.field->form;
  const char* const before = value.at;
  const char* start = tokenizer_.place() + 1;
  const bool isPlain = (form == Form::number || form == Form::vector) &&
                       readPlainNumbers(value.numbers.data(), countOf(form));
  if (!isPlain) {
    advance();
    start = at();
    if (!readValue(value, readOwn)) start = nullptr;
  }
  value.at = start;
  // A texture has two of these, and so has noise.
  const bool isPair = value.field->name == "materialIndex" ||
                      (value.field->name == "color" && form == Form::ownReader);
  if (!before || !start || isPair) return;
  repeats_.push_back({start, value.field->name, before});
}

bool FieldReader::readValue(Value& value, const OwnReader& readOwn) {
  const std::string_view name = value.field->name;
  const Form form = value.field->form;
  if (form == Form::ownReader) return readOwn(name);
  if (form == Form::fileName) return readFileName(name);
  if (form == Form::choice) {
    std::size_t chosen = 0;
    const bool isGood = readChoice(name, kDistributionWords, chosen);
    value.numbers[0] = double(chosen);
    return isGood;
  }
  if (form != Form::whole) {
    const bool areSingle = form == Form::single || form == Form::color;
    return readNumbers(name, value.numbers.data(), countOf(form), areSingle);
  }
  int whole = value.whole();
  const bool isGood = readWholeNumber(name, whole);
  value.numbers[0] = whole;
  return isGood;
}

// Ranges.

bool FieldReader::checkRange(const Value& value) {
  const std::string_view name = value.field->name;
  switch (value.field->range) {
    case Range::color:
      if (std::max({value.numbers[0], value.numbers[1], value.numbers[2]}) > 1) {
        brightColors_.emplace_back(value.at, name);
      }
      return true;
    case Range::reflectance:
      return checkReflectance(value);
    case Range::direction:
      if (value.vector() == Vec3d()) {
        report(value.at, "expected " + withArticle(name) + " that is not zero, found 0 0 0");
        return false;
      }
      return true;
    default:
      const std::string expected = expectedOf(value);
      if (!expected.empty()) reportFound(value.at, expected);
      return expected.empty();
  }
}

bool FieldReader::checkReflectance(const Value& value) {
  Tokenizer words(text_.from(value.at));
  for (const double component : value.numbers) {
    const char* const start = words.next().data();
    if (component >= 0 && component <= 1) continue;
    reportFound(start, std::string(value.field->name) + " from 0 to 1 in each component");
    return false;
  }
  return true;
}

// Lists.

void FieldReader::readCounted(const CountedBlock& block, const std::function<void()>& readItem,
                              const std::function<bool()>& readOther) {
  if (!openBlock(block.owner)) return;
  int expected = 0, found = 0;
  bool isSure = readCount(block, expected);
  const std::string owner(block.owner);
  const std::string says =
      std::string(block.countName) + " says " + std::to_string(expected) + ", but " + owner;
  while (!isAt('}')) {
    if (isOneOf(word_, block.items)) {
      if (isSure && found == expected) {
        report(at(), says + " goes on: expected '}', found " + quoted(word_));
        isSure = false;
      }
      readItem();
      ++found;
    } else if (atEnd() || isOneOf(word_, sectionWords())) {
      return closeBlock(block.owner);
    } else if (!readOther || !readOther()) {
      found += skipUnknown(block.owner, block.allowed);
    }
  }
  if (isSure && found < expected) {
    report(at(), says + " ends after " + std::to_string(found) + ": expected " +
                     std::to_string(expected - found) + " more, found '}'");
  }
  advance();
}

/// Reads the count at the block's start. False where there is none to rely on.
bool FieldReader::readCount(const CountedBlock& block, int& count) {
  if (block.countName.empty()) return false;
  if (!isWord(word_, block.countName)) {
    reportExpected(std::string(block.countName) + " at the start of " + std::string(block.owner));
    return false;
  }
  advance();
  const char* const start = at();
  if (!readWholeNumber(block.countName, count)) return false;
  if (count < 0) reportFound(start, "a count of at least 0 for " + std::string(block.countName));
  return count >= 0;
}
