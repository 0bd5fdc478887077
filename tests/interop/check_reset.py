"""Variants in a scene of the user's MuJoCo: the scene does not change them; they stand on their
bottoms, and start where they should.

    check_reset.py FOLDER
"""

import itertools
import warnings

import mjforge
import mujoco
import numpy as np
from mjforge._comparison import PIECES

from report import check, expect, finish, raises

# The scene's defaults and units must not change the object.
SCENE = """<mujoco><compiler angle="degree" autolimits="false"/>
<default><geom friction=".3 .1 .1" rgba="1 0 0 1"/><joint damping="3"/></default>
<worldbody><geom type="plane" size="2 2 .1"/>
<body name="table" pos="0 0 .4"><geom name="table" type="box" size=".4 .4 .02"/></body></worldbody></mujoco>"""
# Fields that the place in a scene does not change, by the number of their elements.
FIELDS = {"ngeom": "geom_type geom_size geom_friction geom_rgba geom_group geom_condim geom_solref geom_solimp",
          "nbody": "body_mass body_inertia body_ipos body_iquat", "njnt": "jnt_type jnt_axis jnt_limited jnt_range",
          "nv": "dof_damping dof_frictionloss dof_armature", "nsite": "site_pos site_quat site_size",
          "nmat": "mat_rgba mat_specular mat_shininess mat_texrepeat", "ntendon": "tendon_range tendon_stiffness",
          "neq": "eq_type eq_data", "nu": "actuator_gainprm actuator_biasprm actuator_ctrlrange",
          "nmeshvert": "mesh_vert"}
DOOR = """
mjforge: 1
name: door
joints: none
parts: [{name: frame, type: box, size: [0.1, 0.1, 0.1]}]
pose: {swing: 0.5}
bodies:
  - name: leaf
    pos: [0.2, 0, 0]
    joints: [{name: swing, type: hinge, axis: [0, 0, 1], range: [0, 1.5]}]
    parts: [{name: leaf, type: box, size: [0.05, 0.01, 0.05]}]
"""


def scene_with(variant, **options):
    """The model of a scene with the object."""
    scene = mujoco.MjSpec.from_string(SCENE)
    body = variant.attach(scene, prefix="o/", **options)
    expect(body.name == "o/" + variant.members.root, f"the body is {body.name}")
    return scene.compile()


def is_the_same_alone(name):
    """Sizes, masses, joints and materials in the scene are those of the object alone."""
    for target in ("mujoco", "robosuite"):
        try:
            variant = mjforge.Spec(name).variants(seed=3, target=target)[1]
        except mjforge.VariantError as error:
            expect("target/one-root" in str(error), str(error))
            continue
        scene, alone = scene_with(variant, pos=(0.1, 0.2, 0.42), quat=(0.8, 0, 0, 0.6)), variant.load(mujoco)
        for count, fields in FIELDS.items():
            number = getattr(alone, count) - (count == "nbody")  # without the world
            for field in fields.split() if number else ():
                expect(np.array_equal(getattr(scene, field)[-number:], getattr(alone, field)[-number:]),
                       f"for {target} {field} differs")


def stands(name):
    """Its lowest point is on the table, also on its side."""
    variant = mjforge.Spec(name).variants(seed=3)[2]
    for quat in ((1, 0, 0, 0), (1, 1, 0, 0), (1, 0, -1, 0)):
        model = scene_with(variant, pos=(0, 0, 0.42), quat=quat)
        data = mujoco.MjData(model)
        mujoco.mj_kinematics(model, data)
        lowest = min(low_of(model, data, geom) for geom in range(2, model.ngeom))
        # Bounds are those of the true solid, beyond which pieces that collide reach a little.
        allowed = 5e-5 if quat == (1, 0, 0, 0) else PIECES * np.ptp(variant.bounds, axis=0).max()
        expect(-allowed < lowest - 0.42 < 2e-3, f"turned by {quat} its lowest point is at {lowest:.6f} m")
    model = scene_with(variant, pos=(0, 0, 0.42), stand=False)
    expect(model.body("o/" + variant.name).pos[2] == 0.42, "stand=False moves it")


def low_of(model, data, geom):
    box = model.geom_aabb[geom]
    turn = data.geom_xmat[geom].reshape(3, 3)
    return (data.geom_xpos[geom] + turn @ box[:3])[2] - (np.abs(turn) @ box[3:])[2]


def starts(name, prefix="o/"):
    """Joints are at the start after a reset and after start(), and the root stays where it is."""
    variant = mjforge.Spec(name).variants(seed=3)[1]
    model = scene_with(variant, pos=(0.1, 0, 0.42), quat=(0.8, 0, 0, 0.6))
    expect(model.nkey == 0, "the scene has the object's keyframe")
    data = mujoco.MjData(model)
    zero, root = data.qpos.copy(), variant.members.root_joint
    for joint, position in variant.pose.items():
        if isinstance(position, float):
            expect(data.joint(prefix + joint).qpos[0] == position, f"{joint} is not at its start")
    data.qpos += 0.1
    data.qvel += 1
    variant.start(model, data, prefix)
    if root is not None:
        expect(np.allclose(data.joint(prefix + root).qpos, zero[:7] + 0.1), "the root has moved")
        data.joint(prefix + root).qpos = zero[:7]
        variant.start(model, data, prefix)
    expect(np.allclose(data.qpos, zero, atol=1e-9), f"qpos differs by {abs(data.qpos - zero).max():g}")
    expect(not data.qvel.any(), "it moves")


def starts_as_its_keyframe():
    variant = mjforge.Spec(DOOR).variants()[0]
    model = scene_with(variant)
    data = mujoco.MjData(model)
    expect(data.qpos[0] == 0, "it starts at zero")
    variant.start(model, data, "o/")
    expect(data.qpos[0] == 0.5, f"it starts at {data.qpos[0]}")


def names_wrong_arguments():
    variant = mjforge.Spec("laptop").variants()[0]
    scene = mujoco.MjSpec.from_string(SCENE)
    for wrong in (5, None, "scene", scene.compile()):
        raises(TypeError, "scene=", variant.attach, wrong)
    for name, wrong, error in (("prefix", 5, TypeError), ("pos", 5, TypeError), ("pos", "abc", TypeError),
                               ("pos", (1, 2), ValueError), ("pos", (1, 2, float("nan")), ValueError),
                               ("quat", (0, 0, 0, 0), ValueError), ("quat", None, TypeError),
                               ("stand", 1, TypeError)):
        raises(error, f"{name}=", variant.attach, scene, **{name: wrong})
    model = scene_with(variant)
    data = mujoco.MjData(model)
    raises(TypeError, "model=", variant.start, data, data)
    raises(TypeError, "data=", variant.start, model, model)
    raises(TypeError, "prefix=", variant.start, model, data, None)
    raises(ValueError, "the model has no joint 'p/laptop_", variant.start, model, data, "p/")
    raises(ValueError, "is of another model: xpos has 3 rows", variant.start, model, mujoco.MjData(variant.load()))


def mixes_objects_with_and_without_files():
    """The scene compiles without a warning, and so do its copy and a scene to which it is attached."""
    filed = mjforge.Spec("spoon").variants(assets="files")[0]
    inline = mjforge.Spec("hammer").variants()[0]
    expect(filed.files and not inline.files and "<mesh " in inline.xml, "these objects are not such a mix")
    for objects in itertools.product((filed, inline), repeat=3):
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            scene = mujoco.MjSpec.from_string(SCENE)
            for number, variant in enumerate(objects):
                variant.attach(scene, prefix=f"{number}/")
            whole = mujoco.MjSpec()
            copied = scene.copy()
            models = [scene.compile(), copied.compile()]
            whole.attach(copied, prefix="whole/", frame=whole.worldbody.add_frame())
            models += [whole.compile(), whole.copy().compile()]
        expect(len(scene.assets) == len(filed.files) * objects.count(filed), f"it has the files {list(scene.assets)}")
        wanted = [name for number, variant in enumerate(objects) for name in names_of_meshes(variant, f"{number}/")]
        for model, prefix in zip(models, ("", "", "whole/", "whole/")):
            found = [model.mesh(mesh).name for mesh in range(model.nmesh)]
            expect(sorted(found) == sorted(prefix + name for name in wanted), f"it has the meshes {found}")


def names_of_meshes(variant, prefix):
    model = variant.load(mujoco)
    return [prefix + model.mesh(mesh).name for mesh in range(model.nmesh)]


def refuses_a_name_twice():
    """The scene is then as before."""
    variant = mjforge.Spec("hammer").variants()[0]
    scene = mujoco.MjSpec.from_string(SCENE)
    variant.attach(scene, prefix="o/")
    before = scene.to_xml()
    raises(ValueError, "prefix='o/': the scene has a body 'o/hammer' already", variant.attach, scene, prefix="o/")
    expect(scene.to_xml() == before, "the scene has changed")


for name in mjforge.catalogue():
    check(f"{name} in a scene", is_the_same_alone, name)
for name in ("hammer", "laptop", "mug"):
    check(f"{name} stands on its bottom", stands, name)
for name in ("laptop", "cardboard_box", "fridge", "plug_and_socket", "scenes/desk"):
    check(f"{name} starts where it should", starts, name)
check("a keyframe is applied", starts_as_its_keyframe)
check("wrong arguments are named", names_wrong_arguments)
check("objects with and without files in a scene", mixes_objects_with_and_without_files)
check("a name that the scene has is refused", refuses_a_name_twice)
finish()
