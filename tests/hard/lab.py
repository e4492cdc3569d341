# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs scenes for the hard cases and keeps a row for each statement: what was found, and the bound it must hold."""
import os
import pathlib
import shutil
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor

sys.path.insert(0, str(pathlib.Path(__file__).parent.parent / "scenes"))
from outcome import Outcome  # noqa: E402

# Open MPI refuses to start for root unless told.
for permission in ("OMPI_ALLOW_RUN_AS_ROOT", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM"):
    os.environ.setdefault(permission, "1")
SCENES = pathlib.Path(__file__).parent


class Lab:
    """Everything is written below @p folder."""

    def __init__(self, program, folder):
        self.program = str(program)
        self.folder = pathlib.Path(folder)
        self.rows = []
        self.n_runs = 0

    def run(self, scene, *changes, status=0, processes=1):
        """Runs SCENE.prm of this folder with changes `Section/Entry=value`; it must end with the status."""
        self.n_runs += 1
        out = self.folder / f"{scene}_{self.n_runs}"
        shutil.rmtree(out, ignore_errors=True)
        launcher = ["mpirun", "--oversubscribe", "-np", str(processes)] if processes > 1 else []
        answer = subprocess.run(
            [*launcher, self.program, SCENES / f"{scene}.prm", "--output", out,
             *(word for change in changes for word in ("--set", change))],
            cwd=self.folder, capture_output=True, text=True, check=False)
        if answer.returncode != status:
            raise AssertionError(f"{scene} with {changes}: exit status {answer.returncode} instead of {status}\n"
                                 f"{answer.stderr or answer.stdout}")
        complaint = answer.stderr.strip().replace(f"{SCENES}/", "")
        return Ended(out, complaint) if status != 2 else complaint

    def run_all(self, runs):
        """Of each key the run with the arguments beside it, two at a time."""
        with ThreadPoolExecutor(2) as pool:
            futures = {key: pool.submit(self.run, *arguments) for key, arguments in runs.items()}
        failures = [str(future.exception()) for future in futures.values() if future.exception()]
        assert not failures, "\n".join(failures)
        return {key: future.result() for key, future in futures.items()}

    def below(self, what, measured, bound):
        self.keep(what, f"at most {bound:.3g}", f"{measured:.2g}", measured <= bound)

    def above(self, what, measured, bound):
        self.keep(what, f"more than {bound:.3g}", f"{measured:.3g}", measured > bound)

    def says(self, what, complaint, *texts):
        """A run that ends early says all of @p texts."""
        said = complaint.removeprefix("cautery: ")
        self.keep(what, "ends with " + ", ".join(f"`{text}`" for text in texts), said,
                  all(text in complaint for text in texts))

    def keep(self, what, bound, measured, holds):
        self.rows.append((what, bound, measured, holds))
        print(f"  {'right' if holds else 'WRONG'}  {what}: {measured}, {bound}", flush=True)

    def wrong(self):
        return sum(not holds for *_, holds in self.rows)

    def table(self):
        lines = ["| what | bound | measured |", "|---|---|---|"]
        return "\n".join(lines + [f"| {what} | {bound} | {measured} |" for what, bound, measured, _ in self.rows])


class Ended(Outcome):
    """What a run left, also one that failed; and its complaint."""

    def __init__(self, folder, complaint):
        super().__init__(folder)
        self.folder, self.complaint = folder, complaint
        assert (self.summary["status"] == "failed") == bool(self.summary["message"]), self.summary

    def history(self, probe, column):
        return [row[column] for row in self.rows if row["probe"] == probe]

    def end(self, probe, column):
        return self.history(probe, column)[-1]

    def last_time(self):
        return self.rows[-1]["time_s"]

    def coldest(self):
        return self.summary["extremes"]["temperature_min_K"]

    def hottest(self):
        return self.summary["extremes"]["temperature_max_K"]

    def open_books(self):
        return self.summary["balance"]["relative_error"]

    def iterations(self, of):
        return self.summary["statistics"][f"linear_iterations_{of}"]
