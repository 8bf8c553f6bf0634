# The same pictures from every compiler, optimisation, library, instruction set and processor that
# can be had here: builds the program for each and compares with tests/golden.txt. Run by run.sh.
#
#   sh tests/run.sh --portability [NAMES]   all, or e.g. g++-O0 clang++-libc++ s390x musl refusals
#
# Processors other than this machine's are Debian's cross compilers and qemu-user; static, so that
# nothing else is needed. Each combination gives a line: ok, differs, FAILED (it cannot be built, or
# a test fails), or left out and why; the last line counts them. Status 1 where any differs or failed.
root=$(CDPATH= cd -- "$(dirname -- "$0")/.." && pwd) || exit 1
. "$root/tests/setup.sh"
. "$root/tests/variants.sh"

wanted=" $* "
is_wanted() {
  [ "$wanted" = '  ' ] || case $wanted in *" $1 "*) ;; *) false ;; esac
}

# compare NAME ARGUMENTS: the pictures of the variant NAME.
compare() {
  name=$1
  shift
  log=$build/portability/$name/golden.log
  began=$(date +%s)
  sh "$root/tests/golden.sh" check "$build/portability/$name/raytracer" "$@" >"$log" 2>&1
  case $? in
    0) say ok "$name $*: $(grep -c . "$root/tests/golden.txt") pictures, $(since "$began")" ;;
    77) say 'left out' "$name $*: no sha256sum here" ;;
    *)
      say differs "$name $*: $(grep -c '^+' "$log") of $(grep -c . "$root/tests/golden.txt") pictures"
      cat "$log"
      ;;
  esac
}

since() {
  echo "$(($(date +%s) - $1)) s"
}

# build NAME CMAKE_ARGUMENTS: the program; with all tests where $target says so.
target=raytracer
build() {
  name=$1
  shift
  echo "building $name"
  variant "portability/$name" "$target" -DCMAKE_BUILD_TYPE=Release "$@" && return 0
  say FAILED "$name: the build"
  return 1
}

# all_tests NAME: all but the pictures, which compare() does, and what an emulator cannot do.
all_tests() {
  log=$build/portability/$1/tests.log
  began=$(date +%s)
  excluded=$(sed 's/[[:space:]]*#.*//' "$root/tests/not_emulated.txt" | grep . | paste -s -d '|')
  if (cd "$build/portability/$1" && ctest -j"$(count_jobs)" -E "^($excluded)\$") >"$log" 2>&1; then
    say ok "$1 tests: $(grep -c ' Passed ' "$log") passed, $(since "$began")"
  else
    say FAILED "$1 tests"
    sed -n '/tests passed/,$p' "$log"
  fi
}

# Few and many threads, and each instruction set, are the same program: four runs do.
compare_levels() {
  compare "$1" -threads 1 -simd baseline
  compare "$1" -threads 3 -simd avx2
  compare "$1" -threads 64 -simd avx512
  compare "$1"
}

# native NAME COMPILER FLAGS
native() {
  is_wanted "$1" || return 0
  build "$1" -DCMAKE_CXX_COMPILER="$2" -DCMAKE_CXX_FLAGS_RELEASE="$3" && compare_levels "$1"
}

# The last asks for fused multiply-adds wherever the processor has them: CMakeLists.txt forbids it.
natives() {
  native "$1-O0" "$1" -O0
  native "$1-O2" "$1" '-O2 -DNDEBUG'
  native "$1-O3" "$1" '-O3 -DNDEBUG'
  native "$1-native" "$1" '-O3 -DNDEBUG -march=native -ffp-contract=fast'
}

every_thread_count() {
  for threads in 1 2 4 5 8 16 32 64; do compare "$1" -threads $threads; done
}

other_library() {
  is_wanted clang++-libc++ || return 0
  if ! (echo '#include <vector>' | clang++ -stdlib=libc++ -x c++ -fsyntax-only - 2>/dev/null) &&
    ! install libc++-dev libc++abi-dev >/dev/null 2>&1
  then
    say 'left out' 'clang++-libc++: no libc++-dev here'
    return
  fi
  native clang++-libc++ clang++ '-O2 -DNDEBUG -stdlib=libc++'
}

# A compiler x86_64-linux-musl-g++, or one made of Debian's packages.
musl() {
  is_wanted musl || return 0
  compiler=x86_64-linux-musl-g++
  if ! have $compiler; then
    made=$build/portability/musl-compiler
    mkdir -p "$made"
    needs musl-gcc musl-tools "gcc-$(g++ -dumpversion)-source"
    echo 'building libstdc++ for musl'
    sh "$root/tests/tools/musl_compiler.sh" "$made" >"$made/build.log" 2>&1 || {
      say 'left out' "musl: $(tail -n 1 "$made/build.log")"
      return
    }
    compiler=$made/bin/$compiler
  fi
  build musl -DCMAKE_CXX_COMPILER="$compiler" -DCMAKE_EXE_LINKER_FLAGS=-static &&
    compare_levels musl
}

# cross NAME TRIPLE QEMU DEBIAN_NAME WHAT FLAGS: WHAT is raytracer, or all for the tests too. The
# emulator is left away where the program runs without, as 32-bit programs mostly do here.
cross() {
  is_wanted "$1" || return 0
  if ! needs "$2-g++" "g++-$2" "libc6-dev-$4-cross" || ! needs "qemu-$3-static" qemu-user-static
  then
    say 'left out' "$1: no $2-g++ or qemu-$3-static here"
    return
  fi
  target=$5
  build "$1" -DCMAKE_SYSTEM_NAME=Linux -DCMAKE_SYSTEM_PROCESSOR="${2%%-*}" \
    -DCMAKE_CXX_COMPILER="$2-g++" -DCMAKE_CXX_FLAGS="$6" -DCMAKE_EXE_LINKER_FLAGS=-static \
    -DCMAKE_CROSSCOMPILING_EMULATOR="$(command -v "qemu-$3-static")"
  built=$?
  target=raytracer
  [ $built -eq 0 ] || return
  runner=qemu-$3-static
  "$build/portability/$1/raytracer" -version >/dev/null 2>&1 && runner=
  RUNNER=$runner compare "$1" -threads 2
  [ "$5" != all ] || all_tests "$1"
}

# refuses NAME MESSAGE CMAKE_ARGUMENTS: no build comes of them, and the message says why.
refuses() {
  name=$1
  message=$2
  shift 2
  tried=$build/portability/refusals
  rm -rf "$tried"
  if variant portability/refusals raytracer -DBUILD_TESTING=OFF "$@" 2>/dev/null; then
    say FAILED "$name: was built"
  elif ! tr -s ' \n' '  ' <"$tried/build.log" | grep -q -e "$message"; then
    say FAILED "$name: refused, but without the words '$message'"
  else
    say ok "$name: refused"
  fi
}

# What CMake does not see, the header refuses: a compiler that has such options of its own.
header_refuses() {
  if echo '#include "math/arithmetic.h"' | $1 -std=c++17 -x c++ -fsyntax-only \
    -I "$root/include" - 2>&1 | grep -q -e "$2"
  then
    say ok "math/arithmetic.h with $1: refused"
  else
    say FAILED "math/arithmetic.h with $1: not refused with the words '$2'"
  fi
}

refusals() {
  is_wanted refusals || return 0
  for compiler in g++ clang++; do
    have $compiler || continue
    for option in -ffast-math -Ofast -funsafe-math-optimizations -ffinite-math-only; do
      refuses "$compiler $option" "$option would change the pictures" \
        -DCMAKE_CXX_COMPILER=$compiler -DCMAKE_CXX_FLAGS=$option
    done
    header_refuses "$compiler -ffast-math" 'build without -ffast-math'
    header_refuses "$compiler -Ofast" 'build without -ffast-math'
  done
  refuses 'g++ -mfpmath=387' 'sums and products must be rounded' \
    -DCMAKE_CXX_COMPILER=g++ -DCMAKE_CXX_FLAGS=-mfpmath=387
  if needs i686-linux-gnu-g++ g++-i686-linux-gnu libc6-dev-i386-cross; then
    refuses 'i686 with x87' 'sums and products must be rounded' \
      -DCMAKE_CXX_COMPILER=i686-linux-gnu-g++
  else
    say 'left out' 'i686 with x87: no i686-linux-gnu-g++ here'
  fi
}

install_missing
start_report portability
refusals
for compiler in g++ clang++; do
  case $compiler in g++) package=g++ ;; *) package=clang ;; esac
  if needs $compiler $package; then natives $compiler; else say 'left out' "$compiler: not here"; fi
done
is_wanted g++-O3 && have g++ && every_thread_count g++-O3
# One program of one piece, in which the linker chooses among the copies of inline functions.
have g++ && native g++-lto g++ '-O2 -DNDEBUG -flto'
# The vectors for processors that have neither SSE2 nor AVX, here where they are quick to run.
is_wanted g++-vectors && have g++ &&
  build g++-vectors -DCMAKE_CXX_COMPILER=g++ -DCMAKE_CXX_FLAGS=-U__SSE2__ &&
  compare g++-vectors -simd baseline
if have clang++; then other_library; else say 'left out' 'clang++-libc++: no clang++ here'; fi
musl
cross s390x s390x-linux-gnu s390x s390x all ''
cross aarch64 aarch64-linux-gnu aarch64 arm64 all ''
cross armhf arm-linux-gnueabihf arm armhf raytracer ''
cross riscv64 riscv64-linux-gnu riscv64 riscv64 raytracer ''
cross i686-sse2 i686-linux-gnu i386 i386 raytracer '-msse2 -mfpmath=sse'
end_report
