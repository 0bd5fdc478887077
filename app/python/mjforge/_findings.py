"""Findings (errors and warnings), and the exceptions that contain them."""

from __future__ import annotations

import unicodedata
from typing import Any, Mapping, Optional, Sequence

TEXT_NAME = "<spec>"  # name of a spec without a file, in findings
_MAX_COLUMNS = 120  # longest excerpt of a line, as in the command
_DOTS = "..."


def printable(text: str) -> str:
    """Returns the text with escapes in place of control characters, because names in other people's
    files may contain control characters.
    """
    return "".join(c if c.isprintable() or c == "\n" else c.encode("unicode_escape").decode()
                   for c in text)


def _width(character: str) -> int:
    """Returns the number of columns of a character on a terminal."""
    if unicodedata.combining(character):
        return 0
    return 2 if unicodedata.east_asian_width(character) in "WF" else 1


def _excerpt(line: bytes, column: int) -> list[str]:
    """Returns a line of a file and a caret below the byte `column`, which is counted from 1. Cuts a long
    line on both sides of the caret.
    """
    before = line[:column - 1].decode(errors="replace").replace("\t", " ")
    text = line.decode(errors="replace").replace("\t", " ")
    caret, start, dots = len(before), 0, ""
    if sum(map(_width, text)) > _MAX_COLUMNS:
        room = _MAX_COLUMNS - 2 * len(_DOTS)
        start = max(0, min(caret - room // 2, len(text) - room))
        end, dots = start + room, _DOTS if start > 0 else ""
        text = dots + text[start:end] + (_DOTS if end < len(text) else "")
    return [text, " " * (len(dots) + sum(map(_width, before[start:]))) + "^"]


def _quoted(texts: Mapping[str, str], file: Optional[str], line: Optional[int],
            column: Optional[int]) -> list[str]:
    """Returns the lines of an excerpt; none if the file is not one of the texts, or is one of several
    with the same name. Findings name a file by the end of its path.
    """
    if file is None or line is None:
        return []
    path = "-" if file == TEXT_NAME else file
    found = [path] if path in texts else [each for each in texts if each.endswith(f"/{path}")]
    lines = texts[found[0]].encode(errors="surrogateescape").split(b"\n") if len(found) == 1 else []
    if not 0 < line <= len(lines) or not lines[line - 1].strip():
        return []
    return _excerpt(lines[line - 1].rstrip(b"\r"), column or 1)


class Finding:
    """An error or a warning. Attributes that do not apply are None."""

    __slots__ = ("severity", "code", "message", "hint", "file", "line", "column", "seed", "index",
                 "notes", "key", "text")

    severity: str  # "error" or "warning"
    code: str  # "spec/unknown-key": a chapter of docs/errors.md
    message: str
    hint: Optional[str]
    file: Optional[str]
    line: Optional[int]  # counted from 1
    column: Optional[int]  # counted from 1
    seed: Optional[int]  # seed of the variant
    index: Optional[int]  # index of the variant
    notes: list[dict[str, Any]]  # each with message, file, line and column
    key: Optional[str]  # key in a spec that was given as a mapping: "parts[0].type"
    text: str  # the finding as the command prints it

    def __init__(self, members: dict[str, Any], text: str = "") -> None:
        for name in self.__slots__[:-1]:
            setattr(self, name, members.get(name))
        self.text = printable(text.rstrip("\n") or self._text({}))

    def _place(self, members: Mapping[str, Any]) -> str:
        """Returns the place of the finding or of a note, given its members: key or file, line and column."""
        if members.get("key"):
            return str(members["key"])
        names = ("file",) if "key" in members else ("file", "line", "column")
        return ":".join(str(members[name]) for name in names if members.get(name) is not None)

    def _summary(self) -> str:
        members = self.members()
        ids = [f"{name} {members[name]}" for name in ("seed", "index") if name in members]
        variant = f" ({', '.join(ids)})" if ids else ""
        return f"{self._place(members) or 'mjforge'}: {self.severity}: {self.message}{variant} [{self.code}]"

    def _text(self, texts: Mapping[str, str]) -> str:
        """Returns the finding as the command prints it, with the lines of files whose texts are given."""
        words = [self._summary(), *_quoted(texts, self.file, self.line, self.column)]
        if self.hint is not None:
            words.append(f"  hint: {self.hint}")
        for note in self.notes or ():
            place, indent = (self._place(note) or "mjforge", "") if self.key is None else (self._place(note), "  ")
            words.append(f"{indent}{place}: note: {note['message']}" if place else f"{indent}note: {note['message']}")
            words += _quoted(texts, note.get("file"), note.get("line"), note.get("column"))
        return "\n".join(words)

    def set_texts(self, texts: Mapping[str, str]) -> "Finding":
        """Adds the lines at which the finding and its notes point to `text`, unless they have keys. `texts`:
        the texts of the spec's files, by path; see Spec.texts. Returns the finding.
        """
        if self.key is None:
            self.text = printable(self._text(texts))
        return self

    def set_keys(self, key_paths: Sequence[str]) -> "Finding":
        """Sets `key` in a finding about a spec that was given as a mapping, and in its notes.
        `key_paths` has the key of each line of the spec's text; it is empty for other specs.
        Returns the finding.
        """
        if not key_paths or self.file != TEXT_NAME:
            return self

        def key_of(line: Optional[int]) -> str:
            return key_paths[line - 1] if line is not None and 0 < line <= len(key_paths) else ""

        self.key = key_of(self.line)
        self.notes = [{**note, "key": key_of(note.get("line"))} if note.get("file") == TEXT_NAME else note
                      for note in self.notes or []]
        self.text = printable(self._text({}))
        return self

    def members(self) -> dict[str, Any]:
        """Returns the finding's JSON object in the output of `--findings json`."""
        values = {name: getattr(self, name) for name in self.__slots__[:-1]}
        return {name: value for name, value in values.items() if value is not None}

    def __str__(self) -> str:
        return self.text

    def __repr__(self) -> str:
        return f"<mjforge.Finding {printable(self._summary())!r}>"


def findings_of(record: Mapping[str, Any], key_paths: Sequence[str] = ()) -> tuple[Finding, ...]:
    """Returns the findings in the record of a variant. `key_paths`: see Finding.set_keys."""
    return tuple(Finding(members).set_keys(key_paths) for members in record.get("findings", ()))


class _FindingsError(ValueError):
    """An exception whose text consists of the texts of its findings."""

    findings: tuple[Finding, ...]

    def __init__(self, findings: Sequence[Finding]) -> None:
        super().__init__(tuple(findings))
        self.findings = tuple(findings)

    def __str__(self) -> str:
        return "\n".join(finding.text for finding in self.findings)


class SpecError(_FindingsError):
    """Raised if a spec has errors. `findings` contains all errors and warnings."""


class VariantError(_FindingsError):
    """Raised if a variant could not be made or did not pass its checks; `findings` contains the
    reasons.
    """


class MismatchError(ValueError):
    """Raised if a model, a spec or a file differs from the record of a variant."""
