"""Writes the page of the bundled specs, and their wall in the README."""

import math
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

Each large picture shows variant 0 of seed {seed}, and each sheet variants 0 to {last}. Masses and sides are those of
the first {count} variants of seed 0 (of scenes, 8 of seed {seed}) as they start: sides of the box around them, the
longest first. Beside them is a real product or a standard, from [a table](pictures/products.csv); it was chosen for its
likeness, so that it often lies inside. A figure that is `unverified` was not compared with its source. Joints that
differ only in a number share a row, which has the least and the greatest end of all. Values that are computed from
others are at the end of each table of parameters.

How many variants pass the [physical checks](physics.md), and how many pass `--profile simready`
([the benchmark](physics.md#the-simready-benchmark)) as well, was [counted](pictures/shares.csv) by `./dev shares` on
the day that is named.
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


def number(value):
    """Three digits, or all before the point."""
    if value == 0:
        return "0"
    digits = max(0, 2 - math.floor(math.log10(abs(value))))
    text = f"{value:.{digits}f}"
    return text.rstrip("0").rstrip(".") if "." in text else text


def span(low, high, between=" to "):
    low, high = number(low), number(high)
    return low if low == high else low + between + high


def _masses(seen):
    unit, scale = ("kg", 1) if seen.high >= 1 else ("g", 1000)
    return f"{span(scale * seen.low, scale * seen.high)} {unit}"


def _product_mass(mass):
    if mass is None:
        return ""
    return f"{mass:g} kg" if mass >= 1 else f"{1000 * mass:g} g"


def _product_sides(product):
    if not product.sides:
        return ""
    part = f"{product.part}: " if product.part else ""
    return part + " x ".join(f"{side:g}" for side in product.sides) + " mm"


def _share(row, passed, counted):
    share = 100 * row[passed] / row[counted]
    # Never rounded up to all of them.
    text = f"{math.floor(10 * share) / 10:g}"
    return f"{text} % of {row[counted]} ({row['date']})"


def measures(family, product, row):
    """A table of masses and sides beside those of a product, and of the shares that pass."""
    sides = " x ".join(span(1000 * side.low, 1000 * side.high) for side in family.sides) + " mm"
    rows = [["", f"{family.count} variants"], ["mass", _masses(family.mass)], ["sides", sides]]
    if product:
        rows[0].append(_table_cell(f"{product.name} ({product.source})"))
        rows[1].append(_product_mass(product.mass))
        rows[2].append(_table_cell(_product_sides(product)))
    if row:
        rows.append(["pass the physical checks", _share(row, "physics", "variants")])
        if row["profiled"]:
            rows.append(["pass `--profile simready`, too", _share(row, "simready", "profiled")])
    columns = len(rows[0])
    lines = ["| " + " | ".join(cells + [""] * (columns - len(cells))) + " |" for cells in rows]
    return [lines[0], "| --- " * columns + "|", *lines[1:], ""]


def _names(names):
    """One or two names, or the first and the last of names that differ in numbers."""
    def key(name):
        return [int(part) if part.isdigit() else part for part in re.split(r"(\d+)", name)]

    names = sorted(names, key=key)
    return ", ".join(f"`{name}`" for name in names) if len(names) < 3 else f"`{names[0]}` to `{names[-1]}`"


def _joint(joint, count):
    scale, unit = (1000, "mm") if joint.kind == "slide" else (180 / math.pi, "deg")
    if joint.kind == "free":
        ends = ["", "", ""]
    elif not joint.is_limited:
        ends = ["no limit", "no limit", unit]
    else:
        ends = [span(scale * end.low, scale * end.high, " .. ") for end in (joint.low, joint.high)] + [unit]
    variants = "all" if len(joint.variants) == count else f"{len(joint.variants)} of {count}"
    return "| " + " | ".join([_names(joint.names), joint.kind, *ends, variants]) + " |"


def joints_and_grasps(family):
    """A line, or a folded table of the joints."""
    grasps = ", ".join(map(_names, family.grasps.values()))
    sites = sum(map(len, family.grasps.values()))
    grasps = f"grasp site{'s' if sites > 1 else ''} {grasps}" if grasps else "no grasp site"
    if not family.joints:
        return [f"No joints; {grasps}.", ""]
    names = {name for joint in family.joints.values() for name in joint.names}
    count = f"{len(names)} joint{'s' if len(names) > 1 else ''}"
    return ["<details>", f"<summary>{count}; {_text(grasps.replace('`', ''))}</summary>", "",
            "| joint | type | from | to | unit | variants |", "| --- | --- | --- | --- | --- | --- |",
            *(_joint(joint, family.count) for joint in family.joints.values()), "", "</details>", ""]


def chapter(spec, inspected, page, facts, joints, required):
    """The chapter of a spec; `facts` are its family, product and row of shares, or None for what is not known."""
    description = inspected["description"]
    name = picture_name(spec)
    geoms = page.facts["Its elements"]
    lines = [
        f"## {spec}", "", description, "",
        f'<p><img src="pictures/large/{name}.webp" width="40%" align="top" alt="A variant of {spec}: {_text(description)}"> '
        f'<img src="pictures/{name}.webp" width="58%" align="top" alt="Eight variants of {spec}, side by side"></p>', "",
        *_moved(spec, [alt for _, alt in page.moved]),
        f"The variant in the large picture: {page.facts['Variant in the large picture']}; {geoms}; "
        f"{page.facts['Its file']}.", "",
    ]
    if facts[0]:
        lines += [*measures(*facts), *joints_and_grasps(facts[0])]
    else:
        lines += [f"Mass {page.facts['Mass']}; longest side {page.facts['Longest side']}.", ""]
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
