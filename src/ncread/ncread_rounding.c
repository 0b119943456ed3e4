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

/* G64 is a tolerance on LinuxCNC alone: on Fanuc it ends another mode. */
static double of_gcode(const char *text, bool linuxcnc)
{
    const char *at = behind(text, "G187");

    if (at)
        return number_of(at, 'E', 0);
    at = linuxcnc ? behind(text, "G64") : NULL;
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

/* How far the tool's axis may be off, degrees: on Siemens, of its direction or a rotary axis. */
static double turn_of(const struct ncread *c)
{
    static const char *const word[] = {"OTOL=", "ATOL="};
    char text[ROOM];

    if (strcmp(c->options->dialect->name, "siemens") != 0)
        return 0;
    plain_text(c->text, false, text);
    return most_behind(text, word, sizeof word / sizeof *word);
}

static void watch_turn(struct ncread *c)
{
    const double most = 2; /* degrees; paths are followed within one */
    double turn = turn_of(c);
    char text[100];

    if (!(turn > most))
        return;
    snprintf(text, sizeof text,
             "the axis may turn %.4g degrees off the path's, expected %g at most", turn, most);
    ncread_watch_remark(c, c->line, c->block, text);
}

static double of_heidenhain(const char *text)
{
    const char *at = strstr(text, "CYCLDEF32.1T");

    return at ? strtod(at + strlen("CYCLDEF32.1T"), NULL) : 0;
}

/* In the program's unit. */
static double rounding_of(const struct ncread *c)
{
    char text[ROOM];
    const char *name = c->options->dialect->name;

    plain_text(c->text, strcmp(name, "siemens") != 0, text);
    if (strcmp(name, "siemens") == 0)
        return of_siemens(text);
    if (strcmp(name, "heidenhain") == 0)
        return of_heidenhain(text);
    return of_gcode(text, strcmp(name, "linuxcnc") == 0);
}

/* Mach3's G64, with which it smooths as it likes: its maker has been told so. */
static bool takes_no_tolerance(const struct ncread_head *head)
{
    return strcmp(head->control_file, "MACH3") == 0 || strcmp(head->control_file, "mach3") == 0;
}

void ncread_rounding_watch(struct ncread *c)
{
    const struct ncread_head *head = c->options->head;
    char text[100];

    if (!head || !head->numbered)
        return;
    watch_turn(c);
    double may = head->smoothing > 0 ? head->smoothing : head->tolerance, rounds = rounding_of(c);
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
