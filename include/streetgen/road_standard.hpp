// The demands of a base speed on a road: radii, lengths and grades by the laws of road design.
#pragma once

namespace streetgen {

// The least radius of a curve at a speed (km/h): V^2 / (127 (superelevation + friction)), metres.
// The superelevation is rise over run. Friction below 0 stands for that of the Portuguese norm
// (JAE P3/94): 0.16 at 40 km/h falling to 0.06 at 140, linear between its speeds.
double least_radius(double speed, double superelevation, double friction);

}  // namespace streetgen
