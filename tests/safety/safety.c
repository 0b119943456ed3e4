/*
 * safety - what may harm a machine, looked for in the text of an NC program by code that shares
 * nothing with the suite: it reads the words of a block, keeps the few modal states that count, and
 * moves ball, flute and holder along straight moves and rapids over the points of a scan.
 *
 *   safety CONTROL MACHINE.txt RADIUS FLUTE TOLERANCE PROGRAM [SCAN.xyz [HOLDER_RADIUS:LENGTH]]
 *
 * CONTROL: fanuc, siemens, heidenhain, linuxcnc.  The holder stands on the flute.  Prints a line
 * for each fault; exit 0: none, 3: some, 1: the program cannot be read.
 *
 *   rotary      a rotary axis moves at rapid, or by a tilted plane, where the tool is not home or
 *               over the clearance plane
 *   low         a rapid move under the clearance plane that goes neither along the tool axis nor
 *               away from all of the part
 *   length      the tool's length, or tool-centre-point control, goes on or off elsewhere than home
 *               or over the clearance plane; or a move without it
 *   spindle     a cut with the spindle off
 *   start, end  the first move is not home, or the last
 *   ball, shaft, holder   in the part, deeper than the tolerance
 */
#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define HOME 1e6
#define SLACK 0.02 /* mm */

struct v {
    double x, y, z;
};

static struct v add(struct v a, double s, struct v b)
{
    return (struct v){a.x + s * b.x, a.y + s * b.y, a.z + s * b.z};
}

static double dot(struct v a, struct v b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

static struct v unit(struct v a)
{
    double l = sqrt(dot(a, a));
    return l > 0 ? (struct v){a.x / l, a.y / l, a.z / l} : (struct v){0, 0, 1};
}

/* b turned about the unit vector k by so many degrees (Rodrigues). */
static struct v turn(struct v k, double degrees, struct v b)
{
    double t = degrees * acos(-1) / 180, c = cos(t), s = sin(t);
    struct v cross = {k.y * b.z - k.z * b.y, k.z * b.x - k.x * b.z, k.x * b.y - k.y * b.x};
    struct v r = {c * b.x, c * b.y, c * b.z};
    return add(add(r, s, cross), dot(k, b) * (1 - c), k);
}

/* ---- the machine */

static struct {
    char type[32], axes[16];
    struct v axis[3], centre[3];
    bool tcp, given_tcp;
} machine = {"",   "",   {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}},
             true, false};

static void read_machine(const char *file)
{
    char line[400], key[64], value[300], folder[600];
    FILE *f = fopen(file, "r");
    if (!f) {
        fprintf(stderr, "safety: %s\n", file);
        exit(1);
    }
    while (fgets(line, sizeof line, f)) {
        line[strcspn(line, "#\n")] = '\0';
        if (sscanf(line, " %63[^= ] = %299[^\n]", key, value) != 2)
            continue;
        if (strcmp(key, "include") == 0) {
            const char *slash = strrchr(file, '/');
            char name[100];
            sscanf(value, "%99s", name);
            snprintf(folder, sizeof folder, "%.*s%s.txt", slash ? (int)(slash - file) + 1 : 0, file,
                     name);
            read_machine(folder);
        } else if (strcmp(key, "type") == 0) {
            sscanf(value, "%31s", machine.type);
        } else if (strcmp(key, "axes") == 0) {
            snprintf(machine.axes, sizeof machine.axes, "%.15s", value);
        } else if (strcmp(key, "tcp") == 0) {
            machine.tcp = strncmp(value, "yes", 3) == 0;
        } else if (strncmp(key, "axis.", 5) == 0 || strncmp(key, "centre.", 7) == 0) {
            struct v *v = *key == 'a' ? &machine.axis[key[5] - 'A'] : &machine.centre[key[7] - 'A'];
            if (sscanf(value, "%lf %lf %lf", &v->x, &v->y, &v->z) != 3)
                exit(1);
            *v = *key == 'a' ? unit(*v) : *v;
        }
    }
    fclose(f);
}

/* Letters of the first and the second axis, as an index, -1: none. */
static void letters(int l[2])
{
    int n = 0;
    l[0] = l[1] = -1;
    for (const char *s = machine.axes; *s && n < 2; s++)
        if (*s >= 'A' && *s <= 'C')
            l[n++] = *s - 'A';
}

/* Seen from the work: the axis that is nearer to the work turns last. */
static struct v axis_of(const double q[3])
{
    int l[2], near = 1, far = 0;
    struct v a = {0, 0, 1};
    letters(l);
    if (strcmp(machine.type, "head-head") == 0)
        near = 0, far = 1;
    if (l[far] >= 0)
        a = turn(machine.axis[l[far]], q[l[far]], a);
    if (l[near] >= 0)
        a = turn(machine.axis[l[near]], q[l[near]], a);
    return a;
}

/* Places of the linear axes as a place on the work, for tables. */
static struct v tip_of(struct v p, const double q[3])
{
    int l[2];
    letters(l);
    for (int i = 0; i < 2; i++)
        if (l[i] >= 0)
            p = add(turn(machine.axis[l[i]], q[l[i]], add(p, -1, machine.centre[l[i]])), 1,
                    machine.centre[l[i]]);
    return p;
}

/* ---- the part */

static struct v *point;
static size_t points;
static double radius, flute, tolerance, holder_radius, holder_length;

static void read_scan(const char *file)
{
    char line[400];
    size_t cap = 0;
    struct v p;
    FILE *f = fopen(file, "r");
    while (f && fgets(line, sizeof line, f)) {
        if (sscanf(line, "%lf%*[ ,]%lf%*[ ,]%lf", &p.x, &p.y, &p.z) != 3)
            continue;
        if (points == cap) {
            struct v *more = realloc(point, (cap = cap ? 2 * cap : 1024) * sizeof *point);
            if (!more)
                exit(2);
            point = more;
        }
        point[points++] = p;
    }
    if (f)
        fclose(f);
}

/* Depth of a cylinder from height 0 to `length` over c along a. */
static double in_cylinder(struct v c, struct v a, double r, double length)
{
    double most = 0;
    for (size_t i = 0; i < points; i++) {
        struct v d = add(point[i], -1, c);
        double h = dot(d, a), out2;
        if (h <= 0 || h >= length || (out2 = dot(d, d) - h * h) >= r * r)
            continue;
        most = fmax(most, fmin(r - sqrt(fmax(out2, 0)), fmin(length - h, length)));
    }
    return most;
}

static double in_ball(struct v c)
{
    double least = 1e300;
    for (size_t i = 0; i < points; i++) {
        struct v d = add(point[i], -1, c);
        least = fmin(least, dot(d, d));
    }
    return points ? radius - sqrt(least) : -1e300;
}

/* ---- the words of a block */

struct word {
    char name[24];
    double value;
    bool has_value, shortest; /* shortest: DC() */
};

static struct word word[64];
static int words;

static void split(char *line)
{
    words = 0;
    for (char *s = strtok(line, " \t\r\n~"); s && words < 64; s = strtok(NULL, " \t\r\n~")) {
        struct word *w = &word[words++];
        char *equals = strchr(s, '=');
        memset(w, 0, sizeof *w);
        if (equals) {
            snprintf(w->name, sizeof w->name, "%.*s", (int)(equals - s), s);
            w->shortest = strncmp(equals, "=DC(", 4) == 0;
            s = equals + 1 + strcspn(equals + 1, "+-.0123456789");
        } else {
            size_t n = strcspn(s, "+-.0123456789(");
            snprintf(w->name, sizeof w->name, "%.*s", (int)n, s);
            s += n;
        }
        char *end;
        w->value = strtod(s, &end);
        w->has_value = end != s;
        if (strncmp(w->name, "PO[", 3) == 0) /* the end of a polynomial */
            memmove(w->name, w->name + 3, strlen(w->name) - 2),
                w->name[strcspn(w->name, "]")] = '\0';
    }
}

static bool has(const char *name)
{
    for (int i = 0; i < words; i++)
        if (strcmp(word[i].name, name) == 0)
            return true;
    return false;
}

static bool is(const char *name, double value)
{
    for (int i = 0; i < words; i++)
        if (strcmp(word[i].name, name) == 0 && word[i].has_value &&
            fabs(word[i].value - value) < 1e-6)
            return true;
    return false;
}

static bool get(const char *name, double *value)
{
    for (int i = 0; i < words; i++)
        if (strcmp(word[i].name, name) == 0 && word[i].has_value) {
            *value = word[i].value;
            return true;
        }
    return false;
}

static bool shortest(const char *name)
{
    for (int i = 0; i < words; i++)
        if (strcmp(word[i].name, name) == 0)
            return word[i].shortest;
    return false;
}

/* ---- the run */

enum { RAPID, FEED, CURVE };

static struct {
    int control, move;
    bool inch, length, spindle, home, tilted, known, cut, turned[3], blind;
    struct v p, a;
    double q[3], clear;
    bool has_clear, vector;
    size_t line;
    char block[24];
    int faults;
} now;

enum { FANUC, SIEMENS, HEIDENHAIN, LINUXCNC };

/* The first few of each kind are printed. */
static void fault(const char *kind, const char *what, double value)
{
    enum { KINDS = 10, SHOWN = 4 };
    static struct {
        const char *kind;
        int n;
    } told[KINDS];
    int k = 0;
    while (told[k].kind && strcmp(told[k].kind, kind) != 0)
        k++;
    told[k].kind = kind;
    now.faults++;
    if (told[k].n++ < SHOWN)
        printf("%s: line %zu (%s): %s %.4f\n", kind, now.line, now.block, what, value);
}

/* Home, or the tip over the clearance plane. */
static bool above(void)
{
    struct v tip = machine.tcp || now.blind ? now.p : tip_of(now.p, now.q);
    return now.home || (now.known && now.has_clear && tip.z >= now.clear - SLACK);
}

static double angle(struct v a, struct v b)
{
    return acos(fmax(-1, fmin(1, dot(a, b)))) * 180 / acos(-1);
}

struct end {
    struct v p, a;
    double q[3];
    bool vector;
};

/* Where tip and axis are at t of a move. */
static void pose(const struct end *from, const struct end *to, double t, struct v *tip,
                 struct v *axis)
{
    double q[3];
    for (int k = 0; k < 3; k++)
        q[k] = from->q[k] + t * (to->q[k] - from->q[k]);
    *tip = add(from->p, t, add(to->p, -1, from->p));
    *axis = to->vector ? unit(add(from->a, t, add(to->a, -1, from->a))) : axis_of(q);
    if (!machine.tcp && !now.tilted)
        *tip = tip_of(*tip, q);
}

static void follow(const struct end *from, const struct end *to, bool rapid)
{
    struct v a, b, u, w;
    double worst[3] = {0}, low = 0, nearest = -1e300;
    pose(from, to, 0, &a, &u);
    pose(from, to, 1, &b, &w);
    struct v way = add(b, -1, a);
    double length = sqrt(dot(way, way)), turned = angle(u, w);
    int n = 1 + (int)fmax(length / 0.25, turned * 3);
    for (int i = 0; i <= n; i++) {
        struct v tip, axis;
        pose(from, to, (double)i / n, &tip, &axis);
        struct v c = add(tip, radius, axis);
        double ball = in_ball(c);
        worst[0] = fmax(worst[0], ball);
        nearest = fmax(nearest, ball);
        if (flute > 0)
            worst[1] = fmax(worst[1], in_cylinder(c, axis, radius, flute));
        if (holder_length > 0)
            worst[2] = fmax(worst[2],
                            in_cylinder(add(c, flute, axis), axis, holder_radius, holder_length));
        if (now.has_clear && tip.z < now.clear - SLACK)
            low = fmax(low, now.clear - tip.z);
    }
    if (worst[0] > tolerance)
        fault("ball", rapid ? "deep at rapid" : "deep", worst[0]);
    if (worst[1] > tolerance)
        fault("shaft", rapid ? "deep at rapid" : "deep", worst[1]);
    if (worst[2] > tolerance)
        fault("holder", rapid ? "deep at rapid" : "deep", worst[2]);
    double off = length > 0.01 ? angle(unit(way), u) : 0;
    off = fmin(off, 180 - off);
    if (points == 0 && way.z > 0.7 * length) /* the part is not known: up is away from it */
        return;
    bool leaves = points > 0 && nearest < -0.2 * radius; /* never near the part */
    if (rapid && low > 0 && length > 0.01 && off > 2 && !leaves)
        fault("low", "rapid under the clearance plane, nearer to the part than its radius / 5, by",
              -nearest);
    if (rapid && low > 0 && turned > 0.01 && !leaves)
        fault("rotary", "rapid turn under the clearance plane, degrees", turned);
}

static void go(bool rapid, bool curve, const struct end *to, bool rotary, bool lateral, bool down)
{
    struct end from = {now.p, now.a, {now.q[0], now.q[1], now.q[2]}, now.vector};
    bool moves = rotary || lateral || down;
    if (!moves)
        return;
    if (!rapid) {
        now.cut = true;
        if (!now.spindle)
            fault("spindle", "cuts with it off", 0);
        if (!now.length)
            fault("length", "cuts without it", 0);
    }
    if (!now.length && !now.home && (lateral || down) && now.known && !above())
        fault("length", "a move without it, not home", now.p.z);
    if (rotary && !now.length && !now.home)
        fault("rotary", "turns without length compensation, not home", now.p.z);
    if (now.home && down && now.length) { /* from above, only its end is known */
        struct v tip, axis;
        pose(to, to, 1, &tip, &axis);
        if (now.has_clear && tip.z < now.clear - SLACK)
            fault("start", "comes down from home under the clearance plane, by", now.clear - tip.z);
    } else if (!now.home && now.known && now.length && !curve && !now.tilted && !now.blind) {
        follow(&from, to, rapid);
    }
    if (down)
        now.home = false;
    now.p = to->p;
    now.a = to->a;
    memcpy(now.q, to->q, sizeof now.q);
    now.vector = to->vector;
    now.known = now.known || down;
}

static void set_length(bool on, const char *what)
{
    if (on != now.length && !above())
        fault("length", what, now.known ? now.p.z : -1);
    now.length = on;
}

/* The words that name a place; true: the block has one. */
static void move_block(bool rapid, bool curve, bool vectors)
{
    struct end to = {now.p, now.a, {now.q[0], now.q[1], now.q[2]}, now.vector};
    double unit_mm = now.inch ? 25.4 : 1, v;
    bool lateral = false, down = false, rotary = false;
    struct v a = {0, 0, 0};
    if (get("X", &v))
        to.p.x = v * unit_mm, lateral = true;
    if (get("Y", &v))
        to.p.y = v * unit_mm, lateral = true;
    if (get("Z", &v))
        to.p.z = v * unit_mm, down = true;
    static const char *const turns[] = {"A", "B", "C"};
    for (int k = 0; k < 3; k++)
        if (get(turns[k], &v)) {
            v += shortest(turns[k]) ? 360 * round((now.q[k] - v) / 360) : 0;
            rotary = rotary || !now.turned[k] || fabs(v - now.q[k]) > 1e-9;
            now.turned[k] = true;
            to.q[k] = v;
            to.vector = false;
            to.a = axis_of(to.q);
        }
    if ((get("A3", &a.x) | get("B3", &a.y) | get("C3", &a.z)) ||
        (get("TX", &a.x) | get("TY", &a.y) | get("TZ", &a.z)) ||
        (vectors && (get("I", &a.x) | get("J", &a.y) | get("K", &a.z)))) {
        to.a = unit(a);
        to.vector = true;
    }
    if (get("XH", &a.x) | get("YH", &a.y) | get("ZH", &a.z)) {
        to.a = unit(add((struct v){unit_mm * a.x, unit_mm * a.y, unit_mm * a.z}, -1, to.p));
        to.vector = true;
    }
    if (to.vector && !now.vector)
        now.a = axis_of(now.q);
    rotary = rotary || (to.vector && angle(to.a, now.a) > 1e-4);
    go(rapid, curve, &to, rotary, lateral, down);
}

static void go_home(bool z, bool other)
{
    if (other && !z && !now.home)
        fault("rotary", "X, Y or a rotary axis goes home before Z", now.p.z);
    if (z) {
        now.home = true;
        now.known = false;
    }
}

static void spindle_words(void)
{
    if (is("M", 3) || is("M", 4) || is("M", 13) || is("M", 14))
        now.spindle = true;
    if (is("M", 5) || is("M", 30) || is("M", 2))
        now.spindle = false;
}

static bool five_axis; /* vectors by I J K */

static void g_block(void)
{
    spindle_words();
    bool turns = has("A") || has("B") || has("C");
    if (has("G")) {
        if (is("G", 20) || is("G", 70) || is("G", 700))
            now.inch = true;
        if (is("G", 0))
            now.move = RAPID;
        if (is("G", 1))
            now.move = FEED;
        if (is("G", 2) || is("G", 3) || is("G", 6.2) || is("G", 5.2) || is("G", 2.4) ||
            is("G", 3.4))
            now.move = CURVE;
    }
    if (now.control == SIEMENS) {
        if (has("CIP") || has("BSPLINE") || has("POLY") || has("CT"))
            now.move = CURVE;
        if (has("SUPA") || is("G", 153)) {
            go_home(has("Z"), has("X") || has("Y") || turns);
            return;
        }
        if (has("TRAORI")) {
            set_length(true, "TRAORI not over the part");
            return;
        }
        if (has("TRAFOOF") && now.length)
            set_length(false, "TRAFOOF not over the part");
        for (int i = 0; i < words; i++)
            if (strncmp(word[i].name, "CYCLE800", 8) == 0) {
                if (!now.home && now.cut)
                    fault("rotary", "CYCLE800 not home", now.p.z);
                now.blind = true;
            }
        if (is("D", 1) && !machine.tcp)
            now.length = true;
    } else {
        if (is("G", 53) || is("G", 28)) {
            if (is("G", 49))
                set_length(false, "G49 not over the part");
            go_home(has("Z"), has("X") || has("Y") || turns);
            return;
        }
        if (is("G", 43.4) || is("G", 43.5) || is("G", 43))
            set_length(true, "G43 not over the part");
        if (is("G", 49))
            set_length(false, "G49 not over the part");
        if (is("G", 43.5))
            five_axis = true;
        if (is("G", 43.4))
            five_axis = false;
        if (is("G", 68.2) || is("G", 53.1)) {
            if (!now.home)
                fault("rotary", "a tilted plane not home", now.p.z);
            now.blind = true;
        }
    }
    if (now.control == SIEMENS && now.blind && !now.length && has("Z"))
        now.length = true; /* by D1 */
    if (!is("G", 92) && !is("G", 10) && !is("G", 4) && !is("G", 68.2))
        move_block(now.move == RAPID, now.move == CURVE, five_axis);
}

static void klartext_block(void)
{
    const char *first = words > 1 ? word[1].name : "";
    spindle_words();
    if (strcmp(first, "TOOL") == 0) {
        double s = 0;
        now.spindle = now.spindle && !get("S", &s);
        return;
    }
    if (strcmp(first, "FUNCTION") == 0) {
        if (has("TCPM") && !has("RESET"))
            set_length(true, "TCPM not over the part");
        if (has("TCPM") && has("RESET") && now.length)
            set_length(false, "TCPM off not over the part");
        return;
    }
    if (strcmp(first, "PLANE") == 0) {
        if (!has("RESET")) {
            if (!now.home)
                fault("rotary", "PLANE not home", now.p.z);
            now.blind = true;
            now.length = true;
        }
        return;
    }
    if (is("M", 128))
        set_length(true, "M128 not over the part");
    if (is("M", 129))
        set_length(false, "M129 not over the part");
    if (strcmp(first, "BEGIN") == 0)
        now.inch = has("INCH");
    bool line = strcmp(first, "L") == 0 || strcmp(first, "LN") == 0;
    bool arc = strcmp(first, "C") == 0 || strcmp(first, "CR") == 0 || strcmp(first, "CT") == 0;
    if (!line && !arc)
        return;
    if (is("M", 91)) {
        go_home(has("Z"), has("X") || has("Y") || has("A") || has("B") || has("C"));
        return;
    }
    bool rapid = has("FMAX");
    if (!machine.tcp)
        now.length = true; /* TOOL CALL */
    move_block(rapid, arc, false);
}

int main(int argc, char **argv)
{
    static const char *const controls[] = {"fanuc", "siemens", "heidenhain", "linuxcnc"};
    char line[4000];
    if (argc < 7)
        return 2;
    for (int k = 0; k < 4; k++)
        if (strcmp(argv[1], controls[k]) == 0)
            now.control = k;
    read_machine(argv[2]);
    machine.tcp = machine.tcp && (now.control != LINUXCNC || strstr(argv[2], "linuxcnc"));
    radius = atof(argv[3]);
    flute = atof(argv[4]);
    tolerance = atof(argv[5]);
    if (argc > 7)
        read_scan(argv[7]);
    if (argc > 8)
        sscanf(argv[8], "%lf:%lf", &holder_radius, &holder_length);
    if (!machine.tcp && strstr(machine.type, "head"))
        points = 0; /* only tables are followed without control of the tip */
    FILE *f = fopen(argv[6], "r");
    if (!f)
        return 1;
    now.a = (struct v){0, 0, 1};
    bool ended = false, moved = false;
    while (fgets(line, sizeof line, f)) {
        now.line++;
        char *home = strstr(line, "HOME IS ABOVE Z");
        if (home)
            now.has_clear = sscanf(home + 15, "%lf", &now.clear) == 1;
        char *comment = line;
        for (; *comment; comment++) /* parentheses after = or a name belong to the words */
            if (*comment == ';' || (*comment == '(' && (comment == line || comment[-1] == ' ')))
                break;
        *comment = '\0';
        snprintf(now.block, sizeof now.block, "%.*s", (int)strcspn(line, " \n"), line);
        split(line);
        if (words == 0 || strcmp(word[0].name, "%") == 0)
            continue;
        ended = ended || is("M", 30) || is("M", 2) || has("END");
        if (now.control == HEIDENHAIN)
            klartext_block();
        else
            g_block();
        moved = moved || now.cut;
    }
    fclose(f);
    if (!ended)
        fault("end", "no M30", 0);
    if (moved && !now.home)
        fault("end", "the tool is not home", now.p.z);
    if (now.spindle)
        fault("end", "the spindle runs", 0);
    return now.faults ? 3 : 0;
}
