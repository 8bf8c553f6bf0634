# Installs what a build needs where it is missing, and builds. To be read by a POSIX shell script
# that has set `root` to the folder with CMakeLists.txt; the build goes to $build.

build=$root/build

fail() {
  printf '%s\n' "$1" >&2
  exit 1
}

have() {
  command -v "$1" >/dev/null 2>&1
}

# The package of the compiler that is wanted, where it is missing. CXX may carry options.
missing_compiler() {
  case ${CXX:-} in
    '') have c++ || have g++ || have clang++ || printf ' g++' ;;
    clang++ | clang++\ *) have clang++ || printf ' clang' ;;
    *) have "${CXX%% *}" || printf ' g++' ;;
  esac
}

missing_packages() {
  missing_compiler
  have cmake || printf ' cmake'
  have make || have ninja || printf ' make'
}

# install PACKAGES: with apt-get, as root or by sudo; false, with a reason, where that cannot be.
install() {
  have apt-get || { echo "Please install: $*" >&2 && return 1; }
  as_root=
  if [ "$(id -u)" -ne 0 ]; then
    have sudo || { echo "Please install (as root: apt-get install $*)" >&2 && return 1; }
    as_root=sudo
  fi
  echo "installing $*"
  # $as_root is a list of words.
  $as_root env DEBIAN_FRONTEND=noninteractive apt-get -q -y update ||
    echo 'The package lists could not be renewed; going on with the old ones.' >&2
  $as_root env DEBIAN_FRONTEND=noninteractive \
    apt-get -q -y install --no-install-recommends "$@"
}

install_missing() {
  packages=$(missing_packages)
  [ -n "$packages" ] || return 0
  # $packages is a list of words.
  install $packages || fail "Could not install$packages."
}

# Each room as one file, which takes half the time; with the tests where the script that reads this
# has set `with_tests`.
configure() {
  set -- -DCMAKE_BUILD_TYPE=Release -DRAYTRACER_UNITY=ON "$root"
  [ -z "${with_tests:-}" ] || set -- -DBUILD_TESTING=ON "$@"
  have make || set -- -G Ninja "$@"
  (cd "$build" && cmake "$@") >"$build/configure.log" 2>&1
}

forget_build() {
  rm -rf "$build/CMakeCache.txt" "$build/CMakeFiles" "$build/tests/CMakeFiles"
}

# A build folder that was made by another compiler, or for a project that has been moved since, is
# made anew.
configure_afresh_if_needed() {
  if [ -f "$build/compiler.txt" ] && [ "$(cat "$build/compiler.txt")" != "${CXX:-}" ]; then
    forget_build
  fi
  configure || { forget_build && configure; } || {
    cat "$build/configure.log" >&2
    fail "Could not configure the build in $build."
  }
  printf '%s\n' "${CXX:-}" >"$build/compiler.txt"
}

# One for each core, but no more than memory holds compilers, of up to half a gigabyte each.
count_jobs() {
  jobs=$(nproc 2>/dev/null || getconf _NPROCESSORS_ONLN 2>/dev/null || echo 1)
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
  configure_afresh_if_needed
  cmake --build "$build" "$@" -- -j"$(count_jobs)" || fail 'Could not build the program.'
}
