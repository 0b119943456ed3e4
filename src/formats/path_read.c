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

#include "cl_dialect.h"
#include "num.h"
#include "path_cycle.h"
#include "path_feed.h"
#include "path_parse.h"
#include "path_tool.h"

#define AT(p) (p)->error, (p)->path->name, (p)->apt.line

/* The ends of an arc may be off its circle, its start off its plane, by so much, mm. */
static const double near = 0.01;

static int expect_reach(struct path_parse *p, struct vec3 v)
{
    if (fabs(v.x) < 1e8 && fabs(v.y) < 1e8 && fabs(v.z) < 1e8)
        return 0;
    return error_at(AT(p),
                    "found a coordinate too large for any machine, expected less than 1e8 mm");
}

static int read_rapid(struct path_parse *p)
{
    p->rapid = true;
    return 0;
}

/* Both ends of the arc must lie on its circle, the start in its plane. */
static int expect_on_circle(struct path_parse *p, struct vec3 point, const char *which)
{
    const struct path_arc *arc = &p->circle.arc;
    struct vec3 d = vec_sub(point, arc->centre);
    double r = vec_length(vec_reject(d, arc->axis));
    if (fabs(r - arc->radius) > near)
        return error_at(AT(p),
                        "found the %s of a CIRCLE %.4f mm from its centre, expected its "
                        "radius %.4f",
                        which, r, arc->radius);
    return 0;
}

static void take_contact(struct path_parse *p, struct path_item *item)
{
    item->line = p->apt.line;
    item->touches = p->touches;
    item->contact = p->contact;
    p->touches = false;
}

/* An arc from where the tool is; its centre goes to the height of the start. */
static void add_arc(struct path_parse *p, struct pose to)
{
    struct path_arc arc = p->circle.arc;
    double height = vec_dot(vec_sub(p->at.p, arc.centre), arc.axis);
    if (fabs(height) > near)
        arc.centre = vec_along(arc.centre, height, arc.axis);
    struct motion motion = motion_arc(p->at, to, arc.centre, arc.axis);
    path_feed_inverse(p, motion_length(&motion));
    take_contact(p, path_add_arc(p->path, to, arc));
    p->at = to;
}

/* A helix of whole turns, each in two halves, for an arc turns less than once. */
static void add_turns(struct path_parse *p, struct pose to, size_t turns)
{
    struct pose from = p->at;
    const struct path_arc *arc = &p->circle.arc;
    struct vec3 spoke = vec_reject(vec_sub(from.p, arc->centre), arc->axis);
    struct vec3 rise = vec_sub(to.p, from.p);
    for (size_t i = 1; i < 2 * turns; i++) {
        double s = (double)i / (double)(2 * turns);
        struct vec3 base = i % 2 ? vec_along(from.p, -2, spoke) : from.p;
        add_arc(p, (struct pose){vec_along(base, s, rise), vec_slerp(from.a, to.a, s)});
    }
    add_arc(p, to);
}

/* The arc that was said, to its end. */
static int arc_to(struct path_parse *p, struct pose to)
{
    struct vec3 axis = p->circle.arc.axis, way = vec_sub(to.p, p->at.p);
    double rise = vec_dot(way, axis), off = vec_length(vec_reject(way, axis));
    bool closed = off < (p->circle.loose ? 2e-4 : 2e-6);
    if (expect_on_circle(p, p->at.p, "start") < 0 || expect_on_circle(p, to.p, "end") < 0)
        return -1;
    if (closed) /* start = end: a full turn, to where it began */
        to.p = fabs(rise) > near ? vec_along(p->at.p, rise, axis) : p->at.p;
    if (p->circle.turns && !closed)
        return error_at(AT(p),
                        "found a helix of TIMES,%zu that ends beside its start, expected it to "
                        "end above or below",
                        p->circle.turns);
    if (closed && (p->circle.turns || fabs(rise) > near))
        add_turns(p, to, p->circle.turns ? p->circle.turns : 1);
    else
        add_arc(p, to);
    p->circle.open = false;
    return 0;
}

int path_move_to(struct path_parse *p, struct pose to)
{
    if (expect_reach(p, to.p) < 0)
        return -1;
    path_tool_move(p);
    p->said = to.p;
    if (p->circle.open) {
        if (arc_to(p, to) < 0)
            return -1;
    } else if (p->cycling) {
        if (path_hole(p, to) < 0)
            return -1;
    } else {
        if (!p->rapid && p->moved)
            path_feed_inverse(p, vec_distance(p->at.p, to.p));
        take_contact(p, path_add_point(p->path, to, p->rapid));
        p->at = to;
    }
    p->rapid = false;
    p->moved = true;
    return 0;
}

/* GOTO, and numbers alone behind it. */
static int read_goto(struct path_parse *p)
{
    size_t n = p->apt.argument.n;
    double v[6];
    if (n != 3 && n != 6)
        return error_at(AT(p), "found %zu numbers in GOTO, expected three or six", n);
    if (path_numbers(p, 0, n, v, n == 3 ? "x, y, z" : "x, y, z, i, j, k") < 0)
        return -1;
    if (n == 6 && path_direction(p, v + 3, "a tool axis", &p->axis) < 0)
        return -1;
    struct pose to = {path_point_of(p, v), p->axis};
    p->listing = true;
    if (p->spline.stage == SPLINE_FALLBACK) {
        spline_parse_point(&p->spline, to);
        return 0;
    }
    return path_move_to(p, to);
}

static int read_godlta(struct path_parse *p)
{
    double v[3];
    if (!p->moved)
        return error_at(AT(p), "found GODLTA before any position, expected FROM or GOTO first");
    if (p->apt.argument.n != 3 && p->apt.argument.n != 1)
        return error_at(AT(p),
                        "found %zu numbers in GODLTA, expected dx, dy, dz or a way along "
                        "the tool axis",
                        p->apt.argument.n);
    if (path_numbers(p, 0, p->apt.argument.n, v, "dx, dy, dz") < 0)
        return -1;
    struct vec3 way =
        p->apt.argument.n == 1 ? vec_scale(p->unit * v[0], p->axis) : path_way_of(p, v);
    return path_move_to(p, (struct pose){vec_add(p->said, way), p->axis});
}

static int read_tlaxis(struct path_parse *p)
{
    double v[3];
    if (p->apt.argument.n != 3)
        return error_at(AT(p), "found %zu numbers in TLAXIS, expected i, j, k", p->apt.argument.n);
    if (path_numbers(p, 0, 3, v, "i, j, k") < 0)
        return -1;
    return path_direction(p, v, "a tool axis", &p->axis);
}

/* FROM says where the tool is, without a motion.  It is carried along, in millimetres. */
static int read_from(struct path_parse *p)
{
    double v[6];
    size_t n = p->apt.argument.n >= 6 ? 6 : 3;
    if (path_numbers(p, 0, n, v, "x, y, z") < 0)
        return -1;
    if (n == 6 && path_direction(p, v + 3, "a tool axis", &p->axis) < 0)
        return -1;
    p->at = (struct pose){path_point_of(p, v), p->axis};
    p->said = p->at.p;
    p->moved = true;
    if (expect_reach(p, p->at.p) < 0)
        return -1;
    const double at[] = {p->at.p.x, p->at.p.y, p->at.p.z, p->at.a.x, p->at.a.y, p->at.a.z};
    char text[6 * NUM_MAX] = "FROM";
    char *end = text + strlen(text);
    for (size_t i = 0; i < n; i++) {
        *end++ = i ? ',' : '/';
        end += num_write(end, at[i], i < 3 ? 6 : 9);
    }
    path_add_text(p->path, text);
    return 0;
}

int path_begin_arc(struct path_parse *p, struct path_arc arc)
{
    if (!p->moved)
        return error_at(AT(p), "found %.20s before any position, expected a GOTO first",
                        p->apt.word);
    if (p->cycling)
        return error_at(AT(p), "found %.20s among the holes of a CYCLE, expected CYCLE/OFF first",
                        p->apt.word);
    if (!(arc.radius > 0) || !isfinite(arc.radius))
        return error_at(AT(p), "found a CIRCLE of radius %g, expected one above 0", arc.radius);
    if (expect_reach(p, arc.centre) < 0)
        return -1;
    double height = vec_dot(vec_sub(p->at.p, arc.centre), arc.axis);
    if (fabs(height) > near)
        return error_at(AT(p),
                        "found the start of a CIRCLE %.4f mm off its plane, expected it there",
                        fabs(height));
    p->circle = (struct arc_parse){.open = true, .arc = arc};
    return 0;
}

/*
 * CIRCLE/centre, axis[, radius]: without its radius the position now says it.  With eleven numbers,
 * of NX and MAKINO-FF, the arc runs clockwise about its axis, and TIMES,n are turns of a helix.
 */
static int read_circle(struct path_parse *p)
{
    size_t n = p->apt.argument.n;
    bool clockwise = n >= 11;
    double v[7], times = 0;
    struct path_arc arc;
    if (n != 6 && n != 7 && !clockwise)
        return error_at(AT(p), "found %zu numbers in CIRCLE, expected seven: centre, axis, radius",
                        n);
    if (path_numbers(p, 0, n == 6 ? 6 : 7, v, "centre, axis, radius") < 0 ||
        path_direction(p, v + 3, "a CIRCLE's axis", &arc.axis) < 0)
        return -1;
    arc.centre = path_point_of(p, v);
    if (apt_is(&p->apt, 11, "TIMES") && path_numbers(p, 12, 1, &times, "turns") < 0)
        return -1;
    if (!(times >= 0 && times <= 10000 && times == floor(times)))
        return error_at(AT(p), "found TIMES,%g in CIRCLE, expected a whole number", times);
    if (clockwise) {
        arc.axis = vec_scale(-1, arc.axis);
        double height = vec_dot(vec_sub(p->at.p, arc.centre), arc.axis);
        arc.centre = vec_along(arc.centre, height, arc.axis); /* a helix may have it at its end */
    }
    arc.radius =
        n == 6 ? vec_length(vec_reject(vec_sub(p->at.p, arc.centre), arc.axis)) : p->unit * v[6];
    if (path_begin_arc(p, arc) < 0)
        return -1;
    p->circle.loose = clockwise;
    p->circle.turns = (size_t)times;
    return 0;
}

static int read_movnrb(struct path_parse *p)
{
    if (p->cycling || p->shift.x != 0 || p->shift.y != 0 || p->shift.z != 0)
        return error_at(AT(p), "found MOVNRB under CYCLE, ORIGIN or TRANS, expected none of them");
    int done = spline_parse(&p->spline, &p->apt, p->path->name, p->unit, p->at, p->error);
    if (done != 1)
        return done;
    struct pose to;
    struct path_spline spline = spline_parse_take(&p->spline, &to);
    if (expect_reach(p, to.p) < 0)
        return -1;
    path_tool_move(p);
    take_contact(p, path_add_spline(p->path, to, spline));
    p->at = to;
    p->said = to.p;
    p->axis = to.a;
    p->rapid = false;
    return 0;
}

static int read_fini(struct path_parse *p)
{
    p->ended = true;
    return 0;
}

static int read_geometry(struct path_parse *p)
{
    return error_at(AT(p),
                    "found the geometry word %.40s, expected GOTO, CIRCLE or MOVNRB: passing "
                    "over it would send the tool elsewhere",
                    p->apt.word);
}

static const struct path_row motions[] = {
    {"GOTO", read_goto},     {"CIRCLE", read_circle},    {"RAPID", read_rapid},
    {"MOVNRB", read_movnrb}, {"GODLTA", read_godlta},    {"FROM", read_from},
    {"TLAXIS", read_tlaxis}, {"CYCLE", path_read_cycle}, {"FINI", read_fini},
};

/* Post-processor words that a later stage may use. */
static const char *const carried[] = {
    "PPRINT", "INSERT", "TPRINT", "REMARK", "STOP",   "OPSTOP", "CUTCOM", "INTOL",  "OUTTOL",
    "TOLER",  "MACHIN", "END",    "CSYS",   "SELECT", "SEQNO",  "DISPLY", "REWIND", "SELCTL",
};

static const char *const geometry[] = {
    "GO",     "GOFWD",  "GOBACK", "GOLFT",  "GORGT",  "GOUP",   "GODOWN", "TLLFT",
    "TLRGT",  "TLON",   "TLONPS", "TLOFPS", "INDIRV", "INDIRP", "PSIS",   "SPLINE",
    "THRU",   "CYLNDR", "PLANE",  "LINE",   "POINT",  "SPHERE", "CONE",   "TORUS",
    "ELLIPS", "HYPERB", "LCONIC", "GCONIC", "QADRIC", "RULSRF", "TABCYL", "POLCON",
    "PATERN", "MATRIX", "VECTOR", "NURBS",  "KNOT",   "CNTRL",  "BEGIN",  "HELIX",
    "ARC",    "COPY",   "TRACUT", "POCKET", "SCURV",  "SSURF",  "ROTABL",
};

static bool is_among(const char *word, const char *const *words, size_t n)
{
    for (size_t i = 0; i < n; i++)
        if (strcmp(word, words[i]) == 0)
            return true;
    return false;
}

static bool is_geometry(const char *word)
{
    char first[8] = "";
    size_t n = strcspn(word, ",");
    if (n < sizeof first)
        memcpy(first, word, n);
    return strchr(word, '=') || /* a definition: L1 = LINE/... */
           is_among(first, geometry, sizeof geometry / sizeof *geometry);
}

void path_count_unknown(struct path_parse *p, const char *word)
{
    for (size_t i = 0; i < p->path->unknown.n; i++)
        if (strcmp(p->path->unknown.item[i].word, word) == 0) {
            p->path->unknown.item[i].times++;
            return;
        }
    *array_push(&p->path->unknown) =
        (struct path_unknown){mem_string(word, strlen(word)), 1, p->apt.line};
}

/* The row of a word: of a motion, of the system that wrote the stream, of the head. */
static const struct path_row *find_row(const struct path_parse *p)
{
    const char *word = p->apt.word;
    if (p->apt.comment)
        return path_comment_row(word);
    const struct path_row *row = path_find_row(motions, sizeof motions / sizeof *motions, word);
    if (!row && p->dialect)
        row = path_find_row(p->dialect->rows, p->dialect->n, word);
    return row ? row : path_head_row(word);
}

/* What a statement may not stand within. */
static int expect_place(struct path_parse *p)
{
    static const char *const on_arc[] = {"GOTO", "PAINT", "FEDRAT", "PPRINT"};
    const char *word = p->apt.word;
    if (p->apt.comment)
        return 0;
    if (p->circle.open && !is_among(word, on_arc, sizeof on_arc / sizeof *on_arc))
        return error_at(AT(p), "found %.40s behind CIRCLE, expected the GOTO at the arc's end",
                        word);
    if (p->spline.stage != SPLINE_NONE && strcmp(word, "GOTO") != 0 && *word &&
        strcmp(word, "MOVNRB") != 0)
        return error_at(AT(p), "found %.40s within MOVNRB, expected MOVNRB/OFF first", word);
    return 0;
}

/* Numbers without a word: more points of the GOTO before, or a matrix of CATIA. */
static int read_bare(struct path_parse *p, bool listing)
{
    if (listing && !p->circle.open)
        return read_goto(p);
    if (p->matrix > 0) {
        p->matrix--;
        return 0;
    }
    return error_at(AT(p), "found numbers without a word, expected a word like GOTO before them");
}

static int read_statement(struct path_parse *p)
{
    const char *word = p->apt.word;
    bool listing = p->listing;
    if (!p->apt.comment)
        p->listing = false;
    if (!p->sniffed && strcmp(word, "GOTO") != 0)
        cl_sniff(p);
    if (p->apt.comment && strncmp(p->apt.raw, "$$*CATIA0", 9) == 0)
        p->matrix = 3;
    if (p->nurbs.open && !p->apt.comment && cl_nurbs_end(p) < 0)
        return -1;
    if (!p->apt.comment && !*word && p->apt.argument.n)
        return read_bare(p, listing);
    const struct path_row *row = find_row(p);
    if (expect_place(p) < 0)
        return -1;
    if (row)
        return row->read(p);
    if (!p->apt.comment && is_geometry(word))
        return read_geometry(p);
    if (!p->apt.comment && !is_among(word, carried, sizeof carried / sizeof *carried))
        path_count_unknown(p, word);
    return path_keep_text(p);
}

static int read_all(struct path_parse *p)
{
    while (!p->ended) {
        int got = apt_read(&p->reader, &p->apt, p->error);
        if (got < 0)
            return -1;
        if (got == 0 && p->whole && p->depth == 0 && !p->circle.open)
            return 0;
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
    struct path_parse p = {.path = path, .error = error, .unit = 1, .axis = {0, 0, 1}};
    if (reader_open(&p.reader, file, error) < 0)
        return -1;
    path->name = p.reader.name;
    int result = read_all(&p);
    path->system = p.dialect ? p.dialect->name : NULL;
    spline_parse_free(&p.spline);
    array_free(&p.nurbs.knot);
    array_free(&p.nurbs.pole);
    apt_free(&p.apt);
    reader_close(&p.reader);
    if (result < 0)
        path_free(path);
    return result;
}
