# fish completion for mjforge. The program computes the candidates for the word under the cursor
# (app/completion.h).

function __mjforge_complete
    set -l words (commandline --tokenize --cut-at-cursor --current-process)
    set -l word (commandline --current-token --cut-at-cursor)
    set -l lines ($words[1] __complete $words[2..] "$word" 2>/dev/null)
    set -l endings (string split --no-empty ' ' (string sub --start 2 -- $lines[-1]))
    string match --invert --regex '^:' -- $lines
    test -n "$endings"; or return
    # Add files with these endings, and folders, also after the equals sign of --option=FILE.
    set -l option (string match --regex -- '^--[^=]*=' "$word")
    set -l start (string replace --regex -- '^--[^=]*=' '' "$word")
    set -l end (string join '|' (string escape --style=regex -- $endings))
    test "$endings" = .; and set end ''
    string match --regex --entire "(?:/|$end)(?:\t|\$)" -- (complete -C "__fish_command_without_completions $start") |
        string replace --regex -- '^' "$option"
end

complete --command mjforge --no-files --arguments '(__mjforge_complete)'
