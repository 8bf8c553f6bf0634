// Fields: the values of one block, found by their names.
//
// The table of scene_grammar.h has a row for each field of each block; a block's values are those
// of its own rows and of the rows that it shares with others, in the languages that are read, with
// their defaults until something is given.
#include <algorithm>

#include "scene/field_reader.h"

namespace {

bool isCapital(char c) { return c >= 'A' && c <= 'Z'; }

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
    const Field* row = std::begin(kFields);
    while (row->block != block) ++row;
    for (; row != std::end(kFields) && row->block == block; ++row) {
      if (isIn(row->languages, language)) values_.at(count_++) = {row, row->defaults, nullptr};
    }
  }
}

bool Fields::has(std::string_view name) const {
  return std::any_of(begin(), end(), [&](const Value& v) { return v.field->name == name; });
}

const Value& Fields::operator[](std::string_view name) const {
  const Value* value = begin();
  while (value->field->name != name) ++value;
  return *value;
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
