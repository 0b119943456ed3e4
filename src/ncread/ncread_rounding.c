/* ncread_rounding - see ncread_rounding.h. */
#include "ncread_rounding.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "ncread_state.h"

enum { ROOM = 200 };

/* The head's number is rounded, and so is that of the block: mm. */
static const double ROUNDED = 0.00011, EVEN = 0.02;

/* The block in capitals, without blanks and comments. */
static void plain_text(const char *line, bool brackets, char text[ROOM])
{
    size_t n = 0;
    bool comment = false;

    for (const char *s = line; *s && *s != ';' && n + 1 < ROOM; s++) {
        comment = comment || (brackets && *s == '(');
        if (!comment && *s > ' ')
            text[n++] = *s >= 'a' && *s <= 'z' ? (char)(*s - 'a' + 'A') : *s;
        comment = comment && *s != ')';
    }
    text[n] = '\0';
}

/* Behind a word of the block, which no digit or point follows; NULL: it has none. */
static const char *behind(const char *text, const char *word)
{
    const char *at = strstr(text, word);

    if (!at)
        return NULL;
    at += strlen(word);
    return strchr("0123456789.", *at) && *at ? NULL : at;
}

/* The number behind a letter; none: `other`. */
static double number_of(const char *text, char letter, double other)
{
    const char *at = strchr(text, letter);

    return at ? strtod(at + 1, NULL) : other;
}

/* G64 without P is as far as it likes on LinuxCNC alone: on Fanuc it ends another mode. */
static double of_gcode(const char *text, bool linuxcnc)
{
    const char *at = behind(text, "G187");

    if (at)
        return number_of(at, 'E', 0);
    at = behind(text, "G64");
    if (!linuxcnc)
        return at && *at == 'P' ? strtod(at + 1, NULL) : 0;
    return at ? number_of(at, 'P', HUGE_VAL) : 0;
}

/* The largest number behind one of n words. */
static double most_behind(const char *text, const char *const *word, size_t n)
{
    double most = 0;

    for (size_t i = 0; i < n; i++) {
        const char *at = strstr(text, word[i]);
        most = fmax(most, at ? strtod(at + strlen(word[i]), NULL) : 0);
    }
    return most;
}

static double of_siemens(const char *text)
{
    static const char *const word[] = {"CYCLE832(", "ADIS=", "ADISPOS=", "CTOL="};

    return most_behind(text, word, sizeof word / sizeof *word);
}

/* CYCLE832's third number. */
static double orientation_of(const char *text)
{
    const char *at = strstr(text, "CYCLE832(");

    for (int i = 0; at && i < 2; i++)
        at = strpbrk(at + 1, ",)");
    return at && *at == ',' ? strtod(at + 1, NULL) : 0;
}

/* How far the tool's axis may be off: its direction, or a rotary axis. */
static void watch_turn(struct ncread *c, const char *text)
{
    static const char *const siemens[] = {"OTOL=", "ATOL="};
    const double most = 2; /* degrees; paths are followed within one */
    const char *cycle = strstr(text, "CYCLDEF32.2"), *ta = cycle ? strstr(cycle, "TA") : NULL;
    double turn = ta ? strtod(ta + 2, NULL) : 0;
    char remark[100];

    if (c->options->dialect == &ncread_siemens)
        turn = fmax(orientation_of(text), most_behind(text, siemens, 2));
    if (!(turn > most))
        return;
    snprintf(remark, sizeof remark,
             "the axis may turn %.4g degrees off the path's, expected %g at most", turn, most);
    ncread_watch_unasked(c, c->line, c->block, remark, 0);
}

/* Corners by the machine's data alone; of its own programs who made them has been told so. */
static void watch_data(struct ncread *c, const char *text)
{
    static const char *const word[] = {"G642",    "G643",     "G644",   "G645",
                                       "COMPCAD", "COMPCURV", "COMPON", "COMPSURF"};
    bool told = ncread_ours(c) && c->options->head->smoothing > 0;
    char remark[110];

    for (size_t i = 0; i < sizeof word / sizeof *word && !c->rounds_by_data && !told; i++) {
        if (!behind(text, word[i]) || strstr(text, "CTOL="))
            continue;
        snprintf(remark, sizeof remark,
                 "corners may be rounded as the machine's data say (%s), which are not known here",
                 word[i]);
        ncread_watch_unasked(c, c->line, c->block, remark, 0);
        c->rounds_by_data = true;
    }
}

/* The largest of the program, in its unit, is judged in the end. */
static void keep_most(struct ncread *c, double rounds)
{
    struct nc_motion *motion = c->motion;

    if (!(rounds > motion->rounding.most))
        return;
    motion->rounding.most = rounds;
    motion->rounding.line = c->line;
    motion->rounding.block = (int)c->block;
}

static double of_heidenhain(const char *text)
{
    const char *at = strstr(text, "CYCLDEF32.1T");

    return at ? strtod(at + strlen("CYCLDEF32.1T"), NULL) : 0;
}

/* Of a block on that control, in the program's unit. */
static double rounding_of(const char *control, const char *text)
{
    if (strcmp(control, "siemens") == 0)
        return of_siemens(text);
    if (strcmp(control, "heidenhain") == 0)
        return of_heidenhain(text);
    return of_gcode(text, strcmp(control, "linuxcnc") == 0);
}

/* Mach3's G64, with which it smooths as it likes: its maker has been told so. */
static bool takes_no_tolerance(const struct ncread_head *head)
{
    return strcmp(head->control_file, "MACH3") == 0 || strcmp(head->control_file, "mach3") == 0;
}

/* In the head of a program of ncpost stands how far corners may be rounded. */
static void watch_corners(struct ncread *c, double rounds)
{
    const struct ncread_head *head = c->options->head;
    double may = head->smoothing > 0 ? head->smoothing : head->tolerance;
    char text[100];

    if (rounds == 0 || (rounds == HUGE_VAL && head->smoothing > 0 && takes_no_tolerance(head)))
        return;
    rounds *= c->unit > 0 ? c->unit : 1;
    if (!(rounds > may * (1 + EVEN) + ROUNDED))
        return;
    if (rounds < HUGE_VAL)
        snprintf(text, sizeof text,
                 "corners may be rounded by %.4g mm, the head says at most %.4g mm", rounds, may);
    else
        snprintf(text, sizeof text,
                 "corners may be rounded by any length (G64 without P), the head says at most %.4g "
                 "mm",
                 may);
    ncread_watch_remark(c, c->line, c->block, text);
}

void ncread_rounding_watch(struct ncread *c)
{
    const char *control = c->options->dialect->name;
    bool siemens = strcmp(control, "siemens") == 0;
    char text[ROOM];

    plain_text(c->text, !siemens, text);
    double rounds = rounding_of(control, text);
    keep_most(c, rounds);
    watch_turn(c, text);
    if (siemens)
        watch_data(c, text);
    if (ncread_ours(c))
        watch_corners(c, rounds);
}
