#!/bin/sh
# ncverify-options.t - what the options of ncverify say beside the head of a program, and what is told
# where they contradict each other, it, or what is there.
. "${SRC:-$(dirname "$0")/../..}/tests/lib/lib.sh"
cd "$TMP" || exit 1

awk 'BEGIN { for (i = 0; i <= 16; i++) for (k = 0; k <= 12; k++) {
	x = 2.5 * i - 20; y = 2.5 * k - 15; print x, y, 10 - (x * x + y * y) / 120 } }' >scan.xyz
cloud2mesh -q -t 4 scan.xyz -o scan.ply
meshnorm -q -r 4 --rows mesh --fixed 0,0,1 --avoid scan.ply -o path.cl
ncpost -q -c fanuc path.cl -o good.nc
status 0 "a program and its scan" ncverify -q -g scan.xyz good.nc

# wrong usage: nothing is read, one line, status 2
refused() { # DESC WHAT OPTION...
	desc=$1 what=$2
	shift 2
	status 2 "$desc" ncverify -q "$@"
	has "... is told" "$what" err
}
refused "no part" 'expected -g, the scan or mesh' good.nc
refused "two programs" 'found 2 programs, expected one' -g scan.xyz good.nc good.nc
refused "--left and --scallop" 'found --left and --scallop' -g scan.xyz --left 1 --scallop 1 good.nc
refused "--ball-only with a holder" 'found --ball-only with --flute, --holder or --tool-file' \
	-g scan.xyz --ball-only --holder 9:9 good.nc
refused "... with a flute" 'found --ball-only with' -g scan.xyz --ball-only --flute 9 good.nc
refused "a stock of no kind" 'option --stock: found .cylinder' -g scan.xyz --stock cylinder good.nc
refused "a band below the tolerance" 'option --band: found 0.01, expected more than the tolerance 0.1' \
	-g scan.xyz -e 0.1 --band 0.01 good.nc
status 0 "a tolerance of half the radius has a band" ncverify -q -g scan.xyz -e 2 good.nc
refused "a holder that is none" 'option --holder' -g scan.xyz --holder 9 good.nc
refused "no control for standard input" 'give its control by -c' -r 4 -g scan.xyz -

# a pipe with a name is read once, as standard input is
mkfifo pipe
refused "no control for a pipe" 'give its control by -c' -r 4 -g scan.xyz pipe
ncverify -q -c fanuc -g scan.xyz good.nc | sed 's/good.nc/pipe/' >want
cat good.nc >pipe &
writer=$!
status 0 "a program by a pipe with a name" within 60 ncverify -q -c fanuc -g scan.xyz pipe
[ "$got" -eq 0 ] || kill $writer
wait $writer
same "... is judged as the file is" out want
sed '/TOOL: /d;/ball nose/d' good.nc >bare.nc
refused "no ball" 'expected -r, the radius of the ball' -g scan.xyz bare.nc

# what is not there, or nothing
status 1 "no such program" ncverify -q -g scan.xyz none.nc
has "... is told" 'none.nc' err
status 1 "no such part" ncverify -q -g none.xyz good.nc
has "... is told" 'none.xyz' err
status 1 "no such machine" ncverify -q -m none-such -g scan.xyz good.nc
has "... is told" 'none-such' err
printf 'hello\nworld\n' >text.nc
status 1 "a text that is no program" ncverify -q -r 4 -g scan.xyz text.nc
printf '# nothing\n' >empty.xyz
status 1 "a part without points" ncverify -q -r 4 -g empty.xyz good.nc
has "... is told" 'empty.xyz' err
awk 'cut && !done && sub(/ X-?[0-9.]+/, " X400000.") { done = 1 } / G1 / { cut = 1 } { print }' good.nc >far.nc
status 1 "a move of 400 m" ncverify -q -g scan.xyz far.nc
has "... is told with its line" '^ncverify: far.nc:[0-9]+: N[0-9]+: found moves of more than 10 m' err

# the head and the options
status 0 "another name for the control" ncverify -c haas -g scan.xyz good.nc
has "... is told" "the program's head says the control FANUC, it is read as one for haas" err
ncpost -q -c fanuc --set number.step=5 path.cl -o set.nc
status 0 "a program made with --set" ncverify -g scan.xyz set.nc
has "... is told" 'the program was made with --set NUMBER.STEP=5' err
sed 's/TABLE-AC/TABLE-OF-NOBODY/' good.nc >unknown.nc
run ncverify -v -g scan.xyz unknown.nc
has "a machine that is not there is told" 'the program.s head says table-of-nobody, and there is no such file here' err

# the noise that the scan was said to have when the path was made: in the head, or else in the path
meshnorm -q -r 4 --rows mesh --fixed 0,0,1 --avoid --noise 0.004 scan.ply -o noisy.cl
biarcfit -q noisy.cl -o noisy-arcs.cl
told='noise of the scan: 0.004 mm, as the program.s head or path says'
for control in fanuc siemens heidenhain linuxcnc; do
	ncpost -q -c $control noisy-arcs.cl -o noisy.nc
	status 0 "$control: a program of a scan with noise" ncverify -g scan.xyz noisy.nc
	has "$control: ... whose noise is told" "$told" err
	has "$control: ... and taken out" '^part .*, noise 0.0040 mm' out
	ncverify -g scan.xyz --noise 0 noisy.nc >out 2>err
	hasnt "$control: ... unless it is said" noise out
	sed 's/NOISE: /NOTHING /' noisy.nc >silent.nc
	ncverify -c $control -g scan.xyz silent.nc >out 2>err
	hasnt "$control: the head says it, not the reader" noise out
	ncverify -c $control -g scan.xyz -p noisy-arcs.cl silent.nc >out 2>err
	has "$control: the path says it, too" "$told" err
done
sed 1d scan.xyz >another.xyz
ncverify -g another.xyz noisy.nc >out 2>err
hasnt "of another scan it is measured" noise out
has "that it is another one is told" \
	"another.xyz: $(wc -l <another.xyz) points, none of the scan of $(wc -l <scan.xyz) that" err
sed -n '1p;$p' scan.xyz >two.xyz
status 1 "two points of the scan" ncverify -g two.xyz noisy.nc
has "judge nothing" 'two.xyz: found 2 points, expected the scan of [0-9]+ ' err

# the tolerance: what the head of a program says that a scan guarded, else 0.05 or that if it is more
biarcfit -q -e 0.01 path.cl -o arcs.cl
ncpost -q -c fanuc arcs.cl -o arcs.nc
T=$(awk '/TOLERANCE CLOUD2MESH/ { mesh = $3 + 0 } /TOLERANCE: / { sub(/.*TOLERANCE: /, ""); print $0 - mesh }' arcs.nc)
status 0 "a program and its scan" ncverify -v -g scan.xyz arcs.nc
has "... judged by the tolerance that its head says" "tolerance: $T mm \\(as the program.s head says\\)" err
awk -v down=0.17 '/ G1 / { cut = 1 } cut && !done && match($0, / Z-?[0-9.]+/) && !/G53|G28|G0 / { n++
	if (n == 12) { $0 = substr($0, 1, RSTART + 1) (substr($0, RSTART + 2, RLENGTH - 2) - down) substr($0, RSTART + RLENGTH); done = 1 } }
	{ print }' good.nc >deep.nc
status 3 "0.03 mm deep, where the head says less" ncverify -q -g scan.xyz deep.nc
has "... is told" 'the ball is 0.0[0-9]* mm deep in the part at .*, tolerance 0.01' out
status 0 "... unless more is allowed" ncverify -q -e 0.05 -g scan.xyz deep.nc
sed 's/SCAN: /NOTHING /' deep.nc >foreign.nc
status 0 "... or no scan guarded it" ncverify -q -g scan.xyz foreign.nc
sed 's/TOLERANCE: [0-9.]*/TOLERANCE: 0.3/' foreign.nc >rough.nc
status 0 "a program of a rough path" ncverify -g scan.xyz rough.nc
has "... is judged by that" 'tolerance: 0.3 mm' err

# the tool of files: its ball, flute and holder, as options say them
printf 'name = short ball\nradius = 4\nflute = 9\nshank = 4\nlength = 60\nstickout = 30\n' >ball.txt
printf 'name = holder\nholder = 12:20\n' >holder.txt
status 0 "a tool of files" ncverify -v -g scan.xyz --tool-file ball.txt --tool-file holder.txt -o by-file good.nc
status 0 "the same by options" ncverify -q -g scan.xyz --flute 9 --holder 4:17+12:20 -o by-option good.nc
same "... judged alike" by-file by-option
printf 'name = long\nradius = 4\nflute = 2\nshank = 60\nlength = 60\nstickout = 3\n' >thick.txt
status 3 "a tool that meets the part is refused" ncverify -q -g scan.xyz --tool-file thick.txt good.nc
has "... with its depth" '^fault .* (shaft|holder|shank|tool|flute)' out
status 1 "a file without a tool" ncverify -q -g scan.xyz --tool-file scan.xyz good.nc

# the map
status 0 "--map" ncverify -q -g scan.xyz --map map.ply good.nc
has "has all points" "^element vertex $(wc -l <scan.xyz)\$" map.ply
done_testing
