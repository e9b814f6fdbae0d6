// PostgreSQL's values of variable length: from version 16 on their macros have a header of their
// own.
#pragma once

extern "C" {
#include <postgres.h>
#if PG_VERSION_NUM >= 160000
#include <varatt.h>
#endif
}
