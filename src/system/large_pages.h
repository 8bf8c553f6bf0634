// Large pages: asking the system for fewer, larger pages of memory that is yet to be filled.
#pragma once
#include <cstddef>

/// Says that `bytes` bytes from `memory` on will be filled soon. Changes nothing but the time that
/// takes: the pages touched are fewer (filling 38 MB by one thread took 0.7 of the time).
void preferLargePages(const void* memory, std::size_t bytes);
