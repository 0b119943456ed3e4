#!/bin/sh
# completions.sh - completions for bash, zsh and fish, made from the tables of options: from what each
# tool says with --help all.  Usage: completions.sh BIN FOLDER; writes FOLDER/TOOL, FOLDER/_TOOL and
# FOLDER/TOOL.fish for each tool in BIN.  Tools that do not run here (another machine's) get none.
set -eu
bin=$1
to=$2
LC_ALL=C
export LC_ALL
mkdir -p "$to"

# A line for each option: letter (or -), name (or -), value (or -), help.
options() { # TOOL
	"$1" --help all 2>/dev/null | awk '
	function flush() { if (pending != "") print pending "\t" help; pending = "" }
	/^  (-[A-Za-z]|    ) ?/ && match($0, /^  (-[A-Za-z], --|-[A-Za-z], -|-[A-Za-z]( |$)|    --)/) {
		flush()
		rest = substr($0, 3)
		letter = name = value = "-"
		if (rest ~ /^-[A-Za-z]/) { letter = substr(rest, 2, 1); rest = substr(rest, 3) }
		sub(/^,? +/, "", rest)
		sub(/^-[A-Za-z] +/, "", rest) # `-h, -V  help, version`
		if (rest ~ /^--/) { match(rest, /^--[a-z0-9-]+/); name = substr(rest, 3, RLENGTH - 2)
			rest = substr(rest, RLENGTH + 1)
			if (rest ~ /^ [^ ]/) { match(rest, /^ [^ ]+/); value = substr(rest, 2, RLENGTH - 1)
				rest = substr(rest, RLENGTH + 1) } }
		else if (rest ~ /^[^ ]+ ? ?(  |$)/ && $2 ~ /^[A-Za-z|]+$/ && ($2 == toupper($2) || $2 ~ /\|/)) {
			value = $2; sub(/^[^ ]+/, "", rest) }
		sub(/^ +/, "", rest)
		help = rest
		pending = letter "\t" name "\t" value
		next }
	/^        / && pending != "" { sub(/^ +/, ""); help = help (help == "" ? "" : " ") $0; next }
	/^$/ || /^[^ ]/ { flush() }
	END { flush() }'
}

# The words that a value may be, those of `one|two|MM` in small letters; a folder of installed files
# for some; `file`; or nothing.
words='
function words(name, letter, value,   n, part, i, list) {
	if (name == "machine" || (name == "-" && letter == "m")) return "@machines"
	if (name == "control" || (name == "-" && letter == "c")) return "@controls"
	if (name == "tool-file") return "@tools"
	n = split(value, part, "|")
	for (i = 1; i <= n; i++) if (part[i] ~ /^[a-z][a-z0-9-]*$/) list = list (list ? " " : "") part[i]
	if (list) return list
	return value ~ /^(FILE|FOLDER|PROGRAM)/ ? "@file" : ""
}'

bash_completion() { # TOOL, options on standard input
	awk -F '\t' -v tool="$1" "$words"'
	BEGIN { print "# bash completion for " tool ", made by completions.sh from its --help all"
		print "_cloudmill_" tool "()\n{"
		print "\tlocal cur=${COMP_WORDS[COMP_CWORD]} prev=${COMP_WORDS[COMP_CWORD - 1]} data"
		print "\tdata=$(command -v -- \"$1\") && data=${data%/*}/../share/cloudmill"
		print "\tCOMPREPLY=()\n\tcase $prev in" }
	{ both = ($1 != "-" ? "-" $1 : "") ($1 != "-" && $2 != "-" ? " | " : "") ($2 != "-" ? "--" $2 : "")
	  all = all " " ($2 != "-" ? "--" $2 : "-" $1)
	  if ($3 == "-") next
	  w = words($2, $1, $3)
	  printf "\t%s)\n", both
	  if (w == "@file") print "\t\tmapfile -t COMPREPLY < <(compgen -f -- \"$cur\")"
	  else if (w ~ /^@/) {
		print "\t\tmapfile -t COMPREPLY < <(compgen -W \"$(cd \"$data/" substr(w, 2) "\" 2>/dev/null &&"
		print "\t\t\tfor f in *.txt; do printf \"%s \" \"${f%.txt}\"; done)\" -- \"$cur\")" }
	  else if (w != "") print "\t\tmapfile -t COMPREPLY < <(compgen -W \"" w "\" -- \"$cur\")"
	  print "\t\treturn\n\t\t;;" }
	END { print "\tesac"
		print "\tif [[ $cur == -* ]]; then"
		print "\t\tmapfile -t COMPREPLY < <(compgen -W \"" substr(all, 2) "\" -- \"$cur\")"
		print "\telse\n\t\tmapfile -t COMPREPLY < <(compgen -f -- \"$cur\")\n\tfi\n}"
		print "complete -o filenames -F _cloudmill_" tool " " tool }'
}

zsh_completion() {
	awk -F '\t' -v tool="$1" -v q="'" "$words"'
	function plain(s) { gsub(/\\/, "\\\\", s); gsub(/\[|\]|:/, "\\\\&", s); gsub(q, q "\\" q q, s); return s }
	BEGIN { print "#compdef " tool "\n# made by completions.sh from its --help all"
		print "local data=${commands[" tool "]:h}/../share/cloudmill"
		print "_arguments -s \\" }
	{ w = words($2, $1, $3); value = ""
	  if ($3 != "-") {
		action = w == "@file" ? "_files" : \
			w ~ /^@/ ? "{compadd -- $data/" substr(w, 2) "/*.txt(N\\:t\\:r)}" : \
			w != "" ? "(" w ")" : " "
		value = ":" plain($3) ":" action }
	  text = "[" plain($4) "]" value
	  if ($1 != "-" && $2 != "-")
		printf "  %s(-%s --%s)%s{-%s,--%s}%s%s%s \\\n", q, $1, $2, q, $1, $2, q, text, q
	  else printf "  %s%s%s%s \\\n", q, $2 != "-" ? "--" $2 : "-" $1, text, q }
	END { print "  " q "*:file:_files" q }'
}

fish_completion() {
	awk -F '\t' -v tool="$1" -v q="'" "$words"'
	function plain(s) { gsub(/\\/, "\\\\", s); gsub(q, "\\" q, s); return s }
	BEGIN { print "# made by completions.sh from the --help all of " tool
		print "set -g __cloudmill_data (status dirname)/../../cloudmill" }
	{ w = words($2, $1, $3)
	  line = "complete -c " tool ($1 != "-" ? " -s " $1 : "") ($2 != "-" ? " -l " $2 : "")
	  if ($3 != "-") line = line (w == "@file" ? " -r -F" : " -x")
	  if (w ~ /^@(machines|controls|tools)/)
		line = line " -a " q "(for f in $__cloudmill_data/" substr(w, 2) "/*.txt; basename $f .txt; end)" q
	  else if (w != "" && w != "@file") line = line " -a " q w q
	  print line " -d " q plain($4) q }'
}

for tool in "$bin"/*; do
	name=$(basename "$tool" .exe)
	options "$tool" >"$to/.options"
	if [ ! -s "$to/.options" ]; then
		echo "completions: $name does not run here: none" >&2
		continue
	fi
	bash_completion "$name" <"$to/.options" >"$to/$name"
	zsh_completion "$name" <"$to/.options" >"$to/_$name"
	fish_completion "$name" <"$to/.options" >"$to/$name.fish"
done
rm -f "$to/.options"
