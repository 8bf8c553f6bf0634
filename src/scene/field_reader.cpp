// Reading blocks by the tables of scene_grammar.h, and going on after a mistake.
//
// A field is found by its name: mostly it is the next one of the table, so that one is tried first.
// Its value is read by the type of the place where it goes; most are plain numbers, which are tried
// at a stretch before any word is cut. Only when the block has ended are missing fields and ranges
// looked at: of a field that is given twice the last value counts.
#include "scene/field_reader.h"

#include <algorithm>
#include <cmath>

#include "scene/decimal.h"
#include "scene/number_reader.h"

namespace {

bool isCapital(char c) { return c >= 'A' && c <= 'Z'; }

bool isOlderForm(std::string_view word, std::string_view name) {
  if (isCapital(name[0])) return false;
  std::size_t i = 0;
  for (const char c : name) {
    if (isCapital(c) && (i == word.size() || word[i++] != '_')) return false;
    if (i == word.size() || word[i++] != (isCapital(c) ? char(c - 'A' + 'a') : c)) return false;
  }
  return i == word.size();
}

/// True when `word` is `name`, or `name` as the course's older scenes write it: num_objects for
/// numObjects, which is longer, as each capital gives two letters. Names that begin with a capital
/// have only one form.
bool isWord(std::string_view word, std::string_view name) {
  return word == name || (word.size() > name.size() && isOlderForm(word, name));
}

bool isBlockWord(std::string_view word) {
  for (const WordList list : {WordList(kSectionWords), WordList(kLightWords), WordList(kGroupWords),
                              WordList(kTransformWords)}) {
    if (list.contains(word)) return true;
  }
  return false;
}

/// True for every word of the language.
bool isKnownWord(std::string_view word) {
  return isBlockWord(word) ||
         std::any_of(kFieldWords.begin(), kFieldWords.end(),
                     [&](std::string_view name) { return isWord(word, name); });
}

/// The names of all fields.
std::vector<std::string_view> namesOf(FieldLists lists) {
  std::vector<std::string_view> names;
  for (const FieldList& list : lists) {
    for (std::size_t i = 0; i < list.size; ++i) names.push_back(list.first[i].name);
  }
  return names;
}

/// True for MaterialIndex where a field is called materialIndex.
bool isCapitalised(std::string_view word, FieldLists lists) {
  const std::vector<std::string_view> names = namesOf(lists);
  return std::any_of(names.begin(), names.end(), [&](std::string_view name) {
    return word.substr(1) == name.substr(1) && word[0] == name[0] - 'a' + 'A';
  });
}

/// Where the value of a field stands; null where none was given.
const char* givenAt(FieldPlace place) {
  return std::visit([](const auto* given) { return given->at; }, place);
}

/// `vector` times the power of two that brings its largest component into [1/2, 1): the same
/// direction exactly, and its squares neither overflow nor vanish.
Vec3d rescaled(const Vec3d& vector) {
  int exponent = 0;
  std::frexp(maxAbs(vector), &exponent);
  return {std::ldexp(vector.x(), -exponent), std::ldexp(vector.y(), -exponent),
          std::ldexp(vector.z(), -exponent)};
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

// Mistakes.

void FieldReader::report(const char* place, const std::string& message) {
  ++mistakeCount_;
  if (isQuiet_ || place == lastMistakeAt_) return;
  lastMistakeAt_ = place;
  log_.add(placeOf(place), InputError(text_.name(), text_.lineAt(place), message));
}

std::string FieldReader::found() const {
  return word_.empty() ? "the end of the file" : quoted(word_);
}

std::string FieldReader::quotedAt(const char* place) const {
  return quoted(Tokenizer(text_.bytes().substr(placeOf(place))).next());
}

void FieldReader::reportExpected(const std::string& expected) {
  report(at(), "expected " + expected + ", found " + found());
}

void FieldReader::reportFound(const char* place, const std::string& expected) {
  report(place, "expected " + expected + ", found " + quotedAt(place));
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

// Values.

/// What stands behind the word, up to the text's end, is no part of the number, but lets it be read
/// eight bytes at a time.
template <class T>
bool FieldReader::readNumber(std::string_view what, T& value) {
  T found;
  const char* stop = nullptr;
  if constexpr (std::is_same_v<T, float>) {
    if (!atEnd()) stop = scanFloat(word_.data(), tokenizer_.end(), found);
  } else {
    if (!atEnd()) stop = scanDouble(word_.data(), tokenizer_.end(), found);
  }
  if (atEnd() || stop != word_.data() + word_.size()) {
    reportBadNumber(what, "a number");
    return false;
  }
  value = found;
  advance();
  return true;
}
template bool FieldReader::readNumber(std::string_view, double&);
template bool FieldReader::readNumber(std::string_view, float&);

bool FieldReader::readWholeNumber(std::string_view what, int& value) {
  if (!readInt(word_, value)) {
    reportBadNumber(what, "a whole number");
    return false;
  }
  advance();
  return true;
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

bool FieldReader::readPlainNumbers(double* values, std::size_t count) {
  const char* p = tokenizer_.place();
  for (std::size_t i = 0; i < count; ++i) {
    if (tokenizer_.end() - p <= decimal::kBytes || *p != ' ') return false;
    decimal::Decimal number;
    p = decimal::scan(p + 1, number);
    if (!p || !(*p == ' ' || *p == '\n' || *p == '\r' || *p == '}')) return false;
    if (!decimal::round(number, values[i])) return false;
  }
  tokenizer_.moveTo(p);
  lastEnd_ = p;
  word_ = tokenizer_.next();
  return true;
}

template <class T>
bool FieldReader::readVector(std::string_view what, Vec3<T>& value) {
  bool isGood = true;
  for (int axis = 0; axis < 3; ++axis) {
    const char* const before = at();
    isGood &= readNumber(what, value[axis]);
    if (at() == before) return false;
  }
  return isGood;
}

bool FieldReader::readName(std::string_view what, std::string_view& name) {
  if (atEnd() || word_ == "{" || word_ == "}") {
    reportExpected("a file name for " + std::string(what));
    return false;
  }
  name = word_;
  advance();
  return true;
}

bool FieldReader::readChoice(std::string_view what, WordChoice& choice) {
  const std::string_view* const chosen = std::find(choice.words.begin(), choice.words.end(), word_);
  if (chosen != choice.words.end()) {
    choice.index = std::size_t(chosen - choice.words.begin());
    advance();
    return true;
  }
  const std::string_view meant = nearestWord(word_, choice.words);
  report(at(), "expected " + listed(choice.words) + " for " + std::string(what) + ", found " +
                   found() + (meant.empty() ? "" : "; did you mean " + quoted(meant) + "?"));
  return false;
}

// Fields.

bool FieldReader::readFields(std::string_view owner, FieldLists lists) {
  const std::size_t mistakesBefore = mistakeCount_;
  const char* const start = at();
  if (!openBlock(owner)) return false;
  const FieldList* list = lists.begin();
  std::size_t next = 0;  // mostly they stand in order
  while (word_ != "}") {
    if (next == list->size || !isWord(word_, list->first[next].name)) {
      for (list = lists.begin(); list != lists.end(); ++list) {
        next = 0;
        while (next < list->size && !isWord(word_, list->first[next].name)) ++next;
        if (next < list->size) break;
      }
    }
    if (list != lists.end()) {
      readField(list->first[next++], list->block);
      continue;
    }
    if (atEnd() || (isAtBlock() && !isCapitalised(word_, lists))) {
      closeBlock(owner);
      return false;
    }
    skipUnknown(owner, namesOf(lists));
    list = lists.begin();
    next = 0;
  }
  advance();
  if (mistakeCount_ == mistakesBefore) reportMissing(owner, start, lists);
  return mistakeCount_ == mistakesBefore;
}

void FieldReader::reportMissing(std::string_view owner, const char* start, FieldLists lists) {
  for (const FieldList& list : lists) {
    for (std::size_t i = 0; i < list.size; ++i) {
      const Field& field = list.first[i];
      if (!field.isRequired || givenAt(field.in(list.block))) continue;
      report(start, "expected " + std::string(field.name) + " in " + std::string(owner) +
                        ", found none before its '}'");
    }
  }
}

/// Reads a field whose value is a number or three of them, written plainly; false otherwise.
bool FieldReader::readPlainField(FieldPlace place) {
  const char* const start = tokenizer_.place() + 1;
  double numbers[3];
  if (auto* const* number = std::get_if<Given<double>*>(&place)) {
    if (!readPlainNumbers(numbers, 1)) return false;
    **number = {numbers[0], start};
  } else if (auto* const* vector = std::get_if<Given<Vec3d>*>(&place)) {
    if (!readPlainNumbers(numbers, 3)) return false;
    **vector = {{numbers[0], numbers[1], numbers[2]}, start};
  } else {
    return false;
  }
  return true;
}

void FieldReader::readField(const Field& field, void* block) {
  const FieldPlace place = field.in(block);
  if (readPlainField(place)) return;
  advance();
  const char* const start = at();
  struct Reader {
    FieldReader& in;
    std::string_view name;
    bool operator()(double& value) { return in.readNumber(name, value); }
    bool operator()(float& value) { return in.readNumber(name, value); }
    bool operator()(int& value) { return in.readWholeNumber(name, value); }
    bool operator()(Vec3d& value) { return in.readVector(name, value); }
    bool operator()(Vec3f& value) { return in.readVector(name, value); }
    bool operator()(std::string_view& value) { return in.readName(name, value); }
    bool operator()(WordChoice& choice) { return in.readChoice(name, choice); }
    bool operator()(const ReadValue& read) { return read(); }
  };
  Reader reader{*this, field.name};
  std::visit([&](auto* given) { given->at = reader(given->value) ? start : nullptr; }, place);
}

// Ranges.

bool FieldReader::checkRanges(const FieldList& fields) {
  bool isGood = true;
  for (std::size_t i = 0; i < fields.size; ++i) {
    const Field& field = fields.first[i];
    if (field.range != Range::any) isGood &= checkRange(field, field.in(fields.block));
  }
  return isGood;
}

/// A field without a good value passes: that mistake is reported already.
bool FieldReader::checkRange(const Field& field, FieldPlace place) {
  const char* const start = givenAt(place);
  if (!start) return true;
  const std::string name(field.name);
  if (auto* const* color = std::get_if<Given<Vec3f>*>(&place)) {
    const Vec3f& value = (*color)->value;
    if (field.range == Range::reflectance) return checkReflectance(field.name, **color);
    if (value.r() > 1 || value.g() > 1 || value.b() > 1) brightColors_.emplace_back(start, name);
    return true;
  }
  if (auto* const* direction = std::get_if<Given<Vec3d>*>(&place)) {
    Vec3d& value = (*direction)->value;
    const bool isZero = value == Vec3d();
    if (isZero) report(start, "expected a " + name + " that is not zero, found 0 0 0");
    if (!isZero) value = rescaled(value);
    return !isZero;
  }
  auto* const* single = std::get_if<Given<float>*>(&place);
  const double value = single ? double((*single)->value) : std::get<Given<double>*>(place)->value;
  const bool mayBeZero = field.range == Range::atLeastZero;
  if (!(mayBeZero ? value >= 0 : value > 0)) {
    reportFound(start, name + (mayBeZero ? " of at least 0" : " above 0"));
    return false;
  }
  if (field.range != Range::angle || value < 180) return true;
  reportFound(start, "an angle below 180 degrees");
  return false;
}

bool FieldReader::checkReflectance(std::string_view name, const Given<Vec3f>& color) {
  Tokenizer words(text_.bytes().substr(placeOf(color.at)));
  for (int axis = 0; axis < 3; ++axis) {
    const char* const start = words.next().data();
    if (color.value[axis] >= 0 && color.value[axis] <= 1) continue;
    reportFound(start, std::string(name) + " from 0 to 1 in each component");
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
  const std::string says =
      std::string(block.countName) + " says " + std::to_string(expected) + ", but ";
  const std::string owner(block.owner);
  while (word_ != "}") {
    if (block.items.contains(word_)) {
      if (isSure && found == expected) {
        report(at(), says + owner + " goes on: expected '}', found " + quoted(word_));
        isSure = false;
      }
      readItem();
      ++found;
    } else if (atEnd() || WordList(kSectionWords).contains(word_)) {
      return closeBlock(block.owner);
    } else if (!readOther()) {
      found += skipUnknown(block.owner, block.allowed);
    }
  }
  if (isSure && found < expected) {
    report(at(), says + owner + " ends after " + std::to_string(found) + ": expected " +
                     std::to_string(expected - found) + " more, found '}'");
  }
  advance();
}

/// Reads the count at the block's start. False where there is none to rely on.
bool FieldReader::readCount(const CountedBlock& block, int& count) {
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
