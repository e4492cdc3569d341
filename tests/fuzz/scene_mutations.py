# SPDX-License-Identifier: LGPL-2.1-or-later
"""Mutates scenes: knows lines, sections and entries of a .prm file, and what values there may be."""
import re

NUMBERS = ["0", "-0", "-1", "1", "2", "3", "0.5", "1e-3", "1e3", "-1e3", "1e12", "1e300", "-1e300", "1e-300", "5e-324", "1e999",
           "4294967296", "18446744073709551616", "-2147483649", "nan", "NaN", "inf", "-inf", "infinity", "0x10", "1,5", "1e",
           "+1", "--1", "1 2", "1e5000", "\u2212" "1", "\u0661", "9" * 400, "0." + "0" * 400 + "1"]
EXPRESSIONS = ["1/0", "0/0", "0*1/0", "sqrt(-1)", "log(0)", "1/t", "1/x", "1/(t-1)", "1e308*10", "1e300*x", "-1e300*x", "x*y*z",
               "if(t>1,1,-1)", "(t>1)*1e9", "sin(", ")", "(" * 300 + "1" + ")" * 300, "1" + "+1" * 3000, "x^y^z", "t t", "q", "pi",
               "_pi", "rand()", "erf(x)", "T", "1/(T-310)", "exp(T)", "-T", "T-1e9", "x=3", "a=b", "x?1:2", "'1'", '"a"',
               "sin(1,2)", "if(1)", "min()", "1e-400", "t^t^t^t", "floor(t)", "\u03c0", "1;2;3", "0; 0", "1; 2; 3; 4"]
TABLES = ["300: 1, 310: 2", "300: 1", "300: 1, 290: 2", "300: 1, 300: 2", "300:", ":", "300: 1: 2", "nan: 1, 310: 2", "-1: 1, 1e9: 2",
          "300: -1, 310: 1e300", "300: 0, 400: 0", "0: 1e-300, 1e300: 1e300", "300: 1, 310: x", "300: 1,, 310: 2", "300 : 1 , 310 : 2,"]
LISTS = ["", ",", ", ,", ";", ";;", "|", "0, 0", "0, 0, 0", "0, 0, 0, 0", "0, 0, 0; 0, 0, 0", "0.005, 0.005", "0.005, 0.005, 0.005",
         "1, 2; 3", "0 0 0", "nan, 0, 0", "1e300, 1e300, 1e300", "1, 1, 1,", "3, 2, 1", "-1, -1, -1", "1e-9, 1e-9, 1e-9"]
TEXTS = ["all", "remaining", "all, remaining", "none", "off", "on", "yes", "ON", "On", "automatic", "x max", "x min, x max", "1", "-1",
         "4294967295", "../..", "/", "/dev/null", "a/b", "`id`", "$(id)", "%s%n", "\\", "\"", "'", "#", "=", "set", "end",
         "subsection", "\u00e4\u00f6\u00fc", "\u4e2d\u6587", "\u202e", "\U0001f525", "a" * 5000, "caf\u00e9 \u00b0C", "tissue, tissue",
         "a, b, c", "outside", "needle", "\t", "\x01\x02", "\x7f"]
# Such as may be taken, so that cases come farther
GOOD_NUMBERS = ["0", "1", "2", "3", "0.5", "1e-3", "1e3", "1e6", "1e-6", "1e9", "1e12", "1e300", "1e-300", "5e-324", "0.49", "0.4999999",
                "310", "373", "273.15", "1e308", "1.7976931348623157e308"]
GOOD_EXPRESSIONS = ["1/t", "1/x", "1/(t-1)", "1e308*10", "1e300*x", "-1e300*x", "x*y*z", "if(t>1,1,-1)", "(t>1)*1e9", "exp(1e3*t)",
                    "1e-300", "T", "1/(T-310)", "exp(T)", "-T", "T-1e9", "sqrt(310.001-T)", "log(T-300)", "t", "x", "1e6*sin(1e9*t)",
                    "300: 1, 310: 2", "300: 0, 400: 0", "0: 1e-300, 1e300: 1e300", "310: 0.1, 310.001: 1e6", "rand()", "310+1e4*x"]
GOOD_LISTS = ["0, 0, 0", "0.005, 0.005, 0.005", "1e300, 1e300, 1e300", "1, 1, 1", "1e-9, 1e-9, 1e-9", "0, 0; 0, 0", "0; 0; 0", "1; 1; 1",
              "t; t; t", "1e300; 0; 0", "1e9*t; 0; 0", "-1*x; -1*y; -1*z", "1e-3*t; 0; 0", "1, 2, 3, 4", "0.5, 1", "1e-12, 1, 1", "0, 0, 0; 0, 0, 0"]
# Bigger ones would only ask for more than a machine has
FEW = ["0", "1", "2", "3", "1, 2, 3", "-1", "1.5", "nan", "x", "", "1, 1", "2, 2, 2, 2", "10001", "0, 1, 1", "1e300"]
SMALL_ONLY = {"Subdivisions", "Refinements"}
JUNK = ["include scene.prm", "include /dev/null", "include missing.prm", "subsection", "end", "end end", "set", "set =", "set = 1",
        "set A", "set Time/End = 1", "set End = 1 # 2", "set End = 1 \\", "\\", "=", "subsection Time", "subsection Output", "sett End = 1",
        "subsection subsection", "SET Dimension = 2", "set Dimension = 2", "set Title =", "<?xml version=\"1.0\"?>", "{\"a\": 1}",
        "subsection Tissues\nsubsection tissue\nend\nend", "subsection x" * 50, "\ufeff", "a" * 100000]
KEY_LINE = re.compile(r"^(\s*set\s+)([^=]*?)(\s*=\s*)(.*?)(\s*)$")


def entry_lines(lines):
    return [n for n, line in enumerate(lines) if KEY_LINE.match(line)]


def path_of(lines, number):
    """Section/Entry of line @p number, as far as sections are still whole."""
    path = []
    for line in map(str.strip, lines[:number]):
        if line.startswith("subsection"):
            path.append(line[len("subsection"):].strip())
        elif line == "end" and path:
            path.pop()
    return "/".join([*path, KEY_LINE.match(lines[number]).group(2)])


def new_value(random, name, old):
    """Mostly of the kind that stands there, so that it comes far; sometimes of any other."""
    if name in SMALL_ONLY:
        return random.choice(FEW)
    kinds = [NUMBERS, EXPRESSIONS, TABLES, LISTS, TEXTS]
    if random.random() < 0.85:
        if re.fullmatch(r"[-+.\deE]+", old):
            kinds = [GOOD_NUMBERS, GOOD_NUMBERS, GOOD_NUMBERS, NUMBERS, EXPRESSIONS, GOOD_EXPRESSIONS]
        elif re.search(r"[;:]|\d,", old):
            kinds = [LISTS, GOOD_LISTS, TABLES, GOOD_EXPRESSIONS]
        elif re.search(r"[*/+^()]", old):
            kinds = [EXPRESSIONS, GOOD_EXPRESSIONS, GOOD_NUMBERS]
        else:
            kinds = [TEXTS]
    value = random.choice(random.choice(kinds))
    if "," in old and random.random() < 0.4:
        parts = old.split(",")
        parts[random.randrange(len(parts))] = " " + value
        value = ",".join(parts)
    return value


def scaled(random, _, old):
    """The number that stands there times a power of ten."""
    numbers = list(re.finditer(r"(?<![\w.])\d+(\.\d*)?([eE][-+]?\d+)?", old))
    if not numbers:
        return old
    number = random.choice(numbers)
    value = float(number.group()) * random.choice([-1, 1, 1, 1, 1]) * 10. ** random.choice([-12, -6, -3, -1, 1, 2, 3, 6, 12, 100])
    return old[:number.start()] + repr(value) + old[number.end():]


class Scene:
    """A scene's lines, with the paths of the entries that were changed."""

    def __init__(self, text, choices):
        self.lines = text.splitlines()
        self.choices = choices  # by the name of an entry, the values that are documented for it
        self.changed = set()
        self.is_binary = False

    def replace_value(self, random, make):
        entries = entry_lines(self.lines)
        if not entries:
            return
        number = random.choice(entries)
        before, name, sign, old, after = KEY_LINE.match(self.lines[number]).groups()
        self.changed.add(path_of(self.lines, number))
        self.lines[number] = before + name + sign + make(random, name, old.split(" #")[0]) + after

    def change_value(self, random):
        self.replace_value(random, new_value)

    def scale_value(self, random):
        self.replace_value(random, lambda random, name, old: new_value(random, name, old) if name in SMALL_ONLY
                           else scaled(random, name, old))

    def choose_other(self, random):
        """Another of the documented choices, among entries that stand there: what effects have to do with each other."""
        entries = [n for n in entry_lines(self.lines) if KEY_LINE.match(self.lines[n]).group(2) in self.choices]
        if entries:
            number = random.choice(entries)
            before, name, sign, _, after = KEY_LINE.match(self.lines[number]).groups()
            self.changed.add(path_of(self.lines, number))
            self.lines[number] = before + name + sign + random.choice(self.choices[name]) + after

    def drop_line(self, random):
        if self.lines:
            del self.lines[random.randrange(len(self.lines))]

    def double_line(self, random):
        if self.lines:
            number = random.randrange(len(self.lines))
            self.lines.insert(random.randrange(len(self.lines)), self.lines[number])

    def swap_lines(self, random):
        if self.lines:
            a, b = random.randrange(len(self.lines)), random.randrange(len(self.lines))
            self.lines[a], self.lines[b] = self.lines[b], self.lines[a]

    def drop_section(self, random):
        starts = [n for n, line in enumerate(self.lines) if line.strip().startswith("subsection")]
        if starts:
            first = last = random.choice(starts)
            depth = 0
            for last in range(first, len(self.lines)):
                word = self.lines[last].strip()
                depth += word.startswith("subsection") - (word == "end")
                if depth == 0:
                    break
            section = self.lines[first:last + 1]
            if random.random() < 0.6:
                del self.lines[first:last + 1]
            else:
                place = random.randrange(len(self.lines) + 1)
                self.lines[place:place] = section

    def rename(self, random):
        """A name that is used in several places becomes another in one of them."""
        words = [(n, m) for n, line in enumerate(self.lines) for m in re.finditer(r"[A-Za-z]+", line)]
        if words:
            number, word = random.choice(words)
            line, other = self.lines[number], random.choice([*TEXTS, word.group() + "x", word.group()[1:], word.group().upper()])
            self.lines[number] = line[:word.start()] + other + line[word.end():]

    def insert_junk(self, random):
        self.lines.insert(random.randrange(len(self.lines) + 1), random.choice(JUNK))

    def cut(self, random):
        if self.lines:
            del self.lines[random.randrange(len(self.lines)):]

    def text(self, random):
        data = bytearray("\n".join(self.lines).encode() + b"\n")
        if self.is_binary:
            for _ in range(random.choice([1, 3, 30])):
                place = random.randrange(len(data))
                data[place:place + random.choice([0, 1, 1, 1, 8])] = bytes(
                    random.randrange(256) for _ in range(random.choice([0, 1, 1, 4])))
        return bytes(data)

    def random_bytes(self, _):
        self.is_binary = True


MUTATIONS = [(Scene.change_value, 40), (Scene.scale_value, 25), (Scene.choose_other, 35), (Scene.drop_line, 6), (Scene.double_line, 1),
             (Scene.swap_lines, 2), (Scene.drop_section, 3), (Scene.rename, 4), (Scene.insert_junk, 2), (Scene.cut, 1),
             (Scene.random_bytes, 2)]


def mutated(random, text, choices):
    """The bytes of a scene with one to four mutations, and the paths of the entries whose values were changed."""
    scene = Scene(text, choices)
    kinds, weights = zip(*MUTATIONS)
    for mutate in random.choices(kinds, weights, k=random.choice([1, 1, 1, 2, 2, 3, 4])):
        mutate(scene, random)
    return scene.text(random), scene.changed


def choices_of(reference):
    """From what `cautery parameters` prints: by the name of an entry, its documented choices `[a | b]`."""
    choices = {}
    for comment, name in re.findall(r"((?:^\s*#.*\n)+)^\s*set\s+(.*?)\s*=", reference, re.MULTILINE):
        found = re.search(r"\[([^\]]*\|[^\]]*)\]", re.sub(r"\n\s*#", "", comment))
        if found:
            choices[name] = [" ".join(choice.split()) for choice in found.group(1).split("|")]
    return choices
