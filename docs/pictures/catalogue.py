"""Writes the page of the bundled specs, and their wall in the README."""

import re

COLUMNS = 4
LAST_KINDS = ("robosuite", "shapes", "primitives")
# Folders whose specs have the names of specs in other folders.
PREFIXED = ("scenes", "robosuite")

INTRODUCTION = """# The bundled specs

<!-- Made by `./dev pictures`: edits are lost. -->

`mjforge catalogue --html DIR` writes [a gallery](preview.md#a-gallery-of-all-specs) of these specs and of yours,
with a search, charts of all parameters and joints that move. Any parameter can be set: `mjforge generate NAME
--set parameter=value`, or `params:` where your own spec includes one with `spec:`. To change a spec as a whole,
start with `mjforge new my.yaml --like NAME`.

## All at a glance
"""

CHAPTERS = """
## About the chapters

Each large picture shows variant 0 of seed {seed}, and each sheet variants 0 to {last}. Masses and sizes are those of
24 variants (of scenes, 8). Values that are computed from others are at the end of each table.
"""

MATERIALS = """
## Materials

`import: materials` gives a spec [these materials](../specs/materials.yaml), each with its density, friction and look.

![A ball, a box and a cup of each of {count} materials of the library: woods, metals, plastics, glass, stone and more](pictures/materials.webp)
"""


def order(spec):
    """Sorts kinds by name, and reference objects, shapes and primitives last, as the gallery does."""
    kind = spec.split("/")[0]
    return (LAST_KINDS.index(kind) + 1 if kind in LAST_KINDS else 0, kind, spec)


def picture_name(spec):
    """The name of a spec's pictures, without the ending."""
    folder, name = spec.split("/")
    return f"{folder}_{name}" if folder in PREFIXED else name


def anchor(spec):
    return "#" + re.sub(r"[^\w-]", "", spec.lower())


def by_kind(specs):
    kinds = {}
    for spec in specs:
        kinds.setdefault(spec.split("/")[0], []).append(spec)
    return kinds


def _cell(spec, description):
    name = spec.split("/")[1].replace("_", " ")
    return (f'<td align="center" valign="top" width="{100 // COLUMNS}%"><a href="{anchor(spec)}">'
            f'<img src="pictures/wall/{picture_name(spec)}.webp" width="180" alt="A variant of {spec}"><br>'
            f"<b>{name}</b></a><br><sub>{_text(description)}</sub></td>")


def wall(descriptions):
    """The wall of thumbnails: a table for each kind."""
    lines = []
    for kind, specs in by_kind(descriptions).items():
        lines += ["", f"### {kind.capitalize()}", "", "<table>"]
        for first in range(0, len(specs), COLUMNS):
            cells = (_cell(spec, descriptions[spec]) for spec in specs[first:first + COLUMNS])
            lines += ["<tr>", *cells, "</tr>"]
        lines.append("</table>")
    return "\n".join(lines) + "\n"


def readme_wall(specs):
    """The wall of the README: a line for each kind."""
    lines = []
    for members in by_kind(specs).values():
        pictures = " ".join(
            f'<a href="docs/catalogue.md{anchor(spec)}"><img src="docs/pictures/wall/{picture_name(spec)}.webp" '
            f'width="92" alt="{spec}" title="{spec}"></a>' for spec in members)
        lines.append(pictures)
    return "\n".join(lines) + "\n"


def put_between(text, name, content):
    """Replaces what is between the comments `<!-- NAME -->` and `<!-- end of NAME -->`."""
    start, end = f"<!-- {name} -->\n", f"<!-- end of {name} -->\n"
    before, rest = text.split(start)
    return before + start + content + end + rest.split(end)[1]


def _text(words):
    return words.replace("&", "&amp;").replace("<", "&lt;")


def _table_cell(text):
    return text.replace("|", "\\|").replace("\n", " ")


def _table(parameters):
    lines = ["| parameter | value | unit | meaning |", "| --- | --- | --- | --- |"]
    for parameter in parameters:
        lines.append(f"| `{parameter['name']}` | `{_table_cell(parameter['spec'])}` "
                     f"| {_table_cell(parameter['unit'])} | {_table_cell(parameter['doc'])} |")
    return lines


def _moved(spec, alts):
    """Pictures of the joints at the ends of their ranges."""
    if not alts:
        return []
    pictures = " ".join(
        f'<img src="pictures/moved/{picture_name(spec)}_{i}.webp" width="24%" alt="{_text(alt)}">'
        for i, alt in enumerate(alts))
    words = ", ".join("`" + alt.split(" with ", 1)[1].replace(" at ", "` at ", 1) for alt in alts)
    return [f"<p>{pictures}</p>", "", f"Above: {words}.", ""]


def chapter(spec, inspected, page, joints, required):
    description = inspected["description"]
    name = picture_name(spec)
    geoms = page.facts["Its elements"]
    lines = [
        f"## {spec}", "", description, "",
        f'<p><img src="pictures/large/{name}.webp" width="40%" align="top" alt="A variant of {spec}: {_text(description)}"> '
        f'<img src="pictures/{name}.webp" width="58%" align="top" alt="Eight variants of {spec}, side by side"></p>', "",
        *_moved(spec, [alt for _, alt in page.moved]),
        f"Mass {page.facts['Mass']}; longest side {page.facts['Longest side']}. The variant in the large picture: "
        f"{page.facts['Variant in the large picture']}; {geoms}; {page.facts['Its file']}.", "",
    ]
    if joints:
        positions = ", ".join(f"`{joint}` at {value}" for joint, value in joints.items())
        lines += [f"The sheet is drawn with the joint {positions}.", ""]
    count = len(inspected["parameters"])
    lines += ["<details>", f"<summary>{count} parameter{'' if count == 1 else 's'}</summary>", "",
              *_table(inspected["parameters"])]
    if required:
        lines += ["", "Parameters that do not meet these are drawn again (`require:`):", "",
                  "```yaml", required.rstrip(), "```"]
    return "\n".join([*lines, "", "</details>"]) + "\n"
