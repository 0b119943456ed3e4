/*
 * path_read - APT CL text to a path; see path.h, path_parse.h and cloudmill-path(5).
 *
 * Each major word has one row: in the table of motions below, in those of the head and of comments
 * that carry data (path_head.c), or among the words of one CAM system (cl_dialect.h).  A word
 * without a row is either a post-processor word, which is kept as text and counted, or a geometry
 * word, which is an error: without it the tool would go to another place.
 */
#include <stdlib.h>
#include <string.h>

#include "cl_dialect.h"
#include "math/elementary.h"

#define AT(p) (p)->error, (p)->path->name, (p)->apt.line

/* ---- numbers, points and directions */

int path_numbers(struct path_parse *p, size_t from, size_t n, double *value, const char *what)
{
    return apt_numbers(&p->apt, p->path->name, from, n, value, what, p->error);
}

/* Converts a vector from the current coordinate system to the first of the stream. */
static struct vec3 into_first_frame(const struct path_parse *p, struct vec3 v)
{
    const struct frame *f = &p->frame, *g = &p->first;
    struct vec3 z = vec_cross(f->x, f->y);
    struct vec3 w = vec_along(vec_along(vec_scale(v.x, f->x), v.y, f->y), v.z, z);
    return vec(vec_dot(w, g->x), vec_dot(w, g->y), vec_dot(w, vec_cross(g->x, g->y)));
}

struct vec3 path_vector_of(const struct path_parse *p, const double *v)
{
    struct vec3 way = vec_scale(p->unit, vec(v[0], v[1], v[2]));
    return p->framed ? into_first_frame(p, way) : way;
}

struct vec3 path_point_of(const struct path_parse *p, const double *v)
{
    struct vec3 at = path_vector_of(p, v);
    if (p->framed) {
        struct vec3 d = vec_sub(p->frame.origin, p->first.origin);
        const struct frame *g = &p->first;
        at =
            vec_add(at, vec(vec_dot(d, g->x), vec_dot(d, g->y), vec_dot(d, vec_cross(g->x, g->y))));
    }
    return vec_add(at, p->shift);
}

int path_direction(struct path_parse *p, const double *v, const char *what, struct vec3 *unit)
{
    struct vec3 a = vec(v[0], v[1], v[2]);
    double l = vec_length(a);
    if (!(l > 1e-9) || !isfinite(l))
        return error_at(AT(p), "found %s of length zero, expected a unit vector", what);
    *unit = fabs(l - 1) <= 2e-9 ? a : vec_unit(a);
    if (p->framed)
        *unit = into_first_frame(p, *unit);
    return 0;
}

/* ---- motions, and the order of statements */

static int read_rapid(struct path_parse *p)
{
    p->rapid = true;
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
    struct path_spline spline = spline_parse_finish(&p->spline, &to);
    if (path_expect_reach(p, to.p) < 0)
        return -1;
    path_tool_move(p);
    path_attach_contact(p, path_add_spline(p->path, to, spline));
    p->at = to;
    p->last_point = to.p;
    p->axis = to.a;
    p->rapid = false;
    return 0;
}

static int read_fini(struct path_parse *p)
{
    p->ended = true;
    return 0;
}

/* END, which some posts of CATIA write instead of FINI: the path is complete if nothing follows. */
static int read_end(struct path_parse *p)
{
    p->whole = true;
    return path_keep_text(p);
}

static int read_geometry(struct path_parse *p)
{
    return error_at(AT(p),
                    "found the geometry word %.40s, expected GOTO, CIRCLE or MOVNRB: ignoring "
                    "it would send the tool to the wrong place",
                    p->apt.word);
}

static const struct path_row motions[] = {
    {"GOTO", path_read_goto},
    {"CIRCLE", path_read_circle},
    {"RAPID", read_rapid},
    {"MOVARC", path_read_movarc},
    {"END", read_end},
    {"MOVNRB", read_movnrb},
    {"GODLTA", path_read_godlta},
    {"FROM", path_read_from},
    {"TLAXIS", path_read_tlaxis},
    {"CYCLE", path_read_cycle},
    {"FINI", read_fini},
    {"GOHOME", path_read_gohome},
    {"RETRCT", path_read_retrct},
    {"CLEARP", path_read_clearp},
    {"CLRSRF", path_read_clearp},
    {"ROTABL", path_read_rotabl},
    {"ROTATE", path_read_rotabl},
    {"ROTHED", path_read_rotabl},
};

/* Post-processor words that a later stage may use, kept as text. */
static const char *const kept[] = {
    "PPRINT", "INSERT", "TPRINT", "REMARK", "STOP",   "OPSTOP", "AUXFUN",
    "CUTCOM", "INTOL",  "OUTTOL", "TOLER",  "MACHIN", "CSYS",   "OPSKIP",
    "SELECT", "SEQNO",  "DISPLY", "REWIND", "SELCTL",
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

/* The row of a word: among the motions, the words of the stream's system, those of the head. */
static const struct path_row *find_row(const struct path_parse *p)
{
    const char *word = p->apt.word;
    if (p->apt.comment)
        return path_comment_row(word);
    const struct path_row *row = path_row_of_word(motions, sizeof motions / sizeof *motions, word);
    if (!row && p->dialect)
        row = path_row_of_word(p->dialect->rows, p->dialect->n, word);
    return row ? row : path_head_row(word);
}

/* -1: the statement may not come here, within an arc or a MOVNRB. */
static int expect_place(struct path_parse *p)
{
    static const char *const on_arc[] = {"GOTO",   "PAINT",  "FEDRAT", "PPRINT",
                                         "INSERT", "COOLNT", "SPINDL", "CUTCOM"};
    const char *word = p->apt.word;
    if (p->apt.comment)
        return 0;
    if (p->circle.open && !is_among(word, on_arc, sizeof on_arc / sizeof *on_arc))
        return error_at(AT(p), "found %.40s after CIRCLE, expected the GOTO at the arc's end",
                        word);
    if (p->spline.stage != SPLINE_NONE && strcmp(word, "GOTO") != 0 && *word &&
        strcmp(word, "MOVNRB") != 0)
        return error_at(AT(p), "found %.40s within MOVNRB, expected MOVNRB/OFF first", word);
    return 0;
}

/* Numbers without a word: more points of the GOTO before, or a matrix of CATIA. */
static int read_bare(struct path_parse *p, bool listing)
{
    double v[3];
    if (listing && p->dialect == &cl_creo && p->circle.lasting && p->apt.argument.n == 3) {
        if (path_numbers(p, 0, 3, v, "x, y, z") < 0)
            return -1;
        path_arc_continues(p, path_point_of(p, v));
    }
    if (listing)
        return path_read_goto(p);
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
    if (p->nurbs.open && !p->apt.comment && cl_nx_nurbs_end(p) < 0)
        return -1;
    if (!p->apt.comment && !*word && p->apt.argument.n)
        return read_bare(p, listing);
    if (p->catia.open || *word == 'B') {
        int done = cl_catia_nurbs(p);
        if (done != 0)
            return done < 0 ? -1 : 0;
    }
    const struct path_row *row = find_row(p);
    if (expect_place(p) < 0)
        return -1;
    if (row)
        return row->read(p);
    if (!p->apt.comment && is_geometry(word))
        return read_geometry(p);
    if (!p->apt.comment && !is_among(word, kept, sizeof kept / sizeof *kept)) {
        if (path_refuse_motion(p) < 0)
            return -1;
        path_count_unknown(p, word);
    }
    return path_keep_text(p);
}

static int read_all(struct path_parse *p)
{
    while (!p->ended) {
        if (!p->nurbs.open && path_read_plain_gotos(p) < 0)
            return -1;
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

static int read_stream(const char *file, enum path_unit unit, const struct path_listener *listener,
                       struct path *path, struct error *error)
{
    memset(path, 0, sizeof *path);
    path->head.chord = path->head.clearance = NAN;
    struct path_parse p = {
        .path = path, .error = error, .listener = listener, .unit = 1, .axis = {0, 0, 1}};
    p.unit_asked = unit != PATH_UNIT_SAID;
    p.unit = unit == PATH_UNIT_INCH ? 25.4 : 1;
    if (reader_open(&p.reader, file, error) < 0)
        return -1;
    path->name = p.reader.name;
    int result = p.unit_asked ? 0 : path_guess_unit(&p);
    result = result < 0 ? -1 : read_all(&p);
    if (result == 0)
        path_check_passes(&p);
    path->system = p.dialect ? p.dialect->name : NULL;
    spline_parse_free(&p.spline);
    array_free(&p.nurbs.knot);
    array_free(&p.nurbs.pole);
    array_free(&p.catia.interval);
    array_free(&p.catia.pole);
    array_free(&p.catia.head);
    apt_free(&p.apt);
    reader_close(&p.reader);
    if (result < 0)
        path_free(path);
    return result;
}

int path_read(const char *file, struct path *path, struct error *error)
{
    return path_read_listened(file, NULL, path, error);
}

int path_read_listened(const char *file, const struct path_listener *listener, struct path *path,
                       struct error *error)
{
    return read_stream(file, PATH_UNIT_SAID, listener, path, error);
}

int path_read_as(const char *file, enum path_unit unit, struct path *path, struct error *error)
{
    return read_stream(file, unit, NULL, path, error);
}
