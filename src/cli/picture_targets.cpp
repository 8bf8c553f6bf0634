// Outputs as the renderer wants them.
#include "cli/picture_targets.h"

#include <algorithm>

namespace {

FloatImage* exactOf(Output& output) { return output.exact.Width() > 0 ? &output.exact : nullptr; }

bool isPicture(const Output& output) { return output.kind != Output::Kind::rays; }

void setTarget(Output& output, RenderTargets& targets) {
  if (output.kind == Output::Kind::color) {
    targets.color = &output.image;
    targets.exactColor = exactOf(output);
  }
  if (output.kind == Output::Kind::depth) {
    targets.depth = &output.image;
    targets.exactDepth = exactOf(output);
    targets.depthMin = output.depthMin;
    targets.depthMax = output.depthMax;
  }
  if (output.kind == Output::Kind::normals) {
    targets.normals = &output.image;
    targets.exactNormals = exactOf(output);
  }
  if (output.kind == Output::Kind::samples) {
    targets.samples = &output.image;
    targets.samplesZoom = output.zoom;
  }
  if (output.kind == Output::Kind::materials) targets.materials = &output.image;
}

}  // namespace

bool wantsRays(const RenderTargets& targets) {
  return targets.color || targets.depth || targets.normals || targets.samples || targets.materials;
}

RenderTargets targetsOf(const RenderRequest& render, std::vector<Output>& outputs,
                        Image& unwritten) {
  const PictureRequest& picture = render.picture;
  RenderTargets targets;
  targets.window = {picture.area.left, picture.area.bottom, picture.width, picture.height};
  for (Output& output : outputs) {
    setTarget(output, targets);
  }
  const bool isEmpty = std::none_of(outputs.begin(), outputs.end(), isPicture);
  const ResultRequest& results = render.results;
  if (!wantsRays(targets) && (results.stats || (results.preview && isEmpty))) {
    unwritten = Image(picture.area.width(), picture.area.height());
    targets.color = &unwritten;
  }
  return targets;
}

const Image* untracedPicture(const std::vector<Output>& outputs) {
  const Image* picture = nullptr;
  for (const Output& output : outputs) {
    if (output.kind == Output::Kind::heatmap) return &output.image;
    if (output.kind == Output::Kind::filter) picture = &output.image;
  }
  return picture;
}
