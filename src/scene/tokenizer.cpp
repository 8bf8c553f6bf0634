// Cutting a scene file into words, by a table of what each byte is.
#include "scene/tokenizer.h"

#include <array>
#include <cstring>

namespace {

enum class Kind : unsigned char { part, space, brace };

constexpr std::array<Kind, 256> makeKinds() {
  std::array<Kind, 256> kinds{};
  for (const unsigned char c : {' ', '\t', '\n', '\v', '\f', '\r'}) kinds[c] = Kind::space;
  kinds[std::size_t('{')] = kinds[std::size_t('}')] = Kind::brace;
  return kinds;
}
constexpr std::array<Kind, 256> kKinds = makeKinds();

Kind kindOf(char c) { return kKinds[static_cast<unsigned char>(c)]; }

}  // namespace

Tokenizer::Tokenizer(std::string_view bytes)
    : place_(bytes.data()), end_(bytes.data() + bytes.size()) {
  if (bytes.substr(0, 3) == "\xEF\xBB\xBF") place_ += 3;
}

std::string_view Tokenizer::next() {
  skipToWord();
  const char* const start = place_;
  if (place_ != end_ && kindOf(*place_) == Kind::brace) {
    ++place_;
  } else {
    while (place_ != end_ && kindOf(*place_) == Kind::part) ++place_;
  }
  return {start, std::size_t(place_ - start)};
}

void Tokenizer::skipToWord() {
  for (;;) {
    while (place_ != end_ && kindOf(*place_) == Kind::space) ++place_;
    if (place_ == end_) return;
    const bool isComment =
        *place_ == '#' || (*place_ == '/' && place_ + 1 != end_ && place_[1] == '/');
    if (!isComment) return;
    const void* newline = std::memchr(place_, '\n', std::size_t(end_ - place_));
    place_ = newline ? static_cast<const char*>(newline) : end_;
  }
}
