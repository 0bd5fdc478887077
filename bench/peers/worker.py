"""A peer in a process of its own, which lives as long as the benchmark: what it
imports and what it compiles at first use is not measured.

Reads requests, one JSON object a line, and answers each with one:
    {"row": ROW, "object": OBJECT, "count": N}  ->  {"cpu": us, "wall": us} for each object
    {"geoms": OBJECT} or {"file": XML}          ->  {"geoms": {"box collides": 5, ...}}
"""

import collections
import json
import sys
import time

import mujoco


def geoms_of(model):
    """How many geoms of each type, those that collide and those that only show."""
    count = collections.Counter()
    for geom in range(model.ngeom):
        kind = mujoco.mjtGeom(model.geom_type[geom]).name.removeprefix("mjGEOM_").lower()
        collides = model.geom_contype[geom] or model.geom_conaffinity[geom]
        count[f"{kind} {'collides' if collides else 'shows'}"] += 1
    return dict(sorted(count.items()))


def measure(action, count):
    start, cpu = time.perf_counter(), time.process_time()
    for _ in range(count):
        action()
    cpu, wall = time.process_time() - cpu, time.perf_counter() - start
    return {"cpu": cpu / count * 1e6, "wall": wall / count * 1e6}


def answer(request, rows, compiled):
    if "file" in request:
        return {"geoms": geoms_of(mujoco.MjModel.from_xml_path(request["file"]))}
    if "geoms" in request:
        return {"geoms": geoms_of(compiled(request["geoms"]))}
    action = rows[request["row"]]
    name = request["object"]
    return measure(lambda: action(name), request["count"])


def answer_all(answer, rows=()):
    """Answers each request by a function of it."""
    # Whatever a library prints must not come between the answers.
    answers, sys.stdout = sys.stdout, sys.stderr
    print(json.dumps({"rows": list(rows)}), file=answers, flush=True)
    for line in sys.stdin:
        print(json.dumps(answer(json.loads(line))), file=answers, flush=True)


def serve(rows, compiled):
    """`rows`: by name, what makes an object; `compiled`: the same object's MjModel."""
    answer_all(lambda request: answer(request, rows, compiled), rows)
