/* path_cycle - see path_cycle.h. */
#include "path_cycle.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "num.h"
#include "path_feed.h"

#define AT(p) (p)->error, (p)->path->name, (p)->apt.line

static const double usual_clear = 1; /* mm, where nothing is said */
enum { PECKS_MAX = 10000 };

/* The numbers of a cycle. */
enum part { DEPTH, CLEAR, RETRACT, STEP, NEXT, DWELL, FEED, PITCH, TPI, PARTS };

static const struct {
    const char *word;
    enum part part;
} names[] = {
    {"DEPTH", DEPTH},    {"FEDTO", DEPTH},    {"CLEAR", CLEAR},    {"RAPTO", CLEAR},
    {"RTRCTO", RETRACT}, {"RETRCT", RETRACT}, {"RETURN", RETRACT}, {"STEP", STEP},
    {"INCR", STEP},      {"1STPECK", STEP},   {"SUBPECK", NEXT},   {"DWELL", DWELL},
    {"PITCH", PITCH},    {"LEAD", PITCH},     {"TPI", TPI},
};

static const struct {
    const char *word;
    enum path_cycle_kind kind;
} kinds[] = {
    {"DRILL", CYCLE_DRILL},  {"FACE", CYCLE_DRILL},   {"CSINK", CYCLE_DRILL},
    {"DEEP", CYCLE_DEEP},    {"DEEP2", CYCLE_DEEP},   {"PECK", CYCLE_DEEP},
    {"BRKCHP", CYCLE_BREAK}, {"TAP", CYCLE_TAP},      {"DEEPHL", CYCLE_DEEP},
    {"DEEPDR", CYCLE_DEEP},  {"CHIPBR", CYCLE_BREAK}, {"SPOT", CYCLE_DRILL},
    {"CDRILL", CYCLE_DRILL}, {"SPOTDR", CYCLE_DRILL}, {"DRAG", CYCLE_DRAG},
    {"TAPPING", CYCLE_TAP},  {"BORE", CYCLE_BORE},    {"REAM", CYCLE_BORE},
};

static int kind_of(const char *word)
{
    for (size_t i = 0; i < sizeof kinds / sizeof *kinds; i++)
        if (strcmp(word, kinds[i].word) == 0)
            return (int)kinds[i].kind;
    return -1;
}

static int part_of(const char *word)
{
    for (size_t i = 0; i < sizeof names / sizeof *names; i++)
        if (strcmp(word, names[i].word) == 0)
            return (int)names[i].part;
    return -1;
}

/* A word among the numbers that says nothing to us that would move the tool. */
static bool is_idle(const char *word)
{
    static const char *const idle[] = {"", "AUTO", "MANUAL", "ON", "CW", "CLW"};
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

/* The number of a part that is named at argument i; how many arguments that took. */
static size_t read_part(struct path_parse *p, size_t i, double *value)
{
    const struct apt_argument *a = p->apt.argument.item + i;
    size_t left = p->apt.argument.n - i;
    if (left > 1 && a[1].is_number) {
        *value = a[1].number;
        return 2;
    }
    if (left > 2 && apt_is(&p->apt, i, "DWELL") && apt_is(&p->apt, i + 1, "REV") &&
        a[2].is_number) { /* by turns */
        *value = p->spindle > 0 ? 60 * a[2].number / p->spindle : -1;
        return 3;
    }
    return 1;
}

/* The numbers behind the kind, by their names, else depth, feed and clearance in this order. */
static int read_parts(struct path_parse *p, int *kind, double v[PARTS])
{
    static const enum part order[] = {DEPTH, FEED, CLEAR};
    const size_t orders = sizeof order / sizeof *order;
    double unit = p->unit;
    size_t bare = 0;
    bool named = false;
    for (size_t i = 1; i < p->apt.argument.n; i++) {
        const struct apt_argument *a = &p->apt.argument.item[i];
        int part = part_of(a->text);
        double feed = a->is_number ? 0 : path_feed_unit(p, a->text);
        if (a->is_number) {
            if (named || bare == orders)
                return error_at(AT(p),
                                "found %g in CYCLE without a word before it, expected one "
                                "like DEPTH, CLEAR or MMPM",
                                a->number);
            v[order[bare++]] = a->number;
        } else if (feed != 0) {
            unit = feed;
            if (named || bare < 2)
                i += read_part(p, i, &v[FEED]) - 1;
            if (bare == 1 && !isnan(v[FEED]))
                bare = 2;
        } else if (part >= 0) {
            named = true;
            i += read_part(p, i, &v[part]) - 1;
        } else if (strcmp(a->text, "BACK") == 0 || strcmp(a->text, "MANUAL") == 0) {
            return error_at(AT(p),
                            "found CYCLE/%.20s,%s, expected a cycle from above that ends "
                            "by itself",
                            p->apt.argument.item[0].text, a->text);
        } else if (kind_of(a->text) >= 0) {
            *kind = kind_of(a->text);
        } else if (!is_idle(a->text)) {
            double passed_over;
            warn(p, a->text);
            i += read_part(p, i, &passed_over) - 1;
        }
    }
    v[FEED] *= unit;
    return 0;
}

static double or_else(double value, double usual)
{
    return isnan(value) ? usual : value;
}

static int expect_sound(struct path_parse *p, const struct path_cycle *c)
{
    if (!(c->depth > 0 && c->depth < 1e8))
        return error_at(AT(p), "found CYCLE/%.20s without its depth, expected DEPTH or FEDTO",
                        p->apt.argument.item[0].text);
    if (!(c->clear >= 0 && c->pitch >= 0 && c->retract < 1e8 && c->step >= 0 && c->next >= 0 &&
          c->dwell >= 0))
        return error_at(AT(p), "found a number below 0 in CYCLE, expected CLEAR, STEP and DWELL "
                               "of 0 or more");
    if (!(c->feed >= 0 && c->feed < 1e9))
        return error_at(AT(p),
                        "found a feed of %g in CYCLE, expected one above 0 (by the turn "
                        "with SPINDL before it)",
                        c->feed);
    double least = c->step > 0 && c->next > 0 ? fmin(c->step, c->next) : c->step;
    if (least > 0 && c->depth / least > PECKS_MAX)
        return error_at(AT(p), "found steps of %g mm in CYCLE, expected no more than %d of them",
                        least, PECKS_MAX);
    return 0;
}

static int begin(struct path_parse *p, int kind)
{
    double v[PARTS], u = p->unit;
    for (int i = 0; i < PARTS; i++)
        v[i] = NAN;
    if (read_parts(p, &kind, v) < 0)
        return -1;
    struct path_cycle c = {.kind = (enum path_cycle_kind)kind,
                           .depth = fabs(u * or_else(v[DEPTH], 0)),
                           .clear = or_else(u * v[CLEAR], usual_clear),
                           .step = or_else(u * v[STEP], 0),
                           .dwell = or_else(v[DWELL], 0)};
    c.retract = fmax(c.clear, or_else(u * v[RETRACT], c.clear));
    c.next = or_else(u * v[NEXT], c.step);
    if (kind == CYCLE_TAP)
        c.pitch = !isnan(v[PITCH]) ? u * v[PITCH] : v[TPI] > 0 ? 25.4 / v[TPI] : 0;
    if (c.pitch > 0 && p->spindle > 0)
        c.feed = c.pitch * p->spindle;
    else if (!isnan(v[FEED]))
        c.feed = v[FEED];
    if (expect_sound(p, &c) < 0)
        return -1;
    *array_push(&p->path->cycle) = c;
    p->cycling = true;
    return 0;
}

int path_read_cycle(struct path_parse *p)
{
    const char *word = p->apt.argument.n ? p->apt.argument.item[0].text : "";
    int kind = kind_of(word);
    if (kind >= 0)
        return begin(p, kind);
    if (strcmp(word, "OFF") == 0 || strcmp(word, "NOMORE") == 0 || strcmp(word, "INIT") == 0) {
        p->cycling = false;
        return 0;
    }
    if (strcmp(word, "ON") == 0 && p->path->cycle.n) {
        p->cycling = true;
        return 0;
    }
    return error_at(AT(p),
                    "found CYCLE/%.40s, expected DRILL, FACE, CSINK, DEEP, PECK, BRKCHP, TAP, "
                    "BORE, REAM or OFF: passing over it would send the tool elsewhere",
                    word);
}

int path_hole(struct path_parse *p, struct pose mouth)
{
    size_t cycle = p->path->cycle.n - 1;
    path_add_hole(p->path, mouth, cycle);
    p->path->item.item[p->path->item.n - 1].line = p->apt.line;
    p->at.p = vec_along(mouth.p, p->path->cycle.item[cycle].retract, mouth.a);
    p->at.a = mouth.a;
    return 0;
}

static char *put(char *end, const char *word, double value)
{
    size_t n = strlen(word);
    memcpy(end, word, n);
    return end + n + num_write(end + n, value, 6);
}

void path_cycle_text(const struct path_cycle *c, char *text)
{
    static const char *const word[] = {"DRILL", "DEEP", "BRKCHP", "TAP", "BORE", "BORE,DRAG"};
    char *end = text + sprintf(text, "CYCLE/%s", word[c->kind]);
    end = put(end, ",DEPTH,", c->depth);
    if (c->step > 0)
        end = put(end, ",STEP,", c->step);
    if (c->next != c->step)
        end = put(end, ",SUBPECK,", c->next);
    if (c->feed > 0)
        end = put(end, ",MMPM,", c->feed);
    end = put(end, ",CLEAR,", c->clear);
    if (c->retract > c->clear)
        end = put(end, ",RTRCTO,", c->retract);
    if (c->pitch > 0)
        end = put(end, ",PITCH,", c->pitch);
    if (c->dwell > 0)
        put(end, ",DWELL,", c->dwell);
}
