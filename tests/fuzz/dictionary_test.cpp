// The dictionaries of the fuzz targets keep up with the words of the program.
#include "check.h"
#include "cli/option_table.h"
#include "run_program.h"
#include "scene/scene_words.h"

namespace {

/// Checks that `word` stands in an entry of the dictionary: behind a quote, or behind a dash.
void checkWord(const std::string& dictionary, const std::string& word) {
  bool found = false;
  for (const char* before : {"\"", "\"-", "{ ", " "}) {
    for (const char* after : {"\"", " ", "\\x0a"})
      found |= dictionary.find(before + word + after) != std::string::npos;
  }
  check::report(found, __FILE__, __LINE__, "the dictionary has '" + word + "'");
}

std::string dictionary(const std::string& name) {
  return check::contentOf(check::testsFolder() + "/fuzz/dictionaries/" + name + ".dict");
}

}  // namespace

TEST("the dictionary for scenes has every word of the scene language") {
  const std::string text = dictionary("scene");
  const WordList lists[] = {kSectionWords, kLightWords,     kMaterialWords,
                            kGroupWords,   kTransformWords, kFieldWords};
  for (const WordList& list : lists) {
    for (const std::string_view word : list) checkWord(text, std::string(word));
  }
}

TEST("the dictionary for arguments has every argument") {
  const std::string text = dictionary("options");
  for (const OptionRow& row : optionTable()) {
    checkWord(text, row.name);
    if (row.otherName) checkWord(text, row.otherName);
  }
}
