// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cautery/physics/heat_balance.h>

#include <deal.II/base/mpi.h>

#include <cmath>

namespace Cautery
{
  namespace
  {
    double sum(const Vector &x) { return x.mean_value() * x.size(); }

    /// Less heat than this (J) comes from rounding where none moves.
    constexpr double rounding = 1e-11;
  } // namespace

  HeatTotals &HeatTotals::operator+=(const HeatTotals &other)
  {
    sources += other.sources;
    metabolism += other.metabolism;
    stored += other.stored;
    blood += other.blood;
    boundary += other.boundary;
    expansion += other.expansion;
    adaption += other.adaption;
    return *this;
  }

  double HeatTotals::relative_error() const
  {
    const double moved = std::abs(sources) + std::abs(metabolism) + std::abs(stored) + std::abs(blood) +
                         std::abs(boundary) + std::abs(expansion);
    return moved > rounding ? std::abs(error()) / moved : 0.;
  }

  void HeatTotals::archive(Archive &archive)
  {
    archive.shared("sources", sources);
    archive.shared("metabolism", metabolism);
    archive.shared("stored", stored);
    archive.shared("blood", blood);
    archive.shared("boundary", boundary);
    archive.shared("expansion", expansion);
    archive.shared("adaption", adaption);
  }

  template <int dim>
  HeatBalance<dim>::HeatBalance(Heat<dim>                        &heat,
                                const ThermoelasticFeedback<dim> *feedback,
                                const State                      &start,
                                const Rule                        rule)
    : heat(heat)
    , feedback(feedback)
    , rule(rule)
    , delivered(heat.nodes().vector())
    , left(heat.nodes().vector())
    , since(start.time)
    , temperature_then(start.temperature)
    , temperature_integral(heat.nodes().vector())
  {
    if (rule == Rule::trapezoid)
      last_temperature = start.temperature;
    if (feedback != nullptr)
      displacement_then = start.displacement;
    if (heat.relaxes())
      {
        if (heat.changes())
          heat.refresh(start, start.temperature);
        delayed          = heat.changes() ? conducted(start.temperature) : start.temperature;
        delayed_integral = heat.nodes().vector();
        if (rule == Rule::trapezoid && heat.changes())
          last_conducted = delayed;
        first_flux = heat.books().blood_source;
        first_flux += heat.books().metabolism;
        heat.loads().add_last(start.time, first_flux);
        Vector product = heat.nodes().vector();
        heat.stiffness().full.vmult(product, start.temperature);
        first_flux -= product;
        heat.books().capacity.vmult(product, start.temperature_rate);
        first_flux -= product;
        if (feedback != nullptr)
          {
            feedback->matrix().vmult(product, start.displacement_rate);
            first_flux -= product;
          }
      }
  }

  /// Beyond that of a body at the temperature @p base (K), J: the difference of enthalpy.
  template <int dim>
  double HeatBalance<dim>::heat_content(const State &state, const double base)
  {
    if (heat.changes())
      {
        State even       = state;
        even.temperature = base;
        heat.refresh(even, state.temperature);
      }
    Vector above = state.temperature, product = state.temperature;
    above.add(-base);
    (heat.relaxes() ? heat.books().capacity : heat.damping()->full).vmult(product, above);
    return sum(product);
  }

  template <int dim>
  void HeatBalance<dim>::go_on(HeatBalance &before, const State &last, const State &start)
  {
    past              = before.totals(last);
    const double base = last.temperature.mean_value();
    const double made = heat_content(start, base) - before.heat_content(last, base);
    if (heat.changes())
      heat.refresh(start, start.temperature);
    past.adaption += made;
    past.stored += made;
  }

  template <int dim>
  void HeatBalance<dim>::record(const Step &step, const State &now)
  {
    const double  dt       = step.length();
    const bool    implicit = rule == Rule::end_of_step;
    const Vector &before   = implicit ? now.temperature : last_temperature;
    heat.loads().record(step, !implicit, delivered, received);
    temperature_integral.add(0.5 * dt, before, 0.5 * dt, now.temperature);
    if (heat.relaxes())
      relax(dt, now.temperature);
    if (heat.is_limited())
      lend(dt);
    if (!implicit)
      last_temperature = now.temperature;
    if (heat.changes())
      flush(now);
  }

  /// What is conducted off, W per node. Blood and convection, which K has too, act at once.
  template <int dim>
  Vector HeatBalance<dim>::conducted(const Vector &temperature) const
  {
    Vector result = heat.nodes().vector(), exchanged = heat.nodes().vector();
    heat.stiffness().full.vmult(result, temperature);
    heat.books().exchange.vmult(exchanged, temperature);
    result -= exchanged;
    return result;
  }

  template <int dim>
  void HeatBalance<dim>::relax(const double dt, const Vector &temperature)
  {
    const bool    implicit = rule == Rule::end_of_step;
    const Vector  product  = heat.changes() ? conducted(temperature) : Vector();
    const Vector &now      = heat.changes() ? product : temperature;
    const Vector &before   = implicit ? now : heat.changes() ? last_conducted : last_temperature;
    const double *tau      = heat.books().delay.begin();
    double *const Y        = delayed.begin();
    double *const integral = delayed_integral.begin();
    double *const flux     = first_flux.begin();
    double       *rest     = left.begin();
    double        sum_flux = 0.;
    for (unsigned int i = 0; i < delayed.locally_owned_size(); ++i)
      {
        // tau (Y - Y_before) / dt + Y = X, at the end of the step or with the means of both ends
        const double r     = tau[i] / dt;
        const double Y_old = Y[i];
        const double X     = now.begin()[i];
        Y[i]               = implicit ? (r * Y_old + X) / (r + 1.) :
                                        ((r - 0.5) * Y_old + 0.5 * (X + before.begin()[i])) / (r + 0.5);
        integral[i] += dt * (implicit ? Y[i] : 0.5 * (Y[i] + Y_old));

        const double flux_old = flux[i];
        flux[i] *= implicit ? r / (r + 1.) : std::exp(-1. / r);
        const double carried = implicit ? dt * flux[i] : tau[i] * (flux_old - flux[i]);
        rest[i] -= carried;
        sum_flux += carried;
      }
    if (!implicit && heat.changes())
      last_conducted = now;
    first += Utilities::MPI::sum(sum_flux, heat.nodes().communicator());
  }

  /// What the limiter gives acts like a source: in the non-Fourier model as s with tau s' + s.
  template <int dim>
  void HeatBalance<dim>::lend(const double dt)
  {
    const Vector &power = heat.lent();
    if (lending.size() == 0)
      lending = heat.nodes().vector();
    for (unsigned int i = 0; i < power.locally_owned_size(); ++i)
      {
        const double r     = heat.relaxes() ? heat.books().delay.begin()[i] / dt : 0.;
        lending.begin()[i] = (r * lending.begin()[i] + power.begin()[i]) / (1. + r);
      }
    lent += dt * sum(lending);
  }

  template <int dim>
  void HeatBalance<dim>::flush(const State &now)
  {
    const auto  &books    = heat.books();
    const double duration = now.time - since;
    if (duration == 0.)
      return;
    Vector product = heat.nodes().vector();
    Vector change  = now.temperature;
    change -= temperature_then;

    (heat.relaxes() ? books.capacity : heat.damping()->full).vmult(product, change);
    stored += sum(product);
    left -= product;
    if (heat.relaxes())
      flush_delayed();
    else
      {
        heat.stiffness().full.vmult(product, temperature_integral);
        left -= product;
      }
    if (feedback != nullptr)
      {
        change.reinit(now.displacement);
        change = now.displacement;
        change -= displacement_then;
        feedback->matrix().vmult(product, change);
        expansion += sum(product);
        left -= product;
        displacement_then = now.displacement;
      }
    left.add(duration, books.blood_source, duration, books.metabolism);
    metabolism += duration * sum(books.metabolism);
    blood += books.blood_weights * temperature_integral - duration * sum(books.blood_source);
    surfaces += books.surface_weights * temperature_integral;

    since                = now.time;
    temperature_then     = now.temperature;
    temperature_integral = 0.;
  }

  template <int dim>
  void HeatBalance<dim>::flush_delayed()
  {
    Vector product = delayed_integral, at_once = temperature_integral;
    if (!heat.changes())
      {
        heat.stiffness().full.vmult(product, delayed_integral);
        at_once -= delayed_integral; // K has blood and convection in it, which act on T itself
      }
    left -= product;
    heat.books().exchange.vmult(product, at_once);
    left -= product;
    delayed_integral = 0.;
  }

  template <int dim>
  HeatTotals HeatBalance<dim>::totals(const State &now)
  {
    flush(now);
    Vector taken = left;
    taken += delivered;
    heat.nodes().hanging().condense(taken);
    HeatTotals result;
    result.sources    = received.sources;
    result.metabolism = metabolism;
    result.stored     = stored;
    result.blood      = blood;
    result.expansion  = expansion;
    // convection and given fluxes are known; what is left over at nodes of prescribed temperature went
    // through them
    result.boundary = surfaces - received.surfaces + first + heat.prescribed_temperatures().sum(taken) - lent;
    result += past;
    return result;
  }

  template <int dim>
  void HeatBalance<dim>::archive(Archive &archive)
  {
    archive.section("earlier meshes", [&]() { past.archive(archive); });
    received.archive(archive);
    archive.shared("stored", stored);
    archive.shared("lost to blood", blood);
    archive.shared("lost through surfaces", surfaces);
    archive.shared("made by metabolism", metabolism);
    archive.shared("consumed by expansion", expansion);
    archive.shared("carried by the first flux", first);
    archive.shared("lent by the limiter", lent);
    if (heat.is_limited() && lending.size() == 0)
      lending = heat.nodes().vector();
    archive.nodal("power lent", lending);
    archive.shared("last flush", since);
    archive.nodal("delivered", delivered);
    archive.nodal("left", left);
    archive.nodal("last temperature", last_temperature);
    archive.nodal("temperature at the last flush", temperature_then);
    archive.nodal("displacement at the last flush", displacement_then);
    archive.nodal("integral of temperature", temperature_integral);
    archive.nodal("first flux", first_flux);
    archive.nodal("delayed", delayed);
    archive.nodal("integral of delayed", delayed_integral);
    archive.nodal("last conducted", last_conducted);
  }

  template class HeatBalance<2>;
  template class HeatBalance<3>;
} // namespace Cautery
