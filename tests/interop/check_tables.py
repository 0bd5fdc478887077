"""Tables of variants and of batches, as NumPy arrays and, if it is installed, in pandas.

    check_tables.py FOLDER
"""

import importlib.util
import json
import os
import pathlib
import subprocess
import tempfile

import mjforge
import numpy as np
from mjforge import _table
from mjforge._library import PROGRAM

from report import check, expect, finish, raises

MEMBERS = ["params", "mass", "com", "inertia", "bounds", "name", "sha256"]


def has_the_numbers_of_the_records(name):
    variants = mjforge.Spec(name).variants(seed=1)[3:43:2]
    columns = variants.table(MEMBERS, frame=False)
    for number, variant in enumerate(variants):
        row = {column: values[number] for column, values in columns.items()}
        expect(row["index"] == variant.index and row["mass"] == variant.mass, f"row {number}: {row}")
        expect(row["sha256"] == variant.record["sha256"], "another hash")
        bounds = [[row[f"bounds.{end}.{axis}"] for axis in "xyz"] for end in ("min", "max")]
        expect(np.array_equal(bounds, variant.bounds), f"row {number}: bounds {bounds}")
        inertia = [row[f"inertia.{axes}"] for axes in ("xx", "yy", "zz", "xy", "xz", "yz")]
        expect(inertia == variant.record["inertia"], f"row {number}: inertia {inertia}")
        for parameter, value in variant.params.items():
            column = row.get(f"params.{parameter}")
            if isinstance(value, list):
                column = [row[f"params.{parameter}.{each}"] for each in range(len(value))]
            expect(column == value, f"row {number}: {parameter} is {column}, not {value}")
    expect(columns["mass"].dtype == float and columns["index"].dtype == int, "other types")


def has_a_column_for_each_kind():
    """Rows of lists that differ in length, missing members, and numbers beyond 63 bits."""
    table = _table.Table(["index", "a", "b", "c", "d", "e"], False)
    rows = [{"index": 0, "a": [1, 2], "b": {"x": 1, "y": "u"}, "c": 2**64 - 1, "d": True, "e": None},
            {"index": 1, "a": [], "b": {"x": 0.1, "z": [1.5, 2]}, "c": 3, "d": False, "e": "t"},
            {"index": 2, "a": [[3]], "b": {"x": -7, "y": "w"}, "c": 4, "d": True}]
    for row in rows:
        table.add(json.dumps(row).encode())
    raises(ValueError, "it is not the record of a variant", table.add, b"[1]")
    columns = table.finish()
    expect(list(columns) == ["index", "a", "b.x", "b.y", "b.z.0", "b.z.1", "c", "d", "e"], f"{list(columns)}")
    expect(columns["a"].tolist() == [row["a"] for row in rows], f"{columns['a']}")
    expect(columns["b.x"].tolist() == [1, 0.1, -7] and columns["b.x"].dtype == float, f"{columns['b.x']}")
    expect(columns["b.y"].tolist() == ["u", None, "w"], f"{columns['b.y']}")
    expect(np.array_equal(columns["b.z.0"], [np.nan, 1.5, np.nan], equal_nan=True), f"{columns['b.z.0']}")
    expect(columns["c"].tolist() == [2**64 - 1, 3, 4], f"{columns['c']}")
    expect(columns["d"].dtype == bool and columns["d"].tolist() == [True, False, True], f"{columns['d']}")
    expect(columns["e"].tolist() == [None, "t", None], f"{columns['e']}")


def looks_for_members_in_all_records():
    """A member that only the last of 1,500 records has is a column."""
    table = _table.Table(["left_out"], False)
    for index in range(1500):
        table.add(b'{"index":%d%s}' % (index, b',"left_out":["a"]' if index == 1499 else b""))
    expect(table.finish()["left_out.0"].tolist()[-2:] == [None, "a"], "no column")


def has_columns_for_members_that_no_record_has():
    known = json.loads(subprocess.run([PROGRAM, "schema", "manifest"], check=True, capture_output=True).stdout)
    expect(set(known["properties"]) == _table._MEMBERS, "the schema has other members")
    variants = mjforge.Spec("hammer").variants()
    columns = variants[:2].table(["left_out", "places"], frame=False)
    expect([*columns["left_out"], *columns["places"]] == [None] * 4, f"{columns}")


def has_the_same_columns_without_rows():
    variants = mjforge.Spec("hammer").variants()
    none, some = (variants[:count].table(frame=False) for count in (0, 2))
    expect(list(none) == list(some), f"{list(none)}")
    expect({(len(values), values.dtype == some[name].dtype) for name, values in none.items()} == {(0, True)}, f"{none}")


def holds_the_meshes_that_it_uses_first():
    with tempfile.TemporaryDirectory() as folder:
        mesh = pathlib.Path(folder, "roof.obj")
        text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 {}\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n"
        mesh.write_text(text.format(1))
        file = pathlib.Path(folder, "house.yaml")
        file.write_text("{mjforge: 1, name: house, parts: [{name: roof, type: mesh, file: roof.obj, density: 100}]}")
        variants = mjforge.Spec(file).variants()
        variants[:2].table(frame=False)
        mesh.write_text(text.format(2))
        for call in (lambda: variants[:2].table(frame=False), lambda: variants.spec.variants()[0],
                     lambda: variants.spec.variants()[:2].table(frame=False)):
            raises(OSError, "roof.obj' has changed since", call)


def parameters_may_be_named_like_members():
    spec = mjforge.Spec({"mjforge": 1, "name": "ball", "params": {"mass": "1 .. 2", "com": "3 .. 4", "aabb": 5},
                         "parts": [{"name": "ball", "type": "sphere", "size": [0.02]}]})
    variants = spec.variants()[:10]
    columns = variants.table(["mass", "params"], frame=False)
    expect(list(columns["mass"]) == [variant.mass for variant in variants], "the masses are parameters")
    expect(list(columns["params.mass"]) == [variant.params["mass"] for variant in variants], "another mass")


def leaves_out_what_iteration_leaves_out():
    spec = mjforge.Spec({"mjforge": 1, "name": "ball", "params": {"r": "1cm .. 2cm"}, "expect": ["r < 15mm"],
                         "parts": [{"name": "ball", "type": "sphere", "size": ["r"]}]})
    some = spec.variants(on_invalid="skip")[:40]
    made = [variant.index for variant in some]
    expect(1 < len(made) < 40 and list(some.table(frame=False)["index"]) == made, f"{made}")
    try:
        spec.variants()[:40].table(frame=False)
    except mjforge.VariantError as error:
        expect(error.findings[0].index not in made, "another variant failed")
    else:
        raise AssertionError("no variant failed")


def batches_have_the_same():
    some = mjforge.Spec("mug").variants(seed=5)
    with tempfile.TemporaryDirectory() as folder:
        some.write(os.path.join(folder, "x.tar.zst"), 30)
        stored = mjforge.Batch(os.path.join(folder, "x.tar.zst")).table(MEMBERS, frame=False)
    made = some[:30].table(MEMBERS, frame=False)
    expect(list(stored) == list(made), "other columns")
    for name in set(made) - {"sha256"}:  # the command says how many there are
        expect(np.array_equal(stored[name], made[name]), name)


def is_a_frame_of_pandas():
    some = mjforge.Spec("mug").variants(seed=5)[:30]
    table = some.table()
    if importlib.util.find_spec("pandas") is None:
        expect(isinstance(table, dict), f"it is a {type(table)}")
        raises(ImportError, "frame=True", some.table, frame=True)
        return "it is not installed"
    expect(table.shape[0] == 30 and table["mass"].mean() > 0, "another shape")
    return None


def names_wrong_arguments():
    some = mjforge.Spec("mug").variants()
    raises(TypeError, "take a slice", some.table)
    for wrong in ("mass", 5, None, [5], b"mass"):
        raises(TypeError, "members=", some[:3].table, wrong)
    raises(ValueError, "'masz' is in no record", some[:3].table, ["masz"])
    for wrong in (1, "yes"):
        raises(TypeError, "frame=", some[:3].table, frame=wrong)


for name in ("hammer", "mug", "laptop", "scenes/desk"):
    check(f"table of {name}", has_the_numbers_of_the_records, name)
check("a column for each kind of value", has_a_column_for_each_kind)
check("members of late records", looks_for_members_in_all_records)
check("members that no record has", has_columns_for_members_that_no_record_has)
check("a table without rows", has_the_same_columns_without_rows)
check("hashes of meshes are held", holds_the_meshes_that_it_uses_first)
check("parameters are named like members", parameters_may_be_named_like_members)
check("a table leaves out failed variants", leaves_out_what_iteration_leaves_out)
check("a table of a batch", batches_have_the_same)
check("a table in pandas", is_a_frame_of_pandas)
check("wrong arguments of tables are named", names_wrong_arguments)
finish()
