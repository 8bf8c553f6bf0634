// The files of a run.
#include "cli/outputs.h"

#include <new>
#include <stdexcept>

#include "cli/messages.h"
#include "image/netpbm.h"
#include "image/output_file.h"
#include "image/picture_file.h"
#include "render/filter_picture.h"

namespace {

/// Calls work(); returns false, complaining, where an output fails for any reason.
template <class Work>
bool succeeds(const Output& output, const Work& work) {
  try {
    work();
    return true;
  } catch (const std::bad_alloc&) {
    complain(outputTitle(output.file) + ": not enough memory to write it");
  } catch (const std::exception& error) {
    complain(error.what());
  }
  return false;
}

bool wantsFloats(const Output& output) {
  const bool isTraced = output.kind == Output::Kind::color || output.kind == Output::Kind::depth ||
                        output.kind == Output::Kind::normals;
  return isTraced && formatOf(output.file) == PictureFormat::pfm;
}

void write(const Output& output, int threads) {
  if (output.kind == Output::Kind::rays) {
    return writeFile(output.file, output.text.data(), output.text.size());
  }
  if (wantsFloats(output)) return writePfm(output.exact, output.file);
  if (formatOf(output.file) == PictureFormat::tga) {
    return writeTga(output.image, output.file, output.place);
  }
  writePicture(output.image, output.file, threads);
}

}  // namespace

std::vector<Output> outputsOf(const ResultRequest& results) {
  return {results.outputs.begin(), results.outputs.end()};
}

std::size_t markUnwritable(std::vector<Output>& outputs) {
  std::size_t writable = 0;
  for (Output& output : outputs) {
    output.isWritable = succeeds(output, [&] { checkOutput(output.file); });
    writable += output.isWritable;
  }
  return writable;
}

void makeImages(std::vector<Output>& outputs, const PictureRequest& picture) {
  const PixelRectangle& area = picture.area;
  for (Output& output : outputs) {
    if (output.kind == Output::Kind::filter) {
      const auto filter = makeFilter(picture.render.sampling);
      output.image = drawFilter(*filter, picture.width, picture.height, output.zoom);
    } else if (output.kind != Output::Kind::rays) {
      output.image = Image(area.width() * output.zoom, area.height() * output.zoom);
      if (wantsFloats(output)) output.exact = FloatImage(area.width(), area.height());
    }
  }
}

std::size_t writeAll(const std::vector<Output>& outputs, int threads) {
  std::size_t written = 0;
  for (const Output& output : outputs) {
    written += output.isWritable && succeeds(output, [&] { write(output, threads); });
  }
  return written;
}
