/* path_drill - holes of drilling cycles as the motions that they stand for; see path.h. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/num.h"
#include "io/path/path.h"

struct drill {
    struct path *path;
    const struct path_item *hole;
    struct pose at; /* where the tool is */
    bool known;     /* it is */
    double feed;    /* mm/min in force, 0: none */
    bool own_feed;  /* the program has the cycle's feed instead */
    double spindle; /* rev/min */
    bool ccw;
};

static void go_to(struct drill *d, struct pose to, bool rapid)
{
    if (d->known && vec_distance(to.p, d->at.p) == 0 && vec_distance(to.a, d->at.a) == 0)
        return;
    path_add_point(d->path, to, rapid)->line = d->hole->line;
    d->at = to;
    d->known = true;
}

/* To a height above the mouth. */
static void go(struct drill *d, double height, bool rapid)
{
    go_to(d, (struct pose){vec_along(d->hole->to.p, height, d->hole->to.a), d->hole->to.a}, rapid);
}

/* Down to the bottom in steps; the tool is at `clear`. */
static void steps(struct drill *d, const struct path_cycle *c)
{
    double step = c->kind == CYCLE_DEEP || c->kind == CYCLE_BREAK ? c->step : 0, deep = 0;
    while (step > 0 && deep + step < c->depth - 1e-6) {
        double gap = fmin(step / 2, PATH_PECK_GAP);
        deep += step;
        go(d, -deep, false);
        if (c->kind == CYCLE_DEEP)
            go(d, c->clear, true);
        go(d, gap - deep, true);
        step = c->next;
    }
    go(d, -c->depth, false);
}

static void turn_spindle(struct drill *d, bool ccw)
{
    char text[NUM_MAX + 20] = "SPINDL/RPM,";
    if (!(d->spindle > 0))
        return;
    char *end = text + strlen(text);
    end += num_write(end, d->spindle, 6);
    memcpy(end, ccw ? ",CCLW" : ",CLW", ccw ? 6 : 5);
    path_add_text(d->path, text);
}

static void stay(struct drill *d, double seconds)
{
    char text[NUM_MAX + 8] = "DELAY/";
    if (!(seconds > 0))
        return;
    num_write(text + strlen(text), seconds, 6);
    path_add_text(d->path, text);
}

static void drill(struct drill *d, const struct path_cycle *c)
{
    struct pose mouth = d->hole->to;
    double level = c->retract;
    if (d->known && vec_distance(d->at.a, mouth.a) < 1e-9) {
        double height = vec_dot(vec_sub(d->at.p, mouth.p), mouth.a);
        if (height < level) /* up before it goes over */
            go_to(d, (struct pose){vec_along(d->at.p, level - height, mouth.a), mouth.a}, true);
        level = fmax(level, height);
    }
    go(d, level, true);
    go(d, c->retract, true);
    go(d, c->clear, true);
    if (c->feed > 0) {
        path_add_feed(d->path, c->feed);
        d->own_feed = true;
    }
    steps(d, c);
    stay(d, c->dwell);
    if (c->kind == CYCLE_TAP)
        turn_spindle(d, !d->ccw);
    else if (c->kind == CYCLE_DRAG || c->kind == CYCLE_MANUAL)
        path_add_text(d->path, "SPINDL/OFF");
    if (c->kind == CYCLE_MANUAL)
        path_add_text(d->path, "STOP");
    if (c->kind == CYCLE_TAP || c->kind == CYCLE_BORE)
        go(d, c->clear, false);
    if (c->kind == CYCLE_TAP)
        turn_spindle(d, d->ccw);
    go(d, c->retract, true);
    if (c->kind == CYCLE_DRAG || c->kind == CYCLE_MANUAL)
        turn_spindle(d, d->ccw);
}

/* The speed that a SPINDL among the texts says. */
static void interpolation_spindle(struct drill *d, const char *text)
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

static void follow(struct drill *d, const struct path_item *item)
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
        interpolation_spindle(d, d->path->text.item[item->index]);
    }
    *array_push(&d->path->item) = *item;
}

void path_drill(struct path *path)
{
    size_t n = path->item.n;
    struct path_item *item = path->item.item;
    bool any = false;
    for (size_t i = 0; i < n && !any; i++)
        any = item[i].kind == PATH_HOLE;
    if (!any)
        return;
    struct drill d = {.path = path, .spindle = path->head.spindle, .ccw = path->head.spindle_ccw};
    path->item.item = NULL;
    path->item.n = path->item.cap = 0;
    for (size_t i = 0; i < n; i++) {
        d.hole = &item[i];
        if (item[i].kind == PATH_HOLE)
            drill(&d, &path->cycle.item[item[i].index]);
        else
            follow(&d, &item[i]);
    }
    free(item);
}
