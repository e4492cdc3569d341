// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/lac/trilinos_parallel_block_vector.h>
#include <deal.II/lac/trilinos_sparse_matrix.h>
#include <deal.II/lac/trilinos_vector.h>

namespace Cautery
{
  using namespace dealii;

  /// The one kind of vector: distributed over the processes, without ghost entries unless it says so.
  using Vector       = TrilinosWrappers::MPI::Vector;
  using BlockVector  = TrilinosWrappers::MPI::BlockVector;
  using SparseMatrix = TrilinosWrappers::SparseMatrix;
} // namespace Cautery
