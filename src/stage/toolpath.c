/*
 * toolpath - see toolpath.h.  Strips, lifted (toolpath_parts.h) and linked, become items of the
 * path; at the end is what stays uncut, and what is reported.
 */
#include "stage/toolpath.h"

#include <stdio.h>
#include <stdlib.h>

#include "base/cli.h"
#include "base/parallel.h"
#include "gouge/axis_plan.h"
#include "math/kdtree.h"
#include "toolpath_parts.h"

/* Radii of the ball: a link with the tool down is no longer; a retract takes less time. */
static const double LONGEST = 6;

void toolpath_strip(struct toolpath *t, size_t pass, const struct contact *contact, size_t n,
                    struct vec3 along)
{
    struct toolpath_strip strip = {.pass = pass, .rest = t->rest, .lift = t->lift};

    strip.lift.feed.along = along;
    if (t->rest) /* cuts what others left, to the last of it */
        strip.lift.aside = strip.lift.even = 0;
    array_reserve(&strip.contact, n);
    for (size_t i = 0; i < n; i++)
        *array_push(&strip.contact) = contact[i];
    *array_push(&t->strip) = strip;
}

int toolpath_length_bounded(double length, double radius, const char *said, struct error *error)
{
    const double most = 5e5 * radius;

    if (length <= most)
        return 0;
    return error_set(error,
                     "would cut %s, expected at most %.0f m with a ball of radius %g: is the unit "
                     "of the part right? A larger ball, rows farther apart or a part of the mesh "
                     "make less",
                     said, most / 1e3, radius);
}

int toolpath_bounded(const struct toolpath *t, int layers, struct error *error)
{
    double length = 0;
    char said[400];

    for (size_t k = 0; k < t->strip.n; k++) {
        const struct contact *c = t->strip.item[k].contact.item;
        for (size_t i = 1; i < t->strip.item[k].contact.n; i++)
            length += vec_distance(c[i - 1].p, c[i].p);
    }
    length *= layers;
    snprintf(said, sizeof said, "%.0f m in %zu strips", length / 1e3, t->strip.n * (size_t)layers);
    return toolpath_length_bounded(length, t->rule.radius, said, error);
}

/* A point of a cut, which is looked at when the path is done. */
static struct path_item *add_cut_point(struct toolpath *t, struct pose pose)
{
    if (t->lift.guard)
        *array_push(&t->ball) = vec_along(pose.p, t->rule.radius, pose.a);
    return path_add_point(t->path, pose, false);
}

/* One of a link or a rapid, which need not stay where it is: who fits curves to a link has a tenth
 * of the radius. */
static void add_point(struct toolpath *t, struct pose pose, bool rapid)
{
    if (t->lift.guard)
        *array_push(&t->ball_end) = t->ball.n;
    path_add_point(t->path, pose, rapid);
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

struct link_options toolpath_link_options(const struct toolpath *t)
{
    return (struct link_options){.lift = &t->lift,
                                 .holder = &t->rule.holder,
                                 .radius = t->rule.radius,
                                 .limit = fmax(t->rule.radius, t->rule.longest),
                                 .longest = fmax(t->rule.longest, LONGEST * t->rule.radius),
                                 .rate = t->rule.rate,
                                 .frame = vec_length(t->frame.pole) > 0 ? &t->frame : NULL,
                                 .clearance = t->rule.clearance,
                                 .approach = t->rule.approach};
}

/* ---- ways between parts and the clearance plane */

/* The point of the run nearest to its end (or start) from which a way leads up: looked for at
 * distances along the run that are doubled. */
static struct toolpath_way find_way(const struct toolpath *t, const struct run *run, bool from_end)
{
    struct link_options options = toolpath_link_options(t);
    double along = 0, next = 0;

    for (size_t i = 0; i < run->n; i++) {
        size_t k = from_end ? run->n - 1 - i : i;
        if (i > 0)
            along += vec_distance(run->item[k].ball, run->item[from_end ? k + 1 : k - 1].ball);
        if (along < next && i + 1 < run->n)
            continue;
        struct toolpath_way way = {k, link_retract(&options, &run->item[k])};
        if (way.retract.clear)
            return way;
        next = fmax(t->rule.radius / 2, 2 * along);
    }
    return (struct toolpath_way){.at = run->n};
}

struct way_finder {
    const struct toolpath *t;
    struct toolpath_parts *parts;
};

static void find_ways(void *context, size_t from, size_t to)
{
    const struct way_finder *f = context;

    for (size_t i = from; i < to; i++) {
        struct toolpath_part *part = &f->parts->item[i];
        struct toolpath t = *f->t;
        struct run run = toolpath_part_run(&t, part);
        t.lift = t.strip.item[part->strip].lift;
        part->in = find_way(&t, &run, false);
        part->out = part->in.at < run.n ? find_way(&t, &run, true) : part->in;
    }
}

/* ---- parts and links put into the path */

static double tilt_of(struct vec3 axis)
{
    return vec_angle(axis, vec(0, 0, 1));
}

/* z of the tip at which the tool may turn from one axis to another. */
static double turning_height(const struct toolpath *t, struct vec3 a, struct vec3 b)
{
    struct link_options options = toolpath_link_options(t);

    return link_height(&options, 0, fmax(tilt_of(a), tilt_of(b)));
}

/* The tip straight up from a place of the ball, at this height. */
static struct vec3 over(const struct toolpath *t, struct vec3 ball, struct vec3 axis, double height)
{
    return vec(ball.x, ball.y, height + t->rule.radius * axis.z);
}

/* Back along the part that the tool is at the end of, and up to the height at which it may turn to
 * an axis. */
static void retract(struct toolpath *t, struct vec3 next_axis)
{
    const struct toolpath_way *way = &t->last.out;
    struct run run = toolpath_part_run(t, &t->last);
    const struct run_point *p = &run.item[way->at];
    double height = turning_height(t, p->axis, next_axis);

    for (size_t i = run.n - 1; i > way->at; i--)
        add_move(t, run.item[i - 1].ball, run.item[i - 1].axis, false);
    for (size_t i = 0; i < way->retract.n; i++)
        add_move(t, way->retract.at[i], p->axis, i > 0 && way->retract.rapid);
    struct vec3 top = way->retract.at[way->retract.n - 1], up = over(t, top, p->axis, height);
    if (up.z > top.z + 1e-6)
        add_move(t, up, p->axis, true);
    t->height = fmax(height, top.z - t->rule.radius * p->axis.z);
    t->down = false;
}

/* Over the part, by way of an axis that leans less where the turn to this one would dip into it. */
static void turn_over_part(struct toolpath *t, struct vec3 axis)
{
    size_t last = t->path->item.n;
    struct vec3 way;

    while (last > 0 && !path_moves(&t->path->item.item[last - 1]))
        last--;
    if (last == 0)
        return;
    struct pose now = t->path->item.item[last - 1].to;
    if (link_axis_dips(now.a, axis, &way))
        add_point(t, (struct pose){now.p, way}, true);
}

/* A path ends over its clearance plane, also where its last axis may turn lower than another one:
 * there what the program had set goes off. */
static void end_over_plane(struct toolpath *t)
{
    struct pose last = t->path->item.item[t->path->item.n - 1].to;
    if (last.p.z < t->plane - 1e-6)
        add_point(t, (struct pose){vec(last.p.x, last.p.y, t->plane), last.a}, true);
}

/* From over the part down to where its way in begins, and along it to its start. */
static void approach(struct toolpath *t, const struct toolpath_part *part)
{
    const struct toolpath_way *way = &part->in;
    struct run run = toolpath_part_run(t, part);
    const struct run_point *p = &run.item[way->at];
    struct vec3 top = way->retract.at[way->retract.n - 1];
    double height = fmax(t->height, turning_height(t, p->axis, p->axis));
    struct vec3 up = over(t, top, p->axis, height);

    turn_over_part(t, p->axis);
    if (up.z > top.z + 1e-6)
        add_move(t, up, p->axis, true);
    add_move(t, top, p->axis, true);
    if (!way->retract.rapid)
        set_feed(t, t->rule.plunge);
    for (size_t i = way->retract.n - 1; i-- > 0;)
        add_move(t, way->retract.at[i], p->axis, way->retract.rapid);
    set_feed(t, t->rule.plunge);
    add_move(t, p->ball, p->axis, false);
    set_feed(t, t->rule.feed);
    for (size_t i = way->at; i-- > 0;)
        add_move(t, run.item[i].ball, run.item[i].axis, false);
}

/* From where the tool is to the first point of a part, and the word that begins a pass. */
static void link_to(struct toolpath *t, size_t pass, const struct toolpath_part *part)
{
    struct run run = toolpath_part_run(t, part);
    const struct run_point *p = &run.item[0];
    bool low = t->down && part->low;

    if (t->down && !low)
        retract(t, run.item[part->in.at].axis);
    if (low) { /* part of the pass before: to a fitter it is a whole then */
        for (size_t i = 0; i < part->link.n; i++)
            add_move(t, part->link.item[i].ball, part->link.item[i].axis, false);
        add_move(t, p->ball, p->axis, false);
        t->low++;
    }
    if (pass != t->pass)
        path_add_pass(t->path, pass);
    t->pass = pass;
    if (!low) {
        approach(t, part);
        t->high++;
    }
}

static void add_cut(struct toolpath *t, const struct run_point *point, size_t n)
{
    for (size_t i = 0; i < n; i++) {
        const struct run_point *p = &point[i];
        struct path_item *item = add_cut_point(t, (struct pose){p->tip, p->axis});
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

/* What the lift of a strip tells of it. */
static void add_strip(struct toolpath *t, const struct toolpath_strip *strip)
{
    const struct lifted_strip *lifted = &strip->lifted;

    t->chord = fmax(t->chord, strip->chord);
    add_report(t, strip->pass, &lifted->report);
    t->leaned = fmax(t->leaned, strip->leaned);
    if (t->skipped == 0) {
        t->skipped_pass = strip->pass;
        t->skipped_at = strip->skipped_at;
    }
    t->skipped += strip->skipped;
    t->skipped_area += strip->skipped_length * t->rule.spacing;
    for (size_t i = 0; i < lifted->uncut.n; i++)
        *array_push(&t->uncut) =
            (struct toolpath_uncut){lifted->uncut.item[i], strip->pass, strip->lift.offset};
}

/* No way leads to the part, or out of it. */
static bool is_blocked(const struct toolpath_part *part, size_t points)
{
    return part->in.at >= points || part->out.at >= points;
}

/* A part that no way leads to. */
static void add_blocked(struct toolpath *t, size_t pass, const struct run *run)
{
    if (t->blocked++ == 0) {
        t->blocked_pass = pass;
        t->blocked_at = run->item[0].ball;
    }
    for (size_t i = 1; i < run->n; i++)
        t->blocked_area +=
            t->rule.longest / 3 * vec_distance(run->item[i - 1].ball, run->item[i].ball);
}

static void add_part(struct toolpath *t, const struct toolpath_part *part)
{
    const struct toolpath_strip *strip = &t->strip.item[part->strip];
    struct run run = toolpath_part_run(t, part);

    t->lift = strip->lift;
    if (is_blocked(part, run.n)) {
        add_blocked(t, strip->pass, &run);
        if (t->down)
            retract(t, vec(0, 0, 1));
        return;
    }
    link_to(t, strip->pass, part);
    add_cut(t, run.item, run.n);
    t->last = *part;
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

static void plan_strips(void *context, size_t first, size_t last)
{
    const struct batch *b = context;

    for (size_t i = first; i < last; i++)
        toolpath_plan_strip(b->t, &b->t->strip.item[b->from + i]);
}

/* Where the ball's centre is on a lifted strip. */
static void add_swept(struct toolpath *t, const struct lifted_strip *lifted)
{
    for (size_t i = 0, k = 0; i < lifted->run.n; i++) {
        for (; k < lifted->end.n && i == lifted->end.item[k]; k++)
            *array_push(&t->swept_end) = t->swept.n;
        *array_push(&t->swept) = lifted->run.item[i].ball;
    }
    *array_push(&t->swept_end) = t->swept.n;
}

/* Takes the points [from, to) out of a strip; the part that they were is empty. */
static void remove_points(struct lifted_strip *lifted, size_t from, size_t to)
{
    for (size_t i = to; i < lifted->run.n; i++)
        lifted->run.item[from + i - to] = lifted->run.item[i];
    lifted->run.n -= to - from;
    for (size_t k = 0; k < lifted->end.n; k++)
        if (lifted->end.item[k] > from)
            lifted->end.item[k] -= (lifted->end.item[k] < to ? lifted->end.item[k] : to) - from;
}

/* Leaves out of a strip where the ball touches nothing, but for short ways between; there its parts
 * end. */
static void remove_idle(struct lifted_strip *lifted, double longest)
{
    struct run kept = {.radius = lifted->run.radius};
    struct sizes end = {0};

    for (size_t k = 0, from = 0; k < lifted->end.n; from = lifted->end.item[k++]) {
        size_t last = SIZE_MAX; /* that touches */
        for (size_t i = from; i < lifted->end.item[k]; i++) {
            const struct run_point *p = &lifted->run.item[i];
            if (!run_point_touches(p))
                continue;
            bool near =
                last != SIZE_MAX && vec_distance(lifted->run.item[last].ball, p->ball) <= longest;
            if (last != SIZE_MAX && last + 1 < i && !near)
                *array_push(&end) = kept.n;
            for (size_t b = last + 1; near && b < i; b++)
                *array_push(&kept) = lifted->run.item[b];
            *array_push(&kept) = *p;
            last = i;
        }
        *array_push(&end) = kept.n;
    }
    array_free(&lifted->run);
    array_free(&lifted->end);
    lifted->run = kept;
    lifted->end = end;
}

/* Slivers go at once: what is cut later may rest on what is kept now. */
static void remove_slivers(struct toolpath *t)
{
    struct toolpath_parts parts = toolpath_parts_of(t);

    t->slivers = toolpath_drop_slivers(t, &parts);
    for (size_t k = parts.n; k-- > 0;)
        if (parts.item[k].dropped)
            remove_points(&t->strip.item[parts.item[k].strip].lifted, parts.item[k].from,
                          parts.item[k].to);
    array_free(&parts);
}

/* Does something to all strips that wait, and says how far it is. */
static void in_batches(struct toolpath *t, void (*work)(void *, size_t, size_t), const char *what)
{
    const size_t batch = 16;

    for (size_t from = t->lifted, to; from < t->strip.n; from = to) {
        struct batch b = {t, from};
        to = t->strip.n - from < batch ? t->strip.n : from + batch;
        parallel_for(t->threads, to - from, work, &b);
        progress(what, to, t->strip.n);
    }
}

void toolpath_cut(struct toolpath *t)
{
    const size_t first = t->lifted;

    if (first == 0 && t->rule.turn > 0)
        toolpath_choose_lean(t);
    if (!t->planner) {
        t->planner = toolpath_new_planner(t);
        if (t->planner)
            t->frame = rotary_frame_of(&t->rule.chain);
    }
    in_batches(t, lift_strips, "lifting");
    toolpath_smooth(t, first);
    if (t->planner)
        axis_planner_play(t->planner, toolpath_play(t, t->rest));
    in_batches(t, plan_strips, "axes");
    for (size_t k = first; k < t->strip.n; k++) {
        if (t->strip.item[k].rest)
            remove_idle(&t->strip.item[k].lifted, t->rule.radius);
        else
            add_strip(t, &t->strip.item[k]);
        array_free(&t->strip.item[k].contact);
    }
    t->lifted = t->strip.n;
    if (first == 0 && t->lift.guard)
        remove_slivers(t);
    for (size_t k = first; k < t->lifted; k++)
        add_swept(t, &t->strip.item[k].lifted);
}

/* The clearance plane for the axis of the path that leans most. */
static double plane_of(const struct toolpath *t)
{
    struct link_options options = toolpath_link_options(t);
    double most = 0;

    for (size_t k = 0; k < t->strip.n; k++) {
        const struct run *run = &t->strip.item[k].lifted.run;
        for (size_t i = 0; i < run->n; i++)
            most = fmax(most, tilt_of(run->item[i].axis));
    }
    return link_height(&options, 0, most);
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
                               .coarse = !t->lift.between,
                               .threads = t->threads};
}

static void free_strips(struct toolpath *t)
{
    for (size_t k = 0; k < t->strip.n; k++) {
        array_free(&t->strip.item[k].contact);
        lifted_strip_free(&t->strip.item[k].lifted);
    }
    array_free(&t->strip);
}

/* What a fitter asks of the whole path (path_next_run), said before its first pass. */
static struct path_runs runs_of(const struct toolpath *t, const struct toolpath_parts *parts)
{
    struct path_runs runs = {.feed = fmax(t->rule.feed, t->rule.plunge)};

    for (size_t k = 0; k < parts->n; k++) {
        struct run run = toolpath_part_run(t, &parts->item[k]);
        if (is_blocked(&parts->item[k], run.n))
            continue;
        for (size_t i = 0, from; i < run.n; i++) {
            for (from = i; i < run.n && vec_length(run.item[i].normal) > 0;)
                i++;
            runs.points += i > from + 1 ? i - from : 0;
        }
    }
    return runs;
}

/* The parts of all strips in their order, each with its ways in and out. */
static struct toolpath_parts plan_parts(struct toolpath *t)
{
    struct toolpath_parts parts = toolpath_parts_of(t);
    struct way_finder finder = {t, &parts};

    if (t->lift.guard)
        toolpath_order(t, &parts);
    toolpath_join(t, &parts);
    toolpath_calm(t, &parts, toolpath_link_options(t).longest);
    toolpath_thin(t, &parts);
    parallel_for(t->threads, parts.n, find_ways, &finder);
    return parts;
}

void toolpath_end(struct toolpath *t)
{
    const size_t at_once = 64; /* parts that are checked and written together */

    toolpath_cut(t);
    axis_planner_free(t->planner);
    t->planner = NULL;
    array_free(&t->swept);
    array_free(&t->swept_end);
    struct toolpath_parts parts = plan_parts(t);
    t->plane = plane_of(t);
    t->check = path_check_of(t);
    t->path->head.multax = t->path->head.multax || t->leaned > 0;
    t->path->head.runs = runs_of(t, &parts);
    if (t->streams) {
        t->path->head.clearance = t->plane;
        t->out = out_open(t->output);
        path_write_head(t->out, &t->path->head);
    }
    for (size_t i = 0; i < parts.n; i++) {
        add_part(t, &parts.item[i]);
        if (i % at_once == at_once - 1)
            write_items(t);
    }
    if (t->down) {
        retract(t, vec(0, 0, 1));
        end_over_plane(t);
    }
    write_items(t);
    if (!t->out)
        path_check_items(&t->check, t->path, 0, t->path->item.n);
    toolpath_parts_free(&parts);
    free_strips(t);
    find_uncut(t);
}

void toolpath_free(struct toolpath *t)
{
    array_free(&t->ball);
    array_free(&t->ball_end);
}

/* ---- what came of it */

/* What does not hold, and where. */
static void say_unmet(const struct toolpath *t)
{
    const struct gouge_lift_report *r = &t->report;
    struct unmets *unmet = &t->path->head.unmet;
    struct unmets *uncut = t->rule.avoid ? NULL : unmet, *out = t->rule.skip ? NULL : unmet;
    struct vec3 at = r->unreachable_at;

    if (r->unreachable > 0)
        unmet_say(
            uncut,
            "the ball cannot reach %zu points of the path with a lift of at most %g mm and skips "
            "them, worst in pass %zu by %.3f mm at %.3f %.3f %.3f",
            r->unreachable, t->lift.limit, t->unreachable_pass, r->unreachable_by, at.x, at.y,
            at.z);
    at = t->uncut_at;
    if (t->uncut_places > 0)
        unmet_say(
            uncut,
            "the ball does not fit at %zu points of the path and leaves material there, worst in "
            "pass %zu, %.3f mm at %.3f %.3f %.3f",
            t->uncut_places, t->uncut_pass, t->uncut_height, at.x, at.y, at.z);
    if ((r->unreachable > 0 || t->uncut_places > 0) && !t->rule.avoid)
        say("a smaller ball must remove it; --avoid accepts it");
    at = t->blocked_at;
    if (t->blocked > 0)
        unmet_say(
            out,
            "no way between the clearance plane and %zu run%s is clear for the whole tool: left "
            "out, %.1f mm2, the first in pass %zu at %.3f %.3f %.3f",
            t->blocked, t->blocked == 1 ? "" : "s", t->blocked_area, t->blocked_pass, at.x, at.y,
            at.z);
    at = t->skipped_at;
    if (t->skipped > 0)
        unmet_say(
            out,
            "no direction of the axis keeps flute, shank and holder clear at %zu points, about "
            "%.1f mm2: left out, the first in pass %zu at %.3f %.3f %.3f",
            t->skipped, t->skipped_area, t->skipped_pass, at.x, at.y, at.z);
    if (t->shank > 0)
        unmet_say(
            unmet,
            "at %zu points the normal is more than 90 degrees off the axis: the shank touches "
            "there, not the ball",
            t->shank);
}

int toolpath_conclude(const struct toolpath *t)
{
    const struct gouge_lift_report *r = &t->report;

    note("%zu points in %zu passes, %zu links with the tool down, %zu over the clearance plane",
         r->points, t->pass, t->low, t->high);
    if (t->slivers > 0)
        note("%zu runs shorter than the radius left out: their neighbours cut all of them",
             t->slivers);
    note("%zu points lifted, at most by %.4f mm at %.3f %.3f %.3f", r->lifted, r->highest,
         r->highest_at.x, r->highest_at.y, r->highest_at.z);
    if (t->rule.holder.n > 0)
        note("axes at most %.2f degrees off their rule", DEGREES(t->leaned));
    if (t->lift.between)
        note("straight lines within %g mm of the lifted path", t->lift.tolerance);
    else
        note("straight lines up to %.4f mm from the smooth path", t->chord);
    say_unmet(t);
    bool left = (r->unreachable > 0 || t->uncut_places > 0) && !t->rule.avoid;
    left = left || ((t->skipped > 0 || t->blocked > 0) && !t->rule.skip);
    left = path_check_conclude(&t->check, &t->path->head.unmet) != EXIT_DONE || left;
    return left || t->shank > 0 ? EXIT_UNMET : EXIT_DONE;
}
