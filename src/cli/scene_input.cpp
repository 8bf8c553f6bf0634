// Reading a scene, with its warnings.
#include "cli/scene_input.h"

#include "accel/compiled_scene.h"
#include "cli/messages.h"
#include "cli/out_of_memory.h"
#include "cli/sampling_arguments.h"
#include "scene/input_error.h"
#include "scene/source_text.h"

namespace {

std::string displayName(const std::string& input) {
  return input == "-" ? "standard input" : input;
}

bool needsClosedMeshes(const RenderOptions& render) {
  return render.transparentShadows || render.nestedDielectrics || render.fresnel;
}

void warnOfSimd(const Options& options) {
  const SimdLevel available = availableSimd(options.simd);
  if (options.simd == SimdLevel::automatic || available == options.simd) return;
  complain(std::string("warning: -simd ") + nameOf(options.simd) +
           ": this processor does not have it; " + nameOf(available) + " is used");
}

void printWarnings(const SceneParser& scene, const Options& options) {
  if (options.quiet) return;
  for (const std::string& warning : scene.getWarnings()) complain("warning: " + warning);
  warnOfSimd(options);
  const std::string rounding = roundingWarning(options);
  if (!rounding.empty()) complain("warning: " + rounding);
}

}  // namespace

SceneParser readScene(const Options& options, ReadNotes& notes) {
  return withMemory("to read " + displayName(options.input), [&] {
    const SourceText text = SourceText::read(options.input);
    const std::string_view bytes = text.bytes();
    if (!options.checkpoint.empty() || options.part.isWanted()) {
      notes.digest = sha256(bytes.data(), bytes.size());
    }
    return SceneParser(text, options.tracesPixel ? &notes.places : nullptr);
  });
}

void prepareScene(SceneParser& scene, const Options& options) {
  printWarnings(scene, options);
  if (needsClosedMeshes(options.render)) {
    withMemory("to find closed meshes", [&] { scene.findClosedMeshes(); });
  }
}

int checkScene(const Options& options) {
  std::vector<std::string> warnings;
  const std::vector<InputError> mistakes = withMemory("to read " + displayName(options.input), [&] {
    return SceneParser::check(options.input.c_str(), options.quiet ? nullptr : &warnings);
  });
  for (const std::string& warning : warnings) complain("warning: " + warning);
  for (const InputError& mistake : mistakes) complain(mistake.what());
  if (mistakes.size() >= MistakeLog::kCapacity) {
    complain(displayName(options.input) + ": reading ended with mistake number " +
             std::to_string(mistakes.size()));
  }
  if (!mistakes.empty()) return kSceneAtFault;
  return print(displayName(options.input) + ": no mistakes found\n");
}
