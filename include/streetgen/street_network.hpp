// The network of streets: of streets that a source has twice it holds one.
#pragma once

#include <vector>

#include "streetgen/street.hpp"

namespace streetgen {

// The network of the axes, without twins and with reports of ends that miss.
//
// An edge lies on another axis of its level where all of it is no farther from that than the
// tolerance, or a quarter of the narrower of both roadways, and runs as that does.  The less
// important one lies on the other, then the narrower, then that of the greater axis_id.  It is a
// twin, and no edge, where the other one leads wherever it leads: in its directions, and to its
// nodes or dead ends.  A report for each stretch tells its middle and its length.
//
// The end of an axis misses where no other one meets it and the roadway of another one of its level
// holds it, but where one of them lies on the other.  Of two ends that miss each other that of
// the greater axis_id does.
//
// Signals in mid-block cut their edge: they stand on a node of two edges, of their axis and place.
Network street_network(const std::vector<StreetAxis>& axes, double tolerance, Crossing crossing,
                       const ControlRules& controls = {});

// The same network, without reports of ends.
Network network_without_end_reports(const std::vector<StreetAxis>& axes, double tolerance,
                                    Crossing crossing, const ControlRules& controls);

}  // namespace streetgen
