// The land as triangles for one eye, and rays against them.
#pragma once
#include <array>
#include <cstdint>
#include <limits>
#include <memory>
#include <numbers>
#include <span>

#include "scene/land.h"

namespace airlight {

/// Which triangles are wanted: those of about a pixel in what the eye sees, coarser ones elsewhere.
struct LevelOfDetail {
  Position eye{0, 0, 2};
  double pixel_angle = 0.001;            ///< [rad]
  double pixels = 1.5;                   ///< wanted length of a triangle's side in pixels
  Direction axis{0, 1, 0};               ///< middle of what the eye sees
  double half_angle = std::numbers::pi;  ///< cone around the axis that holds all that it sees [rad]; pi: all round
  double unseen_pixels = 48;             ///< length of a side outside the cone, where only shadows fall from [pixels]
  std::size_t most_cells = 12'000'000;   ///< two triangles each; where they do not suffice, `pixels` grows
};

struct SceneRay {
  Position origin;
  Direction direction;  ///< unit
};

struct TerrainHit {
  double distance = std::numeric_limits<double>::infinity();  ///< [m]; infinite: the sky, and nothing else is set
  Position position{};
  GroundPoint ground;                     ///< the same place along the sphere, with its altitude
  std::array<float, 3> normal{};          ///< of the triangle; unit, outward
  std::array<float, 3> shading_normal{};  ///< smooth over triangles; unit
  float level = 1;                        ///< cosine of the angle between shading normal and local vertical
  bool mesh = false;                      ///< false: the plain beyond all triangles
  std::uint32_t tile = 0;                 ///< where the mesh is met: its tile, and coordinates 0 .. 1 in that
  float u = 0, v = 0;
  bool hit() const { return distance < std::numeric_limits<double>::infinity(); }
};

/// The triangle of the mesh that a hit lies on.
struct TerrainTriangle {
  std::array<std::size_t, 3> numbers;  ///< of its corners; triangles of a tile that share a corner share its number
  std::array<Position, 3> corners;
  std::array<double, 3> weights;  ///< barycentric coordinates of the hit: they add up to 1
};

/// A point of the ground that asks how much of the sun it sees.
struct SunQuestion {
  Position position;
  std::array<float, 3> normal;  ///< of the surface; what it faces away from it does not see
};

class Terrain {
 public:
  Terrain(std::shared_ptr<const Land> land, const LevelOfDetail& detail);
  ~Terrain();
  Terrain(Terrain&&) noexcept;
  Terrain& operator=(Terrain&&) noexcept;

  const Land& land() const;
  /// Cells of the mesh (two triangles each), its bytes with Embree's tree, and the side of a seen triangle [pixels].
  struct Statistics {
    std::size_t cells = 0, bytes = 0;
    double pixels = 0;
  };
  Statistics statistics() const;

  /// Nearest ground along each ray, on all cores. A ray that meets the planet always hits.
  void hits(std::span<const SceneRay> rays, std::span<TerrainHit> hits) const;

  /// @param hit  of this terrain's mesh
  TerrainTriangle triangle(const TerrainHit& hit) const;

  /// A hit as it asks for the sun: from the smooth surface that the triangles stand for, which their shading has. Asked from the triangles
  /// themselves, those beyond the edge of day on a round slope are dark and their neighbours are not: the edge is a saw.
  /// @param hit  of this terrain
  SunQuestion sun_question(const TerrainHit& hit) const;

  /// Fraction of the sun's disc in [0, 1] that terrain leaves free, on all cores: two rays tell whole sun or none;
  /// where limbs differ, the height of the horizon across the disc is found by bisection and taken as level.
  /// @param sun            unit, towards the sun's centre, in the scene's frame
  /// @param angular_radius [rad]; 0: one ray to the centre
  void sun_visibility(std::span<const SunQuestion> points, Direction sun, double angular_radius,
                      std::span<float> fraction) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace airlight
