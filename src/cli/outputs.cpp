// The files of a run.
#include "cli/outputs.h"

#include <new>
#include <stdexcept>

#include "cli/messages.h"
#include "cli/part_arguments.h"
#include "image/netpbm.h"
#include "image/output_file.h"
#include "image/picture_file.h"
#include "render/film.h"

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

std::vector<Output> wantedOutputs(const Options& options) {
  std::vector<Output> outputs;
  const auto add = [&](Output::Kind kind, const std::string& file) {
    if (!file.empty()) outputs.push_back({kind, file, Image(), TgaPlace(), FloatImage(), "", true});
  };
  add(Output::Kind::color, options.output);
  add(Output::Kind::depth, options.depthOutput);
  add(Output::Kind::normals, options.normalsOutput);
  add(Output::Kind::samples, options.samplesOutput);
  add(Output::Kind::filter, options.filterOutput);
  add(Output::Kind::materials, options.materialsOutput);
  add(Output::Kind::heatmap, options.heatmapOutput);
  add(Output::Kind::rays, options.pixelObjOutput);
  return outputs;
}

std::size_t markUnwritable(std::vector<Output>& outputs) {
  std::size_t writable = 0;
  for (Output& output : outputs) {
    output.isWritable = succeeds(output, [&] { checkOutput(output.file); });
    writable += output.isWritable;
  }
  return writable;
}

void makeImages(std::vector<Output>& outputs, const Options& options) {
  for (Output& output : outputs) {
    if (output.kind == Output::Kind::filter) {
      const SamplingOptions& sampling = options.render.sampling;
      output.image = drawFilter({sampling.filter, sampling.filterSize}, options.width,
                                options.height, options.filterZoom);
    } else if (output.kind != Output::Kind::rays) {
      const int zoom = output.kind == Output::Kind::samples ? options.samplesZoom : 1;
      const PixelRectangle area = renderedArea(options);
      output.image = Image(area.width() * zoom, area.height() * zoom);
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
