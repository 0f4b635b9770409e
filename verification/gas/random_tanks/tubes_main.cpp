// SPDX-License-Identifier: Apache-2.0
// Prints the bounds that ship of the random tanks of seeds FIRST to LAST, each computed in SECONDS at most.
// usage: gas_random_tubes FIRST LAST SECONDS
#include <cstdlib>
#include <iostream>

#include "tube.hpp"

int main(int count, char** words) {
  using namespace random_tanks;
  if (count != 4) return 2;
  std::cout.precision(17);
  std::cout << "# Proved bounds of the random tanks of verification/gas/random_tanks, by gas_random_tubes "
            << words[1] << ' ' << words[2] << ' ' << words[3]
            << "\nseed,steps,time_s,pressure_Pa_lower,pressure_Pa_upper,temperature_K_lower,"
            << "temperature_K_upper,gas_mass_kg_lower,gas_mass_kg_upper\n";
  for (std::uint64_t seed = std::strtoull(words[1], nullptr, 10);
       seed <= std::strtoull(words[2], nullptr, 10); ++seed) {
    const Tank tank = random_tank(seed);
    const auto scene = scene_of(tank, GASJET_NASA7);
    if (!scene) {
      std::cerr << seed << ": of another kind\n";
      continue;
    }
    try {
      const ShippedTube tube = compute_shipped(tank, *scene, std::atof(words[3]));
      for (const Proved& row : tube.bounds) {
        std::cout << seed << ',' << tube.steps << ',' << row.time;
        for (std::size_t i = 0; i < 3; ++i) std::cout << ',' << row.lower[i] << ',' << row.upper[i];
        std::cout << std::endl;
      }
    } catch (const enclosure::Refusal& refusal) {
      std::cerr << seed << ": " << refusal.what() << '\n';
    }
  }
}
