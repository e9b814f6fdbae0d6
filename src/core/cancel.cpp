#include "streetgen/cancel.hpp"

#include "streetgen/error.hpp"

namespace streetgen {

namespace {
thread_local CancelCheck cancel_check = nullptr;
}

void set_cancel_check(CancelCheck check) noexcept { cancel_check = check; }

void poll_cancel() {
  if (cancel_check != nullptr && cancel_check())
    throw Error(ErrorKind::cancelled, "canceling statement due to user request");
}

}  // namespace streetgen
