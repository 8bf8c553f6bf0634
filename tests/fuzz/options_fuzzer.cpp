// Fuzz target: the argument list, one word a line (a word may be empty, and may hold any byte but
// the line feed). Demands: what is accepted is within its limits and has something to do; an error
// is one line that prints.
#include <cmath>

#include "cli/options.h"
#include "fuzz.h"

namespace {

std::vector<std::string> linesOf(const std::string& text) {
  std::vector<std::string> lines;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    lines.push_back(text.substr(at, end - at));
    at = end + 1;
  }
  return lines;
}

bool namesPicture(const Options& o) {
  for (const std::string* file : {&o.output, &o.depthOutput, &o.normalsOutput, &o.samplesOutput,
                                  &o.filterOutput, &o.materialsOutput, &o.heatmapOutput}) {
    if (!file->empty()) return true;
  }
  return false;
}

void checkOptions(const Options& o) {
  const auto within = [](double value, double least, double most) {
    return value >= least && value <= most;
  };
  fuzz::demand(within(o.width, 1, kMaxImageSide) && within(o.height, 1, kMaxImageSide),
               "a size is within its limits");
  fuzz::demand(within(o.threads, 0, kMaxThreads), "threads are within their limits");
  fuzz::demand(within(o.render.maxBounces, 0, kMaxBounces), "bounces are within their limits");
  fuzz::demand(std::isfinite(o.render.minWeight) && o.render.minWeight >= 0, "a weight is >= 0");
  fuzz::demand(std::isfinite(o.render.epsilon.value) && o.render.epsilon.value >= 0,
               "an epsilon is >= 0");
  fuzz::demand(o.depthOutput.empty() || o.depthMin != o.depthMax, "MIN and MAX differ");
  fuzz::demand(std::isfinite(o.depthMin) && std::isfinite(o.depthMax), "MIN and MAX are finite");
  if (o.wantsText()) return;
  if (o.compare.isWanted() || o.merge.isWanted()) {
    fuzz::demand(o.input.empty() && o.output.empty(), "what compares or merges renders nothing");
    return;
  }
  fuzz::demand(!o.input.empty(), "there is a scene");
  fuzz::demand(o.check || o.stats || o.preview || o.tracesPixel || namesPicture(o),
               "there is something to do");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    checkOptions(parseOptions(linesOf(std::string(data, data + size))));
  } catch (const UsageError& error) {
    fuzz::demand(fuzz::isPlainLine(error.what()), "an error is one line that prints");
  }
  return 0;
}
