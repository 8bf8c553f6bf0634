// Bytes: the content of a file, and the error of one that cannot be read as a picture.
#pragma once
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

using Bytes = std::vector<std::uint8_t>;

/// A picture that cannot be read. what() is "FILE: message"; the message says what was expected
/// and what was found.
class ImageError : public std::runtime_error {
 public:
  ImageError(const std::string& file, const std::string& message)
      : std::runtime_error(file + ": " + message) {}
};

/// The whole content of a file; a pipe is read to its end, but no further than 1 GiB, a
/// device no further than 64 MB. Throws ImageError.
Bytes readBytes(const std::string& path);
