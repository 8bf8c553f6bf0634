// Recognising the words of the scene language.
#include "scene/scene_words.h"

#include <algorithm>

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

}  // namespace

bool isWord(std::string_view word, std::string_view name) {
  // An older form is the longer one, as each capital gives two letters.
  return word == name || (word.size() > name.size() && isOlderForm(word, name));
}

bool isBlockWord(std::string_view word) {
  for (const WordList list : {WordList(kSectionWords), WordList(kLightWords), WordList(kGroupWords),
                              WordList(kTransformWords)}) {
    if (list.contains(word)) return true;
  }
  return false;
}

bool isKnownWord(std::string_view word) {
  const WordList fields(kFieldWords);
  return isBlockWord(word) || std::any_of(fields.begin(), fields.end(), [&](std::string_view name) {
           return isWord(word, name);
         });
}
