#include "occgrid/noise.hpp"

#include <algorithm>
#include <cmath>

#include "occgrid/portable_math.hpp"

namespace occgrid {

// [snippet: philox]
std::array<std::uint32_t, 4> philox4x32(std::array<std::uint32_t, 4> counter,
                                        std::array<std::uint32_t, 2> key) {
  auto [c0, c1, c2, c3] = counter;
  auto [k0, k1] = key;
  for (int round = 0; round < 10; ++round) {
    const std::uint64_t even = std::uint64_t{0xD2511F53} * c0;
    const std::uint64_t odd = std::uint64_t{0xCD9E8D57} * c2;
    c0 = static_cast<std::uint32_t>(odd >> 32) ^ c1 ^ k0;
    c1 = static_cast<std::uint32_t>(odd);
    c2 = static_cast<std::uint32_t>(even >> 32) ^ c3 ^ k1;
    c3 = static_cast<std::uint32_t>(even);
    k0 += 0x9E3779B9;
    k1 += 0xBB67AE85;
  }
  return {c0, c1, c2, c3};
}
// [/snippet]

// [snippet: normal-deviate]
double normal_deviate(std::uint32_t seed, std::uint32_t scan,
                      std::uint32_t beam) {
  const auto w = philox4x32({scan, beam, 0, 0}, {seed, 0});
  const double u1 = (w[0] + 0.5) / 4294967296.0;
  const double u2 = (w[1] + 0.5) / 4294967296.0;
  return std::sqrt(-2.0 * log(u1)) * cos((2.0 * pi) * u2);
}
// [/snippet]

// [snippet: range-noise]
Eigen::ArrayXd add_range_noise(const Eigen::ArrayXd& ranges, double noise_std,
                               std::uint32_t seed, std::uint32_t scan,
                               double z_max) {
  Eigen::ArrayXd noisy(ranges.size());
  for (Eigen::Index i = 0; i < ranges.size(); ++i) {
    const auto beam = static_cast<std::uint32_t>(i);
    const double deviate = normal_deviate(seed, scan, beam);
    noisy[i] = std::clamp(ranges[i] + noise_std * deviate, 0.0, z_max);
  }
  return noisy;
}
// [/snippet]

}  // namespace occgrid
