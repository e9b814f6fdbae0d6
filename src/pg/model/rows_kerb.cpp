// The rows of subject kerb.
#include <utility>

#include "model/row_value.hpp"
#include "model/streets_give.hpp"

namespace streetgen::pg {

namespace {

using Computed = const ComputedStreets&;

bool fill_kerb(const ComputedStreets& computed, const Named& named, std::size_t i, Row& row) {
  const Kerb& kerb = computed.streets.kerbs[i];
  const std::int64_t edge = named.edges[kerb.edge];
  Value node, curve;
  if (kerb.node >= 0) {
    if (named.nodes[kerb.node] == 0) return false;
    node = named.nodes[kerb.node];
  }
  if (kerb.curve) curve = Ewkb{write_arc(*kerb.curve, flat(computed))};
  return edge > 0 &&
         put(row, edge, std::move(node), kerb.level, name(kerb_side_name(kerb.side)), kerb.part,
             Geometry{stored_line(kerb.line, flat(computed))}, std::move(curve),
             Geometry{stored_surface(stones_of(kerb), flat(computed))},
             name(method_name(kerb.method)), name(beside_name(kerb.beside)));
}

const Table kerb_table{[](Computed c) { return c.streets.kerbs.size(); }, fill_kerb,
                       [](ComputedStreets& c) { release(c.streets.kerbs); }};

}  // namespace

STREETGEN_TABLE(kerb, &Named::nodes, &Named::edges)

}  // namespace streetgen::pg
