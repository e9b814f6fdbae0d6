// The rows of subject interconnection.
#include <utility>

#include "model/row_value.hpp"
#include "model/streets_give.hpp"
#include "value/lane_text.hpp"

namespace streetgen::pg {

namespace {

using Computed = const ComputedStreets&;

bool fill_interconnection(const ComputedStreets& computed, const Named& named, std::size_t i,
                          Row& row) {
  const Interconnection& pair = computed.interconnections[i];
  const std::int64_t node = named.nodes[pair.node];
  const std::int64_t lane_in = named.lanes[pair.lane_in], lane_out = named.lanes[pair.lane_out];
  Value traffic;
  if (of_some_alone(pair.traffic)) traffic = kinds_text(pair.traffic);
  if (node == 0 || lane_in == 0 || lane_out == 0) return false;
  return put(row, node, lane_in, lane_out, pair.along_in, pair.along_out,
             name(turn_name(pair.turn)), pair.angle, pair.plausible, name(reason_name(pair.reason)),
             std::move(traffic),
             Geometry{stored_point(pair.control, flat(computed))},
             Geometry{stored_line(pair.line, flat(computed))});
}

const Table interconnection_table{[](Computed c) { return c.interconnections.size(); },
                                  fill_interconnection};

}  // namespace

STREETGEN_TABLE(interconnection, &Named::nodes, &Named::lanes)

}  // namespace streetgen::pg
