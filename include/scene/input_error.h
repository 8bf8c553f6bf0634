// InputError: a mistake in a scene or mesh file. Thrown by scene/, caught once, in main.
#pragma once
#include <cstddef>
#include <stdexcept>
#include <string>

class InputError : public std::runtime_error {
 public:
  /// `line` counts from 1; 0 means the file as a whole. `message` says what was expected and what
  /// was found. what() is "FILE:LINE: message", or "FILE: message" without a line.
  InputError(const std::string& file, std::size_t line, const std::string& message)
      : std::runtime_error(file + (line > 0 ? ":" + std::to_string(line) : "") + ": " + message),
        file_(file),
        line_(line) {}

  const std::string& getFile() const { return file_; }
  std::size_t getLine() const { return line_; }

 private:
  std::string file_;
  std::size_t line_;
};
