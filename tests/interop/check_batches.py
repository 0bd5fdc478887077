"""pandas and webdataset read a compressed series of archives and its manifest.

    check_batches.py FOLDER
"""

import json
import pathlib
import sys

import pandas
import webdataset

from report import check, expect, finish

BATCH = pathlib.Path(sys.argv[1]) / "series"
ARCHIVES = sorted(BATCH.glob("*.tar.zst"))


def indices(found):
    expect(list(found) == list(range(len(found))) and len(found) > 100,
           f"the indices are {list(found)[:3]} ..., {len(found)} in all")
    return f"{len(found)} variants"


def read_manifest():
    (manifest,) = BATCH.glob("*.manifest.jsonl.zst")
    records = pandas.read_json(manifest, lines=True)
    expect(all(records["archive"].isin([archive.name for archive in ARCHIVES])), "other archives")
    return indices(records["index"])


def read_archives():
    urls = [f"pipe:zstd -dc '{archive}'" for archive in ARCHIVES]
    samples = list(webdataset.WebDataset(urls, shardshuffle=False, empty_check=False))
    expect(all(sample["xml"].startswith(b"<!--") or sample["xml"].startswith(b"<mujoco")
               for sample in samples), "a sample has no object")
    return indices([json.loads(sample["json"])["index"] for sample in samples])


check("pandas reads a compressed manifest", read_manifest)
check("webdataset reads compressed archives", read_archives)
finish()
