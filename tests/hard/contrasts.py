# SPDX-License-Identifier: LGPL-2.1-or-later
"""Case 4: strong perfusion, conductivities that jump by 1e4, slivers, cells of 1 um beside cells of 10 mm."""
import bodies

K, CELLS, LENGTH = 0.613, 20, 0.01
PERFUSION = (0.0, 1.0, 1e3, 1e6)  # W/(m3 K)
NODES = (2, 10, 18)               # of the slab, where probes stand
RISE = 35.0                       # K, of the linear temperature over the cube


def fin(w):
    """Temperatures over the blood's at the nodes of the slab, whose ends have 0 and 40 K: the difference equation."""
    h = LENGTH / CELLS
    middle = 2 + w * h * h / K
    upper = [0.0]  # T_i = upper_i T_(i+1)
    for _ in range(1, CELLS):
        upper.append(1 / (middle - upper[-1]))
    values = [40.0]
    for i in range(CELLS - 1, -1, -1):
        values.insert(0, upper[i] * values[0])
    return values


def perfusion(lab):
    places = "; ".join(f"{LENGTH * node / CELLS}, 0.0005" for node in NODES)
    runs = {w: ("slab", "Effects/Heat=Fourier", "Effects/Perfusion=on", f"Tissues/tissue/Perfusion rate={w / 3600}",
                "Initial state/Temperature=330", "Boundaries/ends/Temperature=310 + 40 * x / 0.01", "Time/Step=1e7",
                "Time/End=1e8", "Output/Probe names=a, b, c", f"Output/Probe places={places}") for w in PERFUSION}
    found = lab.run_all(runs)
    lab.below("slab between 310 and 350 K, perfusion 0, 1, 1e3 and 1e6 W/(m3 K): against the difference equation, K",
              max(abs(found[w].end(probe, "temperature_K") - 310 - fin(w)[node])
                  for w in PERFUSION for probe, node in zip("abc", NODES)), 1e-7)
    lab.below("the same: below 310 or above 350 K by, of the range",
              max(max(310 - found[w].coldest(), found[w].hottest() - 350, 0) / 40 for w in PERFUSION), 1e-8)


def errors(run, temperature, scale):
    """Largest errors at the probes, of the range: temperature, displacement."""
    heat, motion = 0.0, 0.0
    places = [tuple(map(float, place.split(","))) for place in run.settings["Output/Probe places"].split(";")]
    for probe, (x, y, z) in zip(run.settings["Output/Probe names"].split(", "), places):
        heat = max(heat, abs(run.end(probe, "temperature_K") - temperature(x, y, z)) / scale)
        exact = (0.01 * x + 0.02 * y, 0.03 * z, -0.02 * x + 0.01 * z)
        motion = max(motion, *(abs(run.end(probe, f"displacement_{c}_m") - value) / 3e-4 for c, value in zip("xyz", exact)))
    return heat, motion


def shapes(lab):
    """Whatever the shape of cells, a linear temperature and displacement are reproduced."""
    linear = lambda x, y, z: 310 + 1000 * x + 2000 * y - 500 * z
    stepped = lambda x, y, z: 310 + (4000 * (x + 0.012) if x < 0 else 48 + 0.4 * x)
    runs = {}
    for flatness in (1.0, 1e-1, 1e-2, 1e-3):
        mesh, moved = bodies.slivers(flatness)
        name = lab.folder / f"slivers_{flatness}.msh"
        name.write_text(mesh)
        runs[flatness] = ("contrasts", "Mesh/Shape=file", f"Mesh/File name={name}", "Effects/Deformation=equilibrium",
                          f"Output/Probe names={', '.join('p' + str(i) for i in range(len(moved)))}",
                          "Output/Probe places=" + "; ".join(", ".join(f"{x:.15g}" for x in place) for place in moved))
    for cells in ("tetrahedra", "hexahedra"):
        name = lab.folder / f"graded_{cells}.msh"
        name.write_text(bodies.graded(cells == "tetrahedra"))
        runs[cells] = ("contrasts", "Mesh/Shape=file", f"Mesh/File name={name}", "Effects/Deformation=equilibrium",
                       "Tissues/Names=bad, good", "Tissues/bad/Regions=1", "Tissues/good/Regions=2",
                       "Tissues/bad/Conductivity=0.1", "Tissues/good/Conductivity=1000",
                       "Boundaries/outside/Temperature=310 + if(x < 0, 4000 * (x + 0.012), 48 + 0.4 * x)",
                       "Output/Probe places=-0.000001, 0.005, 0.005; 0, 0.005, 0.005; 0.0011, 0.005, 0.005")
    found = lab.run_all(runs)
    for flatness in (1.0, 1e-1, 1e-2, 1e-3):
        heat, motion = errors(found[flatness], linear, RISE)
        what = f"slivers of {flatness:g} of their height"
        lab.below(f"{what}: error of a linear temperature and displacement, relative", max(heat, motion), 1e-8)
        lab.keep(f"{what}: iterations for heat in {found[flatness].summary['time_steps']} steps, for displacement",
                 "at most 2000 each", f"{found[flatness].iterations('heat'):.0f}, {found[flatness].iterations('deformation'):.0f}",
                 max(found[flatness].iterations("heat"), found[flatness].iterations("deformation")) <= 2000)
    for cells in ("tetrahedra", "hexahedra"):
        heat, motion = errors(found[cells], stepped, 48)
        what = f"{cells} from 1 um to 10 mm, conductivity jumping by 1e4"
        lab.below(f"{what}: error of the kinked temperature and linear displacement, relative", max(heat, motion), 1e-7)
        lab.keep(f"{what}: iterations for heat, for displacement", "at most 2000 each",
                 f"{found[cells].iterations('heat'):.0f}, {found[cells].iterations('deformation'):.0f}",
                 max(found[cells].iterations("heat"), found[cells].iterations("deformation")) <= 2000)


def check(lab):
    perfusion(lab)
    shapes(lab)
