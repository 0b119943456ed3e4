#!/bin/sh
# ncverify-made.t - what a program was made with is what it cuts with, though no path is given:
# coolant, the work offset, by words of the machine's own, too; and one place that is off its row.
. "${SRC:-$(dirname "$0")/../..}/tests/lib/lib.sh"
cd "$TMP" || exit 1

awk 'BEGIN { for (y = -5; y <= 5.001; y += 0.4) for (x = -7; x <= 7.001; x += 0.4)
	printf "%.5f %.5f %.5f\n", x, y, 20 - (x * x + y * y) / 60 }' >dome.xyz
cloud2mesh -q -t 2 -o dome.ply dome.xyz
meshnorm -q -r 6 --scallop 0.1 -o wet.cl dome.ply
meshnorm -q -r 6 --scallop 0.1 --coolant off -o dry.cl dome.ply

judge() { # STATUS DESC PROGRAM [OPTION ...]
	expected=$1 desc=$2 program=$3
	shift 3
	status "$expected" "$control: $desc" ncverify -q -g dome.xyz -o report "$@" "$program"
}

# again SED: blocks of good.nc changed, those without words dropped, and all numbered anew
again() {
	sed -E "$1" good.nc |
		awk -v control=$control 'control == "heidenhain" { if ($2 == "") next; $1 = k++ }
		/^N[0-9]+ *$/ { next }
		/^N/ { n += 10; sub(/^N[0-9]+/, "N" n) }
		{ print }' >bad.nc
	! cmp -s good.nc bad.nc || result 1 "$control: $1 changes nothing"
}

for control in fanuc siemens heidenhain linuxcnc okuma; do
	machine=table-ac
	[ $control = linuxcnc ] && machine=linuxcnc-xyzac
	post() { # PATH [OPTION ...]
		ncpost -q -c $control -m $machine -o good.nc "$@"
	}

	# ---- coolant
	post wet.cl
	judge 0 "a program with coolant" good.nc
	again 's/^(N?[0-9]+) M8$/\1/'
	judge 3 "coolant that is never on" bad.nc
	has "$control: is named by its first cut" \
		'^fault +N[0-9]+ \(line [0-9]+\): .* without coolant' report
	judge 3 "with its path, too" bad.nc -p wet.cl
	judge 0 "judged alone" bad.nc --accept
	post dry.cl
	has "$control: a program that is to be dry says so" 'COOLANT: NONE' good.nc
	judge 0 "it is accepted" good.nc
	judge 0 "with its path" good.nc -p dry.cl
	judge 3 "but not with a path that has coolant" good.nc -p wet.cl
	post --set coolant.on=M51 --set coolant.off=M59 wet.cl
	judge 0 "coolant by a word of the machine's own" good.nc -p wet.cl
	again 's/^(N?[0-9]+) M51$/\1/'
	judge 3 "which is missing" bad.nc
	awk -v control=$control '/ C-?[0-9.]+|A3=/ && ++n == 20 {
			print control == "heidenhain" ? $1 " M59" : "N" substr($1, 2) - 5 " M59"; done = 1 }
		control == "heidenhain" && done { $1++ } { print }' good.nc >bad.nc
	judge 3 "or goes off amid it" bad.nc
	has "$control: is told" 'the coolant goes off, and cuts follow' report

	# ---- the work offset
	case $control in
	heidenhain) is='CYCL DEF 247 Q339=+1' other='CYCL DEF 247 Q339=+2' ;;
	okuma) is='G15 H3' other='G15 H4' ;;
	*) is=G56 other=G57 ;;
	esac
	post wet.cl
	judge 3 "a program for another offset" good.nc --set "offset=$is"
	post --set "offset=$is" wet.cl
	judge 0 "an offset that the head says" good.nc -p wet.cl
	judge 0 "or an option" good.nc --set "offset=$is"
	judge 3 "not another one" good.nc --set "offset=$other"
	told="work offset is $(echo "$is" | sed 's/+/./'), .* made for $(echo "$other" | sed 's/+/./')"
	has "$control: both are told" "$told" report
	again "/SET: /!s/$(echo "$is" | sed 's/+/[+]/')/$other/"
	judge 3 "another one all along" bad.nc
	has "$control: is named" '^fault +N[0-9]+ \(line [0-9]+\): the work offset is' report
	[ $control = heidenhain ] && continue
	post --set offset.1="$is" wet.cl
	judge 0 "that of the first tool" good.nc
done
control=heidenhain
ncpost -q -c heidenhain -o good.nc --set 'offset=CYCL DEF 247 Q339=+1' wet.cl
again '/^[0-9]+ CYCL DEF 247/s/ .*//'
judge 3 "no preset" bad.nc
has "heidenhain: is told" 'cuts without the work offset, CYCL DEF 247' report

# ---- far below all points of the part, where the table may be
low() { # Z of the tip: there and along at feed, beside the part
	awk -v z="$1" '/^FINI/ {
		print "RAPID\nGOTO/100,0,60,0,0,1\nRAPID\nGOTO/100,0," z ",0,0,1"
		print "GOTO/110,0," z ",0,0,1\nRAPID\nGOTO/110,0,60,0,0,1" } { print }' wet.cl >low.cl
	ncpost -q -c $control -m $machine -o good.nc low.cl
}
for control in fanuc siemens heidenhain linuxcnc; do
	machine=table-ac
	low -61
	judge 0 "79.8 mm below the lowest point: rows may run out so far" good.nc
	low -62
	judge 3 "farther below it" good.nc
	has "$control: how far is told" '^fault .*goes 80.8 mm below the lowest point of the part' report
	sed "s/^GOTO\/110,0,-62/GOTO\/400,0,60/" low.cl >far.cl
	ncpost -q -c $control -m $machine -o good.nc far.cl
	judge 3 "at feed far off all of it" good.nc
	has "$control: how far off is told" '^fault .*is 3[0-9.]+ mm off all of the part' report
done

# ---- an approach from the side that begins nearer to the part than points far apart tell
control=fanuc
awk 'BEGIN { for (y = -6; y <= 6; y += 1.5) for (x = -9; x <= 9; x += 1.5)
	print x, y, 0 }' >plate.xyz
aside() { # FEED: from 0.3 mm over the plate
	printf '%s\n' PARTNO/A UNITS/MM MULTAX/ON CUTTER/6,3 LOADTL/1 SPINDL/RPM,8000,CLW \
		RAPID GOTO/-8,0,20,0,0,1 RAPID GOTO/-6.3,0,0.3,0,0,1 "FEDRAT/MMPM,$1" GOTO/-6,0,0,0,0,1 \
		FEDRAT/MMPM,800 GOTO/0,0,0,0,0,1 GOTO/6,0,0,0,0,1 RAPID GOTO/6,0,20,0,0,1 FINI >aside.cl
	ncpost -q -c fanuc -m table-ac -o aside.nc aside.cl
	run ncverify -q -g plate.xyz -r 3 --partial -o report aside.nc
}
aside 400
hasnt "slower than the cut it is one" 'a rapid move ends on the part' report
aside 800
has "as fast as that it may be a cut that has G0" 'a rapid move ends on the part' report

# ---- one place of a row that is off it: no path says how the tool should go
control=linuxcnc machine=linuxcnc-xyzac
ncpost -q -c linuxcnc -m $machine -o good.nc wet.cl
for change in 'Y 1' 'A 5' 'A -4'; do
	awk -v name="${change% *}" -v more="${change#* }" '
		/^N/ && / A[-0-9.]+/ && / Y[-0-9.]+/ && !/G0/ && ++n == 30 {
			match($0, " " name "[-0-9.]+")
			v = substr($0, RSTART + 2, RLENGTH - 2) + more
			$0 = substr($0, 1, RSTART + 1) sprintf("%.4f", v) substr($0, RSTART + RLENGTH)
			print $1 >"named" }
		{ print }' good.nc >bad.nc
	judge 3 "$change in one block" bad.nc
	has "$change: is named by its block" \
		"^fault +$(cat named) .*(swerves by|the tool axis (turns|swings)|ball is .* deep)" report
done
done_testing
