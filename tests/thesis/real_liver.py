# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs the main job on a human liver that is given beside the project; skipped (77) where it is not.

Usage: real_liver.py CAUTERY SCENE OUTPUT_DIRECTORY
"""
import json
import pathlib
import subprocess
import sys

cautery, scene, output = sys.argv[1], pathlib.Path(sys.argv[2]).resolve(), pathlib.Path(sys.argv[3])
mesh = scene.parents[2] / "shared" / "meshes" / "liver.msh"
if not mesh.exists():
    print(f"skipped: the liver's mesh {mesh.name} is not beside the project (../shared/meshes)")
    sys.exit(77)

subprocess.run([cautery, scene, "--output", output], check=True)
summary = json.loads((output / "summary.json").read_text())
print(json.dumps(summary["ablation"], indent=2))
assert summary["status"] == "done"
assert summary["unknowns"]["temperature"] == 935
assert summary["balance"]["relative_error"] < 1e-8
heated = next(r for r in summary["ablation"]["regions"].values() if r["name"] == "heated")
rest = next(r for r in summary["ablation"]["regions"].values() if r["name"] == "liver")
assert heated["fraction"] > 0.5, "the heated region dies"
assert 0 < rest["fraction"] < 0.05, "and little besides"
assert 310 < summary["extremes"]["temperature_max_K"] < 400
assert 1e-5 < summary["extremes"]["displacement_max_m"] < 2e-3
