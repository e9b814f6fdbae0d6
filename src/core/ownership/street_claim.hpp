// Claims of the surfaces of edges and nodes.
#pragma once

#include "layout/layout.hpp"
#include "ownership/claim.hpp"

namespace streetgen {

// Without a surface yet, wanted where their edge or node is affected.
Claim claim_of_section(const Layout& layout, int edge);
Claim claim_of_intersection(const Layout& layout, int node);

}  // namespace streetgen
