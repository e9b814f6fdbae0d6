// When two lanes count as parallel.
#pragma once

namespace streetgen {

// |cos| of the angle between them; every trajectory of the published Paris 6e agrees.
constexpr double parallel_cosine = 0.85;

}  // namespace streetgen
