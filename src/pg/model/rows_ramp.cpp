// The rows of subject ramp.
#include <utility>

#include "model/row_value.hpp"
#include "model/streets_give.hpp"

namespace streetgen::pg {

namespace {

using Computed = const ComputedStreets&;

bool fill_ramp(const ComputedStreets& computed, const Named& named, std::size_t i, Row& row) {
  const Ramp& ramp = computed.streets.ramps[i];
  const std::int64_t node = named.nodes[ramp.node], link = named.edges[ramp.link],
                     before = named.edges[ramp.before], after = named.edges[ramp.after];
  return node != 0 && link != 0 && before != 0 && after != 0 &&
         put(row, node, link, before, after, name(ramp.on ? "on" : "off"),
             name(ramp.side > 0 ? "left" : "right"), ramp.lanes_before, ramp.lanes_ramp,
             ramp.lanes_after, ramp.missing, ramp.merging, ramp.full_length,
             ramp.missing > 0 ? ramp.taper : 0.0, ramp.tangent, ramp.auxiliary, ramp.cut,
             ramp.short_link,
             Geometry{
                 stored_point(computed.streets.network.nodes[ramp.node].point, flat(computed))},
             name(ramp.by_hand ? "by_hand" : "hypothesis"));
}

const Table ramp_table{[](Computed c) { return c.streets.ramps.size(); }, fill_ramp};

}  // namespace

STREETGEN_TABLE(ramp, &Named::nodes, &Named::edges)

}  // namespace streetgen::pg
