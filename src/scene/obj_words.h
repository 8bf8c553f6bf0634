// ObjWords: cuts the text of an OBJ file into statements and words. A statement ends with its line,
// unless that ends in a backslash; a comment is never continued.
//
// The place in the text is handed along apart from the words, so that it can stay in a register;
// with numbers read in line this took 0.92 of the time.
#pragma once
#include <cstring>
#include <string_view>

inline bool isBlankInObj(char c) { return c == ' ' || (c >= '\t' && c <= '\r' && c != '\n'); }

/// True when the line that ends at `newline` goes on behind it: it ends in a backslash. It begins
/// at or before `start`, and nothing before that is looked at, nor before the last two bytes.
inline bool isContinuedLine(const char* start, const char* newline) {
  if (newline != start && newline[-1] == '\r') --newline;
  return newline != start && newline[-1] == '\\';
}

/// Statements and the words in them, up to the end of a text.
class ObjWords {
 public:
  explicit ObjWords(const char* end) : end_(end) {}

  const char* end() const { return end_; }

  /// Calls `take` at the first letter of each statement from `p` on; it returns a place in it.
  template <class Take>
  void forEachStatement(const char* p, const Take& take) const {
    for (p = findStatement(p); p != end_; p = findStatement(p)) p = skipStatement(take(p));
  }
  /// True when the statement at `p` begins with the one letter `name`.
  bool isStatement(char name, const char* p) const { return *p == name && isWordEnd(p + 1); }
  /// The same for any word.
  bool isStatement(std::string_view name, const char* p) const { return wordAt(p) == name; }

  /// Where the next word of the statement begins; where the statement ends if it has no more.
  const char* findWord(const char* p) const {
    while (p != end_) {
      const std::size_t length = isBlankInObj(*p) ? 1 : continuation(p);
      if (length == 0) break;
      p += length;
    }
    return p;
  }
  /// True where findWord has found no word.
  bool isStatementEnd(const char* p) const { return p == end_ || *p == '\n' || *p == '#'; }
  bool isWordEnd(const char* p) const {
    return p == end_ || *p == '\n' || isBlankInObj(*p) || continuation(p) > 0;
  }
  /// The word that begins at `start`.
  std::string_view wordAt(const char* start) const {
    const char* p = start;
    while (!isWordEnd(p)) ++p;
    return {start, std::size_t(p - start)};
  }

 private:
  const char* findStatement(const char* p) const {
    while (p != end_ && (isBlankInObj(*p) || *p == '\n')) ++p;
    return p;
  }
  /// Where the line behind the statement begins; `p` is a place in the statement.
  const char* skipStatement(const char* p) const {
    if (p != end_ && *p == '\n') return p + 1;
    const bool isComment = p != end_ && *p == '#';
    while (p != end_) {
      const void* const found = std::memchr(p, '\n', std::size_t(end_ - p));
      const char* const newline = found ? static_cast<const char*>(found) : end_;
      const bool goesOn = !isComment && isContinuedLine(p, newline);
      p = newline == end_ ? end_ : newline + 1;
      if (!goesOn) break;
    }
    return p;
  }
  /// Length of a backslash with the line end behind it, 0 for anything else.
  std::size_t continuation(const char* p) const {
    if (*p != '\\') return 0;
    const char* next = p + 1;
    if (next != end_ && *next == '\r') ++next;
    if (next == end_) return std::size_t(next - p);
    return *next == '\n' ? std::size_t(next + 1 - p) : 0;
  }

  const char* end_;
};
