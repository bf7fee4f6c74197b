#include "model/jetlag_noise.h"

namespace airlight {
namespace {

// Constants of Numerical Recipes' quick generator, modulo 2^32; a byte is bits 18 to 25.
constexpr std::uint32_t factor = 1664525, increment = 1013904223;
std::uint8_t byte_of(std::uint32_t seed) { return static_cast<std::uint8_t>(seed >> 18); }

}  // namespace

std::uint8_t jetlag_noise_byte(std::uint32_t index) {
  // index + 1 steps at once: x -> a x + b composed with itself, bit by bit.
  std::uint32_t a = 1, b = 0, step_a = factor, step_b = increment;
  for (std::uint64_t steps = std::uint64_t(index) + 1; steps; steps >>= 1) {
    if (steps & 1) b = step_a * b + step_b, a = step_a * a;
    step_b = (step_a + 1) * step_b, step_a *= step_a;
  }
  return byte_of(b);  // the seed begins at 0
}

std::vector<double> jetlag_noise_texels() {
  std::vector<double> texels(4u * jetlag_noise_size * jetlag_noise_size);
  std::uint32_t seed = 0;
  for (double& value : texels) {
    seed = factor * seed + increment;
    value = byte_of(seed) / 255.0;
  }
  return texels;
}

}  // namespace airlight
