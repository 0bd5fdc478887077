"""What a variant has: members of its file, parts of its record, and files on a disk."""

import copy
import json
import os
import pathlib
import pickle
import tempfile
import unittest

import mjforge
from mjforge._json import members_of_record

# Fixed, so that a keyframe has its start.
DOOR = """
mjforge: 1
name: door
joints: none
pose: {swing: 0.5}
parts: [{name: frame, type: box, size: [0.1, 0.1, 0.1]}]
bodies:
  - name: leaf
    pos: [0.2, 0, 0]
    joints: [{name: swing, type: hinge, axis: [0, 0, 1], range: [0, 1.5]}]
    sites: [{name: knob, pos: [0.1, 0, 0]}]
    parts: [{name: leaf, type: box, size: [0.05, 0.01, 0.05]}]
"""


class Members(unittest.TestCase):
    def test_are_those_of_the_file(self):
        variant = mjforge.Spec("laptop").variants(seed=3)[1]
        self.assertEqual(variant.name, "laptop")
        self.assertEqual(list(variant.joints), ["laptop_joint0", "laptop_hinge"])
        hinge = variant.joints["laptop_hinge"]
        self.assertEqual((hinge.type, hinge.body), ("hinge", "laptop_display"))
        self.assertEqual(hinge.range, (0, variant.params["reach"]))
        self.assertEqual(variant.pose, {"laptop_hinge": variant.params["open"]})
        self.assertIsNone(variant.joints["laptop_joint0"].range)
        self.assertEqual(variant.sites["laptop_grasp"].body, "laptop_display")
        self.assertEqual(len(variant.sites["laptop_grasp"].pos), 3)
        again = pickle.loads(pickle.dumps(variant))
        self.assertEqual(again.pose, variant.pose)

    def test_loose_bodies_start_beside_the_first(self):
        pose = mjforge.Spec("plug_and_socket").variants(seed=3)[1].pose
        self.assertEqual([len(position) for position in pose.values()], [7])

    def test_a_keyframe_has_the_start(self):
        variant = mjforge.Spec(DOOR).variants()[0]
        self.assertEqual(variant.pose, {"door_swing": 0.5})
        self.assertEqual(variant.sites["door_knob"].pos, (0.1, 0, 0))

    def test_robosuite_names_its_root_below_a_body_without_a_name(self):
        variant = mjforge.Spec("robosuite/hinged_box").variants(target="robosuite")[0]
        self.assertEqual(variant.members.root, "object")
        self.assertEqual(list(variant.pose), ["box_hinge"])


class Copies(unittest.TestCase):
    def test_that_are_changed_do_not_change_the_variant(self):
        with tempfile.TemporaryDirectory() as folder:
            variants = mjforge.Spec("laptop").variants(seed=3)
            variants.write(folder, 2)
            for variant in (variants[1], mjforge.Batch(folder)[1]):
                again = pickle.loads(pickle.dumps(variant))
                read = {name: getattr(variant, name) for name in (
                    "joints", "sites", "pose", "params", "places", "left_out", "record", "files", "view")}
                self.assertEqual(read["params"], read["record"]["params"])
                for name, value in read.items():
                    for inner in [*getattr(value, "values", lambda: value)(), value]:
                        if isinstance(inner, (dict, list)):
                            inner.clear()
                    self.assertEqual(getattr(variant, name), getattr(again, name), name)
                    self.assertTrue(getattr(variant, name) or name in ("places", "left_out", "files"), name)
                members = variant.members
                members.joints.clear()
                members.key.clear()
                members.root = ""
                self.assertEqual(variant.members, again.members)
                self.assertIsInstance(variant.standing_box, tuple)
                self.assertEqual((variant, variant.mass, variant.index), (again, again.mass, 1))

    def test_can_be_written_as_json_copied_and_pickled(self):
        variant = mjforge.Spec("laptop").variants(seed=3)[1]
        for value in (variant.record, variant.params, variant.places, variant.left_out, variant.view, variant.pose):
            self.assertEqual(json.loads(json.dumps(value)), value)
        for value in (variant, variant.record, variant.joints, variant.sites, variant.members, variant.view):
            for again in (copy.copy(value), copy.deepcopy(value), pickle.loads(pickle.dumps(value))):
                self.assertEqual(again, value)


class Records(unittest.TestCase):
    def test_have_the_box_of_a_variant(self):
        for name in ("hammer", "laptop", "robosuite/hinged_box"):
            for target in ("mujoco", "robosuite", "scene"):
                for variant in mjforge.Spec(name).variants(seed=4, target=target)[:5]:
                    read = mjforge.Variant(variant.xml_bytes, variant.record_bytes, b"", b"", ())
                    self.assertEqual(list(read.standing_box), list(variant.standing_box))
                    self.assertEqual(list(pickle.loads(pickle.dumps(variant)).standing_box), list(variant.standing_box))
                    box = variant.record["aabb"]
                    wanted = 6 * [0] if target == "scene" else box["min"] + box["max"]
                    self.assertEqual(list(variant.standing_box), wanted)

    def test_some_members_are_those_of_all(self):
        variants = mjforge.Spec("hammer").variants(seed=5)[:5]
        for variant in variants:
            names = ["mass", "aabb", "params", "status", "findings", "spec"]
            self.assertEqual(members_of_record(variant.record_bytes, names),
                             [variant.record[name] for name in names])

    def test_inner_objects_may_have_the_same_keys(self):
        record = {"params": {"mass": 1, "index": 2, "status": "ok"}, "mass": 3, "index": 4, "status": "failed"}
        text = json.dumps(record, separators=(",", ":")).encode()
        self.assertEqual(members_of_record(text, ["mass", "index", "status"]), [3, 4, "failed"])
        self.assertRaises(KeyError, members_of_record, text, ["com"])


class Files(unittest.TestCase):
    def test_are_those_of_the_command(self):
        variants = mjforge.Spec("spoon").variants(seed=3, assets="files")
        with tempfile.TemporaryDirectory() as folder:
            variants.write(pathlib.Path(folder, "made"), 2)
            saved = pathlib.Path(folder, "saved")
            saved.mkdir()
            self.assertEqual(variants[1].save(saved), saved / "spoon_000001.xml")
            variants[0].save(saved / "spoon_000000.xml")
            for file in pathlib.Path(folder, "made").rglob("*"):
                if file.suffix in (".xml", ".obj", ".png"):
                    there = saved / file.relative_to(pathlib.Path(folder, "made"))
                    self.assertEqual(there.read_bytes(), file.read_bytes())
            self.assertRaises(OSError, variants[0].save, pathlib.Path(folder, "no", "a.xml"))
        self.assertRaisesRegex(TypeError, "path=5", variants[0].save, 5)

    def test_of_a_new_folder_have_the_names_of_the_command(self):
        variant = mjforge.Spec("hammer").variants()[3]
        with tempfile.TemporaryDirectory() as folder:
            for name in (f"{folder}/new/one/", f"{folder}/new/one/", f"{folder}/new"):
                file = variant.save(name)
                self.assertEqual(file, pathlib.Path(name, "hammer_000003.xml"))
                self.assertEqual(file.read_bytes(), variant.xml_bytes)
            self.assertEqual(variant.save(f"{folder}/new/two").read_bytes(), variant.xml_bytes)
            self.assertRaises(FileExistsError, variant.save, f"{folder}/new/two/")

    def test_of_other_objects_are_not_replaced(self):
        cube = "".join(f"v {x} {y} {z}\n" for x in (0, 1) for y in (0, 1) for z in (0, 1))
        spec = "mjforge: 1\nname: {}\njoints: none\nparts: [{{name: p, type: mesh, file: m.obj, role: visual}}]\n"
        with tempfile.TemporaryDirectory() as folder:
            for name in ("one", "two"):
                pathlib.Path(folder, name).mkdir()
                pathlib.Path(folder, name, "m.obj").write_text(f"{cube}f 1 2 3\nf 1 2 5\nf 2 3 5\n# {name}\n")
                pathlib.Path(folder, name, "s.yaml").write_text(spec.format(name))
            one, two = (mjforge.Spec(os.path.join(folder, name, "s.yaml")).variants()[0] for name in ("one", "two"))
            for _ in range(2):
                one.save(folder)
            self.assertRaisesRegex(FileExistsError, "assets/m.obj' has another content", two.save, folder)
            self.assertFalse(any(pathlib.Path(folder).glob("two_*")))

    def test_may_be_there_for_a_while(self):
        variant = mjforge.Spec("spoon").variants(assets="files")[0]
        with variant.as_file() as path:
            self.assertEqual(path.read_bytes(), variant.xml_bytes)
            self.assertTrue(any(path.parent.rglob("*.obj")))
        self.assertFalse(os.path.exists(path))


if __name__ == "__main__":
    unittest.main()
