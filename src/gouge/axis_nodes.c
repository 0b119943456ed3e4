/* axis_nodes - see axis_plan_steps.h: nodes along a run, and what is open at them. */
#include <stdlib.h>

#include "axis_plan_steps.h"

static const double NODES = 0.4;         /* of the radius: between nodes, at most */
static const double ROUND = RADIANS(45); /* about the rule: further off only where none is open */

/* The place at `along` on the straight lines between the points. */
struct run_point axis_nodes_place(const struct work *w, size_t after, double along)
{
    const struct run_point *a = &w->run->item[after > 0 ? after - 1 : 0], *b = &w->run->item[after];
    double from = w->along[after > 0 ? after - 1 : 0], length = w->along[after] - from;
    double s = length > 0 ? (along - from) / length : 1;
    struct run_point p = *b;

    if (s >= 1)
        return p;
    p = (struct run_point){.ball = vec_mix(a->ball, b->ball, s),
                           .axis = vec_slerp(a->axis, b->axis, s)};
    if (run_point_touches(a) && run_point_touches(b)) {
        p.normal = vec_slerp(a->normal, b->normal, s);
        p.contact = vec_mix(a->contact, b->contact, s);
    }
    return p;
}

static void add_node(struct nodes *nodes, const struct run_point *p, double along, bool strict)
{
    *array_push(nodes) = (struct node){
        .along = along, .ball = p->ball, .normal = p->normal, .rule = p->axis, .strict = strict};
}

static int by_along(const void *a, const void *b)
{
    double x = ((const struct node *)a)->along, y = ((const struct node *)b)->along;

    return (x > y) - (x < y);
}

/* Nodes at the run's ends and evenly between, and at points where it turns sharply. */
void axis_nodes_first(struct work *w)
{
    double length = w->along[w->run->n - 1], last = 0;
    double step = NODES * w->planner->options.radius;

    step = length > 0 ? length / ceil(length / step) : step;

    add_node(&w->nodes, &w->run->item[0], 0, false);
    for (size_t i = 1; i < w->run->n; i++) {
        bool sharp = vec_dot(w->run->item[i].axis, w->run->item[i - 1].axis) < 0.99;
        while (last + step < w->along[i] - 1e-9) {
            last += step;
            struct run_point p = axis_nodes_place(w, i, last);
            add_node(&w->nodes, &p, last, false);
        }
        if (i + 1 == w->run->n || sharp)
            add_node(&w->nodes, &w->run->item[i], w->along[i], false);
    }
}

void axis_nodes_find_open(const struct axis_planner *p, struct node *node)
{
    size_t n = (size_t)p->grid.n;

    if (node->state)
        return;
    node->state = mem_alloc(n, 1);
    for (double within = fmin(ROUND, p->options.limit); node->open == 0;
         within = p->options.limit) {
        access_find(p->access, node->ball, node->normal, node->rule, within, node->state);
        for (size_t i = 0; i < n; i++) {
            if (!p->reached[i])
                node->state[i] = ACCESS_BLOCKED;
            node->open += node->state[i] != ACCESS_BLOCKED;
        }
        if (within >= p->options.limit)
            break;
    }
    node->rule_open =
        rotary_allows(&p->options.chain, node->rule) && vec_dot(node->rule, node->normal) > -1e-6 &&
        (node->open > 0 && !p->options.fixed ? access_is_open
                                             : access_is_clear)(p->access, node->ball, node->rule);
}

/* A strict node at a place of the path, which is no later than the point `after`. */
void axis_nodes_add_strict(struct work *w, size_t after, double along)
{
    while (after > 0 && w->along[after - 1] >= along)
        after--;
    struct run_point place = axis_nodes_place(w, after, along);
    add_node(&w->nodes, &place, along, true);
}

/* A node wherever the axis goes past the pole between two: there the way is through it. */
void axis_nodes_add_poles(struct work *w)
{
    size_t n = w->nodes.n;

    for (size_t i = 1, after = 0; i < n; i++) {
        const struct node a = w->nodes.item[i - 1], b = w->nodes.item[i];
        double s = axis_nodes_has_axis(&a) && axis_nodes_has_axis(&b) && !b.begins &&
                           !(a.by_rule && b.by_rule)
                       ? rotary_pole_between(a.angles, b.angles)
                       : -1;
        double along = a.along + s * (b.along - a.along);
        if (s < 0)
            continue;
        while (after + 1 < w->run->n && w->along[after] < along)
            after++;
        struct run_point place = axis_nodes_place(w, after, along);
        add_node(&w->nodes, &place, along, false);
        struct node *pole = &w->nodes.item[w->nodes.n - 1];
        pole->pole = true;
        pole->open = 1;
        pole->angles = rotary_angles_between(a.angles, b.angles, s);
        pole->angles.lean = 0;
        pole->axis = rotary_axis(&w->planner->frame, pole->angles);
        pole->allow = fmax(a.allow, b.allow);
    }
    qsort(w->nodes.item, w->nodes.n, sizeof *w->nodes.item, by_along);
}

/* Nodes in order, those in one place as one, which is strict if one of them is. */
void axis_nodes_sort(struct nodes *nodes)
{
    size_t kept = 0;

    qsort(nodes->item, nodes->n, sizeof *nodes->item, by_along);
    for (size_t i = 0; i < nodes->n; i++) {
        struct node *last = &nodes->item[kept > 0 ? kept - 1 : 0], *node = &nodes->item[i];
        if (node->pole)
            continue;
        if (kept > 0 && node->along - last->along < 1e-6) {
            last->strict = last->strict || node->strict;
            free(node->state);
        } else {
            nodes->item[kept++] = *node;
        }
    }
    nodes->n = kept;
}
