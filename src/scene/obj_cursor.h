// ObjCursor: walks over the statements of an OBJ file and the words in them.
// A statement ends with its line, unless that ends in a backslash; a comment is never continued.
#pragma once
#include <cstring>
#include <string_view>

#include "scene/number_reader.h"

class ObjCursor {
 public:
  explicit ObjCursor(std::string_view bytes)
      : place_(bytes.data()), end_(bytes.data() + bytes.size()) {}

  const char* place() const { return place_; }
  const char* end() const { return end_; }
  /// Goes to a place further on in the same statement.
  void moveTo(const char* place) { place_ = place; }

  /// Goes to the next statement's first letter; false at the end.
  bool findStatement() {
    if (place_ != end_ && *place_ > ' ') return true;  // most lines begin so
    while (place_ != end_ && (isBlank(*place_) || *place_ == '\n')) ++place_;
    return place_ != end_;
  }
  /// True when the statement here begins with the one letter `name`.
  bool isStatement(char name) const { return *place_ == name && isWordEnd(place_ + 1); }
  void skipName() { ++place_; }

  /// Goes behind the statement's last line.
  void skipStatement() {
    if (place_ != end_ && *place_ == '\n') {  // mostly its line's end is reached already
      ++place_;
      return;
    }
    const bool isComment = place_ != end_ && *place_ == '#';
    while (place_ != end_) {
      const char* const start = place_;
      const char* const newline = findNewline();
      place_ = newline == end_ ? end_ : newline + 1;
      if (isComment || !isContinued(start, newline)) return;
    }
  }

  /// Goes to the statement's next word; false where it has no more.
  bool findWord() {
    if (place_ != end_ && *place_ == ' ') ++place_;
    if (place_ != end_ && *place_ > '#' && *place_ != '\\') return true;  // most words begin so
    while (place_ != end_) {
      const std::size_t length = isBlank(*place_) ? 1 : continuation(place_);
      if (length == 0) break;
      place_ += length;
    }
    return place_ != end_ && *place_ != '\n' && *place_ != '#';
  }
  /// The word here, up to `p` at least.
  std::string_view wordTo(const char* p) const {
    while (!isWordEnd(p)) ++p;
    return {place_, std::size_t(p - place_)};
  }
  bool isWordEnd(const char* p) const {
    return p == end_ || *p == ' ' || *p == '\n' || isBlank(*p) || continuation(p) > 0;
  }

  /// True when a line that ends at `newline` goes on behind it; it begins at or before `start`, and
  /// nothing before that is looked at.
  static bool isContinued(const char* start, const char* newline) {
    if (newline != start && newline[-1] == '\r') --newline;
    return newline != start && newline[-1] == '\\';
  }

 private:
  static bool isBlank(char c) { return c == ' ' || (c >= '\t' && c <= '\r' && c != '\n'); }
  /// Length of a backslash with the line end behind it, 0 for anything else.
  std::size_t continuation(const char* p) const {
    if (*p != '\\') return 0;
    const char* next = p + 1;
    if (next != end_ && *next == '\r') ++next;
    if (next == end_) return std::size_t(next - p);
    return *next == '\n' ? std::size_t(next + 1 - p) : 0;
  }
  /// The line's end.
  const char* findNewline() const {
    const void* const found = std::memchr(place_, '\n', std::size_t(end_ - place_));
    return found ? static_cast<const char*>(found) : end_;
  }

  const char* place_;
  const char* end_;
};
