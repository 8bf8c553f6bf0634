// The benchmark's mesh: a sphere of about 10 units, displaced by seeded noise.
#pragma once
#include <cstdint>
#include <string>

#include "geometry/mesh_geometry.h"

namespace bench {

/// 20 n^2 triangles, 10 n^2 + 2 vertices: an icosahedron with every edge cut into n >= 1, blown
/// up to a sphere of radius 10 around the origin, each vertex then moved along its radius by five
/// octaves of noise, by less than a third of the radius. The same on every run.
MeshGeometry displacedSphere(int n);

/// The n that gives about `triangles` triangles.
int cutsForTriangles(double triangles);

/// Writes `mesh` as an OBJ file of v and f statements. Throws std::runtime_error.
void writeObj(const MeshGeometry& mesh, const std::string& path);

}  // namespace bench
