// Compares compiled scenes and grids with the plain objects they were made from, bit for bit.
#pragma once
#include <algorithm>
#include <cstring>
#include <memory>
#include <tuple>
#include <vector>

#include "accel/compiled_scene.h"
#include "accel/grid/grid.h"
#include "vectors.h"

namespace accel_test {

inline constexpr double kInf = std::numeric_limits<double>::infinity();

/// So little room that the cells of a grid grow.
inline constexpr double kFewEntries = 200;

/// Every instruction set that this processor has.
inline std::vector<SimdLevel> levels() {
  std::vector<SimdLevel> all;
  for (const SimdLevel level : {SimdLevel::baseline, SimdLevel::avx2, SimdLevel::avx512}) {
    if (availableSimd(level) == level) all.push_back(level);
  }
  return all;
}

inline bool sameBits(double a, double b) { return std::memcmp(&a, &b, sizeof a) == 0; }
inline bool sameBits(const Vec3d& a, const Vec3d& b) {
  return sameBits(a.x(), b.x()) && sameBits(a.y(), b.y()) && sameBits(a.z(), b.z());
}
inline bool sameBits(const Hit& a, const Hit& b) {
  return sameBits(a.getT(), b.getT()) && a.getMaterial() == b.getMaterial() &&
         a.getObject() == b.getObject() && a.getFace() == b.getFace() &&
         sameBits(a.getNormal(), b.getNormal()) &&
         sameBits(a.getIntersectionPoint(), b.getIntersectionPoint()) &&
         sameBits(a.getMagnitude(), b.getMagnitude()) &&
         sameBits(a.getTextureCoordinates().x(), b.getTextureCoordinates().x()) &&
         sameBits(a.getTextureCoordinates().y(), b.getTextureCoordinates().y());
}

inline std::string describe(const Ray& ray, double tmin, double tmax) {
  std::string text = "ray";
  for (const Vec3d& v : {ray.getOrigin(), ray.getDirection()}) {
    for (int axis = 0; axis < 3; ++axis) text += " " + check::show(v[axis]);
  }
  return text + ", tmin " + check::show(tmin) + ", tmax " + check::show(tmax) +
         (ray.getSource() ? ", leaving a surface" : "");
}
inline std::string describe(const Hit& hit) {
  return "t " + check::show(hit.getT()) + " face " + std::to_string(hit.getFace()) +
         (hit.getMaterial() ? "" : " (nothing)");
}

/// All crossings as sorted rows, so that the order of visits does not matter.
class CrossingSet : public CrossingVisitor {
 public:
  using Row = std::tuple<double, const Object3D*, const Material*, bool, bool>;
  CrossingSet(const Object3D& object, const Ray& ray) {
    object.visitCrossings(ray, *this);
    std::sort(rows_.begin(), rows_.end());
  }
  void visit(const Crossing& c) override {
    rows_.insert(rows_.end(), c.count, {c.t, c.object, c.material, c.closed, c.leaving});
  }
  bool operator==(const CrossingSet& other) const { return rows_ == other.rows_; }
  std::size_t size() const { return rows_.size(); }
  const std::vector<Row>& rows() const { return rows_; }

 private:
  std::vector<Row> rows_;
};

/// Asks objects and their compiled forms the same questions, and counts what was found.
class Comparison {
 public:
  /// `root` is not owned.
  explicit Comparison(const Object3D& root, std::string name = "") : root_(root), name_(name) {
    for (const SimdLevel level : levels()) add(std::make_unique<CompiledScene>(root, 2, level));
    for (const GridSize& size : {GridSize{1, 1, 1}, GridSize{7, 5, 6}, GridSize{40, 3, 33}}) {
      add(std::make_unique<Grid>(root, size));
    }
    add(std::make_unique<Grid>(root, GridSize{9, 9, 9}, nullptr, kFewEntries));
  }

  /// intersect, occluded and visitCrossings.
  void ask(const Ray& ray, double tmin, double tmax) {
    Hit expected(tmax);
    const bool found = root_.intersect(ray, expected, tmin);
    const bool blocked = root_.occluded(ray, tmin, tmax);
    hits_ += found;
    for (const Form& form : forms_) {
      Hit hit(tmax);
      const bool ok = form.scene->intersect(ray, hit, tmin) == found && sameBits(hit, expected);
      cases_.expect(ok, [&] {
        return where(form) + describe(ray, tmin, tmax) + ": intersect finds " + describe(hit) +
               ", expected " + describe(expected);
      });
      cases_.expect(form.scene->occluded(ray, tmin, tmax) == blocked, [&] {
        return where(form) + describe(ray, tmin, tmax) + ": occluded, expected " +
               check::show(blocked);
      });
    }
  }
  void askCrossings(const Ray& ray) {
    const CrossingSet expected(root_, ray);
    for (const Form& form : forms_) {
      const CrossingSet found(*form.scene, ray);
      cases_.expect(found == expected, [&] {
        return where(form) + describe(ray, 0, kInf) + ": " + check::show(found.size()) +
               " crossings, expected " + check::show(expected.size());
      });
    }
  }
  /// intersectAll, with hits that begin as `bounds`.
  void askBatch(const std::vector<Ray>& rays, double tmin, const std::vector<Hit>& bounds) {
    std::vector<Hit> expected = bounds;
    for (std::size_t i = 0; i < rays.size(); ++i) {
      hits_ += root_.intersect(rays[i], expected[i], tmin);
    }
    for (const Form& form : forms_) {
      const std::vector<Hit> hits = nearestHits(form, rays, tmin, bounds);
      for (std::size_t i = 0; i < rays.size(); ++i) {
        cases_.expect(sameBits(hits[i], expected[i]), [&] {
          return where(form) + describe(rays[i], tmin, bounds[i].getT()) + ", " +
                 std::to_string(i) + " of a batch of " + std::to_string(rays.size()) + ", finds " +
                 describe(hits[i]) + ", expected " + describe(expected[i]);
        });
      }
    }
  }
  void askBatch(const std::vector<Ray>& rays, double tmin, double tmax) {
    askBatch(rays, tmin, std::vector<Hit>(rays.size(), Hit(tmax)));
  }
  /// All of it: each question alone, every fourth one's crossings, and all rays as batches; with
  /// infinite bounds, and with the questions' own as shadows.
  void askAll(const std::vector<ShadowQuery>& queries) {
    std::vector<Ray> rays;
    for (std::size_t i = 0; i < queries.size(); ++i) {
      ask(queries[i].ray, queries[i].tmin, queries[i].tmax);
      if (i % 4 == 0) askCrossings(queries[i].ray);
      rays.push_back(queries[i].ray);
    }
    askBatch(rays, 0, kInf);
    askShadows(queries);
    CHECK_EQUAL(firstFailure(), "");
  }
  void askShadows(const std::vector<ShadowQuery>& queries) {
    std::vector<char> expected;
    for (const ShadowQuery& q : queries) {
      expected.push_back(root_.occluded(q.ray, q.tmin, q.tmax));
      hits_ += expected.back();
    }
    for (const Form& form : forms_) {
      const std::vector<char> blocked = blockedRays(form, queries);
      for (std::size_t i = 0; i < queries.size(); ++i) {
        cases_.expect(blocked[i] == expected[i], [&] {
          return where(form) + describe(queries[i].ray, queries[i].tmin, queries[i].tmax) + ", " +
                 std::to_string(i) + " of " + std::to_string(queries.size()) +
                 " shadow rays: blocked is expected to be " + check::show(bool(expected[i]));
        });
      }
    }
  }

  /// How many rays have met something.
  int hits() const { return hits_; }
  int tried() const { return cases_.tried(); }
  const std::string& firstFailure() const { return cases_.firstFailure(); }

 private:
  /// One way to find hits, and what to call it.
  struct Form {
    std::unique_ptr<Object3D> scene;
    const BatchGeometry* batches;  // the same object; null where it is asked ray by ray
    std::string description;
  };
  template <class Scene>
  void add(std::unique_ptr<Scene> scene) {
    const std::string description = scene->describe();
    const auto* batches = dynamic_cast<const BatchGeometry*>(scene.get());
    forms_.push_back({std::move(scene), batches, description});
  }

  /// The hits of all rays, asked together where the form can; those that find nothing as in
  /// `bounds`.
  std::vector<Hit> nearestHits(const Form& form, const std::vector<Ray>& rays, double tmin,
                               const std::vector<Hit>& bounds) {
    std::vector<Hit> hits = bounds;
    if (!form.batches) {
      for (std::size_t i = 0; i < rays.size(); ++i) form.scene->intersect(rays[i], hits[i], tmin);
      return hits;
    }
    const Arena::Frame frame(arena_);
    RayTable table(arena_, int(rays.size()), anyLeaves(rays));
    for (int i = 0; i < table.count; ++i) {
      table.setRow(i, rays[std::size_t(i)], tmin, bounds[std::size_t(i)].getT());
    }
    HitTable found(arena_, table.count);
    form.batches->intersectAll(table, found, arena_);
    for (int i = 0; i < table.count; ++i) {
      Hit& hit = hits[std::size_t(i)];
      if (found.isFound(i)) {
        hit = found.hitOf(i, table.tmax[i]);
      } else if (!sameBits(table.tmax[i], hit.getT())) {
        hit = Hit(table.tmax[i]);  // a bound that was lowered for nothing
      }
    }
    return hits;
  }
  std::vector<char> blockedRays(const Form& form, const std::vector<ShadowQuery>& queries) {
    std::vector<char> answers;
    if (!form.batches) {
      for (const ShadowQuery& q : queries) {
        answers.push_back(form.scene->occluded(q.ray, q.tmin, q.tmax));
      }
      return answers;
    }
    const Arena::Frame frame(arena_);
    RayTable table(arena_, int(queries.size()), true);
    for (int i = 0; i < table.count; ++i) {
      const ShadowQuery& q = queries[std::size_t(i)];
      table.setRow(i, q.ray, q.tmin, q.tmax);
    }
    bool* const blocked = arena_.take<bool>(queries.size());
    form.batches->occludedAll(table, blocked, arena_);
    answers.assign(blocked, blocked + queries.size());
    return answers;
  }
  static bool anyLeaves(const std::vector<Ray>& rays) {
    return std::any_of(rays.begin(), rays.end(), [](const Ray& r) { return r.getSource(); });
  }
  std::string where(const Form& form) const { return name_ + " (" + form.description + "): "; }

  const Object3D& root_;
  std::string name_;
  std::vector<Form> forms_;
  check::Cases cases_;
  Arena arena_;
  int hits_ = 0;
};

}  // namespace accel_test
