"""Tables: on the terminal, and in docs/performance.md between markers."""

import datetime
import os
import pathlib
import platform
import subprocess

PAGE = pathlib.Path(__file__).resolve().parents[2] / "docs/performance.md"


def machine():
    """Processor, cores, memory, system; nothing that names this machine."""
    def field(file, name):
        for line in pathlib.Path(file).read_text().splitlines():
            key, _, value = line.partition(":")
            if key.strip() == name:
                return value.strip()
        return "unknown"
    memory = int(field("/proc/meminfo", "MemTotal").split()[0]) / 2**20
    system = platform.freedesktop_os_release()["PRETTY_NAME"]
    return (f"{field('/proc/cpuinfo', 'model name')}, {os.cpu_count()} cores, {memory:.0f} GB RAM,"
            f" {system}, Python {platform.python_version()}; {datetime.date.today()}")


def version_of(program):
    """"mjforge 0.1.0"."""
    return subprocess.run([program, "--version"], check=True, capture_output=True,
                          text=True).stdout.splitlines()[0]


def as_text(head, rows):
    """Columns for a terminal: the first to the left, numbers to the right."""
    table = [head, *rows]
    widths = [max(len(row[i]) for row in table) for i in range(len(head))]
    return "\n".join("  ".join(cell.rjust(width) if i else cell.ljust(width)
                               for i, (cell, width) in enumerate(zip(row, widths))).rstrip()
                     for row in table)


def as_markdown(head, rows):
    lines = ["| " + " | ".join(head) + " |", "| --- |" + " ---: |" * (len(head) - 1)]
    return "\n".join(lines + ["| " + " | ".join(row) + " |" for row in rows])


def write(section, text):
    """Replaces the text between the section's markers."""
    page = PAGE.read_text(encoding="utf-8")
    begin, end = f"<!-- {section}: begin -->\n", f"<!-- {section}: end -->\n"
    before, _, rest = page.partition(begin)
    _, found, after = rest.partition(end)
    if not found:
        raise SystemExit(f"{PAGE.name} has no markers {begin.strip()} and {end.strip()}")
    PAGE.write_text(f"{before}{begin}\n{text}\n\n{end}{after}", encoding="utf-8")
