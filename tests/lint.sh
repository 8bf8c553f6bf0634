# clang-tidy, with the checks of .clang-tidy, and cppcheck, both without a finding. To be run by
# run.sh. A suppression stands beside its reason: in .clang-tidy, in tests/cppcheck.txt, or in a
# NOLINT comment.
root=$(CDPATH= cd -- "$(dirname -- "$0")/.." && pwd) || exit 1
. "$root/tests/setup.sh"
. "$root/tests/variants.sh"

install_missing
needs clang++ clang && needs clang-tidy clang-tidy && needs cppcheck cppcheck ||
  fail 'clang++, clang-tidy and cppcheck are needed.'
start_report lint
folder=$build/lint
(cd "$folder" && cmake -DCMAKE_CXX_COMPILER=clang++ -DCMAKE_EXPORT_COMPILE_COMMANDS=ON \
  "$root") >"$folder/configure.log" || fail "Could not configure $folder."

# The files given, or all: first those that were changed last would be no help, so by name.
if [ $# -eq 0 ]; then set -- $(find "$root/src" -name '*.cpp' | sort); fi
if printf '%s\n' "$@" | xargs -P "$(count_jobs)" -n 4 clang-tidy --quiet -p "$folder" \
  --warnings-as-errors='*' 2>"$folder/tidy.log"; then
  say clean "clang-tidy: $# files"
else
  say FAILED 'clang-tidy'
fi
if cppcheck --quiet --std=c++17 --language=c++ --enable=warning,performance,portability \
  --inline-suppr --suppressions-list="$root/tests/cppcheck.txt" --error-exitcode=1 \
  -I "$root/include" -I "$root/src" "$root/src"; then
  say clean 'cppcheck: src and include'
else
  say FAILED 'cppcheck'
fi
end_report
