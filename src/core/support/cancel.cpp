#include "streetgen/cancel.hpp"

#include "streetgen/error.hpp"

namespace streetgen {

namespace {
thread_local CancelCheck cancel_check = nullptr;
}

void set_cancel_check(CancelCheck check) noexcept { cancel_check = check; }

bool cancel_wanted() noexcept { return cancel_check != nullptr && cancel_check(); }

void poll_cancel() {
  if (cancel_wanted()) throw Error(ErrorKind::cancelled, "canceling statement due to user request");
}

}  // namespace streetgen
