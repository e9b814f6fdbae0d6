// Results of one row, whose columns are arrays of numbers.
#pragma once

#include <vector>

extern "C" {
#include <postgres.h>

#include <fmgr.h>
#include <nodes/execnodes.h>
}

namespace streetgen::pg {

using NumberColumns = std::vector<std::vector<double>>;

ReturnSetInfo* result_of(FunctionCallInfo fcinfo);

// One row of arrays; none where the first column is empty.
void give_row(const NumberColumns& columns, ReturnSetInfo* result);

}  // namespace streetgen::pg
