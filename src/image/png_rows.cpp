// FilteredRows.
#include "image/png_rows.h"

#include <algorithm>

#include "image/png_filter.h"
#include "image/token_trial.h"

namespace png {

using deflate::Costs;
using deflate::SymbolCounts;
using deflate::TokenTrial;

namespace {

constexpr std::size_t kStretch = 1 << 20;  // bytes that are compressed together, at least

}  // namespace

FilteredRows::FilteredRows(const Samples& samples, int height, FilterChoice choice, unsigned depth)
    : samples_(samples),
      choice_(choice),
      depth_(depth),
      first_(height),
      next_(height),
      row_(samples.rowSize()),
      above_(row_.size()) {}

void FilteredRows::takeStretch() {
  const std::size_t kept = std::min<std::size_t>(bytes_.size(), deflate::kWindow);
  bytes_.erase(bytes_.begin(), bytes_.end() - std::ptrdiff_t(kept));
  from_ = kept;
  first_ = next_;
  next_ -= std::min(next_, int(kStretch / stride() + 1));
  bytes_.resize(from_ + std::size_t(first_ - next_) * stride());
  firstAbove_ = above_;
  filterByDifferences();
  if (choice_ == FilterChoice::leastDifferences) return;
  leastCost_ = ~std::uint64_t{0};
  keepIfCheapest();
  for (unsigned filter = 0; filter < kFilters; ++filter) {
    filterRows([filter](std::size_t) { return filter; });
    keepIfCheapest();
  }
  if (choice_ == FilterChoice::perRow) {
    filterByTrial();
    keepIfCheapest();
  }
  bytes_.swap(cheapest_);
}

/// Filters the rows of the stretch by choose(place in bytes_), row_ and above_ being theirs.
template <class Choose>
void FilteredRows::filterRows(const Choose& choose) {
  above_ = firstAbove_;
  std::size_t at = from_;
  for (int y = first_ - 1; y >= next_; --y, at += stride()) {
    samples_.readRow(y, row_);
    filterRow(choose(at), samples_.perPixel(), row_, above_, &bytes_[at]);
    above_.swap(row_);
  }
}

void FilteredRows::filterByDifferences() {
  filterRows([this](std::size_t) { return leastDifference(samples_.perPixel(), row_, above_); });
}

/// Takes for each row the filter that costs least behind the rows that are chosen already.
void FilteredRows::filterByTrial() {
  TokenTrial trial(bytes_, depth_);
  filterRows([&](std::size_t at) {
    trial.passTo(at);
    unsigned best = 0;
    std::uint64_t least = ~std::uint64_t{0};
    for (unsigned filter = 0; filter < kFilters; ++filter) {
      filterRow(filter, samples_.perPixel(), row_, above_, &bytes_[at]);
      const std::uint64_t cost = costs_.of(trial.tryTo(at + stride(), costs_));
      if (cost >= least) continue;
      least = cost;
      best = filter;
    }
    return best;
  });
}

/// A trial with equal costs for all symbols tells their shares, and these tell what they cost.
void FilteredRows::keepIfCheapest() {
  TokenTrial trial(bytes_, depth_);
  trial.passTo(from_);
  const SymbolCounts counts = trial.tryTo(bytes_.size(), deflate::costsAtFirst());
  const Costs costs(counts);
  const std::uint64_t cost = costs.of(counts);
  if (cost >= leastCost_) return;
  leastCost_ = cost;
  costs_ = costs;
  cheapest_ = bytes_;
}

}  // namespace png
