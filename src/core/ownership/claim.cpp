#include "ownership/claim.hpp"

#include <algorithm>
#include <tuple>

namespace streetgen {

bool tile(const Claim& a, const Claim& b) {
  return a.level == b.level || std::find_first_of(a.edges.begin(), a.edges.end(), b.edges.begin(),
                                                  b.edges.end()) != a.edges.end();
}

bool before(const Claim& a, const Claim& b) {
  return std::tie(a.importance, b.width, b.axis_lengths, a.axis_id, a.order_key) <
         std::tie(b.importance, a.width, a.axis_lengths, b.axis_id, b.order_key);
}

}  // namespace streetgen
