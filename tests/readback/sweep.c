#include "sweep.h"

#include "base/array.h"
#include "ncread/ncread.h"

#include <stdlib.h>

#define STEP_TIP 0.25          /* longest piece of a chain, mm ... */
#define STEP_AXIS RADIANS(0.5) /* ... and its turn */
#define FLAT_TIP 1e-5          /* how straight it is, mm */
#define FLAT_AXIS RADIANS(0.001)
#define RAPID_OFF 1.01 /* how far a rapid may be off its straight way, mm */
#define DETOUR 2.0     /* longest way that one may make and the other not, mm */

static double apart(struct nc_motion_pose a, struct nc_motion_pose b, double weight)
{
    return vec_distance(a.p, b.p) + weight * vec_angle(a.a, b.a);
}

static void add(struct samples *chain, struct nc_motion_pose pose, bool joined, size_t piece)
{
    double length = chain->n ? chain->item[chain->n - 1].length : 0;
    if (joined)
        length += apart(chain->item[chain->n - 1].pose, pose, chain->weight);
    *array_push(chain) =
        (struct sample){.pose = pose, .joined = joined, .length = length, .piece = piece};
}

/* Halves the piece from s0 to s1 until it is straight; adds its end. */
static void flatten(const struct nc_motion *nc_motion, size_t index, double s0,
                    struct nc_motion_pose a, double s1, struct nc_motion_pose b, int depth,
                    struct samples *chain)
{
    const struct nc_piece *piece = &nc_motion->piece.item[index];
    double s = (s0 + s1) / 2;
    struct nc_motion_pose m = nc_motion_at(nc_motion, piece, s);
    struct vec3 turn = vec_unit(vec_add(a.a, b.a));
    bool straight = vec_distance(m.p, vec_mix(a.p, b.p, 0.5)) <= FLAT_TIP &&
                    vec_angle(m.a, turn) <= FLAT_AXIS && vec_distance(a.p, b.p) <= STEP_TIP &&
                    vec_angle(a.a, b.a) <= STEP_AXIS;
    /* two halvings at least: a full turn ends where it begins */
    if ((straight && depth >= 2) || depth > 20) {
        add(chain, b, true, index);
        return;
    }
    flatten(nc_motion, index, s0, a, s, m, depth + 1, chain);
    flatten(nc_motion, index, s, m, s1, b, depth + 1, chain);
}

/* The tool comes back to where it had left the cut, down its own axis from no more than 3 mm. */
static bool comes_back(struct nc_motion_pose a, struct nc_motion_pose b, struct nc_motion_pose left)
{
    struct vec3 way = vec_sub(a.p, b.p);
    return vec_distance(b.p, left.p) < 0.005 && vec_angle(b.a, left.a) < RADIANS(0.1) &&
           vec_length(way) < 3 && vec_angle(way, b.a) < RADIANS(0.5);
}

void sweep_chain(const struct nc_motion *nc_motion, struct samples *chain)
{
    bool apart_before = true;
    for (size_t i = 0; i < nc_motion->piece.n; i++) {
        const struct nc_piece *piece = &nc_motion->piece.item[i];
        if (piece->rapid) {
            apart_before = true;
            continue;
        }
        struct nc_motion_pose a = nc_motion_at(nc_motion, piece, 0),
                              b = nc_motion_at(nc_motion, piece, 1);
        if (apart_before && chain->n && piece->shape == SHAPE_LINE &&
            comes_back(a, b, chain->item[chain->n - 1].pose))
            continue;
        if (apart_before)
            add(chain, a, false, i);
        apart_before = false;
        flatten(nc_motion, i, 0, a, 1, b, 0, chain);
    }
}

static bool is_line(const struct nc_piece *piece)
{
    return piece->shape == SHAPE_LINE && !piece->rapid;
}

/* On the line through the cut, from its start on, no further than `beyond` behind its end. */
static bool along(const struct nc_piece *cut, struct vec3 p, double beyond)
{
    struct vec3 way = vec_sub(cut->p[1], cut->p[0]), to = vec_sub(p, cut->p[1]);
    struct vec3 unit = vec_unit(way);
    double length = vec_length(way), s = vec_dot(to, unit);
    return vec_length(vec_reject(to, unit)) < 1e-6 && s >= -length - 1e-6 && s <= beyond;
}

/* The next step of the hole that this cut is part of, 0: there is none. */
static size_t next_step(const struct nc_motion *nc_motion, size_t i)
{
    const struct nc_piece *cut = &nc_motion->piece.item[i];
    size_t k = i + 1;
    while (k < nc_motion->piece.n && nc_motion->piece.item[k].rapid &&
           along(cut, nc_motion->piece.item[k].p[1], 0))
        k++;
    if (k == i + 1 || k == nc_motion->piece.n || !is_line(&nc_motion->piece.item[k]))
        return 0;
    const struct nc_piece *next = &nc_motion->piece.item[k];
    bool deeper = along(cut, next->p[1], HUGE_VAL) && !along(cut, next->p[1], 0);
    return deeper && along(cut, next->p[0], 0) ? k : 0;
}

void sweep_join_steps(struct nc_motion *nc_motion)
{
    size_t n = 0, next;
    for (size_t i = 0; i < nc_motion->piece.n; i++) {
        struct nc_piece *cut = &nc_motion->piece.item[n++];
        *cut = nc_motion->piece.item[i];
        if (!is_line(cut) || vec_distance(cut->p[0], cut->p[1]) == 0)
            continue;
        nc_motion->piece.item[i] = *cut;
        while ((next = next_step(nc_motion, i)) != 0) {
            nc_motion->piece.item[next].p[0] = cut->p[0];
            *cut = nc_motion->piece.item[next];
            i = next;
        }
    }
    nc_motion->piece.n = n;
}

double sweep_length(const struct samples *chain)
{
    double length = 0;
    for (size_t i = 1; i < chain->n; i++)
        if (chain->item[i].joined)
            length += vec_distance(chain->item[i - 1].pose.p, chain->item[i].pose.p);
    return length;
}

static double ball_miss(struct nc_motion_pose a, struct nc_motion_pose b, double radius)
{
    return vec_distance(vec_along(a.p, radius, a.a), vec_along(b.p, radius, b.a));
}

/* The worst of tip, ball and axis: what of the limits a pairing uses, as mm. */
static double misses(struct nc_motion_pose a, struct nc_motion_pose b, const struct samples *chain)
{
    double points = fmax(vec_distance(a.p, b.p), ball_miss(a, b, chain->radius));
    return fmax(points, chain->weight * vec_angle(a.a, b.a));
}

/*
 * The place of segment i (from sample i - 1 to i, or sample i alone) that is nearest to a pose: of
 * those nearest by tip, by axis, by both, and by the ball.
 */
static double nearest_on(const struct samples *chain, size_t i, struct nc_motion_pose pose,
                         double *length, struct nc_motion_pose *found)
{
    const struct sample *b = &chain->item[i], *a = b->joined ? b - 1 : b;
    struct vec3 dp = vec_sub(b->pose.p, a->pose.p), ep = vec_sub(pose.p, a->pose.p);
    struct vec3 da = vec_sub(b->pose.a, a->pose.a), ea = vec_sub(pose.a, a->pose.a);
    double w2 = chain->weight * chain->weight, best = HUGE_VAL;
    const double tip2 = vec_dot(dp, dp), axis2 = w2 * vec_dot(da, da);
    const double tip = vec_dot(dp, ep), axis = w2 * vec_dot(da, ea);
    const struct vec3 ball = vec_along(dp, chain->radius, da);
    const double along[] = {tip, axis, tip + axis, vec_dot(ball, vec_along(ep, chain->radius, ea))};
    const double far[] = {tip2, axis2, tip2 + axis2, vec_dot(ball, ball)};
    for (int k = 0; k < 4; k++) {
        double s = far[k] > 0 ? fmin(fmax(along[k] / far[k], 0), 1) : 0;
        struct nc_motion_pose at = {vec_mix(a->pose.p, b->pose.p, s),
                                    vec_unit(vec_mix(a->pose.a, b->pose.a, s))};
        double miss = misses(pose, at, chain);
        if (miss >= best)
            continue;
        best = miss;
        *found = at;
        *length = a->length + s * (b->length - a->length);
    }
    return best;
}

/* A place on a chain: how far along, and the pose there. */
struct match {
    double length;
    struct nc_motion_pose pose;
    double apart;
};

/* The nearest place of a chain between two lengths; *begin: the first sample worth looking at. */
static struct match nearest_between(const struct samples *to, double from_length, double to_length,
                                    struct nc_motion_pose pose, size_t *begin)
{
    struct match best = {from_length, pose, HUGE_VAL};
    while (*begin + 1 < to->n && to->item[*begin + 1].length < from_length)
        ++*begin;
    for (size_t k = *begin; k < to->n; k++) {
        const struct sample *end = &to->item[k];
        struct match found;
        if ((end->joined ? end[-1].length : end->length) > to_length)
            break;
        found.apart = nearest_on(to, k, pose, &found.length, &found.pose);
        if (found.apart < best.apart)
            best = found;
    }
    return best;
}

struct sweep sweep_walk(const struct samples *from, const struct samples *to, double tip_limit,
                        double axis_limit)
{
    struct sweep sweep = {0};
    size_t begin = 0;
    double here = 0, slack = 0.05 + 2 * tip_limit;
    for (size_t i = 0; i < from->n; i++) {
        const struct sample *sample = &from->item[i];
        double step = i > 0 ? sample->length - sample[-1].length : 0;
        struct match match =
            nearest_between(to, here - slack, here + step + slack, sample->pose, &begin);
        double tip = vec_distance(sample->pose.p, match.pose.p);
        double axis = DEGREES(vec_angle(sample->pose.a, match.pose.a));
        if (to->n && (tip > tip_limit || axis > axis_limit)) {
            /* the other may have made a detour that the way back will judge */
            match = nearest_between(to, here - slack, here + step + DETOUR, sample->pose, &begin);
            tip = vec_distance(sample->pose.p, match.pose.p);
            axis = DEGREES(vec_angle(sample->pose.a, match.pose.a));
        }
        here = match.length;
        if (to->n == 0)
            tip = HUGE_VAL;
        if (!sweep.beyond && (tip > tip_limit || axis > axis_limit)) {
            sweep.beyond = true;
            sweep.first = i;
        }
        if (tip > sweep.tip) {
            sweep.tip = tip;
            sweep.tip_at = i;
        }
        sweep.ball = fmax(sweep.ball, ball_miss(sample->pose, match.pose, from->radius));
        if (axis > sweep.axis) {
            sweep.axis = axis;
            sweep.tool_axis_at = i;
        }
    }
    return sweep;
}

static bool meets(struct nc_motion_pose a, struct nc_motion_pose b, double tip_limit,
                  double axis_limit)
{
    return vec_distance(a.p, b.p) <= tip_limit && DEGREES(vec_angle(a.a, b.a)) <= axis_limit;
}

/* The rapid piece k leads to the way back down to where the cut was left. */
static bool leads_back(const struct nc_motion *nc_motion, size_t k)
{
    const struct nc_piece *piece = nc_motion->piece.item;
    size_t cut = k;
    while (cut > 0 && piece[cut].rapid)
        cut--;
    if (k + 1 >= nc_motion->piece.n || piece[cut].rapid || piece[k + 1].rapid)
        return false;
    return comes_back(nc_motion_at(nc_motion, &piece[k + 1], 0),
                      nc_motion_at(nc_motion, &piece[k + 1], 1),
                      nc_motion_at(nc_motion, &piece[cut], 1));
}

/* On the straight way from one place to another, as close as a rapid has to be. */
static bool on_way(struct vec3 p, struct vec3 from, struct vec3 to)
{
    struct vec3 way = vec_sub(to, from);
    double l2 = vec_dot(way, way), s = l2 > 0 ? vec_dot(vec_sub(p, from), way) / l2 : 0;
    return vec_distance(p, vec_mix(from, to, fmin(1, fmax(0, s)))) < RAPID_OFF;
}

/* The rapid piece k goes up the tool axis from a cut, a full retract. */
static bool leads_off(const struct nc_motion *nc_motion, size_t k)
{
    size_t cut = k;
    while (cut > 0 && nc_motion->piece.item[cut].rapid)
        cut--;
    struct nc_motion_pose from = nc_motion_at(nc_motion, &nc_motion->piece.item[cut], 1);
    struct nc_motion_pose to = nc_motion_at(nc_motion, &nc_motion->piece.item[k], 1);
    struct vec3 off = vec_sub(to.p, from.p);
    return vec_length(vec_reject(off, from.a)) < 0.02 && vec_dot(off, from.a) > 0;
}

int sweep_rapids(const struct nc_motion *program, const struct nc_motion *path, double tip_limit,
                 double axis_limit, struct error *error)
{
    double height = -HUGE_VAL;
    for (size_t i = 0; i < path->piece.n; i++)
        if (path->piece.item[i].rapid)
            height = fmax(height, path->piece.item[i].p[1].z);
    size_t k = 0; /* the program's pieces up to here are done */
    struct nc_motion_pose last = {{0, 0, 0}, {0, 0, 0}};
    for (size_t i = 0; i <= path->piece.n; i++) {
        bool end = i == path->piece.n;
        const struct nc_piece *want = end ? NULL : &path->piece.item[i];
        struct nc_motion_pose place = end ? last : nc_motion_at(path, want, 1);
        if (!end && !want->rapid)
            continue;
        if (!end && meets(place, last, tip_limit, axis_limit))
            continue; /* it is there already */
        bool met = false;
        for (; k < program->piece.n && !met; k++) {
            const struct nc_piece *piece = &program->piece.item[k];
            struct nc_motion_pose there = nc_motion_at(program, piece, 1);
            met = piece->rapid && !end && meets(there, place, tip_limit, axis_limit);
            if (piece->rapid && !met && there.p.z < height - tip_limit &&
                !meets(there, last, tip_limit, axis_limit) && !leads_back(program, k) &&
                !leads_off(program, k) &&
                !(i > 0 && !end && on_way(there.p, nc_motion_at(path, &want[-1], 1).p, place.p))) {
                char text[60];
                ncread_place(piece, text, sizeof text);
                return error_set(error,
                                 "%s: %s: a rapid move to %.3f %.3f %.3f that is not in "
                                 "the path",
                                 program->name, text, there.p.x, there.p.y, there.p.z);
            }
        }
        if (!met && !end)
            return error_at(error, path->name, want->line,
                            "the program makes no rapid move to "
                            "%.3f %.3f %.3f",
                            place.p.x, place.p.y, place.p.z);
        last = place;
    }
    return 0;
}
