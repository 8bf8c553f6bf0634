// What a run tells besides its pictures.
//
// -stats gives one line for each entry, in a fixed order, so that scripts find them by name: what
// was used, how long it took, how many rays there were of each kind and after each number of
// bounces, why branches ended, and what the answers for rays took. Numbers that are measured have a
// fixed number of decimals.
//
// -heatmap and -pixel trace their rays once more, by a tracer that is watched; they ask render/ for
// that and only bring its answers to their outputs.
#include "cli/inspection.h"

#include <cstdio>
#include <iomanip>
#include <numeric>
#include <sstream>

#include "cli/run_display.h"
#include "render/false_colors.h"
#include "render/pixel_trace.h"
#include "render/ray_report.h"

namespace {

/// The length of rays that meet nothing where the scene has planes alone.
constexpr double kEscapeLength = 10;

/// After this many bounces rays share one line of -stats.
constexpr std::size_t kLongestList = 20;

/// 0 where there is nothing to relate to.
double ratio(double amount, double of) { return of > 0 ? amount / of : 0; }

/// The counted rays; those of many bounces, of which there may be 10000, in one line.
void addRays(const RayCounts& rays, std::ostream& text) {
  text << "rays: " << rays.total() << "\neye rays: " << rays.rays(RayKind::eye)
       << "\nmirror rays: " << rays.rays(RayKind::mirror)
       << "\nrefracted rays: " << rays.rays(RayKind::refracted)
       << "\nshadow rays: " << rays.shadowRays()
       << "\nshadow rays blocked: " << rays.blockedShadowRays()
       << "\nrays to the background: " << rays.misses() << '\n';
  const std::vector<std::uint64_t>& all = rays.byBounces();
  const std::size_t listed = std::min(all.size(), kLongestList);
  for (std::size_t bounces = 0; bounces < listed; ++bounces) {
    text << "rays after " << bounces << " bounces: " << all[bounces] << '\n';
  }
  const auto rest =
      std::accumulate(all.begin() + std::ptrdiff_t(listed), all.end(), std::uint64_t(0));
  if (rest > 0) text << "rays after more bounces: " << rest << '\n';
  text << "branches ended by bounces: " << rays.ends(Outcome::tooManyBounces)
       << "\nbranches ended by weight: " << rays.ends(Outcome::tooFaint)
       << "\nbranches ended by total reflection: " << rays.ends(Outcome::totalReflection) << '\n';
}

/// What `rays` rays of one kind, `what`, took.
void addTests(const char* what, const TestCounts& tests, std::uint64_t rays, std::ostream& text) {
  text << "nodes visited for " << what << ": " << tests.nodes << "\nprimitives tested for " << what
       << ": " << tests.primitives << "\nprimitives tested per ray for " << what << ": "
       << ratio(double(tests.primitives), double(rays)) << '\n';
}

}  // namespace

std::string Stats::text(const PictureRequest& picture, int threads,
                        std::size_t pictureBytes) const {
  const auto total = double(rays.total());
  std::ostringstream text;
  text << std::fixed << std::setprecision(6) << "instruction set: " << simd << "\ntree: " << tree
       << "\nthreads: " << threads;
  if (pictureBytes > 0) text << "\nbytes of pictures: " << pictureBytes;
  text << "\nseconds reading: " << readSeconds << "\nseconds building: " << buildSeconds
       << "\nseconds tracing: " << traceSeconds << "\nseconds writing: " << writeSeconds << '\n';
  addRays(rays, text);
  text << std::setprecision(3)
       << "rays per pixel: " << ratio(total, double(picture.area.pixelCount()))
       << "\nrays per second: " << ratio(total, traceSeconds) << '\n';
  if (picture.acceleration.cellPicture == Acceleration::CellPicture::none) {
    addTests("hits", tests.nearest, rays.total() - rays.shadowRays(), text);
    addTests("shadows", tests.shadow, rays.shadowRays(), text);
  } else {
    text << "intersection tests: not counted in a picture of cells\n";
  }
  return text.str();
}

/// Has a line of progress of its own, as all rays are traced once more.
void drawHeatmap(const RayTracer& tracer, const RunRequest& run, std::vector<Output>& outputs) {
  Output* const heat = findOutput(outputs, OutputRequest::Kind::heatmap);
  if (!heat) return;
  RunDisplay display(run.progress);
  const std::vector<std::uint32_t> counts =
      countRays(tracer, run.threads, heat->image.Width(), heat->image.Height(), &display);
  display.finish();
  heat->text = drawHeatmap(counts, heat->image);
}

std::string inspectPixel(const RayTracer& tracer, const ObjectPlaces& places,
                         const RenderRequest& render, std::vector<Output>& outputs) {
  if (!render.results.pixel) return "";
  const PictureRequest& picture = render.picture;
  const PictureSpot at = *render.results.pixel;
  // One observer tells what becomes of each ray, in words, until standard output fails; the other
  // one, where it is wanted, keeps where the ray went.
  const auto report = makeRayReport(tracer, places, [](const std::string& line) {
    if (!std::ferror(stdout)) std::fwrite(line.data(), 1, line.size(), stdout);
  });
  // A ray that meets nothing is drawn as long as the scene.
  const double span = tracer.scene().getSpan();
  RayLines lines(tracer, span > 0 ? span : kEscapeLength);
  Output* const obj = findOutput(outputs, OutputRequest::Kind::rays);
  std::vector<RayObserver*> observers = {report.get()};
  if (obj) observers.push_back(&lines);
  // Users count rows from the top, the camera from the bottom.
  const PictureWindow window = {at.x, picture.height - 1 - at.y, picture.width, picture.height};
  const Vec3f color = tracePixel(tracer, window, observers);
  if (obj) obj->text = lines.obj();
  // The colour is the picture's, of all samples; what was reported is the central ray. So it is
  // told last, in numbers and as the bytes that a file has.
  const Rgb8 bytes = bytesFromColor(color);
  const char* const note =
      "the rays above come of the one through the pixel's centre; the colour of all its samples, "
      "filtered:\n";
  return joined(picture.render.sampling.isPlain() ? "" : note, "color ", textOf(color), "\npixel ",
                at.x, ' ', at.y, " = ", int(bytes.r), ' ', int(bytes.g), ' ', int(bytes.b), '\n');
}
