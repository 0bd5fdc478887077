"""Reads pictures and facts from the pages of `mjforge catalogue --html`."""

import base64
import html
import os
import re
import subprocess

IMAGE = re.compile(r'<img src="data:image/webp;base64,([^"]+)" alt="([^"]*)"')


def make(program, folder):
    """Writes the gallery of the bundled specs to a folder."""
    environment = {key: value for key, value in os.environ.items() if key != "MJFORGE_PATH"}
    subprocess.run([program, "catalogue", "--html", folder, "--force", "-q"], check=True, env=environment)


def _pictures(text):
    """Pairs of a picture's bytes and its alternative text."""
    return [(base64.b64decode(data), html.unescape(alt)) for data, alt in IMAGE.findall(text)]


def thumbnails(folder):
    """The pictures of the index, by the specs' names."""
    text = (folder / "index.html").read_text(encoding="utf-8")
    return {alt.removeprefix("A variant of "): data for data, alt in _pictures(text)}


class SpecPage:
    """The page of a spec."""

    def __init__(self, folder, spec):
        text = (folder / "specs" / f"{spec}.html").read_text(encoding="utf-8")
        figure = re.search(r'<figure class="large">.*?</figure>', text, re.DOTALL)
        self.large = _pictures(figure.group(0))[0][0]
        facts = re.search(r'<dl class="facts">.*?</dl>', text, re.DOTALL)
        rows = re.findall(r"<div><dt>(.*?)</dt><dd>(.*?)</dd></div>", facts.group(0), re.DOTALL)
        self.facts = {html.unescape(key): html.unescape(value) for key, value in rows}
        # Each joint of the page at the end of its range.
        films = re.findall(r'<section class="film".*?</section>', text, re.DOTALL)
        self.moved = [_pictures(film)[-1] for film in films]
