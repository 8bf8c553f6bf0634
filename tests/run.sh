#!/bin/sh
# Builds the program and runs all tests; installs a compiler and cmake where they are missing.
# With --farm: runs the tests that render with GNU parallel and a Slurm cluster of their own.
root=$(CDPATH= cd -- "$(dirname -- "$0")/.." && pwd) || exit 1
. "$root/tests/setup.sh"

# Every script of tests/farm that is a test; one that is skipped (77) says why.
run_farm() {
  build_program --target raytracer
  status=0
  for test in parallel slurm; do
    sh "$root/tests/farm/$test.sh" "$build/raytracer" || [ $? -eq 77 ] || status=1
  done
  exit $status
}

case ${1:-} in
  '') ;;
  --farm) farm=yes ;;
  *) fail "Usage: sh tests/run.sh [--farm]" ;;
esac
install_missing
[ -z "${farm:-}" ] || run_farm
build_program
cd "$build" && exec ctest --output-on-failure
