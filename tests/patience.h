// What a slow build, under a sanitizer or an emulator, is spared (the CMake variable PATIENCE).
#pragma once

/// How many times as long as in an ordinary build something may take.
inline constexpr double kPatience = TEST_PATIENCE;

/// How many of `cases` random cases to try: all, or the first tenth where the build is slow.
constexpr int casesFor(int cases) { return kPatience > 1 ? (cases + 9) / 10 : cases; }
