#include "frame/progress.hpp"

#include <ctime>

#include "frame/border.hpp"
#include "streetgen/progress.hpp"

extern "C" {
#include <utils/backend_status.h>
#include <utils/guc.h>
}

namespace streetgen::pg {

namespace {

char of_call[NAMEDATALEN] = "";
double told_at = 0;  // seconds
bool told = false;

double seconds() noexcept {
  timespec now;
  clock_gettime(CLOCK_MONOTONIC_COARSE, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

void notice(const char* text) noexcept {
  MemoryContext context = CurrentMemoryContext;
  HOLD_INTERRUPTS();
  PG_TRY();
  { ereport(NOTICE, (errmsg("%s", text), errhidestmt(true), errhidecontext(true))); }
  PG_CATCH();
  {
    MemoryContextSwitchTo(context);
    FlushErrorState();
  }
  PG_END_TRY();
  RESUME_INTERRUPTS();
}

void tell(const char* step, std::size_t done, std::size_t of) noexcept {
  const double now = seconds();
  if (now - told_at < 1) return;
  told_at = now;
  told = true;
  char text[NAMEDATALEN];
  const int percent = of == 0 ? 0 : static_cast<int>(100 * done / of);
  snprintf(text, sizeof text, "%s: %s, %d %%", of_call, step, percent);
  pgstat_report_appname(text);
  notice(text);
}

}  // namespace

void begin_progress(const char* of) noexcept {
  strlcpy(of_call, of, sizeof of_call);
  told_at = seconds();
  told = false;
  set_progress_listener(tell);
}

void end_progress() noexcept {
  set_progress_listener(nullptr);
  if (told) pgstat_report_appname(application_name);
}

}  // namespace streetgen::pg
