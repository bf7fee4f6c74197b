#include "scene/terrain.h"

#include <embree3/rtcore.h>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <string>

#include "airlight/error.h"
#include "scene/shadow_map.h"
#include "scene/tile_mesh.h"

namespace airlight {
namespace {

constexpr int packet = 16;

double dot(const Position& a, const Direction& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Position along(const Position& p, const Direction& d, double t) {
  return {p[0] + t * d[0], p[1] + t * d[1], p[2] + t * d[2]};
}

/// Embree's objects, and the bytes that they take.
class RayTree {
 public:
  RayTree(const TileMesh& mesh, std::size_t tiles, bool draft) {
    device_ = rtcNewDevice(nullptr);
    if (!device_) throw WorkError("Embree does not start: error " + std::to_string(int(rtcGetDeviceError(nullptr))));
    rtcSetDeviceMemoryMonitorFunction(
        device_,
        [](void* self, ssize_t bytes, bool) {
          static_cast<RayTree*>(self)->bytes_ += bytes;
          return true;
        },
        this);
    scene_ = rtcNewScene(device_);
    // Robust: rays through an edge of two triangles hit one of them. Compact: half the memory at a tenth of the time.
    rtcSetSceneFlags(scene_, RTCSceneFlags(RTC_SCENE_FLAG_ROBUST | RTC_SCENE_FLAG_COMPACT));
    rtcSetSceneBuildQuality(scene_, draft ? RTC_BUILD_QUALITY_LOW : RTC_BUILD_QUALITY_MEDIUM);
    const RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_GRID);
    rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, mesh.vertices().data(), 0,
                               sizeof mesh.vertices()[0], mesh.vertices().size() - 1);
    auto* grids = static_cast<RTCGrid*>(
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_GRID, 0, RTC_FORMAT_GRID, sizeof(RTCGrid), tiles));
    constexpr unsigned side = TileMesh::grid_side;
    for (std::size_t i = 0; i < tiles; ++i) grids[i] = {unsigned(i) * side * side, side, side, side};
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene_, geometry);
    rtcReleaseGeometry(geometry);
    rtcCommitScene(scene_);
    const RTCError error = rtcGetDeviceError(device_);
    if (error != RTC_ERROR_NONE)
      throw WorkError("Embree cannot build the terrain: error " + std::to_string(int(error)));
  }
  ~RayTree() {
    rtcReleaseScene(scene_);
    rtcReleaseDevice(device_);
  }
  RayTree(const RayTree&) = delete;
  RayTree& operator=(const RayTree&) = delete;

  RTCScene scene() const { return scene_; }
  std::size_t bytes() const { return std::size_t(bytes_.load()); }

 private:
  RTCDevice device_;
  RTCScene scene_ = nullptr;
  std::atomic<ssize_t> bytes_ = 0;
};

}  // namespace

struct Terrain::Impl {
  std::shared_ptr<const Land> land;
  TileTree tree;
  Position centre;
  TileMesh mesh;
  RayTree rays;
  double plain, highest;

  Impl(std::shared_ptr<const Land> l, const LevelOfDetail& detail, const TileTree::Draft* draft)
      : land(std::move(l)),
        tree(*land, detail, draft),
        centre(below(detail.eye)),
        mesh(*land, tree, centre),
        rays(mesh, tree.leaves().size(), !draft),
        plain(land->plain_altitude()),
        highest(land->highest()) {}

  /// The ground under the eye, or the nearest that has triangles.
  Position below(const Position& eye) const {
    const GroundPoint g = land->frame().ground(eye);
    const double half = tree.half_side();
    return land->frame().position({std::clamp(g.east, -half, half), std::clamp(g.north, -half, half), 0});
  }

  bool has_triangles(const GroundPoint& g) const {
    return std::max(std::abs(g.east), std::abs(g.north)) < tree.half_side();
  }

  /// Distance [m] at which a ray first comes down through the sphere of an altitude; negative: it is below at its origin or
  /// never meets it.
  double enters(const SceneRay& ray, double sphere) const {
    const LocalFrame& frame = land->frame();
    const Position from_centre{ray.origin[0], ray.origin[1], ray.origin[2] + frame.radius()};
    const double b = dot(from_centre, ray.direction);
    if (b >= 0) return -1;
    const double radius = frame.radius() + sphere, above = frame.altitude(ray.origin) - sphere;
    const double c = above * (above + 2 * radius);  // |from_centre|^2 - radius^2 without its cancellation
    const double discriminant = b * b - c;
    if (c <= 0 || discriminant < 0) return -1;
    return c / (-b + std::sqrt(discriminant));
  }

  /// Where rays start in Embree's floats: those from space begin where they come down to the highest summit.
  double start(const SceneRay& ray) const { return std::max(0.0, enters(ray, highest + 1)); }

  /// Whether nothing but triangles lies around a point: half the square's side may be a third of it more along the sphere.
  bool amid_triangles(const Position& p) const {
    return std::max(std::abs(p[0]), std::abs(p[1])) < 0.5 * tree.half_side();
  }

  void finish(const SceneRay& ray, double distance, const float* normal, unsigned grid, TerrainHit& hit) const {
    const LocalFrame& frame = land->frame();
    hit = {};
    hit.position = along(ray.origin, ray.direction, std::isinf(distance) ? 0 : distance);
    const bool amid = !std::isinf(distance) && amid_triangles(ray.origin) && amid_triangles(hit.position);
    const double sphere = amid ? -1 : enters(ray, plain);
    if (sphere >= 0 && sphere < distance) {
      // The plain is there only where triangles are not.
      const GroundPoint g = frame.ground(along(ray.origin, ray.direction, sphere));
      if (std::isinf(distance) || !has_triangles(g)) {
        hit.distance = sphere;
        hit.position = along(ray.origin, ray.direction, sphere);
        hit.ground = {g.east, g.north, plain};
        const Direction up = frame.up(hit.position);
        for (std::size_t k = 0; k < 3; ++k) hit.normal[k] = hit.shading_normal[k] = float(up[k]);
        return;
      }
    }
    if (std::isinf(distance)) return;
    hit.mesh = true;
    hit.distance = distance;
    hit.ground = frame.ground(hit.position);
    const Direction up = frame.up(hit.position);
    const double length = std::sqrt(normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2]);
    const double outward = (normal[0] * up[0] + normal[1] * up[1] + normal[2] * up[2] < 0 ? -1 : 1) / length;
    for (std::size_t k = 0; k < 3; ++k) hit.normal[k] = float(normal[k] * outward);
    const Tile& tile = tree.leaves()[grid];
    const double cell = tree.cell(tile.level);
    hit.shading_normal = mesh.normal(grid, (hit.ground.east - tree.metres(tile.x)) / cell,
                                     (hit.ground.north - tree.metres(tile.y)) / cell);
    hit.level = float(hit.shading_normal[0] * up[0] + hit.shading_normal[1] * up[1] + hit.shading_normal[2] * up[2]);
  }

  void hits(std::span<const SceneRay> asked, std::span<TerrainHit> answers) const {
    alignas(64) RTCRayHit16 p;
    alignas(64) int valid[packet];
    double begin[packet];
    const int count = int(asked.size());
    for (int i = 0; i < packet; ++i) {
      const auto k = std::size_t(std::min(i, count - 1));
      valid[i] = i < count ? -1 : 0;
      begin[i] = start(asked[k]);
      const Position o = along(asked[k].origin, asked[k].direction, begin[i]);
      p.ray.org_x[i] = float(o[0] - centre[0]), p.ray.org_y[i] = float(o[1] - centre[1]),
      p.ray.org_z[i] = float(o[2] - centre[2]);
      p.ray.dir_x[i] = float(asked[k].direction[0]);
      p.ray.dir_y[i] = float(asked[k].direction[1]);
      p.ray.dir_z[i] = float(asked[k].direction[2]);
      p.ray.tnear[i] = 0, p.ray.tfar[i] = std::numeric_limits<float>::infinity();
      p.ray.time[i] = 0, p.ray.mask[i] = ~0u, p.ray.flags[i] = 0, p.ray.id[i] = unsigned(i);
      p.hit.geomID[i] = RTC_INVALID_GEOMETRY_ID;
    }
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
    rtcIntersect16(valid, rays.scene(), &context, &p);
    for (int i = 0; i < count; ++i) {
      const bool met = p.hit.geomID[i] != RTC_INVALID_GEOMETRY_ID;
      const float normal[3] = {p.hit.Ng_x[i], p.hit.Ng_y[i], p.hit.Ng_z[i]};
      const double distance = met ? begin[i] + double(p.ray.tfar[i]) : std::numeric_limits<double>::infinity();
      TerrainHit& hit = answers[std::size_t(i)];
      finish(asked[std::size_t(i)], distance, normal, p.hit.primID[i], hit);
      if (hit.mesh) hit.tile = p.hit.primID[i], hit.u = p.hit.u[i], hit.v = p.hit.v[i];
    }
  }

  TerrainTriangle triangle(const TerrainHit& hit) const {
    // Embree runs u and v over all cells of a grid, and cuts each from its lower right corner to its upper left.
    constexpr int last = TileMesh::grid_side - 2;
    const double x = double(hit.u) * (last + 1), y = double(hit.v) * (last + 1);
    const int i = std::clamp(int(x), 0, last), j = std::clamp(int(y), 0, last);
    const double fx = std::clamp(x - i, 0.0, 1.0), fy = std::clamp(y - j, 0.0, 1.0);
    const bool upper = fx + fy > 1;
    const auto number = [&](int di, int dj) {
      return (std::size_t(hit.tile) * TileMesh::grid_side + std::size_t(j + dj)) * TileMesh::grid_side +
             std::size_t(i + di);
    };
    TerrainTriangle triangle{{number(upper, upper), number(!upper, upper), number(upper, !upper)}, {}, {}};
    triangle.weights = upper ? std::array{fx + fy - 1, 1 - fx, 1 - fy} : std::array{1 - fx - fy, fx, fy};
    for (std::size_t c = 0; c < 3; ++c) {
      const std::array<float, 3>& vertex = mesh.vertices()[triangle.numbers[c]];
      for (std::size_t k = 0; k < 3; ++k) triangle.corners[c][k] = centre[k] + double(vertex[k]);
    }
    return triangle;
  }

  // Above a triangle as far as the planes through its corners, normal to their normals, are: on round slopes outside of it, in hollows
  // on it (Hanika 2021, Hacking the Shadow Terminator, Ray Tracing Gems II, chapter 4).
  SunQuestion sun_question(const TerrainHit& hit) const {
    SunQuestion question{hit.position, hit.shading_normal};
    if (!hit.mesh) return question;
    const TerrainTriangle t = triangle(hit);
    constexpr std::size_t side = TileMesh::grid_side;
    for (std::size_t c = 0; c < 3; ++c) {
      const std::size_t place = t.numbers[c] % (side * side);
      const std::array<float, 3> n = mesh.normal(hit.tile, double(place % side) - 1, double(place / side) - 1);
      double below = 0;
      for (std::size_t k = 0; k < 3; ++k) below += (t.corners[c][k] - hit.position[k]) * double(n[k]);
      for (std::size_t k = 0; k < 3; ++k) question.position[k] += t.weights[c] * std::max(below, 0.0) * double(n[k]);
    }
    return question;
  }

  /// Clears `valid` of those points whose ray towards a direction is blocked.
  void shadow(std::span<const SunQuestion> points, const Direction (&towards)[packet], int (&valid)[packet]) const {
    alignas(64) RTCRay16 p;
    alignas(64) int active[packet];
    for (int i = 0; i < packet; ++i) {
      active[i] = valid[i];
      const SunQuestion& point = points[std::size_t(std::min(i, int(points.size()) - 1))];
      const double o[3] = {point.position[0] - centre[0], point.position[1] - centre[1], point.position[2] - centre[2]};
      // Off the surface by what floats do not tell apart there.
      const double lift = 1e-3 + 1e-6 * std::sqrt(o[0] * o[0] + o[1] * o[1] + o[2] * o[2]);
      p.org_x[i] = float(o[0] + lift * point.normal[0]);
      p.org_y[i] = float(o[1] + lift * point.normal[1]);
      p.org_z[i] = float(o[2] + lift * point.normal[2]);
      p.dir_x[i] = float(towards[i][0]), p.dir_y[i] = float(towards[i][1]), p.dir_z[i] = float(towards[i][2]);
      p.tnear[i] = float(lift), p.tfar[i] = std::numeric_limits<float>::infinity();
      p.time[i] = 0, p.mask[i] = ~0u, p.flags[i] = 0, p.id[i] = unsigned(i);
      // A face turned away needs no ray.
      const double facing =
          point.normal[0] * towards[i][0] + point.normal[1] * towards[i][1] + point.normal[2] * towards[i][2];
      if (facing <= 0) valid[i] = active[i] = 0;
      // The plain blocks what goes below its horizon.
      if (active[i] && enters({point.position, towards[i]}, plain) > 0) {
        const double t = enters({point.position, towards[i]}, plain);
        if (!has_triangles(land->frame().ground(along(point.position, towards[i], t)))) valid[i] = active[i] = 0;
      }
    }
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
    rtcOccluded16(active, rays.scene(), &context, &p);
    for (int i = 0; i < packet; ++i) {
      if (p.tfar[i] < 0) valid[i] = 0;
    }
  }

  void sun_visibility(std::span<const SunQuestion> points, const Direction& sun, double radius,
                      std::span<float> fraction) const {
    const int count = int(points.size());
    Direction up[packet];
    for (int i = 0; i < packet; ++i) {
      const SunQuestion& point = points[std::size_t(std::min(i, count - 1))];
      // Across the disc from bottom to top: the local vertical without its part along the sun.
      const Direction vertical = land->frame().up(point.position);
      const double part = dot(vertical, sun);
      up[i] = along(vertical, sun, -part);
      const double length = std::sqrt(dot(up[i], up[i]));
      if (length < 1e-6)
        up[i] = {0, 0, 0};
      else
        for (double& x : up[i]) x /= length;
    }
    const double half_disc = std::tan(radius);
    const auto sees = [&](const double(&height)[packet], const int(&asked)[packet], int(&free)[packet]) {
      Direction towards[packet];
      for (int i = 0; i < packet; ++i) {
        towards[i] = along(sun, up[i], height[i] * half_disc);
        const double length = std::sqrt(dot(towards[i], towards[i]));
        for (double& x : towards[i]) x /= length;
        free[i] = asked[i];
      }
      shadow(points, towards, free);
    };
    double low[packet], high[packet], middle[packet];
    int all[packet], bottom[packet], top[packet];
    for (int i = 0; i < packet; ++i) all[i] = i < count ? -1 : 0, low[i] = -1, high[i] = 1, middle[i] = 0;
    if (radius == 0) {
      sees(middle, all, top);
      for (int i = 0; i < count; ++i) fraction[std::size_t(i)] = top[i] ? 1.0f : 0.0f;
      return;
    }
    sees(low, all, bottom);
    for (int i = 0; i < packet; ++i)
      all[i] = all[i] && !bottom[i] ? -1 : 0;  // whose lower limb is free sees all of the sun
    sees(high, all, top);
    bool partial = false;
    for (int i = 0; i < packet; ++i) {
      all[i] = all[i] && top[i] ? -1 : 0;
      partial = partial || all[i];
    }
    // Six halvings: the horizon's height to 1/64 of the disc.
    for (int step = 0; step < 6 && partial; ++step) {
      int free[packet];
      for (int i = 0; i < packet; ++i) middle[i] = 0.5 * (low[i] + high[i]);
      sees(middle, all, free);
      for (int i = 0; i < packet; ++i) (free[i] ? high[i] : low[i]) = middle[i];
    }
    for (int i = 0; i < count; ++i) {
      const double height = all[i] ? 0.5 * (low[i] + high[i]) : bottom[i] ? -1 : 1;
      fraction[std::size_t(i)] = float(disc_fraction(height));
    }
  }
};

namespace {

/// Calls work(begin, count) for packets of neighbours, on all cores.
template <typename Work>
void in_packets(std::size_t count, const Work& work) {
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, (count + packet - 1) / packet, 32), [&](const auto& range) {
    for (std::size_t k = range.begin(); k != range.end(); ++k) {
      const std::size_t begin = k * packet;
      work(begin, std::min<std::size_t>(packet, count - begin));
    }
  });
}

constexpr double draft_pixels = 16;  // side of a draft's triangles, in those of the final ones
constexpr double look_pixels = 8;    // between the draft's rays

/// Foreshortening of parts of a tree's leaves, from the number of rays that meet them; those beside one that is met count as hardly
/// seen, since the draft's ridges are not quite the final ones.
std::vector<float> stretches(const Terrain& terrain, const TileTree& tree, const LevelOfDetail& detail) {
  // Directions spread evenly over the cone, ring by ring so that packets of them are narrow; dense enough for a far range that shows as a
  // strip above a near one.
  constexpr double most_rays = 1e6;
  const double half_angle = std::min(detail.half_angle, std::numbers::pi), cap = 1 - std::cos(half_angle);
  const double apart = std::max(look_pixels * detail.pixel_angle, std::sqrt(2 * std::numbers::pi * cap / most_rays));
  const Direction& axis = detail.axis;
  const Direction side = std::abs(axis[2]) < 0.9 ? Direction{axis[1], -axis[0], 0} : Direction{0, axis[2], -axis[1]};
  const double length = std::sqrt(dot(side, side));
  const Direction right{side[0] / length, side[1] / length, side[2] / length};
  const Direction up{right[1] * axis[2] - right[2] * axis[1], right[2] * axis[0] - right[0] * axis[2],
                     right[0] * axis[1] - right[1] * axis[0]};
  std::vector<SceneRay> rays;
  const int rings = std::max(1, int(std::ceil(half_angle / apart)));
  for (int ring = 0; ring < rings; ++ring) {
    const double angle = (ring + 0.5) * half_angle / rings, sine = std::sin(angle), cosine = std::cos(angle);
    const int around = std::max(1, int(std::ceil(2 * std::numbers::pi * sine / apart)));
    for (int i = 0; i < around; ++i) {
      const double turn = 2 * std::numbers::pi * i / around;
      rays.push_back({detail.eye, along(along(along({0, 0, 0}, axis, cosine), right, sine * std::cos(turn)), up,
                                        sine * std::sin(turn))});
    }
  }
  const std::size_t count = rays.size();
  std::vector<TerrainHit> hits(count);
  terrain.hits(rays, hits);
  constexpr float most = 2;  // even edge-on, a ridge's outline is wanted
  const double solid_angle = 2 * std::numbers::pi * cap / double(count);
  constexpr std::int32_t parts = TileTree::Draft::parts;
  TileTree::Draft draft{&tree, std::vector<float>(tree.leaves().size() * parts * parts, 0)};
  std::vector<float> facing(draft.stretch.size(), 0);
  for (const TerrainHit& hit : hits) {
    const int part = hit.mesh ? draft.part_at(tree.lattice(hit.ground.east), tree.lattice(hit.ground.north)) : -1;
    // Area of ground turned to the eye.
    if (part >= 0) facing[std::size_t(part)] += float(solid_angle * hit.distance * hit.distance);
  }
  for (std::size_t part = 0; part < facing.size(); ++part) {
    if (facing[part] == 0) continue;
    const Tile& tile = tree.leaves()[part / (parts * parts)];
    const std::int32_t width = TileTree::tile_cells * TileTree::span(tile.level) / parts;
    const double metres = TileTree::tile_cells * tree.cell(tile.level) / parts;
    draft.stretch[part] = std::clamp(float(metres / std::sqrt(facing[part])), 1.0f, most);
    const std::int32_t x = tile.x + std::int32_t(part % parts) * width + width / 2,
                       y = tile.y + std::int32_t(part / parts % parts) * width + width / 2;
    constexpr std::int32_t reach = 2;
    for (std::int32_t j = -reach; j <= reach; ++j) {
      for (std::int32_t i = -reach; i <= reach; ++i) {
        const int beside = draft.part_at(x + i * width, y + j * width);
        if (beside < 0) continue;
        float& stretch = draft.stretch[std::size_t(beside)];
        if (stretch == 0) stretch = most;
      }
    }
  }
  return draft.stretch;
}

}  // namespace

Terrain::Terrain(std::shared_ptr<const Land> land, const LevelOfDetail& detail) {
  // Most of a mountainous country hides behind its nearest ridges. A draft with a fraction of the cells tells which
  // squares the eye sees.
  LevelOfDetail coarse = detail;
  coarse.pixels = draft_pixels * detail.pixels;
  impl_ = std::make_unique<Impl>(land, coarse, nullptr);
  const TileTree::Draft draft{&impl_->tree, stretches(*this, impl_->tree, detail)};
  impl_ = std::make_unique<Impl>(std::move(land), detail, &draft);
}
Terrain::~Terrain() = default;
Terrain::Terrain(Terrain&&) noexcept = default;
Terrain& Terrain::operator=(Terrain&&) noexcept = default;

const Land& Terrain::land() const { return *impl_->land; }

Terrain::Statistics Terrain::statistics() const {
  constexpr std::size_t per_tile = TileTree::tile_cells * TileTree::tile_cells;
  return {impl_->tree.leaves().size() * per_tile, impl_->mesh.bytes() + impl_->rays.bytes(), impl_->tree.pixels()};
}

void Terrain::hits(std::span<const SceneRay> rays, std::span<TerrainHit> hits) const {
  in_packets(rays.size(), [&](std::size_t begin, std::size_t count) {
    impl_->hits(rays.subspan(begin, count), hits.subspan(begin, count));
  });
}

TerrainTriangle Terrain::triangle(const TerrainHit& hit) const { return impl_->triangle(hit); }

SunQuestion Terrain::sun_question(const TerrainHit& hit) const { return impl_->sun_question(hit); }

void Terrain::sun_visibility(std::span<const SunQuestion> points, Direction sun, double angular_radius,
                             std::span<float> fraction) const {
  in_packets(points.size(), [&](std::size_t begin, std::size_t count) {
    impl_->sun_visibility(points.subspan(begin, count), sun, angular_radius, fraction.subspan(begin, count));
  });
}

}  // namespace airlight
