#include "streetgen/progress.hpp"

namespace streetgen {

namespace {
thread_local ProgressListener progress_listener = nullptr;
}

void set_progress_listener(ProgressListener listener) noexcept { progress_listener = listener; }

void tell_progress(const char* step, std::size_t done, std::size_t of) noexcept {
  if (progress_listener != nullptr) progress_listener(step, done, of);
}

}  // namespace streetgen
