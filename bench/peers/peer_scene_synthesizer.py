"""scene_synthesizer: places the objects of a file, each as one mesh of all that collides of it.

Reads requests, one JSON object a line, and answers each with one:
    {"scene": XML, "objects": XML, "seed": N}  ->  {"cpu": ms, "poses": {NAME: [pos, quat] or null}}
    {"settle": XML}                            ->  {"rest": NUMBER}
The support of the scene is given to it, and the objects of the other file.
"""

import logging
import time

logging.disable(logging.WARNING)

import mujoco
import numpy as np
import scene_synthesizer as synth
import trimesh

from worker import answer_all

ROOT = "scene"
SECONDS = 2
MOVED, TURNED = 2e-3, np.radians(2)  # m, rad; what moves or turns more does not rest
CAPSULE_SECTIONS = [16, 16]


def shape_of(model, geom):
    """A geom as a mesh in its own frame."""
    kind, size = model.geom_type[geom], model.geom_size[geom]
    if kind == mujoco.mjtGeom.mjGEOM_BOX:
        return trimesh.creation.box(extents=2 * size)
    if kind == mujoco.mjtGeom.mjGEOM_CYLINDER:
        return trimesh.creation.cylinder(radius=size[0], height=2 * size[1])
    if kind == mujoco.mjtGeom.mjGEOM_CAPSULE:
        return trimesh.creation.capsule(radius=size[0], height=2 * size[1], count=CAPSULE_SECTIONS)
    mesh = model.geom_dataid[geom]
    vertices, faces = model.mesh_vertadr[mesh], model.mesh_faceadr[mesh]
    return trimesh.Trimesh(model.mesh_vert[vertices:vertices + model.mesh_vertnum[mesh]],
                           model.mesh_face[faces:faces + model.mesh_facenum[mesh]])


def meshes_of(model, body):
    """What collides of a body, by name, in its frame."""
    meshes = {}
    for geom in np.flatnonzero((model.geom_bodyid == body) & (model.geom_contype != 0)):
        rotation, pose = np.zeros(9), np.eye(4)
        mujoco.mju_quat2Mat(rotation, model.geom_quat[geom])
        pose[:3, :3], pose[:3, 3] = rotation.reshape(3, 3), model.geom_pos[geom]
        meshes[model.geom(geom).name] = shape_of(model, geom).apply_transform(pose)
    return meshes


def asset(meshes, **options):
    scene = trimesh.Scene()
    for name, mesh in meshes.items():
        scene.add_geometry(mesh, node_name=name, geom_name=name)
    return synth.assets.TrimeshSceneAsset(scene, **options)


def objects_of(model):
    """By name, in the order of the file. One mesh of all convex pieces is placed up to five times
    as fast as the pieces."""
    objects = {}
    for body in range(1, model.nbody):
        if model.body(body).name == ROOT:
            continue
        mesh = trimesh.util.concatenate(list(meshes_of(model, body).values()))
        origin = ("center", "center", "bottom")
        objects[model.body(body).name] = asset({"mesh": mesh}, origin=origin)
    return objects


def place(support, objects, seed):
    scene = synth.Scene(seed=seed)
    scene.add_object(support, "support")
    scene.label_support("boards", obj_ids="support", geom_ids=".*board_.*")
    placed = {name for name, thing in objects.items()
              if scene.place_object(name, thing, support_id="boards")}
    return scene, placed


def pose_in(scene, name):
    """Of an object's frame in its file, which is that of its mesh."""
    matrix = scene.graph.get(f"{name}/mesh")[0]
    quat = np.zeros(4)
    mujoco.mju_mat2Quat(quat, np.ascontiguousarray(matrix[:3, :3]).ravel())
    return [matrix[:3, 3].tolist(), quat.tolist()]


def answer_scene(request):
    model = mujoco.MjModel.from_xml_path(request["scene"])
    support = asset(meshes_of(model, model.body(ROOT).id))
    objects = objects_of(mujoco.MjModel.from_xml_path(request["objects"]))
    start = time.process_time()
    scene, placed = place(support, objects, request["seed"])
    cpu = time.process_time() - start
    return {"cpu": 1e3 * cpu,
            "poses": {name: pose_in(scene, name) if name in placed else None for name in objects}}


def settle(file):
    """How many of a file's free bodies are where they were, after a while."""
    model = mujoco.MjModel.from_xml_path(file)
    data = mujoco.MjData(model)
    mujoco.mj_kinematics(model, data)
    pos, quat = data.xpos.copy(), data.xquat.copy()
    while data.time < SECONDS:
        mujoco.mj_step(model, data)
    mujoco.mj_kinematics(model, data)
    moved = np.linalg.norm(data.xpos - pos, axis=1)
    turned = 2 * np.arccos(np.minimum(np.abs(np.sum(data.xquat * quat, axis=1)), 1))
    rest = (moved <= MOVED) & (turned <= TURNED) & (model.body_dofnum == 6)
    return {"rest": int(rest.sum())}


answer_all(lambda request: settle(request["settle"]) if "settle" in request
           else answer_scene(request))
