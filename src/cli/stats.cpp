// Stats: the lines that -stats prints.
#include "cli/stats.h"

#include <cstdio>

namespace {

std::string line(const std::string& name, const std::string& value) {
  return std::string(name) + ": " + value + "\n";
}

std::string seconds(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6f", value);
  return text;
}

std::string line(const std::string& name, std::uint64_t count) {
  return line(name, std::to_string(count));
}

std::string ratio(double amount, double of) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3f", of > 0 ? amount / of : 0);
  return text;
}

/// After this many bounces rays share one line.
constexpr std::size_t kLongestList = 20;

std::string depthLines(const std::vector<std::uint64_t>& byBounces) {
  std::string lines;
  std::uint64_t rest = 0;
  for (std::size_t bounces = 0; bounces < byBounces.size(); ++bounces) {
    if (bounces < kLongestList) {
      lines += line("rays after " + std::to_string(bounces) + " bounces", byBounces[bounces]);
    } else {
      rest += byBounces[bounces];
    }
  }
  if (rest > 0) lines += line("rays after more bounces", rest);
  return lines;
}

std::string rayLines(const RayCounts& rays) {
  return line("rays", rays.total()) + line("eye rays", rays.rays(RayKind::eye)) +
         line("mirror rays", rays.rays(RayKind::mirror)) +
         line("refracted rays", rays.rays(RayKind::refracted)) +
         line("shadow rays", rays.shadowRays()) +
         line("shadow rays blocked", rays.blockedShadowRays()) +
         line("rays to the background", rays.misses()) + depthLines(rays.byBounces()) +
         line("branches ended by bounces", rays.ends(Outcome::tooManyBounces)) +
         line("branches ended by weight", rays.ends(Outcome::tooFaint)) +
         line("branches ended by total reflection", rays.ends(Outcome::totalReflection));
}

std::string testLines(const char* what, const TestCounts& tests, std::uint64_t rays) {
  const std::string ending = std::string(" for ") + what;
  return line("nodes visited" + ending, tests.nodes) +
         line("primitives tested" + ending, tests.primitives) +
         line("primitives tested per ray" + ending, ratio(double(tests.primitives), double(rays)));
}

}  // namespace

std::string Stats::text() const {
  const auto total = double(rays.total());
  const std::string tested =
      countsTests ? testLines("hits", tests.nearest, rays.total() - rays.shadowRays()) +
                        testLines("shadows", tests.shadow, rays.shadowRays())
                  : line("intersection tests", "not counted in a picture of cells");
  return line("instruction set", simd) + line("tree", tree) +
         line("threads", std::to_string(threads)) + line("seconds reading", seconds(readSeconds)) +
         line("seconds building", seconds(buildSeconds)) +
         line("seconds tracing", seconds(traceSeconds)) +
         line("seconds writing", seconds(writeSeconds)) + rayLines(rays) +
         line("rays per pixel", ratio(total, pixels)) +
         line("rays per second", ratio(total, traceSeconds)) + tested;
}
