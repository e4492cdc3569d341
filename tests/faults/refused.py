# SPDX-License-Identifier: LGPL-2.1-or-later
"""What cannot be resumed is refused with exit status 2 and a reason, and everything stays as it was.
Usage: refused.py CAUTERY PROJECT"""
import pathlib
import shutil
import sys
import tempfile

import cases
from faults import Program, interrupt

SCENE = cases.words("heat")
ON_A_MESH = """
subsection Mesh
  set Shape     = file
  set File name = body.msh
end
subsection Heat sources
  set Names = field
  subsection field
    set Type   = Gaussian
    set Centre = 0.0993, 0.0782, 0.067
    set Radius = 0.02
    set Power  = 20
  end
end
subsection Boundaries
  subsection outside
    set Thermal = insulated
  end
end
subsection Time
  set End = 200
end
subsection Output
  set Every step   = on
  set Probe names  = middle
  set Probe places = 0.0993, 0.0782, 0.067
end
"""


def crc_64(data):
    """Of ECMA-182, as the file's first line states it (reflected, all bits turned before and after)."""
    table = []
    for i in range(256):
        for _ in range(8):
            i = i >> 1 ^ (0xC96C5795D7870F42 if i & 1 else 0)
        table.append(i)
    value = 2**64 - 1
    for byte in data:
        value = value >> 8 ^ table[(value ^ byte) & 255]
    return f"{value ^ (2**64 - 1):016x}".encode()


def of_version(file, version):
    """The checkpoint as another version would have written it."""
    data = file.read_bytes()
    image = data[512:]
    assert crc_64(image) in data[:512], "the first line does not state the CRC-64"
    assert image.count(b"0.1.0") == 1
    other = image.replace(b"0.1.0", version)
    file.write_bytes(data[:512].replace(crc_64(image), crc_64(other)) + other)


def cut(file, share):
    file.write_bytes(file.read_bytes()[:int(share * file.stat().st_size)])


def flip(file, share):
    data = bytearray(file.read_bytes())
    data[int(share * len(data))] ^= 1
    file.write_bytes(data)


def content(folder):
    return {file.name: file.read_bytes() for file in folder.iterdir()}


class Refusals:
    def __init__(self, program, words, out):
        self.program, self.words, self.out = program, words, program.out(out)
        process = program.start(words, out)
        _, complaint = interrupt(process, 30)
        assert process.returncode == 1 and "--resume" in complaint, complaint

    def expect(self, message, harm, *more, words=None):
        """Refused with the message, after `harm` has been done to a copy of the results."""
        copy = self.program.out("copy")
        shutil.rmtree(copy, ignore_errors=True)
        shutil.copytree(self.out, copy)
        harm(copy)
        before = content(copy)
        said = self.program.run(words or self.words, "copy", "--resume", *more, status=2)
        assert message in said, f"`{message}` is not in\n{said}"
        assert content(copy) == before, f"something has changed: {message}"
        print(said[said.rindex("cautery:"):].strip().replace(str(self.program.folder), ""))

    def accept(self, *more):
        self.program.run(self.words, self.out.name, "--resume", *more)


def main(cautery, project):
    with tempfile.TemporaryDirectory() as folder:
        program = Program(folder, cautery)
        runs = Refusals(program, SCENE, "out")
        checkpoint = "checkpoint.h5"
        runs.expect("there is no copy/checkpoint.h5 to resume from", lambda out: (out / checkpoint).unlink())
        for share in (0., 0.0005, 0.01, 0.5, 0.999):
            runs.expect("is no checkpoint" if share < 0.0005 else "is damaged or cut short",
                        lambda out, share=share: cut(out / checkpoint, share))
        for share in (0.01, 0.3, 0.9999):
            runs.expect("is damaged or cut short", lambda out, share=share: flip(out / checkpoint, share))
        runs.expect("is no checkpoint", lambda out: shutil.copy(out / "scene.prm", out / checkpoint))
        runs.expect("belongs to another scene: it had `set Step                    = 0.2` where now is `set Step"
                    "                    = 0.1`", lambda out: None, "--set", "Time/Step=0.1")
        runs.expect("belongs to another scene", lambda out: None, "--set", "Output/Probe names=tip, beside")
        runs.expect("was written by cautery 0.0.9, and this is cautery 0.1.0",
                    lambda out: of_version(out / checkpoint, b"0.0.9"))
        runs.expect("copy/probes.csv has lost its end", lambda out: cut(out / "probes.csv", 0.5))
        runs.expect("cannot go on with copy/probes.csv: No such file", lambda out: (out / "probes.csv").unlink())
        program.run(["check", *SCENE], "out", "--resume", status=2)
        runs.accept("--set", "Output/Checkpoints/Steps=7", "--set", "Output/Checkpoints/Minutes=1")

        mesh = program.folder / "body.msh"
        shutil.copy(project / "meshes" / "liver.msh", mesh)
        (program.folder / "on_a_mesh.prm").write_text(ON_A_MESH)
        runs = Refusals(program, ["on_a_mesh.prm"], "liver")
        text = mesh.read_text()
        mesh.write_text(text.rstrip() + " \n\n")
        runs.expect("body.msh is not what it was when copy/checkpoint.h5 was written", lambda out: None)
        mesh.unlink()
        runs.expect("body.msh", lambda out: None)
        mesh = program.folder / "same.msh"  # content counts, not the name
        mesh.write_text(text)
        runs.accept("--set", "Mesh/File name=same.msh")


if __name__ == "__main__":
    main(str(pathlib.Path(sys.argv[1]).resolve()), pathlib.Path(sys.argv[2]))
