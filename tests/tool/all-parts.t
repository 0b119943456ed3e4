#!/bin/sh
# all-parts.t - a path fitted and posted in parts is what one run writes, byte by byte; samples/
# parallel.sh does it with GNU parallel, here and on hosts, and runs a killed worker's part again.
. "${SRC:-$(dirname "$0")/../..}/tests/lib/lib.sh"

passes=$SRC/tests/data/panel_passes.cl
cd "$TMP" || exit 1

# parts N COMMAND...: the parts joined, in `joined`; fails when one fails
parts() {
	n=$1
	shift
	for k in $(seq "$n"); do
		"$@" --part "$k/$n" -o "part.$k" || return 1
	done
	for k in $(seq "$n"); do
		cat "part.$k"
	done >joined
}

for fitter in biarcfit bsplfit; do
	ok "$fitter: the whole" $fitter -q -e 0.01 -o whole.$fitter "$passes"
	for n in 3 11; do
		ok "$fitter in $n parts" parts $n $fitter -q -e 0.01 "$passes"
		same "$fitter: $n parts joined are the whole" joined whole.$fitter
	done
	ok "the head is in the first part" grep -q '^PARTNO\|^UNITS' part.1
	hasnt "and in no other" '^UNITS' part.2
	hasnt "no part but the last has an end" '^FINI' part.1
	for control in fanuc siemens heidenhain linuxcnc; do
		ok "$fitter, $control: the whole" ncpost -q -c $control --no-spindle -o whole.nc whole.$fitter
		ok "$fitter, $control: 4 parts" parts 4 ncpost -q -c $control --no-spindle whole.$fitter
		same "$fitter, $control: joined they are the program" joined whole.nc
	done
done
status 1 "a part that is not the last is no path" ncpost -c fanuc part.1

# Parts in another order, one missing, one twice: told with both numbers, in the program too.
biarcfit -q -e 0.01 -o whole.cl "$passes"
parts 4 biarcfit -q -e 0.01 "$passes"
same "four parts" joined whole.cl
has "the head lists the passes" '^\$\$-> PASSES/1,THRU,[0-9]+$' part.1
number='pass [0-9]+'
# wrong WHAT FOUND PARTS: what ncpost and a fitter say of these parts
wrong() {
	what=$1 found=$2
	shift 2
	cat "$@" >joined
	status 3 "$what" ncpost -q -c siemens --no-spindle -o wrong.mpf joined
	has "ncpost tells it" "^ncpost: unmet, path: $found" err
	has "and the program" '^; UNMET: path: found ' wrong.mpf
	ok "which is whole" grep -q '^N[0-9]* M30' wrong.mpf
	status 3 "a fitter" bsplfit -q -o wrong.cl joined
	has "tells it" "^bsplfit: unmet before, path: $found" err
	has "and hands it on" '^\$\$-> UNMET/path,found ' wrong.cl
	status 0 "accepted" ncpost -q -c siemens --no-spindle --accept -o wrong.mpf joined
}
wrong "two in the wrong order" "found $number after $number, expected $number, as PASSES of" \
	part.1 part.3 part.2 part.4
wrong "one missing" "found $number after $number, expected $number, as" part.1 part.2 part.4
wrong "one twice" "found $number after $number, expected $number, as" \
	part.1 part.2 part.2 part.3 part.4
wrong "the last too early" "found $number after $number, expected $number, as" \
	part.1 part.2 part.4 part.3
wrong "the first later" "found $number, expected pass 1, as" part.2 part.1 part.3 part.4
wrong "the first missing" "found passes of biarcfit without the head" part.2 part.3 part.4
awk '/PASS\// { n++ } n < 2 || /^FINI/' part.4 >short
wrong "its end missing" "found the end after $number, expected $number, as" \
	part.1 part.2 part.3 short
grep -v PASSES joined >by-hand.cl
status 0 "passes taken out on purpose, and the list of them" \
	ncpost -q -c siemens --no-spindle -o wrong.mpf by-hand.cl
awk '/PASS\// { n++ } n > 1 { exit } { print } END { print "FINI" }' "$passes" >one
biarcfit -q -o one.cl one
has "a path of one pass" 'PASSES/1$' one.cl
status 0 "is sound" ncpost -q -c siemens --no-spindle -o one.mpf one.cl
grep -v 'PASS/' "$passes" >bare.cl
biarcfit -q -o bare-fitted.cl bare.cl
hasnt "a path of no passes has no list" PASSES bare-fitted.cl
spent() { sed -n 's/^.*LEDGER\/biarcfit,//p' "$1"; }
ok "what was spent is said for each pass" [ "$(spent whole.biarcfit | wc -l)" -eq \
	"$(grep -c 'PASS/' whole.biarcfit)" ]
status 0 "the whole ledger" ncpost -v -c fanuc --no-spindle -o /dev/null whole.biarcfit
said=$(sed -n 's/.*with the stages before \([0-9.]*\) mm/\1/p' err)
below "of the passes the largest counts" \
	"$(spent whole.biarcfit | sort -n | tail -n 1)" "$said"
below "and no sum" "$said" 0.03
for part in 0/3 4/3 x 1/ 1/10001; do
	status 2 "biarcfit --part $part" biarcfit --part $part "$passes"
	status 2 "ncpost --part $part" ncpost -c fanuc --part $part whole.biarcfit
done
status 2 "a part of one of the programs of --split" \
	ncpost -c fanuc --part 1/2 --split 100 -o x.nc whole.biarcfit

# ---- GNU parallel

command -v parallel >/dev/null || skip_rest "GNU parallel is not installed"
together=$SRC/samples/parallel.sh
status 0 "in parallel" sh "$together" -n 3 biarcfit "$passes" joined -e 0.01
same "in parallel it is the same" joined whole.biarcfit
status 0 "in parallel, B-splines and more options" \
	sh "$together" -n 2 bsplfit "$passes" joined -e 0.02 --degree 4
bsplfit -q -e 0.02 --degree 4 -o whole.cl "$passes"
same "with the same options" joined whole.cl
mkdir bin
# A worker that is killed the first time.
cat >bin/biarcfit <<END
#!/bin/sh
case \$* in *--part\ 2/3*) [ -e "$TMP/killed" ] || { : >"$TMP/killed" && kill -9 \$\$; } ;; esac
exec "$BIN/biarcfit" "\$@"
END
chmod +x bin/biarcfit
status 0 "a worker is killed" env BIN="$TMP/bin" sh "$together" -n 3 biarcfit "$passes" joined
ok "it was" test -e killed
same "its part is run again" joined whole.biarcfit
mkdir folder
echo precious >folder/joined
status 2 "OUT is a folder" sh "$together" -n 2 biarcfit "$passes" folder
has "it is said" "found .folder', which is no file" err
ok "what is in it stays" grep -qx precious folder/joined
for part in "--part 1/2" --part=2/2; do
	# shellcheck disable=SC2086 # an option and its argument
	status 2 "$part handed on" sh "$together" -n 3 biarcfit "$passes" none.out $part
	has "it is said" "found --part.*, expected -n" err
	ok "nothing is written" test ! -e none.out
done
status 1 "no such path" sh "$together" -n 2 biarcfit none.cl none.out
status 1 "an option that is none" sh "$together" -n 2 biarcfit "$passes" none.out --wrong
ok "nothing is written" test ! -e none.out
for n in 0 -1 x 2.5 10001 ''; do
	status 2 "-n '$n'" sh "$together" -n "$n" biarcfit "$passes" none.out
	ok "nothing is written" test ! -e none.out
done

# ---- hosts, each a folder with a shell

command -v rsync >/dev/null || skip_rest "rsync is not installed"
cat >ssh <<END
#!/bin/sh
while [ \$# -gt 0 ]; do
	case \$1 in -l | -p | -o) shift 2 ;; -*) shift ;; *) break ;; esac
done
HOME=$TMP/home-\$1
shift
[ "\$1" = -- ] && shift
SHELL=/bin/sh
case \$HOME in *bare) PATH=/usr/bin:/bin ;; esac
export HOME SHELL PATH
mkdir -p "\$HOME" && cd "\$HOME" && exec sh -c "\$*"
END
chmod +x ssh
awk 'BEGIN { for (i = -20; i <= 20; i++) for (j = -10; j <= 10; j++)
	printf "%.4f %.4f %.4f\n", i, j, 4 * cos(i / 8) * cos(j / 9) }' >scan.xyz
cloud2mesh -q -t 2 -o mesh.ply scan.xyz
meshnorm -q -r 4 --scallop 0.2 -o guarded.cl mesh.ply
biarcfit -q -o whole.cl guarded.cl
whole=$?
PARALLEL_SSH=$TMP/ssh
export PARALLEL_SSH
status $whole "on two hosts, with the scan" \
	sh "$together" -n 3 -s one,two biarcfit guarded.cl joined
has "the path names its scan" 'SCAN/.*scan.xyz' whole.cl
same "on two hosts it is the same" joined whole.cl
# A scan that is gone, was standard input, or has other points since: said, fitted, as in one run.
mkdir gone
sed 's|,[^,]*scan.xyz$|,none.xyz|' guarded.cl >gone/none.cl
sed 's|,[^,]*scan.xyz$|,-|' guarded.cl >gone/pipe.cl
sed '7,9d' scan.xyz >gone/changed.xyz
sed 's|,[^,]*scan.xyz$|,gone/changed.xyz|' guarded.cl >gone/changed.cl
for why in none pipe changed; do
	biarcfit -q -o whole.cl gone/$why.cl 2>whole.err
	status 3 "a scan that does not guard, $why" sh "$together" -n 2 biarcfit gone/$why.cl joined
	has 'it is said' 'does not guard' err
	for cl in whole.cl joined; do grep -v UNMET $cl >$cl.met; done
	same "the same path" joined.met whole.cl.met
done
# A scan that an option names, from here and in a folder with an awkward name.
mkdir "a folder"
cp scan.xyz "a folder/it's.xyz"
for scan in scan.xyz "a folder/it's.xyz"; do
	biarcfit -q -g "$scan" -o whole.cl guarded.cl
	status $whole "-g $scan" sh "$together" -n 2 biarcfit guarded.cl joined -g "$scan"
	same "here" joined whole.cl
	status $whole "-g$scan" sh "$together" -n 2 -s one biarcfit guarded.cl joined "--guard=$scan"
	same "on a host" joined whole.cl
done
status 1 "a host without the tools" \
	sh "$together" -n 2 -s bare biarcfit guarded.cl none.out
ok "nothing is written then" test ! -e none.out
ok "both were used" test -d home-one -a -d home-two
ok "and nothing is left there" [ -z "$(find home-one home-two -type f)" ]

done_testing
