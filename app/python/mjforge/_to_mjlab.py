"""A family in mjlab: an entity, and an event that gives environments their variants."""

from __future__ import annotations

import importlib.metadata
from typing import TYPE_CHECKING, Any, Callable, Optional

from ._options import function, text
from ._packages import needed
from ._to_warp import changes_of

if TYPE_CHECKING:
    from ._family import Family

# First release of mujoco-warp in which worlds of scissors move like each variant alone. In 3.11,
# the scissors touch the floor too early.
_EXACT = (3, 17)
Choice = Callable[[Any, Any], Any]  # (environment, ids of worlds) -> rows of the family


def entity_and_event(family: Family, name: str, mode: str, rows: Optional[Choice]) -> tuple[Any, Any]:
    """See Family.to_mjlab."""
    name = text(name, "name")
    if not isinstance(mode, str) or mode not in ("startup", "reset"):
        raise ValueError(f"mode={mode!r} is not 'startup' or 'reset'")
    if rows is not None:
        function(rows, "rows")
    entity, managers = needed("mjlab.entity", "mjlab"), needed("mjlab.managers", "mjlab")
    choose = rows or (_in_turn(family) if mode == "startup" else _at_random(family))
    term = _term_of(family, f"{name}/", choose)
    return entity.EntityCfg(spec_fn=lambda: family.base), managers.EventTermCfg(func=term, mode=mode)


def _in_turn(family: Family) -> Choice:
    return lambda env, worlds: worlds % len(family)


def _at_random(family: Family) -> Choice:
    torch = needed("torch", "mjlab")

    return lambda env, worlds: torch.randint(len(family), worlds.shape, device=worlds.device)


def _term_of(family: Family, prefix: str, choose: Choice) -> type:
    """Returns a class for EventTermCfg; mjlab makes an instance of the class for each environment.
    """
    torch = needed("torch", "mjlab")

    class Variants:
        """Event that gives worlds their variants; `rows` has the variant of each world."""

        def __init__(self, cfg: Any, env: Any) -> None:
            self.rows = torch.full((env.num_envs,), -1, dtype=torch.long, device=env.device)
            self._columns = dict(_columns_of(family, prefix, env))
            self.model_fields = tuple(self._columns)  # mjlab gives them a row per world

        def __call__(self, env: Any, env_ids: Any) -> None:
            worlds = torch.arange(env.num_envs, device=env.device)[slice(None) if env_ids is None else env_ids]
            rows = torch.as_tensor(choose(env, worlds), dtype=torch.long, device=env.device)
            if rows.shape != worlds.shape or not ((rows >= 0) & (rows < len(family))).all():
                raise ValueError(f"rows: {rows.tolist()} are not {len(worlds)} rows of the {len(family)} in "
                                 f"'{family.path}'")
            self.rows[worlds] = rows
            for field, (elements, values) in self._columns.items():
                getattr(env.sim.model, field)[worlds[:, None], elements] = values[rows]

    return Variants


def _columns_of(family: Family, prefix: str, env: Any) -> "list[tuple[str, tuple[Any, Any]]]":
    """Returns the fields that differ between variants, with the ids of the elements that differ and
    their numbers in each variant. Other elements belong to other objects.
    """
    import numpy as np
    torch = needed("torch", "mjlab")

    model, m = env.sim.mj_model, env.sim.wp_model
    columns = []
    for holder, name, values in changes_of(m, family.fields(model, prefix), model):
        if holder is not m:
            if holder is m.opt:
                raise ValueError(f"opt.{name} differs between the variants, and mjlab has it once for all worlds")
            continue  # skips statistics, by which solvers scale their tolerance
        differs = (values != getattr(m, name).numpy()[:1]).any(axis=tuple(i for i in range(values.ndim) if i != 1))
        elements = np.flatnonzero(differs)
        if name == "geom_dataid":
            _expect_exact_meshes(model, elements)
        if len(elements):
            columns.append((name, (torch.as_tensor(elements, device=env.device),
                                   torch.as_tensor(values[:, elements], device=env.device))))
    return columns


def _expect_exact_meshes(model: Any, geoms: Any) -> None:
    """Raises ValueError if a geom that collides has different meshes and this release of
    mujoco-warp computes wrong contacts for such geoms.
    """
    version = importlib.metadata.version("mujoco-warp")
    collides = geoms[(model.geom_contype[geoms] | model.geom_conaffinity[geoms]) != 0]
    if len(collides) and tuple(map(int, version.split(".")[:2])) < _EXACT:
        raise ValueError(f"the mesh of geom '{model.geom(collides[0]).name}' differs between the variants, and "
                         f"mujoco-warp {version} collides such geoms wrongly; 3.17 does not")
