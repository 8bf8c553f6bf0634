// The benchmark: raytracer_bench [row ...] [size ...] [-quick] [-single] [-cpu] [-simd NAME].
#include <cstdio>
#include <exception>
#include <filesystem>

#include "rows.h"

namespace {

void runRows(const bench::BenchOptions& options) {
  if (options.wants("rays")) bench::runRayRows(options);
}

}  // namespace

int main(int count, char** words) {
  try {
    runRows(bench::parseBenchOptions(count, words));
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "raytracer_bench: %s\n", error.what());
    return 1;
  }
}
