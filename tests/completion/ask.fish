# fish ask.fish FOLDER LINE: what fish offers at the end of the line, with the script in FOLDER; one
# word a line, after a tab what it means.
source $argv[1]/mjforge.fish
complete --do-complete "$argv[2]"
