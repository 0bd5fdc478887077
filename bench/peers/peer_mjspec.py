"""MuJoCo's own mjSpec from Python: the same trees; what is nested is a spec of
its own, attached to a frame. It writes text only of what is compiled."""

import mujoco

import objects
from worker import serve

GEOMS = {"box": mujoco.mjtGeom.mjGEOM_BOX, "cylinder": mujoco.mjtGeom.mjGEOM_CYLINDER}
JOINTS = {"free": mujoco.mjtJoint.mjJNT_FREE, "hinge": mujoco.mjtJoint.mjJNT_HINGE}
RGB = int(mujoco.mjtTextureRole.mjTEXROLE_RGB)


def add_materials(spec, thing):
    for material in thing["materials"]:
        name = material["name"]
        # A cube's six sides, one below the other.
        spec.add_texture(name=name, type=mujoco.mjtTexture.mjTEXTURE_CUBE,
                         builtin=mujoco.mjtBuiltin.mjBUILTIN_FLAT, rgb1=[1, 1, 1],
                         mark=mujoco.mjtMark.mjMARK_RANDOM, random=0.3,
                         markrgb=[material["grain"]] * 3, width=16, height=96)
        textures = [""] * int(mujoco.mjtTextureRole.mjNTEXROLE)
        textures[RGB] = name
        spec.add_material(name=name, rgba=material["rgba"], specular=material["specular"],
                          shininess=material["shininess"], texrepeat=[3, 3], textures=textures)


def fill(element, body):
    for joint in body["joints"]:
        element.add_joint(**{**joint, "type": JOINTS[joint["type"]]})
    for site in body["sites"]:
        element.add_site(**site)
    for geom in body["geoms"]:
        element.add_geom(**{**geom, "type": GEOMS[geom["type"]]})
    for child in body["bodies"]:
        fill(element.add_body(name=child["name"], pos=child["pos"], quat=child["quat"]), child)
    for thing, pos, quat in body["attached"]:
        child = build(thing)
        frame = element.add_frame(pos=pos, quat=quat)
        frame.attach_body(child.body(thing["name"]), f"{thing['name']}_", "")


def build(thing):
    spec = mujoco.MjSpec()
    spec.modelname = thing["name"]
    spec.compiler.degree = False
    add_materials(spec, thing)
    fill(spec.worldbody.add_body(name=thing["name"]), thing["root"])
    return spec


def compiled(name):
    return build(objects.TREES[name]()).compile()


def text(name):
    spec = build(objects.TREES[name]())
    spec.compile()
    return spec.to_xml()


serve({"load": compiled, "text": text}, compiled=compiled)
