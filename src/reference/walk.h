// Random walks against the light's direction, from an eye to the sun.
#pragma once
#include <span>
#include <vector>

#include "reference/flight.h"
#include "reference/monte_carlo.h"

namespace airlight::reference {

/// What all walks share.
struct WalkRules {
  WalkRules(const Atmosphere& atmosphere, std::span<const double> wavelengths, const MonteCarloSettings& settings);

  Layers layers, rough;  ///< rough: for guesses, on which no answer depends
  Optics optics;
  Guide guide;
  std::shared_ptr<const Surface> surface;
  std::shared_ptr<const Cloud> cloud;
  int max_order;       ///< of scattering and reflection
  int candidates;      ///< directions drawn at each place, of which one is taken
  int kept_orders;     ///< the last row of a result holds all higher ones
  bool uniform_light;  ///< radiance 1 comes from all of space, and no sun shines
};

/// One question: whose light walks look for.
struct WalkStart {
  Place place;
  Vector sun;            ///< unit, towards its centre
  double ground_radius;  ///< [m]
  double distance;       ///< [m]
  bool count_ground;     ///< the ground at the line's end belongs to the answer
  int first_order;       ///< orders before it are left out: 1 or 2
};

/// Draws walks; one object for each thread. A walk goes from the eye to a random place where light may have been
/// scattered, adds the sunlight scattered there, draws a direction from which it may have come before, and so on.
class Walker {
 public:
  explicit Walker(const WalkRules& rules);

  /// The flight from the eye, the same for all walks.
  Flight first_flight(const WalkStart& start) const;

  /// Adds one walk's estimate of radiance for a sun of irradiance 1.
  /// @param where   in [0, 1): chooses the first place along the line, from near to far
  /// @param weight  of the estimate
  /// @param light   orders by wavelengths, order slowest
  void walk(const WalkStart& start, const Flight& first, double where, double weight, Random& random,
            std::span<double> light);

  /// Adds an estimate of the first order alone, from places spread evenly over the chances of the flight.
  void glance(const WalkStart& start, const Flight& first, int places, Random& random, std::span<double> light);

 private:
  void set_out(const WalkStart& start, const Flight& first, double weight);
  void aim(Flight& flight, const Layers& layers, const WalkStart& start, const Place& from, double distance,
           bool scattered_only, bool count_ground) const;
  double light_at(const WalkStart& start, const Vector& position) const;
  double cloud_light(const WalkStart& start, const Flight& flight, const Place& from) const;
  bool draw_with_cloud(const WalkStart& start, const Place& from, const Flight& flight, double hero, double where,
                       Random& random);
  bool move(const WalkStart& start, const Place& from, const Flight& flight, double hero, double where, Random& random);
  void add_sunlight(const WalkStart& start, int order, Random& random, std::span<double> light);
  void add_light_of_space(const Place& from, const Flight& flight, int order, Random& random, std::span<double> light);
  bool turn(const WalkStart& start, int order, Random& random);
  Vector draw_direction(const WalkStart& start, const std::optional<SkyAround>& sky, Random& random);
  std::span<double> row(int order, std::span<double> light) const;

  const WalkRules& rules_;
  // The place that the walk has come to.
  Vector position_, direction_;  // direction_: in which the walk came
  Flight::Event event_;
  Vector normal_;                // of the ground, where the event lies on it
  std::vector<double> albedo_;   // of that ground
  std::vector<double> weights_;  // for each wavelength: light that reaches the eye for each unit that leaves the place

  std::vector<double> importance_;  // for each hero: 1 / light that the whole walk may find
  std::vector<double> hero_weights_, columns_, sunlight_, shares_, factor_, hero_factor_, taken_factor_;
  Flight flight_, candidate_, before_cloud_;
};

}  // namespace airlight::reference
