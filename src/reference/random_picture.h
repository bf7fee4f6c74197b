// A picture by random walks, refined pass by pass.
#pragma once
#include <array>
#include <functional>
#include <iosfwd>
#include <optional>
#include <vector>

#include "airlight/atmosphere.h"
#include "airlight/sky.h"

namespace airlight::reference {

/// What a picture looks at. Pixels are counted along rows, from the top left.
struct PictureQuestion {
  Atmosphere atmosphere;
  int width = 0, height = 0;
  std::function<std::optional<Ray>(int x, int y)> ray;  ///< through a pixel's centre; none: the pixel is black
  std::vector<double> wavelengths;                      ///< [nm]
  std::vector<std::array<double, 3>> weights;           ///< XYZ for each wavelength [cd m^-2 / (W m^-2 sr^-1 nm^-1)]
};

/// Each pass adds some walks to every pixel, with random numbers of its own: the picture after a number of passes is the
/// same however often work was interrupted, and at any number of threads. The error of a pixel is known from the
/// passes' spread.
class RandomPicture {
 public:
  static constexpr int walks_in_a_pass = 8, places_in_a_pass = 32;

  explicit RandomPicture(PictureQuestion question);

  /// @param look  called under a lock with the share of the pass that is done; what it throws undoes the pass
  void add_pass(const std::function<void(double)>& look);

  int passes() const { return passes_; }
  /// [cd m^-2]
  std::array<double, 3> xyz(int x, int y) const;
  /// Standard error of Y over Y; 0 for black.
  double error(int x, int y) const;
  /// Of the pixels that are not black; infinite before there are enough passes to tell.
  double median_error() const;

  /// Sums so far, to go on with later; the question is not among them.
  void save(std::ostream& out) const;
  /// @returns false where the stream does not hold such sums for a picture of this size
  bool load(std::istream& in);

 private:
  struct Sums {
    double x = 0, y = 0, z = 0, squared_y = 0;
  };
  PictureQuestion question_;
  int passes_ = 0;
  std::vector<Sums> sums_;
};

}  // namespace airlight::reference
