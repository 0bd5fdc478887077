"""Cuts the power while a batch is made, and goes on with --resume.

A run is recorded. For each moment, the disk is put together as a power cut may leave it: of what was
not synced, contents may be there, missing, zeros or cut short, and names in the order in which they
were made up to any one of them, or any of them. Then --resume must give the same bytes, or an error.

  python3 power_cut.py PROGRAM SHIM OUTPUT [--every N] [--seed N]
"""

import pathlib
import random
import sys

import harness


class Content:
    """Bytes of a file: what is on the disk for sure, and what the program wrote."""

    def __init__(self):
        self.synced = b""
        self.written = b""

    def after_cut(self, choice):
        if self.synced == self.written:
            return self.written
        way = choice.randrange(4)
        if way == 0:
            return self.synced
        if way == 1:
            return self.written
        appended = self.written.startswith(self.synced)
        size = choice.randrange(len(self.synced) if appended else 0, len(self.written) + 1)
        kept = self.written[:size]
        return kept if way == 2 else kept + bytes(len(self.written) - size)


class Disk:
    def __init__(self):
        self.names = {}  # path: Content
        self.synced_names = {}
        self.pending = []  # changes of names that no sync has reached: (folder, change)

    def change(self, path, change):
        change(self.names)
        self.pending.append((str(pathlib.Path(path).parent), change))

    def apply(self, line, data):
        kind, *words = line.split(" ")
        if kind == "create":
            content = Content()
            self.change(words[0], lambda names: names.__setitem__(words[0], content))
        elif kind == "write":
            content = self.names[words[0]]
            at = int(words[1])
            content.written = content.written[:at] + data + content.written[at + len(data):]
        elif kind == "truncate":
            content = self.names[words[0]]
            content.written = content.written[:int(words[1])]
        elif kind == "rename":
            def rename(names, words=words):
                if words[0] in names:
                    names[words[1]] = names.pop(words[0])
            self.change(words[1], rename)
        elif kind == "remove":
            self.change(words[0], lambda names: names.pop(words[0], None))
        elif kind == "sync":
            if words[0] in self.names:
                content = self.names[words[0]]
                content.synced = content.written
            else:
                self.sync_names(words[0])
        elif kind == "syncfs":
            for content in self.names.values():
                content.synced = content.written
            self.sync_names(None)

    def sync_names(self, folder):
        """The changes in that folder, or all, are on the disk."""
        left = []
        for place, change in self.pending:
            if folder is None or place == folder:
                change(self.synced_names)
            else:
                left.append((place, change))
        self.pending = left

    def after_cut(self, choice):
        """One of the states that the disk may have; by path."""
        names = dict(self.synced_names)
        if choice.randrange(2):
            kept = self.pending[:choice.randrange(len(self.pending) + 1)]
        else:
            kept = [change for change in self.pending if choice.randrange(2)]
        for _, change in kept:
            change(names)
        contents = {}  # a file may have two names
        return {path: contents.setdefault(id(content), content.after_cut(choice))
                for path, content in names.items()}


def read_record(file):
    """The recorded calls: (line, bytes)."""
    data = file.read_bytes()
    at = 0
    while at < len(data):
        end = data.index(b"\n", at)
        line = data[at:end].decode()
        at = end + 1
        size = int(line.split(" ")[3]) if line.startswith("write ") else 0
        yield line, data[at:at + size]
        at += size


def main():
    parser = harness.parser("only every N-th moment")
    parser.add_argument("--seed", type=int, default=1)
    options = parser.parse_args()
    batch = harness.Batch(options.program, options.shim, options.output)
    batch.clear()
    result = batch.run(record=True)
    assert result.returncode == 0, result.stderr
    whole = batch.files()
    choice = random.Random(options.seed)
    disk = Disk()
    tried = resumed = faults = 0
    calls = list(read_record(batch.record))
    assert any(line.startswith("sync") for line, _ in calls), "nothing was synced"
    for moment, (line, data) in enumerate(calls):
        disk.apply(line, data)
        if (moment + options.seed) % options.every and moment + 1 < len(calls):
            continue
        batch.clear()
        for path, content in disk.after_cut(choice).items():
            file = pathlib.Path(path)
            file.parent.mkdir(parents=True, exist_ok=True)
            file.write_bytes(content)
        result = batch.run("--resume")
        tried += 1
        if result.returncode == 0 and batch.files() == whole:
            resumed += 1
        elif not harness.is_honest(result):
            faults += 1
            print(f"after call {moment} ({line}): status {result.returncode}\n{result.stderr}")
            mine = batch.files()
            print("  differ:", [name for name in sorted({*mine, *whole})
                                if mine.get(name) != whole.get(name)][:5])
    print(f"{options.output}: {tried} cuts, {resumed} resumed to the same bytes, "
          f"{tried - resumed - faults} honest errors")
    print(f"{tried - faults} passed, {faults} failed")
    batch.close()
    # An error each time would be honest, too, and of no use.
    return 0 if faults == 0 and resumed >= 0.9 * tried else 1


if __name__ == "__main__":
    sys.exit(main())
