// Eigen, whose assertions are exceptions here: a backend that aborts takes all sessions with it.
#pragma once

#include <stdexcept>

#define eigen_assert(holds) \
  if (!(holds)) throw std::logic_error("an assertion of Eigen failed: " #holds)

#include <Eigen/Core>
#include <Eigen/LU>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
