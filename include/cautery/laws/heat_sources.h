// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cautery/base/parameters.h>

#include <string>
#include <variant>
#include <vector>

namespace Cautery
{
  /**
   * When a source is on: from each of the times `on` to the next of the times `off`.
   */
  struct Schedule
  {
    std::vector<double> on = {0.}; ///< s
    std::vector<double> off;       ///< s; one fewer than `on`: the last interval does not end

    /** Is it on just after @p time (s)? */
    bool active(const double time) const;
    /** The share of the interval [@p from, @p to] (s) in which it is on, 0 to 1: keeps the energy of a switch
     * inside a step. */
    double share(const double from, const double to) const;
    /** All switching times, rising (s). */
    std::vector<double> switching_times() const;

    void parameters(Parameters &p);
  };

  /**
   * Heat at points, e.g. the holes of a needle (thesis Eq. 4-19): @p power in W at each of the places.
   */
  struct PointSources
  {
    static constexpr char type[] = "points";
    std::vector<Point<3>> places; ///< m
    Expression            power;  ///< W, at each place; an expression in t

    void parameters(Parameters &p);
  };

  /**
   * The same heat everywhere in some regions.
   */
  struct UniformSource
  {
    static constexpr char    type[]  = "uniform";
    std::vector<std::string> regions = {"all"};
    Expression               power; ///< W/m3, an expression in t

    double density(const Point<3> &, const unsigned int) const { return 1.; }
    void   parameters(Parameters &p);
  };

  /**
   * P exp(-r^2 / (2 s^2)) / ((2 pi)^(d/2) s^d), whose integral over the whole space is P.
   */
  struct GaussianSource
  {
    static constexpr char type[] = "Gaussian";
    Point<3>              centre;          ///< m
    double                radius = 0.5e-3; ///< s, the standard deviation, m
    Expression            power;           ///< P in W (W/m in two dimensions), an expression in t

    double density(const Point<3> &place, const unsigned int dimension) const;
    void   parameters(Parameters &p);
  };

  /**
   * A microwave antenna (thesis Eq. 6-35):
   * C_t P [2 rho r + (n - 2)] exp(-2 rho r) / r^n exp(-z^2 / z_0^2) W/mm3 with r and z in mm. Not integrable
   * at r = 0: inside the antenna's own radius the value at that radius holds.
   */
  struct MicrowaveAntenna
  {
    static constexpr char type[] = "microwave antenna";
    Point<3>              centre;                     ///< z = 0 on the axis, m
    Point<3>              axis           = {0, 0, 1}; ///< direction, any length
    double                inner_radius   = 1e-3;      ///< m
    double                scale          = 0.00316;   ///< C_t, mm^(n-3)
    double                attenuation    = 41.3;      ///< rho, 1/m
    double                exponent       = 2.2;       ///< n
    double                axial_distance = 0.0185;    ///< z_0, m
    Expression            power;                      ///< W, an expression in t

    double density(const Point<3> &place, const unsigned int dimension) const;
    void   parameters(Parameters &p);
  };

  /**
   * Any distribution: power times an expression in x, y, z, t.
   */
  struct ExpressionSource
  {
    static constexpr char type[]       = "expression";
    Expression            distribution = 1.; ///< W/m3
    Expression            power        = 1.; ///< factor, an expression in t

    void parameters(Parameters &p);
  };

  /// The one list of heat sources: a new one is added here.
  using AnyHeatSource =
    std::variant<PointSources, UniformSource, GaussianSource, MicrowaveAntenna, ExpressionSource>;

  struct HeatSource
  {
    std::string   name;
    Schedule      schedule;
    AnyHeatSource source;

    /** The factor in time, without the schedule. */
    double amplitude(const double time) const;
    void   parameters(Parameters &p);
  };

  /** "points | uniform | ..." for documentation and messages, in the order of the variant. */
  std::vector<std::string> heat_source_types();

  /** The source of that type with its defaults; ExcInput for an unknown one. */
  AnyHeatSource make_heat_source(const std::string &type);
} // namespace Cautery
