# The same pictures from every compiler, optimisation, instruction set and processor that can be had
# here: builds the program for each and compares with tests/golden.txt. To be run by run.sh.
#
#   sh tests/run.sh --portability [NAMES]   all, or e.g. g++-O0 clang++-libc++ s390x
#
# Processors other than this machine's are Debian's cross compilers and qemu-user; static, so that
# nothing else is needed. What cannot be installed is left out, and said so.
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
  if sh "$root/tests/golden.sh" check "$build/portability/$name/raytracer" "$@"; then
    say same "$name $*"
  else
    say FAILED "$name $*"
  fi
}

# build NAME CMAKE_ARGUMENTS
build() {
  name=$1
  shift
  echo "building $name"
  variant "portability/$name" raytracer -DBUILD_TESTING=OFF -DCMAKE_BUILD_TYPE=Release "$@" &&
    return 0
  say FAILED "$name: the build"
  return 1
}

# Few and many threads, and each instruction set, are the same program: three runs do.
compare_levels() {
  compare "$1" -threads 1 -simd baseline
  compare "$1" -threads 3 -simd avx2
  compare "$1" -threads 64 -simd avx512
}

# native NAME COMPILER FLAGS
native() {
  is_wanted "$1" || return 0
  build "$1" -DCMAKE_CXX_COMPILER="$2" -DCMAKE_CXX_FLAGS_RELEASE="$3" && compare_levels "$1"
}

natives() {
  native "$1-O0" "$1" -O0
  native "$1-O2" "$1" '-O2 -DNDEBUG'
  native "$1-O3" "$1" '-O3 -DNDEBUG'
  native "$1-native" "$1" '-O3 -DNDEBUG -march=native'
}

every_thread_count() {
  for threads in 1 2 4 5 8 16 32 64; do compare "$1" -threads $threads; done
}

other_library() {
  is_wanted clang++-libc++ || return 0
  libcxx=$(echo '#include <vector>' | clang++ -stdlib=libc++ -x c++ -fsyntax-only - 2>&1) ||
    install libc++-dev libc++abi-dev >/dev/null 2>&1 || {
    say 'left out' 'clang++-libc++: no libc++-dev here'
    return
  }
  native clang++-libc++ clang++ '-O2 -DNDEBUG -stdlib=libc++'
}

# A static program of another C library needs a C++ library that was built for it, which Debian
# does not have: musl-tools is a C compiler alone. A cross compiler for musl is used where it is.
musl() {
  is_wanted musl || return 0
  if have x86_64-linux-musl-g++; then
    build musl -DCMAKE_CXX_COMPILER=x86_64-linux-musl-g++ -DCMAKE_EXE_LINKER_FLAGS=-static &&
      compare_levels musl
  else
    say 'left out' 'musl: no x86_64-linux-musl-g++ (musl-tools of Debian has no C++ library)'
  fi
}

# cross PROCESSOR TRIPLE QEMU
cross() {
  is_wanted "$1" || return 0
  if ! needs "$2-g++" "g++-$2" "libc6-dev-$4-cross" || ! needs "qemu-$3-static" qemu-user-static
  then
    say 'left out' "$1: no $2-g++ or qemu-$3-static here"
    return
  fi
  build "$1" -DCMAKE_SYSTEM_NAME=Linux -DCMAKE_SYSTEM_PROCESSOR="$1" \
    -DCMAKE_CXX_COMPILER="$2-g++" -DCMAKE_EXE_LINKER_FLAGS=-static || return
  RUNNER=qemu-$3-static compare "$1" -threads 2
}

install_missing
start_report portability
cross aarch64 aarch64-linux-gnu aarch64 arm64
cross s390x s390x-linux-gnu s390x s390x
cross armhf arm-linux-gnueabihf arm armhf
cross riscv64 riscv64-linux-gnu riscv64 riscv64
for compiler in g++ clang++; do
  case $compiler in g++) package=g++ ;; *) package=clang ;; esac
  if needs $compiler $package; then natives $compiler; else say 'left out' "$compiler: not here"; fi
done
is_wanted g++-O3 && have g++ && every_thread_count g++-O3
# The vectors for processors that have neither SSE2 nor AVX, here where they are quick to run.
is_wanted g++-vectors && have g++ &&
  build g++-vectors -DCMAKE_CXX_COMPILER=g++ -DCMAKE_CXX_FLAGS=-U__SSE2__ &&
  compare g++-vectors -simd baseline
if have clang++; then other_library; else say 'left out' 'clang++-libc++: no clang++ here'; fi
musl
end_report
