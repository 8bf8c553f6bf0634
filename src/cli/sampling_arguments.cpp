// The arguments about samples and filters. Of several patterns the last one counts, and of several
// filters.
#include "cli/sampling_arguments.h"

#include <algorithm>
#include <limits>

#include "cli/option_values.h"
#include "render/sampler.h"

namespace {

using Given = const GivenOption&;
using Pattern = SamplingOptions::Pattern;
using FilterKind = SamplingOptions::FilterKind;

void setPattern(Given given, Options& options, Pattern pattern) {
  SamplingOptions& sampling = options.render.sampling;
  sampling.samples = wholeNumber(given, 0, "N", 1, SamplingOptions::kMaxSamples);
  sampling.pattern = pattern;
}

void setAdaptive(Given given, Options& options) {
  SamplingOptions& sampling = options.render.sampling;
  const int first = wholeNumber(given, 0, "MIN", 1, SamplingOptions::kMaxFirstSamples);
  sampling.maxSamples = wholeNumber(given, 1, "MAX", first, SamplingOptions::kMaxSamples);
  sampling.tolerance = numberInRange(given, 2, 0, 1, "a number from 0 to 1 for TOLERANCE");
  sampling.samples = first;
  sampling.pattern = Pattern::adaptive;
}

void setFilter(Given given, Options& options, FilterKind kind, int most) {
  SamplingOptions& sampling = options.render.sampling;
  constexpr double kLeast = std::numeric_limits<double>::min();
  sampling.filterSize = numberInRange(
      given, 0, kLeast, most, "a number of pixels above 0 and up to " + std::to_string(most));
  sampling.filter = kind;
}

std::vector<OptionRow> patternRows(const char* group) {
  return {
      {group, "random_samples", nullptr, "N", nullptr,
       "N rays at random places in each pixel, 1 to 65536",
       [](Given given, Options& o) { setPattern(given, o, Pattern::random); }},
      {group, "uniform_samples", nullptr, "N", nullptr,
       "N rays in each pixel, at the centres of a square grid; N is rounded up to a square",
       [](Given given, Options& o) { setPattern(given, o, Pattern::uniform); }},
      {group, "jittered_samples", nullptr, "N", nullptr,
       "N rays in each pixel, one at random in each cell of such a grid",
       [](Given given, Options& o) { setPattern(given, o, Pattern::jittered); }},
      {group, "adaptive_samples", nullptr, "MIN MAX TOLERANCE", nullptr,
       "MIN jittered rays in each pixel, 1 to 256, and up to MAX where colours differ by more than "
       "TOLERANCE, 0 to 1",
       setAdaptive},
  };
}

std::vector<OptionRow> filterRows(const char* group) {
  constexpr int kMost = SamplingOptions::kMaxReach;
  return {
      {group, "box_filter", nullptr, "R", "0.5",
       "a pixel is the mean of the samples up to R pixels to each side of its centre; R is above 0 "
       "and up to 32",
       [](Given given, Options& o) { setFilter(given, o, FilterKind::box, kMost); }},
      {group, "tent_filter", nullptr, "R", nullptr,
       "samples at distance d count 1 - d / R, up to R pixels away; R is up to 32",
       [](Given given, Options& o) { setFilter(given, o, FilterKind::tent, kMost); }},
      {group, "gaussian_filter", nullptr, "SIGMA", nullptr,
       "samples at distance d count exp(-d^2 / (2 SIGMA^2)), up to 2 SIGMA pixels away; SIGMA is "
       "up to 16",
       [](Given given, Options& o) { setFilter(given, o, FilterKind::gaussian, kMost / 2); }},
  };
}

std::vector<OptionRow> pictureRows(const char* group) {
  return {
      {group, "render_samples", nullptr, "FILE ZOOM", nullptr,
       "write a picture of the samples, each a dot of its colour, ZOOM times as large as the image",
       [](Given given, Options& o) {
         o.samplesZoom = wholeNumber(given, 1, "ZOOM", 1, kMaxImageSide);
         o.samplesOutput = outputName(given);
       }},
      {group, "render_filter", nullptr, "FILE ZOOM", nullptr,
       "write a picture of the filter's weights for the middle pixel, ZOOM times as large as the "
       "image",
       [](Given given, Options& o) {
         o.filterZoom = wholeNumber(given, 1, "ZOOM", 1, kMaxImageSide);
         o.filterOutput = outputName(given);
       }},
  };
}

void checkEnlarged(const char* argument, const Options& options, int zoom, int more) {
  const int longer = std::max(options.width, options.height);
  if (zoom <= (kMaxImageSide - more) / longer) return;
  throw UsageError(std::string("-") + argument + ": expected a ZOOM of at most " +
                   std::to_string((kMaxImageSide - more) / longer) + " for an image of " +
                   std::to_string(options.width) + " x " + std::to_string(options.height) +
                   " pixels, found '" + std::to_string(zoom) + "'");
}

}  // namespace

std::vector<OptionRow> samplingRows() {
  const char* group = "Samples in a pixel";
  std::vector<OptionRow> rows;
  for (const auto& some : {patternRows(group), filterRows(group), pictureRows(group)})
    rows.insert(rows.end(), some.begin(), some.end());
  return rows;
}

void checkEnlargedSizes(const Options& options) {
  if (!options.samplesOutput.empty())
    checkEnlarged("render_samples", options, options.samplesZoom, 0);
  if (!options.filterOutput.empty()) checkEnlarged("render_filter", options, options.filterZoom, 1);
}

std::string roundingWarning(const Options& options) {
  const SamplingOptions& wanted = options.render.sampling;
  const auto sampler = makeSampler(wanted);
  const int first = sampler->getNumFirst(), most = sampler->getNumSamples();
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
