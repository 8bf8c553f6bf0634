// Rays per second: the same rays through our compiled scene and through the rival, in turns. Ours
// go as streams, one for each tile, and, for comparison, one by one.
#include <algorithm>
#include <atomic>
#include <cstdio>
#include <map>
#include <optional>

#include "geometry/triangle_mesh.h"
#include "measure.h"
#include "mesh.h"
#include "our_side.h"
#include "rivals/embree_scene.h"
#include "rows.h"
#include "shading/phong_material.h"
#include "system/worker_threads.h"

namespace bench {
namespace {

struct Figure {
  const char* name;
  RayKind kind;
  bool anyHit;
  bool isCoherent;
};

constexpr Figure kFigures[] = {
    {"primary", RayKind::primary, false, true},
    {"shadow", RayKind::shadow, true, true},
    {"mirror, closest", RayKind::mirror, false, false},
    {"mirror, any", RayKind::mirror, true, false},
    {"diffuse, closest", RayKind::diffuse, false, false},
    {"diffuse, any", RayKind::diffuse, true, false},
};

constexpr std::size_t kStackBytes = 2 << 20;

/// Traces tiles first .. end - 1 and returns how many rays hit.
using TraceTiles = std::function<std::size_t(std::size_t first, std::size_t end)>;

/// Seconds to trace all tiles on `threads` threads, which fetch four tiles at a time.
double secondsToTrace(Clock clock, const RaySet& set, int threads, const TraceTiles& trace,
                      std::size_t& hits) {
  constexpr std::size_t kChunk = 4;
  std::atomic<std::size_t> next{0}, sum{0};
  const double seconds = secondsOf(clock, threads, [&] {
    runOnThreads(threads, kStackBytes, [&](int) {
      std::size_t mine = 0;
      for (std::size_t first; (first = next.fetch_add(kChunk)) < set.tileCount();) {
        mine += trace(first, std::min(first + kChunk, set.tileCount()));
      }
      sum += mine;
    });
  });
  hits = sum;
  return seconds;
}

Target targetOf(const Figure& figure, const std::string& size, bool againstPackets) {
  const bool isLarge = size == "10m";
  if (!figure.isCoherent) return againstPackets ? Target{} : Target{0.9, 1.2};
  if (againstPackets) return {0, 1.0};
  if (figure.kind == RayKind::primary) return {isLarge ? 1.1 : 1.5, 0};
  return {isLarge ? 1.0 : 1.3, 0};
}

/// All contenders on one mesh.
class RayRows {
 public:
  RayRows(const BenchOptions& options, const Size& size)
      : options_(options),
        size_(size),
        geometry_(displacedSphere(cutsForTriangles(size.triangles))),
        mesh_(&geometry_, &material_),
        compiled_(mesh_, hardwareThreads(), options.simd) {
    if (EmbreeScene::isAvailable()) embree_.emplace(geometry_, hardwareThreads()).build();
  }

  void run();
  /// Mrays/s of our best way with one thread, by figure.
  const std::map<std::string, double>& rates() const { return rates_; }

 private:
  void runFigure(const Figure& figure);
  bool hasStreams() const { return !options_.isSingleOnly; }
  std::vector<TraceTiles> waysOf(const Figure& figure, const RaySet& set) const;
  void printRates(const Figure& figure, int threads, const std::vector<Samples>& rates) const;
  void printHits(const std::vector<std::size_t>& hits, const RaySet& set) const;
  void runRobust();

  const BenchOptions& options_;
  const Size& size_;
  const PhongMaterial material_{{1, 1, 1}, {0, 0, 0}, 1, {0, 0, 0}, {0, 0, 0}, 1};
  MeshGeometry geometry_;
  TriangleMesh mesh_;
  CompiledScene compiled_;
  std::optional<EmbreeScene> embree_;
  std::map<std::string, double> rates_;
};

void RayRows::run() {
  printHeading("Rays on " + size_.name + ": " + std::to_string(geometry_.faceCount()) +
               " triangles, " + compiled_.describe());
  for (const Figure& figure : kFigures) runFigure(figure);
  if (embree_) runRobust();
}

void RayRows::runFigure(const Figure& figure) {
  const RaySet set = makeRays(figure.kind, compiled_, options_.side);
  const std::vector<TraceTiles> ways = waysOf(figure, set);
  std::vector<int> threadCounts = {1};
  if (hardwareThreads() > 1) threadCounts.push_back(hardwareThreads());
  std::vector<std::size_t> hits(ways.size());
  std::vector<std::function<double()>> contenders;
  for (const int threads : threadCounts) {
    for (std::size_t i = 0; i < ways.size(); ++i) {
      contenders.push_back([&, threads, i] {
        return secondsToTrace(options_.clock, set, threads, ways[i], hits[i]);
      });
    }
  }
  std::vector<Samples> rates;
  for (const Samples& seconds : inTurns(options_.rounds, contenders)) {
    rates.push_back(seconds.inverted(double(set.rays.size()) / 1e6));
  }
  const std::size_t best = hasStreams() ? 1 : 0, count = ways.size();
  for (std::size_t i = 0; i < threadCounts.size(); ++i) {
    printRates(figure, threadCounts[i],
               {rates.begin() + long(i * count), rates.begin() + long((i + 1) * count)});
  }
  printHits(hits, set);
  rates_[figure.name] = rates[best].median();
  if (threadCounts.size() > 1 && options_.clock == Clock::wall) {
    std::printf("%-34s %d threads are %.2f times one (must 1.90, aim 1.97)\n", figure.name,
                threadCounts[1], rates[count + best].median() / rates[best].median());
  }
}

/// Ours one by one and as streams; then theirs, E1 and E16.
std::vector<TraceTiles> RayRows::waysOf(const Figure& figure, const RaySet& set) const {
  std::vector<TraceTiles> ways;
  ways.push_back([&](std::size_t first, std::size_t end) {
    return traceOurSingle(compiled_, set, first, end, figure.anyHit);
  });
  if (hasStreams()) {
    ways.push_back([&](std::size_t first, std::size_t end) {
      return traceOurStreams(compiled_, set, first, end, figure.anyHit);
    });
  }
  if (!embree_) return ways;
  ways.push_back([&](std::size_t first, std::size_t end) {
    return embree_->traceSingle(set, first, end, figure.anyHit, figure.isCoherent);
  });
  ways.push_back([&](std::size_t first, std::size_t end) {
    return embree_->tracePackets(set, first, end, figure.anyHit, figure.isCoherent);
  });
  return ways;
}

/// `rates` has one entry for each of waysOf.
void RayRows::printRates(const Figure& figure, int threads,
                         const std::vector<Samples>& rates) const {
  const std::size_t best = hasStreams() ? 1 : 0;
  const std::string name = std::string(figure.name) + ", " + size_.name + ", " +
                           std::to_string(threads) + (threads == 1 ? " thread" : " threads");
  for (std::size_t way = 0; way <= best; ++way) {
    const std::string label = name + (way == 1 ? ", stream" : "");
    if (!embree_) {
      printAlone(label, "Mrays/s", rates[way]);
      continue;
    }
    const bool isBest = way == best;
    printRow(label, "Mrays/s", rates[way], "E1", rates[best + 1],
             isBest ? targetOf(figure, size_.name, false) : Target{});
    printRow(label, "Mrays/s", rates[way], "E16", rates[best + 2],
             isBest ? targetOf(figure, size_.name, true) : Target{});
  }
}

/// The rival's float arithmetic finds other answers for a few rays along edges.
void RayRows::printHits(const std::vector<std::size_t>& hits, const RaySet& set) const {
  std::printf("%36s%zu rays; hits, in that order:", "", set.rays.size());
  for (const std::size_t count : hits) std::printf(" %zu", count);
  std::printf("\n");
}

/// For information: what the rival's watertight mode costs it.
void RayRows::runRobust() {
  EmbreeScene robust(geometry_, hardwareThreads(), true);
  robust.build();
  const RaySet set = makeRays(RayKind::primary, compiled_, options_.side);
  std::size_t hits = 0;
  const auto timed = [&](const EmbreeScene& scene) {
    return secondsToTrace(
        options_.clock, set, 1,
        [&](std::size_t first, std::size_t end) {
          return scene.traceSingle(set, first, end, false, true);
        },
        hits);
  };
  const std::vector<Samples> seconds =
      inTurns(options_.rounds, {[&] { return timed(robust); }, [&] { return timed(*embree_); }});
  const double mrays = double(set.rays.size()) / 1e6;
  printRow("(their robust mode, primary, E1)", "Mrays/s", seconds[0].inverted(mrays), "E1",
           seconds[1].inverted(mrays));
}

}  // namespace

void runRayRows(const BenchOptions& options) {
  std::map<std::string, std::map<std::string, double>> rates;
  for (const Size& size : options.sizes) {
    RayRows rows(options, size);
    rows.run();
    rates[size.name] = rows.rates();
  }
  if (rates.count("1m") == 0 || rates.count("10m") == 0) return;
  std::printf("\nCost per ray, 10m against 1m, one thread (must 1.5, aim 1.25)\n");
  for (const auto& [figure, rate] : rates["1m"]) {
    std::printf("%-34s %6.2f\n", figure.c_str(), rate / rates["10m"][figure]);
  }
}

}  // namespace bench
