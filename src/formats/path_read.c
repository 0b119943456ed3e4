/*
 * path_read - APT CL text to a path; see path.h and cloudmill-path(5).
 *
 * One row of the table at the end for each major word; a word that is in no row is a post-processor
 * word nobody here knows (carried along and counted), or one of the geometry words that no reader
 * may pass over, for then the tool would go elsewhere.
 */
#include <math.h>
#include <string.h>

#include "num.h"
#include "path_parse.h"

#define AT(p) (p)->error, (p)->path->name, (p)->apt.line

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

/* Both ends of the arc must lie on its circle. */
static int expect_on_circle(struct path_parse *p, struct vec3 point, const char *which)
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

static void take_contact(struct path_parse *p, struct path_item *item)
{
    item->line = p->apt.line;
    item->touches = p->touches;
    item->contact = p->contact;
    p->touches = false;
}

static int move_to(struct path_parse *p, struct pose to)
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

static int read_goto(struct path_parse *p)
{
    size_t n = p->apt.argument.n;
    double v[6];
    if (n != 3 && n != 6)
        return error_at(AT(p), "found %zu numbers in GOTO, expected three or six", n);
    if (path_numbers(p, 0, n, v, n == 3 ? "x, y, z" : "x, y, z, i, j, k") < 0)
        return -1;
    struct pose to = {path_length_of(p, v), p->at.a};
    if (n == 6 && path_direction(p, v + 3, "a tool axis", &to.a) < 0)
        return -1;
    if (p->spline.stage == SPLINE_FALLBACK) {
        spline_parse_point(&p->spline, to);
        return 0;
    }
    return move_to(p, to);
}

static int read_godlta(struct path_parse *p)
{
    double v[3];
    if (!p->moved)
        return error_at(AT(p), "found GODLTA before any position, expected FROM or GOTO first");
    if (path_numbers(p, 0, 3, v, "dx, dy, dz") < 0)
        return -1;
    return move_to(p, (struct pose){vec_add(p->at.p, path_length_of(p, v)), p->at.a});
}

/* FROM says where the tool is, without a motion.  It is carried along, in millimetres. */
static int read_from(struct path_parse *p)
{
    double v[6];
    size_t n = p->apt.argument.n >= 6 ? 6 : 3;
    if (path_numbers(p, 0, n, v, "x, y, z") < 0)
        return -1;
    p->at.p = path_length_of(p, v);
    p->moved = true;
    if (n == 6 && path_direction(p, v + 3, "a tool axis", &p->at.a) < 0)
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

/* CIRCLE/centre, axis[, radius]: without its radius the position now says it. */
static int read_circle(struct path_parse *p)
{
    size_t n = p->apt.argument.n;
    double v[7];
    if (n != 6 && n != 7)
        return error_at(AT(p), "found %zu numbers in CIRCLE, expected seven: centre, axis, radius",
                        n);
    if (!p->moved)
        return error_at(AT(p), "found CIRCLE before any position, expected a GOTO first");
    if (path_numbers(p, 0, n, v, "centre, axis, radius") < 0)
        return -1;
    p->arc.centre = path_length_of(p, v);
    if (path_direction(p, v + 3, "a CIRCLE's axis", &p->arc.axis) < 0)
        return -1;
    p->arc.radius = n == 7 ? p->unit * v[6]
                           : vec_length(vec_reject(vec_sub(p->at.p, p->arc.centre), p->arc.axis));
    if (!(p->arc.radius > 0))
        return error_at(AT(p), "found a CIRCLE of radius %g, expected one above 0", p->arc.radius);
    p->in_circle = true;
    return 0;
}

static int read_movnrb(struct path_parse *p)
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

struct row {
    const char *word;
    int (*read)(struct path_parse *p);
};

static const struct path_row motions[] = {
    {"GOTO", read_goto},     {"CIRCLE", read_circle}, {"RAPID", read_rapid},
    {"MOVNRB", read_movnrb}, {"GODLTA", read_godlta}, {"FROM", read_from},
    {"FINI", read_fini},
};

/* Post-processor words that a later stage may use. */
static const char *const carried[] = {
    "PPRINT", "INSERT", "TPRINT", "REMARK", "DELAY", "STOP", "OPSTOP", "CUTCOM", "INTOL",
    "OUTTOL", "TOLER",  "MACHIN", "END",    "CSYS",  "LOAD", "SELECT", "MODE",   "SEQNO",
};

static const char *const geometry[] = {
    "GO",     "GOFWD",  "GOBACK", "GOLFT",  "GORGT",  "GOUP",   "GODOWN", "TLLFT",
    "TLRGT",  "TLON",   "TLONPS", "TLOFPS", "INDIRV", "INDIRP", "PSIS",   "SPLINE",
    "THRU",   "CYLNDR", "PLANE",  "LINE",   "POINT",  "SPHERE", "CONE",   "TORUS",
    "ELLIPS", "HYPERB", "LCONIC", "GCONIC", "QADRIC", "RULSRF", "TABCYL", "POLCON",
    "PATERN", "MATRIX", "VECTOR", "NURBS",  "KNOT",   "CNTRL",  "BEGIN",  "HELIX",
    "ARC",    "COPY",   "TRACUT", "POCKET", "SCURV",  "SSURF",  "CYCLE",  "ROTABL",
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
    return strchr(word, '=') || /* a definition: L1 = LINE/... */
           is_among(word, geometry, sizeof geometry / sizeof *geometry);
}

/* Counts a word that nobody knows, for one warning each. */
static void count_unknown(struct path_parse *p)
{
    for (size_t i = 0; i < p->path->unknown.n; i++)
        if (strcmp(p->path->unknown.item[i].word, p->apt.word) == 0) {
            p->path->unknown.item[i].times++;
            return;
        }
    *array_push(&p->path->unknown) =
        (struct path_unknown){mem_string(p->apt.word, strlen(p->apt.word)), 1, p->apt.line};
}

static const struct path_row *find_row(const struct apt *apt)
{
    if (apt->comment)
        return path_comment_row(apt->word);
    const struct path_row *row =
        path_find_row(motions, sizeof motions / sizeof *motions, apt->word);
    return row ? row : path_head_row(apt->word);
}

static int read_statement(struct path_parse *p)
{
    const char *word = p->apt.word;
    const struct path_row *row = find_row(&p->apt);
    if (p->in_circle && !p->apt.comment && strcmp(word, "GOTO") != 0)
        return error_at(AT(p), "found %.40s behind CIRCLE, expected the GOTO at the arc's end",
                        word);
    if (p->spline.stage != SPLINE_NONE && !p->apt.comment && strcmp(word, "GOTO") != 0 &&
        strcmp(word, "MOVNRB") != 0)
        return error_at(AT(p), "found %.40s within MOVNRB, expected MOVNRB/OFF first", word);
    if (row)
        return row->read(p);
    if (!p->apt.comment && is_geometry(word))
        return read_geometry(p);
    if (!p->apt.comment && !is_among(word, carried, sizeof carried / sizeof *carried))
        count_unknown(p);
    return path_keep_text(p);
}

static int read_all(struct path_parse *p)
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
    struct path_parse p = {.path = path, .error = error, .unit = 1, .at.a = {0, 0, 1}};
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
