/*
 * path_read - APT CL text to a path; see path.h, path_parse.h and cloudmill-path(5).
 *
 * Each major word has one row in the tables below: the head and the comments that carry data, the
 * motions, and the words of one CAM system (cl_dialect.h).  A word without a row is either a
 * post-processor word, which is kept as text and counted, or a geometry word, which is an error:
 * without it the tool would go to another place.
 */
#include <ctype.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "cl_dialect.h"
#include "math/elementary.h"
#include "gouge/holder_text.h"

#define AT(p) (p)->error, (p)->path->name, (p)->apt.line

/* ---- numbers, points and directions; the head; comments that carry data */

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

static int read_partno(struct path_parse *p)
{
    const char *text = p->apt.raw + strlen("PARTNO");
    text += strspn(text, " \t/");
    if (p->path->head.partno)
        path_add_text(p->path, p->apt.raw);
    else
        p->path->head.partno = mem_string(text, strlen(text));
    return 0;
}

/* -1: the unit is another than the one that was asked for. */
static int set_unit(struct path_parse *p, double unit)
{
    if (p->unit_asked && p->unit != unit)
        return error_at(AT(p), "found UNITS/%.20s, expected %s, as asked for",
                        p->apt.argument.item[0].text, p->unit > 1 ? "INCHES" : "MM");
    p->unit = unit;
    p->unit_said = true;
    p->unit_line = p->apt.line;
    return path_unit_agrees(p);
}

static int read_units(struct path_parse *p)
{
    if (apt_is(&p->apt, 0, "MM"))
        return set_unit(p, 1);
    if (apt_is(&p->apt, 0, "INCHES") || apt_is(&p->apt, 0, "INCH"))
        return set_unit(p, 25.4);
    if (apt_is(&p->apt, 0, "CM"))
        return set_unit(p, 10);
    return error_at(AT(p), "found units `%.40s`, expected MM, CM or INCHES",
                    p->apt.argument.n ? p->apt.argument.item[0].text : "");
}

static int read_multax(struct path_parse *p)
{
    if (!apt_is(&p->apt, 0, "OFF"))
        p->path->head.multax = true;
    else
        p->axis = vec(0, 0, 1);
    return 0;
}

static int read_coolant(struct path_parse *p)
{
    const char *word = p->apt.argument.n ? p->apt.argument.item[0].text : "";
    enum path_coolant coolant = path_coolant_of(word);
    if (coolant == COOLANT_NOT_GIVEN) {
        char said[60];
        snprintf(said, sizeof said, "COOLNT/%.40s", word);
        path_count_unknown(p, said);
    } else if (p->path->head.coolant || p->moved) {
        path_add_text(p->path, p->apt.raw);
    } else {
        p->path->head.coolant = coolant;
    }
    return 0;
}

static int read_pass(struct path_parse *p)
{
    double n;
    if (path_numbers(p, 0, 1, &n, "number of the pass") < 0)
        return -1;
    if (n < 0 || n > 1e9 || n != floor(n))
        return error_at(AT(p), "found PASS/%g, expected a whole number", n);
    if (p->listener)
        p->listener->pass(p->listener->context, p->path);
    path_add_pass(p->path, (size_t)n);
    return 0;
}

static int read_track(struct path_parse *p)
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

/* The entry of a stage that says pass by pass what it spent. */
static struct ledger_entry *entry_by_pass(struct path *path, const char *stage)
{
    for (size_t i = 0; i < path->head.ledger.n; i++) {
        struct ledger_entry *entry = &path->head.ledger.item[i];
        if (entry->by_pass && strcmp(entry->stage, stage) == 0)
            return entry;
    }
    path_spend(path, stage, 0);
    path->head.ledger.item[path->head.ledger.n - 1].by_pass = true;
    return &path->head.ledger.item[path->head.ledger.n - 1];
}

static int read_ledger(struct path_parse *p)
{
    double spent;
    if (path_numbers(p, 1, 1, &spent, "mm spent") < 0)
        return -1;
    if (!(spent >= 0))
        return error_at(AT(p), "found %g mm in LEDGER, expected 0 or more", spent);
    /* the stage's name as it was written, not in upper case */
    const char *name = strchr(p->apt.raw, '/') + 1;
    name += strspn(name, " \t");
    char *stage = mem_string(name, strcspn(name, ", \t"));
    if (p->path->item.n == 0) {
        path_spend(p->path, stage, spent);
    } else {
        struct ledger_entry *entry = entry_by_pass(p->path, stage);
        entry->spent = fmax(entry->spent, spent);
    }
    free(stage);
    return 0;
}

/* UNMET/stage, text: as it was written, to the end of the line. */
static int read_unmet(struct path_parse *p)
{
    const char *name = strchr(p->apt.raw, '/');
    size_t n = name ? strcspn(++name, ",") : 0;
    if (n == 0 || name[n] != ',')
        return error_at(AT(p), "found `%.60s`, expected UNMET/stage, what it could not keep",
                        p->apt.raw);
    char *stage = mem_string(name, n);
    unmets_add(&p->path->head.unmet, stage, name + n + 1);
    free(stage);
    return 0;
}

static int read_chord(struct path_parse *p)
{
    return path_numbers(p, 0, 1, &p->path->head.chord, "mm");
}

static int read_clear(struct path_parse *p)
{
    return path_numbers(p, 0, 1, &p->path->head.clearance, "z of the clearance plane");
}

static int read_scallop(struct path_parse *p)
{
    return path_numbers(p, 0, 1, &p->path->head.scallop, "mm");
}

static int read_runs(struct path_parse *p)
{
    double v[2];
    if (path_numbers(p, 0, 2, v, "points of the cutting runs, largest feed") < 0)
        return -1;
    if (!(v[0] >= 1 && v[0] <= 1e15) || v[0] != floor(v[0]) || !(v[1] > 0))
        return error_at(AT(p), "found RUNS/%g,%g, expected a number of points and a feed", v[0],
                        v[1]);
    p->path->head.runs = (struct path_runs){(size_t)v[0], p->unit * v[1]};
    return 0;
}

/* TOOL/BALL-ONLY; TOOL/FLUTE,length,HOLDER,cones: what the tool is above its ball. */
static int read_body(struct path_parse *p)
{
    struct tool_body body = {.ball_only = apt_is(&p->apt, 0, "BALL-ONLY")};
    size_t n = p->apt.argument.n;
    struct error why;
    if (body.ball_only
            ? n != 1
            : !apt_is(&p->apt, 0, "FLUTE") || (n != 2 && (n != 4 || !apt_is(&p->apt, 2, "HOLDER"))))
        return error_at(AT(p),
                        "found `%.60s`, expected TOOL/BALL-ONLY or "
                        "TOOL/FLUTE,length,HOLDER,cones",
                        p->apt.raw);
    if (!body.ball_only && path_numbers(p, 1, 1, &body.flute, "length of the flute") < 0)
        return -1;
    if (!(body.flute >= 0 && body.flute <= 1e4))
        return error_at(AT(p), "found a flute of %g mm, expected 0 to 10000", body.flute);
    if (n == 4 && holder_text_read(p->apt.argument.item[3].text, &body.above, &why) < 0)
        return error_at(AT(p), "TOOL: %s", why.text);
    p->path->head.body = body;
    p->path->head.body_given = true;
    return 0;
}

/* SCAN/points, hash, name: as it was written, to the end of the line. */
static int read_scan(struct path_parse *p)
{
    struct scan_sources *scan = &p->path->head.scan;
    const char *text = strchr(p->apt.raw, '/');
    if (!text || !scan_sources_read(scan, text + 1, ','))
        return error_at(AT(p), "found `%.60s`, expected SCAN/points, hash, name of the scan",
                        p->apt.raw);
    char *name = scan->item[scan->n - 1].name;
    size_t n = strlen(name);
    if (n > 2 && strcmp(name + n - 2, "$$") == 0) /* doubled, so that it continues nothing */
        name[n - 1] = '\0';
    return 0;
}

/* PLACE/row, and its four numbers; the rows come in order. */
static int read_place(struct path_parse *p)
{
    struct scan_sources *scan = &p->path->head.scan;
    double v[5];
    if (path_numbers(p, 0, 5, v, "a row of the matrix that placed the scan") < 0)
        return -1;
    if (!(v[0] >= 1 && v[0] <= 3) || v[0] != floor(v[0]))
        return error_at(AT(p), "found row %g in PLACE, expected 1, 2 or 3", v[0]);
    if (!scan->placed)
        scan->place = transform_identity();
    scan->placed = true;
    memcpy(scan->place.m[(int)v[0] - 1], v + 1, 4 * sizeof *v);
    return 0;
}

int path_ignore(struct path_parse *p)
{
    (void)p;
    return 0;
}

/* A stream of this suite has no words of other systems. */
static int read_own(struct path_parse *p)
{
    p->sniffed = true;
    return 0;
}

/* ORIGIN: the machine's zero in the coordinates of the stream; TRANS: an offset added to them. */
static int read_shift(struct path_parse *p, struct vec3 *shift)
{
    double v[3];
    if (p->apt.argument.n != 3)
        return error_at(AT(p), "found %zu arguments in %s, expected x, y, z", p->apt.argument.n,
                        p->apt.word);
    if (path_numbers(p, 0, 3, v, "x, y, z") < 0)
        return -1;
    *shift = vec_scale(p->unit, vec(v[0], v[1], v[2]));
    p->shift = vec_sub(p->trans, p->origin);
    return 0;
}

static int read_origin(struct path_parse *p)
{
    return read_shift(p, &p->origin);
}

static int read_trans(struct path_parse *p)
{
    return read_shift(p, &p->trans);
}

/* MODE/INCR, SET/MODE,INCR: incremental coordinates. */
static int read_mode(struct path_parse *p)
{
    for (size_t i = 0; i < p->apt.argument.n; i++)
        if (strncmp(p->apt.argument.item[i].text, "INCR", 4) == 0)
            return error_at(AT(p), "found %s with incremental coordinates, expected absolute ones",
                            p->apt.word);
    return path_keep_text(p);
}

int path_keep_text(struct path_parse *p)
{
    path_add_text(p->path, p->apt.raw);
    p->path->item.item[p->path->item.n - 1].line = p->apt.line;
    return 0;
}

static const struct path_row head_words[] = {
    {"FEDRAT", path_read_feed},
    {"PARTNO", read_partno},
    {"UNITS", read_units},
    {"UNIT", read_units},
    {"MULTAX", read_multax},
    {"CUTTER", path_read_cutter},
    {"LOADTL", path_read_tool},
    {"TOOLNO", path_read_tool},
    {"TLCHG", path_read_tool},
    {"LOAD", path_read_load},
    {"SPINDL", path_read_spindle},
    {"COOLNT", read_coolant},
    {"DELAY", path_read_delay},
    {"ORIGIN", read_origin},
    {"TRANS", read_trans},
    {"MODE", read_mode},
    {"SET", read_mode},
};

static const struct path_row comments[] = {
    {"CONTCT", path_read_contact}, {"PASS", read_pass},          {"TRACK", read_track},
    {"LEDGER", read_ledger},       {"CHORD", read_chord},        {"CLEAR", read_clear},
    {"CLOUDMILL", read_own},       {"CUTTER", path_read_cutter}, {"SCALLOP", read_scallop},
    {"TOOL", read_body},           {"SCAN", read_scan},          {"PLACE", read_place},
    {"UNMET", read_unmet},         {"RUNS", read_runs},
};

/* The row of a table for a word; NULL: none. */
static const struct path_row *row_of_word(const struct path_row *rows, size_t n, const char *word)
{
    for (size_t i = 0; i < n; i++)
        if (strcmp(rows[i].word, word) == 0)
            return &rows[i];
    return NULL;
}

static const struct path_row *head_row(const char *word)
{
    return row_of_word(head_words, sizeof head_words / sizeof *head_words, word);
}

static const struct path_row *comment_row(const char *word)
{
    return row_of_word(comments, sizeof comments / sizeof *comments, word);
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
        return comment_row(word);
    const struct path_row *row = row_of_word(motions, sizeof motions / sizeof *motions, word);
    if (!row && p->dialect)
        row = row_of_word(p->dialect->rows, p->dialect->n, word);
    return row ? row : head_row(word);
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

/* ---- the unit of a stream that does not say it */

enum { PEEK_FIRST = 1 << 9, PEEK = 1 << 16, PEEK_MOST = 1 << 22 };

static bool is_letter(char c)
{
    return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9');
}

/* The n letters and digits are this word, in capitals or not. */
static bool is_word(const char *text, size_t n, const char *word)
{
    size_t k = 0;
    while (k < n && toupper((unsigned char)text[k]) == word[k])
        k++;
    return k == n && word[k] == '\0';
}

/* What the lines say of units; each is set where it is found. */
struct unit_signs {
    bool units, inch, mm;
};

static void look_at_line(const char *line, size_t n, struct unit_signs *found)
{
    bool feed = false, inch = false, mm = false;
    for (size_t i = 0; i < n; i++) {
        const char *word = line + i;
        while (i < n && is_letter(line[i]))
            i++;
        size_t m = (size_t)(line + i - word);
        if (m < 3 || m > 6)
            continue;
        feed = feed || is_word(word, m, "FEDRAT") || is_word(word, m, "CYCLE");
        inch = inch || is_word(word, m, "IPM") || is_word(word, m, "IPR");
        mm = mm || is_word(word, m, "MMPM") || is_word(word, m, "MMPR");
        found->units = found->units || is_word(word, m, "UNITS") || is_word(word, m, "UNIT");
    }
    found->inch = found->inch || (feed && inch);
    found->mm = found->mm || (feed && mm);
}

static void look_for_units(const char *text, size_t n, struct unit_signs *found)
{
    const char *end = text + n;
    while (text < end && !found->units) {
        const char *stop = memchr(text, '\n', (size_t)(end - text));
        size_t length = (size_t)((stop ? stop : end) - text);
        look_at_line(text, length, found);
        text += length + 1;
    }
}

/* The text without a last line that is not whole. */
static size_t whole_lines(const char *text, size_t n)
{
    while (n > 0 && text[n - 1] != '\n')
        n--;
    return n;
}

/* Before the first statement: inches, where nothing says the unit and feeds are in them.  Most
 * streams say it at once, and what comes slowly is not waited for. */
static int guess_unit(struct path_parse *p)
{
    struct unit_signs found = {0};
    size_t all = p->reader.size > 0 ? p->reader.size : PEEK_MOST;
    const char *text;
    for (size_t want = PEEK_FIRST;; want = want < PEEK ? 2 * want : all) {
        long got = reader_peek(&p->reader, &text, want, p->error);
        if (got < 0)
            return -1;
        bool last = want >= all || (size_t)got < want;
        found = (struct unit_signs){0};
        look_for_units(text, last ? (size_t)got : whole_lines(text, (size_t)got), &found);
        if (found.units || last)
            break;
    }
    if (found.units || !found.inch)
        return 0;
    if (found.mm)
        return error_set(p->error,
                         "%s: found feeds in inches and in mm and no UNITS, expected UNITS/MM, "
                         "UNITS/INCHES or option -u",
                         p->path->name);
    p->unit = 25.4;
    p->path->inches_taken = true;
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
    int result = p.unit_asked ? 0 : guess_unit(&p);
    result = result < 0 ? -1 : read_all(&p);
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
