// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cautery/solve/ssor_cg.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/tensor.h>
#include <deal.II/lac/trilinos_sparsity_pattern.h>

#include <Epetra_CrsMatrix.h>

#include <map>
#include <utility>

namespace Cautery
{
  namespace
  {
    template <int size>
    class BlockSsorCG : public SsorCG
    {
    public:
      BlockSsorCG(const SparseMatrix &matrix, const double relaxation);
      unsigned int
      solve(Vector &x, const Vector &r, const double reduction, const unsigned int max_iterations) override;

    private:
      using Node  = Tensor<1, size>;
      using Block = Tensor<2, size>;

      void   read(const SparseMatrix &matrix);
      void   read_coupling(const SparseMatrix &matrix);
      void   forward(const std::vector<Node> &f, std::vector<Node> &y) const;
      void   backward();
      double apply();
      double precondition();

      const double              relaxation; ///< omega
      const unsigned int        n_nodes;
      const MPI_Comm            communicator;
      std::vector<std::size_t>  start = {0}; ///< of a node's row in `columns` and `lower`
      std::vector<unsigned int> columns;     ///< nodes
      std::vector<Block>        lower;       ///< L by rows, without zero blocks
      std::vector<Block>        pivots, inverse_pivots;
      SparseMatrix              coupling; ///< the columns of other processes; empty with one process

      // of the iteration: E^-1 residual, P times that, search direction before and after E^-T, image
      std::vector<Node> hidden_residual, scaled, hidden_direction, direction, image, work;
      Vector            direction_for_all, coupled;
    };

    template <int size>
    BlockSsorCG<size>::BlockSsorCG(const SparseMatrix &matrix, const double relaxation)
      : relaxation(relaxation)
      , n_nodes(matrix.local_size() / size)
      , communicator(matrix.get_mpi_communicator())
      , pivots(n_nodes)
      , inverse_pivots(n_nodes)
    {
      read(matrix);
      if (Utilities::MPI::n_mpi_processes(communicator) > 1)
        read_coupling(matrix);
      for (auto *array : {&hidden_residual, &scaled, &hidden_direction, &direction, &image, &work})
        array->resize(n_nodes);
    }

    /// Calls use(column, value) for a row of this process, both numbers global. deal.II's iterators copy
    /// whole rows: far too slow here.
    template <typename Use>
    void for_each_entry(const SparseMatrix &matrix, const types::global_dof_index row, const Use &use)
    {
      const Epetra_CrsMatrix &entries = matrix.trilinos_matrix();
      int                     length  = 0;
      double                 *values  = nullptr;
      int                    *columns = nullptr;
      entries.ExtractMyRowView(row - matrix.local_range().first, length, values, columns);
      for (int k = 0; k < length; ++k)
        use(static_cast<types::global_dof_index>(entries.GCID(columns[k])), values[k]);
    }

    template <int size>
    void BlockSsorCG<size>::read(const SparseMatrix &matrix)
    {
      const auto                    first = matrix.local_range().first;
      std::map<unsigned int, Block> row;
      for (unsigned int i = 0; i < n_nodes; ++i)
        {
          row.clear();
          for (int c = 0; c < size; ++c)
            for_each_entry(matrix, first + i * size + c, [&](const auto column, const double value) {
              if (value != 0. && column >= first && column < first + (i + 1) * size)
                row[(column - first) / size][c][(column - first) % size] = value;
            });
          for (const auto &[j, block] : row)
            if (j != i)
              {
                columns.push_back(j);
                lower.push_back(block);
              }
          start.push_back(columns.size());
          pivots[i]         = row[i] / relaxation;
          inverse_pivots[i] = invert(pivots[i]);
        }
    }

    template <int size>
    void BlockSsorCG<size>::read_coupling(const SparseMatrix &matrix)
    {
      const IndexSet rows = matrix.locally_owned_range_indices();
      const auto     each = [&](const auto &use) {
        for (const auto row : rows)
          for_each_entry(matrix, row, [&](const auto column, const double value) {
            if (value != 0. && !rows.is_element(column))
              use(row, column, value);
          });
      };
      TrilinosWrappers::SparsityPattern pattern(rows, communicator, 1);
      each([&](const auto row, const auto column, const double) { pattern.add(row, column); });
      pattern.compress();
      coupling.reinit(pattern);
      each([&](const auto row, const auto column, const double value) { coupling.set(row, column, value); });
      coupling.compress(VectorOperation::insert);
      direction_for_all.reinit(rows, communicator);
      coupled.reinit(rows, communicator);
    }

    /// E y = f
    template <int size>
    void BlockSsorCG<size>::forward(const std::vector<Node> &f, std::vector<Node> &y) const
    {
      for (unsigned int i = 0; i < n_nodes; ++i)
        {
          Node sum = f[i];
          for (std::size_t k = start[i]; k < start[i + 1]; ++k)
            sum -= lower[k] * y[columns[k]];
          y[i] = inverse_pivots[i] * sum;
        }
    }

    /// E^T direction = hidden direction
    template <int size>
    void BlockSsorCG<size>::backward()
    {
      work = hidden_direction;
      for (unsigned int i = n_nodes; i-- > 0;)
        {
          const Node value = inverse_pivots[i] * work[i];
          direction[i]     = value;
          for (std::size_t k = start[i]; k < start[i + 1]; ++k)
            work[columns[k]] -= value * lower[k];
        }
    }

    /// image = E^-1 A E^-T hidden direction; returns its product with the hidden direction.
    template <int size>
    double BlockSsorCG<size>::apply()
    {
      backward();
      for (unsigned int i = 0; i < n_nodes; ++i)
        work[i] = hidden_direction[i] - (2. - relaxation) * (pivots[i] * direction[i]);
      if (coupling.m() > 0)
        {
          for (unsigned int i = 0; i < n_nodes; ++i)
            for (int c = 0; c < size; ++c)
              direction_for_all.begin()[i * size + c] = direction[i][c];
          coupling.vmult(coupled, direction_for_all);
          for (unsigned int i = 0; i < n_nodes; ++i)
            for (int c = 0; c < size; ++c)
              work[i][c] += coupled.begin()[i * size + c];
        }
      forward(work, image);
      double product = 0.;
      for (unsigned int i = 0; i < n_nodes; ++i)
        {
          image[i] += direction[i];
          product += image[i] * hidden_direction[i];
        }
      return Utilities::MPI::sum(product, communicator);
    }

    /// scaled = P hidden residual; returns their product.
    template <int size>
    double BlockSsorCG<size>::precondition()
    {
      double product = 0.;
      for (unsigned int i = 0; i < n_nodes; ++i)
        {
          scaled[i] = pivots[i] * hidden_residual[i];
          product += scaled[i] * hidden_residual[i];
        }
      return Utilities::MPI::sum(product, communicator);
    }

    template <int size>
    unsigned int BlockSsorCG<size>::solve(Vector            &x,
                                          const Vector      &r,
                                          const double       reduction,
                                          const unsigned int max_iterations)
    {
      for (unsigned int i = 0; i < n_nodes; ++i)
        for (int c = 0; c < size; ++c)
          work[i][c] = r.begin()[i * size + c];
      forward(work, hidden_residual);
      x                       = 0.;
      double       rho        = precondition();
      const double goal       = reduction * reduction * rho;
      unsigned int iterations = 0;
      hidden_direction        = scaled;
      while (!(rho <= goal) && iterations <= max_iterations)
        {
          const double alpha = rho / apply();
          for (unsigned int i = 0; i < n_nodes; ++i)
            {
              for (int c = 0; c < size; ++c)
                x.begin()[i * size + c] += alpha * direction[i][c];
              hidden_residual[i] -= alpha * image[i];
            }
          const double last = std::exchange(rho, precondition());
          for (unsigned int i = 0; i < n_nodes; ++i)
            hidden_direction[i] = scaled[i] + rho / last * hidden_direction[i];
          ++iterations;
        }
      return iterations;
    }
  } // namespace

  std::unique_ptr<SsorCG> SsorCG::make(const SparseMatrix &matrix, const unsigned int n_components)
  {
    // measured on the chapter 4 cube: 1 is best where the capacity rules, 1.3 to 1.5 for elasticity
    if (n_components == 1)
      return std::make_unique<BlockSsorCG<1>>(matrix, 1.);
    if (n_components == 2)
      return std::make_unique<BlockSsorCG<2>>(matrix, 1.4);
    Assert(n_components == 3, ExcNotImplemented());
    return std::make_unique<BlockSsorCG<3>>(matrix, 1.4);
  }
} // namespace Cautery
