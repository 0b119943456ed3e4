/*
 * toolpath - see toolpath.h.  A strip is lifted and its axes are shaped; strips, linked, become
 * items of the path; at the end is what stays uncut, and what is reported.
 */
#include "stage/toolpath.h"

#include <stdlib.h>

#include "base/cli.h"
#include "base/parallel.h"
#include "gouge/axis_smooth.h"
#include "gouge/holder_avoid.h"
#include "gouge/link.h"
#include "machine/rotary_cost.h"
#include "math/kdtree.h"

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

/* ---- the lean at which rotary axes turn least */

struct lean_trial {
    const struct toolpath *t;
    double least, most; /* off the normal, radians */
    double *travel;     /* of the rotary axes, by lean, radians */
};

/* How far the rotary axes turn over all contacts, with the axis by this rule. */
static double travel_by(const struct toolpath *t, const struct tool_axis_options *rule)
{
    struct vec3 before = {0, 0, 0};
    double travel = 0;

    for (size_t i = 0; i < t->strip.n; i++) {
        const struct toolpath_strip *strip = &t->strip.item[i];
        for (size_t k = 0; k < strip->contact.n; k++) {
            struct contact c = strip->contact.item[k];
            struct vec3 centre = vec_along(c.p, strip->lift.offset, c.n);
            struct vec3 axis = tool_axis_at(rule, &strip->lift.feed, centre, c.n);
            if (i > 0 || k > 0)
                travel += rotary_travel(before, axis);
            before = axis;
        }
    }
    return travel;
}

static void try_leans(void *context, size_t from, size_t to)
{
    const struct lean_trial *trial = context;

    for (size_t i = from; i < to; i++) {
        struct tool_axis_options rule = rotary_lean(trial->least, trial->most, (int)i);
        trial->travel[i] = travel_by(trial->t, &rule);
    }
}

/* Chooses lead and tilt anew, between what they are together and rule.turn, so that rotary axes
 * turn least over the contacts of all strips (rotary_cost.h), and says which. */
static void choose_lean(struct toolpath *t)
{
    const struct tool_axis_options *asked = &t->lift.axis;
    double least = atan(hypot(tan(asked->lead), tan(asked->tilt)));
    struct lean_trial trial = {t, least, fmax(least, t->rule.turn), NULL};
    size_t n = (size_t)rotary_leans(trial.least, trial.most), best = 0;

    trial.travel = mem_alloc(n, sizeof *trial.travel);
    parallel_for(t->threads, n, try_leans, &trial);
    for (size_t i = 1; i < n; i++) /* a larger lean has to be worth it */
        if (trial.travel[i] < (1 - 1e-6) * trial.travel[best])
            best = i;
    double before = travel_by(t, asked), now = trial.travel[best];
    free(trial.travel);
    if (now < before) {
        struct tool_axis_options rule = rotary_lean(trial.least, trial.most, (int)best);
        t->lift.axis = rule;
        for (size_t i = 0; i < t->strip.n; i++)
            t->strip.item[i].lift.axis = rule;
    }
    say("lead %.1f, tilt %.1f: rotary axes turn %.0f degrees over the rows (as asked: %.0f)",
        DEGREES(t->lift.axis.lead), DEGREES(t->lift.axis.tilt), DEGREES(fmin(now, before)),
        DEGREES(before));
}

/* ---- a strip lifted, its axes smoothed and leaned away from the part */

static const double SLACK = 0.01;    /* mm: guard points may be in the holder by so much */
static const double ROUNDED = 0.999; /* of the rate: the rest goes to the printed digits */

/* Axes of the points [from, to), smoothed and leaned; touches[] becomes true where the holder keeps
 * the tool out. */
static void shape_axes(const struct toolpath *t, struct toolpath_strip *strip, size_t from,
                       size_t to, bool *touches)
{
    const struct run *all = &strip->lifted.run;
    struct run run = {.n = to - from, .item = all->item + from, .radius = all->radius};
    struct holder_avoid_options rule = {strip->lift.guard, &t->rule.holder, t->rule.lean, SLACK};
    bool has_holder = rule.guard && rule.holder->n > 0;

    if (t->rule.play > 0)
        axis_smooth_play(&run, t->rule.play);
    if (has_holder)
        strip->leaned = fmax(strip->leaned, holder_avoid(&rule, &run, touches + from));
    if (t->rule.rate > 0 && axis_smooth_rate(&run, ROUNDED * t->rule.rate) > 0 && has_holder) {
        rule.limit = 0; /* looks again, leans no more */
        holder_avoid(&rule, &run, touches + from);
    }
}

/* The parts of the strip without the points that touch; a part ends before them. */
static void skip_points(struct toolpath_strip *strip, const bool *touches)
{
    struct lifted_strip *lifted = &strip->lifted;
    struct sizes end = {0};
    size_t kept = 0, part = 0;

    for (size_t i = 0; i < lifted->run.n; i++) {
        if (i == lifted->end.item[part]) {
            *array_push(&end) = kept;
            part++;
        }
        if (touches[i]) {
            if (strip->skipped++ == 0)
                strip->skipped_at = lifted->run.item[i].contact;
            *array_push(&end) = kept;
            continue;
        }
        lifted->run.item[kept++] = lifted->run.item[i];
    }
    *array_push(&end) = kept;
    lifted->run.n = kept;
    array_free(&lifted->end);
    lifted->end = end;
}

/* Puts points on the straight lines between those further apart than this, for the axes to lean. */
static void refine_for_lean(struct lifted_strip *lifted)
{
    const double most = 0.5; /* mm */
    struct run fine = {.radius = lifted->run.radius};
    size_t part = 0;

    for (size_t i = 0; i < lifted->run.n; i++) {
        const struct run_point *b = &lifted->run.item[i], *a = b - 1;
        bool begins = i == 0 || i == lifted->end.item[part];
        for (; i > 0 && i == lifted->end.item[part]; part++)
            lifted->end.item[part] = fine.n;
        double parts = begins ? 1 : ceil(vec_distance(a->ball, b->ball) / most);
        for (double k = 1; k < parts; k++) {
            struct run_point p = {.ball = vec_mix(a->ball, b->ball, k / parts),
                                  .axis = vec_slerp(a->axis, b->axis, k / parts)};
            if (vec_length(a->normal) > 0 && vec_length(b->normal) > 0) {
                p.normal = vec_slerp(a->normal, b->normal, k / parts);
                p.contact = vec_mix(a->contact, b->contact, k / parts);
            }
            p.tip = vec_along(p.ball, -fine.radius, p.axis);
            *array_push(&fine) = p;
        }
        *array_push(&fine) = *b;
    }
    for (; part < lifted->end.n; part++)
        lifted->end.item[part] = fine.n;
    array_free(&lifted->run);
    lifted->run = fine;
}

static void shape_strip(const struct toolpath *t, struct toolpath_strip *strip)
{
    const struct sizes *end = &strip->lifted.end;
    bool any = false;

    if (t->rule.holder.n > 0)
        refine_for_lean(&strip->lifted);
    size_t n = strip->lifted.run.n;
    bool *touches = mem_alloc(n + 1, sizeof *touches);

    for (size_t i = 0; i < n; i++)
        touches[i] = false;
    for (size_t k = 0, from = 0; k < end->n; from = end->item[k++])
        shape_axes(t, strip, from, end->item[k], touches);
    for (size_t i = 0; i < n; i++)
        any = any || touches[i];
    if (any)
        skip_points(strip, touches);
    free(touches);
}

/* The largest distance between straight lines and the smooth curve, over the parts of [from, to)
 * that touch: what a fitter would take out. */
static double chord_of(const struct run *run, size_t from, size_t to)
{
    double chord = 0;

    for (size_t i = from; i < to; i++) {
        size_t begin = i;
        while (i < to && vec_length(run->item[i].normal) > 0)
            i++;
        struct run touching = {.n = i - begin, .item = run->item + begin, .radius = run->radius};
        struct run smooth = {.radius = run->radius};
        chord = fmax(chord, run_densify(&touching, run->radius, &smooth));
        array_free(&smooth);
    }
    return chord;
}

/* Lifts a strip and does with its axes what the rule says: play, lean and rate.  Where the holder
 * still touches, points are left out and the strip is in more parts. */
static void lift_strip(const struct toolpath *t, struct toolpath_strip *strip)
{
    struct lifted_strip *lifted = &strip->lifted;
    struct run nodes = {.radius = t->rule.radius};
    size_t from = 0;

    for (size_t i = 0; i < strip->contact.n; i++)
        gouge_lift_contact(&nodes, &strip->lift, strip->contact.item[i].p,
                           strip->contact.item[i].n);
    lifted->run.radius = nodes.radius;
    gouge_lift_run(&nodes, &strip->lift, lifted);
    array_free(&nodes);
    shape_strip(t, strip);
    /* Points put between them lie on the smooth path. */
    for (size_t k = 0; !strip->lift.between && k < lifted->end.n; k++) {
        strip->chord = fmax(strip->chord, chord_of(&lifted->run, from, lifted->end.item[k]));
        from = lifted->end.item[k];
    }
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

/* Strips to be lifted while those before them are put into the path. */
struct batch {
    struct toolpath *t;
    size_t done, from; /* strips [done, from) are lifted, those after are not */
};

/* Writes what there is of the path, and uses its room for what follows. */
static void write_items(struct toolpath *t)
{
    if (!t->out)
        return;
    path_write_items(t->out, t->path);
    t->path->item.n = t->path->contact.n = 0;
}

static void lift_and_add(void *context, size_t first, size_t last)
{
    const struct batch *b = context;

    for (size_t i = first; i < last; i++) {
        if (i > 0)
            lift_strip(b->t, &b->t->strip.item[b->from + i - 1]);
        for (size_t k = b->done; i == 0 && k < b->from; k++) {
            struct toolpath_strip *strip = &b->t->strip.item[k];
            add_strip(b->t, strip);
            array_free(&strip->contact);
            lifted_strip_free(&strip->lifted);
            write_items(b->t);
        }
    }
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

void toolpath_end(struct toolpath *t)
{
    enum { BATCH = 16 };
    struct batch b = {t, 0, 0};

    if (t->rule.turn > 0)
        choose_lean(t);
    if (t->streams) {
        t->out = out_open(t->output);
        path_write_head(t->out, &t->path->head);
    }
    while (b.done < t->strip.n) {
        size_t left = t->strip.n - b.from, more = left < BATCH ? left : BATCH;
        parallel_for(t->threads, 1 + more, lift_and_add, &b);
        progress("lifting", b.from + more, t->strip.n);
        b.done = b.from;
        b.from += more;
    }
    array_free(&t->strip);
    if (t->down)
        retract(t);
    write_items(t);
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
    return left || t->blocked > 0 || t->shank > 0 ? EXIT_UNMET : EXIT_DONE;
}
