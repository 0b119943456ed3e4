/*
 * toolpath - see toolpath.h.  Strips, lifted (toolpath_parts.h) and linked, become items of the
 * path; at the end is what stays uncut, and what is reported.
 */
#include "stage/toolpath.h"

#include <stdlib.h>

#include "base/cli.h"
#include "base/parallel.h"
#include "gouge/link.h"
#include "math/kdtree.h"
#include "toolpath_parts.h"

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

/* ---- strips and links put into the path */

/* A point of the path, and of what is looked at when it is done. */
static struct path_item *add_point(struct toolpath *t, struct pose pose, bool rapid)
{
    if (t->lift.guard && !rapid)
        *array_push(&t->ball) = vec_along(pose.p, t->rule.radius, pose.a);
    return path_add_point(t->path, pose, rapid);
}

static void add_move(struct toolpath *t, struct vec3 ball, struct vec3 axis, bool rapid)
{
    add_point(t, (struct pose){vec_along(ball, -t->rule.radius, axis), axis}, rapid);
}

static void set_feed(struct toolpath *t, double feed)
{
    if (feed != t->feed_now)
        path_add_feed(t->path, feed);
    t->feed_now = feed;
}

static struct link_options link_options(const struct toolpath *t)
{
    return (struct link_options){.lift = &t->lift,
                                 .holder = &t->rule.holder,
                                 .radius = t->rule.radius,
                                 .limit = t->rule.radius,
                                 .rate = t->rule.rate,
                                 .clearance = t->rule.clearance,
                                 .approach = t->rule.approach};
}

static struct retract find_retract(struct toolpath *t, const struct run_point *p)
{
    struct link_options options = link_options(t);
    struct retract r = link_retract(&options, p);

    if (!r.clear && t->blocked++ == 0) {
        t->blocked_pass = t->pass;
        t->blocked_at = p->contact;
    }
    return r;
}

static void retract(struct toolpath *t)
{
    struct retract r = find_retract(t, &t->at);

    add_move(t, r.near, t->at.axis, false);
    if (r.top.z > r.out.z)
        add_move(t, r.out, t->at.axis, r.clear);
    add_move(t, r.top, t->at.axis, r.clear);
    t->down = false;
}

static void approach(struct toolpath *t, const struct run_point *p)
{
    struct retract r = find_retract(t, p);

    add_move(t, r.top, p->axis, true);
    if (!r.clear)
        set_feed(t, t->rule.plunge);
    if (r.top.z > r.out.z)
        add_move(t, r.out, p->axis, r.clear);
    add_move(t, r.near, p->axis, r.clear);
    set_feed(t, t->rule.plunge);
    add_move(t, p->ball, p->axis, false);
    set_feed(t, t->rule.feed);
}

/* From where the tool is to the first point of a strip, and the word that begins a pass. */
static void link_to(struct toolpath *t, size_t pass, const struct run_point *p)
{
    struct link_options options = link_options(t);
    struct run link = {.radius = t->rule.radius};
    bool low = t->down && vec_distance(t->at.ball, p->ball) <= t->rule.longest &&
               link_low(&options, &t->at, p, &link);

    if (t->down && !low)
        retract(t);
    if (pass != t->pass)
        path_add_pass(t->path, pass);
    t->pass = pass;
    if (low) {
        for (size_t i = 0; i < link.n; i++)
            add_move(t, link.item[i].ball, link.item[i].axis, false);
        add_move(t, p->ball, p->axis, false);
        t->low++;
    } else {
        approach(t, p);
        t->high++;
    }
    array_free(&link);
}

static void add_cut(struct toolpath *t, const struct run_point *point, size_t n)
{
    for (size_t i = 0; i < n; i++) {
        const struct run_point *p = &point[i];
        struct path_item *item = add_point(t, (struct pose){p->tip, p->axis}, false);
        if (vec_length(p->normal) > 0)
            path_set_contact(t->path, item, (struct contact){p->contact, p->normal});
        if (vec_dot(p->axis, p->normal) < -1e-6)
            t->shank++;
    }
    t->at = point[n - 1];
    t->down = true;
}

static void add_report(struct toolpath *t, size_t pass, const struct gouge_lift_report *r)
{
    struct gouge_lift_report *all = &t->report;

    all->points += r->points;
    all->lifted += r->lifted;
    all->unreachable += r->unreachable;
    if (r->highest > all->highest) {
        all->highest = r->highest;
        all->highest_at = r->highest_at;
    }
    if (r->unreachable_by > all->unreachable_by) {
        all->unreachable_by = r->unreachable_by;
        all->unreachable_at = r->unreachable_at;
        t->unreachable_pass = pass;
    }
}

static void add_strip(struct toolpath *t, const struct toolpath_strip *strip)
{
    const struct lifted_strip *lifted = &strip->lifted;
    size_t from = 0;

    t->lift = strip->lift;
    t->chord = fmax(t->chord, strip->chord);
    add_report(t, strip->pass, &lifted->report);
    t->leaned = fmax(t->leaned, strip->leaned);
    if (t->skipped == 0) {
        t->skipped_pass = strip->pass;
        t->skipped_at = strip->skipped_at;
    }
    t->skipped += strip->skipped;
    for (size_t i = 0; i < lifted->end.n; i++) {
        size_t end = lifted->end.item[i];
        if (end > from) {
            link_to(t, strip->pass, &lifted->run.item[from]);
            add_cut(t, &lifted->run.item[from], end - from);
        }
        from = end;
    }
    for (size_t i = 0; i < lifted->uncut.n; i++)
        *array_push(&t->uncut) =
            (struct toolpath_uncut){lifted->uncut.item[i], strip->pass, strip->lift.offset};
}

/* Strips to be lifted at a time. */
struct batch {
    struct toolpath *t;
    size_t from;
};

/* Checks what there is of the path, writes it, and uses its room for what follows. */
static void write_items(struct toolpath *t)
{
    if (!t->out)
        return;
    path_check_items(&t->check, t->path, 0, t->path->item.n);
    path_write_items(t->out, t->path);
    t->path->item.n = t->path->contact.n = 0;
}

static void lift_strips(void *context, size_t first, size_t last)
{
    const struct batch *b = context;

    for (size_t i = first; i < last; i++)
        toolpath_lift_strip(b->t, &b->t->strip.item[b->from + i]);
}

static void add_strips(struct toolpath *t, size_t from, size_t to)
{
    for (size_t k = from; k < to; k++) {
        struct toolpath_strip *strip = &t->strip.item[k];
        add_strip(t, strip);
        array_free(&strip->contact);
        lifted_strip_free(&strip->lifted);
    }
    write_items(t);
}

/* ---- what the path leaves uncut */

struct uncut_check {
    const struct toolpath *t;
    struct kdtree *ball; /* where its centre is at the points of the path */
    bool *uncut;         /* at each place: more than may be */
};

/* No ball comes nearer to the place than this above it. */
static bool is_uncut(const struct uncut_check *check, const struct toolpath_uncut *s, double height)
{
    struct vec3 at = s->place.contact;

    return s->place.height > height && !kdtree_any_beside(check->ball, at, at, s->offset + height);
}

static void check_places(void *context, size_t from, size_t to)
{
    struct uncut_check *check = context;

    for (size_t i = from; i < to; i++)
        check->uncut[i] = is_uncut(check, &check->t->uncut.item[i], check->t->lift.uncut);
}

/* Counts what stays uncut, and finds the highest. */
static void find_highest_uncut(struct toolpath *t, const struct uncut_check *check)
{
    for (size_t i = 0; i < t->uncut.n; i++) {
        const struct toolpath_uncut *s = &t->uncut.item[i];
        struct vec3 at = s->place.contact;
        size_t nearest;
        t->uncut_places += check->uncut[i];
        if (!check->uncut[i] || !is_uncut(check, s, t->uncut_height))
            continue;
        double far = s->offset + s->place.height;
        t->uncut_height = kdtree_nearest_segment(check->ball, at, at, far, &nearest) - s->offset;
        t->uncut_at = at;
        t->uncut_pass = s->pass;
    }
}

/* Looks from the places where a lifted ball may leave something for the nearest that it comes on
 * the whole path, which may reach them from the side, and counts those where it does not. */
static void find_uncut(struct toolpath *t)
{
    struct uncut_check check = {.t = t};

    if (t->uncut.n == 0)
        return;
    check.ball = kdtree_new_by(t->ball.item, t->ball.n, t->threads);
    array_free(&t->ball);
    check.uncut = mem_alloc(t->uncut.n, sizeof *check.uncut);
    parallel_for(t->threads, t->uncut.n, check_places, &check);
    find_highest_uncut(t, &check);
    free(check.uncut);
    kdtree_free(check.ball);
    array_free(&t->uncut);
}

/* What the path is checked with when it is done. */
static struct path_check path_check_of(const struct toolpath *t)
{
    return (struct path_check){.tool = {.guard = t->lift.guard,
                                        .radius = t->rule.radius,
                                        .tolerance = t->lift.tolerance,
                                        .holder = t->rule.holder},
                               .threads = t->threads};
}

void toolpath_end(struct toolpath *t)
{
    const size_t batch = 16;

    if (t->rule.turn > 0)
        toolpath_choose_lean(t);
    t->check = path_check_of(t);
    if (t->streams) {
        t->out = out_open(t->output);
        path_write_head(t->out, &t->path->head);
    }
    for (size_t from = 0, to; from < t->strip.n; from = to) {
        struct batch b = {t, from};
        to = t->strip.n - from < batch ? t->strip.n : from + batch;
        parallel_for(t->threads, to - from, lift_strips, &b);
        progress("lifting", to, t->strip.n);
        add_strips(t, from, to);
    }
    array_free(&t->strip);
    if (t->down)
        retract(t);
    write_items(t);
    if (!t->out) {
        t->check.chord = t->chord;
        path_check_items(&t->check, t->path, 0, t->path->item.n);
    }
    find_uncut(t);
}

/* ---- what came of it */

/* What does not hold, and where. */
static void say_unmet(const struct toolpath *t)
{
    const struct gouge_lift_report *r = &t->report;
    struct vec3 at = r->unreachable_at;

    if (r->unreachable > 0)
        say("the ball cannot reach %zu points with a lift of at most %g mm and skips them, worst "
            "in "
            "pass %zu by %.3f mm at %.3f %.3f %.3f",
            r->unreachable, t->lift.limit, t->unreachable_pass, r->unreachable_by, at.x, at.y,
            at.z);
    at = t->uncut_at;
    if (t->uncut_places > 0)
        say("the ball does not fit at %zu points and leaves material there, worst in pass %zu "
            "%.3f mm at %.3f %.3f %.3f",
            t->uncut_places, t->uncut_pass, t->uncut_height, at.x, at.y, at.z);
    if ((r->unreachable > 0 || t->uncut_places > 0) && !t->rule.avoid)
        say("a smaller ball must remove it; --avoid accepts it");
    at = t->blocked_at;
    if (t->blocked > 0)
        say("pass %zu: the ball touches the part on %zu moves to or from the clearance plane, the "
            "first at %.3f %.3f %.3f",
            t->blocked_pass, t->blocked, at.x, at.y, at.z);
    at = t->skipped_at;
    if (t->skipped > 0)
        say("shank or holder touches at %zu points for every tilt within the limit: "
            "left out, the first in pass %zu at %.3f %.3f %.3f",
            t->skipped, t->skipped_pass, at.x, at.y, at.z);
    if (t->shank > 0)
        say("at %zu points the normal is more than 90 degrees off the axis: the shank touches "
            "there, not the ball",
            t->shank);
}

int toolpath_conclude(const struct toolpath *t)
{
    const struct gouge_lift_report *r = &t->report;

    note("%zu points in %zu passes, %zu links with the tool down, %zu over the clearance plane",
         r->points, t->pass, t->low, t->high);
    note("%zu points lifted, at most by %.4f mm at %.3f %.3f %.3f", r->lifted, r->highest,
         r->highest_at.x, r->highest_at.y, r->highest_at.z);
    if (t->rule.holder.n > 0)
        note("axes tilted by at most %.2f degrees for shank and holder", DEGREES(t->leaned));
    if (t->lift.between)
        note("straight lines within %g mm of the lifted path", t->lift.tolerance);
    else
        note("straight lines up to %.4f mm from the smooth path", t->chord);
    say_unmet(t);
    bool left = (r->unreachable > 0 || t->uncut_places > 0) && !t->rule.avoid;
    left = left || (t->skipped > 0 && !t->rule.skip);
    left = left || path_check_conclude(&t->check) != EXIT_DONE;
    return left || t->blocked > 0 || t->shank > 0 ? EXIT_UNMET : EXIT_DONE;
}
