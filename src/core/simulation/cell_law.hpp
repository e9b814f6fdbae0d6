// Both laws of a flow through cells: what a cell sends, what it takes, and how a link goes on.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "streetgen/cell_flow.hpp"

namespace streetgen {

// The cells of a link.
struct LinkCells {
  std::int32_t first = 0, count = 1;
  double length = 1, speed = 1;  // of a cell; of the link
  double capacity = 0;           // greatest flow
};

// A flow, and the eagerness that it carries.
struct CellFlux {
  double cars = 0, eager = 0;
};

struct CellStates {
  std::vector<double> density;
  std::vector<double> eager;  // density times eagerness; arz alone

  double eagerness(int cell) const { return density[cell] > 0 ? eager[cell] / density[cell] : 1; }
};

// The smaller one of two changes of one sign, else 0.
inline double common_change(double a, double b) {
  return std::max(0., std::min(a, b)) + std::min(0., std::max(a, b));
}

struct LwrLaw {
  static constexpr bool carries = false;  // eagerness
  double jam, wave;

  double capacity(double speed) const { return speed * wave / (speed + wave) * jam; }
  double fastest(double speed) const { return std::max(speed, wave); }
  double eagerness(const CellStates&, int) const { return 1; }

  double sent(const CellStates& states, int cell, const LinkCells& link) const {
    return std::min(link.speed * states.density[cell], link.capacity);
  }
  double taken(const CellStates& states, int cell, const LinkCells& link, double) const {
    return std::min(link.capacity, wave * (jam - states.density[cell]));
  }
  double speed(const CellStates& states, int cell, double free) const {
    const double density = states.density[cell];
    return density > 0 ? std::min(free, wave * (jam - density) / density) : free;
  }

  // A step of the cells of a link; `flux` has room for one flow more than cells.
  void advance(CellStates& states, const LinkCells& link, CellFlux in, CellFlux out, double step,
               double* flux) const {
    double* density = &states.density[link.first];
    const int last = link.count - 1;
    const double share = step / link.length;
    if (last == 0) {
      *density += share * (in.cars - out.cars);
      return;
    }
    // The densities at a border go as far downwind as no cell then passes its neighbours.
    const double ahead = 1 / (share * link.speed) - 1, back = 1 / (share * wave) - 1;
    const auto between = [&](int i, double before, double behind) {
      const double jump = density[i + 1] - density[i];
      const double left = density[i] + common_change(ahead * before, jump);
      const double right = density[i + 1] - common_change(back * behind, jump);
      return std::min(std::min(link.speed * left, link.capacity), wave * (jam - right));
    };
    flux[0] = in.cars;
    flux[last + 1] = out.cars;
    if (last == 1) {
      flux[1] = between(0, 0, 0);
    } else {
      flux[1] = between(0, 0, density[2] - density[1]);
      for (int i = 1; i < last - 1; ++i)
        flux[i + 1] = between(i, density[i] - density[i - 1], density[i + 2] - density[i + 1]);
      flux[last] = between(last - 1, density[last - 1] - density[last - 2], 0);
    }
    for (int i = 0; i <= last; ++i) density[i] += share * (flux[i] - flux[i + 1]);
  }
};

struct ArzLaw {
  static constexpr bool carries = true;  // eagerness
  double jam, relaxation;

  // The flow of drivers so eager, of cars at jam density and full speed.
  static double flow(double density, double eagerness) {
    return density * (eagerness - std::sqrt(density));
  }
  // The density of the greatest flow.
  static double critical(double eagerness) { return 4. / 9 * eagerness * eagerness; }

  double capacity(double speed) const { return flow(critical(1), 1) * speed * jam; }
  double fastest(double speed) const { return speed; }
  double eagerness(const CellStates& states, int cell) const { return states.eagerness(cell); }

  // The speed of a cell in relation to its link's.
  double pace(const CellStates& states, int cell) const {
    return std::max(0., states.eagerness(cell) - std::sqrt(states.density[cell] / jam));
  }
  double speed(const CellStates& states, int cell, double free) const {
    return free * pace(states, cell);
  }
  double sent(const CellStates& states, int cell, const LinkCells& link) const {
    const double eagerness = states.eagerness(cell);
    return link.speed * jam *
           flow(std::min(states.density[cell] / jam, critical(eagerness)), eagerness);
  }
  // Drivers who come close up to the pace of those in the cell.
  double taken(const CellStates& states, int cell, const LinkCells& link, double eagerness) const {
    double density = critical(eagerness);
    if (states.density[cell] > 0) {
      const double slower = eagerness - pace(states, cell);
      if (slower > 0) density = std::max(density, slower * slower);
    }
    return link.speed * jam * flow(density, eagerness);
  }

  void advance(CellStates& states, const LinkCells& link, CellFlux in, CellFlux out, double step,
               double*) const {
    const double share = step / link.length, calmed = step / (relaxation + step);
    CellFlux before = in;
    for (int i = link.first; i < link.first + link.count; ++i) {
      CellFlux behind = out;
      if (i + 1 < link.first + link.count) {
        const double eagerness = states.eagerness(i);
        behind.cars = std::min(sent(states, i, link), taken(states, i + 1, link, eagerness));
        behind.eager = behind.cars * eagerness;
      }
      states.density[i] += share * (before.cars - behind.cars);
      states.eager[i] += share * (before.eager - behind.eager);
      if (relaxation > 0) states.eager[i] += calmed * (states.density[i] - states.eager[i]);
      before = behind;
    }
  }
};

}  // namespace streetgen
