// The word that was probably meant.
#include "cli/nearest_word.h"

#include <algorithm>

namespace {

/// Source: Wagner and Fischer, "The String-to-String Correction Problem", 1974; with swaps of
/// neighbours, Lowrance and Wagner, "An Extension of the String-to-String Correction Problem", 1975.
std::size_t editDistance(const std::string& a, const std::string& b) {
  using Row = std::vector<std::size_t>;  // distances from the first i letters of a
  Row previous, beforePrevious, row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    beforePrevious = std::move(previous);
    previous = row;
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = previous[j - 1] + (a[i - 1] != b[j - 1]);
      row[j] = std::min({replaced, previous[j] + 1, row[j - 1] + 1});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        row[j] = std::min(row[j], beforePrevious[j - 2] + 1);
    }
  }
  return row[b.size()];
}

}  // namespace

std::string nearestWord(const std::string& word, const std::vector<std::string>& words) {
  std::string nearest;
  std::size_t least = 0;
  for (const std::string& candidate : words) {
    const std::size_t longer = std::max(word.size(), candidate.size());
    const std::size_t distance = editDistance(word, candidate);
    if (3 * distance > longer + 2 || (!nearest.empty() && distance >= least)) continue;
    nearest = candidate;
    least = distance;
  }
  return nearest;
}
