// Range noise that depends on nothing but the seed, the scan and the beam
// (SPEC.md section 3.3).
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>

namespace occgrid {

/// Philox4x32-10 (Salmon et al. 2011): four random words for a counter and a
/// key.
std::array<std::uint32_t, 4> philox4x32(std::array<std::uint32_t, 4> counter,
                                        std::array<std::uint32_t, 2> key);

/// The standard normal deviate (Box and Muller 1958) of one beam; scan and
/// beam count from 0.
double normal_deviate(std::uint32_t seed, std::uint32_t scan,
                      std::uint32_t beam);

/// Simulated ranges (n, metres) with noise of standard deviation noise_std
/// (metres), kept within [0, z_max]: (n). scan is the scan's number in its
/// scenario. A beam that met no wall gets noise too, as in the lesson.
Eigen::ArrayXd add_range_noise(const Eigen::ArrayXd& ranges, double noise_std,
                               std::uint32_t seed, std::uint32_t scan,
                               double z_max);

}  // namespace occgrid
