// The heat map and the tree of one pixel's rays.
#include "cli/inspection.h"

#include <cstdio>

#include "cli/run_display.h"
#include "render/heatmap.h"
#include "render/material_colors.h"
#include "render/pixel_trace.h"
#include "render/report_words.h"

namespace {

/// The length of rays that meet nothing where the scene has planes alone.
constexpr double kEscapeLength = 10;

Output* find(std::vector<Output>& outputs, Output::Kind kind) {
  for (Output& output : outputs)
    if (output.kind == kind) return &output;
  return nullptr;
}

void writeOut(const std::string& text) {
  if (!std::ferror(stdout)) std::fwrite(text.data(), 1, text.size(), stdout);
}

/// The last lines: the pixel's colour, in numbers and in bytes.
std::string resultOf(const Options& options, const Vec3f& color) {
  const Rgb8 bytes = bytesFromColor(color);
  const std::string note =
      options.render.sampling.isPlain()
          ? ""
          : "the rays above come of the one through the pixel's centre; the colour of all its "
            "samples, filtered:\n";
  return note + "color " + textOf(color) + "\npixel " + std::to_string(options.pixelX) + " " +
         std::to_string(options.pixelY) + " = " + std::to_string(bytes.r) + " " +
         std::to_string(bytes.g) + " " + std::to_string(bytes.b) + "\n";
}

}  // namespace

bool wantsInspection(const Options& options) {
  return options.tracesPixel || !options.heatmapOutput.empty();
}

void drawHeatmap(const InspectedScene& inspected, const Options& options, int threads,
                 std::vector<Output>& outputs) {
  Output* const heat = find(outputs, Output::Kind::heatmap);
  if (!heat) return;
  RunDisplay display(options, RenderTargets());
  const std::vector<std::uint32_t> counts =
      countRays(inspected.scene, inspected.geometry, options.render, threads, options.width,
                options.height, display.isWanted() ? &display : nullptr);
  display.finish();
  heat->text = drawHeatmap(counts, heat->image);
}

std::string inspectPixel(const InspectedScene& inspected, const Options& options,
                         std::vector<Output>& outputs) {
  if (!options.tracesPixel) return "";
  Output* const obj = find(outputs, Output::Kind::rays);
  const SceneNames names(inspected.scene, inspected.places);
  const auto report = makeRayReport(names, inspected.geometry, options.render, writeOut);
  const double span = inspected.scene.getSpan();
  RayLines lines(inspected.geometry, options.render, span > 0 ? span : kEscapeLength);
  std::vector<RayObserver*> observers = {report.get()};
  if (obj) observers.push_back(&lines);
  const PixelOfPicture place = {options.width, options.height, options.pixelX,
                                options.height - 1 - options.pixelY};
  const Vec3f color =
      tracePixel(inspected.scene, inspected.geometry, options.render, place, observers);
  if (obj) obj->text = lines.obj();
  return resultOf(options, color);
}

std::string legendOf(const SceneParser& scene, const std::vector<Output>& outputs) {
  std::string text;
  for (const Output& output : outputs) {
    if (output.kind == Output::Kind::materials) text += MaterialColors(scene).legend(output.image);
    if (output.kind == Output::Kind::heatmap) text += output.text;
  }
  return text;
}

void checkPixel(const Options& options) {
  if (!options.tracesPixel && !options.pixelObjOutput.empty()) {
    throw UsageError("-pixel_obj: expected a pixel to trace, for example -pixel 50 50, found none");
  }
  if (!options.tracesPixel) return;
  if (options.pixelX < options.width && options.pixelY < options.height) return;
  throw UsageError("-pixel: expected X below " + std::to_string(options.width) + " and Y below " +
                   std::to_string(options.height) + ", the size of the image, found '" +
                   std::to_string(options.pixelX) + " " + std::to_string(options.pixelY) + "'");
}
