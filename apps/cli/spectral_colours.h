// Pictures that keep their wavelengths, and the three channels of an eye or a camera that are made of them.
#pragma once
#include <span>
#include <string>
#include <vector>

#include "airlight/sky.h"
#include "command_line.h"
#include "picture_outputs.h"

namespace airlight::cli {

/// "4": none, for the model's own; 8, 16, 40: centres of equal bins of 380 .. 780 nm; or first:last:step, or a list.
/// @throws InputError
std::vector<double> picture_wavelengths(const std::string& text);

/// --wavelengths, --spectral, --sensor
std::vector<Option> add_spectral_options(const Verb& verb, std::string& wavelengths, bool& spectral,
                                         std::string& sensor);

class SpectralColours {
 public:
  /// @param wavelengths  [nm]; empty: the four of real time
  /// @param sensor       file of a camera's responses; empty: the eye's, as linear sRGB [cd/m^2]
  /// @param keep         each wavelength becomes a channel of the file
  /// @throws InputError naming the file, or the model that knows no wavelengths
  SpectralColours(const Sky& sky, std::span<const double> wavelengths, const std::string& sensor, bool keep);

  const std::vector<double>& wavelengths() const { return wavelengths_; }
  /// Names after the layout of Fichet, Pacanowski & Wilkie 2021 (Journal of Computer Graphics Techniques 10(3)): "S0.445nm", with a comma
  /// for the point, which would begin a layer's name.
  std::vector<std::string> channels() const;
  /// Adds what the layout asks for, and what red, green and blue are.
  void describe(Metadata& metadata) const;
  /// @param values  rows [begin, end) as Sky::render_spectral gives them
  void write(PictureOutputs& files, int begin, int end, std::span<const float> values);

 private:
  std::vector<double> wavelengths_;
  std::vector<std::array<double, 3>> weights_;  // what a unit of each adds to red, green and blue
  std::string sensor_;
  bool keep_;
  std::vector<float> rgba_;
};

}  // namespace airlight::cli
