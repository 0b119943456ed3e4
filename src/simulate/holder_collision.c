/* holder_collision - see holder_collision.h. */
#include "simulate/holder_collision.h"

enum { CURVED = 8 };

#define FINE 0.005  /* mm, or ... */
#define ALIKE 1.1   /* depths are told within a tenth */
#define SHARE 0.25  /* ... this of the tolerance */
#define ENOUGH 10   /* mm: more clearance than that is not measured */
#define GAIN 0.0005 /* mm: deeper by less than that is not deeper */
#define BEND 1.3    /* how much longer than its ends are apart a part of a curved way may be */

/* The ball's centre and the axis at s of a piece. */
static struct nc_motion_pose pose_at(const struct holder_collision *w, size_t piece, double s)
{
    struct nc_motion_pose pose = nc_motion_at(w->nc_motion, &w->nc_motion->piece.item[piece], s);
    if (w->nc_motion->track == NC_MOTION_TIP)
        pose.p = vec_along(pose.p, w->radius, pose.a);
    return pose;
}

/* No place of the stack moves further than this, the way being straight. */
static double moves(const struct holder_collision *w, struct nc_motion_pose a,
                    struct nc_motion_pose b)
{
    return vec_distance(a.p, b.p) + holder_reach(w->holder) * vec_angle(a.a, b.a);
}

struct stretch {
    size_t piece;
    double from, to;
    struct nc_motion_pose a, b;
    double bend;
};

/* What is nearest where the stack stands, and nearer than `limit`; the first nearer than `enough`.
 */
static double nearest(struct holder_collision *w, size_t piece, struct nc_motion_pose pose,
                      double limit, double enough)
{
    struct tiles_search search = {w->holder, pose.p, pose.a, limit, enough, {0, 0, 0}};
    collision_body_nearest(w->obstacle, &search);
    if (search.distance < limit && -search.distance > fmax(w->tolerance, w->depth)) {
        w->depth = -search.distance;
        w->piece = piece;
        w->at = search.at;
    }
    return search.distance;
}

/*
 * Looks at one place; returns how far the stack is off, at most ENOUGH.  Once the piece is known to
 * hit, only what is deeper than anything before is of interest, or may become so within `half`.
 */
static double look(struct holder_collision *w, size_t piece, struct nc_motion_pose pose,
                   double half)
{
    if (!w->hit) {
        double clear = nearest(w, piece, pose, ENOUGH, -w->tolerance);
        if (clear >= -w->tolerance)
            return clear;
        w->hit = true;
        w->pieces++;
    }
    double limit = fmax(half - ALIKE * w->depth, -w->depth - GAIN);
    return nearest(w, piece, pose, limit, -HUGE_VAL);
}

static void follow(struct holder_collision *w, struct stretch s)
{
    double way = s.bend * moves(w, s.a, s.b);
    if (way <= w->budget) {
        w->budget -= way;
        return;
    }
    double middle = (s.from + s.to) / 2;
    struct nc_motion_pose m = pose_at(w, s.piece, middle);
    double half = s.bend * fmax(moves(w, s.a, m), moves(w, m, s.b));
    double distance = look(w, s.piece, m, half);
    double deepest = half - distance; /* that it may be anywhere on the stretch */
    w->budget = fmax(0, w->tolerance - deepest);
    if (deepest <= w->tolerance || half < fmax(FINE, SHARE * w->tolerance) ||
        (w->hit && deepest <= ALIKE * w->depth))
        return;
    w->budget = 0;
    follow(w, (struct stretch){s.piece, s.from, middle, s.a, m, s.bend});
    follow(w, (struct stretch){s.piece, middle, s.to, m, s.b, s.bend});
}

void holder_collision_piece(struct holder_collision *w, size_t index)
{
    const struct nc_piece *piece = &w->nc_motion->piece.item[index];
    bool straight = piece->shape == SHAPE_LINE && vec_distance(piece->q[0], piece->q[1]) == 0 &&
                    piece->swing != SWING_HEAD;
    struct nc_motion_pose a = pose_at(w, index, 0);
    int parts = straight ? 1 : CURVED;
    if (w->known)
        w->budget = fmax(0, w->budget - moves(w, w->last, a));
    w->hit = false;
    for (int i = 1; i <= parts; i++) {
        struct nc_motion_pose b = pose_at(w, index, (double)i / parts);
        struct stretch s = {index, (i - 1.0) / parts, (double)i / parts, a, b, straight ? 1 : BEND};
        follow(w, s);
        a = b;
    }
    w->last = a;
    w->known = true;
}
