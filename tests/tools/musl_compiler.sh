#!/bin/sh
# Makes a C++ compiler for musl out of Debian's packages g++, musl-tools and gcc-12-source.
#
#   sh tests/tools/musl_compiler.sh FOLDER    makes FOLDER/bin/x86_64-linux-musl-g++
#
# musl-tools has a C compiler alone, and a C++ library belongs to the C library that it was made
# for. So libstdc++ is made here, from the sources of the very g++ that compiles, in a minute or
# two; it stays in FOLDER. Programs are to be linked with -static.
root=$(CDPATH= cd -- "$(dirname -- "$0")/../.." && pwd) || exit 1
folder=$1
specs=/usr/lib/x86_64-linux-musl/musl-gcc.specs
version=$(g++ -dumpfullversion) || exit 1
archive=$(echo /usr/src/gcc-"${version%%.*}"/gcc-"$version"*.tar.xz)
[ -x "$folder/bin/x86_64-linux-musl-g++" ] && exit 0
[ -f "$specs" ] && [ -f "$archive" ] || {
  echo "no $specs or no $archive" >&2
  exit 77
}

# compiler NAME COMMAND: a command of its own for a compiler with options.
compiler() {
  printf '#!/bin/sh\nexec %s "$@" -specs %s\n' "$2" "$specs" >"$folder/bin/$1" &&
    chmod +x "$folder/bin/$1"
}

# Without the threads that libgcc would be configured for there is no std::mutex; they are there in
# every program for musl, so that no symbol needs to be weak.
unpack() {
  mkdir -p "$folder/source" "$folder/work" "$folder/bin" && cd "$folder/source" &&
    tar xJf "$archive" --strip-components=1 --wildcards \
      --exclude='*/libstdc++-v3/testsuite/*/*' '*/libstdc++-v3' '*/libgcc' '*/config' \
      '*/include' '*/libbacktrace' '*/libiberty' '*/gcc/BASE-VER' '*/gcc/DEV-PHASE' \
      "gcc-$version/config*" "gcc-$version/m*" "gcc-$version/lt*" "gcc-$version/libtool*" \
      '*/install-sh' '*/symlink-tree' '*/depcomp' '*/compile' &&
    date +%Y%m%d >gcc/DATESTAMP && cp libgcc/gthr-posix.h libgcc/gthr-default.h &&
    sed -i '1i #define GTHREAD_USE_WEAK 0' libgcc/gthr.h
}

# The unwinder of libgcc asks for _dl_find_object, which only glibc has.
build_library() {
  cd "$folder/work" &&
    ../source/libstdc++-v3/configure --build=x86_64-linux-gnu --host=x86_64-linux-musl \
      --prefix="$folder" --disable-multilib --disable-shared --disable-nls --disable-werror \
      --disable-libstdcxx-pch --disable-libstdcxx-dual-abi CFLAGS=-O2 CXXFLAGS=-O2 \
      CC="$folder/bin/c-compiler" CXX="$folder/bin/bare-compiler" &&
    make -j"$(nproc)" SUBDIRS='include libsupc++ src' install &&
    "$folder/bin/c-compiler" -O2 -c "$root/tests/tools/find_object.c" -o find_object.o &&
    ar r "$folder/lib/libstdc++.a" find_object.o
}

unpack && compiler c-compiler gcc && compiler bare-compiler g++ && build_library || exit 1
headers=$folder/include/c++/$version
rm -rf "$folder/source" "$folder/work"
compiler x86_64-linux-musl-g++ "g++ -nostdinc++ -I$headers -I$headers/x86_64-linux-musl \
-L$folder/lib -Wl,--eh-frame-hdr -Wl,--undefined=_dl_find_object"
