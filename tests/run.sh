#!/bin/sh
# Builds the program and runs all tests; installs a compiler and cmake where they are missing.
#
#   sh tests/run.sh                 the ordinary tests
#   sh tests/run.sh --portability   the same pictures from other compilers and processors
#   sh tests/run.sh --sanitize      the tests under ASan and UBSan, TSan and valgrind
#   sh tests/run.sh --lint          clang-tidy and cppcheck
#   sh tests/run.sh --coverage      lines and branches that the tests run
root=$(CDPATH= cd -- "$(dirname -- "$0")/.." && pwd) || exit 1
. "$root/tests/setup.sh"

case ${1:-} in
  --portability | --sanitize | --lint | --coverage)
    mode=${1#--}
    shift
    exec sh "$root/tests/$mode.sh" "$@"
    ;;
  ?*)
    sed -n 's/^# \{0,1\}//p' "$0" >&2
    exit 2
    ;;
esac

install_missing
build_program
cd "$build" && exec ctest --output-on-failure
