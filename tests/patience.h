// How many times as long as in an ordinary build something may take: sanitizers and emulators are
// slow (the CMake variable PATIENCE).
#pragma once

inline constexpr double kPatience = TEST_PATIENCE;
