// MistakeLog: where mistakes in an input go: the first one is thrown, or all are collected.
#pragma once
#include <cstddef>
#include <exception>
#include <vector>

#include "scene/input_error.h"

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
  void add(std::size_t place, const InputError& mistake);

  /// Everything collected, in file order.
  std::vector<InputError> inOrder() const;

 private:
  struct Entry {
    std::size_t place;
    InputError mistake;
  };
  Mode mode_;
  std::vector<Entry> mistakes_;
};
