"""The inputs that fuzzing starts from: files of the tests, and small batches made for it."""

import fnmatch
import hashlib
import io
import json
import pathlib
import re
import struct
import subprocess
import tarfile
import tempfile

# Longer ones make every run slow, and say nothing that shorter ones do not.
MOST_BYTES = 16_000


# A file on a page: tests/docs/page.h.
BLOCK = re.compile(r"^```(?:\w+ (\S+)|yaml\n# file: (\S+))\n(.*?)^```", re.MULTILINE | re.DOTALL)


def texts(places, *patterns):
    """The contents of files in folders and on pages, in a fixed order."""
    for place in places:
        pages = [place] if place.suffix == ".md" else sorted(place.rglob("*.md"))
        blocks = [block for page in pages for block in BLOCK.findall(page.read_text())]
        for pattern in patterns:
            for path in sorted(place.rglob(pattern)):
                if path.is_file() and path.stat().st_size <= MOST_BYTES:
                    yield path.read_bytes()
            for *names, text in blocks:
                if fnmatch.fnmatch("".join(names), pattern):
                    yield text.encode()


def specs(project, _):
    """Target, sampler, size of the batch, seed, whether to resample; then the spec."""
    # A scene takes too long with sanitizers.
    objects = [place for place in sorted((project / "specs").iterdir()) if place.name != "scenes"]
    places = [project / "tests/golden", project / "docs/errors.md", *objects,
              project / "tests/parity", project / "tests/property"]
    for number, text in enumerate(texts(places, "*.yaml")):
        yield bytes([number % 5, number // 5 % 4, 20, 1, number % 2]) + text


def expressions(project, _):
    """Values of the variables; then what stands between brackets and colons of specs."""
    found = set()
    for text in texts([project / "tests/golden", project / "docs/errors.md", project / "specs"],
                      "*.yaml"):
        for line in text.decode(errors="replace").splitlines():
            for piece in line.partition(": ")[2].strip(" []{}").split(", "):
                found.add(piece.strip(" []{}'\""))
    functions = (project / "docs/manual.md").read_text().split("`")
    found.update(piece for piece in functions[1::2] if "\n" not in piece and len(piece) < 60)
    for piece in sorted(found):
        yield bytes(7) + piece.encode()


def mjcf_files(project):
    return texts([project / "tests/golden", project / "tests/property/models",
                  project / "tests/parity"], "*.xml")


def mjcf(project, _):
    for number, text in enumerate(mjcf_files(project)):
        yield bytes([number % 5]) + text


def xml(project, _):
    yield from mjcf_files(project)


def meshes(project, _):
    for text in texts([project / "tests"], "*.obj"):
        yield b"\1" + text
    yield b"\1" + b"v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1/1/1 2//1 3/2 4\nf -1 -2 -3\no second\n"
    for text in texts([project / "tests"], "*.stl"):
        yield b"\0" + text
    yield b"\0" + (b"solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n"
                   b"vertex 0 1 0\nendloop\nendfacet\nendsolid a\n")
    triangle = struct.pack("<12fH", 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0)
    yield b"\0" + bytes(80) + struct.pack("<I", 2) + 2 * triangle


class Batches:
    """Small batches made by the program, by their `-o`."""

    def __init__(self, program):
        self._program = program
        self._folder = tempfile.TemporaryDirectory(prefix="mjforge-seeds-")
        self.folder = pathlib.Path(self._folder.name)

    def make(self, output, *words):
        """The files of one, by name."""
        folder = self.folder / hashlib.sha256(repr([output, words]).encode()).hexdigest()[:8]
        if not folder.exists():
            folder.mkdir()
            subprocess.run([self._program, "generate", "ball", "--name", "x", "--seed", "1", "-q",
                            *words, "-o", output], cwd=folder, check=True)
        return {path.name: path.read_bytes() for path in sorted(folder.rglob("*"))
                if path.is_file()}


def manifests(project, batches):
    """Whether to make a page; then the manifest."""
    found = [*texts([project / "tests/golden"], "*.jsonl"),
             batches.make("out", "-n", "3", "--validate", "none")["manifest.jsonl"],
             batches.make("out", "-n", "2", "--validate", "physics")["manifest.jsonl"],
             batches.make("x.tar", "-n", "2")["x.manifest.jsonl"],
             batches.make("x.tar.zst", "-n", "2")["x.manifest.jsonl.zst"]]
    for text in found:
        yield b"\0" + text
        # Its spec is not found: drawing from it for the page would take most of the time.
        yield b"\1" + text.replace(b"primitives/ball", b"spec")


def seals(_, batches):
    for words in (["out"], ["x.tar"], ["x_%d.tar", "--per-archive", "1"]):
        for name, text in batches.make(words[0], "-n", "3", *words[1:]).items():
            if name.endswith(".seal.json"):
                yield text
                yield with_tokens(text, "manifest").encode()


def archives(_, batches):
    for output in ("x.tar", "x.tar.zst"):
        yield batches.make(output, "-n", "2")[output]
    for form in (tarfile.PAX_FORMAT, tarfile.GNU_FORMAT, tarfile.USTAR_FORMAT):
        content = io.BytesIO()
        with tarfile.open(fileobj=content, mode="w", format=form) as archive:
            for name in ("x" * 120, "x_000000.xml"):
                member = tarfile.TarInfo(name[:100] if form == tarfile.USTAR_FORMAT else name)
                member.size = 4
                archive.addfile(member, io.BytesIO(b"abcd"))
        yield content.getvalue()


def with_tokens(seal, manifest):
    """A seal whose checksums follow what the fuzzer changes."""
    found = json.loads(seal)
    found["manifest"]["xxh128"] = f"@{manifest}:@"
    for archive in found["archives"]:
        archive["xxh128"] = "@archive:@"
    found["xxh128"] = "@own@"
    return json.dumps(found, separators=(",", ":"))


def pieces_of(files, name):
    """The pieces of a manifest that have a checkpoint each, and the count of records up to each:
    lines, or the only frame of three records, without the seek table of 25 bytes."""
    if packed := files.get(f"{name}.jsonl.zst"):
        return [(3, packed[:-25])]
    return list(enumerate(files[f"{name}.jsonl"].splitlines(keepends=True), 1))


def begun(files, kind, name, archive):
    """A batch under construction: half of its records are noted in the journal."""
    seal = with_tokens(files[f"{name}.seal.json"], "part")
    pieces = pieces_of(files, name)
    words = [f"mjforge-journal 1 {seal}"]
    sections = {}
    size = 0
    if archive:
        sections["archivepart"] = files[archive]
        words.append("at 0 0 @part:0@ 0 0 -")
    for number, piece in pieces:
        size += len(piece)
        part = len(files[archive]) - 1024 if archive else 0
        checksum = f"@archivepart:{part}@" if archive else "-"
        words.append(f"at {number} {size} @part:{size}@ 0 {part} {checksum}")
    if archive:
        words.insert(2, "asset " + 64 * "0" + " wood.png")
    else:
        sections["object"] = files["x_000000.xml"]
    words.append(f"made x_{kind}.tar")
    sections["journal"] = ("\n".join(words) + "\n").encode()
    sections["part"] = b"".join(piece for _, piece in pieces)
    return sections


def closed(files, kind, name, archive):
    """The same, when the archive had got its name and the manifest had not."""
    sections = begun(files, kind, name, archive)
    sections["archive"] = sections.pop("archivepart")
    records, size = pieces_of(files, name)[-1][0], len(sections["part"])
    sections["journal"] = (sections["journal"].replace(b"@archivepart:", b"@archive:") +
                           f"closed {len(files[archive])} @archive:@ {archive}\n"
                           f"at {records} {size} @part:@ 1 0 -\n".encode())
    return sections


def finished(files, name, archive):
    sections = {"manifest": files.get(f"{name}.jsonl.zst") or files[f"{name}.jsonl"],
                "seal": with_tokens(files[f"{name}.seal.json"], "manifest").encode() + b"\n"}
    if archive:
        sections["archive"] = files[archive]
    else:
        sections["object"] = files["x_000000.xml"]
    return sections


def resumed(_, batches):
    """Kind of output and options, as digits; then the files."""
    outputs = [("out", [], "manifest", None), ("x.tar", [], "x.manifest", "x.tar"),
               ("x.tar.zst", [], "x.manifest", "x.tar.zst"),
               ("x_%d.tar", ["--per-archive", "3"], "x.manifest", "x_0.tar")]
    for kind, (output, words, name, archive) in enumerate(outputs):
        files = batches.make(output, "-n", "3", *words)
        for sections in (begun(files, kind, name, archive), finished(files, name, archive),
                         *([closed(files, kind, name, archive)] if archive else [])):
            for flags in "0135":
                options = f"{kind}{flags}33100\n".encode()
                yield options + b"".join(b"%%% " + key.encode() + b"\n" + text
                                         for key, text in sections.items())


SEEDS = {"archive": archives, "expression": expressions, "manifest": manifests, "mesh": meshes,
         "mjcf": mjcf, "resume": resumed, "seal": seals, "spec": specs, "xml": xml}


def write(target, project, program, folder):
    """Writes the target's seeds to a folder, which is made."""
    folder.mkdir(parents=True, exist_ok=True)
    for content in SEEDS[target](project, Batches(program)):
        (folder / hashlib.sha256(content).hexdigest()[:16]).write_bytes(content)
