#!/usr/bin/env python3
"""Makes the pictures of the documentation and the page of the bundled specs.

    docs/pictures/make.py MJFORGE

writes, beside itself, for every bundled spec the sheet NAME.webp, wall/NAME.webp, large/NAME.webp and
moved/NAME_*.webp; materials.webp; NAME.png for the cookbook; hero.webp and ten.webp for the README; and
catalogue.json, which says which specs they show. Also ../catalogue.md and the wall in the README. A test
compares the hashes in catalogue.json with the specs. `./dev pictures` builds the program and runs this.
"""

import concurrent.futures
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

import catalogue
import families
import gallery
import products
import shares

HERE = pathlib.Path(__file__).resolve().parent
PAGE = HERE.parent / "catalogue.md"
README = HERE.parent.parent / "README.md"
SEED = 7
VARIANTS = 8
TILE = "184x184"

# Variants whose masses, sides, joints and grasp sites the page has.
DRAWN = 100

QUALITY = "80"

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

# The pictures at the top of the README: a variant of a scene, and an animation of ten.
HERO = "scenes/worktop"
HERO_INDEX = "4"
HERO_SIZE = "1280x560"
TEN_SIZE = "640x280"
TEN_MILLISECONDS = "600"  # for each

# Samples of every material of the library.
SPECS = HERE.parent.parent / "specs"
LIBRARY = SPECS / "materials.yaml"
SAMPLES = HERE / "samples.yaml"
SAMPLES_TILE = "200x120"

# Recipes, whose specs stand on the page.
COOKBOOK = HERE.parent / "cookbook.md"


def run(program, *arguments):
    return subprocess.run(
        [program, *arguments], check=True, stdout=subprocess.PIPE, text=True
    ).stdout


def draw(program, what, picture, joints, *options):
    """Draws to a PNG or, through a PNG, to a WebP."""
    for name, value in joints.items():
        options += ("--joint", f"{name}={value}")
    drawn = picture.with_suffix(".png")
    run(program, "preview", str(what), "-o", str(drawn), "-s", str(SEED), "-q", *options)
    if picture.suffix == ".webp":
        run("cwebp", "-quiet", "-q", QUALITY, str(drawn), "-o", str(picture))
        drawn.unlink()


def requirements(spec):
    """The lines of `require:` in the spec's file, with their comments."""
    text = (SPECS / f"{spec}.yaml").read_text(encoding="utf-8")
    block = re.search(r"^require:\n((?:  .*\n)+)", text, re.MULTILINE)
    return re.sub("^  ", "", block.group(1), flags=re.MULTILINE) if block else ""


def write_all(folder, pictures):
    """Replaces the WebP pictures of a folder."""
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir()
    for name, data in pictures.items():
        (folder / f"{name}.webp").write_bytes(data)


def draw_materials(program, picture):
    names = re.findall(r"^  (\w+): {", LIBRARY.read_text(encoding="utf-8"), re.MULTILINE)
    cycle = f"material={{cycle: [{', '.join(names)}]}}"
    draw(program, SAMPLES, picture, {}, "-n", str(len(names)), "--size", SAMPLES_TILE, "--set", cycle)
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


def draw_hero(program):
    draw(program, HERO, HERE / "hero.webp", {}, "--first", HERO_INDEX, "--size", HERO_SIZE)
    with tempfile.TemporaryDirectory() as folder:
        frames = [pathlib.Path(folder, f"{index}.png") for index in range(10)]
        for index, frame in enumerate(frames):
            draw(program, HERO, frame, {}, "--first", str(index), "--size", TEN_SIZE)
        run("img2webp", "-loop", "0", "-lossy", "-q", QUALITY, "-d", TEN_MILLISECONDS, *map(str, frames),
            "-o", str(HERE / "ten.webp"))


def draw_sheets(program, specs):
    """Draws the sheet of each spec, and returns what `inspect` says about the specs."""
    def work(spec):
        inspected = json.loads(run(program, "inspect", spec, "--json"))
        picture = HERE / f"{catalogue.picture_name(spec)}.webp"
        draw(program, spec, picture, JOINTS.get(spec, {}), "-n", str(VARIANTS), "--size", TILE)
        print(f"{picture.name}: {picture.stat().st_size // 1000} kB", flush=True)
        return inspected

    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        return dict(zip(specs, pool.map(work, specs)))


def draw_specs(program, specs):
    """Draws all pictures of the specs, and returns `inspect`'s results and the gallery's pages."""
    inspected = draw_sheets(program, specs)
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        gallery.make(program, folder)
        thumbnails = gallery.thumbnails(folder)
        pages = {spec: gallery.SpecPage(folder, spec) for spec in specs}
    names = {spec: catalogue.picture_name(spec) for spec in specs}
    write_all(HERE / "wall", {names[spec]: thumbnails[spec] for spec in specs})
    write_all(HERE / "large", {names[spec]: pages[spec].large for spec in specs})
    write_all(HERE / "moved", {f"{names[spec]}_{i}": data for spec in specs
                               for i, (data, _) in enumerate(pages[spec].moved)})
    return inspected, pages


def draw_families(program, specs):
    """Draws the variants whose measures the page has, by spec; none of scenes, which take seconds."""
    def work(spec):
        return None if spec.startswith("scenes/") else families.draw(program, spec, DRAWN)

    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        return dict(zip(specs, pool.map(work, specs)))


def gather_facts(program, specs):
    """Each spec's family, product and shares; says which products lie outside of their family."""
    known, counted = products.read(), shares.read()
    facts = {spec: (family, known.get(spec), counted.get(spec))
             for spec, family in draw_families(program, specs).items()}
    for spec, (family, product, _) in facts.items():
        for difference in products.outside(product, family) if product else []:
            print(f"{spec}: {difference}", flush=True)
    return facts


def write_page(specs, inspected, pages, facts, materials):
    descriptions = {spec: inspected[spec]["description"] for spec in specs}
    chapters = (catalogue.chapter(spec, inspected[spec], pages[spec], facts[spec], JOINTS.get(spec, {}),
                                  requirements(spec)) for spec in specs)
    introduction = catalogue.CHAPTERS.format(seed=SEED, last=VARIANTS - 1, count=DRAWN)
    PAGE.write_text(catalogue.INTRODUCTION + catalogue.wall(descriptions) + introduction + "\n" + "\n".join(chapters)
                    + catalogue.MATERIALS.format(count=materials), encoding="utf-8")
    readme = README.read_text(encoding="utf-8")
    README.write_text(catalogue.put_between(readme, "wall", catalogue.readme_wall(specs)), encoding="utf-8")


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    program = str(pathlib.Path(sys.argv[1]).resolve())
    listed = json.loads(run(program, "catalogue", "--json"))
    specs = sorted((item["name"] for item in listed), key=catalogue.order)
    inspected, pages = draw_specs(program, specs)
    hashes = {f"{catalogue.picture_name(spec)}.webp": {"spec": spec, "sha256": inspected[spec]["spec_sha256"]}
              for spec in specs}
    materials = draw_materials(program, HERE / "materials.webp")
    hashes["materials.webp"] = {"spec": SAMPLES.name,
                                "sha256": json.loads(run(program, "inspect", str(SAMPLES), "--json"))["spec_sha256"]}
    hashes |= draw_cookbook(program)
    draw_hero(program)
    hashes |= {name: {"spec": HERO, "sha256": inspected[HERO]["spec_sha256"]} for name in ("hero.webp", "ten.webp")}
    known = HERE / "catalogue.json"
    before = json.loads(known.read_text(encoding="utf-8")) if known.exists() else {}
    for name in before.keys() - hashes.keys():
        (HERE / name).unlink(missing_ok=True)
    write_page(specs, inspected, pages, gather_facts(program, specs), materials)
    text = json.dumps(hashes, indent=1, sort_keys=True) + "\n"
    known.write_text(text, encoding="utf-8")


if __name__ == "__main__":
    main()
