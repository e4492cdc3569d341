// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cautery/scene/scene_checks.h>

#include <algorithm>
#include <cmath>

namespace Cautery
{
  namespace
  {
    void require(const bool condition, const std::string &message)
    {
      AssertThrow(condition, ExcInput(message));
    }

    void check_boundaries(const Scene &scene)
    {
      bool held = !scene.tools.empty();
      for (const auto &boundary : scene.boundaries)
        {
          const std::string path = "Boundaries/" + boundary.name;
          require(!scene.effects.has_heat() || boundary.thermal != Boundary::Thermal::missing,
                  path + " has no thermal condition; set Thermal (e.g. insulated)");
          require(!scene.effects.has_deformation() || boundary.mechanical != Boundary::Mechanical::missing,
                  path + " has no mechanical condition; set Mechanical (e.g. free)");
          held = held || boundary.mechanical == Boundary::Mechanical::fixed ||
                 boundary.mechanical == Boundary::Mechanical::displacement ||
                 boundary.mechanical == Boundary::Mechanical::roller;
        }
      const bool at_rest = scene.effects.deformation == Effects::Deformation::equilibrium ||
                           scene.effects.deformation == Effects::Deformation::large_equilibrium;
      require(
        held || !at_rest,
        "Boundaries: nothing holds the body, so it has no equilibrium; set Mechanical = fixed, roller or "
        "displacement somewhere, or Effects/Deformation = inertia");
    }

    void check_properties(const Scene &scene)
    {
      for (const auto &tissue : scene.tissues)
        require(
          scene.effects.temperature_dependent_properties ||
            (tissue.thermally_constant() && tissue.elastic.youngs_modulus.is_constant() &&
             tissue.expansion.coefficient.is_constant()),
          "Tissues/" + tissue.name +
            " has a property that depends on temperature; set Effects/Temperature-dependent properties = on, "
            "or give a number");
    }

    void check_numerics(const Scene &scene)
    {
      const bool ida = scene.time.integrator == TimeSettings::Integrator::ida;
      require(!ida || scene.effects.has_heat(),
              "Time/Integrator = IDA integrates heat; turn Effects/Heat on");
      require(!ida || scene.effects.coupling != Effects::Coupling::two_way,
              "Time/Integrator = IDA does not know two-way coupling; choose backward Euler or Coupling = "
              "expansion");
      require(
        !ida || scene.effects.deformation != Effects::Deformation::inertia,
        "Time/Integrator = IDA does not know inertia; choose backward Euler or Deformation = equilibrium");
      require(
        !ida || scene.effects.heat != Effects::Heat::non_fourier ||
          scene.effects.metabolism != Effects::Metabolism::q10,
        "Time/Integrator = IDA does not know the rate of a metabolism that grows with temperature in the "
        "non-Fourier model; choose backward Euler, or Metabolism = constant");
      require(
        scene.numerics.displacement_at != Numerics::DisplacementAt::output_times ||
          !scene.effects.damage_needs_strain_energy(),
        "Numerics/Displacement at = output times, but the damage law needs strain energy at every step; "
        "choose automatic");
      require(
        scene.effects.coupling != Effects::Coupling::two_way ||
          scene.effects.deformation != Effects::Deformation::large_equilibrium,
        "Effects/Coupling = two-way is for small deformation; choose Coupling = expansion or Deformation = "
        "equilibrium");
      require(scene.effects.coupling != Effects::Coupling::two_way || !scene.elastic_properties_change(),
              "Effects/Coupling = two-way needs elastic properties that do not depend on temperature and "
              "`Thermal stretch = linearised`; choose Coupling = expansion or such properties");
      require(scene.numerics.degree == 1 ||
                scene.numerics.capacity_matrix == Numerics::CapacityMatrix::consistent,
              "Numerics/Capacity matrix = lumped is for Element degree = 1 only; choose consistent");
      require(
        !scene.numerics.temperature_limiter ||
          (scene.effects.has_heat() && scene.numerics.degree == 1 &&
           scene.time.integrator == TimeSettings::Integrator::backward_euler &&
           scene.effects.coupling != Effects::Coupling::two_way),
        "Numerics/Temperature limiter = on is for heat by backward Euler, elements of degree 1, without "
        "two-way coupling; turn it off");
      require(
        !scene.numerics.mean_dilatation ||
          (scene.numerics.degree == 1 && scene.numerics.method == Numerics::Method::finite_elements &&
           (scene.effects.deformation == Effects::Deformation::equilibrium ||
            scene.effects.deformation == Effects::Deformation::inertia)),
        "Numerics/Mean dilatation = on is for small deformation by finite elements of degree 1; turn it "
        "off, or set Element degree = 2");
      require(ida || scene.time.end / scene.time.step <= scene.time.max_steps,
              "Time/Step = " + to_text(scene.time.step) + " s makes " +
                to_text(std::ceil(scene.time.end / scene.time.step)) +
                " steps to Time/End, more than Largest number of steps = " +
                std::to_string(scene.time.max_steps) + "; take a larger step or allow more");
      require(scene.output.interval == 0. || scene.time.end / scene.output.interval <= scene.time.max_steps,
              "Output/Interval = " + to_text(scene.output.interval) + " s makes " +
                to_text(scene.time.end / scene.output.interval) +
                " outputs, more than Time/Largest number of steps = " + std::to_string(scene.time.max_steps) +
                "; take a larger interval");
    }

    void check_finite_differences(const Scene &scene)
    {
      if (scene.numerics.method != Numerics::Method::finite_differences)
        return;
      const std::string name = "Numerics/Method = finite differences";
      require(
        scene.mesh.shape == MeshSettings::Shape::box && scene.mesh.cells == MeshSettings::Cells::hexahedra,
        name + " needs a grid along the axes; set Mesh/Shape = box and Mesh/Cells = hexahedra, or choose "
               "finite elements");
      require(scene.numerics.degree == 1,
              name + " knows the corners of cells only; set Numerics/Element degree = 1");
      require(!scene.effects.has_large_deformation() && !scene.has_explicit_loop(),
              name + " knows small deformation and implicit steps only; choose finite elements, or "
                     "Effects/Deformation = equilibrium and Time/Integrator = backward Euler");
    }

    /// Another matrix would have to be condensed anew.
    void check_condensation(const Scene &scene)
    {
      if (scene.numerics.kept_nodes.empty())
        return;
      const std::string name = "Numerics/Kept nodes = " + join(scene.numerics.kept_nodes);
      require(!scene.effects.has_large_deformation() && !scene.has_explicit_loop(),
              name +
                " condenses linear systems, which explicit steps and large deformation do not have; leave it "
                "empty");
      require(scene.time.integrator != TimeSettings::Integrator::ida && !scene.thermal_properties_change() &&
                !scene.elastic_properties_change() && !scene.effects.perfusion_stops_in_dead_tissue,
              name +
                " needs a matrix that stays, which IDA, properties that depend on temperature and perfusion "
                "that stops do not leave; leave it empty");
    }

    void check_adaptive(const Scene &scene)
    {
      const AdaptiveSettings &adaptive = scene.mesh.adaptive;
      if (!adaptive.is_on())
        return;
      const std::string name = "Mesh/Adaptive/Follow";
      require(!adaptive.follows_temperature() || scene.effects.has_heat(),
              name + " = temperature, but heat is off; choose displacement, or turn Effects/Heat on");
      require(
        !adaptive.follows_displacement() || scene.effects.has_deformation(),
        name + " = displacement, but deformation is off; choose temperature, or turn Effects/Deformation on");
      require(
        scene.mesh.shape == MeshSettings::Shape::file || scene.mesh.cells == MeshSettings::Cells::hexahedra,
        name + " needs cells that can be divided beside others that are not, as tetrahedra cannot here; set "
               "Mesh/Cells = hexahedra, or choose nothing");
      require(scene.numerics.method == Numerics::Method::finite_elements,
              name + ": finite differences know one grid only; choose nothing, or Method = finite elements");
      require(
        !scene.has_explicit_loop() && scene.numerics.large_equilibrium == Numerics::LargeEquilibrium::newton,
        name +
          ": explicit steps and dynamic relaxation do not know nodes that follow others; choose nothing");
      require(scene.numerics.kept_nodes.empty(),
              name + ": Numerics/Kept nodes needs a mesh that stays; choose nothing, or leave it empty");
      require(scene.mesh.refinements + adaptive.max_divisions <= 10,
              "Mesh/Refinements = " + std::to_string(scene.mesh.refinements) +
                " and Adaptive/Largest number of divisions = " + std::to_string(adaptive.max_divisions) +
                " are more than 10 together; take fewer");
    }

    void check_explicit(const Scene &scene)
    {
      require(
        scene.effects.conduction == Effects::Conduction::reference_body ||
          (scene.effects.deformation == Effects::Deformation::explicit_dynamics &&
           scene.time.integrator == TimeSettings::Integrator::explicit_steps),
        "Effects/Conduction in = deformed body needs Deformation = explicit dynamics and Time/Integrator = "
        "explicit; choose these, or reference body");
      const bool relaxes = scene.effects.deformation == Effects::Deformation::large_equilibrium &&
                           scene.numerics.large_equilibrium == Numerics::LargeEquilibrium::relaxation;
      if (!scene.has_explicit_loop() && !relaxes)
        return;
      const bool motion = scene.effects.deformation == Effects::Deformation::explicit_dynamics;
      require(
        motion || !scene.effects.has_deformation() ||
          scene.time.integrator != TimeSettings::Integrator::explicit_steps,
        "Time/Integrator = explicit goes with Effects/Deformation = explicit dynamics or off; choose one of "
        "these, or backward Euler");
      const std::string name = motion  ? "Effects/Deformation = explicit dynamics" :
                               relaxes ? "Numerics/Large equilibrium = dynamic relaxation" :
                                         "Time/Integrator = explicit";
      require(scene.dimension == 3, name + " is for three dimensions only; set Dimension = 3");
      require(scene.numerics.degree == 1, name + " is for Numerics/Element degree = 1 only");
      require(scene.effects.coupling != Effects::Coupling::two_way,
              name + " does not know Effects/Coupling = two-way; choose expansion");
    }

    /// What points out of the plane would be lost in silence.
    void check_in_plane(const Scene &scene)
    {
      if (scene.dimension == 3)
        return;
      const auto require_zero = [](const Expression &out_of_plane, const std::string &entry) {
        require(out_of_plane.is_constant() && out_of_plane.value(Point<3>(), 0.) == 0.,
                entry + " has a component along z, out of the plane; in two dimensions it must be 0");
      };
      if (scene.effects.gravity)
        require_zero(Expression(scene.loads.gravity[2]), "Loads/Gravity");
      for (const auto &load : scene.loads.points)
        require_zero(load.force[2], "Loads/" + load.name + "/Force");
      for (const auto &tool : scene.tools)
        require_zero(tool.displacement[2], "Tools/" + tool.name + "/Displacement");
      for (const auto &boundary : scene.boundaries)
        {
          require_zero(boundary.traction[2], "Boundaries/" + boundary.name + "/Traction");
          require_zero(boundary.displacement[2], "Boundaries/" + boundary.name + "/Displacement");
        }
    }
  } // namespace

  void check(const Scene &scene)
  {
    require(!scene.tissues.empty(), "Tissues/Names is empty; name at least one tissue");
    require(!scene.initial_temperature.depends_on_time(),
            "Initial state/Temperature = " + scene.initial_temperature.text() +
              ": it cannot depend on t; it is that at t = 0");
    scene.effects.check();
    check_boundaries(scene);
    check_properties(scene);
    check_numerics(scene);
    check_finite_differences(scene);
    check_condensation(scene);
    check_explicit(scene);
    check_adaptive(scene);
    check_in_plane(scene);
    require(!scene.output.reactions || scene.effects.has_deformation(),
            "Output/Reactions = on, but there is none without deformation; switch one of both");
    for (const double time : scene.output.times)
      require(time <= scene.time.end,
              "Output/Times: " + to_text(time) + " s is after Time/End = " + to_text(scene.time.end) +
                " s; take it out or run longer");
  }
} // namespace Cautery
