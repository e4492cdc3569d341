// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cautery/space/assignment.h>

#include <algorithm>

namespace Cautery
{
  namespace
  {
    const std::vector<std::string> remaining = {"remaining"};

    std::string id_text(const unsigned int id, const std::string &name)
    {
      return std::to_string(id) + (name.empty() ? "" : " `" + name + "`");
    }

    /**
     * Gives every id of the mesh one of the @p items, of which each names its ids by texts; `remaining`
     * stands for what no other item names.
     */
    template <typename Item, typename Id, typename ToIds>
    std::map<Id, unsigned int> assign(const std::vector<Item> &items,
                                      std::vector<std::string> Item::*const texts,
                                      const std::map<Id, std::string>      &names,
                                      const ToIds                          &to_ids,
                                      const std::string                    &section,
                                      const std::string                    &entry,
                                      const std::string                    &kind)
    {
      std::map<Id, unsigned int> assigned;
      const auto                 give = [&](const Id id, const unsigned int i) {
        const auto [place, is_new] = assigned.emplace(id, i);
        AssertThrow(is_new,
                    ExcInput(section + ": " + kind + " " + id_text(id, names.at(id)) + " belongs to both " +
                             items[place->second].name + " and " + items[i].name +
                             "; name it once (`remaining` means what no other names)"));
      };
      for (unsigned int i = 0; i < items.size(); ++i)
        if (items[i].*texts != remaining)
          for (const Id id : to_ids(items[i].*texts, section + "/" + items[i].name + "/" + entry))
            give(id, i);
      for (unsigned int i = 0; i < items.size(); ++i)
        if (items[i].*texts == remaining)
          for (const auto &[id, name] : names)
            if (assigned.count(id) == 0 || items[assigned.at(id)].*texts == remaining)
              give(id, i);
      for (const auto &[id, name] : names)
        AssertThrow(assigned.count(id) == 1,
                    ExcInput(section + ": nothing is said of " + kind + " " + id_text(id, name) +
                             " of the mesh; name it, or use `remaining`"));
      for (unsigned int i = 0; i < items.size(); ++i)
        AssertThrow(
          std::any_of(assigned.begin(), assigned.end(), [i](const auto &pair) { return pair.second == i; }),
          ExcInput(section + "/" + items[i].name + "/" + entry + " = " + join(items[i].*texts) + ": no " +
                   kind + " of the mesh is left for it; name one, or take " + items[i].name + " out of " +
                   section + "/Names"));
      return assigned;
    }
  } // namespace

  template <int dim>
  TissueMap<dim>::TissueMap(const Mesh<dim> &mesh, const std::vector<Tissue> &tissues)
    : tissues(tissues)
    , of_region(assign(
        tissues,
        &Tissue::regions,
        mesh.regions(),
        [&mesh](const auto &texts, const std::string &parameter) {
          return mesh.region_ids(texts, parameter);
        },
        "Tissues",
        "Regions",
        "region"))
  {
  }

  template <int dim>
  BoundaryMap<dim>::BoundaryMap(const Mesh<dim> &mesh, const std::vector<Boundary> &boundaries)
    : boundaries(boundaries)
    , of_surface(assign(
        boundaries,
        &Boundary::surfaces,
        mesh.surfaces(),
        [&mesh](const auto &texts, const std::string &parameter) {
          return mesh.surface_ids(texts, parameter);
        },
        "Boundaries",
        "Surfaces",
        "surface"))
  {
  }

  template <int dim>
  std::set<types::boundary_id> BoundaryMap<dim>::surfaces(const unsigned int index) const
  {
    std::set<types::boundary_id> ids;
    for (const auto &[id, boundary] : of_surface)
      if (boundary == index)
        ids.insert(id);
    return ids;
  }

  template class TissueMap<2>;
  template class TissueMap<3>;
  template class BoundaryMap<2>;
  template class BoundaryMap<3>;
} // namespace Cautery
