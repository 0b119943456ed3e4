/* toolpath_moves - parts, and what leads from one to the next, put into the path. */
#include <stdlib.h>

#include "toolpath_parts.h"

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

double toolpath_axis_lean(struct vec3 axis)
{
    return vec_angle(axis, vec(0, 0, 1));
}

/* z of the tip at which the tool may turn from one axis to another. */
static double turning_height(const struct toolpath *t, struct vec3 a, struct vec3 b)
{
    struct link_options options = toolpath_link_options(t);

    return link_height(&options, 0, fmax(toolpath_axis_lean(a), toolpath_axis_lean(b)));
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

/* The straight way from one axis to another leaves the travel, and that by the pole does not. */
static bool turns_by_pole(const struct toolpath *t, struct vec3 from, struct vec3 to)
{
    const double upright = 0.9; /* cosine */
    const struct kinematic_chain *chain = &t->rule.chain;
    struct vec3 pole = t->frame.pole;

    return pole.z > upright && !rotary_reaches_between(chain, from, to) &&
           rotary_reaches_between(chain, from, pole) && rotary_reaches_between(chain, pole, to);
}

/* Over the part, by way of an axis that leans less where the turn to this one would dip into it, or
 * by the pole where the rotary axes do not travel so far. */
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
    else if (turns_by_pole(t, now.a, axis))
        add_point(t, (struct pose){now.p, t->frame.pole}, true);
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

bool toolpath_is_blocked(const struct toolpath_part *part, size_t points)
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

void toolpath_add_part(struct toolpath *t, const struct toolpath_part *part)
{
    const struct toolpath_strip *strip = &t->strip.item[part->strip];
    struct run run = toolpath_part_run(t, part);

    t->lift = strip->lift;
    if (toolpath_is_blocked(part, run.n)) {
        add_blocked(t, strip->pass, &run);
        if (t->down)
            retract(t, vec(0, 0, 1));
        return;
    }
    link_to(t, strip->pass, part);
    add_cut(t, run.item, run.n);
    t->last = *part;
}

void toolpath_add_end(struct toolpath *t)
{
    if (!t->down)
        return;
    retract(t, vec(0, 0, 1));
    end_over_plane(t);
}
