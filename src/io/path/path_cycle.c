/*
 * path_cycle - drilling cycles: the words of CYCLE in the order and under the names of each CAM
 * system, the statement as this suite writes it, and the holes as straight motions.  See
 * path_parse.h and path.h.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "math/elementary.h"
#include "base/num.h"
#include "cl_dialect.h"

#define AT(p) (p)->error, (p)->path->name, (p)->apt.line

/*
 * ---- the words and numbers of one CYCLE, as the systems name and order them: Creo (PTC, CL Output
 * for Holemaking Cycles), NX, CATIA, SolidWorks CAM and generic APT
 */
enum cycle_number {
    CYCLE_DEPTH,
    CYCLE_CLEAR,   /* CLEAR */
    CYCLE_RAPID,   /* RAPTO */
    CYCLE_RETRACT, /* RTRCTO, RETURN */
    CYCLE_STEP,
    CYCLE_NEXT,  /* the smallest of the steps after the first */
    CYCLE_DWELL, /* seconds */
    CYCLE_FEED,  /* mm/min */
    CYCLE_PITCH,
    CYCLE_TPI, /* threads per inch */
    CYCLE_NUMBERS
};

/* The contents of one CYCLE; NAN: not given.  Lengths are in the unit of the stream. */
struct cycle_words {
    enum path_cycle_kind kind;
    bool home; /* RTRCTO,AUTO: the tool returns to the height it came from */
    double value[CYCLE_NUMBERS];
};

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

/* The kind of hole that a word means; -1: none. */
static int cycle_kind(const char *word)
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

/* A word that does not change the motion. */
static bool is_idle(const char *word)
{
    static const char *const idle[] = {"", "AUTO", "ON", "CW", "CLW", "RIGID"};
    for (size_t i = 0; i < sizeof idle / sizeof *idle; i++)
        if (strcmp(word, idle[i]) == 0)
            return true;
    return false;
}

static void count_unknown(struct path_parse *p, const char *word)
{
    char text[64];
    snprintf(text, sizeof text, "CYCLE/%.40s", word);
    path_count_unknown(p, text);
}

/* The number after argument i, and *i is its index; NAN: there is none. */
static double next_number(const struct path_parse *p, size_t *i)
{
    if (*i + 1 < p->apt.argument.n && p->apt.argument.item[*i + 1].is_number)
        return p->apt.argument.item[++*i].number;
    return NAN;
}

/* Seconds of n turns; -1: the spindle is off. */
static double seconds_of_turns(const struct path_parse *p, double turns)
{
    return p->spindle > 0 ? 60 * turns / p->spindle : -1;
}

static void read_named(struct path_parse *p, struct cycle_words *w, enum cycle_number number,
                       size_t *i)
{
    size_t at = *i;
    double value = next_number(p, i);
    if (number == CYCLE_DWELL && isnan(value) && apt_is(&p->apt, *i + 1, "REV")) {
        ++*i;
        value = seconds_of_turns(p, next_number(p, i));
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

/* The meanings of the numbers without a name, in their order. */
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

/* A word that is not the name of a number. */
static int read_word(struct path_parse *p, struct cycle_words *w, size_t *i)
{
    const char *word = p->apt.argument.item[*i].text;
    double ignored;
    if (strcmp(word, "REV") == 0) {
        w->value[CYCLE_DWELL] = seconds_of_turns(p, next_number(p, i));
    } else if (strcmp(word, "DIAMET") == 0) {
        next_number(p, i); /* of a countersink: its depth is said */
    } else if (cycle_kind(word) >= 0) {
        w->kind = (enum path_cycle_kind)cycle_kind(word);
    } else if (!is_idle(word)) {
        ignored = next_number(p, i);
        if (isnan(ignored) || w->kind != CYCLE_BREAK)
            if (expect_from_above(p, word) < 0)
                return -1;
        count_unknown(p, word);
    }
    return 0;
}

/*
 * Reads the arguments of the statement, the first of which is a kind.  Numbers without a name are,
 * in this order, depth, feed, threads per inch (of a tap, when there are four), clearance, step;
 * named ones may come between them, as INCR of CATIA.  Other words are counted as unknown.  -1: a
 * number whose meaning is unknown, or a hole that is not made from above.
 */
static int read_cycle_words(struct path_parse *p, struct cycle_words *w)
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
            if (w->kind != CYCLE_TAP && path_feed_agrees(p, a->text) < 0)
                return -1;
            unit = word_unit;
            if (bare < 2)
                read_named(p, w, CYCLE_FEED, &i);
            if (bare == 1 && !isnan(w->value[CYCLE_FEED]))
                bare = 2;
        } else if (number >= 0) {
            named = true;
            read_named(p, w, (enum cycle_number)number, &i);
        } else if (read_word(p, w, &i) < 0) {
            return -1;
        }
    }
    w->value[CYCLE_FEED] *= unit;
    return 0;
}

/* ---- a cycle and its holes */

static const double usual_clear = 1; /* mm, where none is given */
enum { PECKS_MAX = 10000 };

static double or_else(double value, double usual)
{
    return isnan(value) ? usual : value;
}

static int expect_sound(struct path_parse *p, const struct path_cycle *c)
{
    if (!(c->depth > 0 && c->depth < 1e8))
        return error_at(AT(p), "found CYCLE/%.20s without its depth, expected DEPTH or FEDTO",
                        p->apt.argument.item[0].text);
    if (!(c->clear > -c->depth && c->retract < 1e8))
        return error_at(AT(p),
                        "found CYCLE/%.20s begin %g mm above the mouth, expected more than %g",
                        p->apt.argument.item[0].text, c->clear, -c->depth);
    if (!(c->pitch >= 0 && c->step >= 0 && c->next >= 0 && c->dwell >= 0))
        return error_at(AT(p),
                        "found a number below 0 in CYCLE, expected STEP and DWELL of 0 or more "
                        "(by the turn with SPINDL before it)");
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

/*
 * The heights where the feed begins and to which the tool retracts.  RAPTO is a height like CLEAR;
 * Creo's is the distance that the rapid goes on down from CLEAR (PTC, CL Output for Holemaking
 * Cycles).  The feed may begin inside a hole that exists already.
 */
static void set_heights(struct path_parse *p, const struct cycle_words *w, struct path_cycle *c)
{
    double clear = p->unit * w->value[CYCLE_CLEAR], rapid = p->unit * w->value[CYCLE_RAPID];
    bool further = p->dialect == &cl_creo && !isnan(clear) && !isnan(rapid);
    c->clear = further ? clear - rapid : or_else(rapid, or_else(clear, usual_clear));
    double least = c->clear < 0 ? usual_clear : c->clear;
    c->retract = fmax(fmax(c->clear, 0), or_else(p->unit * w->value[CYCLE_RETRACT],
                                                 fmax(least, or_else(clear, least))));
}

/* A pitch gives the feed. */
static void set_feed(struct path_parse *p, const struct cycle_words *w, struct path_cycle *c)
{
    double pitch = p->unit * w->value[CYCLE_PITCH], tpi = w->value[CYCLE_TPI];
    if (c->kind == CYCLE_TAP)
        c->pitch = !isnan(pitch) ? pitch : tpi > 0 ? 25.4 / tpi : 0;
    if (c->pitch > 0 && p->spindle > 0)
        c->feed = c->pitch * p->spindle;
    else if (!isnan(w->value[CYCLE_FEED]))
        c->feed = w->value[CYCLE_FEED];
}

static int begin_cycle(struct path_parse *p)
{
    struct cycle_words w;
    if (read_cycle_words(p, &w) < 0)
        return -1;
    struct path_cycle c = {.kind = w.kind,
                           .depth = fabs(p->unit * or_else(w.value[CYCLE_DEPTH], 0)),
                           .step = or_else(p->unit * w.value[CYCLE_STEP], 0),
                           .dwell = or_else(w.value[CYCLE_DWELL], 0)};
    c.next = or_else(p->unit * w.value[CYCLE_NEXT], c.step);
    set_heights(p, &w, &c);
    set_feed(p, &w, &c);
    if (expect_sound(p, &c) < 0)
        return -1;
    *array_push(&p->path->cycle) = c;
    p->cycling = true;
    p->drilled = false;
    p->to_start = p->moved && (w.home || (p->dialect == &cl_creo && w.value[CYCLE_RETRACT] == 0));
    p->before = p->at;
    p->leave = c.retract;
    return 0;
}

int path_read_cycle(struct path_parse *p)
{
    const char *word = p->apt.argument.n ? p->apt.argument.item[0].text : "";
    if (cycle_kind(word) >= 0)
        return begin_cycle(p);
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
                    "BORE, REAM or OFF: ignoring it would send the tool to the wrong place",
                    word);
}

/* The tool retracts to the height at which it came to CYCLE if that is above this mouth; a new
 * cycle is added where the retract height differs from that of the hole before. */
static void leave_at_start(struct path_parse *p, struct pose mouth)
{
    struct path_cycle *c = &p->path->cycle.item[p->path->cycle.n - 1];
    double height = vec_dot(vec_sub(p->before.p, mouth.p), mouth.a);
    if (height <= c->clear || height <= 0)
        height = p->leave;
    if (fabs(height - c->retract) < 1e-6)
        return;
    struct path_cycle other = *c;
    other.retract = height;
    if (p->drilled)
        *array_push(&p->path->cycle) = other;
    else
        *c = other;
}

int path_add_cycle_hole(struct path_parse *p, struct pose mouth)
{
    if (p->to_start)
        leave_at_start(p, mouth);
    p->drilled = true;
    size_t cycle = p->path->cycle.n - 1;
    path_add_hole(p->path, mouth, cycle);
    p->path->item.item[p->path->item.n - 1].line = p->apt.line;
    p->at.p = vec_along(mouth.p, p->path->cycle.item[cycle].retract, mouth.a);
    p->at.a = mouth.a;
    return 0;
}

static char *append_word(char *end, const char *word, double value)
{
    size_t n = strlen(word);
    memcpy(end, word, n);
    return end + n + num_write(end + n, value, 6);
}

void path_cycle_text(const struct path_cycle *c, char *text)
{
    static const char *const word[] = {"DRILL", "DEEP",      "BRKCHP",     "TAP",
                                       "BORE",  "BORE,DRAG", "BORE,MANUAL"};
    char *end = text + sprintf(text, "CYCLE/%s", word[c->kind]);
    end = append_word(end, ",DEPTH,", c->depth);
    if (c->step > 0)
        end = append_word(end, ",STEP,", c->step);
    if (c->next != c->step)
        end = append_word(end, ",SUBPECK,", c->next);
    if (c->feed > 0)
        end = append_word(end, ",MMPM,", c->feed);
    end = append_word(end, ",CLEAR,", c->clear);
    if (c->retract > c->clear)
        end = append_word(end, ",RTRCTO,", c->retract);
    if (c->pitch > 0)
        end = append_word(end, ",PITCH,", c->pitch);
    if (c->dwell > 0)
        append_word(end, ",DWELL,", c->dwell);
}

/* ---- holes as straight motions */

struct expansion {
    struct path *path;
    const struct path_item *hole;
    struct pose at; /* where the tool is */
    bool known;     /* `at` is known */
    double feed;    /* mm/min in force, 0: none */
    bool own_feed;  /* the cycle's feed is in force instead */
    double spindle; /* rev/min */
    bool ccw;
};

static void go_to(struct expansion *d, struct pose to, bool rapid)
{
    if (d->known && vec_distance(to.p, d->at.p) == 0 && vec_distance(to.a, d->at.a) == 0)
        return;
    path_add_point(d->path, to, rapid)->line = d->hole->line;
    d->at = to;
    d->known = true;
}

/* Moves to a height above the mouth. */
static void go_to_height(struct expansion *d, double height, bool rapid)
{
    go_to(d, (struct pose){vec_along(d->hole->to.p, height, d->hole->to.a), d->hole->to.a}, rapid);
}

/* Drills from `clear` to the bottom in steps. */
static void drill_in_steps(struct expansion *d, const struct path_cycle *c)
{
    double step = c->kind == CYCLE_DEEP || c->kind == CYCLE_BREAK ? c->step : 0, deep = 0;
    while (step > 0 && deep + step < c->depth - 1e-6) {
        double gap = fmin(step / 2, PATH_PECK_GAP);
        deep += step;
        go_to_height(d, -deep, false);
        if (c->kind == CYCLE_DEEP)
            go_to_height(d, c->clear, true);
        go_to_height(d, gap - deep, true);
        step = c->next;
    }
    go_to_height(d, -c->depth, false);
}

static void turn_spindle(struct expansion *d, bool ccw)
{
    char text[NUM_MAX + 20] = "SPINDL/RPM,";
    if (!(d->spindle > 0))
        return;
    char *end = text + strlen(text);
    end += num_write(end, d->spindle, 6);
    memcpy(end, ccw ? ",CCLW" : ",CLW", ccw ? 6 : 5);
    path_add_text(d->path, text);
}

static void add_dwell(struct expansion *d, double seconds)
{
    char text[NUM_MAX + 8] = "DELAY/";
    if (!(seconds > 0))
        return;
    num_write(text + strlen(text), seconds, 6);
    path_add_text(d->path, text);
}

static void drill_hole(struct expansion *d, const struct path_cycle *c)
{
    struct pose mouth = d->hole->to;
    double level = c->retract;
    if (d->known && vec_distance(d->at.a, mouth.a) < 1e-9) {
        double height = vec_dot(vec_sub(d->at.p, mouth.p), mouth.a);
        if (height < level) /* up first, then across */
            go_to(d, (struct pose){vec_along(d->at.p, level - height, mouth.a), mouth.a}, true);
        level = fmax(level, height);
    }
    go_to_height(d, level, true);
    go_to_height(d, c->retract, true);
    go_to_height(d, c->clear, true);
    if (c->feed > 0) {
        path_add_feed(d->path, c->feed);
        d->own_feed = true;
    }
    drill_in_steps(d, c);
    add_dwell(d, c->dwell);
    if (c->kind == CYCLE_TAP)
        turn_spindle(d, !d->ccw);
    else if (c->kind == CYCLE_DRAG || c->kind == CYCLE_MANUAL)
        path_add_text(d->path, "SPINDL/OFF");
    if (c->kind == CYCLE_MANUAL)
        path_add_text(d->path, "STOP");
    if (c->kind == CYCLE_TAP || c->kind == CYCLE_BORE)
        go_to_height(d, c->clear, false);
    if (c->kind == CYCLE_TAP)
        turn_spindle(d, d->ccw);
    go_to_height(d, c->retract, true);
    if (c->kind == CYCLE_DRAG || c->kind == CYCLE_MANUAL)
        turn_spindle(d, d->ccw);
}

/* Remembers the speed of a SPINDL among the texts. */
static void read_spindle_text(struct expansion *d, const char *text)
{
    if (strncmp(text, "SPINDL", 6) != 0)
        return;
    const char *s = text + 6;
    double rpm;
    for (; *s; s++)
        if (*s >= '0' && *s <= '9' && num_read(&s, &rpm)) {
            d->spindle = rpm;
            d->ccw = strstr(text, "CCLW") != NULL;
            return;
        }
}

static void copy_item(struct expansion *d, const struct path_item *item)
{
    if (item->kind == PATH_POINT || item->kind == PATH_ARC || item->kind == PATH_SPLINE) {
        if (d->own_feed && d->feed > 0)
            path_add_feed(d->path, d->feed);
        d->own_feed = false;
        d->at = item->to;
        d->known = true;
    } else if (item->kind == PATH_FEED) {
        d->feed = item->feed;
        d->own_feed = false;
    } else if (item->kind == PATH_TEXT) {
        read_spindle_text(d, d->path->text.item[item->index]);
    }
    *array_push(&d->path->item) = *item;
}

void path_expand_cycles(struct path *path)
{
    size_t n = path->item.n;
    struct path_item *item = path->item.item;
    bool any = false;
    for (size_t i = 0; i < n && !any && path->cycle.n > 0; i++)
        any = item[i].kind == PATH_HOLE;
    if (!any)
        return;
    struct expansion d = {
        .path = path, .spindle = path->head.spindle, .ccw = path->head.spindle_ccw};
    path->item.item = NULL;
    path->item.n = path->item.cap = 0;
    for (size_t i = 0; i < n; i++) {
        d.hole = &item[i];
        if (item[i].kind == PATH_HOLE)
            drill_hole(&d, &path->cycle.item[item[i].index]);
        else
            copy_item(&d, &item[i]);
    }
    free(item);
}
