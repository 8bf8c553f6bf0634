// Throwing or collecting mistakes.
#include "scene/mistake_log.h"

#include <algorithm>

void MistakeLog::add(std::size_t place, const InputError& mistake) {
  // A copy that finds no memory throws bad_alloc in its place.
  if (mode_ == Mode::throwFirst) throw mistake;  // NOLINT(cert-err60-cpp)
  mistakes_.push_back({place, mistake});
  if (mistakes_.size() >= kCapacity) throw Full();
}

std::vector<InputError> MistakeLog::inOrder() const {
  std::vector<Entry> entries = mistakes_;
  std::stable_sort(entries.begin(), entries.end(),
                   [](const Entry& a, const Entry& b) { return a.place < b.place; });
  std::vector<InputError> mistakes;
  mistakes.reserve(entries.size());
  for (const Entry& entry : entries) mistakes.push_back(entry.mistake);
  return mistakes;
}
