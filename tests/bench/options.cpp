// The benchmark's own words.
#include "options.h"

#include <algorithm>
#include <stdexcept>

namespace bench {
namespace {

const std::vector<std::string> kRows = {"rays", "build", "read", "program", "tiny", "bad", "png"};
const std::vector<Size> kSizes = {{"70k", 70e3}, {"1m", 1e6}, {"10m", 10e6}};

/// Takes the name of a row or a size; false for any other word.
bool addWord(const std::string& word, BenchOptions& options) {
  if (std::find(kRows.begin(), kRows.end(), word) != kRows.end()) {
    options.rows.push_back(word);
    return true;
  }
  if (word.empty() || word[0] == '-') return false;
  options.sizes.push_back(sizeNamed(word));
  return true;
}

}  // namespace

Size sizeNamed(const std::string& name) {
  for (const Size& size : kSizes) {
    if (size.name == name) return size;
  }
  throw std::runtime_error(
      "expected a row (rays, build, read, program, tiny, bad, png) or a size (70k, 1m, "
      "10m), found " +
      name);
}

SimdLevel simdNamed(const std::string& name) {
  for (const SimdLevel level :
       {SimdLevel::automatic, SimdLevel::baseline, SimdLevel::avx2, SimdLevel::avx512}) {
    if (name == nameOf(level)) return level;
  }
  throw std::runtime_error("expected auto, baseline, avx2 or avx512, found " + name);
}

bool BenchOptions::wants(const std::string& row) const {
  return std::find(rows.begin(), rows.end(), row) != rows.end();
}

BenchOptions parseBenchOptions(int count, char** words) {
  BenchOptions options;
  for (int i = 1; i < count; ++i) {
    const std::string word = words[i];
    if (addWord(word, options)) continue;
    if (word == "-quick") {
      options.rounds = 3;
      options.side = 512;
    } else if (word == "-single") {
      options.isSingleOnly = true;
    } else if (word == "-cpu") {
      options.clock = Clock::processor;
    } else if (word == "-simd" && i + 1 < count) {
      options.simd = simdNamed(words[++i]);
    } else if (word == "-against" && i + 1 < count) {
      options.against = words[++i];
    } else {
      throw std::runtime_error(
          "usage: raytracer_bench [rays|build|read|program|tiny|bad|png ...] [70k|1m|10m ...] "
          "[-quick] [-single] [-cpu] [-simd NAME] [-against RAYTRACER]");
    }
  }
  if (options.rows.empty()) options.rows = kRows;
  if (options.sizes.empty()) options.sizes = kSizes;
  return options;
}

}  // namespace bench
