/*
 * path_tool - tools, the spindle and feeds: CUTTER, LOADTL, TOOLNO, LOAD; SPINDL; FEDRAT, DELAY.
 * See path_parse.h.
 */
#include <stdio.h>
#include <string.h>

#include "math/elementary.h"
#include "base/num.h"
#include "path_parse.h"

#define AT(p) (p)->error, (p)->path->name, (p)->apt.line

static bool has_argument(const struct apt *apt, const char *word)
{
    for (size_t i = 0; i < apt->argument.n; i++)
        if (apt_is(apt, i, word))
            return true;
    return false;
}

/* The speed of the spindle from here on: the first is the head's, later ones are items. */
static int path_set_speed(struct path_parse *p, double rpm, bool ccw);

/* ---- tools */

static bool same_shape(const struct path_tool *a, const struct path_tool *b)
{
    if (a->cutter_n != b->cutter_n)
        return false;
    for (int i = 0; i < a->cutter_n; i++)
        if (a->cutter[i] != b->cutter[i])
            return false;
    return true;
}

/* The first tool is the head's, a later one the last item's. */
static void store_tool(struct path_parse *p)
{
    struct path *path = p->path;
    if (path->tool.n) {
        path->tool.item[path->tool.n - 1] = p->tool;
        return;
    }
    path->head.tool = p->tool.number;
    path->head.offset = p->tool.offset;
    memcpy(path->head.tool_name, p->tool.name, sizeof path->head.tool_name);
    path->head.cutter_n = p->tool.cutter_n;
    memcpy(path->head.cutter, p->tool.cutter, sizeof path->head.cutter);
}

void path_tool_shape(struct path_parse *p, const double *cutter, int n)
{
    struct path_tool *tool = p->tool_used ? &p->next_tool : &p->tool;
    memset(tool->cutter, 0, sizeof tool->cutter);
    memcpy(tool->cutter, cutter, (size_t)n * sizeof *cutter);
    tool->cutter_n = n;
    if (!p->tool_used)
        store_tool(p);
}

/* The next tool goes into the spindle. */
static void change_tool(struct path_parse *p)
{
    p->tool = p->next_tool;
    p->next_tool = (struct path_tool){0};
    p->tool_used = p->guessed = false;
    path_add_tool(p->path, p->tool);
    p->path->item.item[p->path->item.n - 1].line = p->apt.line;
}

/* A number for a tool that has none: one above the greatest so far. */
static int free_number(const struct path *path)
{
    int most = path->head.tool;
    for (size_t i = 0; i < path->tool.n; i++)
        most = path->tool.item[i].number > most ? path->tool.item[i].number : most;
    return most + 1;
}

static void change_tool_without_number(struct path_parse *p)
{
    struct path *path = p->path;
    if (!path->head.tool) {
        path->head.tool = 1;
        path->tools_numbered++;
    }
    p->next_tool.number = free_number(path);
    path->tools_numbered++;
    change_tool(p);
    p->guessed = true;
}

/* The number after OSETNO (or ADJUST, of NX) among the arguments, 0: there is none. */
static int offset_number(const struct apt *apt)
{
    for (size_t i = 0; i + 1 < apt->argument.n; i++) {
        double n = apt->argument.item[i + 1].number;
        bool named = apt_is(apt, i, "OSETNO") || apt_is(apt, i, "ADJUST");
        if (named && n >= 1 && n <= 99999999 && n == floor(n))
            return (int)n;
    }
    return 0;
}

static int set_number(struct path_parse *p, double n)
{
    int offset = offset_number(&p->apt);
    if (n < 0 || n > 99999999 || n != floor(n))
        return error_at(AT(p), "found tool number %g, expected a whole number", n);
    int number = (int)n;
    if (!p->tool_used) {
        if (p->guessed) /* the tool's name came before its number */
            p->path->tools_numbered--;
        p->guessed = false;
        p->tool.number = number;
        p->tool.offset = offset > 0 ? offset : p->tool.offset;
        store_tool(p);
    } else if (number != p->tool.number) {
        p->next_tool.number = number;
        p->next_tool.offset = offset;
        change_tool(p);
    } else {
        p->next_tool = (struct path_tool){0};
    }
    return 0;
}

void path_tool_named(struct path_parse *p, const char *name)
{
    if (!p->tool_used && !*p->tool.name) {
        snprintf(p->tool.name, sizeof p->tool.name, "%s", name);
        if (!p->tool.number) { /* a number may still come: LOAD/TOOL */
            p->tool.number = free_number(p->path);
            p->path->tools_numbered++;
            p->guessed = true;
        }
        store_tool(p);
    }
    bool other = p->tool_used && strncmp(p->tool_name, name, sizeof p->tool_name - 1) != 0;
    size_t n = strlen(name) < sizeof p->tool_name ? strlen(name) : sizeof p->tool_name - 1;
    memcpy(p->tool_name, name, n);
    p->tool_name[n] = '\0';
    if (other) {
        snprintf(p->next_tool.name, sizeof p->next_tool.name, "%s", name);
        change_tool_without_number(p);
    }
}

void path_tool_move(struct path_parse *p)
{
    if (p->tool_used && p->next_tool.cutter_n && !same_shape(&p->tool, &p->next_tool))
        change_tool_without_number(p);
    p->next_tool = (struct path_tool){0};
    if (p->rapid && !p->tool.number && !p->path->tool.n)
        return; /* a rapid to where the first tool is loaded */
    p->tool_used = true;
    p->guessed = false;
}

/* CUTTER/d, r, e, f, alpha, beta, h, or fewer; the angles alpha and beta keep their unit. */
int path_read_cutter(struct path_parse *p)
{
    size_t n = p->apt.argument.n < 7 ? p->apt.argument.n : 7;
    double v[7];
    if (path_numbers(p, 0, n, v, "diameter, corner radius, e, f, alpha, beta, height") < 0)
        return -1;
    for (size_t i = 0; i < n; i++)
        v[i] *= i == 4 || i == 5 ? 1 : p->unit;
    path_tool_shape(p, v, (int)n);
    return 0;
}

/* A speed among the arguments of LOADTL (CATIA): SPINDL,1500,CLW or RPM,1500. */
static int speed_in_load(struct path_parse *p)
{
    for (size_t i = 1; i + 1 < p->apt.argument.n; i++) {
        const struct apt_argument *a = &p->apt.argument.item[i + 1];
        bool named = apt_is(&p->apt, i, "SPINDL") || apt_is(&p->apt, i, "RPM") ||
                     apt_is(&p->apt, i, "SPEED");
        if (named && a->is_number)
            return path_set_speed(p, a->number, has_argument(&p->apt, "CCLW"));
    }
    return 0;
}

/* LOADTL/number or LOADTL/name, which gets a number. */
int path_read_tool(struct path_parse *p)
{
    double n;
    if (!p->apt.argument.n)
        return error_at(AT(p), "found %.20s without a tool, expected its number", p->apt.word);
    if (p->apt.argument.item[0].is_number) {
        if (path_numbers(p, 0, 1, &n, "tool number") < 0 || set_number(p, n) < 0)
            return -1;
        return speed_in_load(p);
    }
    if (!*p->apt.argument.item[0].text)
        return error_at(AT(p), "found %.20s without a tool, expected its number", p->apt.word);
    path_tool_named(p, p->apt.argument.item[0].text);
    return speed_in_load(p);
}

int path_read_load(struct path_parse *p)
{
    double n;
    if (!apt_is(&p->apt, 0, "TOOL") || p->apt.argument.n < 2 ||
        !p->apt.argument.item[1].is_number) {
        path_count_unknown(p, "LOAD");
        return path_keep_text(p);
    }
    return path_numbers(p, 1, 1, &n, "tool number") < 0 ? -1 : set_number(p, n);
}

/* ---- spindle and feeds */

/* The first number among the arguments; NAN: there is none. */
static double first_number(const struct apt *apt)
{
    for (size_t i = 0; i < apt->argument.n; i++)
        if (apt->argument.item[i].is_number)
            return apt->argument.item[i].number;
    return NAN;
}

/* Rev/min from a surface speed, in metres or feet a minute; 0: no diameter is known. */
static double surface_speed(const struct path_parse *p, double speed)
{
    double d = p->tool.cutter_n ? p->tool.cutter[0] : 0;
    return d > 0 ? speed * (has_argument(&p->apt, "SFM") ? 304.8 : 1000) / (PI * d) : 0;
}

/* Words of SPINDL beside which its number is the speed in rev/min. */
static bool is_plain(const char *word)
{
    static const char *const plain[] = {"RPM", "CLW", "CCLW", ""};
    for (size_t i = 0; i < sizeof plain / sizeof *plain; i++)
        if (strcmp(word, plain[i]) == 0)
            return true;
    return false;
}

/* The speed: the first number that is not a gear, a limit or an angle. */
static double spindle_speed(const struct apt *apt)
{
    static const char *const others[] = {"RANGE", "GEAR", "MAXRPM", "MAX", "RADIUS", "ORIENT"};
    bool other = false; /* the word before says what the number is */
    for (size_t i = 0; i < apt->argument.n; i++) {
        if (apt->argument.item[i].is_number && !other)
            return apt->argument.item[i].number;
        other = false;
        for (size_t k = 0; k < sizeof others / sizeof *others; k++)
            other = other || apt_is(apt, i, others[k]);
    }
    return NAN;
}

static void add_spindle(struct path_parse *p)
{
    char text[NUM_MAX + 20] = "SPINDL/RPM,";
    char *end = text + strlen(text);
    end += num_write(end, p->spindle, 6);
    memcpy(end, p->ccw ? ",CCLW" : ",CLW", p->ccw ? 6 : 5);
    path_add_text(p->path, text);
}

/* SPINDL without a speed: OFF; ON or a direction, at the speed before; ORIENT, which is ignored. */
static int turn_spindle(struct path_parse *p)
{
    static const char *const known[] = {"OFF",  "ON",     "CLW",  "CCLW", "RPM",    "RANGE",  "LOW",
                                        "HIGH", "MEDIUM", "AUTO", "LOCK", "UNLOCK", "NEUTRL", ""};
    if (has_argument(&p->apt, "ORIENT")) {
        path_count_unknown(p, "SPINDL/ORIENT");
        return 0;
    }
    for (size_t i = 0; i < p->apt.argument.n; i++) {
        const struct apt_argument *a = &p->apt.argument.item[i];
        bool found = a->is_number;
        for (size_t k = 0; k < sizeof known / sizeof *known; k++)
            found = found || strcmp(a->text, known[k]) == 0;
        if (!found)
            return error_at(
                AT(p), "found `%.40s` in SPINDL, expected a speed, ON, OFF, CLW or CCLW", a->text);
    }
    if (has_argument(&p->apt, "OFF") || !(p->spindle > 0))
        return path_keep_text(p);
    add_spindle(p);
    return 0;
}

/* A feed per revolution goes with the speed. */
static void follow_speed(struct path_parse *p)
{
    if (!(p->by_turn > 0) || p->feed == p->by_turn * p->spindle)
        return;
    p->feed = p->by_turn * p->spindle;
    path_add_feed(p->path, p->feed);
}

static int path_set_speed(struct path_parse *p, double rpm, bool ccw)
{
    struct path_head *head = &p->path->head;
    if (!(rpm >= 1 && rpm <= 1e6))
        return error_at(AT(p), "found a speed of %g rev/min in %.20s, expected 1 to 1e6", rpm,
                        p->apt.word);
    p->spindle = rpm;
    p->ccw = ccw;
    if (head->spindle > 0) {
        add_spindle(p);
    } else {
        head->spindle = rpm;
        head->spindle_ccw = ccw;
    }
    follow_speed(p);
    return 0;
}

/* SPINDL/RPM,8000,CLW or SPINDL/8000,RPM,CLW: the first goes into the head, later ones are items.
 */
int path_read_spindle(struct path_parse *p)
{
    double rpm = spindle_speed(&p->apt);
    bool surface = has_argument(&p->apt, "SFM") || has_argument(&p->apt, "SMM"), plain = true;
    if (rpm < 0)
        return error_at(AT(p), "found a speed of %g in SPINDL, expected one above 0", rpm);
    if (has_argument(&p->apt, "CCLW") || has_argument(&p->apt, "CLW"))
        p->ccw = has_argument(&p->apt, "CCLW");
    else if (rpm > 0)
        p->ccw = false;
    if (!(rpm > 0))
        return turn_spindle(p);
    if (surface)
        rpm = surface_speed(p, rpm);
    if (!(rpm > 0))
        return error_at(AT(p), "found a surface speed in SPINDL, expected a CUTTER before it");
    for (size_t i = 0; i < p->apt.argument.n; i++)
        plain =
            plain && (p->apt.argument.item[i].is_number || is_plain(p->apt.argument.item[i].text));
    if (!(p->path->head.spindle > 0 && plain))
        return path_set_speed(p, rpm, p->ccw);
    if (!(rpm >= 1 && rpm <= 1e6))
        return error_at(AT(p), "found a speed of %g rev/min in SPINDL, expected 1 to 1e6", rpm);
    p->spindle = rpm;
    path_keep_text(p);
    follow_speed(p);
    return 0;
}

/* A word that says the unit of a feed. */
struct feed_unit {
    const char *word;
    double mm;    /* 0: the unit of the stream */
    bool by_turn; /* per revolution, not per minute */
};

static const struct feed_unit *feed_unit(const char *word)
{
    static const struct feed_unit units[] = {
        {"MMPM", 1, false},  {"IPM", 25.4, false}, {"PERMIN", 0, false},  {"MMPR", 1, true},
        {"IPR", 25.4, true}, {"PERREV", 0, true},  {"FPM", 304.8, false}, {"FPR", 304.8, true}};
    for (size_t i = 0; i < sizeof units / sizeof *units; i++)
        if (strcmp(word, units[i].word) == 0)
            return &units[i];
    return NULL;
}

double path_feed_unit(const struct path_parse *p, const char *word)
{
    const struct feed_unit *unit = feed_unit(word);
    if (!unit)
        return 0;
    double mm = unit->mm > 0 ? unit->mm : p->unit;
    return !unit->by_turn ? mm : p->spindle > 0 ? mm * p->spindle : (double)NAN;
}

int path_unit_agrees(struct path_parse *p)
{
    bool inches = p->unit > 10;
    if (p->unit_asked || !p->unit_said || !p->feed_line || inches == p->feed_inch)
        return 0;
    if (inches) { /* lengths are as UNITS says, the feed as its word says */
        if (!p->path->feeds_mm)
            p->path->feeds_mm = p->feed_line;
        return 0;
    }
    return error_at(AT(p),
                    "found UNITS/%s in line %u and a feed in inches in line %u, expected one unit "
                    "(ncpost -u mm if both are meant)",
                    p->unit > 1 ? "CM" : "MM", p->unit_line, p->feed_line);
}

int path_feed_agrees(struct path_parse *p, const char *word)
{
    const struct feed_unit *unit = feed_unit(word);
    if (!unit || !(unit->mm > 0))
        return 0;
    p->feed_inch = unit->mm > 1;
    p->feed_line = p->apt.line;
    return path_unit_agrees(p);
}

/* mm per unit of a feed per revolution; 0: the word is none. */
static double unit_by_turn(const struct path_parse *p, const char *word)
{
    const struct feed_unit *unit = feed_unit(word);
    return !unit || !unit->by_turn ? 0 : unit->mm > 0 ? unit->mm : p->unit;
}

int path_expect_speed(struct path_parse *p)
{
    if (!(p->by_turn > 0) || p->spindle > 0)
        return 0;
    return error_at(AT(p), "found a motion at a feed per revolution, expected SPINDL with a speed "
                           "before it");
}

static int expect_feed(struct path_parse *p, double feed)
{
    if (!(feed > 0) || !isfinite(feed))
        return error_at(AT(p), "found a feed of %g in %s, expected one above 0", feed, p->apt.word);
    return 0;
}

/* FEDRAT/MMPM,800 or /800,MMPM; IPM likewise.  Feeds per revolution become feeds per minute. */
int path_read_feed(struct path_parse *p)
{
    double value = first_number(&p->apt), unit = p->unit;
    double by_turn = 0;
    bool inverse = false, word = false;
    for (size_t i = 0; i < p->apt.argument.n; i++) {
        const struct apt_argument *a = &p->apt.argument.item[i];
        double of_word = a->is_number ? 0 : path_feed_unit(p, a->text);
        if (strncmp(a->text, "INVERS", 6) == 0)
            inverse = true;
        else if (inverse && (apt_is(&p->apt, i, "AUTO") || apt_is(&p->apt, i, "OFF")))
            word = true;
        else if (of_word != 0) {
            if (path_feed_agrees(p, a->text) < 0)
                return -1;
            unit = of_word;
            by_turn = unit_by_turn(p, a->text);
        } else if (!a->is_number && *a->text)
            return error_at(AT(p),
                            "found `%.40s` in FEDRAT, expected a number and MMPM, IPM, MMPR, IPR, "
                            "PERMIN, PERREV or INVERS",
                            a->text);
    }
    if (word) { /* INVERS,AUTO or OFF chooses how the program writes feeds; the feed itself stays */
        p->inverse = 0;
        return 0;
    }
    if (isnan(value))
        return error_at(AT(p), "found no number in FEDRAT, expected a feed");
    if (expect_feed(p, inverse ? value : fabs(value * (isnan(unit) ? 1 : unit)) * (value > 0)) < 0)
        return -1;
    p->inverse = inverse ? value : 0;
    p->by_turn = by_turn && !inverse ? value * by_turn : 0;
    if (inverse || isnan(unit)) /* with the speed, that is to come (CATIA) */
        return 0;
    p->feed = value * unit;
    path_add_feed(p->path, p->feed);
    return 0;
}

void path_feed_inverse(struct path_parse *p, double length)
{
    if (p->inverse > 0 && length > 0 && p->feed != p->inverse * length) {
        p->feed = p->inverse * length;
        path_add_feed(p->path, p->feed);
    }
}

/* DELAY/seconds or DELAY/REV,turns, which becomes seconds. */
int path_read_delay(struct path_parse *p)
{
    double n = first_number(&p->apt);
    if (!(n >= 0))
        return error_at(AT(p), "found `%.40s`, expected DELAY/ and seconds", p->apt.raw);
    if (!has_argument(&p->apt, "REV") || !(n > 0))
        return path_keep_text(p);
    if (!(p->spindle > 0))
        return error_at(AT(p), "found DELAY by turns, expected SPINDL with a speed before it");
    char text[NUM_MAX + 8] = "DELAY/";
    num_write(text + strlen(text), 60 * n / p->spindle, 6);
    path_add_text(p->path, text);
    return 0;
}
