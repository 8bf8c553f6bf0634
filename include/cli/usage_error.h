// UsageError: a mistake in the command line.
#pragma once
#include <stdexcept>

/// what() says what was expected and what was found.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};
