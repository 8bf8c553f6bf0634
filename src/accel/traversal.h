// Traversal: what the kernels of every instruction set work on, and what they hand back.
//
// Filter in float, decide in double. A kernel walks a WideBvh with floats only and concludes what
// its error bounds prove; what they leave open becomes a Candidate, which `resolve` decides with
// the primitive's own double function. So every instruction set gives the same answer.
//
// The ray is in the normalised space of the tree, its origin moved to where it enters the tree's
// box and its direction scaled so that the largest component is 1 to 2: t' = (t - shift) * tScale,
// and t' >= 0 for everything in the tree.
//
// Error bounds, e = 2^-24, R = reach (the largest component of any vertex relative to the origin),
// D = the largest component of the direction, E = the largest component of an edge of the leaf:
//   an edge function           64 e R D E   (sum of three products of a cross product)
//   the determinant            48 e E E D
//   the distance's numerator   80 e E E R
// from the standard model of rounding, every operation with a relative error of e (Higham,
// "Accuracy and Stability of Numerical Algorithms", 2002). They hold while E >= 2^-26 R; smaller
// triangles are all left open (a leaf's E is at least 2^-40, so that no product underflows), and so
// is everything for a ray that starts more than 2^56 sizes of the tree away.
//
// The surface that a ray leaves lies at t = 0 give or take rounding, so it is never proven to be
// hit beyond tmin: leaving it out can wait for the double function.
#pragma once
#include <cstdint>

#include "accel/test_tally.h"
#include "accel/wide_bvh.h"

namespace accel {

/// A primitive that the filter could not rule out: lane `lane` of the leaf at `words`.
struct Candidate {
  const std::uint32_t* words;
  int lane;
  float tLow;  ///< it is not hit at any t' below this
};

struct RayPacket;
struct TriangleHits;

struct TraversalRay {
  static constexpr int kMostCandidates = 16;

  const WideNode* nodes;
  const std::uint32_t* leaves;
  float originHigh[4], originLow[4];  ///< origin as the sum of two floats
  float direction[4];
  float reciprocal[4];                ///< of the direction, finite
  float nearOffset[4], farOffset[4];  ///< box test: t' = plane * reciprocal + offset, widened
  int nearRow[3];                     ///< which of WideNode::planes is the near one on this axis
  float tminDown, tminUp;             ///< below and above tmin', both >= 0
  float tmaxUp, tmaxDown;             ///< above and below tmax'
  float reach;                        ///< R
  float edgeError;                    ///< 64 e R D
  float determinantError;             ///< 48 e D
  float numeratorError;               ///< 80 e R
  float inverseLengthSquared;         ///< of the direction

  std::uint32_t nodesVisited, primitivesTested;
  int candidateCount;
  Candidate candidates[kMostCandidates];

  /// Decides all candidates and empties the list; may lower tmaxUp and tmaxDown. True ends the
  /// traversal.
  bool (*resolve)(TraversalRay& ray);
  /// Asks object `id`; may lower tmaxUp and tmaxDown. True ends the traversal.
  bool (*askObject)(TraversalRay& ray, std::uint32_t id);
  void* context;  ///< for these two
};

/// How a ray's own t and the tree's t' belong together: t' = t * scale - shift.
struct ParameterMap {
  double scale = 1, shift = 0;

  /// Floats surely not above, and surely not below, the t' of t.
  float below(double t) const;
  float above(double t) const;
};

/// What a traversal is for.
enum class Purpose {
  nearest,  ///< a proven hit lowers tmax'
  any,      ///< a proven hit ends it
  all       ///< every primitive that is not ruled out becomes a candidate
};

/// Rays to be prepared together. Rows are read up to a multiple of eight.
struct RayRows {
  static constexpr int kMost = 64;
  double origin[3][kMost], direction[3][kMost];
  double tmin[kMost], tmax[kMost];
};

/// Both directions of one instruction set; each walks the tree and returns true where a proven
/// hit or a call back ended it. Candidates may be left over: the caller resolves them.
struct Kernels {
  const char* name;
  bool (*nearest)(TraversalRay& ray);
  bool (*any)(TraversalRay& ray);
  bool (*all)(TraversalRay& ray);
  /// Find the nearest hits of a packet, or which of its rays are blocked.
  void (*nearestOfPacket)(RayPacket& packet);
  void (*anyOfPacket)(RayPacket& packet);
  void (*computeHits)(TriangleHits& hits);
  /// Fills `prepared` but for the tree, its candidates and call backs, and stores the map of its
  /// t'. Origin and direction are three numbers each. False where the ray misses the box of the
  /// tree between tmin and tmax.
  bool (*prepareRay)(const WideBvh& bvh, const double* origin, const double* direction, double tmin,
                     double tmax, TraversalRay& prepared, ParameterMap& time);
  /// The same for `count` rays; bit i of the result is the answer for ray i.
  std::uint64_t (*prepareRays)(const WideBvh& bvh, const RayRows& rows, int count,
                               TraversalRay* prepared, ParameterMap* times);
  /// Where it is noted what all this takes; null where nobody asks. Not owned.
  TestTally* tally = nullptr;

  /// Adds to the tally what one walk has taken: of a TraversalRay or a RayPacket.
  template <class Walked>
  void countNearest(const Walked& walked) const {
    if (tally) tally->addNearest({walked.nodesVisited, walked.primitivesTested});
  }
  template <class Walked>
  void countShadow(const Walked& walked) const {
    if (tally) tally->addShadow({walked.nodesVisited, walked.primitivesTested});
  }
};

Kernels baselineKernels();
Kernels avx2Kernels();    // only where the processor has AVX2, FMA, BMI and BMI2
Kernels avx512Kernels();  // only where it has AVX-512 F, VL, DQ, BW too

/// The most entries that a walk can have open: seven for each level of the deepest tree.
constexpr int kMostLevels = 96;
constexpr int kStackSize = kMostLevels * (kWidth - 1) + 1;

}  // namespace accel
