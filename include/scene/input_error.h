// InputError: a mistake in a scene or mesh file, and MistakeLog, where such mistakes go: the first
// one is thrown, to be caught once, in main; or all are collected, for -check.
#pragma once
#include <cstddef>
#include <exception>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

class InputError : public std::runtime_error {
 public:
  /// `line` counts from 1; 0 means the file as a whole. `message` says what was expected and what
  /// was found. what() is "FILE:LINE: message", or "FILE: message" without a line.
  InputError(const std::string& file, std::size_t line, const std::string& message)
      : std::runtime_error(file + (line > 0 ? ":" + std::to_string(line) : "") + ": " + message),
        file_(file),
        line_(line) {}

  const std::string& getFile() const { return file_; }
  /// Counted from 1; 0 where the file as a whole is meant.
  std::size_t getLine() const { return line_; }

 private:
  std::string file_;
  std::size_t line_;
};

class MistakeLog {
 public:
  enum class Mode { throwFirst, collect };
  /// Thrown by add() when so many mistakes are collected that reading on makes no sense.
  class Full : public std::exception {};
  static constexpr std::size_t kCapacity = 100;

  explicit MistakeLog(Mode mode) : mode_(mode) {}

  Mode mode() const { return mode_; }
  std::size_t count() const { return mistakes_.size(); }

  /// Throws `mistake`, or keeps it; `place` says where in the scene file it belongs, in bytes.
  void add(std::size_t place, const InputError& mistake) {
    // A copy that finds no memory throws bad_alloc in its place.
    if (mode_ == Mode::throwFirst) throw mistake;  // NOLINT(cert-err60-cpp)
    mistakes_.emplace(place, mistake);
    if (mistakes_.size() >= kCapacity) throw Full();
  }

  /// Everything collected, in file order.
  std::vector<InputError> inOrder() const {
    std::vector<InputError> mistakes;
    for (const auto& [place, mistake] : mistakes_) mistakes.push_back(mistake);
    return mistakes;
  }

 private:
  Mode mode_;
  std::multimap<std::size_t, InputError> mistakes_;  // by place
};
