"""The five objects as plain numbers, drawn from the ranges of mjforge's bundled
specs: what a peer's user computes before any library is called.

A draw is the keyword arguments of robosuite's class; a tree is the whole object,
as nested dictionaries whose keys are MJCF's words.
"""

import colorsys
from math import cos, pi, sin
from random import uniform

FRICTION = [1, 0.005, 0.0001]
QUARTER = 0.5 ** 0.5  # of a right angle's quaternion
RING_SEGMENTS = 50
WRENCH_SEGMENTS = 8


def hsv(hue, saturation, value):
    return [*colorsys.hsv_to_rgb(uniform(*hue), uniform(*saturation), uniform(*value)), 1]


def draw_pot():
    x, y, z = uniform(0.06, 0.09), uniform(0.06, 0.09), uniform(0.05, 0.08)
    while True:
        radius, width = uniform(0.008, 0.012), uniform(0.07, 0.1)
        if width / 2 + radius <= x:
            break
    return {"body_half_size": [x, y, z], "handle_radius": radius,
            "handle_length": uniform(0.06, 0.09), "handle_width": width,
            "thickness": uniform(0.006, 0.012)}


def draw_hinged_box():
    x, y, z = uniform(0.03, 0.05), uniform(0.025, 0.04), uniform(0.02, 0.035)
    return {"box1_size": [x, y, z], "box2_size": [x, y, uniform(0.3 * z, 0.6 * z)]}


def draw_wrench():
    draw = {"handle_size": [uniform(0.07, 0.1), uniform(0.008, 0.011), uniform(0.004, 0.006)],
            "grip_size": [uniform(0.012, 0.015), uniform(0.03, 0.05)],
            "ngeoms": WRENCH_SEGMENTS}
    for i in (1, 2):
        radius = uniform(0.022, 0.032)
        draw[f"outer_radius_{i}"] = radius
        draw[f"inner_radius_{i}"] = uniform(0.5, 0.65) * radius
        draw[f"height_{i}"] = uniform(0.008, 0.015)  # half of it
    return draw


def draw_ring():
    radius = uniform(0.03, 0.05)
    return {"outer_radius": radius, "inner_radius": uniform(0.5, 0.8) * radius,
            "height": uniform(0.01, 0.05), "ngeoms": RING_SEGMENTS}  # half of the height


def body(name, pos=(0, 0, 0), quat=(1, 0, 0, 0), joints=(), sites=(), geoms=(), bodies=()):
    return {"name": name, "pos": pos, "quat": quat, "joints": list(joints), "sites": list(sites),
            "geoms": list(geoms), "bodies": list(bodies), "attached": []}


def site(name, pos=(0, 0, 0), size=0.005, rgba=(1, 0, 0, 1), quat=(1, 0, 0, 0)):
    return {"name": name, "pos": pos, "size": [size] * 3, "rgba": rgba, "quat": quat}


def both(name, type, size, material, density, pos=(0, 0, 0), quat=(1, 0, 0, 0), friction=FRICTION,
         **more):
    """A geom that collides and its visual twin."""
    shape = {"type": type, "size": size, "pos": pos, "quat": quat}
    return [{"name": name, "density": density, "friction": friction, "group": 3,
             "rgba": [0.5, 0, 0, 1], **shape, **more},
            {"name": name + "_vis", "contype": 0, "conaffinity": 0, "mass": 0, "group": 2,
             "material": material, **shape}]


def material(name, rgba, specular, shininess, grain=0.75):
    """With a texture of the same name."""
    return {"name": name, "rgba": rgba, "specular": specular, "shininess": shininess,
            "grain": grain}


FREE = {"name": "joint0", "type": "free"}


def hammer():
    radius, length = uniform(0.015, 0.02), uniform(0.1, 0.25)
    density, head = uniform(100, 250), uniform(radius, 1.2 * radius)
    z = length / 2 + head
    metal = hsv((0.6, 0.6), (0.04, 0.04), (0.35, 0.6))
    sideways = [QUARTER, 0, QUARTER, 0]
    geoms = (
        both("handle", "box", [radius, radius, length / 2], "wood", density,
             friction=[uniform(3, 5), 0.005, 0.0001])
        + both("head", "box", [2 * head, head, head], "head_metal", 2 * density, [0, 0, z])
        + both("neck", "cylinder", [0.8 * head, 0.2 * head, 0], "face_metal", 2 * density,
               [2.2 * head, 0, z], sideways)
        + both("face", "cylinder", [head, 0.4 * head, 0], "face_metal", 2 * density,
               [2.8 * head, 0, z], sideways)
        + both("claw", "box", [0.7072 * head, 0.95 * head, 0.7072 * head], "claw_metal",
               2 * density, [-2 * head, 0, z], [cos(pi / 8), 0, sin(pi / 8), 0]))
    return {
        "name": "hammer",
        "materials": [
            material("wood", hsv((0.06, 0.09), (0.45, 0.65), (0.5, 0.8)), 0.2, 0.2),
            material("head_metal", metal, 0.6, 0.4),
            material("face_metal", hsv((0.6, 0.6), (0.03, 0.03), (0.6, 0.75)), 0.7, 0.6),
            material("claw_metal", metal, 0.6, 0.4)],
        "root": body("hammer", joints=[FREE], geoms=geoms, sites=[
            site("grasp", [0, 0, -length / 8], rgba=[0, 1, 0, 1]),
            site("strike", [3.2 * head, 0, z], quat=sideways)])}


def pot():
    draw = draw_pot()
    (x, y, z), radius = draw["body_half_size"], draw["handle_radius"]
    length, width, wall = draw["handle_length"], draw["handle_width"], draw["thickness"]
    grip_y, grip_z = y + length, z - radius
    geoms = both("base", "box", [x, y, wall / 2], "enamel", 1000, [0, 0, wall / 2 - z])
    for i, side in enumerate((-1, 1)):
        geoms += both(f"body{2 * i}", "box", [wall / 2, x, z], "enamel", 1000,
                      [0, side * (y - wall / 2), 0], [QUARTER, 0, 0, -side * QUARTER])
        geoms += both(f"body{2 * i + 1}", "box", [wall / 2, y, z], "enamel", 1000,
                      [side * (x - wall / 2), 0, 0], [0, 0, 0, 1] if i else [1, 0, 0, 0])
    for i, side in enumerate((1, -1)):
        geoms += both(f"handle{i}_c", "box", [width / 2 + radius, radius, radius], f"handle{i}",
                      1000, [0, side * grip_y, grip_z])
        for arm in range(2):
            geoms += both(f"handle{i}_arm{arm}", "box", [radius, length / 2, radius],
                          f"handle{i}", 1000,
                          [(arm - 0.5) * width, side * (y + length / 2), grip_z])
    green, blue = [0.2, 0.55, 0.25, 1], [0.2, 0.3, 0.65, 1]
    down = [0, 1, 0, 0]
    return {
        "name": "pot",
        "materials": [material("enamel", hsv((0, 1), (0.3, 0.7), (0.5, 0.85)), 0.5, 0.5, 0.8),
                      material("handle0", green, 0.2, 0.2, 0.8),
                      material("handle1", blue, 0.2, 0.2, 0.8)],
        "root": body("pot", joints=[FREE], geoms=geoms, sites=[
            site("grasp0", [0, grip_y, grip_z], rgba=[0, 1, 0, 1], quat=down),
            site("grasp1", [0, -grip_y, grip_z], rgba=[0, 1, 0, 1], quat=down),
            site("handle0", [0, grip_y - 0.005, grip_z], rgba=green),
            site("handle1", [0, 0.005 - grip_y, grip_z], rgba=blue),
            site("center")])}


def hinged_box():
    draw = draw_hinged_box()
    lower, lid = draw["box1_size"], draw["box2_size"]
    edge = [lid[0], 0, -lid[2]]
    pin = body("hinge", edge, [QUARTER, QUARTER, 0, 0], geoms=[
        {"name": "hinge_g0_vis", "type": "cylinder", "size": [lid[2] / 5, lid[1], 0],
         "contype": 0, "conaffinity": 0, "mass": 0, "rgba": [0.5, 0.5, 0, 1], "group": 2}])
    hinge = {"name": "box_hinge", "type": "hinge", "pos": edge, "axis": [0, 1, 0],
             "range": [0, uniform(pi / 2, 2 * pi / 3)], "stiffness": 0.0001,
             "damping": uniform(0.0005, 0.002), "frictionloss": uniform(0.0002, 0.001)}
    upper = body("box2", [lower[0] - lid[0], 0, lower[2] + lid[2] + uniform(0.0002, 0.0005)],
                 joints=[hinge], geoms=both("box2_g0", "box", lid, "wood2", 1000), bodies=[pin],
                 sites=[site("grasp", [-lid[0], 0, 0], rgba=[0, 1, 0, 1],
                             quat=[QUARTER, 0, QUARTER, 0])])
    base = body("box1", geoms=both("box1_g0", "box", lower, "wood1", 1000), bodies=[upper])
    return {
        "name": "hinged_box",
        "materials": [material("wood1", hsv((0, 0.08), (0.5, 0.75), (0.45, 0.7)), 0.2, 0.2),
                      material("wood2", hsv((0.55, 0.65), (0.4, 0.7), (0.4, 0.7)), 0.2, 0.2)],
        "root": body("hinged_box", joints=[FREE], bodies=[base])}


def hollow_cylinder(name, outer, inner, half_height, count, rgba, density):
    face = outer * cos(pi / count)
    middle = (face + inner) / 2
    size = [(face - inner) / 2, outer * sin(pi / count), half_height]
    geoms = []
    for i in range(count):
        angle = pi - 2 * pi * i / count
        geoms += both(f"hc_{i}", "box", size, "surface", density,
                      [middle * cos(angle), middle * sin(angle), 0],
                      [cos(angle / 2), 0, 0, sin(angle / 2)],
                      solref=[0.02, 1], solimp=[0.9, 0.95, 0.001, 0.5, 2], condim=4)
    return {"name": name, "materials": [material("surface", rgba, 0.4, 0.3, 0.8)],
            "root": body(name, geoms=geoms, sites=[site("center", size=0.002)])}


def plain_box(name, size, rgba, density):
    return {"name": name, "materials": [material("plain", rgba, 0.3, 0.3)],
            "root": body(name, geoms=both("g0", "box", size, "plain", density))}


def ring():
    draw = draw_ring()
    thing = hollow_cylinder("ring", draw["outer_radius"], draw["inner_radius"], draw["height"],
                            draw["ngeoms"], hsv((0, 1), (0.3, 0.8), (0.5, 0.9)), 1000)
    thing["root"]["joints"].append(FREE)
    return thing


def wrench():
    """Its four parts are objects of their own, attached."""
    draw = draw_wrench()
    rgba = hsv((0.6, 0.6), (0.03, 0.08), (0.55, 0.75))
    handle, (grip_radius, grip_length) = draw["handle_size"], draw["grip_size"]
    root = body("wrench", joints=[{**FREE, "damping": 0.0005}],
                sites=[site("grasp", rgba=[0, 1, 0, 1])])
    for i, side in ((1, -1), (2, 1)):
        outer, inner = draw[f"outer_radius_{i}"], draw[f"inner_radius_{i}"]
        sagitta = outer * (1 - cos(pi / WRENCH_SEGMENTS))
        part = hollow_cylinder(f"hole{i}", outer, inner, draw[f"height_{i}"], WRENCH_SEGMENTS, rgba,
                               7850)
        root["attached"].append((part, [side * (handle[0] + inner + sagitta), 0, 0], [1, 0, 0, 0]))
    root["attached"].append((plain_box("handle", handle, rgba, 7850), [0, 0, 0], [1, 0, 0, 0]))
    grip = plain_box("grip", [grip_radius, grip_radius, grip_length], [0.13, 0.13, 0.13, 1], 1100)
    root["attached"].append((grip, [0, 0, 0], [QUARTER, 0, QUARTER, 0]))
    return {"name": "wrench", "materials": [], "root": root}


TREES = {"hammer": hammer, "pot": pot, "hinged box": hinged_box, "wrench": wrench,
         "ring of 50": ring}
