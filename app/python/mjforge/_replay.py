"""Makes a variant again from its record, a line of a manifest."""

from __future__ import annotations

import os
import pathlib
from typing import Any, Iterator, Mapping, Optional, Union

from ._batch_files import OPTIONAL
from ._findings import MismatchError, SpecError, findings_of
from ._spec import Source, Spec
from ._variant import Variant
from ._yaml import RecordedText

# Options of variants(), each with the member of a record that has the option's value.
_OPTIONS = {"target": "target", "assets": "assets_as", "sampler": "sampler", "batch": "batch",
            "on_invalid": "on_invalid", "place_seed": "place_seed", "name": "name"}


def _files_of(record: Mapping[str, Any], folder: Optional[pathlib.Path]) -> Iterator[pathlib.Path]:
    """Returns paths at which the spec of a record may be; `folder` is the folder of the manifest.
    """
    if folder is not None and record.get("spec_file"):
        yield folder / record["spec_file"]
    name = os.path.basename(record["spec"])
    for place in (pathlib.Path(), folder, folder and folder.parent):
        if place is not None and name.endswith((".yaml", ".yml")):
            yield place / name


def _spec_of(record: Mapping[str, Any], folder: Optional[pathlib.Path]) -> Spec:
    files = list(_files_of(record, folder))
    found = next((file for file in files if file.is_file()), None)
    if found is None and record["spec"] in ("-", "<spec>"):
        raise ValueError("the spec of the record was a text or a mapping: give it as spec=")
    try:
        return Spec(found or record["spec"], set=_settings_of(record))
    except SpecError as error:
        if found or not files or error.findings[0].code != "yaml/cannot-read":
            raise
        names = ", ".join(dict.fromkeys(repr(os.path.abspath(file)) for file in files))
        raise FileNotFoundError(f"the spec of the record is not at {names}: give its path as spec=") from None


def _settings_of(record: Mapping[str, Any]) -> dict[str, Any]:
    return {name: RecordedText(value) if isinstance(value, str) else value
            for name, value in record.get("set", {}).items()}


def replay(record: Mapping[str, Any], spec: Union[Source, Spec, None],
           folder: Optional[pathlib.Path] = None) -> Variant:
    """See Variant.from_record."""
    if not isinstance(record, Mapping):
        raise TypeError(f"record={record!r} is not a mapping but of type {type(record).__name__}")
    missing = [name for name in ("spec", "spec_sha256", "seed", "index", "target", "name") if name not in record]
    if missing:
        raise ValueError(f"record has no {missing[0]!r}: it is not a line of a manifest")
    wrong = [name for name, is_good in OPTIONAL.items() if name in record and not is_good(record[name])]
    if wrong:
        raise ValueError(f"the member {wrong[0]!r} of record has a wrong type: record is not a line of a manifest")
    if record.get("each"):
        raise ValueError("record is that of a scene whose objects are files of their own (--each)")
    if record.get("pad"):
        raise ValueError("record is that of a variant with null geoms (--pad): load_family(...).to_model(...) has its "
                         "model, and the command `replay` makes its MJCF")
    if spec is None:
        spec = _spec_of(record, folder)
    elif not isinstance(spec, Spec):
        spec = Spec(spec, set=_settings_of(record))
    options = {option: record[name] for option, name in _OPTIONS.items() if record.get(name) is not None}
    if record.get("attempt"):  # validation may have rejected earlier attempts
        options["validate"] = record.get("validate", "none")
    variant = spec.variants(record["seed"], set=_settings_of(record), **options)[record["index"]]
    again = variant.record
    title = f"{record['name']} {record['index']} of seed {record['seed']}"
    if again["spec_sha256"] != record["spec_sha256"]:
        where = f" '{spec.path}'" if spec.path else ""
        raise MismatchError(f"{title}: the spec{where} has changed: its SHA-256 is {again['spec_sha256']}, not "
                            f"{record['spec_sha256']}")
    if again.get("sha256") != record.get("sha256"):
        raise MismatchError(f"{title}: it is another file: its SHA-256 is {again.get('sha256')}, not "
                            f"{record.get('sha256')}")
    variant.findings = findings_of(record, spec._key_paths)  # those of a validation, too
    return variant
