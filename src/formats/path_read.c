/*
 * path_read - APT CL text to a path; see path.h and cloudmill-path(5).
 *
 * One row of the table at the end for each major word; a word that is in no row is a post-processor
 * word nobody here knows (carried along and counted), or one of the geometry words that no reader
 * may pass over, for then the tool would go elsewhere.
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "apt.h"
#include "path.h"
#include "path_spline.h"

/* What the statements read so far leave behind for those that come. */
struct parse {
    struct path *path;
    struct reader reader;
    struct apt apt;
    struct error *error;
    double unit; /* millimetres */
    bool rapid;  /* RAPID was said: the next point is one */
    bool moved;  /* `at` is known */
    struct pose at;
    bool touches; /* CONTCT was said for the next point */
    struct contact contact;
    bool in_circle; /* CIRCLE was said: the next statement is its end */
    struct path_arc arc;
    struct spline_parse spline;
    bool ended;
};

#define AT(p) (p)->error, (p)->path->name, (p)->apt.line

static int numbers(struct parse *p, size_t from, size_t n, double *value, const char *what)
{
    return apt_numbers(&p->apt, p->path->name, from, n, value, what, p->error);
}

static struct vec3 length_of(const struct parse *p, const double *v)
{
    return vec_scale(p->unit, vec(v[0], v[1], v[2]));
}

/* A direction: unit length when it is that but for its printed digits, made so when it is not. */
static int direction(struct parse *p, const double *v, const char *what, struct vec3 *unit)
{
    struct vec3 a = vec(v[0], v[1], v[2]);
    double l = vec_length(a);
    if (!(l > 1e-9) || !isfinite(l))
        return error_at(AT(p), "found %s of length zero, expected a unit vector", what);
    *unit = fabs(l - 1) <= 2e-9 ? a : vec_unit(a);
    return 0;
}

static int expect_reach(struct parse *p, struct vec3 v)
{
    if (fabs(v.x) < 1e8 && fabs(v.y) < 1e8 && fabs(v.z) < 1e8)
        return 0;
    return error_at(AT(p),
                    "found a coordinate too large for any machine, expected less than 1e8 mm");
}

static int read_partno(struct parse *p)
{
    const char *text = p->apt.raw + strlen("PARTNO");
    text += strspn(text, " \t/");
    if (p->path->head.partno)
        path_add_text(p->path, p->apt.raw);
    else
        p->path->head.partno = mem_string(text, strlen(text));
    return 0;
}

static int read_units(struct parse *p)
{
    if (apt_is(&p->apt, 0, "MM"))
        p->unit = 1;
    else if (apt_is(&p->apt, 0, "INCHES") || apt_is(&p->apt, 0, "INCH"))
        p->unit = 25.4;
    else if (apt_is(&p->apt, 0, "CM"))
        p->unit = 10;
    else
        return error_at(AT(p), "found units `%.40s`, expected MM, CM or INCHES",
                        p->apt.argument.n ? p->apt.argument.item[0].text : "");
    return 0;
}

static int read_multax(struct parse *p)
{
    p->path->head.multax = !apt_is(&p->apt, 0, "OFF");
    return 0;
}

/* CUTTER/d, r, e, f, alpha, beta, h: as many as are there; the angles have no unit of length. */
static int read_cutter(struct parse *p)
{
    struct path_head *head = &p->path->head;
    size_t n = p->apt.argument.n < 7 ? p->apt.argument.n : 7;
    if (head->cutter_n || p->apt.comment) {
        path_add_text(p->path, p->apt.raw);
        return 0;
    }
    double v[7];
    if (numbers(p, 0, n, v, "diameter, corner radius, e, f, alpha, beta, height") < 0)
        return -1;
    for (size_t i = 0; i < n; i++)
        head->cutter[i] = i == 4 || i == 5 ? v[i] : p->unit * v[i];
    head->cutter_n = (int)n;
    return 0;
}

static int read_tool(struct parse *p)
{
    double n;
    if (p->path->head.tool || !p->apt.argument.n || !p->apt.argument.item[0].is_number) {
        path_add_text(p->path, p->apt.raw);
        return 0;
    }
    if (numbers(p, 0, 1, &n, "tool number") < 0)
        return -1;
    if (n < 0 || n > 99999999 || n != floor(n))
        return error_at(AT(p), "found tool number %g, expected a whole number", n);
    p->path->head.tool = (int)n;
    return 0;
}

/* SPINDL/RPM,8000,CLW or SPINDL/8000,RPM,CLW in the head; later ones are carried along. */
static int read_spindle(struct parse *p)
{
    struct path_head *head = &p->path->head;
    double rpm = 0;
    for (size_t i = 0; i < p->apt.argument.n; i++)
        if (p->apt.argument.item[i].is_number)
            rpm = p->apt.argument.item[i].number;
    if (head->spindle > 0 || rpm <= 0) {
        path_add_text(p->path, p->apt.raw);
        return 0;
    }
    head->spindle = rpm;
    for (size_t i = 0; i < p->apt.argument.n; i++)
        head->spindle_ccw = head->spindle_ccw || apt_is(&p->apt, i, "CCLW");
    return 0;
}

static int read_coolant(struct parse *p)
{
    int said = apt_is(&p->apt, 0, "OFF") ? 1 : apt_is(&p->apt, 0, "MIST") ? 3 : 2;
    if (p->path->head.coolant || p->moved)
        path_add_text(p->path, p->apt.raw);
    else
        p->path->head.coolant = said;
    return 0;
}

/* FEDRAT/MMPM,800 or /800,MMPM; IPM likewise.  Feeds by the turn become feeds by the minute. */
static int read_feed(struct parse *p)
{
    double value = NAN, unit = p->unit;
    for (size_t i = 0; i < p->apt.argument.n; i++) {
        const struct apt_argument *a = &p->apt.argument.item[i];
        if (a->is_number && isnan(value))
            value = a->number;
        else if (strcmp(a->text, "MMPM") == 0)
            unit = 1;
        else if (strcmp(a->text, "IPM") == 0)
            unit = 25.4;
        else if (strcmp(a->text, "MMPR") == 0)
            unit = p->path->head.spindle;
        else if (strcmp(a->text, "IPR") == 0)
            unit = 25.4 * p->path->head.spindle;
        else if (!a->is_number)
            return error_at(AT(p),
                            "found `%.40s` in FEDRAT, expected a number and MMPM, IPM, MMPR "
                            "or IPR",
                            a->text);
    }
    if (isnan(value))
        return error_at(AT(p), "found no number in FEDRAT, expected a feed");
    if (!(value * unit > 0))
        return error_at(AT(p), "found a feed of %g in FEDRAT, expected one above 0", value * unit);
    path_add_feed(p->path, value * unit);
    return 0;
}

static int read_rapid(struct parse *p)
{
    p->rapid = true;
    return 0;
}

/* Both ends of the arc must lie on its circle. */
static int expect_on_circle(struct parse *p, struct vec3 point, const char *which)
{
    struct vec3 d = vec_sub(point, p->arc.centre);
    double height = vec_dot(d, p->arc.axis), r = vec_length(vec_reject(d, p->arc.axis));
    if (fabs(r - p->arc.radius) > 0.01)
        return error_at(AT(p),
                        "found the %s of a CIRCLE %.4f mm from its centre, expected its "
                        "radius %.4f",
                        which, r, p->arc.radius);
    if (fabs(height) > 0.01)
        return error_at(AT(p), "found the %s of a CIRCLE %.4f mm off its plane, expected it there",
                        which, fabs(height));
    return 0;
}

static void take_contact(struct parse *p, struct path_item *item)
{
    item->line = p->apt.line;
    item->touches = p->touches;
    item->contact = p->contact;
    p->touches = false;
}

static int move_to(struct parse *p, struct pose to)
{
    if (expect_reach(p, to.p) < 0)
        return -1;
    if (p->in_circle) {
        if (expect_on_circle(p, p->at.p, "start") < 0 || expect_on_circle(p, to.p, "end") < 0)
            return -1;
        take_contact(p, path_add_arc(p->path, to, p->arc));
        p->in_circle = false;
    } else {
        take_contact(p, path_add_point(p->path, to, p->rapid));
    }
    p->rapid = false;
    p->moved = true;
    p->at = to;
    return 0;
}

static int read_goto(struct parse *p)
{
    size_t n = p->apt.argument.n;
    double v[6];
    if (n != 3 && n != 6)
        return error_at(AT(p), "found %zu numbers in GOTO, expected three or six", n);
    if (numbers(p, 0, n, v, n == 3 ? "x, y, z" : "x, y, z, i, j, k") < 0)
        return -1;
    struct pose to = {length_of(p, v), p->at.a};
    if (n == 6 && direction(p, v + 3, "a tool axis", &to.a) < 0)
        return -1;
    if (p->spline.stage == SPLINE_FALLBACK) {
        spline_parse_point(&p->spline, to);
        return 0;
    }
    return move_to(p, to);
}

static int read_godlta(struct parse *p)
{
    double v[3];
    if (!p->moved)
        return error_at(AT(p), "found GODLTA before any position, expected FROM or GOTO first");
    if (numbers(p, 0, 3, v, "dx, dy, dz") < 0)
        return -1;
    return move_to(p, (struct pose){vec_add(p->at.p, length_of(p, v)), p->at.a});
}

/* FROM says where the tool is, without a motion. */
static int read_from(struct parse *p)
{
    double v[6];
    size_t n = p->apt.argument.n >= 6 ? 6 : 3;
    if (numbers(p, 0, n, v, "x, y, z") < 0)
        return -1;
    p->at.p = length_of(p, v);
    p->moved = true;
    path_add_text(p->path, p->apt.raw);
    return n == 6 ? direction(p, v + 3, "a tool axis", &p->at.a) : 0;
}

/* CIRCLE/centre, axis[, radius]: without its radius the position now says it. */
static int read_circle(struct parse *p)
{
    size_t n = p->apt.argument.n;
    double v[7];
    if (n != 6 && n != 7)
        return error_at(AT(p), "found %zu numbers in CIRCLE, expected seven: centre, axis, radius",
                        n);
    if (!p->moved)
        return error_at(AT(p), "found CIRCLE before any position, expected a GOTO first");
    if (numbers(p, 0, n, v, "centre, axis, radius") < 0)
        return -1;
    p->arc.centre = length_of(p, v);
    if (direction(p, v + 3, "a CIRCLE's axis", &p->arc.axis) < 0)
        return -1;
    p->arc.radius = n == 7 ? p->unit * v[6]
                           : vec_length(vec_reject(vec_sub(p->at.p, p->arc.centre), p->arc.axis));
    if (!(p->arc.radius > 0))
        return error_at(AT(p), "found a CIRCLE of radius %g, expected one above 0", p->arc.radius);
    p->in_circle = true;
    return 0;
}

static int read_movnrb(struct parse *p)
{
    int done = spline_parse(&p->spline, &p->apt, p->path->name, p->unit, p->at, p->error);
    if (done != 1)
        return done;
    struct pose to;
    struct path_spline spline = spline_parse_take(&p->spline, &to);
    if (expect_reach(p, to.p) < 0)
        return -1;
    take_contact(p, path_add_spline(p->path, to, spline));
    p->at = to;
    p->rapid = false;
    return 0;
}

static int read_pass(struct parse *p)
{
    double n;
    if (numbers(p, 0, 1, &n, "number of the pass") < 0)
        return -1;
    if (n < 0 || n > 1e9 || n != floor(n))
        return error_at(AT(p), "found PASS/%g, expected a whole number", n);
    path_add_pass(p->path, (size_t)n);
    return 0;
}

static int read_contact(struct parse *p)
{
    double v[6];
    if (numbers(p, 0, 6, v, "x, y, z and the surface normal") < 0)
        return -1;
    p->contact.p = length_of(p, v);
    p->touches = true;
    return direction(p, v + 3, "a surface normal", &p->contact.n);
}

static int read_track(struct parse *p)
{
    struct path_head *head = &p->path->head;
    if (apt_is(&p->apt, 0, "TIP"))
        head->track = TRACK_TIP;
    else if (apt_is(&p->apt, 0, "CENTER") || apt_is(&p->apt, 0, "CENTRE"))
        head->track = TRACK_CENTRE;
    else if (apt_is(&p->apt, 0, "CONTACT"))
        head->track = TRACK_CONTACT;
    else
        return error_at(AT(p), "found TRACK/%.40s, expected TIP, CENTER or CONTACT",
                        p->apt.argument.n ? p->apt.argument.item[0].text : "");
    return 0;
}

static int read_ledger(struct parse *p)
{
    double spent;
    if (numbers(p, 1, 1, &spent, "mm spent") < 0)
        return -1;
    /* the stage's name as it was written, not in capitals */
    const char *name = strchr(p->apt.raw, '/') + 1;
    name += strspn(name, " \t");
    char *stage = mem_string(name, strcspn(name, ", \t"));
    path_spend(p->path, stage, spent);
    free(stage);
    return 0;
}

static int read_chord(struct parse *p)
{
    return numbers(p, 0, 1, &p->path->head.chord, "mm");
}

static int read_clear(struct parse *p)
{
    return numbers(p, 0, 1, &p->path->head.clearance, "z of the clearance plane");
}

static int read_nothing(struct parse *p)
{
    (void)p;
    return 0;
}

static int read_text(struct parse *p)
{
    path_add_text(p->path, p->apt.raw);
    return 0;
}

static int read_fini(struct parse *p)
{
    p->ended = true;
    return 0;
}

static int read_geometry(struct parse *p)
{
    return error_at(AT(p),
                    "found the geometry word %.40s, expected GOTO, CIRCLE or MOVNRB: passing "
                    "over it would send the tool elsewhere",
                    p->apt.word);
}

struct row {
    const char *word;
    int (*read)(struct parse *p);
};

static const struct row statements[] = {
    {"GOTO", read_goto},
    {"CIRCLE", read_circle},
    {"RAPID", read_rapid},
    {"FEDRAT", read_feed},
    {"MOVNRB", read_movnrb},
    {"GODLTA", read_godlta},
    {"FROM", read_from},
    {"FINI", read_fini},
    {"PARTNO", read_partno},
    {"UNITS", read_units},
    {"UNIT", read_units},
    {"MULTAX", read_multax},
    {"CUTTER", read_cutter},
    {"LOADTL", read_tool},
    {"TOOLNO", read_tool},
    {"SPINDL", read_spindle},
    {"COOLNT", read_coolant},
    /* post-processor words that a later stage may use */
    {"PPRINT", read_text},
    {"INSERT", read_text},
    {"TPRINT", read_text},
    {"REMARK", read_text},
    {"DELAY", read_text},
    {"STOP", read_text},
    {"OPSTOP", read_text},
    {"CUTCOM", read_text},
    {"INTOL", read_text},
    {"OUTTOL", read_text},
    {"TOLER", read_text},
    {"MACHIN", read_text},
    {"END", read_text},
    {"CSYS", read_text},
    {"LOAD", read_text},
    {"SELECT", read_text},
    {"MODE", read_text},
    {"SEQNO", read_text},
};

static const struct row comments[] = {
    {"PASS", read_pass},         {"CONTCT", read_contact}, {"TRACK", read_track},
    {"LEDGER", read_ledger},     {"CHORD", read_chord},    {"CLEAR", read_clear},
    {"CLOUDMILL", read_nothing},
};

static const char *const geometry[] = {
    "GO",     "GOFWD",  "GOBACK", "GOLFT",  "GORGT",  "GOUP",   "GODOWN", "TLLFT",
    "TLRGT",  "TLON",   "TLONPS", "TLOFPS", "INDIRV", "INDIRP", "PSIS",   "SPLINE",
    "THRU",   "CYLNDR", "PLANE",  "LINE",   "POINT",  "SPHERE", "CONE",   "TORUS",
    "ELLIPS", "HYPERB", "LCONIC", "GCONIC", "QADRIC", "RULSRF", "TABCYL", "POLCON",
    "PATERN", "MATRIX", "VECTOR", "NURBS",  "KNOT",   "CNTRL",  "BEGIN",  "HELIX",
    "ARC",    "COPY",   "TRACUT", "POCKET", "SCURV",  "SSURF",  "CYCLE",  "ROTABL",
};

static bool is_geometry(const struct apt *apt)
{
    if (strchr(apt->word, '=')) /* a definition: L1 = LINE/... */
        return true;
    for (size_t i = 0; i < sizeof geometry / sizeof *geometry; i++)
        if (strcmp(apt->word, geometry[i]) == 0)
            return true;
    return false;
}

/* Counts a word that nobody knows, for one warning each. */
static void count_unknown(struct parse *p)
{
    for (size_t i = 0; i < p->path->unknown.n; i++)
        if (strcmp(p->path->unknown.item[i].word, p->apt.word) == 0) {
            p->path->unknown.item[i].times++;
            return;
        }
    *array_push(&p->path->unknown) =
        (struct path_unknown){mem_string(p->apt.word, strlen(p->apt.word)), 1, p->apt.line};
}

static const struct row *find(const struct row *rows, size_t n, const char *word)
{
    for (size_t i = 0; i < n; i++)
        if (strcmp(rows[i].word, word) == 0)
            return &rows[i];
    return NULL;
}

static int read_statement(struct parse *p)
{
    const char *word = p->apt.word;
    const struct row *row = p->apt.comment
                                ? find(comments, sizeof comments / sizeof *comments, word)
                                : find(statements, sizeof statements / sizeof *statements, word);
    if (p->in_circle && !p->apt.comment && strcmp(word, "GOTO") != 0)
        return error_at(AT(p), "found %.40s behind CIRCLE, expected the GOTO at the arc's end",
                        word);
    if (p->spline.stage != SPLINE_NONE && !p->apt.comment && strcmp(word, "GOTO") != 0 &&
        strcmp(word, "MOVNRB") != 0)
        return error_at(AT(p), "found %.40s within MOVNRB, expected MOVNRB/OFF first", word);
    if (row)
        return row->read(p);
    if (!p->apt.comment && is_geometry(&p->apt))
        return read_geometry(p);
    if (!p->apt.comment)
        count_unknown(p);
    return read_text(p);
}

static int read_all(struct parse *p)
{
    while (!p->ended) {
        int got = apt_read(&p->reader, &p->apt, p->error);
        if (got < 0)
            return -1;
        if (got == 0)
            return error_at(p->error, p->path->name, p->reader.line,
                            p->reader.line ? "the input ends without FINI, expected it: the path "
                                             "was cut off"
                                           : "found an empty input, expected a path with FINI");
        if (read_statement(p) < 0)
            return -1;
    }
    return 0;
}

int path_read(const char *file, struct path *path, struct error *error)
{
    memset(path, 0, sizeof *path);
    path->head.chord = path->head.clearance = NAN;
    struct parse p = {.path = path, .error = error, .unit = 1, .at.a = {0, 0, 1}};
    if (reader_open(&p.reader, file, error) < 0)
        return -1;
    path->name = p.reader.name;
    int result = read_all(&p);
    spline_parse_free(&p.spline);
    apt_free(&p.apt);
    reader_close(&p.reader);
    if (result < 0)
        path_free(path);
    return result;
}
