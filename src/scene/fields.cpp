// Fields: the values of one block, found by their names, and how they are read.
//
// The table of scene_grammar.h has a row for each field of each block; a block's values are those
// of its own rows and of the rows that it shares with others, in the languages that are read, with
// their defaults until something is given. Only when the block has ended are missing fields and
// ranges looked at: of a field that is given twice the last value counts.
#include <algorithm>

#include "scene/field_reader.h"

namespace {

bool isCapital(char c) { return c >= 'A' && c <= 'Z'; }

/// True for MaterialIndex where a field is called materialIndex.
bool isCapitalised(std::string_view word, const Fields& fields) {
  return std::any_of(fields.begin(), fields.end(), [&](const Value& value) {
    const std::string_view name = value.field->name;
    return word.substr(1) == name.substr(1) && word[0] == name[0] - 'a' + 'A';
  });
}

}  // namespace

bool isWord(std::string_view word, std::string_view name) {
  if (word.size() <= name.size() || isCapital(name[0])) return word == name;
  std::string olderForm;
  for (const char c : name) {
    if (isCapital(c)) olderForm += '_';
    olderForm += isCapital(c) ? char(c - 'A' + 'a') : c;
  }
  return word == olderForm;
}

Fields::Fields(Language language, std::initializer_list<std::string_view> blocks) {
  for (const std::string_view block : blocks) {
    const Field* field = std::begin(kFields);
    while (field->block != block) ++field;
    for (; field != std::end(kFields) && field->block == block; ++field) {
      if (!isIn(field->languages, language)) continue;
      values_.at(count_++) = {field, field->defaults, nullptr};
    }
  }
}

bool Fields::has(std::string_view meaning) const {
  return std::any_of(begin(), end(), [&](const Value& v) { return v.field->meaning == meaning; });
}

Value Fields::operator[](std::string_view meaning) const {
  const auto isMeant = [&](const Field& field) { return field.meaning == meaning; };
  for (const Value& value : *this) {
    if (isMeant(*value.field)) return value;
  }
  const Field* const other = std::find_if(std::begin(kFields), std::end(kFields), isMeant);
  return {other, other->defaults, nullptr};
}

Value* Fields::find(std::string_view word, Value* next) {
  if (next != end() && next->field->name == word) return next;
  return std::find_if(begin(), end(),
                      [&](const Value& value) { return isWord(word, value.field->name); });
}

std::vector<std::string_view> Fields::names() const {
  std::vector<std::string_view> names;
  for (const Value& value : *this) names.push_back(value.field->name);
  return names;
}

Languages Fields::languagesOfField(std::string_view name) const {
  Languages languages = 0;
  for (const Field& field : kFields) {
    const auto isOfBlock = [&](const Value& value) { return value.field->block == field.block; };
    if (field.name == name && std::any_of(begin(), end(), isOfBlock)) languages |= field.languages;
  }
  return languages;
}

// Reading them.

Fields FieldReader::readFields(std::string_view owner,
                               std::initializer_list<std::string_view> blocks,
                               const OwnReader& readOwn, const char* start) {
  Fields fields(language_, blocks);
  const std::size_t mistakesBefore = mistakeCount_;
  const char* const place = start ? start : at();
  if (!start && !openBlock(owner)) return fields;
  const bool isWhole = readNames(owner, fields, readOwn);
  if (isWhole && mistakeCount_ == mistakesBefore) reportMissing(owner, place, fields);
  fields.areGood = isWhole && mistakeCount_ == mistakesBefore;
  for (const Value& value : fields) {
    const bool isLimited = value.at && value.field->range != Range::any;
    if (isLimited) fields.areGood &= checkRange(value);
  }
  return fields;
}

/// Reads fields up to the block's }, and takes that. False where the block does not end so.
bool FieldReader::readNames(std::string_view owner, Fields& fields, const OwnReader& readOwn) {
  for (Value* next = fields.begin(); !isAt('}');) {
    if (Value* const value = fields.find(word_, next); value != fields.end()) {
      readField(*value, readOwn);
      next = value + 1;
    } else if (const Languages languages = fields.languagesOfField(word_)) {
      skipUnknown(owner, fields.names(), languages);
    } else if (atEnd() || (isAtBlock() && !isCapitalised(word_, fields))) {
      closeBlock(owner);
      return false;
    } else {
      skipUnknown(owner, fields.names());
    }
  }
  advance();
  return true;
}

void FieldReader::reportMissing(std::string_view owner, const char* start, const Fields& fields) {
  for (const Value& value : fields) {
    if (value.field->isOptional || value.at) continue;
    report(start, "expected " + std::string(value.field->name) + " in " + std::string(owner) +
                      ", found none before its '}'");
  }
}
