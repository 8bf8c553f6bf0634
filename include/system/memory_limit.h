// A limit on the memory of the whole process, whatever it is used for.
#pragma once
#include <cstddef>

/// From now on, asking for memory that would take the process above `bytes` fails: `new` and
/// PageBuffer throw std::bad_alloc, and a thread whose stack does not fit is not started. Counted
/// is what the process may write to, used or only reserved: its data, heap, mappings and stacks
/// (but the first thread's), not its code. A stricter limit that holds already stays. Never lifted
/// again. Throws std::system_error where the system refuses.
void limitMemory(std::size_t bytes);
