// TokenTrial.
#include "image/token_trial.h"

namespace deflate {

void TokenTrial::passTo(std::size_t to) {
  for (; passed_ < to; ++passed_) finder_.add(passed_);
}

SymbolCounts TokenTrial::tryTo(std::size_t to, const Costs& costs) {
  SymbolCounts counts;
  for (std::size_t at = passed_; at < to;) {
    const Token token = bestAt(at, to, costs);
    counts.add(token);
    const std::size_t end = isLiteral(token) ? at + 1 : at + token.length;
    for (; at < end; ++at) finder_.add(at);
  }
  finder_.remove(passed_, to);
  return counts;
}

Token TokenTrial::bestAt(std::size_t at, std::size_t end, const Costs& costs) {
  copies_.clear();
  finder_.find(at, end, copies_);
  Token best = {bytes_[at], 0};
  std::int64_t mostSaved = 0, literals = 0;
  unsigned length = 0;
  for (const Copy copy : copies_) {
    for (; length < copy.length; ++length) literals += costs.literal[bytes_[at + length]];
    const std::int64_t saved = literals - costs.of(copy);
    if (saved <= mostSaved) continue;
    mostSaved = saved;
    best = copy;
  }
  return best;
}

}  // namespace deflate
