/* cycle_words - see cycle_words.h. */
#include "cycle_words.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "path_feed.h"

#define AT(p) (p)->error, (p)->path->name, (p)->apt.line

static const struct {
    const char *word;
    enum cycle_number number;
} names[] = {
    {"DEPTH", CYCLE_DEPTH},    {"FEDTO", CYCLE_DEPTH},    {"CLEAR", CYCLE_CLEAR},
    {"RAPTO", CYCLE_RAPID},    {"RTRCTO", CYCLE_RETRACT}, {"RETRCT", CYCLE_RETRACT},
    {"RETURN", CYCLE_RETRACT}, {"STEP", CYCLE_STEP},      {"INCR", CYCLE_STEP},
    {"1STPECK", CYCLE_STEP},   {"SUBPECK", CYCLE_NEXT},   {"DWELL", CYCLE_DWELL},
    {"PITCH", CYCLE_PITCH},    {"LEAD", CYCLE_PITCH},     {"TPI", CYCLE_TPI},
};

static const struct {
    const char *word;
    enum path_cycle_kind kind;
} kinds[] = {
    {"DRILL", CYCLE_DRILL},   {"FACE", CYCLE_DRILL},   {"CSINK", CYCLE_DRILL},
    {"DEEP", CYCLE_DEEP},     {"DEEP2", CYCLE_DEEP},   {"PECK", CYCLE_DEEP},
    {"BRKCHP", CYCLE_BREAK},  {"TAP", CYCLE_TAP},      {"DEEPHL", CYCLE_DEEP},
    {"DEEPDR", CYCLE_DEEP},   {"CHIPBR", CYCLE_BREAK}, {"SPOT", CYCLE_DRILL},
    {"CDRILL", CYCLE_DRILL},  {"SPOTDR", CYCLE_DRILL}, {"DRAG", CYCLE_DRAG},
    {"TAPPING", CYCLE_TAP},   {"BORE", CYCLE_BORE},    {"REAM", CYCLE_BORE},
    {"MANUAL", CYCLE_MANUAL},
};

int cycle_kind(const char *word)
{
    for (size_t i = 0; i < sizeof kinds / sizeof *kinds; i++)
        if (strcmp(word, kinds[i].word) == 0)
            return (int)kinds[i].kind;
    return -1;
}

static int number_of(const char *word)
{
    for (size_t i = 0; i < sizeof names / sizeof *names; i++)
        if (strcmp(word, names[i].word) == 0)
            return (int)names[i].number;
    return -1;
}

/* A word that says nothing that would move the tool otherwise. */
static bool is_idle(const char *word)
{
    static const char *const idle[] = {"", "AUTO", "ON", "CW", "CLW", "RIGID"};
    for (size_t i = 0; i < sizeof idle / sizeof *idle; i++)
        if (strcmp(word, idle[i]) == 0)
            return true;
    return false;
}

static void warn(struct path_parse *p, const char *word)
{
    char text[64];
    snprintf(text, sizeof text, "CYCLE/%.40s", word);
    path_count_unknown(p, text);
}

/* The number behind argument i, the next one to look at behind it; NAN: there is none. */
static double next_number(const struct path_parse *p, size_t *i)
{
    if (*i + 1 < p->apt.argument.n && p->apt.argument.item[*i + 1].is_number)
        return p->apt.argument.item[++*i].number;
    return NAN;
}

/* Seconds of n turns; -1: the spindle stands. */
static double seconds(const struct path_parse *p, double turns)
{
    return p->spindle > 0 ? 60 * turns / p->spindle : -1;
}

static void take_named(struct path_parse *p, struct cycle_words *w, enum cycle_number number,
                       size_t *i)
{
    size_t at = *i;
    double value = next_number(p, i);
    if (number == CYCLE_DWELL && isnan(value) && apt_is(&p->apt, *i + 1, "REV")) {
        ++*i;
        value = seconds(p, next_number(p, i));
    }
    if (number == CYCLE_RETRACT && isnan(value) && apt_is(&p->apt, *i + 1, "AUTO"))
        w->home = true;
    if (!isnan(value))
        w->value[number] = value;
    if (!apt_is(&p->apt, at, "STEP"))
        return;
    for (double next; !isnan(next = next_number(p, i));) /* STEP,5,4,3 of NX */
        w->value[CYCLE_NEXT] = fmin(next, w->value[CYCLE_NEXT]);
}

/* Numbers without a name, by their place among them. */
static const enum cycle_number *order_of(const struct path_parse *p, enum path_cycle_kind kind)
{
    static const enum cycle_number usual[] = {CYCLE_DEPTH, CYCLE_FEED, CYCLE_CLEAR, CYCLE_STEP},
                                   tap[] = {CYCLE_DEPTH, CYCLE_FEED, CYCLE_TPI, CYCLE_CLEAR};
    size_t n = 0;
    for (size_t i = 1; i < p->apt.argument.n; i++)
        n += p->apt.argument.item[i].is_number;
    return kind == CYCLE_TAP && n == 4 ? tap : usual;
}

static int expect_from_above(struct path_parse *p, const char *word)
{
    if (strcmp(word, "BACK") != 0)
        return 0;
    return error_at(AT(p),
                    "found CYCLE/%.20s,BACK, expected a hole made from above: have the CAM system "
                    "write out its moves",
                    p->apt.argument.item[0].text);
}

/* A word that is no name of a number. */
static int take_word(struct path_parse *p, struct cycle_words *w, size_t *i)
{
    const char *word = p->apt.argument.item[*i].text;
    double passed_over;
    if (strcmp(word, "REV") == 0) {
        w->value[CYCLE_DWELL] = seconds(p, next_number(p, i));
    } else if (strcmp(word, "DIAMET") == 0) {
        next_number(p, i); /* of a countersink: its depth is said */
    } else if (cycle_kind(word) >= 0) {
        w->kind = (enum path_cycle_kind)cycle_kind(word);
    } else if (!is_idle(word)) {
        passed_over = next_number(p, i);
        if (isnan(passed_over) || w->kind != CYCLE_BREAK)
            if (expect_from_above(p, word) < 0)
                return -1;
        warn(p, word);
    }
    return 0;
}

int cycle_words(struct path_parse *p, struct cycle_words *w)
{
    enum { BARE = 4 };
    double unit = p->unit, word_unit;
    size_t bare = 0;
    bool named = false;
    w->kind = (enum path_cycle_kind)cycle_kind(p->apt.argument.item[0].text);
    w->home = false;
    for (int i = 0; i < CYCLE_NUMBERS; i++)
        w->value[i] = NAN;
    const enum cycle_number *order = order_of(p, w->kind);
    for (size_t i = 1; i < p->apt.argument.n; i++) {
        const struct apt_argument *a = &p->apt.argument.item[i];
        int number = number_of(a->text);
        if (a->is_number) {
            if ((named && bare == 0) || bare == BARE)
                return error_at(AT(p),
                                "found %g in CYCLE without a word before it, expected one "
                                "like DEPTH, CLEAR or MMPM",
                                a->number);
            w->value[order[bare++]] = a->number;
        } else if ((word_unit = path_feed_unit(p, a->text)) != 0) {
            unit = word_unit;
            if (bare < 2)
                take_named(p, w, CYCLE_FEED, &i);
            if (bare == 1 && !isnan(w->value[CYCLE_FEED]))
                bare = 2;
        } else if (number >= 0) {
            named = true;
            take_named(p, w, (enum cycle_number)number, &i);
        } else if (take_word(p, w, &i) < 0) {
            return -1;
        }
    }
    w->value[CYCLE_FEED] *= unit;
    return 0;
}
