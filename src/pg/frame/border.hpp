// The one door between PostgreSQL and the core.
//
// PostgreSQL reports an error by longjmp, C++ by an exception, and neither survives the other's
// frames.  Every SQL function has three steps that never mix: take (PostgreSQL calls, plain
// locals), compute (C++ only), give (PostgreSQL calls, plain locals).
#pragma once

#include <exception>
#include <new>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

#include "frame/build_mark.hpp"
#include "streetgen/cancel.hpp"
#include "streetgen/error.hpp"

extern "C" {
#include <postgres.h>

#include <fmgr.h>
#include <funcapi.h>
#include <miscadmin.h>
#include <utils/memutils.h>
}

// On PostgreSQL 15 PGDLLEXPORT is empty on Linux, and we build with hidden visibility.
#define STREETGEN_FUNCTION(name)                                                   \
  static Datum name##_of_one_build(PG_FUNCTION_ARGS);                              \
  extern "C" {                                                                     \
  __attribute__((visibility("default"))) const Pg_finfo_record* pg_finfo_##name(); \
  const Pg_finfo_record* pg_finfo_##name() {                                       \
    static const Pg_finfo_record record = {1};                                     \
    return &record;                                                                \
  }                                                                                \
  __attribute__((visibility("default"))) Datum name(PG_FUNCTION_ARGS);             \
  Datum name(PG_FUNCTION_ARGS) {                                                   \
    streetgen::pg::require_one_build();                                            \
    return name##_of_one_build(fcinfo);                                            \
  }                                                                                \
  }                                                                                \
  static Datum name##_of_one_build(PG_FUNCTION_ARGS)

namespace streetgen::pg {

// A C++ object owned by a memory context and freed with it, however the statement ends.
// Nothing in T's destructor throws or calls PostgreSQL.
template <class T>
struct Slot {
  MemoryContextCallback on_reset;
  T* value;
};

template <class T>
Slot<T>* make_slot(MemoryContext owner) {
  auto* slot = static_cast<Slot<T>*>(MemoryContextAllocZero(owner, sizeof(Slot<T>)));
  slot->on_reset.func = [](void* p) {
    delete std::exchange(static_cast<Slot<T>*>(p)->value, nullptr);
  };
  slot->on_reset.arg = slot;
  MemoryContextRegisterResetCallback(owner, &slot->on_reset);
  return slot;
}

// How the compute step ended: plain bytes, so that a longjmp may step over them.
struct Outcome {
  int sqlstate = 0;  // 0: it went well, and nothing else is said
  char message[512];
  char hint[1024];  // empty: none
};
static_assert(std::is_trivially_destructible_v<Outcome>);

int sqlstate_of(ErrorKind kind) noexcept;
bool cancel_requested() noexcept;

template <class Work>
Outcome compute(Work&& work) noexcept {
  Outcome outcome;
  const auto failed = [&](int sqlstate, const char* message, const char* hint = "") {
    outcome.sqlstate = sqlstate;
    strlcpy(outcome.message, message, sizeof outcome.message);
    strlcpy(outcome.hint, hint, sizeof outcome.hint);
  };
  set_cancel_check(cancel_requested);
  try {
    work();
  } catch (const Error& e) {
    failed(sqlstate_of(e.kind()), e.what(), e.hint().c_str());
  } catch (const std::bad_alloc&) {
    failed(ERRCODE_OUT_OF_MEMORY, "out of memory");
  } catch (const std::exception& e) {
    failed(ERRCODE_INTERNAL_ERROR, e.what());
  } catch (...) {
    failed(ERRCODE_INTERNAL_ERROR, "unknown C++ exception");
  }
  return outcome;
}

// Raises what `compute` caught: no C++ frame is left by now.
void report(const Outcome& outcome);

// What a bytea or text holds, detoasted by the take step: PostgreSQL owns it during the call.
std::string_view bytes_of(Datum datum);
std::string text_of(Datum datum);

// A bytea in the current memory context.
Datum bytes_datum(const std::string& bytes);

}  // namespace streetgen::pg
