// The files of a run: which are wanted, whether they can be written, and writing them.
#pragma once
#include <string>
#include <vector>

#include "cli/request.h"
#include "image/float_image.h"
#include "image/image.h"
#include "image/tga.h"

struct Output : OutputRequest {
  explicit Output(const OutputRequest& request) : OutputRequest(request) {}

  Image image;             ///< empty until makeImages, of `rays` always
  TgaPlace place;          ///< of a part, where the file is a TGA
  FloatImage exact;        ///< its unclamped colours, empty where the format of the file has none
  std::string text;        ///< of `rays`: what is written; of `heatmap`: its scale
  bool isWritable = true;  ///< false where this was tried and complained of
};

/// The outputs that are wanted, without their images.
std::vector<Output> outputsOf(const ResultRequest& results);

/// Marks those that cannot be written, complaining of each, and returns how many can.
std::size_t markUnwritable(std::vector<Output>& outputs);

/// Gives every output a black image of its size (that of a part where one is wanted), and draws
/// that of the filter. Throws std::bad_alloc where memory is short.
void makeImages(std::vector<Output>& outputs, const PictureRequest& picture);

/// Writes every output that is not marked with at most `threads` threads, complaining of each that
/// fails, and returns how many were written.
std::size_t writeAll(const std::vector<Output>& outputs, int threads);
