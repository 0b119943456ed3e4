#include "stage/toolpath.h"

#include <stdlib.h>

#include "gouge/axis_smooth.h"
#include "base/cli.h"
#include "gouge/holder_avoid.h"
#include "base/parallel.h"
#include "gouge/link.h"

/* A direction flatter than this does not lead to the clearance plane: sin 10 degrees. */
static const double FLAT = 0.17364817766693033;

/* A way from a point of a strip to the clearance plane, for the ball's centre. */
struct way {
    struct vec3 near; /* the approach distance off the point */
    struct vec3 out;  /* straight on, on the clearance plane or beside the part */
    struct vec3 top;  /* with the tip on the clearance plane */
    bool clear;
};

/* A point of the path, and of what is looked at when it is done. */
static struct path_item *add_point(struct toolpath *t, struct pose pose, bool rapid)
{
    if (t->lift.guard && !rapid)
        *array_push(&t->ball) = vec_along(pose.p, t->rule.radius, pose.a);
    return path_add_point(t->path, pose, rapid);
}

static void move(struct toolpath *t, struct vec3 ball, struct vec3 axis, bool rapid)
{
    add_point(t, (struct pose){vec_along(ball, -t->rule.radius, axis), axis}, rapid);
}

static void set_feed(struct toolpath *t, double feed)
{
    if (feed != t->feed_now)
        path_add_feed(t->path, feed);
    t->feed_now = feed;
}

/* How far to go in a direction: to the clearance plane, which is `rise` above, or where that is
 * too flat to where the part ends. */
static double way_out(const struct toolpath *t, struct vec3 from, struct vec3 direction,
                      double rise)
{
    if (direction.z > FLAT)
        return rise / direction.z;
    if (!t->lift.guard)
        return 0;
    return fmax(0, gouge_extent(t->lift.guard, from, direction) + t->lift.offset);
}

/* Shank and holder go clear from one place to the other with the axis of p. */
static bool holder_clear(const struct toolpath *t, const struct run_point *p, struct vec3 from,
                         struct vec3 to)
{
    struct holder_avoid_options rule = {t->lift.guard, &t->rule.holder, 0, 2 * t->lift.tolerance};
    struct run_point a = {.ball = from, .axis = p->axis}, b = {.ball = to, .axis = p->axis};

    return t->rule.holder.n == 0 || holder_lean_clear(&rule, &a, &b);
}

/* The way off the point p that begins in this direction. */
static struct way way_off(const struct toolpath *t, const struct run_point *p,
                          struct vec3 direction)
{
    const struct gouge_check *guard = t->lift.guard;
    double offset = t->lift.offset, plane = t->rule.clearance + t->rule.radius * p->axis.z;
    struct way way = {.near = vec_along(p->ball, t->rule.approach, direction), .clear = true};
    double out = way_out(t, way.near, direction, fmax(0, plane - way.near.z));

    way.out = vec_along(way.near, out, direction);
    way.top = way.out;
    if (plane > way.out.z + 1e-6)
        way.top.z = plane;
    if (guard) {
        double depth = fmax(gouge_depth_along(guard, p->ball, way.out, offset),
                            gouge_depth_along(guard, way.out, way.top, offset));
        way.clear = depth <= fmax(gouge_depth(guard, p->ball, offset), 0) + t->lift.tolerance &&
                    holder_clear(t, p, p->ball, way.out) && holder_clear(t, p, way.out, way.top);
    }
    return way;
}

static struct way find_way(struct toolpath *t, const struct run_point *p)
{
    struct way along_axis = way_off(t, p, p->axis);
    if (along_axis.clear)
        return along_axis;
    struct way straight_up = way_off(t, p, vec(0, 0, 1));
    if (straight_up.clear)
        return straight_up;
    if (t->blocked++ == 0) {
        t->blocked_pass = t->pass;
        t->blocked_at = p->contact;
    }
    return along_axis;
}

static void retract(struct toolpath *t)
{
    struct way way = find_way(t, &t->at);

    move(t, way.near, t->at.axis, false);
    if (way.top.z > way.out.z)
        move(t, way.out, t->at.axis, way.clear);
    move(t, way.top, t->at.axis, way.clear);
    t->down = false;
}

static void approach(struct toolpath *t, const struct run_point *p)
{
    struct way way = find_way(t, p);

    move(t, way.top, p->axis, true);
    if (!way.clear)
        set_feed(t, t->rule.plunge);
    if (way.top.z > way.out.z)
        move(t, way.out, p->axis, way.clear);
    move(t, way.near, p->axis, way.clear);
    set_feed(t, t->rule.plunge);
    move(t, p->ball, p->axis, false);
    set_feed(t, t->rule.feed);
}

/* Shank and holder go clear, and the axis turns no faster than it may, on the way to p. */
static bool low_is_free(const struct toolpath *t, const struct run_point *p, const struct run *way)
{
    struct holder_avoid_options rule = {t->lift.guard, &t->rule.holder, 0, 2 * t->lift.tolerance};
    struct run_point before = t->at;

    for (size_t i = 0; i <= way->n; i++) {
        struct run_point ends[2] = {before, i < way->n ? way->item[i] : *p};
        struct run both = {.n = 2, .item = ends, .radius = t->rule.radius};
        if ((t->rule.rate > 0 && axis_smooth_fastest(&both) > t->rule.rate) ||
            (t->rule.holder.n > 0 && t->lift.guard &&
             !holder_lean_clear(&rule, &ends[0], &ends[1])))
            return false;
        before = ends[1];
    }
    return true;
}

/* From where the tool is to the first point of a strip, and the word that begins a pass. */
static void link_to(struct toolpath *t, size_t pass, const struct run_point *p)
{
    struct run way = {.radius = t->rule.radius};
    bool low = t->down && vec_distance(t->at.ball, p->ball) <= t->rule.longest &&
               link_low(&t->at, p, &t->lift, t->rule.radius, &way) && low_is_free(t, p, &way);

    if (t->down && !low)
        retract(t);
    if (pass != t->pass)
        path_add_pass(t->path, pass);
    t->pass = pass;
    if (low) {
        for (size_t i = 0; i < way.n; i++)
            move(t, way.item[i].ball, way.item[i].axis, false);
        move(t, p->ball, p->axis, false);
        t->low++;
    } else {
        approach(t, p);
        t->high++;
    }
    array_free(&way);
}

static void cut(struct toolpath *t, const struct run_point *point, size_t n)
{
    for (size_t i = 0; i < n; i++) {
        const struct run_point *p = &point[i];
        struct path_item *item = add_point(t, (struct pose){p->tip, p->axis}, false);
        if (vec_length(p->normal) > 0)
            path_touch(t->path, item, (struct contact){p->contact, p->normal});
        if (vec_dot(p->axis, p->normal) < -1e-6)
            t->shank++;
    }
    t->at = point[n - 1];
    t->down = true;
}

static void report(struct toolpath *t, size_t pass, const struct gouge_strip_report *r)
{
    struct gouge_strip_report *all = &t->report;

    all->points += r->points;
    all->lifted += r->lifted;
    all->missed += r->missed;
    if (r->highest > all->highest) {
        all->highest = r->highest;
        all->highest_at = r->highest_at;
    }
    if (r->miss > all->miss) {
        all->miss = r->miss;
        all->miss_at = r->miss_at;
        t->missed_pass = pass;
    }
}

void toolpath_strip(struct toolpath *t, size_t pass, const struct contact *contact, size_t n,
                    struct vec3 along)
{
    struct toolpath_strip strip = {.pass = pass, .lift = t->lift};

    strip.lift.feed.along = along;
    array_reserve(&strip.contact, n);
    for (size_t i = 0; i < n; i++)
        *array_push(&strip.contact) = contact[i];
    *array_push(&t->strip) = strip;
}

static void add_strip(struct toolpath *t, const struct toolpath_strip *strip)
{
    const struct gouge_strip *lifted = &strip->lifted;
    size_t from = 0;

    t->lift = strip->lift;
    t->chord = fmax(t->chord, strip->chord);
    report(t, strip->pass, &lifted->report);
    t->leaned = fmax(t->leaned, strip->leaned);
    if (t->held == 0) {
        t->held_pass = strip->pass;
        t->held_at = strip->held_at;
    }
    t->held += strip->held;
    for (size_t i = 0; i < lifted->end.n; i++) {
        size_t end = lifted->end.item[i];
        if (end > from) {
            link_to(t, strip->pass, &lifted->run.item[from]);
            cut(t, &lifted->run.item[from], end - from);
        }
        from = end;
    }
    for (size_t i = 0; i < lifted->stand.n; i++)
        *array_push(&t->stand) =
            (struct toolpath_stand){lifted->stand.item[i], strip->pass, strip->lift.offset};
}

/* Strips to be lifted while those before them are put into the path. */
struct batch {
    struct toolpath *t;
    size_t done, from; /* strips [done, from) are lifted, those behind are not */
};

/* What there is of the path goes out, and its room is for what follows. */
static void drain(struct toolpath *t)
{
    if (!t->out)
        return;
    path_write_items(t->out, t->path);
    t->path->item.n = t->path->contact.n = 0;
}

static void work_on(void *context, size_t first, size_t last)
{
    const struct batch *b = context;

    for (size_t i = first; i < last; i++) {
        if (i > 0)
            toolpath_lift(b->t, &b->t->strip.item[b->from + i - 1]);
        for (size_t k = b->done; i == 0 && k < b->from; k++) {
            struct toolpath_strip *strip = &b->t->strip.item[k];
            add_strip(b->t, strip);
            array_free(&strip->contact);
            gouge_strip_free(&strip->lifted);
            drain(b->t);
        }
    }
}

void toolpath_end(struct toolpath *t)
{
    enum { BATCH = 16 };
    struct batch b = {t, 0, 0};

    if (t->rule.turn > 0)
        toolpath_turn(t);
    if (t->streams) {
        t->out = out_open(t->output);
        path_write_head(t->out, &t->path->head);
    }
    while (b.done < t->strip.n) {
        size_t left = t->strip.n - b.from, more = left < BATCH ? left : BATCH;
        parallel_for(t->threads, 1 + more, work_on, &b);
        progress("lifting", b.from + more, t->strip.n);
        b.done = b.from;
        b.from += more;
    }
    array_free(&t->strip);
    if (t->down)
        retract(t);
    drain(t);
    toolpath_stand(t);
}
