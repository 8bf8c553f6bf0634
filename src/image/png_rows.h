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
  /// `depth` as for TokenTrial. Refers to `samples`. Trials are shared among `threads` >= 1 threads
  /// at most; what they find does not depend on them.
  FilteredRows(const Samples& samples, int height, FilterChoice choice, unsigned depth,
               int threads);

  bool done() const { return next_ == 0; }
  void takeStretch();

  /// The rows of the stretch are bytes()[from()..); before them stands the end of those before.
  const Bytes& bytes() const { return stretch_.bytes; }
  std::size_t from() const { return from_; }
  /// What symbols of these bytes probably cost.
  const deflate::Costs& costs() const { return stretch_.costs; }

 private:
  /// The rows of a stretch, filtered in one of several ways, and what they cost.
  struct Stretch {
    Bytes bytes;
    deflate::Costs costs = deflate::costsAtFirst();
    std::uint64_t cost = 0;
  };

  std::size_t stride() const { return 1 + samples_.rowSize(); }
  template <class Choose>
  void filterRows(const Choose& choose, Bytes& bytes) const;
  void filterByDifferences(Bytes& bytes) const;
  void filterByTrial(const deflate::Costs& costs, Bytes& bytes) const;
  void estimate(Stretch& stretch) const;
  Stretch cheapestOfAll(const Stretch& empty) const;

  const Samples& samples_;
  const int height_;
  const FilterChoice choice_;
  const unsigned depth_;
  const int threads_;
  int first_, next_;  // the rows of the stretch: next_ <= y < first_
  Stretch stretch_;
  std::size_t from_ = 0;
};

}  // namespace png
