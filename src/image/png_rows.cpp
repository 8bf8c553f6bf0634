// FilteredRows.
#include "image/png_rows.h"

#include <algorithm>

#include "image/png_filter.h"
#include "image/token_trial.h"
#include "system/worker_threads.h"

namespace png {

using deflate::Costs;
using deflate::SymbolCounts;
using deflate::TokenTrial;

namespace {

constexpr std::size_t kStretch = 1 << 20;  // bytes that are compressed together, at least
constexpr std::size_t kStack = 1 << 18;    // bytes

}  // namespace

FilteredRows::FilteredRows(const Samples& samples, int height, FilterChoice choice, unsigned depth,
                           int threads)
    : samples_(samples),
      height_(height),
      choice_(choice),
      depth_(depth),
      threads_(threads),
      first_(height),
      next_(height) {}

void FilteredRows::takeStretch() {
  Bytes& bytes = stretch_.bytes;
  const std::size_t kept = std::min<std::size_t>(bytes.size(), deflate::kWindow);
  bytes.erase(bytes.begin(), bytes.end() - std::ptrdiff_t(kept));
  from_ = kept;
  first_ = next_;
  next_ -= std::min(next_, int(kStretch / stride() + 1));
  bytes.resize(from_ + std::size_t(first_ - next_) * stride());
  if (choice_ == FilterChoice::leastDifferences) {
    filterByDifferences(bytes);
  } else {
    stretch_ = cheapestOfAll(stretch_);
  }
}

/// `empty` has room for the stretch, behind what stands before it.
FilteredRows::Stretch FilteredRows::cheapestOfAll(const Stretch& empty) const {
  std::vector<Stretch> ways(1 + kFilters, empty);
  shareOnThreads(threads_, kStack, ways.size(), [&](std::size_t way) {
    Bytes& bytes = ways[way].bytes;
    if (way == 0) {
      filterByDifferences(bytes);
    } else {
      filterRows([&](std::size_t, const Bytes&, const Bytes&) { return unsigned(way - 1); }, bytes);
    }
    estimate(ways[way]);
  });
  const auto isCheaper = [](const Stretch& a, const Stretch& b) { return a.cost < b.cost; };
  Stretch best = std::move(*std::min_element(ways.begin(), ways.end(), isCheaper));
  if (choice_ == FilterChoice::perRow) {
    Stretch byRow = empty;
    filterByTrial(best.costs, byRow.bytes);
    estimate(byRow);
    if (isCheaper(byRow, best)) best = std::move(byRow);
  }
  return best;
}

/// Filters the rows of the stretch by choose(place in `bytes`, row, row above).
template <class Choose>
void FilteredRows::filterRows(const Choose& choose, Bytes& bytes) const {
  Bytes row(samples_.rowSize()), above(samples_.rowSize());
  if (first_ < height_) samples_.readRow(first_, above);
  std::size_t at = from_;
  for (int y = first_ - 1; y >= next_; --y, at += stride()) {
    samples_.readRow(y, row);
    filterRow(choose(at, row, above), samples_.perPixel(), row, above, &bytes[at]);
    above.swap(row);
  }
}

void FilteredRows::filterByDifferences(Bytes& bytes) const {
  const auto choose = [this](std::size_t, const Bytes& row, const Bytes& above) {
    return leastDifference(samples_.perPixel(), row, above);
  };
  filterRows(choose, bytes);
}

/// Takes for each row the filter that costs least behind the rows that are chosen already.
void FilteredRows::filterByTrial(const Costs& costs, Bytes& bytes) const {
  TokenTrial trial(bytes, depth_);
  const auto choose = [&](std::size_t at, const Bytes& row, const Bytes& above) {
    trial.passTo(at);
    unsigned best = 0;
    std::uint64_t least = ~std::uint64_t{0};
    for (unsigned filter = 0; filter < kFilters; ++filter) {
      filterRow(filter, samples_.perPixel(), row, above, &bytes[at]);
      const std::uint64_t cost = costs.of(trial.tryTo(at + stride(), costs));
      if (cost >= least) continue;
      least = cost;
      best = filter;
    }
    return best;
  };
  filterRows(choose, bytes);
}

/// A trial with equal costs for all symbols tells their shares, and these tell what they cost.
void FilteredRows::estimate(Stretch& stretch) const {
  TokenTrial trial(stretch.bytes, depth_);
  trial.passTo(from_);
  const SymbolCounts counts = trial.tryTo(stretch.bytes.size(), deflate::costsAtFirst());
  stretch.costs = Costs(counts);
  stretch.cost = stretch.costs.of(counts);
}

}  // namespace png
