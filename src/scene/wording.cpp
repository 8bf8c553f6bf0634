// Showing words of the input in messages, and guessing which word was meant: of those that may
// stand there the one with the fewest slips, if they are few for its length.
#include "scene/wording.h"

#include <algorithm>
#include <array>

namespace {

constexpr std::size_t kLongestGuess = 31;

char lower(char c) { return c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : c; }

/// Least number of letters to change, add, leave out, or swap with the next one, to turn a into b,
/// both at most kLongestGuess long; no letter is touched twice. Source: Damerau, "A Technique for
/// Computer Detection and Correction of Spelling Errors", 1964; by rows.
std::size_t editDistance(std::string_view a, std::string_view b) {
  std::array<std::size_t, kLongestGuess + 1> beforeLast{}, last{}, row{};
  for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    beforeLast = last;
    last = row;
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t changed = last[j - 1] + (lower(a[i - 1]) != lower(b[j - 1]));
      row[j] = std::min({changed, last[j] + 1, row[j - 1] + 1});
      const bool isSwap = i > 1 && j > 1 && lower(a[i - 1]) == lower(b[j - 2]) &&
                          lower(a[i - 2]) == lower(b[j - 1]);
      if (isSwap) row[j] = std::min(row[j], beforeLast[j - 2] + 1);
    }
  }
  return row[b.size()];
}

}  // namespace

bool isOneOf(std::string_view word, WordList words) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

std::string quoted(std::string_view word, std::size_t limit) {
  constexpr char kHex[] = "0123456789abcdef";
  std::string text = "'";
  for (const char c : word.substr(0, limit)) {
    const unsigned byte = static_cast<unsigned char>(c);
    if (byte >= 0x20 && byte < 0x7f) {
      text += c;
    } else {
      text += {'\\', 'x', kHex[byte / 16], kHex[byte % 16]};
    }
  }
  return text + (word.size() > limit ? "...'" : "'");
}

std::string_view nearestWord(std::string_view word, WordList allowed) {
  std::string_view nearest;
  if (word.size() > kLongestGuess) return nearest;
  std::size_t least = std::max(word.size() / 3, std::size_t(1)) + 1;
  for (const std::string_view candidate : allowed) {
    if (candidate.size() > kLongestGuess) continue;
    const std::size_t distance = editDistance(word, candidate);
    if (distance >= least || distance >= candidate.size()) continue;
    least = distance;
    nearest = candidate;
  }
  return nearest;
}

std::string listed(WordList words, const char* conjunction) {
  std::string text;
  for (const std::string_view* word = words.begin(); word != words.end(); ++word) {
    const bool isLast = word + 1 == words.end();
    if (word != words.begin()) text += isLast ? " " + std::string(conjunction) + " " : ", ";
    text += *word;
  }
  return text;
}

std::string withArticle(std::string_view noun) {
  const bool isVowel = !noun.empty() && std::string_view("aeiouAEIOU").find(noun[0]) != noun.npos;
  return (isVowel ? "an " : "a ") + std::string(noun);
}

std::string counted(std::size_t count, std::string_view noun, std::string_view plural) {
  const std::string text = std::to_string(count) + " ";
  if (count == 1 || plural.empty()) return text + std::string(noun) + (count == 1 ? "" : "s");
  return text + std::string(plural);
}
