#!/bin/sh
# cloudmill, the pipe in one command: what it prints is what it runs, its program is that of the
# stages typed by hand, and its status is the worst of theirs.
. "${SRC:-$(dirname "$0")/../..}/tests/lib/lib.sh"
cd "$TMP" || exit 1

# A low dome, 40 x 30 mm, in a folder with a blank.
mkdir "a b"
awk 'BEGIN { for (x = -20; x <= 20; x += 0.5) for (y = -15; y <= 15; y += 0.5)
	printf "%.3f %.3f %.4f\n", x, y, 10 - (x * x + y * y) / 120 }' >"a b/it's.xyz"
scan="a b/it's.xyz"

status 0 "a program in one command" cloudmill "$scan" -r 4 -c siemens -o part.mpf -s 0.05 -k kept
cp err said
has "ncverify accepts it" '^verdict +accepted' out
has "and the last line says so" '^cloudmill: part.mpf is written and accepted' err
ok "picture and page are beside it" test -s part.svg -a -s part.html
mkdir typed
sed -n 's/^\$ //p' said | sed -e 's,kept/,typed/,g' -e 's/part\./typed\/part./g' >commands.sh
ok "the commands can be typed as printed" sh -eu commands.sh
same "and give the same program" part.mpf typed/part.mpf
status 0 "nothing is run with -n" cloudmill "$scan" -n -r 4 -c siemens -o dry.mpf -s 0.05
sed -n 's/^\$ //p' err | sed 's/dry\./part./g; s/streams/kept/g' >dry
sed -n 's/^\$ //p' said >commands
same "the same commands" dry commands
fails "no program" test -e dry.mpf

status 0 "B-splines for a Fanuc" cloudmill "$scan" -f splines -r 4 -c fanuc -o part.nc -s 0.1
has "are in it" 'G06\.2' part.nc
status 0 "options of meshnorm after --" cloudmill "$scan" -f points -r 4 -c linuxcnc -o part.ngc -s 0.1 \
	-- --fixed 0,0,1
status 0 "NURBS surfaces" cloudmill "$SRC/samples/saddle.nurbs" -f points -r 3 -c heidenhain -o part.h -s 0.3

# A trough that the ball does not fit.
awk 'BEGIN { for (x = -10; x <= 10; x += 0.5) for (y = 0; y <= 20; y += 0.5) {
	r = 16 - x * x; printf "%.3f %.3f %.4f\n", x, y, (r > 0 ? -sqrt(r) : 0) } }' >trough.xyz
status 3 "what is not kept" cloudmill trough.xyz -r 6 -c siemens -o trough.mpf -s 0.1
has "is told at the end" '^cloudmill: trough.mpf is written, but not all .* UNMET in its head' err
ok "is written" test -s trough.mpf
has "is in its head" 'UNMET: meshnorm: the ball' trough.mpf

status 0 "doctor" cloudmill doctor trough.xyz
has "the size and the unit that was taken" '20 x 20 x 4 mm, their unit taken as mm' out
has "which balls fit" 'R 3: 100 %, R 4: .* R 6: ' out
has "what to begin with" '^suggested cloudmill trough.xyz -r [34] ' out
awk '{ print $1, $2, $3 }' "$SRC/samples/panel_17036.xyz" | sed -n 'p;n;n' >panel.xyz
status 0 "doctor, of a panel" cloudmill doctor panel.xyz
has "a ball that fits everywhere is suggested" \
	'^suggested cloudmill panel.xyz -r 8 -c CONTROL -o part.nc$' out
# Hollows everywhere: grooves of radius 2.5 in a slope, a fifth of the surface; none but small balls fit them.
awk 'BEGIN { for (x = -25; x <= 25; x += 0.5) for (y = 0; y <= 40; y += 0.5) {
	d = x - 12.5 * int(x / 12.5 + (x < 0 ? -0.5 : 0.5)); r = 6.25 - d * d
	printf "%.3f %.3f %.4f\n", x, y, 0.1 * x - (r > 0 ? sqrt(r) : 0) } }' >grooves.xyz
status 0 "doctor, of grooves" cloudmill doctor grooves.xyz
has "no tiny ball is suggested for them" '^suggested cloudmill grooves.xyz -r ([2-9]|[1-9][0-9]) ' out
awk '{ print $1 / 1000, $2 / 1000, $3 / 1000 }' "$scan" >metres.xyz
status 0 "a scan in metres" cloudmill doctor metres.xyz
has "is suspected" 'Try -u m' out
has "and looked at again by what is suggested" '^suggested cloudmill doctor metres.xyz -u m$' out
hasnt "not cut by a ball of a hundred times its size" ' -r [0-9]' out
awk '{ print $1 / 25.4, $2 / 25.4, $3 / 25.4 }' "$scan" >inch.xyz
status 0 "a scan in inches" cloudmill doctor inch.xyz
has "may be one" 'mm long: inches[?] Try -u inch' out
hasnt "no ball is wider than the part" 'R [1-9]' out
status 0 "of a name with a blank and a quote" cloudmill doctor "$scan"
has "a shell reads what is suggested" "^suggested cloudmill 'a b/it'\\\\''s.xyz' -r " out
status 0 "with its unit" cloudmill doctor metres.xyz -u m
hasnt "is none" 'Try -u' out

# Map coordinates.
awk '{ printf "%.3f %.3f %.4f\n", $1 + 350000, $2 + 5600000, $3 }' "$scan" >map.xyz
status 0 "doctor, of map coordinates" cloudmill doctor map.xyz
has "no machine reaches there" 'lies 5.6e\+06 mm from the zero of its coordinates' out
has "what moves it is suggested" '^suggested cloudmill map.xyz -O -r ' out
status 0 "moved" cloudmill map.xyz -O -r 4 -c siemens -o map.mpf -s 0.1
has "the program is at the zero" '^travel X +-?[0-9]{1,2}[.]' out
hasnt "a scan at the zero is not far away" 'farther than machines travel' err
status 2 "a model is not moved" cloudmill "$SRC/samples/saddle.nurbs" -O -r 4 -c siemens -o x.mpf

status 2 "no radius" cloudmill "$scan" -c siemens -o x.mpf
has "how to find one" 'expected -r MM' err
status 2 "no output" cloudmill "$scan" -r 4 -c siemens
status 2 "an unknown option" cloudmill "$scan" --avoid -r 4 -c siemens -o x.mpf
status 1 "no such scan" cloudmill nothing.xyz -r 4 -c siemens -o x.mpf
echo "no points" >bad.xyz
status 1 "a stage that fails ends it" cloudmill bad.xyz -r 4 -c siemens -o x.mpf
hasnt "before the next" '^\$ meshnorm' err
fails "no program" test -e x.mpf
status 1 "doctor, of no points" cloudmill doctor bad.xyz
has "is told as an error" '^cloudmill: bad.xyz: no points' err
empty "and not as what is in it" out

# Results with one name, or with the scan's: one of them would be lost.
for name in x.svg x.html; do
	status 2 "a program in $name" cloudmill "$scan" -r 4 -c siemens -o $name
	has "is the picture's or the page's" "^cloudmill: option -o: found $name, expected another name" err
done
status 2 "a program in standard output" cloudmill "$scan" -r 4 -c siemens -o -
status 2 "a folder" cloudmill "$scan" -r 4 -c siemens -o "a b/"
mkdir over
cp "$scan" over/own
for name in own.svg own.html path.cl; do ln -s own over/$name; done
status 2 "a program over its scan" cloudmill over/own -r 4 -c siemens -o over/own
has "is told" '^cloudmill: over/own: found the scan' err
status 2 "a picture over its scan" cloudmill over/own.svg -r 4 -c siemens -o over/own.mpf
status 2 "a page over its scan" cloudmill over/own.html -r 4 -c siemens -o over/own.mpf
status 2 "a stream over its scan" cloudmill over/own -r 4 -c siemens -k over -o x.mpf
same "the scan is as it was" over/own "$scan"
mkfifo pipe
status 1 "a pipe is no scan" cloudmill pipe -r 4 -c siemens -o x.mpf
has "for it is read more than once" 'pipe: found no file, expected one' err
mkdir -p dot.d/in
status 0 "a program without an ending, in a folder with a dot" \
	cloudmill "$scan" -f points -r 4 -c siemens -o dot.d/part -s 0.2
ok "has picture and page beside it" test -s dot.d/part.svg -a -s dot.d/part.html
fails "not beside the folder" test -e dot.svg
cd dot.d/in || exit 1
status 0 "and one in the folder above" cloudmill "../../$scan" -f points -r 4 -c siemens -o ../up -s 0.2
cd ../.. || exit 1
ok "too" test -s dot.d/up.svg -a -s dot.d/up.html
status 0 "-h" cloudmill -h
status 1 "no room for files" env TMPDIR=/no/such/folder cloudmill doctor "$scan"
has "is told" '^cloudmill: no folder can be made in /no/such/folder, expected' "$TMP/err"
done_testing
