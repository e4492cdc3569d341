// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cautery/space/cell_changes.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Cautery
{
  namespace
  {
    /// Of the square of the error: what divided cells should hold of it together.
    constexpr double bulk = 0.8;
    /// Relative to the target: where dividing ends, and how far merging may go.
    constexpr double after_dividing = 0.9, after_merging = 0.7;
    /// Of the square of the target: what merged cells may add even if it is missed.
    constexpr double negligible = 0.01;

    /**
     * What is to be divided and merged: of each owned cell, in the order of active cells, its part of the
     * error and how often it was divided. Sums are over all processes.
     */
    template <int dim>
    class Candidates
    {
    public:
      /** Errors are relative to the target; of several fields the largest counts. */
      Candidates(const Mesh<dim> &mesh, const std::vector<IndicatedError> &errors, const double target)
        : mesh(mesh), errors(mesh.triangulation().n_active_cells(), 0.), divisions(this->errors.size(), 0)
      {
        for (const auto &cell : mesh.triangulation().active_cell_iterators())
          {
            if (!cell->is_locally_owned())
              continue;
            const unsigned int index = cell->active_cell_index();
            divisions[index]         = mesh.divisions(cell);
            for (const auto &error : errors)
              if (error.gradient > 0.) // else the field is uniform
                this->errors[index] =
                  std::max(this->errors[index],
                           error.cells(index) * std::sqrt(cell->measure()) / (target * error.gradient));
          }
      }

      std::size_t  size() const { return errors.size(); }
      double       error(const std::size_t cell) const { return errors[cell]; }
      unsigned int times_divided(const std::size_t cell) const { return divisions[cell]; }

      /** The sum of value(cell) over the cells for which counts(cell). Collective. */
      template <typename Counts, typename Value>
      double sum(const Counts &counts, const Value &value) const
      {
        double own = 0.;
        for (std::size_t cell = 0; cell < size(); ++cell)
          own += counts(cell) ? value(cell) : 0.;
        return Utilities::MPI::sum(own, mesh.communicator());
      }
      template <typename Counts>
      double sum_of_squares(const Counts &counts) const
      {
        return sum(counts, [this](const std::size_t cell) { return errors[cell] * errors[cell]; });
      }
      template <typename Counts>
      double number(const Counts &counts) const
      {
        return sum(counts, [](const std::size_t) { return 1.; });
      }
      double number_of_all() const { return mesh.n_cells(); }
      double largest() const
      {
        return Utilities::MPI::max(*std::max_element(errors.begin(), errors.end()), mesh.communicator());
      }

      /**
       * The largest limit of the error of a cell at which holds(limit), by bisection of its logarithm; beyond
       * it that is false. Coarse steps keep it away from errors that are equal but for rounding, of which all
       * or none must count.
       */
      template <typename Holds>
      double last_limit(const Holds &holds) const
      {
        double low = std::log(largest()) - 20., high = std::log(largest()) + 1e-3;
        while (high - low > 1e-4)
          {
            const double middle                    = 0.5 * (low + high);
            (holds(std::exp(middle)) ? low : high) = middle;
          }
        return std::exp(low);
      }

    private:
      const Mesh<dim>          &mesh;
      std::vector<double>       errors;
      std::vector<unsigned int> divisions;
    };

    /// Cells with a larger error are divided. @p gain: what the square of the error falls by.
    template <int dim>
    double limit_of_dividing(const Candidates<dim>  &cells,
                             const double            total,
                             const double            gain,
                             const AdaptiveSettings &settings)
    {
      if (total <= 1.)
        return std::numeric_limits<double>::infinity();
      const auto above = [&](const double limit) {
        return [&cells, limit](const std::size_t cell) { return cells.error(cell) > limit; };
      };
      const double wanted =
        std::min(bulk * total, (total - after_dividing * after_dividing) / (1. - 1. / gain));
      const double needed =
        cells.last_limit([&](const double limit) { return cells.sum_of_squares(above(limit)) >= wanted; });
      const double room =
        (settings.max_cells - cells.number_of_all()) / (GeometryInfo<dim>::max_children_per_cell - 1.);
      const auto too_many = [&](const double limit) {
        return cells.number([&](const std::size_t cell) {
          return cells.times_divided(cell) < settings.max_divisions && cells.error(cell) > limit;
        }) > room;
      };
      return too_many(needed) ? 1.001 * cells.last_limit(too_many) : needed;
    }

    /// Cells with a smaller error are merged.
    template <int dim>
    double limit_of_merging(const Candidates<dim> &cells, const double total, const double gain)
    {
      const double budget = std::max(after_merging * after_merging - total, negligible);
      return cells.last_limit([&](const double limit) {
        const auto below = [&](const std::size_t cell) {
          return cells.times_divided(cell) > 0 && cells.error(cell) < limit;
        };
        return (gain - 1.) * cells.sum_of_squares(below) <= budget;
      });
    }
  } // namespace

  template <int dim>
  std::vector<CellChange> cell_changes(const Mesh<dim>                   &mesh,
                                       const unsigned int                 degree,
                                       const std::vector<IndicatedError> &errors,
                                       const AdaptiveSettings            &settings)
  {
    const Candidates<dim> cells(mesh, errors, settings.target_error);
    if (cells.largest() == 0.)
      return {};
    const double total    = cells.sum_of_squares([](const std::size_t) { return true; });
    const double gain     = std::pow(4., degree);
    const double dividing = limit_of_dividing(cells, total, gain, settings);
    // what is merged must not be divided in the next round
    const double merging = std::min(limit_of_merging(cells, total, gain),
                                    dividing / std::sqrt(gain * GeometryInfo<dim>::max_children_per_cell));

    std::vector<CellChange> changes(cells.size(), CellChange::keep);
    for (std::size_t cell = 0; cell < cells.size(); ++cell)
      if (cells.times_divided(cell) < settings.max_divisions && cells.error(cell) > dividing)
        changes[cell] = CellChange::refine;
      else if (cells.times_divided(cell) > 0 && cells.error(cell) < merging)
        changes[cell] = CellChange::coarsen;
    const double n_changes =
      cells.number([&](const std::size_t cell) { return changes[cell] != CellChange::keep; });
    return n_changes > 0. ? changes : std::vector<CellChange>();
  }

  template std::vector<CellChange> cell_changes(const Mesh<2> &,
                                                const unsigned int,
                                                const std::vector<IndicatedError> &,
                                                const AdaptiveSettings &);
  template std::vector<CellChange> cell_changes(const Mesh<3> &,
                                                const unsigned int,
                                                const std::vector<IndicatedError> &,
                                                const AdaptiveSettings &);
} // namespace Cautery
