"""Families: objects of one structure whose numbers differ, for engines that step many worlds."""

from __future__ import annotations

import os
from typing import TYPE_CHECKING, Any, Callable, Mapping, Optional, Sequence, Union

if TYPE_CHECKING:
    from mujoco import MjModel, MjSpec  # type: ignore[import-not-found, import-untyped, unused-ignore]

    from ._family_file import FamilyFile

Prefix = Union[str, Sequence[str]]
Rows = Any  # whole numbers: a list, or an array of NumPy


class Family:
    """Objects of one structure, whose numbers differ: variants in rows, for many worlds.

    >>> hammers = mjforge.load_family("hammers.npz")  # doctest: +SKIP
    >>> scene.attach(hammers.base, prefix="hammer/", frame=scene.worldbody.add_frame())  # doctest: +SKIP
    >>> model = scene.compile()  # doctest: +SKIP
    >>> fields = hammers.fields(model, "hammer/")  # doctest: +SKIP
    >>> fields["geom_size"].shape  # doctest: +SKIP
    (64, 11, 3)

    Its methods take the compiled scene, the prefix with which the base was attached, and `rows`: the
    variant of each world, as positions in `index`. Without rows, each variant has a world.
    """

    def __init__(self, file: FamilyFile) -> None:
        self._file = file
        self._model: Any = None

    @property
    def path(self) -> "os.PathLike[str]":
        """The file."""
        return self._file.path

    @property
    def base(self) -> MjSpec:
        """A new MjSpec of the object, to be changed or attached to a scene. If meshes differ between variants,
        it has those of all variants, from which `fields` chooses (`geom_dataid`). It has no keyframe: see `start`.
        """
        from ._family_base import spec_of

        return spec_of(self._file)

    @property
    def arrays(self) -> dict[str, Any]:
        """The arrays of the file, a row for each variant: the numbers that differ, by field of mjModel, in the
        order of `names`; the start state; mass, bounds and offsets.
        """
        return self._file.arrays()

    @property
    def names(self) -> dict[str, list[str]]:
        """Names of the elements in each of the arrays; a joint once for each of its numbers."""
        return {name: self._file.members[f"{name}.names"].tolist() for name in self._file.fields()}

    @property
    def parameters(self) -> dict[str, Any]:
        """The parameters of the spec, a row for each variant; lists are filled up as in the file."""
        import numpy as np

        constants = {name: np.broadcast_to(value, (len(self), *value.shape))
                     for name, value in self._file.columns("constants/").items()}
        return {**self._file.columns("params/"), **constants}

    @property
    def index(self) -> Any:
        """The index of each variant in its batch."""
        return self._file.members["index"]

    @property
    def facts(self) -> Mapping[str, Any]:
        """The facts in the file: name, seed, settings, version."""
        return self._file.facts

    def table(self, frame: Optional[bool] = None) -> Any:
        """A table of index, parameters, mass and bounds with the columns of Variants.table, which describes `frame`."""
        from ._family_table import table_of

        return table_of(self._file, self.parameters, frame)

    def fields(self, model: MjModel, prefix: Prefix = "", rows: Rows = None, *,
               over: Optional[Mapping[str, Any]] = None) -> dict[str, Any]:
        """The numbers of a scene's model in each world: arrays [worlds, ...] by field of mjModel.

        `model`: the compiled scene. `prefix`: that of the object, or a list of prefixes if the scene has it
        several times. `rows`: the variant of each world, for several objects [worlds, objects]. `over`: the
        result of another family for the same scene, whose numbers worlds keep.

        The result has all fields in which worlds may differ, also those that MuJoCo derives from others
        (`body_subtreemass`, `geom_rbound`). "opt.timestep" and "stat.meaninertia" are members of
        `model.opt` and `model.stat`. Raises ValueError if the object is not in the scene.
        """
        from ._family_fields import fields_of

        return fields_of(self, model, prefix, rows, over)

    def start(self, model: MjModel, prefix: Prefix = "", rows: Rows = None, *,
              over: Optional[Mapping[str, Any]] = None) -> dict[str, Any]:
        """The start state of each world: those of the arrays qpos, qvel, act, ctrl, mocap_pos and mocap_quat that
        the model has numbers for.

        The object is where it stands in the scene, and its joints are at their start; everything else is at
        its default. The arguments are those of `fields`, and `over` is the result of another `start`.
        """
        from ._family_start import start_of

        return start_of(self, model, prefix, rows, over)

    def to_model(self, model: MjModel, prefix: Prefix = "", row: int = 0) -> MjModel:
        """A copy of the scene's model with the numbers of one variant, for MuJoCo itself."""
        from ._family_fields import model_of

        return model_of(self, model, prefix, row)

    def to_warp(self, m: Any, model: MjModel, prefix: Prefix = "", rows: Rows = None, *,
                over: Optional[Mapping[str, Any]] = None, worlds: Rows = None) -> None:
        """Gives the worlds of MuJoCo Warp their variants.

        `m`: mujoco_warp.put_model(model), which gets arrays with a row for each world; the other arguments are those
        of `fields`. With `worlds`, a list as long as `rows`, these worlds get other variants, in place, at a reset.
        Raises ValueError for a difference that Warp cannot have: poses of geoms that are fixed to the world (make the
        family with --mocap), and fields that worlds share.
        """
        from ._to_warp import to_warp

        to_warp(self, m, model, prefix, rows, over, worlds)

    def to_batch(self, batch: Any, prefix: Prefix = "", rows: Rows = None, *,
                 over: Optional[Mapping[str, Any]] = None, worlds: Rows = None) -> None:
        """Gives the simulations of a mujoco.batch.Batch their variants; a row for each. See `to_warp`."""
        from ._to_batch import to_batch

        to_batch(self, batch, prefix, rows, over, worlds)

    def to_mjx(self, model: MjModel, prefix: Prefix = "", rows: Rows = None, *,
               over: Optional[Mapping[str, Any]] = None) -> "tuple[dict[str, Any], Any]":
        """The numbers of each world for MJX (its implementation in JAX): a dict, and axes for jax.vmap.

        >>> numbers, axes = hammers.to_mjx(model, "hammer/")  # doctest: +SKIP
        >>> worlds = mjx.put_model(model).tree_replace(numbers)  # doctest: +SKIP
        >>> step = jax.jit(jax.vmap(mjx.step, in_axes=(axes, 0)))  # doctest: +SKIP

        The arguments are those of `fields`. Meshes that collide must have convex hulls with the same faces, as those
        of `--target mjx` have. Raises ValueError for this, and for a field that MJX has once for all worlds. Looks
        that MJX does not read (such as `mat_rgba` of a renderer) are left as they are.
        """
        from ._to_mjx import replacements

        return replacements(model, self.fields(model, prefix, rows, over=over))

    def to_mjlab(self, name: str, mode: str = "startup", rows: "Optional[Callable[[Any, Any], Any]]" = None,
                 ) -> "tuple[Any, Any]":
        """An entity of mjlab (EntityCfg), and the event (EventTermCfg) that gives environments their variants.

        `name` is that of the entity in SceneCfg.entities. `mode`: "startup" gives each environment a variant in
        turn, "reset" another one, drawn at random, at each of its resets. `rows` chooses otherwise: it is called with
        the environment and a tensor of ids, and returns a row of the family for each. An event has an attribute
        `rows`: the rows that environments have now.
        """
        from ._to_mjlab import entity_and_event

        return entity_and_event(self, name, mode, rows)

    def to_newton(self, builder: Any, rows: Rows = None, **options: Any) -> None:
        """Adds worlds to a newton.ModelBuilder, each with the variant of its row.

        Each world is imported with `add_mjcf`, which gets the options, from MJCF of its variant, so that all of
        Newton's solvers have its numbers. Without rows, each variant has a world.
        """
        from ._to_newton import add_worlds

        add_worlds(self, builder, rows, options)

    def __len__(self) -> int:
        return self._file.count

    def __repr__(self) -> str:
        return f"<mjforge.Family {str(self._file.path)!r}: {len(self)} of {self.facts.get('name')}>"

    def __getstate__(self) -> dict[str, Any]:
        return {**self.__dict__, "_model": None}

    def _compiled(self) -> MjModel:
        """The compiled base, without the meshes of variants."""
        from ._family_base import compiled

        if self._model is None:
            self._model = compiled(self._file)
        return self._model


def load_family(path: "Union[str, os.PathLike[str]]") -> Family:
    """Reads a family, which `mjforge generate SPEC -n 4096 -o NAME.npz` wrote.

    Raises FileNotFoundError without the file, ValueError if it is not a family, was cut short or changed,
    ImportError without NumPy.
    """
    from ._family_file import FamilyFile  # keeps the import of the package short

    return Family(FamilyFile(path))
