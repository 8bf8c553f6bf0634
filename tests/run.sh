#!/bin/sh
# Builds the program and runs all tests; installs a compiler and cmake where they are missing.
#
#   sh tests/run.sh                      the ordinary tests
#   sh tests/run.sh --numbers [SCENES]   so many random scenes (500) against long double
#   sh tests/run.sh --fuzz [SECONDS]     each fuzz target for so long (60), where clang has libFuzzer
#   sh tests/run.sh --portability        the same pictures from other compilers and processors
#   sh tests/run.sh --sanitize           the tests under ASan and UBSan, TSan and valgrind
#   sh tests/run.sh --lint               clang-tidy and cppcheck
#   sh tests/run.sh --coverage           lines and branches that the tests run
#   sh tests/run.sh --farm               renders with GNU parallel and on a Slurm cluster of its own
root=$(CDPATH= cd -- "$(dirname -- "$0")/.." && pwd) || exit 1
. "$root/tests/setup.sh"

# Every script of tests/farm that is a test; one that is skipped (77) says why.
run_farm() {
  status=0
  for test in parallel slurm; do
    sh "$root/tests/farm/$test.sh" "$build/raytracer" || [ $? -eq 77 ] || status=1
  done
  exit $status
}

mode=${1:-}
[ $# -eq 0 ] || shift
case $mode in
  '')
    install_missing
    with_tests=yes
    build_program
    cd "$build" && exec ctest --output-on-failure -j"$(count_jobs)"
    ;;
  --numbers)
    install_missing
    with_tests=yes
    build_program --target unit_tests
    RAYTRACER_NUMBERS=${1:-500} exec "$build/unit_tests" long_double_test
    ;;
  --fuzz)
    install_missing
    . "$root/tests/fuzz/fuzz.sh"
    fuzz_all "${1:-60}"
    exit
    ;;
  --farm)
    install_missing
    build_program --target raytracer
    run_farm
    ;;
  --portability | --sanitize | --lint | --coverage)
    exec sh "$root/tests/${mode#--}.sh" "$@"
    ;;
esac
sed -n '2,/^root/s/^# \{0,1\}//p' "$0" >&2
exit 2
