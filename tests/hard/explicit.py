# SPDX-License-Identifier: LGPL-2.1-or-later
"""Case 6: explicit steps with fibres that stiffen by 1e6, strong compression, snap-through, tools that turn cells inside
out, steps at and beyond the bound, and a million of them."""
import bodies  # noqa: F401  (its folder's helpers)
import closed_forms
import make_meshes

DYNAMICS = ["Effects/Deformation=explicit dynamics", "Numerics/Explicit/Damping=100"]
FIBRES = ["Tissues/tissue/Fibre families=collagen", "Tissues/tissue/collagen/Fibre stiffness=1000",
          "Tissues/tissue/collagen/Fibre stiffening=1", "Tissues/tissue/collagen/Fibre direction=1; 0; 0"]
SINGLE = "Numerics/Explicit/Precision=single"


def affine(along, across, end):
    """All of the surface moves so that the whole body is stretched by these within 20 ms."""
    way = "; ".join(f"({stretch} - 1) * {axis} * min(t / 0.02, 1)" for axis, stretch in zip("xyz", (along, across, across)))
    return [change for side in ("moved", "held", "rest")
            for change in (f"Boundaries/{side}/Mechanical=displacement", f"Boundaries/{side}/Displacement={way}")] + [
                "Mesh/Subdivisions=3", "Output/Probe places=0.0031, 0.0052, 0.0073; 0.01, 0.01, 0.01", f"Time/End={end}",
                "Time/Step=0.01", "Output/Interval=0", "Numerics/Explicit/Damping=2000"]


def stretches(lab):
    cases = {"fibres at I4 = 4, exp(9)": (2.0, 0.7, FIBRES, (1000.0, 1.0), 0.03),
             "pressed to 20 %": (0.2, 1.5, [], (0.0, 1.0), 0.2)}
    cells = {"tetrahedra": ["Mesh/Cells=tetrahedra"], "hexahedra": [],
             "hexahedra of one point": ["Numerics/Explicit/Points of hexahedra=1"]}
    runs = {}
    for name, (along, across, choice, _, end) in cases.items():
        for kind, mesh in cells.items():
            runs[name, kind, "double"] = ("block", *DYNAMICS, *affine(along, across, end), *choice, *mesh)
        runs[name, "tetrahedra", "single"] = (*runs[name, "tetrahedra", "double"], SINGLE)
    found = lab.run_all(runs)
    for name, (along, across, _, fibres, _) in cases.items():
        exact = closed_forms.cauchy(along, across, fibres)
        error = lambda run: abs(run.end("middle", "stress_xx_Pa") / exact - 1)
        lab.below(f"{name}, explicit, three kinds of cells: stress at rest against the closed form ({exact:.3g} Pa), relative",
                  max(error(found[name, kind, "double"]) for kind in cells), 1e-6)
        lab.below(f"{name}, single precision: the same", error(found[name, "tetrahedra", "single"]), 1e-3)


def arch(lab):
    """A shallow arch between two walls, pressed from above beyond its limit: 40 mm wide, 4 mm high, 1 mm thick."""
    rise = lambda p: (p[0], p[1] + 4 * 4 * p[0] * (40 - p[0]) / 40**2, p[2])
    surfaces = {(0, 0): 10, (0, 1): 11, (1, 1): 12}
    mesh = make_meshes.box((24, 2, 1), (40, 1, 2), lambda k: 1, lambda d, end: surfaces.get((d, end), 0),
                           [(3, 1, "arch"), (2, 10, "left"), (2, 11, "right"), (2, 12, "top")], rise)
    (lab.folder / "arch.msh").write_text(mesh)
    return ["Mesh/Shape=file", f"Mesh/File name={lab.folder / 'arch.msh'}", "Mesh/Length unit=mm",
            "Boundaries/held/Surfaces=left, right", "Boundaries/held/Mechanical=fixed",
            "Boundaries/moved/Surfaces=top", "Boundaries/moved/Mechanical=traction",
            "Output/Probe places=0.02, 0.0045, 0.001; 0.01, 0.0035, 0.001"]


def snap(lab):
    load = "Boundaries/moved/Traction=0; -30 * min(t, 1); 0"
    down = lab.run("block", *DYNAMICS, "Numerics/Explicit/Damping=30", *arch(lab), load, "Time/End=2")
    history = down.history("middle", "displacement_y_m")
    lab.above("snap-through of an arch of 4 mm: way down, mm", -1e3 * history[-1], 6.0)
    steps = [abs(b - a) for a, b in zip(history, history[1:])]
    lab.above("the same: largest way in 0.1 s over the mean", max(steps) / (abs(history[-1]) / len(steps)), 3.0)
    lab.below("the same: way in the last 0.1 s, of all", steps[-1] / abs(history[-1]), 1e-3)


def inversion(lab):
    pushed = [*DYNAMICS, "Tools/Names=forceps", "Tools/forceps/Centre=0.005, 0.005, 0.005",
              "Tools/forceps/Displacement=0.02 * t; 0; 0", "Time/Step=0.02",
              *(f"Boundaries/{side}/Mechanical=fixed" for side in ("moved", "held", "rest"))]
    for cells in ("tetrahedra", "hexahedra"):
        run = lab.run("block", *pushed, f"Mesh/Cells={cells}", status=1)
        lab.says(f"a tool pushed through {cells}", run.complaint, "at t = 0.", "cell", " m is ", "load the body more slowly")
        lab.keep("the same: last good state on disk", "within a step of the end", f"t = {run.last_time():g} s",
                 0.1 < run.last_time() < 0.9 and run.summary["end_time_s"] == run.last_time())


def bound(lab):
    """A block that gravity sets swinging."""
    swing = ["Effects/Deformation=explicit dynamics", "Effects/Gravity=on", "Loads/Gravity=10, 0, 0", "Mesh/Subdivisions=4",
             "Boundaries/moved/Mechanical=free", "Time/End=5", "Time/Step=0.05", "Tissues/tissue/Young's modulus=30000"]
    first = lab.run("block", *swing, "Numerics/Explicit/Safety factor=1", "Time/End=0.05")
    longest = first.summary["statistics"]["stable_motion_step_s"]
    given = lambda factor: f"Numerics/Explicit/Motion step={factor * longest:.12g}"
    near = lab.run("block", *swing, given(0.99))
    half = lab.run("block", *swing, given(0.5))
    lab.below(f"{near.summary['statistics']['motion_steps']:.0f} steps at 0.99 of the bound: largest displacement over "
              "that at 0.5 of it",
              near.summary["extremes"]["displacement_max_m"] / half.summary["extremes"]["displacement_max_m"], 1.02)
    refused = lab.run("block", *swing, given(1.5), status=2)
    lab.says("a step at 1.5 of the bound", refused, "is longer than", "known to be stable at t = 0 s", "Unstable steps = on")
    for law in ("neo-Hookean", "linear"):
        run = lab.run("block", *swing, given(1.5), "Numerics/Explicit/Unstable steps=on", "Time/Step=0.001",
                      f"Tissues/tissue/Elastic law={law}", status=1)
        lab.says(f"the same, forced, {law}", run.complaint, "t = ", " m", "Safety factor")
        lab.keep("the same: last good state on disk", "finite, after the start", f"t = {run.last_time():g} s",
                 run.last_time() > 0 and all(abs(row["displacement_x_m"]) < 1 for row in run.rows))


def million(lab):
    hanging = [*DYNAMICS, "Effects/Gravity=on", "Loads/Gravity=10, 0, 0", "Mesh/Subdivisions=1",
               "Boundaries/moved/Mechanical=free",
               "Output/Interval=0", "Output/Probe places=0.01, 0.01, 0.01; 0.01, 0.01, 0.01", "Time/Step=10"]
    step = lab.run("block", *hanging, "Time/End=10").summary["statistics"]["stable_motion_step_s"]
    end = 10 * round(1e5 * step) * 1.05
    runs = {name: ("block", *hanging, f"Time/End={end:g}", f"Output/Times={end / 10:g}", *choice)
            for name, choice in (("double", []), ("single", [SINGLE]))}
    for (name, run), limit in zip(lab.run_all(runs).items(), (1e-12, 1e-5)):
        start, last = run.history("middle", "displacement_x_m")[-2:]
        lab.above(f"rest under gravity, {name}: steps", run.summary["statistics"]["motion_steps"], 1e6)
        lab.below(f"the same: drift in nine tenths of them, relative to {last:.3g} m", abs(last / start - 1), limit)


def check(lab):
    stretches(lab)
    snap(lab)
    inversion(lab)
    bound(lab)
    million(lab)
