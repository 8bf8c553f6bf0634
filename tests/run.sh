#!/bin/sh
# Builds the program and runs all tests; installs a compiler and cmake where they are missing.
#   sh tests/run.sh                      all tests
#   sh tests/run.sh --numbers [SCENES]   so many random scenes (500) against long double
#   sh tests/run.sh --fuzz [SECONDS]     each fuzz target for so long (60), where clang has libFuzzer
root=$(CDPATH= cd -- "$(dirname -- "$0")/.." && pwd) || exit 1
. "$root/tests/setup.sh"

install_missing
if [ "${1:-}" = --numbers ]; then
  build_program --target unit_tests
  RAYTRACER_NUMBERS=${2:-500} exec "$build/unit_tests" long_double_test
fi
if [ "${1:-}" = --fuzz ]; then
  . "$root/tests/fuzz/fuzz.sh"
  fuzz_all "${2:-60}"
fi
build_program
cd "$build" && exec ctest --output-on-failure
