/*
 * axis_plan_steps - how the axes of a run are planned (gouge/axis_plan.h), step by step: nodes
 * along the run and what is open there (axis_nodes.c), which direction each gets (axis_choose.c),
 * their angles made smooth (axis_settle.c), and the points of the run with these axes
 * (axis_points.c). Lengths in mm, angles in radians; a step changes nothing but the nodes, or the
 * points, that it is given.
 */
#ifndef CLOUDMILL_AXIS_PLAN_STEPS_H
#define CLOUDMILL_AXIS_PLAN_STEPS_H

#include "access.h"
#include "gouge/axis_plan.h"
#include "machine/rotary_cost.h"

enum { AXIS_NEIGHBOURS = 48 };

/* How far axes in the air are off their rule for little. */
#define AXIS_AIR RADIANS(60)

/* Of play: kept for what the turn is off beside the pole. */
#define AXIS_SPARE RADIANS(0.6)

/* Directions of the grid beside one, itself among them. */
struct neighbours {
    int n;
    int index[AXIS_NEIGHBOURS];
    float travel[AXIS_NEIGHBOURS]; /* of the rotary axes */
};

struct axis_planner {
    struct axis_planner_options options;
    struct sphere_grid grid;
    struct access *access;
    struct rotary_frame frame;
    struct rotary_leaning *leaning; /* each direction of the grid, in that frame */
    bool *reached;                  /* by the machine, each of them */
    struct neighbours *beside;
};

/* A place of the path at which an axis is chosen. */
struct node {
    double along; /* the path of the ball's centre, mm */
    struct vec3 ball, normal;
    struct vec3 rule;     /* axis by the rule */
    unsigned char *state; /* of the directions of the grid; NULL: not yet found */
    int open;             /* how many are */
    bool rule_open;
    bool strict; /* the grid is not fine enough here: each axis is checked */
    bool pole;   /* put between two others, where the axis is at the pole; for this round alone */

    struct vec3 axis; /* that it gets */
    bool by_rule;     /* which is the rule's */
    bool begins;      /* can't be come to from the node before */
    double allow;     /* how far the axis may be off its rule, radians */
    struct rotary_angles angles;
};

struct nodes {
    size_t n, cap;
    struct node *item;
};

/* A point as it was in a round: how far the tool is clear there, and whether it is on the way from
 * the point before. */
struct axis_checked {
    double along;
    struct vec3 ball, axis;
    double clear;
    enum { WAY_UNKNOWN, WAY_CLEAR, WAY_BLOCKED } way;
};

struct axis_checks {
    size_t n, cap;
    struct axis_checked *item;
};

/* A run and where its points are along the path. */
struct work {
    const struct axis_planner *planner;
    const struct run *run;
    double *along; /* of each point */
    struct nodes nodes;
    struct axis_checks checked; /* in the round before */
};

/* ---- axis_nodes.c */

/* The place at `along` on the straight line that leads to the point `after`. */
struct run_point axis_nodes_place(const struct work *w, size_t after, double along);

/* Nodes at the run's ends and evenly between, and at points where it turns sharply. */
void axis_nodes_first(struct work *w);

/* A node at a place of the path, which is no later than the point `after`, where each axis is
 * checked by itself. */
void axis_nodes_add_strict(struct work *w, size_t after, double along);

/* A node wherever the axis goes past the pole between two: there the way is through it. */
void axis_nodes_add_poles(struct work *w);

/* Nodes in order, those in one place as one, which is strict if one of them is; none at the
 * pole. */
void axis_nodes_sort(struct nodes *nodes);

/* Which directions of the grid are open at the node, and whether the rule's is; once. */
void axis_nodes_find_open(const struct axis_planner *p, struct node *node);

/* The node has an axis: any direction is open there. */
static inline bool axis_nodes_has_axis(const struct node *node)
{
    return node->open > 0 || node->rule_open;
}

/* ---- axis_choose.c */

/* How the directions lean, which the rest asks. */
void axis_choose_leanings(struct axis_planner *p);

/* The directions that are neighbours of direction i, and what the rotary axes turn to them. */
void axis_choose_neighbours(struct axis_planner *p, int i);

/* The play that the choice of axes has: less by what is spared. */
double axis_choose_play(const struct axis_planner *p);

/* Axes of the nodes [from, to), each of which has an open one, by dynamic programming; where one
 * can't be come to from the one before, it begins anew. */
void axis_choose(const struct work *w, size_t from, size_t to);

/* ---- axis_settle.c */

/* The angles of the nodes [from, to), none of which but the first begins anew, made smooth. */
void axis_settle(const struct work *w, size_t from, size_t to);

/* ---- axis_points.c */

/* Neither the node `at` nor the one after it, among the first n, has an axis. */
bool axis_points_without(const struct work *w, size_t n, size_t at);

/* Appends the points of the run with their axes and, if any may be put between, those nodes where
 * the axis is not on the straight line; `along`: where each is. */
void axis_points_put(const struct work *w, struct run *to, struct doubles *along);

#endif
