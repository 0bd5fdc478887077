"""Families: variants with the same elements but different numbers, for engines that step many
worlds.
"""

from __future__ import annotations

import os
from typing import TYPE_CHECKING, Any, Callable, Mapping, Optional, Sequence, Union

if TYPE_CHECKING:
    from mujoco import MjModel, MjSpec  # type: ignore[import-not-found, import-untyped, unused-ignore]

    from ._family_file import FamilyFile

Prefix = Union[str, Sequence[str]]
Rows = Any  # whole numbers: a list, or an array of NumPy


class Family:
    """Variants of a spec with the same elements but different numbers, for many parallel worlds.

    >>> hammers = mjforge.load_family("hammers.npz")  # doctest: +SKIP
    >>> scene.attach(hammers.base, prefix="hammer/", frame=scene.worldbody.add_frame())  # doctest: +SKIP
    >>> model = scene.compile()  # doctest: +SKIP
    >>> fields = hammers.fields(model, "hammer/")  # doctest: +SKIP
    >>> fields["geom_size"].shape  # doctest: +SKIP
    (64, 11, 3)

    Methods take the compiled scene, the prefix with which the base was attached, and `rows`: the
    variant of each world, as positions in `index`. Without `rows`, there is one world for each
    variant.
    """

    def __init__(self, file: FamilyFile) -> None:
        self._file = file
        self._model: Any = None

    @property
    def path(self) -> "os.PathLike[str]":
        """Path of the family's file."""
        return self._file.path

    @property
    def base(self) -> MjSpec:
        """A new MjSpec of the object, which can be changed or attached to a scene. If meshes differ
        between variants, the MjSpec has the meshes of all variants, and `fields` selects the mesh
        of each world (`geom_dataid`). The MjSpec has no keyframe; see `start`.
        """
        from ._family_base import spec_of

        return spec_of(self._file)

    @property
    def arrays(self) -> dict[str, Any]:
        """Arrays of the file, with one row for each variant: the numbers that differ between
        variants, by field of mjModel and in the order of `names`; the start state; mass, bounds and
        offsets.
        """
        return self._file.arrays()

    @property
    def names(self) -> dict[str, list[str]]:
        """Names of the elements in each of the arrays. The name of a joint is repeated for each
        number of the joint.
        """
        return {name: self._file.members[f"{name}.names"].tolist() for name in self._file.fields()}

    @property
    def parameters(self) -> dict[str, Any]:
        """Values of the spec's parameters, with one row for each variant. Lists are padded, as in
        the file.
        """
        import numpy as np

        constants = {name: np.broadcast_to(value, (len(self), *value.shape))
                     for name, value in self._file.columns("constants/").items()}
        return {**self._file.columns("params/"), **constants}

    @property
    def index(self) -> Any:
        """Index of each variant in its batch."""
        return self._file.members["index"]

    @property
    def facts(self) -> Mapping[str, Any]:
        """Facts in the file: name, seed, settings, version."""
        return self._file.facts

    def table(self, frame: Optional[bool] = None) -> Any:
        """Returns a table of index, parameters, mass and bounds of the variants, with the columns
        of Variants.table, which documents `frame`.
        """
        from ._family_table import table_of

        return table_of(self._file, self.parameters, frame)

    def fields(self, model: MjModel, prefix: Prefix = "", rows: Rows = None, *,
               over: Optional[Mapping[str, Any]] = None) -> dict[str, Any]:
        """Returns the numbers of a scene's model in each world: arrays [worlds, ...] by field of
        mjModel.

        `model`: the compiled scene. `prefix`: the prefix of the object's names, or a list of
        prefixes if the scene contains the object several times. `rows`: the variant of each world;
        for several objects an array [worlds, objects]. `over`: the result of another family for the
        same scene; the numbers of this family are added to a copy.

        The result contains all fields in which worlds may differ, including fields that MuJoCo
        derives from others (`body_subtreemass`, `geom_rbound`). The keys "opt.timestep" and
        "stat.meaninertia" are members of `model.opt` and `model.stat`. Raises ValueError if the
        object is not in the scene.
        """
        from ._family_fields import fields_of

        return fields_of(self, model, prefix, rows, over)

    def start(self, model: MjModel, prefix: Prefix = "", rows: Rows = None, *,
              over: Optional[Mapping[str, Any]] = None) -> dict[str, Any]:
        """Returns the start state of each world: the arrays qpos, qvel, act, ctrl, mocap_pos and
        mocap_quat, except those that are empty for the model.

        The object keeps its place in the scene, and its joints are at their start positions;
        everything else is at its default. The arguments are those of `fields`, except that `over`
        is the result of another `start`.
        """
        from ._family_start import start_of

        return start_of(self, model, prefix, rows, over)

    def to_model(self, model: MjModel, prefix: Prefix = "", row: int = 0) -> MjModel:
        """Returns a copy of the scene's model with the numbers of one variant, for MuJoCo itself.
        """
        from ._family_fields import model_of

        return model_of(self, model, prefix, row)

    def to_warp(self, m: Any, model: MjModel, prefix: Prefix = "", rows: Rows = None, *,
                over: Optional[Mapping[str, Any]] = None, worlds: Rows = None) -> None:
        """Gives each world of MuJoCo Warp the numbers of its variant.

        `m`: the result of mujoco_warp.put_model(model), whose fields become arrays with one row for
        each world. `worlds`: a list as long as `rows`; only these worlds get other variants, in
        place, for example at a reset. The other arguments are those of `fields`. Raises ValueError
        for differences that Warp does not support: poses of geoms that are fixed to the world (make
        the family with --mocap), and fields that all worlds share.
        """
        from ._to_warp import to_warp

        to_warp(self, m, model, prefix, rows, over, worlds)

    def to_batch(self, batch: Any, prefix: Prefix = "", rows: Rows = None, *,
                 over: Optional[Mapping[str, Any]] = None, worlds: Rows = None) -> None:
        """Gives each simulation of a mujoco.batch.Batch the numbers of its variant, one row for
        each simulation. See `to_warp`.
        """
        from ._to_batch import to_batch

        to_batch(self, batch, prefix, rows, over, worlds)

    def to_mjx(self, model: MjModel, prefix: Prefix = "", rows: Rows = None, *,
               over: Optional[Mapping[str, Any]] = None) -> "tuple[dict[str, Any], Any]":
        """Returns the numbers of each world for MJX (its implementation in JAX): a dict of arrays,
        and axes for jax.vmap.

        >>> numbers, axes = hammers.to_mjx(model, "hammer/")  # doctest: +SKIP
        >>> worlds = mjx.put_model(model).tree_replace(numbers)  # doctest: +SKIP
        >>> step = jax.jit(jax.vmap(mjx.step, in_axes=(axes, 0)))  # doctest: +SKIP

        The arguments are those of `fields`. The meshes of a colliding geom must have convex hulls
        with the same faces in all variants, as with `--target mjx`. Raises ValueError if the faces
        differ, or if a field differs that MJX shares between worlds. Fields that MJX does not read,
        such as `mat_rgba` of a renderer, are left unchanged.
        """
        from ._to_mjx import replacements

        return replacements(model, self.fields(model, prefix, rows, over=over))

    def to_mjlab(self, name: str, mode: str = "startup", rows: "Optional[Callable[[Any, Any], Any]]" = None,
                 ) -> "tuple[Any, Any]":
        """Returns an entity of mjlab (EntityCfg), and an event (EventTermCfg) that gives
        environments their variants.

        `name`: name of the entity in SceneCfg.entities. `mode`: with "startup", environments get
        the variants in turn; with "reset", an environment gets a random variant at each of its
        resets. `rows`: a function that selects the variants instead. It is called with the
        environment and a tensor of ids, and returns a row of the family for each id. The event has
        an attribute `rows`: the present row of each environment.
        """
        from ._to_mjlab import entity_and_event

        return entity_and_event(self, name, mode, rows)

    def to_newton(self, builder: Any, rows: Rows = None, **options: Any) -> None:
        """Adds worlds to a newton.ModelBuilder, each with the variant of its row.

        Imports MJCF of each variant by `add_mjcf`, which gets the options, so that all of Newton's
        solvers use the numbers of the variant. Without `rows`, there is one world for each variant.
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
        """Returns the compiled base, without the meshes of single variants."""
        from ._family_base import compiled

        if self._model is None:
            self._model = compiled(self._file)
        return self._model


def load_family(path: "Union[str, os.PathLike[str]]") -> Family:
    """Reads a family, which `mjforge generate SPEC -n 4096 -o NAME.npz` wrote.

    Raises FileNotFoundError if the file does not exist, ValueError if it is not a family, was cut
    short or was changed, and ImportError if NumPy is not installed.

    >>> report = mjforge.Spec("robosuite/hammer").variants().write("hammers.npz", 64)  # doctest: +SKIP
    >>> mjforge.load_family("hammers.npz").parameters["handle_length"].shape  # doctest: +SKIP
    (64,)
    """
    from ._family_file import FamilyFile  # keeps the import of the package short

    return Family(FamilyFile(path))
