// A straight piece of a random walk: where along a line the walk scatters next.
#pragma once
#include <span>
#include <vector>

#include "reference/guide.h"
#include "reference/layers.h"
#include "reference/optics.h"
#include "reference/surface.h"

namespace airlight::reference {

/// Draws the next place along a line with a density proportional to transmittance * scattering * the guide's light,
/// mixed over the heroes, with a share that knows no guide. The density is known exactly: weights are never estimates,
/// and where neither guide nor colours differ they do not change from place to place, which long walks need.
class Flight {
 public:
  /// @param surface         in the line's way; none: the planet's sphere alone
  /// @param sun             unit, towards its centre
  /// @param scattered_only  the light looked for is that scattered before
  /// @param count_ground    the walk may go on at the ground
  void aim(const Layers& layers, const Optics& optics, const Guide& guide, const Surface* surface, const Place& from,
           const Vector& sun, double ground_radius, double distance, bool scattered_only, bool count_ground);

  /// Sees to it that neither the air nor the ground has less than this share of the chance: what sends little light and
  /// were met by one walk in thousands would be missing from a standard error. For lines that walks begin with: in long
  /// walks the weights would drift apart.
  void give_each_a_share(double least);

  const Line& line() const { return line_; }
  /// Where the line meets the surface, if its end lies on that.
  const std::optional<Surface::Hit>& solid() const { return solid_; }
  /// Distance [m] from the line's start to its end; infinite: space.
  double reach() const { return line_.meets_ground ? line_.borders.back() - line_.start : distance_; }
  /// The light to be found along the line, for each hero, as the guide thinks.
  std::span<const double> light() const { return light_; }

  /// Where the walk scatters next, and all that is known there.
  struct Event {
    bool ground;
    double t;                       ///< on the line [m]
    double density;                 ///< with which it was drawn [1/m]; ground: probability
    std::vector<double> columns;    ///< [m] from the line's start
    std::vector<double> densities;  ///< relative; in the air
  };
  /// @param weights  of the heroes
  /// @param first    in [0, 1), chooses a hero
  /// @param second   in [0, 1), places move along the line steadily with it
  /// @returns        false where nothing is to be found along the line
  bool draw(const Layers& layers, const Optics& optics, std::span<const double> weights, double first, double second,
            Event& event) const;

 private:
  void group(std::size_t together);
  void add_up();
  void find(const Layers& layers, const Optics& optics, std::size_t hero, std::size_t piece, double depth,
            Event& event) const;

  Line line_;
  std::optional<Surface::Hit> solid_;
  double distance_ = 0;            // asked for
  std::vector<std::size_t> ends_;  // of pieces, as borders of the line; the first is 0
  // A row for each hero, a place for each piece and the last for the ground.
  std::size_t stride_ = 0;      // places in a row, and one more
  std::vector<double> analog_;  // chance to scatter there, at the ground: to arrive
  std::vector<double> guide_;   // light expected there
  std::vector<double> depths_;  // optical depth of each piece
  std::vector<double> sums_;    // of analog * guide before each place
  std::vector<double> phases_;
  std::vector<double> light_;
};

}  // namespace airlight::reference
