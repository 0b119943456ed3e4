#!/bin/sh
# parallel.sh [-n PARTS] [-s HOSTS] FITTER PATH OUT [OPTION...] - a path fitted in parts by GNU
# parallel, here or on other machines; the parts joined are what one run writes, byte by byte.
#
# FITTER: biarcfit or bsplfit, with OPTIONs.  -n: how many parts (default: two for each processor
# here).  -s: hosts as parallel's --sshlogin has them, `:` for this one; each needs the tools in
# its PATH, ssh without a password, and rsync.  A part whose worker dies is run again, three times
# in all, elsewhere if there is an elsewhere.  BIN: where the tools are here.
# Exit status 3: a part could not keep what was asked, as OUT says.  cloudmill-parallel(7).
usage() {
	echo "usage: parallel.sh [-n PARTS] [-s HOSTS] FITTER PATH OUT [OPTION...]" >&2
	exit 2
}
parts=$(($(getconf _NPROCESSORS_ONLN) * 2)) hosts=:
while getopts n:s: option; do
	case $option in
	n) parts=$OPTARG ;;
	s) hosts=$OPTARG ;;
	*) usage ;;
	esac
done
shift $((OPTIND - 1))
[ $# -ge 3 ] || usage
case $parts in
10000) ;; # as many as --part takes
'' | 0* | *[!0-9]* | ?????*)
	echo "parallel.sh: found \`$parts' parts, expected 1 to 10000" >&2
	exit 2
	;;
esac
fitter=$1 path=$2 out=$3
shift 3
if [ -e "$out" ] && [ ! -f "$out" ]; then
	echo "parallel.sh: found \`$out', which is no file, expected a name for the fitted path" >&2
	exit 2
fi
for option; do
	case $option in
	--part | --part=*)
		echo "parallel.sh: found $option, expected -n: which part is fitted is said here" >&2
		exit 2
		;;
	esac
done
PATH=${BIN:+$BIN:}$PATH
export PATH
command -v parallel >/dev/null || {
	echo "parallel.sh: found no GNU parallel, expected it in PATH" >&2
	exit 1
}
work=$(mktemp -d "${TMPDIR:-/tmp}/parallel.XXXXXX") || exit 1
trap 'rm -rf "$work"' EXIT
trap 'exit 130' INT TERM

# ship_scan FILE: it is shipped under a name of its own, in $name.
ship_scan() {
	n=$((n + 1))
	name=scan-$n-$(basename "$1" | tr -c 'A-Za-z0-9.\n' _)
	cp "$1" "$work/$name" || exit 1
	printf '%s\n%s\n' "$name" "$1" >>"$work/scans"
	ship="$ship --basefile $name"
}

# rename_scan FILE FROM TO: what the path in FILE calls a scan.
rename_scan() {
	awk -v from="$(printf %s "$2" | sed 's/\\/&&/g')" -v to="$(printf %s "$3" | sed 's/\\/&&/g')" '
		match($0, /^\$\$-> SCAN\/[0-9]*,[0-9a-f]*,/) && substr($0, RLENGTH + 1) == from {
			$0 = substr($0, 1, RLENGTH) to
		}
		{ print }' "$1" >"$work/renamed" && mv "$work/renamed" "$1" || exit 1
}

# What is shipped: the path, the scans that it or an option names, what is to be done with a part.
cp "$path" "$work/path.cl" || exit 1
ship='--basefile path.cl --basefile part.sh' n=0
: >"$work/scans"
case " $* " in *' -g'* | *' --guard'* | *' --no-guard '*) named=/dev/null ;; *) named=$path ;; esac
sed -n 's/^\$\$-> SCAN\/[0-9]*,[0-9a-f]*,//p' "$named" >"$work/named"
while IFS= read -r scan; do
	[ -f "$scan" ] || continue # each part says that it is gone, as one run does
	ship_scan "$scan"
	rename_scan "$work/path.cl" "$scan" "$name"
done <"$work/named"
quoted='' before=''
for option; do
	as=$option
	case $before in -g | --guard) ship_scan "$option" && as=$name ;; esac
	case $option in
	-g?*) ship_scan "${option#-g}" && as=-g$name ;;
	--guard=*) ship_scan "${option#*=}" && as=--guard=$name ;;
	esac
	before=$option option=$as
	quoted="$quoted '$(printf %s "$option" | sed "s/'/'\\\\''/g")'"
done
cat >"$work/part.sh" <<END
exec 2>"said.\$1"
$fitter -q -j 1 --part "\$1/$parts" -o "fitted.\$1" $quoted path.cl
s=\$?
echo \$s >"status.\$1"
[ \$s -eq 0 ] || [ \$s -eq 3 ]
END

here=$(pwd)
cd "$work" || exit 1
if [ "$hosts" = : ]; then
	how="--workdir $work"
else
	how="--workdir .cloudmill-$(basename "$work") --cleanup --return fitted.{} --return status.{} --return said.{} $ship"
fi
# shellcheck disable=SC2086 # options, one by one
seq "$parts" | parallel --sshlogin "$hosts" --retries 3 $how sh part.sh '{}'
ran=$?
cat said.* 2>/dev/null | sort -u >&2
for k in $(seq "$parts"); do
	[ -e "fitted.$k" ] && [ -e "status.$k" ] && continue
	echo "parallel.sh: part $k of $parts could not be fitted (parallel: $ran); nothing is written" >&2
	exit 1
done
for k in $(seq "$parts"); do
	cat "fitted.$k"
done >joined
# The scans have their own names again.
while IFS= read -r name && IFS= read -r scan; do
	rename_scan joined "$name" "$scan"
done <scans
cd "$here" && mv "$work/joined" "$out" || exit 1
! grep -q 3 "$work"/status.* || exit 3
