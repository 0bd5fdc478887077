#!/usr/bin/env bash
# man_pages.sh PROGRAM FOLDER: writes mjforge.1 and mjforge-COMMAND.1 for each command into FOLDER.
# help2man makes the pages from the help texts; without help2man FOLDER stays empty.
set -euo pipefail
program=$1
folder=$2

rm -rf "$folder"
mkdir -p "$folder"
if ! command -v help2man >/dev/null; then
  echo "man pages are left out, because help2man is not installed"
  exit 0
fi
version=$("$program" --version | sed -n '1s/.* //p')

# CLI11's headings and lists of names, in the form that man pages have.
heads='s/^  \(-.\),-/  \1, -/; s/^Positionals:/Arguments:/; s/SUBCOMMAND/COMMAND .../; s/^Subcommands:/*Commands*/'

# page NAME COMMAND SUMMARY: the last sections of the page come from standard input.
page() {
  # Keeps the line ends of examples, and quotes as ASCII, so that examples can be copied.
  help2man --no-info --manual "Manual of mjforge" --name "$3" --include /dev/stdin \
    --version-string "$1 (mjforge) $version" --help-option "$2 --help | sed '$heads'" "$program" |
    sed -e '/^\.SH EXAMPLES/,/^\.SH "SEE/{s/^\.IP$/.EX/;s/^\.SH "SEE/.EE\n&/}' \
      -e 's/^\.SS "Arguments:"/.SH ARGUMENTS/' -e "/^\./! s/'/\\\\(aq/g" >"$folder/$1.1"
}

page mjforge "" "randomized MuJoCo objects from YAML specs" <"$(dirname "$0")/man_sections.txt"
"$program" --help | sed -n '/^Subcommands:/,/^$/s/^  \([a-z]*\) *\(.*\)/\1 \l\2/p' |
  while read -r command summary; do
    page "mjforge-$command" "$command" "$summary" <<'END'
[see also]
.BR mjforge (1),
for the other commands, exit status and environment
END
    printf '.BR mjforge\\-%s (1),\n' "$command" >>"$folder/mjforge.1"
  done
sed -i '$s/,$//' "$folder/mjforge.1"
