"""What the medians say: CPU time of each object, wall time of the command, and
the ratios that are claimed."""

# Row of the measurements, and its words.
WRITE = [
    ("robosuite text", "robosuite: construct, object and assets as text"),
    ("robosuite world", "robosuite: in its MujocoWorldBase, get_xml"),
    ("pymjcf text", "PyMJCF: build, to_xml_string"),
    ("mjspec text", "mjSpec: build, compile, to_xml"),
    ("library none", "mjforge, library: text and record"),
    ("command none 1", "mjforge generate --validate none -j 1, to one tar"),
    ("command none 2", "mjforge generate --validate none -j 2, to one tar"),
]
LOAD = [
    ("robosuite load", "robosuite: in its world, get_model"),
    ("robosuite load light", "robosuite: without world and textures, from_xml_string"),
    ("pymjcf load", "PyMJCF: build, to_xml_string, from_xml_string"),
    ("mjspec load", "mjSpec: build, compile"),
    ("library bare", "bare loop of mj_loadXML in C++, tight size"),
    ("library load", "mjforge, library: validated"),
    ("command load 1", "mjforge generate -j 1, validated, to one tar"),
    ("command load 2", "mjforge generate -j 2, validated, to one tar"),
]
COMMANDS = [row for row in WRITE + LOAD if row[0].startswith("command")]

# Words, numerator, denominator, clock, goal.
RATIOS = [
    ("robosuite as text / mjforge command, not validated", "robosuite text", "command none 1",
     "cpu", 18),
    ("PyMJCF as text / the same", "pymjcf text", "command none 1", "cpu", None),
    ("mjSpec as text / the same", "mjspec text", "command none 1", "cpu", None),
    ("mjforge library / mjforge command, not validated", "library none", "command none 1", "cpu",
     0.8),
    ("robosuite loaded / mjforge command, validated", "robosuite load", "command load 1", "cpu",
     4),
    ("robosuite loaded without textures / the same", "robosuite load light", "command load 1",
     "cpu", 4),
    ("PyMJCF loaded / the same", "pymjcf load", "command load 1", "cpu", None),
    ("mjSpec compiled / the same", "mjspec load", "command load 1", "cpu", None),
    ("bare mj_loadXML / mjforge command, validated", "library bare", "command load 1", "cpu",
     0.87),
    ("wall time of one worker / of two, not validated", "command none 1", "command none 2", "wall",
     1.8),
    ("wall time of one worker / of two, validated", "command load 1", "command load 2", "wall",
     1.8),
]


def number(value):
    return f"{value:.0f}" if value >= 100 else f"{value:.3g}"


def report(medians, objects, about, table):
    def times(rows, clock):
        return [[words, *(number(medians[row, name][clock]) for name in objects)]
                for row, words in rows]

    def ratios():
        for words, numerator, denominator, clock, goal in RATIOS:
            values = [medians[numerator, name][clock] / medians[denominator, name][clock]
                      for name in objects]
            missed = " (not reached)" if goal and values[0] < goal else ""
            yield [words, *map(number, values), f">= {goal}{missed}" if goal else ""]

    head = list(objects)
    return "\n\n".join([
        about,
        "To text, microseconds of CPU time for each object:",
        table(["", *head], times(WRITE, "cpu")),
        "Loaded in MuJoCo, microseconds of CPU time for each object:",
        table(["", *head], times(LOAD, "cpu")),
        "The command's wall time, microseconds for each object:",
        table(["", *head], times(COMMANDS, "wall")),
        "Ratios of these; the goals are the hammer's:",
        table(["", *head, "goal"], list(ratios())),
    ])
