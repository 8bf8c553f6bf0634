// Wording: how messages show words of the input, and which word was probably meant.
#pragma once
#include <cstddef>
#include <iterator>
#include <string>
#include <string_view>

/// Some words in a row; a view of an array that outlives it.
class WordList {
 public:
  constexpr WordList(const std::string_view* first, std::size_t size)
      : first_(first), size_(size) {}
  /// An array, a std::array or a vector.
  template <class Words>
  constexpr WordList(const Words& words) : WordList(std::data(words), std::size(words)) {}

  const std::string_view* begin() const { return first_; }
  const std::string_view* end() const { return first_ + size_; }

 private:
  const std::string_view* first_;
  std::size_t size_;
};

bool isOneOf(std::string_view word, WordList words);

/// `word` in quotes, at most `limit` bytes of it, with bytes that do not print escaped as \xHH.
std::string quoted(std::string_view word, std::size_t limit = 40);

/// The word of `allowed` that `word` is probably a slip of; empty where none is near. Near means
/// a third of its letters may be wrong, missing, added, or swapped with the next one; upper and
/// lower case count as equal.
std::string_view nearestWord(std::string_view word, WordList allowed);

/// "a, b or c", or with another word before the last one.
std::string listed(WordList words, const char* conjunction = "or");

/// "a camera", "an up", by the first letter.
std::string withArticle(std::string_view noun);

/// "1 pair", "2 pairs": a count and a noun, of which the plural has an s unless it is given.
std::string counted(std::size_t count, std::string_view noun, std::string_view plural = "");
