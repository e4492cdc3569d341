// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cautery/base/linear_algebra.h>

#include <map>
#include <string>
#include <utility>
#include <vector>

namespace Cautery
{
  /**
   * All that the rest of a run depends on, by name.
   *
   * A class lists what it remembers in one function `archive(Archive &)`, as it lists its parameters: the
   * same call stores it, and later brings it back into an object made from the same scene. What follows from
   * the rest is not stored but made again. Numbers come back with all their bits.
   *
   * Each process has an archive of its own; the kind of an entry says how those of different processes belong
   * together, so that a run may go on on another number of them.
   */
  class Archive
  {
  public:
    enum class Kind
    {
      shared, ///< the same on all processes
      nodal,  ///< the same number of numbers for each node
      summed, ///< shares of a sum
      own     ///< of use on the same number of processes only
    };
    struct Entry
    {
      Kind                kind;
      std::vector<double> numbers;
    };
    using Entries = std::map<std::string, Entry>;

    /** Stores. */
    Archive() = default;
    /** Brings back. */
    explicit Archive(Entries entries) : all(std::move(entries)), restoring(true) {}

    bool           restores() const { return restoring; }
    const Entries &entries() const { return all; }

    /** Calls @p inside, the names of whose entries begin with @p name. */
    template <typename Function>
    void section(const std::string &name, const Function &inside)
    {
      const std::string outer = prefix;
      prefix += name + ": ";
      inside();
      prefix = outer;
    }

    /** A number; integers up to 2^53. */
    template <typename Number>
    void shared(const std::string &name, Number &value)
    {
      exchange(name, Kind::shared, &value, 1);
    }
    void shared(const std::string &name, std::vector<double> &values);

    /** Of the process's own nodes, some for each, node after node. Empty ones are left out. */
    void nodal(const std::string &name, Vector &values)
    {
      nodal(name, values.begin(), values.locally_owned_size());
    }
    void nodal(const std::string &name, std::vector<double> &values)
    {
      nodal(name, values.data(), values.size());
    }
    template <typename Number>
    void nodal(const std::string &name, Number *values, const std::size_t n)
    {
      exchange(name, Kind::nodal, values, n);
    }

    /** The process's share of a sum. On another number of processes the first gets it all. */
    void summed(const std::string &name, double &value) { exchange(name, Kind::summed, &value, 1); }

    /** What this process alone knows. Returns false, the values untouched, on another number of processes. */
    bool own(const std::string &name, std::vector<double> &values);

  private:
    Entry &entry(const std::string &name, const Kind kind);

    template <typename Number>
    void exchange(const std::string &name, const Kind kind, Number *values, const std::size_t n)
    {
      Entry &found = entry(name, kind);
      if (restoring)
        {
          check_size(name, found.numbers.size(), n);
          for (std::size_t i = 0; i < n; ++i)
            values[i] = static_cast<Number>(found.numbers[i]);
        }
      else
        found.numbers.assign(values, values + n);
    }
    void check_size(const std::string &name, const std::size_t stored, const std::size_t wanted) const;

    Entries     all;
    bool        restoring = false;
    std::string prefix;
  };
} // namespace Cautery
