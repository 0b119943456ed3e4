/* path_parse - the words of a path's head and of the comments that carry data; see path_parse.h. */
#include "path_parse.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define AT(p) (p)->error, (p)->path->name, (p)->apt.line

int path_numbers(struct path_parse *p, size_t from, size_t n, double *value, const char *what)
{
    return apt_numbers(&p->apt, p->path->name, from, n, value, what, p->error);
}

struct vec3 path_length_of(const struct path_parse *p, const double *v)
{
    return vec_scale(p->unit, vec(v[0], v[1], v[2]));
}

/* A direction: unit length when it is that but for its printed digits, made so when it is not. */
int path_direction(struct path_parse *p, const double *v, const char *what, struct vec3 *unit)
{
    struct vec3 a = vec(v[0], v[1], v[2]);
    double l = vec_length(a);
    if (!(l > 1e-9) || !isfinite(l))
        return error_at(AT(p), "found %s of length zero, expected a unit vector", what);
    *unit = fabs(l - 1) <= 2e-9 ? a : vec_unit(a);
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
    p->path->head.multax = !apt_is(&p->apt, 0, "OFF");
    return 0;
}

/* CUTTER/d, r, e, f, alpha, beta, h: as many as are there; the angles have no unit of length. */
static int read_cutter(struct path_parse *p)
{
    struct path_head *head = &p->path->head;
    size_t n = p->apt.argument.n < 7 ? p->apt.argument.n : 7;
    if (head->cutter_n || p->apt.comment) {
        path_add_text(p->path, p->apt.raw);
        return 0;
    }
    double v[7];
    if (path_numbers(p, 0, n, v, "diameter, corner radius, e, f, alpha, beta, height") < 0)
        return -1;
    for (size_t i = 0; i < n; i++)
        head->cutter[i] = i == 4 || i == 5 ? v[i] : p->unit * v[i];
    head->cutter_n = (int)n;
    return 0;
}

static int read_tool(struct path_parse *p)
{
    double n;
    if (p->path->head.tool || !p->apt.argument.n || !p->apt.argument.item[0].is_number) {
        path_add_text(p->path, p->apt.raw);
        return 0;
    }
    if (path_numbers(p, 0, 1, &n, "tool number") < 0)
        return -1;
    if (n < 0 || n > 99999999 || n != floor(n))
        return error_at(AT(p), "found tool number %g, expected a whole number", n);
    p->path->head.tool = (int)n;
    return 0;
}

/* SPINDL/RPM,8000,CLW or SPINDL/8000,RPM,CLW in the head; later ones are carried along. */
static int read_spindle(struct path_parse *p)
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

static int read_coolant(struct path_parse *p)
{
    int said = apt_is(&p->apt, 0, "OFF") ? 1 : apt_is(&p->apt, 0, "MIST") ? 3 : 2;
    if (p->path->head.coolant || p->moved)
        path_add_text(p->path, p->apt.raw);
    else
        p->path->head.coolant = said;
    return 0;
}

/* FEDRAT/MMPM,800 or /800,MMPM; IPM likewise.  Feeds by the turn become feeds by the minute. */
static int read_feed(struct path_parse *p)
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

static int read_contact(struct path_parse *p)
{
    double v[6];
    if (path_numbers(p, 0, 6, v, "x, y, z and the surface normal") < 0)
        return -1;
    p->contact.p = path_length_of(p, v);
    p->touches = true;
    return path_direction(p, v + 3, "a surface normal", &p->contact.n);
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

static int read_nothing(struct path_parse *p)
{
    (void)p;
    return 0;
}

int path_keep_text(struct path_parse *p)
{
    path_add_text(p->path, p->apt.raw);
    return 0;
}

static const struct path_row head_words[] = {
    {"PARTNO", read_partno}, {"UNITS", read_units},    {"UNIT", read_units},
    {"MULTAX", read_multax}, {"CUTTER", read_cutter},  {"LOADTL", read_tool},
    {"TOOLNO", read_tool},   {"SPINDL", read_spindle}, {"COOLNT", read_coolant},
    {"FEDRAT", read_feed},
};

static const struct path_row comments[] = {
    {"PASS", read_pass},         {"CONTCT", read_contact}, {"TRACK", read_track},
    {"LEDGER", read_ledger},     {"CHORD", read_chord},    {"CLEAR", read_clear},
    {"CLOUDMILL", read_nothing},
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
