// FilteredRows: the rows of a PNG, each with the filter that makes it compress well.
#pragma once
#include "image/bytes.h"
#include "image/deflate_costs.h"
#include "image/png_samples.h"

namespace png {

/// How filters are chosen, the quickest way first.
enum class FilterChoice {
  leastDifferences,  // for each row, by the sum of absolute differences
  perStretch,        // that, or one filter for a whole stretch, by a trial of what it would cost
  perRow             // also for each row, by a trial behind the rows before
};

/// The filtered rows from the top, as many at a time as fill a stretch, behind the bytes that
/// copies may reach back to.
class FilteredRows {
 public:
  /// `depth` as for TokenTrial. Refers to `samples`.
  FilteredRows(const Samples& samples, int height, FilterChoice choice, unsigned depth);

  bool done() const { return next_ == 0; }
  void takeStretch();

  /// The rows of the stretch are bytes()[from()..); before them stands the end of those before.
  const Bytes& bytes() const { return bytes_; }
  std::size_t from() const { return from_; }
  /// What symbols of these bytes probably cost.
  const deflate::Costs& costs() const { return costs_; }

 private:
  std::size_t stride() const { return 1 + row_.size(); }
  template <class Choose>
  void filterRows(const Choose& choose);
  void filterByDifferences();
  void filterByTrial();
  void keepIfCheapest();

  const Samples& samples_;
  const FilterChoice choice_;
  const unsigned depth_;
  int first_, next_;                // the rows of the stretch: next_ <= y < first_
  Bytes row_, above_, firstAbove_;  // samples; those above the stretch's first row
  Bytes bytes_, cheapest_;
  std::uint64_t leastCost_ = 0;
  std::size_t from_ = 0;
  deflate::Costs costs_ = deflate::costsAtFirst();
};

}  // namespace png
