"""Findings (errors and warnings), and the exceptions that contain them."""

from __future__ import annotations

from typing import Any, Mapping, Optional, Sequence


TEXT_NAME = "<spec>"  # name of a spec without a file, in findings


def printable(text: str) -> str:
    """Returns the text with escapes in place of control characters, because names in other people's
    files may contain control characters.
    """
    return "".join(c if c.isprintable() or c == "\n" else c.encode("unicode_escape").decode()
                   for c in text)


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
        text = text.rstrip("\n") or self._summary()
        self.text = printable(text)

    def _summary(self) -> str:
        place = ":".join(str(p) for p in (self.file, self.line, self.column) if p is not None)
        summary = f"{place or 'mjforge'}: {self.severity}: {self.message} [{self.code}]"
        return summary if self.hint is None else f"{summary}\n  hint: {self.hint}"

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
        place = self.key or TEXT_NAME
        summary = [f"{place}: {self.severity}: {self.message} [{self.code}]"]
        if self.hint is not None:
            summary.append(f"  hint: {self.hint}")
        self.notes = [{**note, "key": key_of(note.get("line"))} if note.get("file") == TEXT_NAME else note
                      for note in self.notes or []]
        for note in self.notes:
            at = note.get("key") or note.get("file")
            summary.append(f"  {at}: note: {note['message']}" if at else f"  note: {note['message']}")
        self.text = printable("\n".join(summary))
        return self

    def members(self) -> dict[str, Any]:
        """Returns the finding's JSON object in the output of `--findings json`."""
        values = {name: getattr(self, name) for name in self.__slots__[:-1]}
        return {name: value for name, value in values.items() if value is not None}

    def __str__(self) -> str:
        return self.text

    def __repr__(self) -> str:
        return f"<mjforge.Finding {self._summary()!r}>"


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
