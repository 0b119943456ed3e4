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
#include "path_arc.h"
#include "path_cycle.h"
#include "path_goto.h"
#include "path_home.h"
#include "path_parse.h"
#include "path_tool.h"

#define AT(p) (p)->error, (p)->path->name, (p)->apt.line

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
    struct path_spline spline = spline_parse_take(&p->spline, &to);
    if (path_expect_reach(p, to.p) < 0)
        return -1;
    path_tool_move(p);
    path_take_contact(p, path_add_spline(p->path, to, spline));
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
    {"GOTO", path_read_goto},     {"CIRCLE", path_read_circle}, {"RAPID", read_rapid},
    {"MOVNRB", read_movnrb},      {"GODLTA", path_read_godlta}, {"FROM", path_read_from},
    {"TLAXIS", path_read_tlaxis}, {"CYCLE", path_read_cycle},   {"FINI", read_fini},
    {"GOHOME", path_read_gohome}, {"RETRCT", path_read_retrct}, {"CLEARP", path_read_clearp},
    {"CLRSRF", path_read_clearp}, {"ROTABL", path_read_rotabl}, {"ROTATE", path_read_rotabl},
    {"ROTHED", path_read_rotabl},
};

/* Post-processor words that a later stage may use. */
static const char *const carried[] = {
    "PPRINT", "INSERT", "TPRINT", "REMARK", "STOP",   "OPSTOP", "AUXFUN",
    "CUTCOM", "INTOL",  "OUTTOL", "TOLER",  "MACHIN", "END",    "CSYS",
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
    static const char *const on_arc[] = {"GOTO",   "PAINT",  "FEDRAT", "PPRINT",
                                         "INSERT", "COOLNT", "SPINDL", "CUTCOM"};
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
    double v[3];
    if (listing && p->dialect == &cl_creo && p->circle.lasting && p->apt.argument.n == 3) {
        if (path_numbers(p, 0, 3, v, "x, y, z") < 0)
            return -1;
        path_arc_goes_on(p, path_point_of(p, v));
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
    if (p->nurbs.open && !p->apt.comment && cl_nurbs_end(p) < 0)
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
    if (!p->apt.comment && !is_among(word, carried, sizeof carried / sizeof *carried))
        path_count_unknown(p, word);
    return path_keep_text(p);
}

static int read_all(struct path_parse *p)
{
    while (!p->ended) {
        if (!p->nurbs.open && path_goto_run(p) < 0)
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
    array_free(&p.catia.interval);
    array_free(&p.catia.pole);
    array_free(&p.catia.head);
    apt_free(&p.apt);
    reader_close(&p.reader);
    if (result < 0)
        path_free(path);
    return result;
}
