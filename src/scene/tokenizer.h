// Tokenizer: cuts a scene file into words, without copying any.
// White space separates words; a brace is a word of its own wherever it stands; a # or // where a
// word would begin starts a comment that runs to the end of the line.
#pragma once
#include <string_view>

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
  void skipToWord();

  const char* place_;
  const char* end_;
};
