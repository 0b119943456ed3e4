/* path_parse - the words of a path's head and of the comments that carry data; see path_parse.h. */
#include "path_parse.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "cl_dialect.h"
#include "path_feed.h"
#include "path_goto.h"
#include "path_tool.h"

#define AT(p) (p)->error, (p)->path->name, (p)->apt.line

int path_numbers(struct path_parse *p, size_t from, size_t n, double *value, const char *what)
{
    return apt_numbers(&p->apt, p->path->name, from, n, value, what, p->error);
}

/* A vector in the frame of the statements, told in the first one. */
static struct vec3 turned(const struct path_parse *p, struct vec3 v)
{
    const struct frame *f = &p->frame, *g = &p->first;
    struct vec3 z = vec_cross(f->x, f->y);
    struct vec3 w = vec_along(vec_along(vec_scale(v.x, f->x), v.y, f->y), v.z, z);
    return vec(vec_dot(w, g->x), vec_dot(w, g->y), vec_dot(w, vec_cross(g->x, g->y)));
}

struct vec3 path_way_of(const struct path_parse *p, const double *v)
{
    struct vec3 way = vec_scale(p->unit, vec(v[0], v[1], v[2]));
    return p->framed ? turned(p, way) : way;
}

struct vec3 path_point_of(const struct path_parse *p, const double *v)
{
    struct vec3 at = path_way_of(p, v);
    if (p->framed) {
        struct vec3 d = vec_sub(p->frame.origin, p->first.origin);
        const struct frame *g = &p->first;
        at =
            vec_add(at, vec(vec_dot(d, g->x), vec_dot(d, g->y), vec_dot(d, vec_cross(g->x, g->y))));
    }
    return vec_add(at, p->shift);
}

/* A direction: unit length when it is that but for its printed digits, made so when it is not. */
int path_direction(struct path_parse *p, const double *v, const char *what, struct vec3 *unit)
{
    struct vec3 a = vec(v[0], v[1], v[2]);
    double l = vec_length(a);
    if (!(l > 1e-9) || !isfinite(l))
        return error_at(AT(p), "found %s of length zero, expected a unit vector", what);
    *unit = fabs(l - 1) <= 2e-9 ? a : vec_unit(a);
    if (p->framed)
        *unit = turned(p, *unit);
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

static int read_units(struct path_parse *p)
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
    int said = apt_is(&p->apt, 0, "OFF") ? 1 : apt_is(&p->apt, 0, "MIST") ? 3 : 2;
    if (p->path->head.coolant || p->moved)
        path_add_text(p->path, p->apt.raw);
    else
        p->path->head.coolant = said;
    return 0;
}

static int read_pass(struct path_parse *p)
{
    double n;
    if (path_numbers(p, 0, 1, &n, "number of the pass") < 0)
        return -1;
    if (n < 0 || n > 1e9 || n != floor(n))
        return error_at(AT(p), "found PASS/%g, expected a whole number", n);
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

static int read_ledger(struct path_parse *p)
{
    double spent;
    if (path_numbers(p, 1, 1, &spent, "mm spent") < 0)
        return -1;
    if (!(spent >= 0))
        return error_at(AT(p), "found %g mm in LEDGER, expected 0 or more", spent);
    /* the stage's name as it was written, not in capitals */
    const char *name = strchr(p->apt.raw, '/') + 1;
    name += strspn(name, " \t");
    char *stage = mem_string(name, strcspn(name, ", \t"));
    path_spend(p->path, stage, spent);
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

int path_drop(struct path_parse *p)
{
    (void)p;
    return 0;
}

/* This suite's own stream: no other system's words. */
static int read_own(struct path_parse *p)
{
    p->sniffed = true;
    return 0;
}

/* ORIGIN: the machine's zero in the coordinates of the stream; TRANS: what is added to them. */
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

/* MODE/INCR, SET/MODE,INCR: coordinates that are ways. */
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
    {"CLOUDMILL", read_own},       {"CUTTER", path_read_cutter},
};

const struct path_row *path_find_row(const struct path_row *rows, size_t n, const char *word)
{
    for (size_t i = 0; i < n; i++)
        if (strcmp(rows[i].word, word) == 0)
            return &rows[i];
    return NULL;
}

const struct path_row *path_head_row(const char *word)
{
    return path_find_row(head_words, sizeof head_words / sizeof *head_words, word);
}

const struct path_row *path_comment_row(const char *word)
{
    return path_find_row(comments, sizeof comments / sizeof *comments, word);
}
