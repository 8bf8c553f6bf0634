#!/bin/sh
# Builds the program and runs all tests; installs a compiler and cmake where they are missing.
root=$(CDPATH= cd -- "$(dirname -- "$0")/.." && pwd) || exit 1
. "$root/tests/setup.sh"

install_missing
build_program
cd "$build" && exec ctest --output-on-failure
