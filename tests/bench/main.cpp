// The benchmark: raytracer_bench [row ...] [size ...] [-quick] [-single] [-cpu] [-simd NAME]
// [-against RAYTRACER].
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <string>

#include "child.h"
#include "rows.h"
#include "system/worker_threads.h"

namespace {

/// Wall-clock figures mean little where others keep the processors busy.
void printMachine(const bench::BenchOptions& options) {
  double load = 0;
  getloadavg(&load, 1);
  std::printf(
      "%d threads, %s; load before the start %.1f; %d rounds; rays and builds in seconds of "
      "%s\n",
      hardwareThreads(), nameOf(availableSimd(options.simd)), load, options.rounds,
      options.clock == bench::Clock::wall ? "the wall clock" : "processor time");
}

void runRows(const bench::BenchOptions& options) {
  printMachine(options);
  if (options.wants("rays")) bench::runRayRows(options);
  if (options.wants("build")) bench::runBuildRows(options);
  if (options.wants("read")) bench::runReadRows(options);
  if (options.wants("program")) bench::runProgramRows(options);
  if (options.wants("tiny")) bench::runTinyRows(options);
  if (options.wants("bad")) bench::runBadMeshRows(options);
  if (options.wants("png")) bench::runPngRows(options);
}

}  // namespace

int main(int count, char** words) {
  try {
    if (count > 1 && std::string(words[1]) == "_child") {
      bench::runChild({words + 2, words + count});
      return 0;
    }
    runRows(bench::parseBenchOptions(count, words));
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "raytracer_bench: %s\n", error.what());
    return 1;
  }
}
