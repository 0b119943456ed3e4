/* axis_points - see axis_plan_steps.h: the points of a run with the axes of its nodes. */
#include <stdlib.h>

#include "axis_plan_steps.h"

static const double SHORTEST = 0.0205; /* mm: no piece of a program should be shorter */
static const double AT_POLE = 1e-4;    /* radians: an axis that leans less has no say in its turn */
static const double BENT = RADIANS(0.15); /* an axis further off the straight line gets a point */

static void set_axis(struct run_point *p, double radius, struct vec3 axis)
{
    p->axis = axis;
    p->tip = vec_along(p->ball, -radius, axis);
}

/* The axis at a place of the path between the nodes `at` and at + 1, or of the one that has any. */
static struct vec3 axis_between(const struct work *w, size_t at, const struct run_point *p,
                                double along)
{
    const struct node *a = &w->nodes.item[at], *b = at + 1 < w->nodes.n ? a + 1 : a;

    if (!axis_nodes_has_axis(a) || !axis_nodes_has_axis(b))
        return axis_nodes_has_axis(a) ? a->axis : axis_nodes_has_axis(b) ? b->axis : p->axis;
    const struct kinematic_chain *chain = &w->planner->options.chain;
    if (a->by_rule && b->by_rule && rotary_allows(chain, p->axis))
        return p->axis;
    double length = b->along - a->along, s = length > 0 ? (along - a->along) / length : 0;
    if (b->begins)
        return s < 0.5 ? a->axis : b->axis;
    struct rotary_angles to = rotary_angles_between(a->angles, b->angles, fmin(fmax(s, 0), 1));
    struct vec3 axis = rotary_axis(&w->planner->frame, to);
    double off = vec_angle(axis, p->axis), most = fmax(a->allow, b->allow);
    /* by a little, for the angles go straight between nodes; by more the rule itself jumps */
    return off > most && off < most + 0.02 ? vec_slerp(p->axis, axis, most / off) : axis;
}

/* Neither the node `at` nor the one after it, among the first n, has an axis. */
bool axis_points_without(const struct work *w, size_t n, size_t at)
{
    return !axis_nodes_has_axis(&w->nodes.item[at]) &&
           !axis_nodes_has_axis(&w->nodes.item[at + 1 < n ? at + 1 : at]);
}

/* Appends a point, and before it, if it is joined to the last, as many on the straight line of the
 * ball's centre that a tip that goes straight does not swing the ball off it by more than may be.
 * An axis that would leave its travel on the way is not turned: check_points parts the run
 * there. */
static void put_point(const struct work *w, size_t after, struct run_point end, double at,
                      bool joined, struct run *to, struct doubles *along)
{
    const struct axis_planner_options *o = &w->planner->options;

    if (to->n > 0 && joined && o->between &&
        rotary_reaches_between(&o->chain, to->item[to->n - 1].axis, end.axis)) {
        const struct run_point last = to->item[to->n - 1];
        double from = along->item[along->n - 1];
        double parts = ceil(vec_angle(last.axis, end.axis) / sqrt(0.8 * o->tolerance / o->radius));
        for (double k = 1; k < parts && at > from; k++) {
            struct run_point p = axis_nodes_place(w, after, from + k / parts * (at - from));
            set_axis(&p, to->radius, vec_slerp(last.axis, end.axis, k / parts));
            *array_push(to) = p;
            *array_push(along) = from + k / parts * (at - from);
        }
    }
    *array_push(to) = end;
    *array_push(along) = at;
}

/* A point of the run so near to where the axis passes the pole that it passes it there. */
static bool meets_pole(const struct node *node, struct run_point *p, double apart, double radius)
{
    bool meets = node->pole && apart < SHORTEST && vec_angle(p->axis, node->axis) < AT_POLE;

    if (meets)
        set_axis(p, radius, node->axis);
    return meets;
}

/* Appends the points of the run with their axes and, if any may be put between, those nodes where
 * the axis is not on the straight line. */
void axis_points_put(const struct work *w, struct run *to, struct doubles *along)
{
    const struct nodes *nodes = &w->nodes;
    size_t at = 0;
    bool joined = false; /* the last point has an axis to go on from */

    for (size_t i = 0; i < w->run->n; i++) {
        struct run_point end = w->run->item[i];
        size_t first = at;
        while (at + 1 < nodes->n && nodes->item[at + 1].along <= w->along[i])
            at++;
        set_axis(&end, to->radius, axis_between(w, at, &end, w->along[i]));
        for (size_t k = first + 1; i > 0 && k <= at && w->planner->options.between; k++) {
            const struct node *node = &nodes->item[k];
            struct run_point *last = &to->item[to->n - 1];
            double from = along->item[along->n - 1];
            if (node->along <= from || node->along >= w->along[i] || !axis_nodes_has_axis(node) ||
                meets_pole(node, &end, w->along[i] - node->along, to->radius) ||
                meets_pole(node, last, node->along - from, to->radius) ||
                (!node->pole && vec_angle(vec_slerp(last->axis, end.axis,
                                                    (node->along - from) / (w->along[i] - from)),
                                          node->axis) < BENT))
                continue;
            struct run_point p = axis_nodes_place(w, i, node->along);
            set_axis(&p, to->radius, node->axis);
            put_point(w, i, p, node->along, joined, to, along);
            joined = true;
        }
        bool none = axis_points_without(w, nodes->n, at);
        put_point(w, i, end, w->along[i], joined && !none, to, along);
        joined = !none;
    }
}
