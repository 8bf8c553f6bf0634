# Builds the fuzz targets and runs each for a while. To be read by a POSIX shell script that has
# read tests/setup.sh.

fuzz_targets='scene picture obj tga png bmp netpbm options'
fuzz_build=$build/fuzz

# The first clang that comes with libFuzzer and the sanitizers; nothing where there is none.
find_fuzz_compiler() {
  mkdir -p "$fuzz_build" || exit 1
  echo 'extern "C" int LLVMFuzzerTestOneInput(const char*, unsigned long) { return 0; }' \
    >"$fuzz_build/probe.cpp"
  for compiler in clang++ clang++-19 clang++-18 clang++-17 clang++-16 clang++-15 clang++-14; do
    if have "$compiler" && "$compiler" -fsanitize=fuzzer,address,undefined \
      "$fuzz_build/probe.cpp" -o "$fuzz_build/probe" >/dev/null 2>&1; then
      echo "$compiler"
      return
    fi
  done
}

# A compiler other than the last one needs a new build folder: CMake would forget all but that.
build_fuzzers() {
  [ "$(cat "$fuzz_build/compiler.txt" 2>/dev/null)" = "$1" ] ||
    rm -rf "$fuzz_build/CMakeCache.txt" "$fuzz_build/CMakeFiles"
  echo "$1" >"$fuzz_build/compiler.txt"
  set -- -S "$root" -B "$fuzz_build" -DCMAKE_CXX_COMPILER="$1" -DBUILD_TESTING=ON -DRAYTRACER_FUZZ=ON
  [ -f "$fuzz_build/CMakeCache.txt" ] || have make || set -- -G Ninja "$@"
  cmake "$@" >"$fuzz_build/configure.log" 2>&1 || {
    cat "$fuzz_build/configure.log" >&2
    fail "Could not configure the build in $fuzz_build."
  }
  cmake --build "$fuzz_build" --target fuzzers -- -j"$(count_jobs)" >"$fuzz_build/build.log" 2>&1 ||
    {
      cat "$fuzz_build/build.log" >&2
      fail 'Could not build the fuzz targets.'
    }
}

# run_fuzzer NAME SECONDS: the dictionary is what is kept here and the program's own words. Inputs
# that lead somewhere new are kept in the build folder, and are where the next run begins. An input
# may take 5 seconds and 512 MB.
run_fuzzer() {
  name=$1 seconds=$2 inputs=$root/tests/fuzz
  mkdir -p "$fuzz_build/found/$name" "$fuzz_build/findings"
  set -- "$fuzz_build/found/$name"
  for folder in "$inputs/corpus/$name" "$inputs/regressions/$name"; do
    [ ! -d "$folder" ] || set -- "$@" "$folder"
  done
  {
    [ ! -f "$inputs/dictionaries/$name.dict" ] || cat "$inputs/dictionaries/$name.dict"
    "$fuzz_build/fuzz_words" "$name"
  } >"$fuzz_build/$name.dict"
  [ ! -s "$fuzz_build/$name.dict" ] || set -- -dict="$fuzz_build/$name.dict" "$@"
  TMPDIR=$fuzz_build ASAN_OPTIONS=quarantine_size_mb=64 "$fuzz_build/fuzz_$name" \
    -max_total_time="$seconds" -timeout=5 -rss_limit_mb=512 -max_len=4096 -print_final_stats=1 \
    -artifact_prefix="$fuzz_build/findings/$name-" "$@" >"$fuzz_build/$name.log" 2>&1 </dev/null
  echo $? >"$fuzz_build/$name.status"
}

# report_fuzzer NAME SECONDS: fails where there was a finding.
report_fuzzer() {
  count=$(sed -n 's/^stat::number_of_executed_units: *//p' "$fuzz_build/$1.log")
  if [ "$(cat "$fuzz_build/$1.status")" -eq 0 ]; then
    echo "fuzz $1: $2 s, ${count:-0} inputs, no finding"
    return 0
  fi
  tail -n 60 "$fuzz_build/$1.log" >&2
  echo "fuzz $1: a finding after ${count:-?} inputs; $fuzz_build/$1.log says where it is kept" >&2
  return 1
}

# fuzz_all SECONDS: as many targets at once as there are cores. Exit status 1 where there was a
# finding, 77 where nothing could be run.
fuzz_all() {
  case $1 in '' | *[!0-9]*) fail "--fuzz: expected a number of seconds, found '$1'" ;; esac
  compiler=$(find_fuzz_compiler)
  if [ -z "$compiler" ]; then
    echo 'There is no clang++ with libFuzzer here (Debian: clang); fuzzing is left out.'
    exit 77
  fi
  echo "fuzzing with $compiler, $1 s for each of: $fuzz_targets"
  build_fuzzers "$compiler"
  at_once=$(count_jobs) running=0
  for name in $fuzz_targets; do
    run_fuzzer "$name" "$1" &
    running=$((running + 1))
    if [ "$running" -ge "$at_once" ]; then
      wait
      running=0
    fi
  done
  wait
  findings=0
  for name in $fuzz_targets; do report_fuzzer "$name" "$1" || findings=1; done
  exit "$findings"
}
