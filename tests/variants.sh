# Builds of the program other than the ordinary one, each in a folder of its own under build/. To be
# read by a POSIX shell script after setup.sh.

# needs PROGRAM PACKAGES: whether PROGRAM can be run, once the packages are installed.
needs() {
  program_needed=$1
  shift
  have "$program_needed" || { install "$@" >/dev/null 2>&1 && have "$program_needed"; }
}

# variant FOLDER TARGET CMAKE_ARGUMENTS: builds a target in build/FOLDER. What the compiler says is
# in build.log there; its end is shown where it fails.
variant() {
  folder=$build/$1
  target=$2
  shift 2
  mkdir -p "$folder" || return 1
  have make || set -- -G Ninja "$@"
  (cd "$folder" && cmake -DBUILD_TESTING=ON "$@" "$root" &&
    cmake --build . --target "$target" -- -j"$(count_jobs)") \
    >"$folder/build.log" 2>&1 && return 0
  tail -n 20 "$folder/build.log" >&2
  return 1
}

# say RESULT WHAT: a line of the report, and of its end.
say() {
  printf '%-10s %s\n' "$1" "$2" | tee -a "$report"
}

start_report() {
  report=$build/$1/report.txt
  mkdir -p "$build/$1" && : >"$report"
}

# Shows the report again, with a last line that counts, and ends the script: status 1 where
# anything failed or differs.
end_report() {
  printf '\n'
  cat "$report"
  failed=$(grep -c -e '^FAILED' -e '^differs' "$report")
  left_out=$(grep -c '^left out' "$report")
  passed=$(($(grep -c . "$report") - failed - left_out))
  echo "$passed passed, $failed failed, $left_out skipped"
  [ "$failed" -eq 0 ]
  exit $?
}
