// Reading a scene, with its warnings; and building what answers for its objects.
//
// The scene is read whole, so that the bytes that are parsed are those of its digest. Warnings are
// those of the scene first, then what of the arguments cannot be had as it was asked for. None of
// the ways to answer for objects changes a pixel, but for the cells of a grid, which are drawn in
// place of the scene.
#include "cli/scene_setup.h"

#include "accel/compiled_scene.h"
#include "accel/grid/grid.h"
#include "accel/grid/grid_view.h"
#include "accel/test_tally.h"
#include "cli/program.h"
#include "cli/runs.h"
#include "render/sampler.h"
#include "scene/input_error.h"
#include "scene/source_text.h"

namespace {

using Pattern = SamplingOptions::Pattern;

/// What messages call the scene.
std::string displayName(const std::string& input) {
  return input == "-" ? "standard input" : input;
}

/// The best that the processor has is taken in its stead.
void warnOfSimd(SimdLevel wanted) {
  const SimdLevel available = availableSimd(wanted);
  if (wanted == SimdLevel::automatic || available == wanted) return;
  complain(std::string("warning: -simd ") + nameOf(wanted) + ": this processor does not have it; " +
           nameOf(available) + " is used");
}

/// Numbers of samples may have been rounded up.
void warnOfSamples(const SamplingOptions& wanted, const Course& course) {
  const Sampler sampler(wanted);
  const int first = sampler.getNumFirst(), most = sampler.getNumSamples();
  const bool isKept = first == wanted.samples;
  if (wanted.pattern == Pattern::adaptive) {
    if (isKept && most == wanted.maxSamples) return;
    complain(joined("warning: -adaptive_samples ", wanted.samples, ' ', wanted.maxSamples,
                    ": rounded up to ", first, " and ", most,
                    ", a square and this times a power of 4"));
  } else if (wanted.pattern != Pattern::center && !isKept) {
    const char* const grid = course.uniformSamples == Pattern::uniform ? "uniform" : "regular";
    complain(joined("warning: -", wanted.pattern == Pattern::uniform ? grid : "jittered",
                    "_samples ", wanted.samples, ": rounded up to ", first, ", a square"));
  }
}

/// An automatic epsilon looks at the thickness itself.
void warnOfThinGlass(const ThinSolid& thinnest, const Epsilon& epsilon, const std::string& file) {
  if (epsilon.kind != Epsilon::Kind::fixed || thinnest.thickness >= epsilon.value) return;
  complain(joined("warning: ", file, ":", thinnest.line, ": the transparent object is ",
                  thinnest.thickness, " thick, less than the epsilon of ", epsilon.value,
                  ": rays that enter it pass its back; -epsilon adaptive sees it"));
}

}  // namespace

SceneParser readScene(RenderRequest& render, const RunRequest& run, ReadNotes& notes) {
  const std::string& file = render.picture.scene;
  return withMemory("to read " + displayName(file), [&] {
    const SourceText text = SourceText::read(file);
    const std::string_view bytes = text.bytes();
    // Only what is taken up another time, or put together with others, has to know its scene again.
    if (!run.checkpoint.empty() || render.picture.isPart) {
      notes.digest = sha256(bytes.data(), bytes.size());
    }
    const Course* const withBounces = render.picture.course->withBounces;
    if (withBounces && SceneParser::hasGlass(text)) render = adapted(render, *withBounces, {});
    return SceneParser(text, render.results.pixel ? &notes.places : nullptr, render.picture.rules);
  });
}

void prepareScene(SceneParser& scene, const PictureRequest& picture, bool quiet) {
  const RenderOptions& options = picture.render;
  if (!quiet) {
    for (const std::string& warning : scene.getWarnings()) complain("warning: " + warning);
    warnOfSimd(picture.acceleration.simd);
    warnOfSamples(options.sampling, *picture.course);
    for (const std::string& note : picture.notes) complain("note: " + note);
    warnOfThinGlass(scene.getThinnestSolid(), options.epsilon, displayName(picture.scene));
  }
  // These ask what a ray is inside of, which only a closed mesh can tell.
  if (options.transparentShadows || options.nestedDielectrics || options.fresnel) {
    withMemory("to find closed meshes", [&] { scene.findSolids(); });
  }
}

int checkScene(const PictureRequest& picture, bool quiet) {
  const std::string& file = picture.scene;
  std::vector<std::string> warnings;
  const std::vector<InputError> mistakes = withMemory("to read " + displayName(file), [&] {
    return SceneParser::check(file.c_str(), quiet ? nullptr : &warnings, picture.rules);
  });
  for (const std::string& warning : warnings) complain("warning: " + warning);
  for (const InputError& mistake : mistakes) complain(mistake.what());
  // There may be more of them.
  if (mistakes.size() >= MistakeLog::kCapacity) {
    complain(joined(displayName(file), ": reading ended with mistake number ", mistakes.size()));
  }
  if (!mistakes.empty()) return kSceneAtFault;
  return print(displayName(file) + ": no mistakes found\n");
}

SceneGeometry::SceneGeometry(const Object3D& root, const Acceleration& wanted,
                             const CellRules& cells, int threads, bool counts)
    : root_(root) {
  TestTally* const tally = counts ? &tally_ : nullptr;
  if (wanted.kind == Acceleration::Kind::fast) {
    auto compiled = std::make_unique<CompiledScene>(root, threads, wanted.simd, tally);
    simd_ = nameOf(availableSimd(wanted.simd));
    description_ = compiled->describe();
    built_ = std::move(compiled);
  } else if (wanted.cellPicture != Acceleration::CellPicture::none) {
    buildCells(wanted, cells);
  } else if (wanted.kind == Acceleration::Kind::grid) {
    auto grid = std::make_unique<Grid>(root, wanted.gridSize, tally);
    description_ = grid->describe();
    built_ = std::move(grid);
  } else if (tally) {
    built_ = std::make_unique<CountingTree>(root, *tally);
  }
}

/// Where cells are not told apart, all are painted as those of one object.
void SceneGeometry::buildCells(const Acceleration& wanted, const CellRules& rules) {
  const bool counts = rules.alwaysCounts || wanted.cellPicture == Acceleration::CellPicture::counts;
  for (const CellPaint& each : rules.paints) {
    paints_.emplace_back(each.color, Vec3f(), 1.0f, Vec3f(), Vec3f(), 1.0f);
    paints_.back().setNumber(-int(paints_.size()));  // none of the scene's, and all different
  }
  std::vector<const Material*> palette;  // by the number of objects
  for (std::size_t i = 0; i < (counts ? paints_.size() : 1); ++i) {
    palette.resize(rules.paints[i].most, &paints_[i]);
  }
  CellCounts cells = rules.areTouched ? countTouched(root_, wanted.gridSize)
                                      : countReached(root_, wanted.gridSize);
  built_ = std::make_unique<GridView>(std::move(cells), std::move(palette));
  description_ = "cells of a grid";
}
