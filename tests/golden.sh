#!/bin/sh
# Compares the pictures of a program with tests/golden.txt, or writes that list anew.
#
#   sh tests/golden.sh check PROGRAM [ARGUMENTS]   e.g. -threads 3 -simd baseline
#   sh tests/golden.sh write PROGRAM
#
# Each line of the list is a SHA-256 and what it is of: a scene of scenes/ and its arguments. It is
# that of all files of the run one after the other, in the order of their names. RUNNER, where set,
# comes before the program, e.g. RUNNER=qemu-aarch64-static. Exit status 0 where all are equal, 1
# where any differs, 77 without sha256sum.
root=$(CDPATH= cd -- "$(dirname -- "$0")/.." && pwd) || exit 1
. "$root/tests/scene_arguments.sh"
list=$root/tests/golden.txt
size='-size 96 72'

# The scenes as their comments say, but smaller; then option sets, a scene and its arguments a line.
cases() {
  for scene in "$root"/scenes/*.txt "$root"/scenes/courses/*.txt; do
    name=${scene#"$root/scenes/"}
    echo "${name%.txt} $(arguments_of "$scene")$size"
  done
  sed "s/ / $size /" "$root/tests/golden_options.txt"
}

# hash_of SCENE ARGUMENTS: the hash of what the program writes; nothing where it fails.
hash_of() {
  scene=$root/scenes/$1.txt
  shift
  rm -rf "$work/files" && mkdir "$work/files" || exit 1
  # $RUNNER is a list of words.
  (cd "$work/files" && $RUNNER "$program" -input "$scene" -output out.tga "$@" -quiet) >&2 || return
  (set +f && cat "$work"/files/* >"$work/all") && sha256sum <"$work/all" | cut -c 1-64
}

# Reads cases, writes lines of the list. The cases are lists of words, none a pattern.
hash_all() {
  set -f
  while read -r case; do
    hash=$(hash_of $case $extra </dev/null)
    echo "${hash:-failed} $case"
  done
}

mode=$1
program=$2
case $mode:$program in
  check:/* | write:/*) ;;
  check:?* | write:?*) program=$PWD/$program ;;
  *)
    sed -n '2,/^root/s/^# \{0,1\}//p' "$0" >&2
    exit 2
    ;;
esac
shift 2
extra=$*
command -v sha256sum >/dev/null || {
  echo 'sha256sum is not there: nothing compared' >&2
  exit 77
}
LC_ALL=C
export LC_ALL
work=$(mktemp -d "${TMPDIR:-/tmp}/golden.XXXXXX") || exit 1
trap 'rm -rf "$work"' EXIT
trap 'exit 1' INT TERM
cases >"$work/cases" || exit 1
hash_all <"$work/cases" >"$work/found"
if [ "$mode" = write ]; then
  cp "$work/found" "$list"
  grep '^failed' "$list" && exit 1
  echo "$(wc -l <"$list") hashes written to $list"
  exit 0
fi
# The lines expected begin with -, those found with +.
diff -U 0 "$list" "$work/found" | sed -n '/^[-+][0-9a-f]/p' >"$work/differences"
if [ -s "$work/differences" ]; then
  echo 'The pictures are not those of tests/golden.txt (expected -, found +):'
  cat "$work/differences"
  exit 1
fi
echo "$(wc -l <"$list") pictures are those of tests/golden.txt"
