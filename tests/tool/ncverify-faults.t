#!/bin/sh
# ncverify-faults.t - the faults that a shop fears, each put into programs of every control over
# several shapes (tests/lib/faults.awk): refused, and named by the block it is in.  Drawn by
# numbers, one of each here; all of FAULT_SEEDS="1 2 3" with every fitter by `make nc-faults`.
. "${SRC:-$(dirname "$0")/../..}/tests/lib/lib.sh"
cd "$TMP" || exit 1

seeds=${FAULT_SEEDS:-1}
kinds=${FAULT_KINDS:-rapid plunge approach retract no-offset offset edge length tool coolant dry fast
	slow ORIMKS ORICURVE poly axis sign digit}

# ---- three shapes, their paths as lines, arcs and splines

shape() { # NAME R TILT HEIGHT: a function of x and y, as awk has it
	awk "BEGIN { for (y = -5; y <= 5.001; y += 0.4) for (x = -7; x <= 7.001; x += 0.4)
		printf \"%.5f %.5f %.5f\\n\", x, y, $4 }" >$1.xyz
	cloud2mesh -q -t 2 $1.xyz -o $1.ply
	meshnorm -q -r $2 --avoid --axis-play 0 --tilt $3 --scallop 0.1 $1.ply >$1-line.cl
	biarcfit -q -e 0.01 $1-line.cl >$1-arc.cl
	bsplfit -q -e 0.01 $1-line.cl >$1-curve.cl
}
shape dome 6 12 '20 - (x * x + y * y) / 60'
shape wave 4 15 '10 + 1.5 * sin(x / 4) * cos(y / 5)'
shape trough 3 20 '5 + x * x / 80 - y / 6'
radius() {
	case $1 in dome) echo 6 ;; wave) echo 4 ;; trough) echo 3 ;; bend) echo 1.5 ;; esac
}

judge() { # PROGRAM [MORE]: status in $got, findings in err
	program=$1
	shift
	run ncverify -g $shape.xyz -r "$(radius $shape)" -m $machine -c $control "$@" $program
}

# What is known by the program alone, without its path.
alone=' rapid plunge retract no-offset offset edge length tool coolant ORIMKS '

# refused KIND WHERE: by what was run last, and by its block
refused() {
	case $got in
	1 | 3) ;;
	*)
		result 1 "$2: $1 is refused (exit $got)"
		return 1
		;;
	esac
	: >why
	cp err why
	if grep -Eq "(^|[^0-9A-Z])N?$(cat named)([^0-9]|\$)" why; then result 0 "$2: $1 is found"; else
		result 1 "$2: $1 is named by its block $(cat named)"
		return 1
	fi
}

# put KIND SEED: into the program
put() {
	reach=2
	[ $fitter = curve ] && reach=6
	[ "$1" = ORICURVE ] && reach=20 # what it governs
	awk -v reach=$reach -v kind="$1" -v seed="$2" -v control=$control -v named=named \
		-f "$SRC/tests/lib/faults.awk" good.nc >bad.nc
}

for kind in $kinds; do
	for c in fanuc siemens heidenhain linuxcnc; do echo "$kind $c 0 0"; done
done >table
count() { # KIND HOW: 0 found, 1 missed
	awk -v kind="$1" -v c=$control -v how="$2" '$1 == kind && $2 == c { $3 += !how; $4 += how } { print }' \
		table >table.new && mv table.new table
}

seed=0
for shape in dome wave trough; do
	for control in fanuc siemens heidenhain linuxcnc; do
		machine=table-ac
		[ $control = linuxcnc ] && machine=linuxcnc-xyzac
		for fitter in ${FAULT_FITTERS:-$(case $shape in dome) echo line ;; wave) echo curve ;; *) echo arc ;; esac)}; do
			ncpost -q -c $control -m $machine $shape-$fitter.cl >good.nc
			where="$shape, $control, $fitter"
			judge good.nc -p $shape-$fitter.cl
			result "$got" "$where: the good program is accepted"
			for _ in $seeds; do
				seed=$((seed + 1))
				for kind in $kinds; do
					put $kind $seed || continue # none of its blocks can have it
					[ -z "${FAULT_KEEP:-}" ] || cp bad.nc named "$FAULT_KEEP/"
					judge bad.nc -p $shape-$fitter.cl
					refused $kind "$where $seed"
					count $kind $?
					case $alone in *" $kind "*)
						judge bad.nc
						refused $kind "$where $seed, without its path"
						count $kind $?
						;;
					esac
				done
			done
		done
	done
done

# ---- polynomials, where rows bend sideways: 1 % of their coefficients are microns
shape=bend control=siemens machine=table-ac fitter=curve
awk 'BEGIN { for (y = -5; y <= 5.001; y += 0.4) for (x = -7; x <= 7.001; x += 0.4)
	printf "%.5f %.5f %.5f\n", x, y, 10 + 2.5 * sin(x / 2.6 + y / 4) + x * y / 12 }' >bend.xyz
cloud2mesh -q -t 2 bend.xyz -o bend.ply
meshnorm -q -r 1.5 --avoid --axis-play 0 --tilt 25 --direction 20 --scallop 0.2 bend.ply |
	bsplfit -q --degree 5 -e 0.01 >bend-curve.cl
ncpost -q -c siemens bend-curve.cl >good.nc
judge good.nc -p bend-curve.cl
result "$got" "bend, siemens, curve: the good program is accepted"
for seed in $seeds; do
	if put poly $seed; then
		judge bad.nc -p bend-curve.cl
		refused poly "bend, siemens, curve $seed"
		count poly $?
	else
		result 1 "bend, siemens: the fault is put in"
	fi
done

echo "# found and missed, by kind and control"
awk '{ t[$1, $2] = $3 "/" $4; if (!k[$1]++) kind[++n] = $1 }
	END { for (i = 1; i <= n; i++) { printf "# %-10s", kind[i]
		split("fanuc siemens heidenhain linuxcnc", c, " ")
		for (j = 1; j <= 4; j++) printf " %s %s", c[j], t[kind[i], c[j]]
		print "" } }' table
awk '$3 + $4 > 0 { any[$1] = 1 } { all[$1] = 1 } END { for (k in all) if (!any[k]) { bad = 1; print k } exit bad }' \
	table >never
result $? "each kind of fault was put into a program (not: $(tr '\n' ' ' <never))"
done_testing
