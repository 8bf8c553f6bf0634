// The one place where the words behind "_child" are understood.
#include "child.h"

#include <cstdio>
#include <stdexcept>

#include "options.h"
#include "process.h"

namespace bench {

void runChild(const std::vector<std::string>& words) {
  if (words.size() == 4 && words[0] == "build") {
    measureBuildMemory(words[1], sizeNamed(words[2]).triangles, simdNamed(words[3]));
  } else if (words.size() == 5 && words[0] == "phases") {
    measurePhases(words[1], words[2], std::stoi(words[3]), simdNamed(words[4]));
  } else if (words.size() >= 2 && words[0] == "run") {
    const Run run = runProcess({words.begin() + 2, words.end()}, words[1]);
    std::printf("%.6f %.0f\n", run.seconds, run.peakBytes);
  } else {
    throw std::runtime_error("these words are for the benchmark's own use");
  }
}

}  // namespace bench
