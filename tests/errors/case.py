# SPDX-License-Identifier: LGPL-2.1-or-later
"""A case of bad input: a small good scene, what is changed in it, and what must be said of that."""
import dataclasses

SCENE = """
subsection Mesh
  set Cells        = hexahedra
  set Subdivisions = 2
end
subsection Heat sources
  set Names = needle
  subsection needle
    set Places = 0.005, 0.005, 0.005
    set Power  = 0.1
  end
end
subsection Boundaries
  subsection outside
    set Thermal    = insulated
    set Mechanical = fixed
  end
end
subsection Time
  set End  = 2
  set Step = 1
end
subsection Output
  set Fields       = off
  set Probe names  = tip
  set Probe places = 0.005, 0.005, 0.005
end
"""

DEFORMATION = ["Effects/Deformation=equilibrium"]


@dataclasses.dataclass
class Case:
    name: str
    message: str                                        # all that is said, `<any>` for what depends on the machine
    overrides: list = dataclasses.field(default_factory=list)
    text: str = SCENE                                   # of scene.prm
    files: dict = dataclasses.field(default_factory=dict)
    command: list = None                                # in place of scene, output and overrides
    status: int = 2
    check_too: bool = False                             # ask `cautery check` as well: for what shows with the mesh
    last_good: float = None                             # s; the time that a run which fails on its way has reached
    says: list = ()                                     # texts that a good run prints

    def words(self):
        if self.command is not None:
            return self.command
        return ["scene.prm", "--output", "out"] + [word for text in self.overrides for word in ("--set", text)]


def write_files(folder, case):
    (folder / "scene.prm").write_text(case.text)
    for name, text in case.files.items():
        (folder / name).write_text(text)


def value(entry, text, reason):
    """A value that its parameter refuses by itself, when the scene is read."""
    return Case(f"{entry} = {text}", f"scene.prm: {entry} = {text}: {reason}", [f"{entry}={text}"])


def mesh(name, expected, text, overrides=(), scene=SCENE, check_too=True, **options):
    """A scene on the mesh file body.msh."""
    return Case(name, expected, ["Mesh/Shape=file", "Mesh/File name=body.msh", *overrides], scene,
                files={} if text is None else {"body.msh": text}, check_too=check_too, **options)


def rollers(surfaces):
    """Rollers on some sides of the box; the others are free."""
    return ["Boundaries/Names=outside, rest", f"Boundaries/outside/Surfaces={surfaces}",
            "Boundaries/outside/Mechanical=roller", "Boundaries/rest/Surfaces=remaining",
            "Boundaries/rest/Thermal=insulated", "Boundaries/rest/Mechanical=free"]


TISSUE = "Tissues/tissue"
NEEDLE = "Heat sources/needle"
EXPRESSION = "this is neither a number nor an expression in x,y,z,t with muParser's functions (sin, exp, if, ...): "
TABLE = "a table is written `temperature: value, temperature: value, ...`"
PLACE = "a place has three coordinates, x, y, z"
ALTERNATE = "the times must alternate: on, off, on, off, ..."
