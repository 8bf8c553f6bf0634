// Medians, and the lines of the table.
#include "measure.h"

#include <time.h>

#include <algorithm>
#include <cstdio>
#include <fstream>

#include "system/worker_threads.h"

namespace bench {
namespace {

std::string numberText(double value) {
  char text[32];
  const double size = value < 0 ? -value : value;
  std::snprintf(text, sizeof text, size >= 1000 ? "%.0f" : size >= 100 ? "%.1f" : "%.3g", value);
  return text;
}

double now(clockid_t clock) {
  timespec time{};
  clock_gettime(clock, &time);
  return double(time.tv_sec) + double(time.tv_nsec) * 1e-9;
}

std::string samplesText(const Samples& samples) {
  return numberText(samples.median()) + " (" + numberText(samples.least()) + ".." +
         numberText(samples.most()) + ")";
}

}  // namespace

double Samples::median() const {
  if (values_.empty()) return 0;
  std::vector<double> sorted = values_;
  std::sort(sorted.begin(), sorted.end());
  const std::size_t half = sorted.size() / 2;
  return sorted.size() % 2 == 1 ? sorted[half] : (sorted[half - 1] + sorted[half]) / 2;
}

double Samples::least() const {
  return values_.empty() ? 0 : *std::min_element(values_.begin(), values_.end());
}

double Samples::most() const {
  return values_.empty() ? 0 : *std::max_element(values_.begin(), values_.end());
}

Samples Samples::inverted(double factor) const {
  Samples result;
  for (const double value : values_) result.add(factor / value);
  return result;
}

Samples Samples::scaled(double factor) const {
  Samples result;
  for (const double value : values_) result.add(factor * value);
  return result;
}

double secondsOf(Clock clock, int threads, const std::function<void()>& work) {
  const clockid_t id = clock == Clock::wall ? CLOCK_MONOTONIC : CLOCK_PROCESS_CPUTIME_ID;
  const double start = now(id);
  work();
  return (now(id) - start) / (clock == Clock::wall ? 1 : threads);
}

std::vector<Samples> inTurns(int rounds, const std::vector<std::function<double()>>& contenders) {
  std::vector<Samples> samples(contenders.size());
  for (int round = 0; round < rounds; ++round) {
    for (std::size_t i = 0; i < contenders.size(); ++i) samples[i].add(contenders[i]());
  }
  return samples;
}

const std::string& processorName() {
  static const std::string name = [] {
    std::ifstream in("/proc/cpuinfo");
    std::string line, model = "processor unknown";
    while (std::getline(in, line)) {
      if (line.rfind("model name", 0) == 0) {
        model = line.substr(line.find(':') + 2);
        break;
      }
    }
    return model + " x " + std::to_string(hardwareThreads());
  }();
  return name;
}

void printRow(const std::string& figure, const std::string& unit, const Samples& ours,
              const std::string& rival, const Samples& theirs, Target target) {
  const std::string must = target.must > 0 ? "must " + numberText(target.must) : "";
  const std::string aim = target.aim > 0 ? "aim " + numberText(target.aim) : "";
  std::printf("%-34s %-8s %-25s %-10s %-26s %-9s %-8s %6.2f  %s\n", figure.c_str(), unit.c_str(),
              samplesText(ours).c_str(), rival.c_str(), samplesText(theirs).c_str(), must.c_str(),
              aim.c_str(), theirs.empty() ? 0.0 : ours.median() / theirs.median(),
              processorName().c_str());
  std::fflush(stdout);
}

void printAlone(const std::string& figure, const std::string& unit, const Samples& ours) {
  std::printf("%-34s %-8s %-25s %-63s %s\n", figure.c_str(), unit.c_str(),
              samplesText(ours).c_str(), "", processorName().c_str());
  std::fflush(stdout);
}

void printHeading(const std::string& title) {
  std::printf("\n%s\n%-34s %-8s %-25s %-37s %-18s %6s  %s\n", title.c_str(), "figure", "unit",
              "ours (least..most)", "theirs (least..most)", "target", "ratio", "processor");
  std::fflush(stdout);
}

}  // namespace bench
