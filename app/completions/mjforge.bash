# bash completion for mjforge. The program computes the candidates for the word under the cursor
# (app/completion.h); functions of the package bash-completion split the line and list files.

_mjforge() {
    local cur prev words cword
    _init_completion -n = || return
    # Remove quotes, as the shell does before it runs a program.
    local arguments=("${words[@]:1:cword}")
    arguments=("${arguments[@]//[\'\"\\]/}")
    arguments=("${arguments[@]/#\~\//$HOME/}")
    local lines
    mapfile -t lines < <("${1/#\~\//$HOME/}" __complete "${arguments[@]}" 2>/dev/null)
    ((${#lines[@]})) || return
    local files=${lines[-1]#:} line
    unset 'lines[-1]'
    COMPREPLY=("${lines[@]%%$'\t'*}")
    # Readline replaces only the part after the last equals sign.
    if [[ $COMP_WORDBREAKS == *=* ]]; then
        COMPREPLY=("${COMPREPLY[@]#"${cur%"${cur##*=}"}"}")
        cur=${cur##*=}
    fi
    if [[ $files ]]; then
        files=${files//./}
        _filedir "${files// /|}"
    elif ((COMP_TYPE == 63 && ${#lines[@]} > 1)); then
        # Readline shows a list and inserts nothing, so the list can contain descriptions.
        COMPREPLY=()
        for line in "${lines[@]}"; do
            printf -v line '%-24s %s' "${line%%$'\t'*}" "${line#*$'\t'}"
            COMPREPLY+=("${line:0:${COLUMNS:-80}-1}")
        done
    elif ((${#lines[@]})); then
        mapfile -t COMPREPLY < <(printf '%q\n' "${COMPREPLY[@]}")
        if [[ ${#lines[@]} -eq 1 && $COMPREPLY == *= ]]; then
            compopt -o nospace 2>/dev/null  # fails outside of a completion
        fi
    fi
} && complete -F _mjforge mjforge
