// Stream: rays that walk one tree together, and what the kernels of every instruction set work on.
//
// The walk. Rays are sorted by the octant of their direction, and those of one octant begin in a
// list at the root. Each entry of the stack is a node and the list of the rays that are to visit
// it. The node's eight boxes are loaded once and every ray of the list is tested against them; each
// box that is met by any ray becomes an entry, with the list of the rays that meet it, and the box
// that a ray enters soonest is visited next. At a leaf the list is what its primitives are tested
// against. A single ray is a stream of one. So there is one walk for nearest hits, for shadows and
// for crossings, and rays need not have anything in common but their number.
// Source: Barringer and Akenine-Moeller, "Dynamic Ray Stream Traversal", 2014.
//
// Filter in float, decide in double. A kernel computes with floats only, and concludes what its
// error bounds prove: a triangle is missed, or is hit nearer than anything before. What they leave
// open becomes a Candidate, which `resolve` decides with the primitive's own double function. So
// every instruction set gives the same answer.
//
// Rays enter the tree of a mesh under a Transform by one multiplication more, and are sorted by
// octant there. To give them a table of their own, and to sort them before they are prepared, took
// 1.15 of the instructions of a picture of 10,000 instances.
//
// A ray is in the normalised space of the tree, its origin moved to where it enters the tree's box
// and its direction scaled so that the largest component is 1 to 2: t' = t * scale - shift, and
// t' >= 0 for everything in the tree.
//
// Bounds are local. A node that is much smaller than what rays were prepared for begins a frame:
// its rays are put aside and prepared again for its box, from where they enter it, and come back as
// they were when all below it is done. So what is large or far away costs what is small nothing but
// that. t' has another shift within, so candidates are decided at both ends of a frame.
//
// Error bounds, e = 2^-24, R = reach (the largest component of any vertex relative to the origin),
// D = the largest component of the direction, E = the largest component of an edge of the leaf:
//   an edge function           64 e R D E   (sum of three products of a cross product)
//   the determinant            48 e E E D
//   the distance's numerator   80 e E E R
//   where a sphere lies        128 e R       (its centre beside the ray, and along it)
// from the standard model of rounding, every operation with a relative error of e (Higham,
// "Accuracy and Stability of Numerical Algorithms", 2002). They hold while E >= 2^-26 R; smaller
// triangles are all left open (E and R are at least 2^-40, so that no product vanishes), and so
// is everything for a ray that starts more than 2^56 sizes of the tree away.
//
// The surface that a ray leaves lies at t = 0 give or take rounding, so it is never proven to be
// hit beyond tmin: leaving it out can wait for the double function.
#pragma once
#include <cstdint>
#include <limits>

#include "accel/mesh_tree.h"
#include "accel/test_tally.h"
#include "accel/wide_bvh.h"
#include "geometry/ray_table.h"
#include "math/number.h"

namespace accel {

/// What, rounded to floats, is surely not above, and surely not below, t' = t * scale - shift:
/// -infinity and infinity where floats are too small.
template <class Number>
void boundsOf(const Number& t, const Number& scale, const Number& shift, Number& below,
              Number& above) {
  constexpr double kMost = 0x1p127;  // half of what a float holds, so that sums with it are held
  const Number x = t * scale - shift, slack = absolute(x) * 0x1p-23 + absolute(shift) * 0x1p-46;
  const Number most = kMost, endless = __builtin_inf();
  below = choose(x > most, most, choose(x < -most, -endless, x - slack));
  above = choose(x < -most, -most, choose(x > most, endless, x + slack));
}

/// How a ray's own t and the tree's t' belong together: t' = t * scale - shift.
struct ParameterMap {
  double scale, shift;
};

/// What the boxes of nodes are tested against: t' = plane * reciprocal + offset, widened so that
/// nothing is missed by rounding.
struct BoxRay {
  float reciprocal[3];  ///< of the direction, finite
  float nearOffset[3], farOffset[3];
  float tminDown;     ///< below tmin', >= 0
  float tmaxUp;       ///< above tmax'; -infinity where the ray wants nothing any more
  std::uint32_t row;  ///< of the ray in its table
};
static_assert(sizeof(BoxRay) == 48, "three quarters of a cache line");

/// What primitives are tested against.
struct PrimitiveRay {
  float originHigh[3], originLow[3];  ///< the origin as the sum of two floats
  float direction[3];
  float tminUp, tmaxDown;      ///< above tmin' (>= 0) and below tmax'
  float reach;                 ///< R
  float edgeError;             ///< 64 e R D
  float determinantError;      ///< 48 e D
  float numeratorError;        ///< 80 e R
  float inverseLengthSquared;  ///< of the direction
};
static_assert(sizeof(PrimitiveRay) == 64, "one cache line");

/// A primitive that the filter could not rule out for a ray.
struct Candidate {
  std::uint32_t leaf;  ///< the offset of its leaf's words
  float tLow;          ///< it is not hit at any t' below this
  std::uint16_t ray;   ///< of the stream
  std::uint8_t lane;   ///< its place in the leaf
  bool isProven;       ///< it is surely hit, between tmin and what tmax was; or crossed, at any t
};

/// A ray as it was outside of a frame.
struct OutsideRay {
  BoxRay box;
  PrimitiveRay primitive;
  ParameterMap map;
};

/// A node or a leaf that rays are to visit, or a frame that they leave.
struct StreamEntry {
  static constexpr std::uint32_t kFrameEnd = kLeafBit - 1;

  std::uint32_t child;  ///< as in WideNode, or kFrameEnd
  std::uint32_t first;  ///< its list begins here in the pool
  std::uint32_t end;    ///< of the pool's part in use while it is visited
  std::uint32_t count;  ///< of rays
};

struct Stream {
  /// As many candidates may wait to be decided.
  static constexpr int kMostCandidates = 1024;

  // What is asked.
  const WideBvh* bvh;
  const WideNode* nodes;       ///< of the tree
  const std::uint32_t* words;  ///< of its leaves
  const RayTable* rays;
  RowList list;           ///< the rows that are asked
  const Matrix* inverse;  ///< of the Transform that the tree stands under; null where of none

  // The rays of the list that meet the tree's box, none as yet. There is room for one more.
  int count;
  std::uint32_t octantCount[8];  ///< of those whose direction lies in octant o
  std::uint32_t octantRoom;      ///< their list is at o times this in the pool
  BoxRay* boxRays;
  PrimitiveRay* primitiveRays;
  ParameterMap* maps;

  // What the walk needs.
  StreamEntry* stack;
  std::uint16_t* pool;  ///< the lists of the octants; behind them those of all entries
  std::uint8_t* masks;  ///< which boxes of a node each ray of a list meets
  OutsideRay* outside;  ///< those of all frames that have been entered, up to `outsideEnd`
  int outsideEnd;

  // What it finds.
  Candidate* candidates;
  int candidateCount;
  std::uint64_t nodesVisited, primitivesTested;

  /// Decides all candidates and empties the list; may lower tmax' of their rays.
  void (*resolve)(Stream& stream);
  /// Asks the object of the leaf at `words` for rays `rays[0 .. count)` of the stream; may lower
  /// their tmax'.
  void (*askObject)(Stream& stream, const std::uint32_t* words, const std::uint16_t* rays,
                    int count);
  void* context;  ///< for these two

  /// For the tree, which is not empty, with memory of the arena; attach is still to be called.
  /// `moves` takes the rays to where the tree stands; null where they are there. Nothing is owned.
  Stream(const WideBvh& tree, const Matrix* moves, const RayTable& table, const RowList& rows,
         Arena& arena);

  /// Sets the callbacks: Walk::resolve and Walk::askObject, which find `walk`, not owned, in
  /// context.
  template <class Walk>
  void attach(Walk& walk) {
    resolve = Walk::resolve;
    askObject = Walk::askObject;
    context = &walk;
  }

  /// Brings back the listed rays, the last that were put aside, with the bounds they now have.
  void leaveFrame(const std::uint16_t* inside, int size);

  int rowOf(int ray) const { return int(boxRays[ray].row); }
  /// Lowers the bounds of a ray to t, where they are higher.
  void lowerBound(int ray, double t);
  /// The ray is blocked, and wants nothing any more.
  void end(int ray);
  bool hasEnded(int ray) const {
    return boxRays[ray].tmaxUp == -std::numeric_limits<float>::infinity();
  }
  /// Sets blocked[row] for all that have ended.
  void markEnded(bool* blocked) const;
};

/// Which triangle or sphere of the scene stands in a leaf. Nothing is owned.
struct LeafPrimitive {
  const Object3D* object;  ///< the mesh, where it is one of its faces
  const Material* material;
  std::uint32_t order, face;  ///< number in the order of the scene; 0 but for a face of a mesh
  bool isSphere;
};

/// Triangles, or spheres, that are known to be hit, whose hits are still to be computed. The
/// kernels compute them several at a time with the very operations of Triangle and Sphere, in the
/// same order and in double, so with the same bits.
struct alignas(64) LeafHits {
  static constexpr int kMost = 64;

  int count = 0;
  std::uint16_t rows[kMost];  ///< of the rays that hit them
  double numbers[9][kMost];   ///< the corners of each; or centre and radius

  /// Repeats the last one up to a multiple of eight, so that the kernels find no garbage there.
  void fillUp();
};

/// A plane or a sphere: a unit normal and an offset, or a centre and a radius; perhaps seen through
/// a Transform. Nothing is owned.
struct ShapeNumbers {
  bool isSphere;
  double place[3], size;
  double extent;          ///< the largest number of them, as magnitudeOf wants it
  const Matrix* inverse;  ///< of the Transform; null where there is none
  const Object3D* object;
  const Object3D* whole;  ///< the Transform, or the object
  const Material* material;
  std::uint32_t order;  ///< number in the order of the scene
};

/// A box around all that can be hit of an object, in numbers for doubles.
struct BoxNumbers {
  double low[3], high[3];
  double slack;  ///< hits may seem outside by so much of the largest coordinate of a ray's origin
};

/// What is computed several rays or boxes at a time.
struct Kernels {
  /// Whether RayRange::holds for the origins of all rays: one by one, 1.02 of the instructions.
  bool (*areHeld)(const RayTable& rays);
  /// Fills in the rays of the list that meet the tree's box between tmin and tmax, and their count.
  void (*prepare)(Stream& stream);
  /// Walk the tree. Candidates may be left over: the caller resolves them. A proven hit
  void (*nearest)(Stream& stream);  ///< lowers tmax';
  void (*any)(Stream& stream);      ///< ends its ray;
  void (*all)(Stream& stream);      ///< is a candidate as any other, where triangles are crossed.
  /// Store t, point, normal and magnitude in the rows of the rays; that of spheres takes t from
  /// tmax. Up to a multiple of eight, rows and numbers behind the count are read. Where `inverse`
  /// is not null, it takes the rays to where the triangles stand, and the hits are those there.
  void (*hitsOfTriangles)(const LeafHits& hits, const RayTable& rays, const Matrix* inverse,
                          const HitTable& table);
  void (*hitsOfSpheres)(const LeafHits& hits, const RayTable& rays, const HitTable& table);
  /// Stores t and `leaving` of the crossings of rays with triangles that they surely cross.
  void (*crossTriangles)(const LeafHits& hits, const RayTable& rays, const Matrix* inverse,
                         Crossing* crossings);
  /// Object3D::intersect of `count` shapes for the listed rays: lowers tmax to the t of each new
  /// hit, and sets its row. The shapes are in the order of the scene.
  void (*nearestOfShapes)(const ShapeNumbers* shapes, int count, const RayTable& rays,
                          const RowList& list, const HitTable& hits);
  /// Sets blocked[row] for those of the listed rays that meet any between tmin and tmax.
  void (*occludedByShapes)(const ShapeNumbers* shapes, int count, const RayTable& rays,
                           const RowList& list, bool* blocked);
  /// Sets bit k of met[i] where listed ray i comes to shape k, or leaves it, between 0 and tmax, or
  /// is inside of it all that way; `count` is at most 16.
  void (*shapesMet)(const ShapeNumbers* shapes, int count, const RayTable& rays,
                    const RowList& list, std::uint16_t* met);
  /// Stores those of the listed rows whose rays may meet the box between tmin and tmax; returns
  /// their number.
  int (*rowsAtBox)(const BoxNumbers& box, const RayTable& rays, const RowList& list,
                   std::uint16_t* rows);
  /// Take the listed rays into a Transform, one row of `inside` each; and the hits of the listed
  /// rays there out of it.
  void (*moveRays)(const Matrix& inverse, const RayTable& rays, const RowList& list,
                   const RayTable& inside);
  void (*moveHits)(const Matrix& inverse, const RayTable& rays, const RowList& list,
                   const HitTable& hits);
  /// Where it is noted what all this takes; null where nobody asks. Not owned.
  TestTally* tally = nullptr;
};

/// One set of them for each SimdLevel; only for a processor that has it, see availableSimd.
namespace baseline {
Kernels kernels();
}
namespace avx2 {
Kernels kernels();
}
namespace avx512 {
Kernels kernels();
}

}  // namespace accel
