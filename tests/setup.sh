# Installs what a build needs where it is missing, and builds. To be read by a POSIX shell script
# that has set `root` to the folder with CMakeLists.txt; afterwards the build is in $build.

build=$root/build

fail() {
  printf '%s\n' "$1" >&2
  exit 1
}

have() {
  command -v "$1" >/dev/null 2>&1
}

have_compiler() {
  if [ -n "${CXX:-}" ]; then
    # CXX may carry options: the first word is the compiler.
    have "${CXX%% *}" || fail "CXX is set to '$CXX', which is not there."
    return 0
  fi
  have c++ || have g++ || have clang++
}

missing_packages() {
  have_compiler || printf ' g++'
  have cmake || printf ' cmake'
  have make || have ninja || printf ' make'
}

install_missing() {
  packages=$(missing_packages) || exit 1
  [ -n "$packages" ] || return 0
  have apt-get || fail "Please install$packages and run this again."
  as_root=
  if [ "$(id -u)" -ne 0 ]; then
    have sudo || fail "Please install$packages (as root: apt-get install$packages) and try again."
    as_root=sudo
  fi
  echo "installing$packages"
  # $as_root and $packages are lists of words.
  $as_root env DEBIAN_FRONTEND=noninteractive apt-get -q -y update &&
    $as_root env DEBIAN_FRONTEND=noninteractive \
      apt-get -q -y install --no-install-recommends $packages ||
    fail "Could not install$packages."
  # Without recommended packages a compiler may come without the C library's headers.
  hash -r
}

# A build folder that another source folder or compiler made is made anew; nothing else is there.
forget_foreign_build() {
  cache=$build/CMakeCache.txt
  [ -f "$cache" ] || return 0
  made_for=$(sed -n 's/^CMAKE_HOME_DIRECTORY:INTERNAL=//p' "$cache")
  made_in=$(sed -n 's/^CMAKE_CACHEFILE_DIR:INTERNAL=//p' "$cache")
  made_with=$(sed -n 's/^CMAKE_CXX_COMPILER:[A-Z]*=//p' "$cache")
  made_with_command=$(cat "$build/compiler.txt" 2>/dev/null)
  same_folder "$made_for" "$root" && same_folder "$made_in" "$build" &&
    [ -x "$made_with" ] && [ "$made_with_command" = "${CXX:-}" ] && return 0
  rm -rf "$build/CMakeCache.txt" "$build/CMakeFiles"
}

same_folder() {
  [ -d "$1" ] && [ "$(cd "$1" && pwd -P)" = "$(cd "$2" && pwd -P)" ]
}

count_jobs() {
  jobs=$(nproc 2>/dev/null || getconf _NPROCESSORS_ONLN 2>/dev/null || echo 1)
  # A compiler takes up to half a gigabyte.
  memory=$(sed -n 's/^MemAvailable: *\([0-9]*\) kB/\1/p' /proc/meminfo 2>/dev/null)
  if [ -n "$memory" ] && [ "$memory" -lt $((jobs * 500000)) ]; then
    jobs=$((memory / 500000))
  fi
  [ "$jobs" -ge 1 ] || jobs=1
  echo "$jobs"
}

# build_program [--target NAME]: builds everything, or one target, in Release mode.
build_program() {
  mkdir -p "$build" || exit 1
  forget_foreign_build
  (cd "$build" && cmake -DCMAKE_BUILD_TYPE=Release "$root" >configure.log 2>&1) || {
    cat "$build/configure.log" >&2
    fail "Could not configure the build in $build."
  }
  printf '%s\n' "${CXX:-}" >"$build/compiler.txt"
  cmake --build "$build" "$@" -- -j"$(count_jobs)" || fail "Could not build the program."
}
