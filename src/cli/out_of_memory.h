// OutOfMemory: ends a run, and says what memory was wanted for.
#pragma once
#include <new>
#include <stdexcept>
#include <string>

class OutOfMemory : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Returns work(); where memory runs out, throws OutOfMemory with `purpose`, "to ...".
template <class Work>
auto withMemory(const std::string& purpose, const Work& work) {
  try {
    return work();
  } catch (const std::bad_alloc&) {
    throw OutOfMemory("not enough memory " + purpose);
  }
}
