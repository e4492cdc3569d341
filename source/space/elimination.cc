// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cautery/space/elimination.h>

namespace Cautery
{
  void Elimination::reinit(const AffineConstraints<double> &constraints, const IndexSet &owned)
  {
    lines.clear();
    for (const auto &line : constraints.get_lines())
      if (owned.is_element(line.index))
        {
          lines.push_back({static_cast<unsigned int>(owned.index_within_set(line.index)), {}});
          for (const auto &[index, weight] : line.entries)
            {
              Assert(owned.is_element(index), ExcMessage("A constraint must not leave its process."));
              lines.back().depends_on.emplace_back(owned.index_within_set(index), weight);
            }
        }
  }

  void Elimination::condense(Vector &residual) const
  {
    double *const entries = residual.begin();
    for (const auto &line : lines)
      {
        for (const auto &[index, weight] : line.depends_on)
          entries[index] += weight * entries[line.row];
        entries[line.row] = 0.;
      }
  }

  void Elimination::distribute(Vector &x) const
  {
    double *const entries = x.begin();
    for (const auto &line : lines)
      {
        entries[line.row] = 0.;
        for (const auto &[index, weight] : line.depends_on)
          entries[line.row] += weight * entries[index];
      }
  }

  void Elimination::clear(Vector &x) const
  {
    for (const auto &line : lines)
      x.begin()[line.row] = 0.;
  }

  void Elimination::copy_constrained(const Vector &from, Vector &to) const
  {
    for (const auto &line : lines)
      to.begin()[line.row] = from.begin()[line.row];
  }

  void Elimination::keep_constrained(Vector &x) const
  {
    std::vector<double> kept;
    kept.reserve(lines.size());
    for (const auto &line : lines)
      kept.push_back(x.begin()[line.row]);
    x = 0.;
    for (unsigned int i = 0; i < lines.size(); ++i)
      x.begin()[lines[i].row] = kept[i];
  }
} // namespace Cautery
