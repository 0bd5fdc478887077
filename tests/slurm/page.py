"""The scripts of docs/scale-out.md, for a batch that is small enough for a test."""

import pathlib
import re

PAGE = pathlib.Path(__file__).resolve().parents[2] / "docs" / "scale-out.md"

COUNT = 2000
SHARDS = 8
PER_SHARD = COUNT // SHARDS

# What the page's scripts make, and how a test makes it smaller.
_COUNT = ("-n 1000000 ", f"-n {COUNT} ")
_ARCHIVES = "-o hammers_%05d.tar.zst"


def block(language, text):
    """The one code block in that language that contains the text."""
    blocks = re.findall(rf"^```{language}\n(.*?)^```$", PAGE.read_text(), re.M | re.S)
    found = [one for one in blocks if text in one]
    if len(found) != 1:
        raise AssertionError(f"{PAGE.name}: {len(found)} blocks of {language} with '{text}'")
    return found[0]


def smaller(script, output):
    """The script for COUNT variants, with the `-o` and its like that are given."""
    for old, new in (_COUNT, (_ARCHIVES, output)):
        if script.count(old) != 1:
            raise AssertionError(f"{PAGE.name}: '{old}' is not once in\n{script}")
        script = script.replace(old, new)
    return script
