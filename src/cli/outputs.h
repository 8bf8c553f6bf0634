// The files of a run: whether each is a file of its own, whether it can be written, its image, and
// writing it.
#pragma once
#include <string>
#include <vector>

#include "cli/request.h"
#include "image/image.h"
#include "image/picture_file.h"
#include "render/renderer.h"

/// True where both outputs go to the same place, whether or not there is a file yet: links are
/// followed, "-" is standard output, whatever that is. False where one of them is empty, or a
/// device such as /dev/null, which holds nothing that could be lost.
bool isSameOutput(const std::string& a, const std::string& b);

/// Throws UsageError where two outputs, of which `checkpoint` is one unless it is empty, are the
/// same file, or an output is the scene or one of `inputFiles`, or standard output (by whatever
/// name) where lines are printed there. See isSameOutput.
void checkFiles(const RenderRequest& render, const std::string& checkpoint,
                const std::vector<std::string>& inputFiles = {});

/// Throws UsageError, in the name of the `arguments` that name them, where both are the same.
void checkDifferent(const std::string& arguments, const std::string& a, const std::string& b);

/// An output and what is in it. One without a file is traced and not written.
struct Output : OutputRequest {
  explicit Output(const OutputRequest& request, PictureFormat unnamed = PictureFormat::tga)
      : OutputRequest(request), format(formatOf(file, unnamed).value_or(PictureFormat::tga)) {}

  PictureFormat format;    ///< of the file, but for `rays`
  Image image;             ///< empty until makeImages, of `rays` always
  TgaPart part;            ///< where it is one, and the file a TGA
  FloatImage exact;        ///< its unclamped colours, empty where the format of the file has none
  std::string text;        ///< of `rays`: what is written; of `heatmap`: its scale
  bool isWritable = true;  ///< false where it could not be, which has been complained of
};

/// The outputs that are wanted, without their images. A name without an ending is a file of the
/// course's format, but a part's always a TGA.
std::vector<Output> outputsOf(const RenderRequest& render);

/// Marks those whose files cannot be written, complaining of each, and returns how many can.
std::size_t markUnwritable(std::vector<Output>& outputs, const PictureRequest& picture);

/// Gives every output a black image of its size (that of a part where one is wanted), and draws
/// that of the filter. Returns those that the renderer fills; it points into `outputs`. Throws
/// std::bad_alloc where memory is short.
RenderTargets makeImages(std::vector<Output>& outputs, const PictureRequest& picture);

/// False where the renderer has nothing to do.
bool wantsRays(const std::vector<Output>& outputs);

/// Writes every output that has a file and is not marked, with at most `threads` threads,
/// complaining of each that fails, and returns how many were written.
std::size_t writeAll(std::vector<Output>& outputs, int threads);
