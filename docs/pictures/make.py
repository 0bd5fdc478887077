#!/usr/bin/env python3
"""Makes the pictures of the documentation and the page of the bundled specs.

    docs/pictures/make.py MJFORGE

writes, beside itself, NAME.png for every bundled spec, materials.png, hero.png for the README, and
catalogue.json, which says which specs they show; and ../catalogue.md. A test compares the hashes in catalogue.json
with the specs. `./dev pictures` builds the program and runs this.
"""

import json
import pathlib
import re
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
PAGE = HERE.parent / "catalogue.md"
SEED = 7
VARIANTS = 8
TILE = "184x184"

# Joint positions that show what moves, within the range of every variant.
JOINTS = {
    "articulated/door_with_lever": {"hinge": "25deg"},
    "articulated/drawer_cabinet": {"slide_1": "0.15"},
    "articulated/faucet": {"swivel": "-35deg"},
    "articulated/hinged_box": {"box_hinge": "80deg"},
    "articulated/jar_with_lid": {"lid_rise": "2mm"},
    "articulated/scissors": {"pivot": "40deg"},
    "furniture/cupboard": {"hinge_1": "70deg"},
    "furniture/desk": {"slide_0": "12cm"},
    "electronics/keyboard": {"press_56": "-2.5mm"},
}

# The picture at the top of the README.
HERO = "scenes/set_table"
HERO_INDEX = "1"
HERO_SIZE = "1120x528"

# A block of every material of the library.
SPECS = HERE.parent.parent / "specs"
LIBRARY = SPECS / "materials.yaml"
BLOCK = "primitives/box"
BLOCK_SETTINGS = ("--set", "size=[4cm, 3cm, 3cm]", "--set", "rgba=[1, 1, 1, 1]")
BLOCK_TILE = "144x96"

# Recipes, whose specs stand on the page.
COOKBOOK = HERE.parent / "cookbook.md"

MATERIALS = """
## Materials

`import: materials` gives a spec [these materials](../specs/materials.yaml), each with its density, friction and look.

![{count} equal blocks, each of a different material of the library: woods, metals, plastics, glass, stone and more](pictures/materials.png)
"""

INTRODUCTION = """# The bundled specs

<!-- Made by `./dev pictures`: edits are lost. -->

Each is drawn with seed {seed}, indices 0 to {last}; the joints named below a picture are open. Any parameter can be set: `mjforge
generate NAME --set parameter=value`, or `params:` where your own spec includes one with `spec:`. Values that are
computed from others are at the end of each table.

"""


def run(program, *arguments):
    return subprocess.run(
        [program, *arguments], check=True, stdout=subprocess.PIPE, text=True
    ).stdout


def draw(program, what, picture, joints, *options):
    for name, value in joints.items():
        options += ("--joint", f"{name}={value}")
    run(program, "preview", str(what), "-o", str(picture), "-s", str(SEED), "-q", *options)


def picture_name(spec):
    """Scenes have the names of objects, so their pictures have the folder's name, too."""
    folder, name = spec.split("/")
    return f"{folder}_{name}.png" if folder == "scenes" else f"{name}.png"


def requirements(spec):
    """The lines of `require:` in the spec's file, with their comments."""
    text = (SPECS / f"{spec}.yaml").read_text(encoding="utf-8")
    block = re.search(r"^require:\n((?:  .*\n)+)", text, re.MULTILINE)
    return re.sub("^  ", "", block.group(1), flags=re.MULTILINE) if block else ""


def cell(text):
    return text.replace("|", "\\|").replace("\n", " ")


def chapter(spec, inspected):
    joints = JOINTS.get(spec, {})
    lines = [
        f"## {spec}",
        "",
        inspected["description"],
        "",
        f"![{VARIANTS} variants of {spec}: {inspected['description']}](pictures/{picture_name(spec)})",
        "",
    ]
    if joints:
        stand = ", ".join(f"`{name}` at {value}" for name, value in joints.items())
        lines += [f"Drawn with the joint {stand}.", ""]
    lines += ["| parameter | value | unit | meaning |", "| --- | --- | --- | --- |"]
    for parameter in inspected["parameters"]:
        lines.append(
            f"| `{parameter['name']}` | `{cell(parameter['spec'])}` | {cell(parameter['unit'])} "
            f"| {cell(parameter['doc'])} |"
        )
    if required := requirements(spec):
        lines += ["", "Parameters that do not meet these are drawn again (`require:`):", "",
                  "```yaml", required.rstrip(), "```"]
    return "\n".join(lines) + "\n"


def draw_materials(program, picture):
    names = re.findall(r"^  (\w+): {", LIBRARY.read_text(encoding="utf-8"), re.MULTILINE)
    cycle = f"material={{cycle: [{', '.join(names)}]}}"
    draw(program, BLOCK, picture, {}, "-n", str(len(names)), "--size", BLOCK_TILE, "--set", cycle,
         *BLOCK_SETTINGS)
    return len(names)


def draw_cookbook(program):
    """Draws the recipes on the page; the hashes of their specs, by picture."""
    text = COOKBOOK.read_text(encoding="utf-8")
    hashes = {}
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        for file, spec in re.findall(r"```yaml\n(?=# file: (\S+)\n)(.*?)```", text, re.DOTALL):
            (folder / file).write_text(spec, encoding="utf-8")
        for name in re.findall(r"\]\(pictures/(\w+)\.png\)", text):
            spec = folder / f"{name}.yaml"
            draw(program, spec, HERE / f"{name}.png", {}, "-n", "4", "--size", TILE)
            inspected = json.loads(run(program, "inspect", str(spec), "--json"))
            hashes[f"{name}.png"] = {"spec": spec.name, "sha256": inspected["spec_sha256"]}
    return hashes


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    program = str(pathlib.Path(sys.argv[1]).resolve())
    specs = [item["name"] for item in json.loads(run(program, "catalogue", "--json"))]
    hashes = {}
    chapters = []
    for spec in specs:
        inspected = json.loads(run(program, "inspect", spec, "--json"))
        picture = HERE / picture_name(spec)
        draw(program, spec, picture, JOINTS.get(spec, {}), "-n", str(VARIANTS), "--size", TILE)
        hashes[picture.name] = {"spec": spec, "sha256": inspected["spec_sha256"]}
        chapters.append(chapter(spec, inspected))
        print(f"{picture.name}: {picture.stat().st_size // 1000} kB", flush=True)
    materials = draw_materials(program, HERE / "materials.png")
    hashes["materials.png"] = {"spec": BLOCK, "sha256": hashes[picture_name(BLOCK)]["sha256"]}
    hashes |= draw_cookbook(program)
    draw(program, HERO, HERE / "hero.png", {}, "--first", HERO_INDEX, "--size", HERO_SIZE)
    hashes["hero.png"] = hashes[picture_name(HERO)]
    known = HERE / "catalogue.json"
    before = json.loads(known.read_text(encoding="utf-8")) if known.exists() else {}
    for name in before.keys() - hashes.keys():
        (HERE / name).unlink(missing_ok=True)
    page = INTRODUCTION.format(seed=SEED, last=VARIANTS - 1) + "\n".join(chapters)
    PAGE.write_text(page + MATERIALS.format(count=materials), encoding="utf-8")
    text = json.dumps(hashes, indent=1, sort_keys=True) + "\n"
    known.write_text(text, encoding="utf-8")


if __name__ == "__main__":
    main()
