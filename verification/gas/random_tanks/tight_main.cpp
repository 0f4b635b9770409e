// SPDX-License-Identifier: Apache-2.0
// Prints p, T and m of the tight tanks at the ends of their calls by libgas, or with the word `tubes` their
// bounds.
#include <iostream>
#include <string>

#include "libgas_route.hpp"
#include "tight_tanks.hpp"
#include "tube.hpp"

int main(int count, char**) {
  using namespace random_tanks;
  std::cout.precision(17);
  for (const Tank& tank : tight_tanks()) {
    if (count > 1) {
      for (const auto& moment :
           enclosure::enclose(*scene_of(tank, GASJET_NASA7), {.times = tank.times, .width = 1e-13}).moments)
        for (const std::size_t column : {0U, 1U, 3U})
          std::cout << moment.bounds[column].lower << ' ' << moment.bounds[column].upper << '\n';
      continue;
    }
    for (const Sample& s : libgas_route(tank).samples)
      std::cout << s.pressure << '\n' << s.temperature << '\n' << s.mass << '\n';
  }
}
