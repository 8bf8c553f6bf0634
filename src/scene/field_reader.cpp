// Numbers and fields of a scene file.
#include <algorithm>

#include "scene/block_reader.h"
#include "scene/number_reader.h"
#include "scene/quick_decimal.h"
#include "scene/scene_words.h"

namespace {

/// Read a number that is the whole of `word`. What stands behind it, up to `end`, is no part of a
/// number, but lets numbers be read eight bytes at a time.
bool readAny(std::string_view word, const char* end, double& value) {
  double found;
  if (word.empty() || scanDouble(word.data(), end, found) != word.data() + word.size())
    return false;
  value = found;
  return true;
}
bool readAny(std::string_view word, const char* end, float& value) {
  float found;
  if (word.empty() || scanFloat(word.data(), end, found) != word.data() + word.size()) return false;
  value = found;
  return true;
}

/// True for MaterialIndex where a field is called materialIndex.
bool isCapitalised(std::string_view word, const Field* first, const Field* last) {
  return std::any_of(first, last, [&](const Field& field) {
    return word.substr(1) == field.name.substr(1) && word[0] == field.name[0] - 'a' + 'A';
  });
}

}  // namespace

template <class T>
bool BlockReader::readNumberOf(std::string_view what, T& value) {
  if (!readAny(word_, text_.bytes().data() + text_.bytes().size(), value)) {
    reportBadNumber(what, "a number");
    return false;
  }
  advance();
  return true;
}

bool BlockReader::readNumber(std::string_view what, double& value) {
  return readNumberOf(what, value);
}
bool BlockReader::readNumber(std::string_view what, float& value) {
  return readNumberOf(what, value);
}

bool BlockReader::readWholeNumber(std::string_view what, int& value) {
  if (!readInt(word_, value)) {
    reportBadNumber(what, "a whole number");
    return false;
  }
  advance();
  return true;
}

/// Reports the current word, which should be a number, and passes over it unless it plainly
/// belongs to what comes next.
void BlockReader::reportBadNumber(std::string_view what, const std::string& kind) {
  const std::string range = isNumber(word_) && kind == "a number" ? " within range" : "";
  reportExpected(kind + range + " for " + std::string(what));
  if (word_ == "{") {
    skipBlock();
  } else if (!atEnd() && word_ != "}" && !isKnownWord(word_)) {
    advance();
  }
}

bool BlockReader::readPlainNumbers(double* values, int count) {
  const char* p = tokenizer_.place();
  for (int i = 0; i < count; ++i) {
    if (tokenizer_.end() - p <= kQuickBytes || *p != ' ') return false;
    QuickDecimal number;
    p = scanQuickly(p + 1, number);
    if (!p || !(*p == ' ' || *p == '\n' || *p == '\r' || *p == '}')) return false;
    if (!toDouble(number, values[i])) return false;
  }
  tokenizer_.moveTo(p);
  lastEnd_ = p;
  word_ = tokenizer_.next();
  return true;
}

bool BlockReader::readFields(std::string_view owner, FieldList fields) {
  const std::size_t mistakesBefore = mistakeCount_;
  const char* const start = at();
  if (!openBlock(owner)) return false;
  Field* const end = fields.first + fields.size;
  Field* expected = fields.first;
  while (word_ != "}") {
    Field* field = expected;  // mostly they stand in order
    if (field == end || !isWord(word_, field->name)) {
      field =
          std::find_if(fields.first, end, [&](const Field& f) { return isWord(word_, f.name); });
    }
    if (field != end) {
      readField(*field);
      expected = field + 1;
    } else if (atEnd() || (isBlockWord(word_) && !isCapitalised(word_, fields.first, end))) {
      closeBlock(owner);
      return false;
    } else {
      skipUnknownField(owner, fields);
    }
  }
  advance();
  if (mistakeCount_ > mistakesBefore) return false;
  for (const Field* field = fields.first; field != fields.first + fields.size; ++field) {
    if (!field->isRequired || field->at) continue;
    report(start, "expected " + std::string(field->name) + " in " + std::string(owner) +
                      ", found none before its '}'");
  }
  return mistakeCount_ == mistakesBefore;
}

/// Reads a field whose value is a number or three of them, written plainly; false otherwise.
bool BlockReader::readPlainField(Field& field) {
  const char* const place = tokenizer_.place() + 1;
  double numbers[3];
  if (double* const* number = std::get_if<double*>(&field.target)) {
    if (!readPlainNumbers(numbers, 1)) return false;
    **number = numbers[0];
  } else if (Vec3d* const* vector = std::get_if<Vec3d*>(&field.target)) {
    if (!readPlainNumbers(numbers, 3)) return false;
    **vector = {numbers[0], numbers[1], numbers[2]};
  } else {
    return false;
  }
  field.at = place;
  return true;
}

void BlockReader::readField(Field& field) {
  if (readPlainField(field)) return;
  advance();
  const char* const place = at();
  struct Reader {
    BlockReader& in;
    std::string_view name;
    bool operator()(double* value) { return in.readNumber(name, *value); }
    bool operator()(float* value) { return in.readNumber(name, *value); }
    bool operator()(int* value) { return in.readWholeNumber(name, *value); }
    bool operator()(Vec3d* value) { return in.readVector(name, *value); }
    bool operator()(Vec3f* value) { return in.readVector(name, *value); }
    bool operator()(std::string_view* value) { return in.readName(name, *value); }
    bool operator()(const WordChoice& choice) { return in.readChoice(name, choice); }
    bool operator()(const std::function<bool()>* read) { return (*read)(); }
  };
  field.at = std::visit(Reader{*this, field.name}, field.target) ? place : nullptr;
}

bool BlockReader::readName(std::string_view what, std::string_view& name) {
  if (atEnd() || word_ == "{" || word_ == "}") {
    reportExpected("a file name for " + std::string(what));
    return false;
  }
  name = word_;
  advance();
  return true;
}

bool BlockReader::readChoice(std::string_view what, const WordChoice& choice) {
  const std::string_view* const chosen = std::find(choice.words.begin(), choice.words.end(), word_);
  if (chosen != choice.words.end()) {
    *choice.index = std::size_t(chosen - choice.words.begin());
    advance();
    return true;
  }
  const std::string_view meant = nearestWord(word_, choice.words);
  report(at(), "expected " + listed(choice.words) + " for " + std::string(what) + ", found " +
                   found() + (meant.empty() ? "" : "; did you mean " + quoted(meant) + "?"));
  return false;
}

void BlockReader::skipUnknownField(std::string_view owner, FieldList fields) {
  std::string_view names[16];
  const std::size_t count = fields.size < 16 ? fields.size : 16;
  for (std::size_t i = 0; i < count; ++i) names[i] = fields.first[i].name;
  skipUnknown(owner, WordList(names, count));
}
