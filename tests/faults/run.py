"""All moments and all calls: ./dev faults. Prints "N passed, N failed" at the end."""

import pathlib
import re
import subprocess
import sys

import harness

SEEDS = 5


def main():
    program, shim = sys.argv[1:]
    here = pathlib.Path(__file__).parent
    passed = failed = 0
    for output in harness.OUTPUTS:
        runs = [["power_cut.py", program, shim, output, "--seed", str(seed)]
                for seed in range(1, SEEDS + 1)]
        for words in [*runs, ["faults.py", program, shim, output]]:
            print(" ".join([words[0], *words[3:]]), flush=True)
            result = subprocess.run([sys.executable, "-B", str(here / words[0]), *words[1:]],
                                    stdout=subprocess.PIPE, text=True)
            print(result.stdout, end="", flush=True)
            counts = re.search(r"(\d+) passed, (\d+) failed\n$", result.stdout)
            passed += int(counts[1]) if counts else 0
            failed += int(counts[2]) if counts else 1
            if counts and result.returncode != 0 and counts[2] == "0":
                failed += 1
    print(f"{passed} passed, {failed} failed")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
