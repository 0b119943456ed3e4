#!/bin/sh
# manners.t - what every tool does the same way: options, exit status, output, messages.
. "${SRC:-$(dirname "$0")/../..}/tests/lib/lib.sh"
cd "$TMP" || exit 1

# A small cloud, and what each stage makes of it: the input of the next.
awk 'BEGIN { for (i = 0; i <= 20; i++) for (k = 0; k <= 15; k++) {
	x = i - 10; y = k - 7.5; print x, y, 10 - (x * x + y * y) / 120 } }' >cloud.xyz
arguments() { # TOOL: what it needs besides its input
	case $1 in
	cloud2mesh) echo -t 2 ;;
	nurbs2mesh) echo --count 12 ;;
	meshnorm | planecut) echo -r 4 ;;
	ncpost) echo -c siemens ;;
	esac
}
input() { # TOOL
	case $1 in
	cloud2mesh | cloud2surf) echo cloud.xyz ;;
	nurbs2mesh) echo saddle.nurbs ;;
	meshnorm | planecut) echo mesh.ply ;;
	biarcfit | bsplfit) echo path.cl ;;
	ncpost) echo arcs.cl ;;
	esac
}
cp "$SRC/samples/saddle.nurbs" .
cloud2mesh -q -t 2 cloud.xyz >mesh.ply
meshnorm -q -r 4 --rows mesh mesh.ply >path.cl
biarcfit -q path.cl >arcs.cl

# The same by the shell, where redirections matter.
shell() { # STATUS DESC COMMAND-LINE
	status "$1" "$2" sh -c "$3"
}

# shellcheck disable=SC2086,SC2046,SC2012 # words of options and file names of our own
for tool in cloud2mesh cloud2surf nurbs2mesh meshnorm planecut biarcfit bsplfit ncpost; do
	in=$(input $tool)
	set -- $(arguments $tool)
	args=$*

	# help, version, usage
	status 0 "$tool -h" $tool -h
	has "$tool -h says how it is used" "^usage: $tool " out
	empty "$tool -h says nothing else" err
	cp out help
	status 0 "$tool --help" $tool --help
	same "$tool --help is -h" out help
	status 0 "$tool --help all" $tool --help all
	ok "is no shorter" test "$(wc -l <out)" -ge "$(wc -l <help)"
	cat out >>help
	awk '/\t/ || / $/' help >long
	empty "$tool -h has neither tabs nor blanks at the end of lines" long
	status 0 "$tool -V" $tool -V
	has "$tool -V names it and its version" "^$tool .*[0-9]+\.[0-9]+\.[0-9]+" out
	status 2 "$tool: an unknown option" $tool "$@" --no-such $in
	has "$tool: wrong usage is told with the tool's name" "^$tool: " err
	empty "$tool: wrong usage writes nothing" out
	status 2 "$tool: a mistyped option" $tool "$@" --verbos-e $in
	has "names the nearest" 'did you mean --verbose\?' err
	status 2 "$tool -o without a file" $tool "$@" $in -o
	for bad in nan inf 8x '' 1e999 -1 0x10; do
		case $tool in
		cloud2mesh | cloud2surf) status 2 "$tool -t '$bad'" $tool -t "$bad" $in ;;
		meshnorm | planecut) status 2 "$tool -r '$bad'" $tool -r "$bad" $in ;;
		*) status 2 "$tool -e '$bad'" $tool "$@" -e "$bad" $in ;;
		esac
		status 2 "$tool -j '$bad'" $tool "$@" -j "$bad" $in
	done

	# input
	status 1 "$tool: no such file" $tool "$@" no/such/file
	has "$tool: no such file: the message names it" "^$tool: .*no/such/file" err
	empty "$tool: no such file: no output" out
	status 1 "$tool: a folder" $tool "$@" .
	status 1 "$tool: empty input" $tool "$@" /dev/null
	empty "$tool: empty input: no output" out
	shell 1 "$tool: no standard input" "exec $tool $args <&-"
	status 0 "$tool FILE" $tool "$@" $in
	cp out want
	shell 0 "$tool <FILE" "exec $tool $args <$in"
	cp out through
	shell 0 "$tool - <FILE" "exec $tool $args - <$in"
	same "$tool - is standard input" out through
	head -c $(($(wc -c <$in) / 2)) $in | sed '$d' >half
	if [ $tool != cloud2mesh ] && [ $tool != cloud2surf ]; then # half a cloud is a cloud
		status 1 "$tool: half of its input" $tool "$@" half
		empty "$tool: half of its input: no output" out
		shell 1 "$tool: half of its input by a pipe" "cat half | $tool $args"
	fi

	# the same bytes
	for j in 1 2 5; do
		status 0 "$tool -j $j" $tool "$@" -j $j $in
		same "$tool -j $j: the same bytes" out want
	done
	for lang in de_DE.UTF-8 tr_TR.UTF-8 C.UTF-8; do
		has_locale $lang || {
			skip "$tool in $lang" "no locale $lang"
			skip "$tool in $lang: the same bytes" "no locale $lang"
			continue
		}
		status 0 "$tool in $lang" env LC_ALL=$lang $tool "$@" $in
		same "$tool in $lang: the same bytes" out want
	done
	mkdir -p elsewhere
	cp $in elsewhere/
	shell 0 "$tool in another folder" "cd elsewhere && exec $tool $args $in"
	same "$tool in another folder: the same bytes" out want

	# output
	if [ -e /dev/full ]; then
		shell 1 "$tool: full disk" "exec $tool $args $in >/dev/full"
		has "$tool: full disk is told" "^$tool: " err
		status 1 "$tool -o /dev/full" $tool "$@" -o /dev/full $in
	else
		skip "$tool: full disk" "no /dev/full"
	fi
	shell 1 "$tool: standard output closed" "exec $tool $args $in >&-"
	status 0 "$tool -o FILE" $tool "$@" -o file $in
	empty "$tool -o FILE: nothing on standard output" out
	same "$tool -o FILE: the same bytes" file want
	status 0 "$tool FILE -o FILE: options behind operands" $tool $in "$@" -o file
	same "$tool FILE -o FILE: the same bytes" file want
	echo older >file
	status 1 "$tool -o: a failing run" $tool "$@" -o file /dev/null
	echo older >older
	same "$tool -o: a failing run leaves the older file" file older
	mkdir -p dir
	rm -f dir/*
	$tool -q "$@" -o dir/file /dev/null 2>err
	ls -A dir >left
	empty "$tool -o: a failing run leaves nothing beside it" left
	$tool -q "$@" -o dir/file $in 2>err
	ls -A dir >left
	echo file >want_left
	same "$tool -o: nothing else is left beside the file" left want_left
	(umask 027 && rm -f file && $tool -q "$@" -o file $in)
	ls -l file | cut -c 1-10 >mode
	has "$tool -o: the file's mode follows the umask" '^-rw-r-----$' mode
	cp $in own
	case $tool in
	biarcfit | bsplfit)
		status 0 "$tool -o over its own input" $tool "$@" -o own own
		tail -n 1 own >a
		tail -n 1 want >b
		same "$tool -o over its own input: written to its end" a b
		;;
	*)
		ln -s own link
		status 2 "$tool -o over its own input" $tool "$@" -o own own
		status 2 "$tool -o over its own input by a link" $tool "$@" -o link own
		shell 1 "$tool -o over its standard input" "exec $tool $args -o own <own"
		has "$tool -o over its input: told" "own: found a file that is read" err
		same "$tool -o over its input: it stays" own $in
		rm link
		;;
	esac
	status 0 "$tool -o /dev/null" $tool "$@" -o /dev/null $in
	[ -c /dev/null ]
	result $? "/dev/null is still a device"
	rm -f fifo && mkfifo fifo
	cat fifo >through &
	reader=$!
	status 0 "$tool -o FIFO" within 20 $tool "$@" -o fifo $in
	[ "$got" -eq 0 ] || kill $reader
	wait $reader
	same "$tool -o FIFO: written through it" through want
	[ -p fifo ]
	result $? "$tool -o FIFO: it is still a FIFO"
	rm -f file
	shell 0 "$tool -o FILE with standard error closed" "exec $tool -v $args -o file $in 2>&-"
	same "$tool -o FILE with standard error closed: the same bytes" file want
	status 1 "$tool -o into no folder" $tool "$@" -o no/such/file $in

	# messages
	status 0 "$tool -q" $tool -q "$@" $in
	empty "$tool -q is quiet" err
	status 0 "$tool -v" $tool -v "$@" $in
	has "$tool -v sums up" "^$tool: " err
	same "$tool -v: the same bytes" out want
	grep -v "^$tool: " err >other
	empty "$tool -v: every line begins with its name" other
	sh -c "$tool -q $args $in 2>err | head -n 1 >first"
	empty "$tool | head -n 1 is quiet" err
done

# Of every tool
for tool in "$BIN"/*; do
	name=${tool##*/}
	"$tool" --help >help
	ok "$name --help fits a screen of 24 lines, with a prompt" test "$(wc -l <help)" -le 23
	has "it says which manual to read" "man $name\$" help
	[ "$name" = cloudmill ] || "$tool" --help all >>help
	awk 'length > 80' help >long
	empty "and 80 columns" long
done

# Old names, with a note of the new one.
status 2 "two directions by their new names" planecut -r 4 -s 3 -a 90 --normal 0,1,0 mesh.ply
planecut -q -r 4 -s 3 --one-way --direction 90 mesh.ply >want
status 0 "by their old names" planecut -r 4 -s 3 --oneway --angle 90 mesh.ply
has "a note of one" '--oneway is now --one-way' err
has "a note of the other" '--angle is now --direction' err
same "the same bytes" out want
ncplot -q --joints path.cl >want
for old in points ends; do
	status 0 "ncplot --$old" ncplot --$old path.cl
	has "is told" "--$old is now --joints" err
	same "the same picture" out want
done
cloud2surf -q --outliers keep --bending 0.001 cloud.xyz >want
status 0 "an old name without a value of one that has it" cloud2surf --keep-outliers --smooth 0.001 cloud.xyz
has "a note with the value" '--keep-outliers is now --outliers=keep' err
same "the same bytes" out want
status 2 "ncpost -c nosuch" ncpost -c nosuch arcs.cl
has "... says what there is" "siemens" err
status 2 "meshnorm without -r" meshnorm mesh.ply
status 2 "ncpost without -c" ncpost arcs.cl
# ---- two results with one name: one of them would be lost
ncpost -q -c siemens arcs.cl >program.mpf
for file in both ./both; do
	rm -f both
	status 1 "ncverify: a map and a report in $file" ncverify -q -r 4 -g cloud.xyz --map both -o $file program.mpf
	has "is told" "$file: found two results for this file, expected a file for each" err
done

status 1 "ncverify: a map in standard output" ncverify -q -r 4 -g cloud.xyz --map - program.mpf
has "is told" "standard output: found two results, expected a file for each" err
for command in "ncverify -r 4 -g cloud.xyz --map" "cloud2mesh -t 4 cloud.xyz --clean"; do
	[ "${command%% *}" = ncverify ] && file=program.mpf || file=
	for to in both /dev/stdout; do
		shell 1 "${command%% *}: a second result in $to, which is standard output" \
			"exec $command $to -q $file >both"
		has "is told" "found two results" err
	done
done

# ---- a file may not become that large: told, and nothing is left
echo older >limited
shell 1 "a file beyond its limit" "ulimit -f 1; exec cloud2mesh -q -t 1 -o limited cloud.xyz"
has "is told" '^cloud2mesh: limited: cannot write: ' err
ok "the older one stays" test "$(cat limited)" = older
# shellcheck disable=SC2012
ok "and nothing beside it" test "$(ls limited* | wc -l)" -eq 1

done_testing
