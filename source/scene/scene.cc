// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cautery/scene/scene_checks.h>
#include <cautery/scene/scene_text.h>

#include <deal.II/base/utilities.h>

#include <filesystem>
#include <sstream>

namespace Cautery
{
  void DamageSettings::parameters(Parameters &p)
  {
    p.entry(
      "Quadrature",
      quadrature,
      Choices<Quadrature>{{"exponential", Quadrature::exponential}, {"end of step", Quadrature::end_of_step}},
      "How the rate of damage is integrated over a step: with a logarithm that runs straight (the critical "
      "thermal load, linear in the flux, by the trapezoidal rule), or with its value at the end (thesis Eq. "
      "6-24)");
  }

  bool Scene::has_explicit_loop() const
  {
    return effects.deformation == Effects::Deformation::explicit_dynamics ||
           time.integrator == TimeSettings::Integrator::explicit_steps;
  }

  bool Scene::thermal_properties_change() const
  {
    return std::any_of(
      tissues.begin(), tissues.end(), [](const Tissue &t) { return !t.thermally_constant(); });
  }

  bool Scene::elastic_properties_change() const
  {
    return std::any_of(
      tissues.begin(), tissues.end(), [](const Tissue &t) { return !t.elastically_constant(); });
  }

  namespace
  {
    template <typename Item>
    void named_sections(Parameters        &p,
                        const std::string &section,
                        const std::string &documentation,
                        std::vector<Item> &items)
    {
      p.section(section, [&]() {
        std::vector<std::string> names;
        for (const auto &item : items)
          names.push_back(item.name);
        p.entry("Names", names, documentation);
        for (auto &item : items)
          p.section(item.name, [&]() { item.parameters(p); });
      });
    }

    void tissue_sections(Scene &scene, Parameters &p)
    {
      named_sections(p, "Tissues", "Names of the tissues, each with a subsection", scene.tissues);
      // Presets were applied before: stating them again keeps the complete scene readable.
      p.section("Tissues", [&]() {
        for (auto &tissue : scene.tissues)
          p.section(tissue.name, [&]() {
            std::string preset = tissue_presets().front();
            p.entry(
              "Preset", preset, "Values that are the defaults here [" + join(tissue_presets(), " | ") + "]");
          });
      });
    }

    void source_sections(Scene &scene, Parameters &p)
    {
      p.section("Heat sources", [&]() {
        for (auto &source : scene.heat_sources)
          p.section(source.name, [&]() {
            std::string type =
              std::visit([](const auto &shape) { return std::string(shape.type); }, source.source);
            p.entry("Type", type, "The source's type [" + join(heat_source_types(), " | ") + "]");
          });
      });
      named_sections(
        p, "Heat sources", "Names of the heat sources, each with a subsection", scene.heat_sources);
    }

    /// The order in which a complete scene is written.
    void scene_parameters(Scene &scene, Parameters &p)
    {
      p.entry("Title", scene.title, "What the scene is about");
      p.entry("Dimension", scene.dimension, "Dimension of space; 2: plane strain", Bounds::between(2, 3));
      p.require_coordinates(scene.dimension);
      p.section("Mesh", [&]() { scene.mesh.parameters(p); });
      p.section("Effects", [&]() { scene.effects.parameters(p); });
      p.section("Initial state", [&]() {
        p.entry("Temperature",
                scene.initial_temperature,
                "K",
                "At t = 0; an expression in x, y, z",
                Bounds::non_negative());
      });
      tissue_sections(scene, p);
      source_sections(scene, p);
      named_sections(p, "Boundaries", "Names of the boundaries, each with a subsection", scene.boundaries);
      p.section("Loads", [&]() {
        p.entry("Gravity", scene.loads.gravity, "m/s2", "Acceleration, for the effect Gravity");
      });
      named_sections(p, "Loads", "Names of the point loads, each with a subsection", scene.loads.points);
      named_sections(
        p, "Tools", "Names of the tools that hold the body, each with a subsection", scene.tools);
      p.section("Time", [&]() { scene.time.parameters(p); });
      p.section("Numerics", [&]() { scene.numerics.parameters(p); });
      p.section("Damage", [&]() { scene.damage.parameters(p); });
      p.section("Output", [&]() { scene.output.parameters(p); });
      p.section("Accuracy", [&]() { scene.accuracy.parameters(p); });
      named_sections(p,
                     "Accuracy",
                     "Names of the ladders, each with a subsection where it needs one",
                     scene.accuracy.ladders);
    }

    template <typename Item>
    std::vector<Item> named(const std::vector<std::string> &names)
    {
      std::vector<Item> items(names.size());
      for (unsigned int i = 0; i < names.size(); ++i)
        items[i].name = names[i];
      return items;
    }

    /// Puts the entry in front of the reason why @p make refuses its value.
    template <typename Make>
    auto made_from(const std::string &path, const std::string &value, const Make &make)
    {
      try
        {
          return make(value);
        }
      catch (const ExcInput &exception)
        {
          AssertThrow(false, ExcInput(path + " = " + value + ": " + message_of(exception)));
          throw;
        }
    }

    /// A scene that has all named parts, with their defaults.
    Scene skeleton(const SceneText &text)
    {
      Scene scene;
      for (const auto &name : text.peek_names({"Tissues"}, "Names", "tissue"))
        {
          const std::string preset = text.peek({"Tissues", name}, "Preset", tissue_presets().front());
          scene.tissues.push_back(made_from("Tissues/" + name + "/Preset", preset, make_tissue));
          scene.tissues.back().name        = name;
          scene.tissues.back().fibre_names = text.peek_names({"Tissues", name}, "Fibre families", "");
          scene.tissues.back().fibres.resize(scene.tissues.back().fibre_names.size());
        }
      for (const auto &name : text.peek_names({"Heat sources"}, "Names", ""))
        {
          const std::string type = text.peek({"Heat sources", name}, "Type", heat_source_types().front());
          scene.heat_sources.push_back(
            {name, Schedule(), made_from("Heat sources/" + name + "/Type", type, make_heat_source)});
        }
      scene.boundaries       = named<Boundary>(text.peek_names({"Boundaries"}, "Names", "outside"));
      scene.loads.points     = named<PointLoad>(text.peek_names({"Loads"}, "Names", ""));
      scene.tools            = named<Tool>(text.peek_names({"Tools"}, "Names", ""));
      scene.accuracy.ladders = named<LadderSettings>(text.peek_names({"Accuracy"}, "Names", ""));
      return scene;
    }

    std::string resolved(const std::string &path, const std::string &scene_file)
    {
      return std::filesystem::weakly_canonical(std::filesystem::absolute(scene_file).parent_path() / path)
        .string();
    }

    std::string written(const ParameterHandler &handler, const ParameterHandler::OutputStyle style)
    {
      std::ostringstream stream;
      handler.print_parameters(stream, style);
      return stream.str();
    }

    const auto complete = static_cast<ParameterHandler::OutputStyle>(
      ParameterHandler::PRM | ParameterHandler::Short | ParameterHandler::KeepDeclarationOrder);

    /// Where the mesh and the results are makes no other run. When checkpoints are written neither, but for
    /// IDA.
    std::string identity(const Scene &scene, ParameterHandler &handler)
    {
      handler.enter_subsection("Mesh");
      handler.set("File name", std::string());
      handler.leave_subsection();
      handler.enter_subsection("Output");
      handler.set("Directory", std::string());
      handler.enter_subsection("Checkpoints");
      handler.set("Minutes", std::string("0"));
      if (scene.time.integrator != TimeSettings::Integrator::ida)
        handler.set("Steps", std::string("0"));
      handler.leave_subsection();
      handler.leave_subsection();
      return written(handler, complete);
    }
  } // namespace

  Scene read_scene(const std::string &file_name, const std::vector<Override> &overrides)
  {
    const SceneText  text(file_name, overrides);
    ParameterHandler handler;
    try
      {
        Scene      scene = skeleton(text);
        Parameters declaring(handler, Parameters::Mode::declare);
        scene_parameters(scene, declaring);
        text.parse(handler, false);

        if (const std::string mesh = handler.get({"Mesh"}, "File name"); !mesh.empty())
          {
            handler.enter_subsection("Mesh");
            handler.set("File name", resolved(mesh, file_name));
            handler.leave_subsection();
          }
        Parameters reading(handler, Parameters::Mode::read);
        scene_parameters(scene, reading);
        check(scene);
        scene.complete_text = written(handler, complete);
        scene.identity      = identity(scene, handler);
        return scene;
      }
    catch (const ExcInput &exception)
      {
        const std::string message = message_of(exception);
        const bool        named =
          message.find(file_name) == 0 || message.find("the scene") == 0 || message.find("--set") == 0;
        AssertThrow(false, ExcInput(named ? message : file_name + ": " + message));
      }
    return {};
  }

  Override parse_override(const std::string &text, const std::string &remedy)
  {
    const auto sign = text.find('=');
    AssertThrow(sign != std::string::npos && sign > 0, ExcInput(remedy));
    return {Utilities::trim(text.substr(0, sign)), Utilities::trim(text.substr(sign + 1))};
  }

  std::string parameter_reference()
  {
    Scene scene;
    scene.tissues.push_back(make_tissue(tissue_presets().front()));
    scene.tissues.back().name = "tissue";
    for (const auto &type : heat_source_types())
      scene.heat_sources.push_back({type, Schedule(), make_heat_source(type)});
    scene.boundaries       = named<Boundary>({"outside"});
    scene.loads.points     = named<PointLoad>({"pull"});
    scene.tools            = named<Tool>({"forceps"});
    scene.accuracy.ladders = named<LadderSettings>({"mesh"});

    ParameterHandler handler;
    Parameters       declaring(handler, Parameters::Mode::declare);
    scene_parameters(scene, declaring);
    return written(handler, ParameterHandler::PRM | ParameterHandler::KeepDeclarationOrder);
  }
} // namespace Cautery
