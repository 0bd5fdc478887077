"""dm_control's PyMJCF: the same trees element by element; what is nested is a
model of its own, attached at a site."""

import mujoco
from dm_control import mjcf

import objects
from worker import serve


def fill(element, body):
    for joint in body["joints"]:
        element.add("joint", **joint)
    for site in body["sites"]:
        element.add("site", **site)
    for geom in body["geoms"]:
        element.add("geom", **geom)
    for child in body["bodies"]:
        fill(element.add("body", name=child["name"], pos=child["pos"], quat=child["quat"]), child)
    for thing, pos, quat in body["attached"]:
        site = element.add("site", name=thing["name"], pos=pos, quat=quat)
        site.attach(attachment(thing))


def model(thing):
    root = mjcf.RootElement(model=thing["name"])
    root.compiler.angle = "radian"
    for material in thing["materials"]:
        grain = [material["grain"]] * 3
        texture = root.asset.add("texture", name=material["name"], type="cube", builtin="flat",
                                 rgb1=[1, 1, 1], mark="random", random=0.3, markrgb=grain,
                                 width=16, height=16)
        root.asset.add("material", name=material["name"], texture=texture, rgba=material["rgba"],
                       specular=material["specular"], shininess=material["shininess"],
                       texrepeat=[3, 3])
    return root


def attachment(thing):
    root = model(thing)
    fill(root.worldbody, thing["root"])  # attaching makes the body
    return root


def build(name):
    thing = objects.TREES[name]()
    root = model(thing)
    fill(root.worldbody.add("body", name=thing["name"]), thing["root"])
    return root


def load(name):
    root = build(name)
    return mujoco.MjModel.from_xml_string(root.to_xml_string(), root.get_assets())


serve({"text": lambda name: build(name).to_xml_string(), "load": load}, compiled=load)
