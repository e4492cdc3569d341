# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a run has left in its folder."""
import csv
import json
import math
import pathlib
import re

import prm


class Outcome:
    """settings: complete, by path; rows: of probes.csv, with numbers; reactions: forces (N) by time and support; arrays: names in each .vtu file; log: text."""

    def __init__(self, folder):
        folder = pathlib.Path(folder)
        self.settings = prm.values((folder / "scene.prm").read_text())
        self.summary = json.loads((folder / "summary.json").read_text())
        self.log = (folder / "log.txt").read_text()
        with open(folder / "probes.csv", newline="") as file:
            reader = csv.DictReader(file)
            self.rows = [{column: text if column == "probe" else float(text) for column, text in row.items()}
                         for row in reader]
            self.columns = reader.fieldnames
        self.reactions = {}
        if self["Output/Reactions"] == "on":
            with open(folder / "reactions.csv", newline="") as file:
                for row in csv.DictReader(file):
                    self.reactions[float(row["time_s"]), row["support"]] = [float(row[f"force_{c}_N"]) for c in "xyz"]
        self.arrays = [set(re.findall(r'<DataArray [^>]*Name="([^"]*)"', file.read_text(errors="replace")))
                       - {"connectivity", "offsets", "types"} for file in sorted(folder.glob("*.vtu"))]

    def __getitem__(self, path):
        """A setting as a number where it is one."""
        try:
            return float(self.settings[path])
        except ValueError:
            return self.settings[path]

    def is_on(self, effect):
        return self.settings["Effects/" + effect] != "off"

    def at(self, time, probe):
        return next(row for row in self.rows if row["probe"] == probe and math.isclose(row["time_s"], time))
