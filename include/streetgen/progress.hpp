// Long computations tell now and then how far they are.
#pragma once

#include <cstddef>

namespace streetgen {

// Gets the name of the step and how much of it is done. Called often: whoever sets it decides how
// often it is worth hearing (thread local; nullptr: nobody listens).
using ProgressListener = void (*)(const char* step, std::size_t done, std::size_t of) noexcept;
void set_progress_listener(ProgressListener listener) noexcept;

// Costs a few nanoseconds.
void tell_progress(const char* step, std::size_t done, std::size_t of) noexcept;

}  // namespace streetgen
