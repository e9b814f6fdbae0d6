// How far a long computation is, for its client and for other sessions.
#pragma once

namespace streetgen::pg {

// From now on the core's progress is told, once a second at most: as a NOTICE, and in
// pg_stat_activity.application_name until end_progress. The one call of PostgreSQL within a
// compute step: no error leaves it, and interrupts wait.
// `of` opens each line, such as "streets of 7 axes".
void begin_progress(const char* of) noexcept;
void end_progress() noexcept;

}  // namespace streetgen::pg
