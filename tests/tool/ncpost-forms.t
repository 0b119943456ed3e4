#!/bin/sh
# ncpost-forms.t - forms of CAM systems: the unit of a file that does not say it, MOVARC, feeds per
# revolution before the speed, speeds in LOADTL, END without FINI; 48 files that are wrong, each
# refused in one line; each shared file of a CAM system for all controls.
. "${SRC:-$(dirname "$0")/../..}/tests/lib/lib.sh"
cd "$TMP" || exit 1

# ---- the unit
nx() { # UNITS-LINE FEED-WORD
	printf '%s\n' $1 'TOOL PATH/FACE,TOOL,T1' 'TLDATA/MILL,1.0,0.0,3.0,0.0,0.0' 'LOAD/TOOL,1' 'SPINDL/RPM,900,CLW' \
		RAPID 'GOTO/0,0,2' "FEDRAT/$2,10" 'GOTO/0,0,0' 'GOTO/4,0,0' END-OF-PATH
}
nx '' IPM >inch.cls
nx UNITS/INCHES IPM >said.cls
nx '' MMPM >mm.cls
nx UNITS/MM IPM >mixed.cls
sed 's/^GOTO\/4,0,0/FEDRAT\/MMPM,20\n&/' inch.cls >both.cls
status 0 "feeds in IPM and no UNITS: inches" ncpost -c fanuc inch.cls
has "told" 'found feeds in inches and no UNITS: took inches' err
has "25.4 times as long" 'X101\.6' out
has "the feed" 'F254\.' out
has "the head says so" 'ASSUMED: THE PATH IS IN INCHES' out
grep -v ASSUMED out >guessed
ncpost -q -c fanuc said.cls | grep -v ASSUMED >out
same "the same as with UNITS/INCHES" guessed out
status 0 "from a pipe" sh -c 'cat inch.cls | ncpost -c fanuc'
has "inches too" 'X101\.6' out
status 0 "feeds in MMPM" ncpost -c fanuc mm.cls
has "millimetres" ' X4\.' out
status 0 "-u mm" ncpost -c fanuc -u mm inch.cls
has "as asked" ' X4\.' out
status 0 "-u inch" ncpost -c fanuc -u inch mm.cls
has "as asked" 'X101\.6' out
status 1 "UNITS/MM with feeds in IPM" ncpost -c fanuc mixed.cls
has "is refused with both lines" '^ncpost: mixed.cls:8: found UNITS/MM in line 1 and a feed in inches in line 8, expected' err
ok "by one line" test "$(wc -l <err)" -eq 1
empty "and nothing is written" out
status 0 "unless -u mm says that both are meant" ncpost -c fanuc -u mm mixed.cls
has "the feed alone is in inches" 'F254\.' out
has "lengths stay" ' X4\.' out
sed '1d;/^FEDRAT/s/$/\nUNITS\/MM/' mixed.cls >after.cls
status 1 "UNITS behind the feed" ncpost -c fanuc after.cls
has "is refused too" ':8: found UNITS/MM in line 8 and a feed in inches in line 7' err
sed 's/^FEDRAT.*/CYCLE\/DRILL,3,IPR,.01,1/;s/^GOTO\/4,0,0/&\nCYCLE\/OFF/' mixed.cls >hole.cls
status 1 "a hole's feed in inches" ncpost -c fanuc hole.cls
has "is refused too" 'found UNITS/MM in line 1 and a feed in inches in line 8' err
nx UNITS/INCHES MMPM >other.cls
status 0 "UNITS/INCHES with feeds in MMPM" ncpost -c fanuc other.cls
has "told" '^ncpost: other.cls:8: found a feed in mm under UNITS/INCHES' err
has "the feed is in mm" 'F10\.' out
has "lengths are in inches" 'X101\.6' out
status 1 "feeds in both and no UNITS" ncpost -c fanuc both.cls
has "is refused" 'feeds in inches and in mm and no UNITS' err
status 1 "-u mm against UNITS/INCHES" ncpost -c fanuc -u mm said.cls
has "is refused" 'found UNITS/INCHES, expected MM, as asked for' err

# ---- MOVARC is an arc
arc() { # MOVARC and the GOTO at its end
	printf '%s\n' UNITS/MM LOADTL/1 SPINDL/900 RAPID GOTO/10,0,5 FEDRAT/100 GOTO/10,0,0 "$@" FINI
}
arc MOVARC/0,0,0,0,0,1,10,ANGLE,90 GOTO/0,10,0 >quarter.cl
status 0 "MOVARC" ncpost -c fanuc quarter.cl
has "is an arc" 'G3 X0\. Y10\. I-10\. J0\.' out
arc MOVARC/0,0,0,0,0,-1,10,ANGLE,270 GOTO/0,10,0 >back.cl
ncpost -q -c fanuc back.cl >out
has "about its axis, clockwise" 'G2 X0\. Y10\. I-10\. J0\.' out
arc MOVARC/0,0,0,0,0,1,10,ANGLE,360 GOTO/10,0,0 >whole.cl
ncpost -q -c siemens -m three-axis whole.cl >out
[ "$(grep -c 'X.*I1=AC' out)" -ge 2 ]
result $? "a whole circle"
arc MOVARC/0,0,0,0,0,1,10,ANGLE,90 GOTO/-10,0,0 >off.cl
status 1 "an angle that is another" ncpost -c fanuc off.cl
has "is refused" 'MOVARC of 90 degrees that ends after 180' err

# ---- CATIA
catia() { printf '%s\n' '$$ CATIA APT VERSION 1.0' PPRINT LOADTL/1 "$@"; }
catia FEDRAT/0.2,MMPR SPINDL/1000,RPM,CLW RAPID GOTO/0,0,9 GOTO/0,0,0 GOTO/9,0,0 SPINDL/2000,RPM,CLW GOTO/0,0,0 FINI >turn.cl
status 0 "MMPR before SPINDL" ncpost -c fanuc turn.cl
has "the feed comes with the speed" 'F200\.' out
has "and follows it" 'F400\.' out
catia FEDRAT/0.2,MMPR RAPID GOTO/0,0,9 GOTO/0,0,0 FINI >never.cl
status 1 "MMPR and never a speed" ncpost -c fanuc never.cl
has "is refused at the cut" 'never\.cl:7: found a motion at a feed per revolution' err
catia | sed 's/LOADTL.*/LOADTL\/3,SPINDL,1500,CCLW/' >load.cl
printf '%s\n' RAPID GOTO/0,0,9 FEDRAT/100,MMPM GOTO/0,0,0 END >>load.cl
status 0 "the speed in LOADTL, END without FINI" ncpost -c fanuc load.cl
has "the speed and its sense" 'S1500 M4' out
has "the tool" 'T3 M6' out

# ---- 48 files that are wrong
n=0 bad=
wrong() { # LINES...: refused with one line, and nothing is written
	n=$((n + 1))
	printf '%s\n' "$@" >wrong.cl
	ncpost -c fanuc --no-spindle -o wrong.nc wrong.cl >out 2>err
	got=$?
	[ $got -eq 1 ] && [ "$(wc -l <err)" -eq 1 ] && [ ! -e wrong.nc ] && [ ! -s out ] && return
	bad="$bad $n:$*($got)"
	rm -f wrong.nc
}
for line in 'GOTO 5,5,5' 'GOT0/5,5,5' 'GOTOO/5,5,5' 'GOTP/5,5,5' GOTO/5,5 GOTO/5 GOTO/ 'GOTO/5,5,5,0' 'GOTO/5,5,x' \
	'GOTO/5,5,nan' 'GOTO/5,5,inf' 'GOTO/1e9,0,0' 'GOTO/0,0,0,0,0,0' 'GODLTA/1,2' GODLTA/x 'MOVETO/1,2,3' 'SLIDE/1,2,3' \
	'CIRCLE/0,0,0,0,0,1' 'CIRCLE/1,2' 'CIRCLE/0,0,0,0,0,0,5' 'CIRCLE/0,0,9,0,0,1,5' 'MOVARC/0,0,0' \
	'MOVARC/0,0,0,0,0,1,5,ANGLE,0' 'TLAXIS/0,0,0' 'TLAXIS/1,2' UNITS/YARDS 'FEDRAT/-5,MMPM' 'FEDRAT/0' FEDRAT/x \
	'FEDRAT/5,FURLONG' 'SPINDL/RPM,fast' 'SPINDL/-3' 'SPINDL/0.3' 'DELAY/-1' DELAY/x 'LOADTL/1.5' 'LOADTL/-1' LOADTL/ \
	'CUTTER/x' 'CYCLE/DRILL' 'ROTABL/ATANGL,30' 'GOFWD/L1' 'L1 = LINE/0,0,1,1' 'MOVNRB/OFF' 'COPY/1,2' 'MODE/INCR'; do
	wrong UNITS/MM GOTO/0,0,9 "$line" GOTO/9,0,9 FINI
done
wrong UNITS/MM GOTO/0,0,9
wrong FINI
[ $n -eq 48 ] && [ -z "$bad" ]
result $? "$n wrong files, each refused with one line and no output$bad"

done_testing
