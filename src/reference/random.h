// Random numbers: as many independent streams as there are batches of walks.
#pragma once
#include <bit>
#include <cstdint>

namespace airlight::reference {

/// Scrambles 64 bits (splitmix64: Steele, Lea & Flood 2014, OOPSLA, with Stafford's constants).
inline std::uint64_t scramble(std::uint64_t z) {
  z += 0x9e3779b97f4a7c15;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
  z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
  return z ^ (z >> 31);
}

/// xoshiro256+ (Blackman & Vigna 2021, ACM Trans. Math. Softw. 47, 36); its upper 53 bits are used.
class Random {
 public:
  Random(std::uint64_t seed, std::uint64_t stream) {
    std::uint64_t state = scramble(seed) ^ scramble(~stream);
    for (std::uint64_t& word : words_) word = state = scramble(state);
  }

  /// Uniform in [0, 1).
  double operator()() {
    const std::uint64_t result = words_[0] + words_[3], shifted = words_[1] << 17;
    words_[2] ^= words_[0];
    words_[3] ^= words_[1];
    words_[1] ^= words_[2];
    words_[0] ^= words_[3];
    words_[2] ^= shifted;
    words_[3] = std::rotl(words_[3], 45);
    return double(result >> 11) * 0x1p-53;
  }

 private:
  std::uint64_t words_[4];
};

}  // namespace airlight::reference
