// The text of an input file: read whole (SourceText), told by lines, and cut into words
// (Tokenizer).
#pragma once
#include <cstddef>
#include <string>
#include <string_view>

/// Stores everything in `filename` (a regular file, a FIFO, or a device that ends) in `bytes` and
/// returns true. Otherwise returns false and says in `reason` why, without the file's name. Waits
/// for the writer of a FIFO. Memory grows with the bytes that arrive, never with a size that was
/// only declared; throws std::bad_alloc where it does not hold them.
bool readWholeFile(const std::string& filename, std::string& bytes, std::string& reason);

/// The bytes of one input file, and which line each of them stands on.
class SourceText {
 public:
  /// Holds `bytes` under the name that messages call them by.
  SourceText(std::string name, std::string bytes)
      : name_(std::move(name)), bytes_(std::move(bytes)) {}

  /// Reads the whole of `filename`; "-" is standard input, which stays open. Throws InputError,
  /// without a line, where that cannot be done.
  static SourceText read(const std::string& filename);

  const std::string& name() const { return name_; }
  std::string_view bytes() const { return bytes_; }
  /// How many bytes stand before a place inside or at the end of the bytes; and those from there
  /// on.
  std::size_t offsetOf(const char* place) const { return std::size_t(place - bytes_.data()); }
  std::string_view from(const char* place) const { return bytes().substr(offsetOf(place)); }

  /// The line, counted from 1, of such a place. Time proportional to what stands before it: for
  /// messages only.
  std::size_t lineAt(const char* place) const;

 private:
  std::string name_;
  std::string bytes_;
};

/// Cuts a scene file into words, without copying any. White space separates words; a brace is a
/// word of its own wherever it stands; a # or // where a word would begin starts a comment that
/// runs to the end of the line.
class Tokenizer {
 public:
  /// `bytes` must outlive the tokenizer and its words. A UTF-8 byte-order mark is passed over.
  explicit Tokenizer(std::string_view bytes);

  /// The next word, a view into the bytes; an empty view at their end, and ever after.
  std::string_view next();

  /// Where the last word ends.
  const char* place() const { return place_; }
  const char* end() const { return end_; }
  /// Goes on from a place further on where a word has ended.
  void moveTo(const char* place) { place_ = place; }

 private:
  const char* place_;
  const char* end_;
};

/// Whether the bytes seem to be text in UTF-16, with a mark at the start or without.
bool isWideText(std::string_view bytes);

/// What a file seems to be that is no plain text of ours, with what to do about it, such as "a gzip
/// file: unpack it first"; "" where it may be one.
std::string otherKindOf(std::string_view bytes);

/// The bytes without the UTF-8 byte-order mark that may stand at their start.
std::string_view withoutByteOrderMark(std::string_view bytes);
