"""Reads real products to compare families with, and says where they lie outside of what variants have."""

import csv
import dataclasses
import pathlib

FILE = pathlib.Path(__file__).resolve().parent / "products.csv"
# Makers round, and measure with or without feet.
TOLERANCE = 0.02


@dataclasses.dataclass
class Product:
    name: str
    mass: float  # in kg, or None
    part: str  # what the sides are of, if not of the whole object as variants start
    sides: list  # in mm, longest first
    source: str


def read(file=FILE):
    """The products, by spec."""
    with file.open(encoding="utf-8", newline="") as lines:
        return {row["spec"]: _product(row) for row in csv.DictReader(lines)}


def _product(row):
    part, _, size = row["size"].rpartition(": ")
    sides = [float(side) for side in size.split(" x ")] if size else []
    if sides != sorted(sides, reverse=True):
        raise ValueError(f"products.csv: the size of {row['spec']}, '{row['size']}', has not its longest side first")
    return Product(row["product"], float(row["mass"]) if row["mass"] else None, part, sides, row["source"])


def outside(product, family):
    """The masses and sides of a product that no variant comes near, in words."""
    found = []
    if product.mass is not None and not _is_in(product.mass, family.mass):
        found.append(f"{product.name} weighs {product.mass:g} kg, variants {family.mass.low:.3g} to "
                     f"{family.mass.high:.3g} kg")
    for number, (side, seen) in enumerate(zip([] if product.part else product.sides, family.sides), start=1):
        if not _is_in(side / 1000, seen):
            found.append(f"side {number} of {product.name} is {side:g} mm long, of variants "
                         f"{1000 * seen.low:.3g} to {1000 * seen.high:.3g} mm")
    return found


def _is_in(value, seen):
    return (1 - TOLERANCE) * seen.low <= value <= (1 + TOLERANCE) * seen.high
