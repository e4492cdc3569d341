# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a run of a scene left, for the tests of this folder."""
import csv
import json


class Run:
    def __init__(self, directory):
        with open(directory / "probes.csv", newline="") as file:
            self.rows = {(float(row["time_s"]), row["probe"]): row for row in csv.DictReader(file)}
        self.summary = json.loads((directory / "summary.json").read_text())

    def value(self, time, probe, column):
        return float(self.rows[(time, probe)][column])

    def history(self, probe, column):
        return [float(row[column]) for (_, name), row in sorted(self.rows.items()) if name == probe]


def radius_of_death(run, time):
    """Where ln(Omega) = 0 on the axis y = z = 5 mm, from the centre (mm); the probes P1 to P6 stand 1 mm apart."""
    values = [run.value(time, f"P{i}", "ln_damage") for i in range(1, 7)]
    for i, (inner, outer) in enumerate(zip(values, values[1:])):
        if inner >= 0 > outer:
            return i + inner / (inner - outer)
    return 0.0
