// SourceText: the bytes of one input file, and which line each of them stands on.
#pragma once
#include <cstddef>
#include <string>
#include <string_view>

class SourceText {
 public:
  /// Holds `bytes` under the name that messages call them by.
  SourceText(std::string name, std::string bytes)
      : name_(std::move(name)), bytes_(std::move(bytes)) {}

  /// Reads the whole of `filename`; "-" is standard input. Throws InputError, without a line,
  /// where that cannot be done.
  static SourceText read(const std::string& filename);

  const std::string& name() const { return name_; }
  std::string_view bytes() const { return bytes_; }

  /// The line, counted from 1, of a place inside or at the end of the bytes. Time proportional
  /// to what stands before it: for messages only.
  std::size_t lineAt(const char* place) const;

 private:
  std::string name_;
  std::string bytes_;
};
