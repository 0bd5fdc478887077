# bash ask.bash FOLDER LINE [COMP_TYPE]: what bash offers at the end of the line, with the script in
# FOLDER; one word a line.
source /usr/share/bash-completion/bash_completion
source "$1/mjforge.bash"
COMP_LINE=$2 COMP_POINT=${#2} COMP_TYPE=${3:-9}
# As readline splits it: an equals sign is a word, a blank behind a backslash belongs to one.
line=${2//\\ /$'\1'}
read -ra COMP_WORDS <<<"${line//=/ = }"
COMP_WORDS=("${COMP_WORDS[@]//$'\1'/\\ }")
[[ $2 == *' ' ]] && COMP_WORDS+=("")
COMP_CWORD=$((${#COMP_WORDS[@]} - 1))
COMPREPLY=()
_mjforge mjforge
((${#COMPREPLY[@]} == 0)) || printf '%s\n' "${COMPREPLY[@]}"
