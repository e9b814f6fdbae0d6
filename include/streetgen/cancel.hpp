// Long computations ask now and then whether they should stop.
#pragma once

namespace streetgen {

// Set by the caller for its own computations (thread local; nullptr: never cancelled).
using CancelCheck = bool (*)() noexcept;
void set_cancel_check(CancelCheck check) noexcept;

// Whether the caller asks to stop.
bool cancel_wanted() noexcept;

// Throws Error{cancelled} when the caller asks to stop.  Costs a few nanoseconds.
void poll_cancel();

}  // namespace streetgen
