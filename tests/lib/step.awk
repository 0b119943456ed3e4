# step.awk - a STEP file from lines `NAME ENTITY(...)`, where {NAME} in the attributes is the reference
# to another instance and {p X Y Z}, {d X Y Z}, {v X Y Z}, {a P Z X} make points, directions, vertices and
# axes (P, Z, X as X,Y,Z) on the spot; -v unit=INCH (default mm), -v degrees=1.  {CONTEXT} is the context of units.
function new(text) { out[++n] = text; return "#" n }
function point(x, y, z) { return new("CARTESIAN_POINT(''," "(" x "," y "," z "))") }
function direction(x, y, z) { return new("DIRECTION(''," "(" x "," y "," z "))") }
function expand(text,   name, part, k, q, r, made) {
	while (match(text, /{[^}]*}/)) {
		name = substr(text, RSTART + 1, RLENGTH - 2)
		part = substr(text, RSTART + RLENGTH)
		text = substr(text, 1, RSTART - 1)
		k = split(name, q, " ")
		if (k == 1) {
			if (!(name in number)) number[name] = ++n
			made = "#" number[name]
		} else if (q[1] == "p") made = point(q[2], q[3], q[4])
		else if (q[1] == "d") made = direction(q[2], q[3], q[4])
		else if (q[1] == "v") made = new("VERTEX_POINT(''," point(q[2], q[3], q[4]) ")")
		else {
			split(q[2], r, ","); made = point(r[1], r[2], r[3])
			split(q[3], r, ","); made = made "," direction(r[1], r[2], r[3])
			split(q[4], r, ","); made = made "," direction(r[1], r[2], r[3])
			made = new("AXIS2_PLACEMENT_3D(''," made ")")
		}
		text = text made part
	}
	return text
}
NF >= 2 && $1 !~ /^#/ {
	name = $1
	sub(/^[^ ]+ +/, "")
	if (!(name in number)) number[name] = ++n
	id = number[name]
	out[id] = expand($0)
}
END {
	length_unit = unit == "INCH" ? \
		"(CONVERSION_BASED_UNIT('INCH'," new("LENGTH_MEASURE_WITH_UNIT(LENGTH_MEASURE(25.4)," new("(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.MILLI.,.METRE.))") ")") ")LENGTH_UNIT()NAMED_UNIT(*))" : \
		"(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.MILLI.,.METRE.))"
	length_unit = new(length_unit)
	angle = "(NAMED_UNIT(*)PLANE_ANGLE_UNIT()SI_UNIT($,.RADIAN.))"
	if (degrees) angle = "(CONVERSION_BASED_UNIT('DEGREE'," new("PLANE_ANGLE_MEASURE_WITH_UNIT(PLANE_ANGLE_MEASURE(0.017453292519943295)," new(angle) ")") ")NAMED_UNIT(*)PLANE_ANGLE_UNIT())"
	angle = new(angle)
	if ("CONTEXT" in number)
		out[number["CONTEXT"]] = "(GEOMETRIC_REPRESENTATION_CONTEXT(3)GLOBAL_UNIT_ASSIGNED_CONTEXT((" \
			length_unit "," angle "))REPRESENTATION_CONTEXT('',''))"
	print "ISO-10303-21;\nHEADER;\nFILE_DESCRIPTION(('made by step.awk'),'2;1');"
	print "FILE_NAME('model','',(''),(''),'','','');\nFILE_SCHEMA(('AUTOMOTIVE_DESIGN'));\nENDSEC;\nDATA;"
	for (i = 1; i <= n; i++) print "#" i "=" out[i] ";"
	print "ENDSEC;\nEND-ISO-10303-21;"
}
