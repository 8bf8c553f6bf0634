// Measuring: contenders take turns, and the median of each one's rounds counts.
#pragma once
#include <chrono>
#include <functional>
#include <string>
#include <vector>

namespace bench {

/// Values of one contender, one for each round, in any unit.
class Samples {
 public:
  void add(double value) { values_.push_back(value); }
  bool empty() const { return values_.empty(); }
  /// The middle value; of an even number the mean of the two. 0 without values.
  double median() const;
  double least() const;
  double most() const;
  /// Every value v as factor / v: seconds become rates.
  Samples inverted(double factor) const;
  Samples scaled(double factor) const;

 private:
  std::vector<double> values_;
};

/// Seconds that work() takes.
template <class Work>
double secondsOf(const Work& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// Calls every contender `rounds` times, in turns; each returns its seconds.
std::vector<Samples> inTurns(int rounds, const std::vector<std::function<double()>>& contenders);

/// What a row must and should reach; 0 where nothing is asked.
struct Target {
  double must = 0, aim = 0;
};

/// One line of the table: ours, theirs, and ours / theirs in the last column.
void printRow(const std::string& figure, const std::string& unit, const Samples& ours,
              const std::string& rival, const Samples& theirs, Target target = {});
/// The same without a rival.
void printAlone(const std::string& figure, const std::string& unit, const Samples& ours);
void printHeading(const std::string& title);

}  // namespace bench
