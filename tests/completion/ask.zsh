# zsh -f ask.zsh FOLDER LINE: what zsh offers at the end of the line, with the script in FOLDER; one
# word a line. It types into a zsh that has a terminal, and listens to what is added to its list.
zmodload zsh/zpty
hits=$PWD/.hits
: >$hits
zpty shell zsh -f -i
zpty -w shell "PS1=; fpath=(${(q)1} \$fpath); autoload -Uz compinit; compinit -D -u"
# With -O, -A or -D nothing is added.
zpty -w shell 'compadd() {
  if [[ ${@[1,(i)(-|--)]} != *-(O|A|D)\ * ]]; then
    local -a found folder
    zparseopts -E p:=folder
    builtin compadd -A found "$@"
    print -rl -- ${IPREFIX}${folder[2]}${^found} >>'${(q)hits}'
  fi
  builtin compadd "$@"
}'
zpty -w shell 'finish() print DO""NE; zle -N finish; bindkey "^X" finish; bindkey "^I" complete-word'
zpty -w shell 'print REA""DY'
zpty -r -m shell said '*READY*'
zpty -n -w shell "$2"$'\t\x18'
zpty -r -m shell said '*DONE*'
zpty -d shell
for word in "${(@f)$(<$hits)}"; do print -r -- "${(Q)word}"; done
