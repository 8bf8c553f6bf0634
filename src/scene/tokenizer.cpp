// Cutting a scene file into words, by what each byte is: eight of them at a time, where there are
// so many (0.6 of the instructions of one after the other).
#include "scene/tokenizer.h"

#include <array>
#include <cstring>

#include "scene/eight_bytes.h"

namespace {

enum class Kind : unsigned char { part, space, brace };

constexpr std::array<Kind, 256> makeKinds() {
  std::array<Kind, 256> kinds{};
  for (const char c : {' ', '\t', '\n', '\v', '\f', '\r'}) kinds[std::size_t(c)] = Kind::space;
  kinds[std::size_t('{')] = kinds[std::size_t('}')] = Kind::brace;
  return kinds;
}
constexpr std::array<Kind, 256> kKinds = makeKinds();

Kind kindOf(char c) { return kKinds[static_cast<unsigned char>(c)]; }

/// Marks all bytes that may end a word: those up to a blank, and from { up to 127.
std::uint64_t markEnds(std::uint64_t bytes) {
  using eight_bytes::markAtLeast;
  return (~markAtLeast(bytes, '!') | (markAtLeast(bytes, '{') & ~bytes)) & eight_bytes::kMarks;
}

/// How many of eight bytes come before the first that is no blank.
int countBlanks(std::uint64_t bytes) {
  const std::uint64_t others = bytes ^ eight_bytes::all(' ');
  return others == 0 ? 8 : eight_bytes::firstMarked(others);
}

/// The first byte from `p` on that is no white space. Mostly one blank stands before it, or a line
/// end and an indentation.
const char* skipSpace(const char* p, const char* end) {
  while (end - p > 8 && kindOf(*p) == Kind::space) {
    ++p;
    p += countBlanks(eight_bytes::load(p));
  }
  while (p != end && kindOf(*p) == Kind::space) ++p;
  return p;
}

/// The end of a word that goes on at `p`.
const char* skipWord(const char* p, const char* end) {
  while (end - p >= 8) {
    const std::uint64_t ends = markEnds(eight_bytes::load(p));
    p += ends != 0 ? eight_bytes::firstMarked(ends) : 8;
    if (ends == 0) continue;
    if (kindOf(*p) != Kind::part) return p;
    ++p;
  }
  while (p != end && kindOf(*p) == Kind::part) ++p;
  return p;
}

}  // namespace

Tokenizer::Tokenizer(std::string_view bytes)
    : place_(bytes.data()), end_(bytes.data() + bytes.size()) {
  if (bytes.substr(0, 3) == "\xEF\xBB\xBF") place_ += 3;
}

std::string_view Tokenizer::next() {
  skipToWord();
  const char* const start = place_;
  if (place_ == end_) return {start, 0};
  if (kindOf(*place_) == Kind::brace) {
    ++place_;
  } else {
    place_ = skipWord(place_, end_);
  }
  return {start, std::size_t(place_ - start)};
}

void Tokenizer::skipToWord() {
  for (;;) {
    place_ = skipSpace(place_, end_);
    if (place_ == end_) return;
    const bool isComment =
        *place_ == '#' || (*place_ == '/' && place_ + 1 != end_ && place_[1] == '/');
    if (!isComment) return;
    const void* newline = std::memchr(place_, '\n', std::size_t(end_ - place_));
    place_ = newline ? static_cast<const char*>(newline) : end_;
  }
}
