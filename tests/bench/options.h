// What the benchmark is asked to do.
#pragma once
#include <string>
#include <vector>

#include "accel/compiled_scene.h"
#include "measure.h"

namespace bench {

struct Size {
  std::string name;  ///< "70k", "1m" or "10m"
  double triangles;
};

struct BenchOptions {
  std::vector<std::string> rows;  ///< of kRows in options.cpp; never empty
  std::vector<Size> sizes;        ///< never empty
  int rounds = 5;
  int side = 1024;            ///< of the picture of rays
  bool isSingleOnly = false;  ///< leave out our streams
  Clock clock = Clock::wall;  ///< of the rows rays and build
  SimdLevel simd = SimdLevel::automatic;
  std::string against;  ///< path of another build of the program, which takes turns; or ""

  bool wants(const std::string& row) const;
};

/// These throw std::runtime_error for a word that they do not know.
Size sizeNamed(const std::string& name);
SimdLevel simdNamed(const std::string& name);
BenchOptions parseBenchOptions(int count, char** words);

}  // namespace bench
