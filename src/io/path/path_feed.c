/* path_feed - see path_feed.h. */
#include "path_feed.h"

#include <math.h>
#include <string.h>

#include "base/num.h"

#define AT(p) (p)->error, (p)->path->name, (p)->apt.line

/* The first number among the arguments; NAN: there is none. */
static double first_number(const struct apt *apt)
{
    for (size_t i = 0; i < apt->argument.n; i++)
        if (apt->argument.item[i].is_number)
            return apt->argument.item[i].number;
    return NAN;
}

static bool holds(const struct apt *apt, const char *word)
{
    for (size_t i = 0; i < apt->argument.n; i++)
        if (apt_is(apt, i, word))
            return true;
    return false;
}

/* Turns a minute of a speed that was given at the cutting edge: mm or feet a minute. */
static double surface_speed(const struct path_parse *p, double speed)
{
    double d = p->tool.cutter_n ? p->tool.cutter[0] : 0;
    return d > 0 ? speed * (holds(&p->apt, "SFM") ? 304.8 : 1000) / (PI * d) : 0;
}

/* Words of SPINDL that leave its speed and its turn as the numbers say. */
static bool is_plain(const char *word)
{
    static const char *const plain[] = {"RPM", "CLW", "CCLW", ""};
    for (size_t i = 0; i < sizeof plain / sizeof *plain; i++)
        if (strcmp(word, plain[i]) == 0)
            return true;
    return false;
}

/* The speed: the first number that is not a gear's, a limit's or an angle's. */
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

static void carry_spindle(struct path_parse *p)
{
    char text[NUM_MAX + 20] = "SPINDL/RPM,";
    char *end = text + strlen(text);
    end += num_write(end, p->spindle, 6);
    memcpy(end, p->ccw ? ",CCLW" : ",CLW", p->ccw ? 6 : 5);
    path_add_text(p->path, text);
}

/* SPINDL without a speed: OFF; ON or a turn, as fast as before; ORIENT, which is passed over. */
static int turn_spindle(struct path_parse *p)
{
    if (holds(&p->apt, "ORIENT"))
        path_count_unknown(p, "SPINDL/ORIENT");
    else if (holds(&p->apt, "OFF") || !(p->spindle > 0))
        return path_keep_text(p);
    else
        carry_spindle(p);
    return 0;
}

/* SPINDL/RPM,8000,CLW or SPINDL/8000,RPM,CLW: the first is the head's, later ones are carried. */
int path_read_spindle(struct path_parse *p)
{
    struct path_head *head = &p->path->head;
    double rpm = spindle_speed(&p->apt);
    bool surface = holds(&p->apt, "SFM") || holds(&p->apt, "SMM"), plain = true;
    if (holds(&p->apt, "CCLW") || holds(&p->apt, "CLW"))
        p->ccw = holds(&p->apt, "CCLW");
    else if (rpm > 0)
        p->ccw = false;
    if (!(rpm > 0))
        return turn_spindle(p);
    if (surface)
        rpm = surface_speed(p, rpm);
    if (!(rpm > 0))
        return error_at(AT(p),
                        "found a SPINDL speed at the cutting edge, expected a CUTTER before it");
    p->spindle = rpm;
    for (size_t i = 0; i < p->apt.argument.n; i++)
        plain =
            plain && (p->apt.argument.item[i].is_number || is_plain(p->apt.argument.item[i].text));
    if (head->spindle > 0 && plain)
        return path_keep_text(p);
    if (head->spindle > 0) {
        carry_spindle(p);
        return 0;
    }
    head->spindle = rpm;
    head->spindle_ccw = p->ccw;
    return 0;
}

double path_feed_unit(const struct path_parse *p, const char *word)
{
    static const struct {
        const char *word;
        double mm;   /* 0: the unit of the stream */
        bool a_turn; /* not a minute */
    } units[] = {{"MMPM", 1, false},    {"IPM", 25.4, false}, {"PERMIN", 0, false},
                 {"MMPR", 1, true},     {"IPR", 25.4, true},  {"PERREV", 0, true},
                 {"FPM", 304.8, false}, {"FPR", 304.8, true}};
    for (size_t i = 0; i < sizeof units / sizeof *units; i++)
        if (strcmp(word, units[i].word) == 0) {
            double mm = units[i].mm > 0 ? units[i].mm : p->unit;
            return !units[i].a_turn ? mm : p->spindle > 0 ? mm * p->spindle : (double)NAN;
        }
    return 0;
}

static int expect_feed(struct path_parse *p, double feed)
{
    if (isnan(feed))
        return error_at(AT(p), "found a feed by the turn, expected SPINDL with a speed before it");
    if (!(feed > 0) || !isfinite(feed))
        return error_at(AT(p), "found a feed of %g in %s, expected one above 0", feed, p->apt.word);
    return 0;
}

/* FEDRAT/MMPM,800 or /800,MMPM; IPM likewise.  Feeds by the turn become feeds by the minute. */
int path_read_feed(struct path_parse *p)
{
    double value = first_number(&p->apt), unit = p->unit;
    bool inverse = false, word = false;
    for (size_t i = 0; i < p->apt.argument.n; i++) {
        const struct apt_argument *a = &p->apt.argument.item[i];
        double of_word = a->is_number ? 0 : path_feed_unit(p, a->text);
        if (strncmp(a->text, "INVERS", 6) == 0)
            inverse = true;
        else if (inverse && (apt_is(&p->apt, i, "AUTO") || apt_is(&p->apt, i, "OFF")))
            word = true;
        else if (of_word != 0)
            unit = of_word;
        else if (!a->is_number && *a->text)
            return error_at(AT(p),
                            "found `%.40s` in FEDRAT, expected a number and MMPM, IPM, MMPR, IPR, "
                            "PERMIN, PERREV or INVERS",
                            a->text);
    }
    if (word) { /* how the machine is to be told: the feed of the path stays as it is */
        p->inverse = 0;
        return 0;
    }
    if (isnan(value))
        return error_at(AT(p), "found no number in FEDRAT, expected a feed");
    if (expect_feed(p, inverse ? value : value * unit) < 0)
        return -1;
    p->inverse = inverse ? value : 0;
    if (inverse)
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
    if (!holds(&p->apt, "REV") || !(n > 0))
        return path_keep_text(p);
    if (!(p->spindle > 0))
        return error_at(AT(p), "found DELAY by turns, expected SPINDL with a speed before it");
    char text[NUM_MAX + 8] = "DELAY/";
    num_write(text + strlen(text), 60 * n / p->spindle, 6);
    path_add_text(p->path, text);
    return 0;
}
