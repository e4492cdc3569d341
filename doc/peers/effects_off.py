# SPDX-License-Identifier: LGPL-2.1-or-later
"""An effect that is off costs nothing: a scene that writes down everything but has it off, against one that never mentions it.
Instructions by callgrind, peak memory by the run itself; for implicit steps and for the explicit loop.
What a process does before it reads a scene, which is to load libraries, is left out of the counts.

Usage, from the project's root: python3 doc/peers/effects_off.py (valgrind is needed; some minutes)
"""
import json
import pathlib
import re
import subprocess
import tempfile

PLAIN = """
subsection Mesh
  set Subdivisions = {cells}
end
subsection Effects
  set Heat = {heat}
  {effects}
end
{rest}
subsection Time
  set End  = {end}
  set Step = {step}
  {integrator}
end
subsection Output
  set Fields = off
end
"""
BOUNDARY = """
subsection Boundaries
  subsection outside
    set Thermal = temperature
    {mechanical}
  end
end
"""
SOURCE = """
subsection Heat sources
  set Names = needle
  subsection needle
    set Type   = uniform
    set Power  = 0.1
  end
end
"""
ALL_OFF = """
  set Perfusion                        = off
  set Perfusion stops in dead tissue   = off
  set Metabolism                       = off
  set Deformation                      = {deformation}
  set Coupling                         = off
  set Gravity                          = off
  set Temperature-dependent properties = off
  set Damage                           = off
"""
EVERYTHING = """
subsection Tissues
  set Names = tissue
  subsection tissue
    set Perfusion rate = 0.7
    set Relaxation time = 16
    set Young's modulus = 1e7
    set Thermal expansion coefficient = 2e-4
    set Metabolic heat = 4e4
    subsection Arrhenius damage
      set Constants = liver
    end
  end
end
subsection Loads
  set Gravity = 0, 0, -9
  set Names   = pull
  subsection pull
    set Place = 0.005, 0.005, 0.005
    set Force = {force}
  end
end
subsection Damage
  set Quadrature = end of step
end
"""
CASES = {
    "implicit, heat alone": dict(cells=8, heat="Fourier", end=200, step=1, integrator="", deformation="off", force="1; 0; 0",
                                 mechanical="set Mechanical = fixed"),
    "explicit dynamics alone": dict(cells=8, heat="off", end=0.02, step=0.01, integrator="", deformation="explicit dynamics",
                                    force="0; 0; 0", mechanical="set Mechanical = fixed"),
}


def scenes(case):
    plain = "" if case["deformation"] == "off" else f"set Deformation = {case['deformation']}"
    source = "" if case["heat"] == "off" else SOURCE
    yield PLAIN.format(**case, effects=plain, rest=source + BOUNDARY.format(**case))
    yield PLAIN.format(**case, effects=ALL_OFF.format(**case), rest=source + EVERYTHING.format(**case) + BOUNDARY.format(**case))


def instructions(scene, folder):
    done = subprocess.run(["valgrind", "--tool=callgrind", f"--callgrind-out-file={folder}/callgrind.out", "build/cautery", scene,
                           "--output", f"{folder}/out"], check=True, capture_output=True, text=True)
    return int(re.search(r"Collected : (\d+)", done.stderr).group(1))


def start():
    """What a process does before it reads a scene."""
    done = subprocess.run(["valgrind", "--tool=callgrind", "--callgrind-out-file=/dev/null", "build/cautery", "--version"],
                          check=True, capture_output=True, text=True)
    return int(re.search(r"Collected : (\d+)", done.stderr).group(1))


def peak(scene, folder):
    subprocess.run(["build/cautery", scene, "--output", f"{folder}/out"], check=True, stdout=subprocess.DEVNULL)
    return json.loads(pathlib.Path(folder, "out", "summary.json").read_text())["cost"]["peak_memory_bytes"]


def main():
    print("| case | instructions, never mentioned | all written, off | ratio | peak memory ratio |\n|---|---|---|---|---|")
    common = start()
    for name, case in CASES.items():
        with tempfile.TemporaryDirectory() as folder:
            counts, peaks = [], []
            for text in scenes(case):
                scene = pathlib.Path(folder, "scene.prm")
                scene.write_text(text)
                counts.append(instructions(scene, folder))
                peaks.append(peak(scene, folder))
        plain, written = (count - common for count in counts)
        print(f"| {name} | {plain:.4g} | {written:.4g} | {written / plain:.4f} | {peaks[1] / peaks[0]:.4f} |", flush=True)


if __name__ == "__main__":
    main()
