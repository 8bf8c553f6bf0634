// WideBvh: a tree whose inner nodes have up to eight boxes, which one instruction tests at once.
//
// All its numbers are floats in a normalised space: x' = (x - anchor) * scale, scale a power of
// two, chosen so that the tree's own box has a longest side of 1 to 2. So no scene is too small or
// too large for float, and error bounds can be stated once.
#pragma once
#include <cstdint>

#include "system/memory.h"

namespace accel {

constexpr int kWidth = 8;

/// Eight boxes and what is in them. An empty slot has an inverted box, which no ray meets.
struct alignas(64) WideNode {
  float planes[6][kWidth];  ///< low x, high x, low y, high y, low z, high z
  /// A node's number, perhaps with kFrameBit; or kLeafBit and the offset of a leaf's words.
  std::uint32_t child[kWidth];
};
static_assert(sizeof(WideNode) == 256, "four cache lines");

constexpr std::uint32_t kLeafBit = 0x80000000u;
/// Set besides a node's number: it is so small that rays are prepared again for it; see stream.h.
constexpr std::uint32_t kFrameBit = 0x40000000u;

/// What a leaf holds. A leaf is a run of 32-bit words:
///   head, then rows of n numbers each, then a row of n primitive numbers.
/// The head is a float, an upper bound of the edges' components of triangles, at least 2^-40, whose
/// low half is count, kind and number of vertices. Rows are not padded: a load of eight runs over
/// into what follows, and the lanes above n are masked out. Primitive numbers have kIdBit set, so
/// that read as a float they are no denormals, which processors handle slowly.
///
/// Triangles of a mesh share vertices (a triangle of an ordinary mesh takes 22 bytes in place of
/// 40): head; for each of eight lanes a half word, in which five bits each say where its corners
/// v0, v1 and v2 are in the rows, lanes above n as the last; rows x, y, z of the vertices, exact;
/// face numbers.
enum class LeafKind : std::uint16_t {
  meshTriangles = 0,
  looseTriangles = 1,  ///< nine rows: v0 rounded, v1 - v0 and v2 - v0 rounded
  spheres = 2,         ///< four rows: centre and radius, rounded
  objects = 3          ///< anything else, one in a leaf: head, TreeMember, perhaps a Matrix
};
constexpr std::uint32_t kIdBit = 0x40000000u;

/// Of loose triangles and spheres.
constexpr int rowsOf(LeafKind kind) { return kind == LeafKind::spheres ? 4 : 9; }
constexpr LeafKind kindOf(std::uint32_t head) { return LeafKind(head >> 4 & 3); }
constexpr int countOf(std::uint32_t head) { return int(head & 15); }
/// In a leaf of a mesh, 3 to 24; the rows begin behind head and places.
constexpr int verticesOf(std::uint32_t head) { return int(head >> 8 & 31); }
constexpr int kPlaceBits = 5, kFirstRow = 5;

/// What rays are prepared for: all of a tree, or a node with kFrameBit and what is below it.
struct TreeFrame {
  /// Edges of faces in smaller ones would be below what floats can multiply: see leafHead.
  static constexpr float kLeast = 0x1p-40f;

  double low[3], high[3];  ///< the box, normalised
  double size;             ///< a power of two, kLeast to 1: the unit of what is small or far

  /// The frame that a node begins.
  static TreeFrame of(const WideNode& node);
};

struct WideBvh {
  /// WideNodes, of which the first is the root, then the words of leaves, with room behind them for
  /// a load of eight to run over. Empty where there is nothing to hit.
  PageBuffer memory;
  std::size_t nodeCount = 0, leafWords = 0;
  int levels = 0;          ///< of nodes and frames
  int frameLevels = 0;     ///< of frames that are in one another
  bool isInParts = false;  ///< a primitive may be in several leaves
  double anchor[3] = {0, 0, 0};
  double scale = 1;
  TreeFrame whole = {};  ///< around everything
  /// Hits are off as those of objects under no Transform would be that were seen from
  /// far * errorFactor + fixedError away, far being how far off the ray's origin is; see
  /// TransformError.
  double errorFactor = 1, fixedError = 0;

  bool isEmpty() const { return nodeCount == 0; }
  const WideNode* root() const { return static_cast<const WideNode*>(memory.data()); }
  const std::uint32_t* words() const {
    return reinterpret_cast<const std::uint32_t*>(root() + nodeCount);
  }
  /// Bytes that the tree occupies.
  std::size_t bytes() const { return memory.size(); }
};

}  // namespace accel
