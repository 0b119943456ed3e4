/* ncahead - see ncahead.h. */
#include "ncahead.h"

#include <stdlib.h>

enum { DEPTH = 12, SPAN_PIECES = 8, HALVINGS = 45, PLACES_MAX = 200000 };
#define INSIDE 1e-3 /* radians of way that a turn inside of a motion counts */

struct motion nc_item_motion(const struct path *path, const struct path_item *item,
                             struct pose from)
{
    if (item->kind == PATH_ARC) {
        const struct path_arc *arc = &path->arc.item[item->index];
        return motion_arc(from, item->to, arc->centre, arc->axis);
    }
    if (item->kind == PATH_SPLINE)
        return motion_spline(from, item->to, &path->spline.item[item->index].curve);
    return motion_line(from, item->to);
}

static void add(struct nc_ahead *ahead, struct vec3 axis, double s, bool may_turn)
{
    *array_push(ahead) = (struct turnplan_place){.axis = axis, .may_turn = may_turn};
    *array_push(&ahead->s) = s;
}

/* Where between two places an axis comes to an end of its travel, a place of its own: the tool may
 * turn there, though rather at the end of a motion. */
static void add_ends(struct nc_ahead *ahead, const struct chain *chain,
                     const struct motion *motion, double s0, double s1)
{
    struct vec3 a0 = motion_at(motion, s0).a, a1 = motion_at(motion, s1).a;
    double end[2], share;
    int n = 0;
    for (int k = 0; k < 2; k++) {
        double low = s0, high = s1;
        if (!turnplan_end(chain, a0, a1, k, &share))
            continue;
        for (int i = 0; i < HALVINGS; i++) { /* before the end, by less than the last digit */
            double mid = (low + high) / 2;
            bool behind = turnplan_end(chain, a0, motion_at(motion, mid).a, k, &share);
            *(behind ? &high : &low) = mid;
        }
        end[n++] = low;
    }
    if (n == 2 && end[0] > end[1]) {
        double other = end[0];
        end[0] = end[1];
        end[1] = other;
    }
    for (int i = 0; i < n; i++) {
        if (end[i] <= s0 || (i == 1 && end[1] == end[0]))
            continue;
        add(ahead, motion_at(motion, end[i]).a, end[i], true);
        ahead->item[ahead->n - 1].dear = INSIDE;
    }
}

/* Places of a motion behind s0, where the direction is a0, up to s1. */
static void sample(struct nc_ahead *ahead, const struct chain *chain, const struct motion *motion,
                   double s0, struct vec3 a0, double s1, int depth)
{
    struct vec3 a1 = motion_at(motion, s1).a;
    double step = fmin(turnplan_step(chain, a0), turnplan_step(chain, a1));
    if (vec_angle(a0, a1) <= step || depth == DEPTH || ahead->n > PLACES_MAX) {
        add_ends(ahead, chain, motion, s0, s1);
        add(ahead, a1, s1, false);
        return;
    }
    double mid = (s0 + s1) / 2;
    sample(ahead, chain, motion, s0, a0, mid, depth + 1);
    sample(ahead, chain, motion, mid, motion_at(motion, mid).a, s1, depth + 1);
}

static void sample_motion(struct nc_ahead *ahead, const struct chain *chain,
                          const struct motion *motion)
{
    double s = 0;
    struct vec3 a = motion_at(motion, 0).a;
    while (s < 1) {
        double from = s, next = motion_next_knot(motion, s);
        int pieces = motion->kind == MOTION_SPLINE ? SPAN_PIECES : 1;
        for (int i = 1; i <= pieces; i++) {
            double to = from + (next - from) * i / pieces;
            sample(ahead, chain, motion, s, a, to, 0);
            a = ahead->item[ahead->n - 1].axis;
            s = to;
        }
        s = next;
    }
    ahead->item[ahead->n - 1].may_turn = true;
}

bool nc_ahead_make(struct nc_ahead *ahead, const struct nc_step *step, size_t from, size_t to)
{
    const struct path *path = step->path;
    const struct chain *chain = &step->machine->chain;
    bool cutting = false, begun = step->state.begun;
    struct pose pose = step->state.pose;
    *ahead = (struct nc_ahead){0};
    if (step->follow.mode == FOLLOW_VECTOR || chain->n == 0)
        return false;
    if (begun)
        add(ahead, pose.a, 1, true);
    for (size_t i = from; i < to && ahead->n < PLACES_MAX; i++) {
        const struct path_item *item = &path->item.item[i];
        bool moves =
            item->kind == PATH_POINT || item->kind == PATH_ARC || item->kind == PATH_SPLINE;
        *array_push(&ahead->start) = ahead->n ? ahead->n - 1 : 0;
        if (!moves)
            continue;
        cutting = cutting || !item->rapid || item->kind != PATH_POINT;
        if (!cutting || !begun) { /* in the clear: only where it leads to matters */
            ahead->n = ahead->s.n = 0;
            add(ahead, item->to.a, 1, true);
        } else {
            struct motion motion = nc_item_motion(path, item, pose);
            sample_motion(ahead, chain, &motion);
        }
        pose = item->to;
        begun = true;
    }
    *array_push(&ahead->start) = ahead->n ? ahead->n - 1 : 0;
    return ahead->n > 1 && ahead->n < PLACES_MAX &&
           turnplan_make(chain, ahead->item, ahead->n, step->state.at.q) >= 0;
}

void nc_ahead_free(struct nc_ahead *ahead)
{
    array_free(&ahead->start);
    array_free(&ahead->s);
    array_free(ahead);
}
