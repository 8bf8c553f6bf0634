# The tests under tools that find mistakes no test sees: ASan with UBSan, TSan, valgrind. To be run
# by run.sh.
#
#   sh tests/run.sh --sanitize [address] [thread] [valgrind]     all three, or those named
root=$(CDPATH= cd -- "$(dirname -- "$0")/.." && pwd) || exit 1
. "$root/tests/setup.sh"
. "$root/tests/variants.sh"

# sanitized NAME SANITIZERS: builds everything with them; the first finding ends a program.
sanitized() {
  echo "building sanitize/$1"
  variant "sanitize/$1" all -DCMAKE_BUILD_TYPE=Release -DPATIENCE=30 \
    -DCMAKE_CXX_FLAGS_RELEASE="-O1 -g -fno-omit-frame-pointer $2" && return 0
  say FAILED "$1: the build"
  return 1
}

# all_tests NAME: the whole suite.
all_tests() {
  if (cd "$build/sanitize/$1" && ctest --output-on-failure -j"$(count_jobs)"); then
    say clean "$1: the suite"
  else
    say FAILED "$1: the suite"
  fi
}

# Memory, and everything that the language leaves undefined, conversions of floats out of range too.
address() {
  sanitized address \
    '-fsanitize=address,undefined,float-cast-overflow -fno-sanitize-recover=all' || return
  ASAN_OPTIONS=detect_leaks=1:strict_string_checks=1:detect_stack_use_after_return=1
  UBSAN_OPTIONS=print_stacktrace=1
  export ASAN_OPTIONS UBSAN_OPTIONS
  all_tests address
}

# Threads: the suite, and a scene of every kind of work with 1 to 16 of them.
thread() {
  sanitized thread '-fsanitize=thread' || return
  # Without a pause at the end, which would let every signal look slow. A thread that a signal's end
  # does not wait for is no leak.
  TSAN_OPTIONS=halt_on_error=1:atexit_sleep_ms=0:report_thread_leaks=0
  export TSAN_OPTIONS
  all_tests thread
  picture=$build/sanitize/thread/out.tga
  for threads in 1 2 3 4 8 16; do
    for scene in 14_meshes 25_textures_in_textures 20_still_life; do
      "$build/sanitize/thread/raytracer" -input "$root/scenes/$scene.txt" -output "$picture" \
        -size 48 36 -threads $threads -transparent_shadows -adaptive_samples 1 4 0.1 &&
        "$build/sanitize/thread/raytracer" -input "$root/scenes/$scene.txt" -stats -size 48 36 \
          -threads $threads -grid 20 20 20 >"$build/sanitize/thread/stats.txt" ||
        say FAILED "thread: $scene with $threads threads"
    done
  done
  say clean 'thread: 3 scenes with 1 to 16 threads, where nothing else is said'
}

# Values that were never set, which no sanitizer of g++ finds. Slow: the rooms one by one, those that
# end within half a minute. Left out, too, are tests that measure memory or ask which instructions
# there are, those of long double, which valgrind takes for double, and those that fork beside other
# threads, whose memory the child has lost. A thread that runs when a signal ends the program is no
# leak.
valgrind_tests() {
  needs valgrind valgrind || { say 'left out' 'valgrind: not here'; return; }
  echo 'building sanitize/valgrind'
  variant sanitize/valgrind all -DCMAKE_BUILD_TYPE=Release \
    -DCMAKE_CXX_FLAGS_RELEASE='-O1 -g' || { say FAILED 'valgrind: the build' && return; }
  while read -r unit; do
    status=0
    valgrind --quiet --error-exitcode=99 --leak-check=full --errors-for-leak-kinds=definite \
      "$build/sanitize/valgrind/unit_tests" "$unit" || status=$?
    case $status in
      0) say clean "valgrind: $unit" ;;
      77) say 'left out' "valgrind: $unit, none of which runs here" ;;
      *) say FAILED "valgrind: $unit" ;;
    esac
  done <"$root/tests/valgrind_units.txt"
}

install_missing
start_report sanitize
for tool in ${*:-address thread valgrind}; do
  case $tool in
    address | thread) $tool ;;
    valgrind) valgrind_tests ;;
    *) fail "no such tool: $tool" ;;
  esac
done
end_report
