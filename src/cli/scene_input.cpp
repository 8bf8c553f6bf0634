// Reading a scene, with its warnings.
#include "cli/scene_input.h"

#include "accel/compiled_scene.h"
#include "cli/program.h"
#include "render/sampler.h"
#include "scene/input_error.h"
#include "scene/source_text.h"

namespace {

using Pattern = SamplingOptions::Pattern;

std::string displayName(const std::string& input) {
  return input == "-" ? "standard input" : input;
}

bool needsClosedMeshes(const RenderOptions& render) {
  return render.transparentShadows || render.nestedDielectrics || render.fresnel;
}

void warnOfSimd(SimdLevel wanted) {
  const SimdLevel available = availableSimd(wanted);
  if (wanted == SimdLevel::automatic || available == wanted) return;
  complain(std::string("warning: -simd ") + nameOf(wanted) + ": this processor does not have it; " +
           nameOf(available) + " is used");
}

/// Which numbers of samples are rounded up, and to what; "" where none is.
std::string roundingWarning(const SamplingOptions& wanted) {
  const Sampler sampler(wanted);
  const int first = sampler.getNumFirst(), most = sampler.getNumSamples();
  const std::string samples = std::to_string(wanted.samples);
  if (wanted.pattern == Pattern::adaptive) {
    if (first == wanted.samples && most == wanted.maxSamples) return "";
    return "-adaptive_samples " + samples + " " + std::to_string(wanted.maxSamples) +
           ": rounded up to " + std::to_string(first) + " and " + std::to_string(most) +
           ", a square and this times a power of 4";
  }
  if (wanted.pattern == Pattern::center || most == wanted.samples) return "";
  const bool isUniform = wanted.pattern == Pattern::uniform;
  return std::string(isUniform ? "-uniform_samples " : "-jittered_samples ") + samples +
         ": rounded up to " + std::to_string(most) + ", a square";
}

void printWarnings(const SceneParser& scene, const PictureRequest& picture) {
  for (const std::string& warning : scene.getWarnings()) complain("warning: " + warning);
  warnOfSimd(picture.acceleration.simd);
  const std::string rounding = roundingWarning(picture.render.sampling);
  if (!rounding.empty()) complain("warning: " + rounding);
}

}  // namespace

SceneParser readScene(const RenderRequest& render, const RunRequest& run, ReadNotes& notes) {
  const std::string& file = render.picture.scene;
  return withMemory("to read " + displayName(file), [&] {
    const SourceText text = SourceText::read(file);
    const std::string_view bytes = text.bytes();
    if (!run.checkpoint.empty() || render.picture.isPart) {
      notes.digest = sha256(bytes.data(), bytes.size());
    }
    return SceneParser(text, render.results.pixel ? &notes.places : nullptr);
  });
}

void prepareScene(SceneParser& scene, const PictureRequest& picture, bool quiet) {
  if (!quiet) printWarnings(scene, picture);
  if (needsClosedMeshes(picture.render)) {
    withMemory("to find closed meshes", [&] { scene.findClosedMeshes(); });
  }
}

int checkScene(const std::string& file, bool quiet) {
  std::vector<std::string> warnings;
  const std::vector<InputError> mistakes = withMemory("to read " + displayName(file), [&] {
    return SceneParser::check(file.c_str(), quiet ? nullptr : &warnings);
  });
  for (const std::string& warning : warnings) complain("warning: " + warning);
  for (const InputError& mistake : mistakes) complain(mistake.what());
  if (mistakes.size() >= MistakeLog::kCapacity) {
    complain(displayName(file) + ": reading ended with mistake number " +
             std::to_string(mistakes.size()));
  }
  if (!mistakes.empty()) return kSceneAtFault;
  return print(displayName(file) + ": no mistakes found\n");
}
