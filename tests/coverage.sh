# Prints the lines and branches of scene/, image/ and cli/ that the tests run, as clang counts them,
# and fails below 95 % of the lines of each and 90 % of the branches of all. To be run by run.sh.
root=$(CDPATH= cd -- "$(dirname -- "$0")/.." && pwd) || exit 1
. "$root/tests/setup.sh"
. "$root/tests/variants.sh"

# The table of llvm-cov for all files: name, functions, missed, share, lines, missed, share, branches,
# missed, share.
report_all() {
  llvm-cov report -show-branch-summary -show-region-summary=false -instr-profile="$folder/all" \
    "$folder/unit_tests" -object "$folder/raytracer" >"$folder/table.txt"
}

# share_of KIND ROOMS: the percentage of lines or branches run, over all files of the rooms, which
# are separated by |.
share_of() {
  awk -v kind="$1" -v rooms="(src|include)/($2)/" '$1 ~ rooms && $1 !~ /tests\// {
    all += kind == "lines" ? $5 : $8
    missed += kind == "lines" ? $6 : $9
  }
  END { if (all) printf "%.2f", 100 * (all - missed) / all }' "$folder/table.txt"
}

# at_least LIMIT SHARE WHAT
at_least() {
  if awk -v limit="$1" -v share="$2" 'BEGIN { exit !(share >= limit) }'; then
    say enough "$2 % $3 (at least $1)"
  else
    say FAILED "$2 % $3 (at least $1)"
  fi
}

install_missing
needs clang++ clang && needs llvm-cov llvm || fail 'clang++ and llvm-cov are needed.'
start_report coverage
counting='-fprofile-instr-generate -fcoverage-mapping -mllvm -runtime-counter-relocation'
variant coverage all -DCMAKE_CXX_COMPILER=clang++ -DCMAKE_BUILD_TYPE=Release -DPATIENCE=30 \
  -DCMAKE_CXX_FLAGS_RELEASE="-O1 $counting" || exit 1
folder=$build/coverage
find "$folder" -maxdepth 1 -name '*.profraw' -exec rm -f {} +
# A file for each process: one that several share is lost to all when a full disk cuts it off, as
# tests do. %c: the counters are the file's memory, so that what runs before a signal or in its
# handler counts.
LLVM_PROFILE_FILE=$folder/%c%p.profraw
export LLVM_PROFILE_FILE
# A test that limits the size of files keeps its profile from being written, and reads a message
# about it: whether all tests pass is told by the ordinary run.
(cd "$folder" && ctest --output-on-failure) || say note 'not all tests passed'
unset LLVM_PROFILE_FILE
find "$folder" -maxdepth 1 -name '*.profraw' -size +0 >"$folder/profiles.txt"
llvm-profdata merge -sparse -failure-mode=all -input-files="$folder/profiles.txt" \
  -o "$folder/all" || exit 1
report_all
grep -E '(src|include)/(scene|image|cli)/' "$folder/table.txt"
for room in scene image cli; do
  at_least 95 "$(share_of lines $room)" "of the lines of $room/"
done
at_least 90 "$(share_of branches 'scene|image|cli')" 'of the branches of all three'
end_report
