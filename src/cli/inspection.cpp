// The heat map and the tree of one pixel's rays.
#include "cli/inspection.h"

#include <cstdio>

#include "cli/run_display.h"
#include "render/heatmap.h"
#include "render/material_colors.h"
#include "render/number_text.h"
#include "render/pixel_trace.h"
#include "render/ray_lines.h"
#include "render/ray_report.h"

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
std::string resultOf(const PictureRequest& picture, const Pixel& at, const PixelColors& colors) {
  const Rgb8 bytes = bytesFromColor(colors.pixel);
  const std::string note =
      picture.render.sampling.isPlain()
          ? ""
          : "the rays above come of the one through the pixel's centre; the colour of all its "
            "samples, filtered:\n";
  return note + "color " + textOf(colors.pixel) + "\npixel " + std::to_string(at.i) + " " +
         std::to_string(picture.height - 1 - at.j) + " = " + std::to_string(bytes.r) + " " +
         std::to_string(bytes.g) + " " + std::to_string(bytes.b) + "\n";
}

}  // namespace

bool wantsInspection(const ResultRequest& results) {
  return results.pixel || results.find(OutputRequest::Kind::heatmap);
}

void drawHeatmap(const InspectedScene& inspected, const PictureRequest& picture,
                 const RunRequest& run, std::vector<Output>& outputs) {
  Output* const heat = find(outputs, Output::Kind::heatmap);
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
  Output* const obj = find(outputs, Output::Kind::rays);
  const SceneNames names(inspected.scene, inspected.places);
  RayReport report(names, inspected.geometry, picture.render, writeOut);
  const double span = inspected.scene.getSpan();
  RayLines lines(inspected.geometry, picture.render, span > 0 ? span : kEscapeLength);
  std::vector<RayObserver*> observers = {&report};
  if (obj) observers.push_back(&lines);
  const PixelOfPicture place = {picture.width, picture.height, at.i, at.j};
  const PixelColors colors =
      tracePixel(inspected.scene, inspected.geometry, picture.render, place, observers);
  if (obj) obj->text = lines.obj();
  return resultOf(picture, at, colors);
}

std::string legendOf(const SceneParser& scene, const std::vector<Output>& outputs) {
  std::string text;
  for (const Output& output : outputs) {
    if (output.kind == Output::Kind::materials) text += MaterialColors(scene).legend(output.image);
    if (output.kind == Output::Kind::heatmap) text += output.text;
  }
  return text;
}
