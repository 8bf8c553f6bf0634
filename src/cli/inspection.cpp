// What a run tells besides its pictures. -stats gives one line for each entry; the other three ask
// render/ and only bring its answers to their outputs.
#include "cli/inspection.h"

#include <cstdio>

#include "cli/run_display.h"
#include "render/false_colors.h"
#include "render/pixel_trace.h"
#include "render/report_words.h"

namespace {

using Kind = OutputRequest::Kind;

/// The length of rays that meet nothing where the scene has planes alone.
constexpr double kEscapeLength = 10;

/// After this many bounces rays share one line of -stats.
constexpr std::size_t kLongestList = 20;

std::string line(const std::string& name, const std::string& value) {
  return name + ": " + value + "\n";
}

std::string line(const std::string& name, std::uint64_t count) {
  return line(name, std::to_string(count));
}

std::string decimals(const char* format, double value) {
  char text[32];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

std::string seconds(double value) { return decimals("%.6f", value); }
std::string ratio(double amount, double of) { return decimals("%.3f", of > 0 ? amount / of : 0); }

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

void writeOut(const std::string& text) {
  if (!std::ferror(stdout)) std::fwrite(text.data(), 1, text.size(), stdout);
}

/// The last lines of -pixel: the pixel's colour, in numbers and in bytes.
std::string resultOf(const PictureRequest& picture, const Pixel& at, const Vec3f& color) {
  const Rgb8 bytes = bytesFromColor(color);
  const std::string note =
      picture.render.sampling.isPlain()
          ? ""
          : "the rays above come of the one through the pixel's centre; the colour of all its "
            "samples, filtered:\n";
  return note + "color " + textOf(color) + "\npixel " + std::to_string(at.i) + " " +
         std::to_string(picture.height - 1 - at.j) + " = " + std::to_string(bytes.r) + " " +
         std::to_string(bytes.g) + " " + std::to_string(bytes.b) + "\n";
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

bool wantsInspection(const ResultRequest& results) {
  return results.pixel || results.find(Kind::heatmap);
}

void drawHeatmap(const InspectedScene& inspected, const PictureRequest& picture,
                 const RunRequest& run, std::vector<Output>& outputs) {
  Output* const heat = findOutput(outputs, Kind::heatmap);
  if (!heat) return;
  RunDisplay display(false, run.progress, RenderTargets());
  const std::vector<std::uint32_t> counts =
      countRays(inspected.scene, inspected.geometry, picture.render, run.threads, picture.width,
                picture.height, display.isWanted() ? &display : nullptr);
  display.finish();
  heat->text = drawHeatmap(counts, heat->image);
}

std::string inspectPixel(const InspectedScene& inspected, const RenderRequest& render,
                         std::vector<Output>& outputs) {
  if (!render.results.pixel) return "";
  const PictureRequest& picture = render.picture;
  const Pixel at = *render.results.pixel;
  Output* const obj = findOutput(outputs, Kind::rays);
  const SceneNames names(inspected.scene, inspected.places);
  const auto report = makeRayReport(names, inspected.geometry, picture.render, writeOut);
  const double span = inspected.scene.getSpan();
  RayLines lines(inspected.geometry, picture.render, span > 0 ? span : kEscapeLength);
  std::vector<RayObserver*> observers = {report.get()};
  if (obj) observers.push_back(&lines);
  const PixelOfPicture place = {picture.width, picture.height, at.i, at.j};
  const Vec3f color =
      tracePixel(inspected.scene, inspected.geometry, picture.render, place, observers);
  if (obj) obj->text = lines.obj();
  return resultOf(picture, at, color);
}

std::string legendOf(const SceneParser& scene, const std::vector<Output>& outputs) {
  std::string text;
  for (const Output& output : outputs) {
    if (output.kind == Kind::materials) text += MaterialColors(scene).legend(output.image);
    if (output.kind == Kind::heatmap) text += output.text;
  }
  return text;
}
