/* axis_choose - see axis_plan_steps.h: which direction each node gets, by dynamic programming. */
#include <stdlib.h>

#include "axis_plan_steps.h"

static const double STEP = 0.23;  /* radians: neighbouring directions are no further apart */
static const double NEAR = 0.004; /* cost per mm of an axis that is off by all of `play` */
static const double FAR = 20;     /* cost per mm and radian beyond */
static const double ALIKE = 0.1;  /* radians: directions so much further off are as good */
static const double JUMP = 12;    /* cost of an axis that can't be come to from the last */
static const double SUDDEN = 0.6; /* radians between nodes beyond the rule's: lift instead */

static struct rotary_leaning leaning_of(const struct rotary_frame *f, struct vec3 a)
{
    return rotary_leaning_of(vec(vec_dot(a, f->x), vec_dot(a, f->y), vec_dot(a, f->pole)));
}

static double travel_between(const struct rotary_frame *f, const struct rotary_leaning *a,
                             const struct rotary_leaning *b)
{
    return f->both ? rotary_leaning_travel(a, b) : rotary_leaning_travel_one(a, b);
}

void axis_choose_leanings(struct axis_planner *p)
{
    p->leaning = mem_alloc((size_t)p->grid.n, sizeof *p->leaning);
    for (int i = 0; i < p->grid.n; i++)
        p->leaning[i] = leaning_of(&p->frame, p->grid.at[i]);
}

void axis_choose_neighbours(struct axis_planner *p, int i)
{
    struct neighbours *beside = &p->beside[i];

    for (int j = 0; j < p->grid.n; j++) {
        if (beside->n == AXIS_NEIGHBOURS || vec_dot(p->grid.at[i], p->grid.at[j]) < cos(STEP))
            continue;
        beside->index[beside->n] = j;
        beside->travel[beside->n++] =
            (float)travel_between(&p->frame, &p->leaning[i], &p->leaning[j]);
    }
}

/* The cheapest way to each direction at a node; the last one is the rule's. */
struct step {
    double *cost;
    short *from;
    struct rotary_leaning rule;
};

/* The play that the choice of axes has: less by what is spared. */
double axis_choose_play(const struct axis_planner *p)
{
    return p->options.play > 4 * AXIS_SPARE ? p->options.play - AXIS_SPARE : p->options.play;
}

/* How far off the rule costs little: play, or what is open nearest to it and a little more. */
static double free_zone(const struct axis_planner *p, const struct node *node)
{
    double nearest = -1;

    if (vec_length(node->normal) == 0 && p->options.play > 0)
        return AXIS_AIR;
    if (node->rule_open)
        return axis_choose_play(p);
    for (int j = 0; j < p->grid.n; j++)
        if (node->state[j] != ACCESS_BLOCKED)
            nearest = fmax(nearest, vec_dot(p->grid.at[j], node->rule));
    double off = acos(fmin(nearest, 1));
    return off > axis_choose_play(p) ? off + ALIKE : axis_choose_play(p);
}

/* What it costs to be off the rule, after what it cost to come.  HUGE_VAL: surely more than `most`,
 * from where a jump leads anywhere: the angle is no less than its chord. */
static double cost_off(double zone, const struct node *node, struct vec3 axis, double length,
                       double come, double most)
{
    const double rounding = 1e-6;
    double off2 = 2 - 2 * vec_dot(axis, node->rule);

    if (off2 <= zone * zone)
        return come + (zone > 0 ? NEAR * length * off2 / (zone * zone) : 0);
    if (come + length * (NEAR + FAR * (sqrt(off2) - zone)) > most + rounding)
        return HUGE_VAL;
    return come + length * (NEAR + FAR * (acos(1 - off2 / 2) - zone));
}

static int nearest_of_grid(const struct axis_planner *p, struct vec3 axis)
{
    int corner[4], best;

    sphere_grid_corners(&p->grid, axis, corner);
    best = corner[0];
    for (int k = 1; k < 4; k++)
        if (vec_dot(p->grid.at[corner[k]], axis) > vec_dot(p->grid.at[best], axis))
            best = corner[k];
    return best;
}

/* Offers the rule's axis at the node before as the one to come from. */
static void come_from_rule(const struct axis_planner *p, const struct node *before,
                           const struct step *last, const struct node *node, struct step *now)
{
    const struct neighbours *beside = &p->beside[nearest_of_grid(p, before->rule)];

    for (int k = 0; before->rule_open && k < beside->n; k++) {
        int j = beside->index[k];
        if (node->state[j] == ACCESS_BLOCKED || last->cost[p->grid.n] >= now->cost[j])
            continue;
        double cost =
            last->cost[p->grid.n] + travel_between(&p->frame, &last->rule, &p->leaning[j]);
        if (cost < now->cost[j]) {
            now->cost[j] = cost;
            now->from[j] = (short)p->grid.n;
        }
    }
}

/* Finds where to come from to the rule's axis. */
static void come_to_rule(const struct axis_planner *p, const struct node *before,
                         const struct step *last, const struct node *node, struct step *now)
{
    const struct neighbours *beside = &p->beside[nearest_of_grid(p, node->rule)];
    int rule = p->grid.n;

    if (before->rule_open) {
        now->cost[rule] = last->cost[rule] + travel_between(&p->frame, &last->rule, &now->rule);
        now->from[rule] = (short)rule;
    }
    for (int k = 0; k < beside->n; k++) {
        int j = beside->index[k];
        if (before->state[j] == ACCESS_BLOCKED || last->cost[j] >= now->cost[rule])
            continue;
        double cost = last->cost[j] + travel_between(&p->frame, &p->leaning[j], &now->rule);
        if (cost < now->cost[rule]) {
            now->cost[rule] = cost;
            now->from[rule] = (short)j;
        }
    }
}

static void come_by_grid(const struct axis_planner *p, const struct step *last,
                         const struct node *node, struct step *now)
{
    for (int j = 0; j < p->grid.n; j++) {
        const struct neighbours *beside = &p->beside[j];
        if (node->state[j] == ACCESS_BLOCKED)
            continue;
        for (int k = 0; k < beside->n; k++) {
            double cost = last->cost[beside->index[k]] + beside->travel[k];
            if (cost < now->cost[j]) {
                now->cost[j] = cost;
                now->from[j] = (short)beside->index[k];
            }
        }
    }
}

static int cheapest(const struct step *step, int n)
{
    int best = 0;

    for (int j = 1; j < n; j++)
        if (step->cost[j] < step->cost[best])
            best = j;
    return best;
}

static struct step new_step(const struct axis_planner *p, const struct node *node)
{
    size_t n = (size_t)p->grid.n + 1;
    struct step s = {mem_alloc(n, sizeof *s.cost), mem_alloc(n, sizeof *s.from),
                     leaning_of(&p->frame, node->rule)};

    for (size_t j = 0; j < n; j++) {
        s.cost[j] = HUGE_VAL;
        s.from[j] = -1;
    }
    return s;
}

/* The step to node i, from the one before unless it is the first; what was dear is come to by a
 * jump. */
static void take_step(const struct axis_planner *p, const struct node *node, bool first,
                      double length, const struct step *last, struct step *now)
{
    int n = p->grid.n + 1, best = first ? -1 : cheapest(last, n);
    double zone = free_zone(p, node), start = first ? 0 : last->cost[best] + JUMP;

    if (!first) {
        come_by_grid(p, last, node, now);
        come_from_rule(p, node - 1, last, node, now);
        if (node->rule_open)
            come_to_rule(p, node - 1, last, node, now);
    }
    double least = HUGE_VAL;
    for (int j = n - 1; j >= 0; j--) { /* the rule's first: mostly it is the cheapest */
        bool rule = j + 1 == n, open = rule ? node->rule_open : node->state[j] != ACCESS_BLOCKED;
        if (!open)
            continue;
        if (start < now->cost[j]) {
            now->cost[j] = start;
            now->from[j] = (short)best;
        }
        now->cost[j] = cost_off(zone, node, rule ? node->rule : p->grid.at[j], length, now->cost[j],
                                least + JUMP);
        least = fmin(least, now->cost[j]);
    }
}

/* Axes of the nodes [from, to), each of which has an open one. */
void axis_choose(const struct work *w, size_t from, size_t to)
{
    const struct axis_planner *p = w->planner;
    struct step *step = mem_alloc(to - from, sizeof *step);
    struct node *node = &w->nodes.item[from];

    for (size_t i = 0; i < to - from; i++) {
        double before = i > 0 ? node[i].along - node[i - 1].along : 0;
        double after = i + 1 < to - from ? node[i + 1].along - node[i].along : 0;
        step[i] = new_step(p, &node[i]);
        take_step(p, &node[i], i == 0, 0.01 + (before + after) / 2, i > 0 ? &step[i - 1] : NULL,
                  &step[i]);
    }
    int at = cheapest(&step[to - from - 1], p->grid.n + 1);
    for (size_t i = to - from; i-- > 0; at = step[i].from[at]) {
        node[i].by_rule = at == p->grid.n;
        node[i].axis = node[i].by_rule ? node[i].rule : p->grid.at[at];
    }
    for (size_t i = 0; i < to - from; i++) {
        free(step[i].cost);
        free(step[i].from);
        node[i].begins = i == 0 || vec_angle(node[i].axis, node[i - 1].axis) >
                                       vec_angle(node[i].rule, node[i - 1].rule) + SUDDEN;
    }
    free(step);
}
