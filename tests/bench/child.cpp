// The one place where the words behind "_child" are understood.
#include "child.h"

#include <stdexcept>

#include "options.h"

namespace bench {

void runChild(const std::vector<std::string>& words) {
  if (words.size() == 4 && words[0] == "build") {
    measureBuildMemory(words[1], sizeNamed(words[2]).triangles, simdNamed(words[3]));
  } else if (words.size() == 5 && words[0] == "phases") {
    measurePhases(words[1], words[2], std::stoi(words[3]), simdNamed(words[4]));
  } else {
    throw std::runtime_error("these words are for the benchmark's own use");
  }
}

}  // namespace bench
