// Prints the program's own words as dictionary entries: those of the scene language
// (`fuzz_words scene`) or the arguments (`fuzz_words options`); nothing for any other name.
#include <algorithm>
#include <cstdio>
#include <cstring>

#include "cli/arguments.h"
#include "scene/scene_grammar.h"

namespace {

void printSceneWords() {
  const auto print = [](std::string_view word) {
    std::printf("\"%.*s \"\n", int(word.size()), word.data());
  };
  const WordList lists[] = {kSectionWords,     kLightWords,    kStepWords, kGroupWords,
                            kCountWords,       kNodeStepWords, kNodeWords, kShapeTypes,
                            kNodeSectionWords, kLightTypes};
  for (const WordList& list : lists) std::for_each(list.begin(), list.end(), print);
  for (const Field& field : kFields) print(field.name);
}

void printArguments() {
  for (const ArgumentRow& row : argumentTable()) {
    std::printf("\"-%s\\x0a\"\n", row.name.c_str());
    if (!row.otherName.empty()) std::printf("\"-%s\\x0a\"\n", row.otherName.c_str());
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc == 2 && std::strcmp(argv[1], "scene") == 0) printSceneWords();
  if (argc == 2 && std::strcmp(argv[1], "options") == 0) printArguments();
}
