// Measuring: contenders take turns, and the median of each one's rounds counts.
#pragma once
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

/// What a second is: of the clock on the wall, or of processor time that all threads together
/// use, divided by their number. The latter hardly sees what else the machine does, nor that
/// threads wait for each other.
enum class Clock { wall, processor };

/// Seconds that work() takes on `threads` threads.
double secondsOf(Clock clock, int threads, const std::function<void()>& work);

/// Calls every contender `rounds` times, in turns; each returns its seconds.
std::vector<Samples> inTurns(int rounds, const std::vector<std::function<double()>>& contenders);

/// What a row must and should reach; 0 where nothing is asked.
struct Target {
  double must = 0, aim = 0;
};

/// The processor's name and the number of threads that it runs at a time.
const std::string& processorName();

/// One line of the table: ours, theirs, ours / theirs, and the processor.
void printRow(const std::string& figure, const std::string& unit, const Samples& ours,
              const std::string& rival, const Samples& theirs, Target target = {});
/// The same without a rival.
void printAlone(const std::string& figure, const std::string& unit, const Samples& ours);
void printHeading(const std::string& title);

}  // namespace bench
