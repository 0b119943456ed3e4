/* path_cycle - see path_cycle.h. */
#include "path_cycle.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "cl_dialect.h"
#include "cycle_words.h"
#include "base/num.h"

#define AT(p) (p)->error, (p)->path->name, (p)->apt.line

static const double usual_clear = 1; /* mm, where nothing is said */
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
 * Where the feed begins and where the tool leaves.  RAPTO is a height as CLEAR is; of Creo it is
 * how much further down from there the rapid goes (PTC, CL Output for Holemaking Cycles).  The feed
 * may begin within a hole that is there already.
 */
static void take_heights(struct path_parse *p, const struct cycle_words *w, struct path_cycle *c)
{
    double clear = p->unit * w->value[CYCLE_CLEAR], rapid = p->unit * w->value[CYCLE_RAPID];
    bool further = p->dialect == &cl_creo && !isnan(clear) && !isnan(rapid);
    c->clear = further ? clear - rapid : or_else(rapid, or_else(clear, usual_clear));
    double least = c->clear < 0 ? usual_clear : c->clear;
    c->retract = fmax(fmax(c->clear, 0), or_else(p->unit * w->value[CYCLE_RETRACT],
                                                 fmax(least, or_else(clear, least))));
}

/* A thread's pitch says the feed. */
static void take_feed(struct path_parse *p, const struct cycle_words *w, struct path_cycle *c)
{
    double pitch = p->unit * w->value[CYCLE_PITCH], tpi = w->value[CYCLE_TPI];
    if (c->kind == CYCLE_TAP)
        c->pitch = !isnan(pitch) ? pitch : tpi > 0 ? 25.4 / tpi : 0;
    if (c->pitch > 0 && p->spindle > 0)
        c->feed = c->pitch * p->spindle;
    else if (!isnan(w->value[CYCLE_FEED]))
        c->feed = w->value[CYCLE_FEED];
}

static int begin(struct path_parse *p)
{
    struct cycle_words w;
    if (cycle_words(p, &w) < 0)
        return -1;
    struct path_cycle c = {.kind = w.kind,
                           .depth = fabs(p->unit * or_else(w.value[CYCLE_DEPTH], 0)),
                           .step = or_else(p->unit * w.value[CYCLE_STEP], 0),
                           .dwell = or_else(w.value[CYCLE_DWELL], 0)};
    c.next = or_else(p->unit * w.value[CYCLE_NEXT], c.step);
    take_heights(p, &w, &c);
    take_feed(p, &w, &c);
    if (expect_sound(p, &c) < 0)
        return -1;
    *array_push(&p->path->cycle) = c;
    p->cycling = true;
    p->drilled = false;
    p->homeward = p->moved && (w.home || (p->dialect == &cl_creo && w.value[CYCLE_RETRACT] == 0));
    p->before = p->at;
    p->leave = c.retract;
    return 0;
}

int path_read_cycle(struct path_parse *p)
{
    const char *word = p->apt.argument.n ? p->apt.argument.item[0].text : "";
    if (cycle_kind(word) >= 0)
        return begin(p);
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

/* The tool leaves as high above this mouth as it came to CYCLE, else as usual: another cycle where
 * that differs from the hole before. */
static void leave_homeward(struct path_parse *p, struct pose mouth)
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

int path_hole(struct path_parse *p, struct pose mouth)
{
    if (p->homeward)
        leave_homeward(p, mouth);
    p->drilled = true;
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
    static const char *const word[] = {"DRILL", "DEEP",      "BRKCHP",     "TAP",
                                       "BORE",  "BORE,DRAG", "BORE,MANUAL"};
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
