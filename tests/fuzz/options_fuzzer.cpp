// Fuzz target: the argument list, one word a line (a word may be empty, and may hold any byte but
// the line feed). Demands: what is accepted is within its limits and has something to do; an error
// is one line that prints.
#include <cmath>

#include "cli/request.h"
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

void checkRequest(const Request& request) {
  const auto within = [](double value, double least, double most) {
    return value >= least && value <= most;
  };
  const PictureRequest& picture = request.render.picture;
  const ResultRequest& results = request.render.results;
  fuzz::demand(within(picture.width, 1, kMaxImageSide) && within(picture.height, 1, kMaxImageSide),
               "a size is within its limits");
  fuzz::demand(within(request.run.threads, 1, kMaxThreads), "threads are within their limits");
  fuzz::demand(within(picture.render.maxBounces, 0, kMaxBounces),
               "bounces are within their limits");
  fuzz::demand(std::isfinite(picture.render.minWeight) && picture.render.minWeight >= 0,
               "a weight is >= 0");
  fuzz::demand(std::isfinite(picture.render.epsilon.value) && picture.render.epsilon.value >= 0,
               "an epsilon is >= 0");
  for (const OutputRequest& output : results.outputs) {
    const bool isDepth = output.kind == OutputRequest::Kind::depth;
    fuzz::demand(!isDepth || output.depthMin != output.depthMax, "MIN and MAX differ");
    fuzz::demand(std::isfinite(output.depthMin) && std::isfinite(output.depthMax),
                 "MIN and MAX are finite");
    fuzz::demand(!output.file.empty() && results.find(output.kind) == &output,
                 "an output has a name, and there is one of a kind");
  }
  if (request.text != ProgramText::none) return;
  if (request.compare.isWanted() || request.merge.isWanted()) {
    fuzz::demand(picture.scene.empty() && results.outputs.empty(),
                 "what compares or merges renders nothing");
    return;
  }
  fuzz::demand(!picture.scene.empty(), "there is a scene");
  fuzz::demand(request.check || results.stats || results.preview || results.pixel ||
                   !results.outputs.empty(),
               "there is something to do");
  fuzz::demand(picture.area.left >= 0 && picture.area.left < picture.area.right &&
                   picture.area.right <= picture.width && picture.area.bottom >= 0 &&
                   picture.area.bottom < picture.area.top && picture.area.top <= picture.height,
               "what is rendered lies in the picture");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    checkRequest(parseRequest(linesOf(std::string(data, data + size))));
  } catch (const UsageError& error) {
    fuzz::demand(fuzz::isPlainLine(error.what()), "an error is one line that prints");
  }
  return 0;
}
