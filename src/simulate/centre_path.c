/* centre_path - see centre_path.h. */
#include "simulate/centre_path.h"

#include "base/array.h"

enum { DEEPEST = 16 }; /* halvings of a piece, at most */

struct piece_walk {
    const struct nc_motion *motion;
    const struct nc_piece *piece;
    size_t index;
    double height; /* above the point that the motion tracks */
    const struct centre_path_options *options;
    struct centre_path *path;
};

/* The centre at a place of the piece. */
static struct vec3 centre_at(const struct piece_walk *w, double s)
{
    struct nc_motion_pose pose = nc_motion_at(w->motion, w->piece, s);
    return vec_along(pose.p, w->height, pose.a);
}

/* How near to m, the middle of a segment, it has to be. */
static double flat_at(const struct piece_walk *w, struct vec3 m)
{
    const double far = 10, part = 0.01;
    const struct box *box = w->options->part;

    if (!box || box->low.x > box->high.x) /* no point */
        return w->options->flat;
    double off = sqrt(box_distance2(box, m)) - far * box_diagonal(box);
    return w->options->flat + part * fmax(0, off);
}

/* Halves until three places between the ends lie on the chord. */
static void add_segments(const struct piece_walk *w, double s0, struct vec3 a, double s1,
                         struct vec3 b, int depth)
{
    double s = (s0 + s1) / 2;
    struct vec3 m = centre_at(w, s);
    double flat = flat_at(w, m);
    bool straight = vec_segment_distance(a, b, m) <= flat;
    for (int i = 1; straight && i <= 3; i += 2) {
        double between = s0 + (s1 - s0) * i / 4;
        straight = vec_segment_distance(a, b, centre_at(w, between)) <= flat;
    }
    if (depth >= DEEPEST || (straight && depth >= 0)) {
        *array_push(w->path) =
            (struct centre_segment){a, b, {(float)s0, (float)s1}, (unsigned)w->index, false};
        return;
    }
    add_segments(w, s0, a, s, m, depth + 1);
    add_segments(w, s, m, s1, b, depth + 1);
}

void centre_path_piece(const struct nc_motion *motion, size_t piece,
                       const struct centre_path_options *options, struct centre_path *path)
{
    const struct nc_piece *at = &motion->piece.item[piece];
    double height = motion->track == NC_MOTION_TIP ? options->radius : 0;
    struct piece_walk w = {motion, at, piece, height, options, path};
    struct vec3 a = centre_at(&w, 0), b = centre_at(&w, 1);
    bool still = at->shape == SHAPE_LINE && vec_distance(at->q[0], at->q[1]) == 0 &&
                 at->interpolation != AXIS_BY_HEAD;
    if (still)
        *array_push(path) = (struct centre_segment){a, b, {0, 1}, (unsigned)piece, false};
    else /* what curves is halved twice at least: a full turn ends where it begins */
        add_segments(&w, 0, a, 1, b, at->shape == SHAPE_LINE ? 0 : -2);
}

void centre_path_cut(const struct nc_motion *motion, const struct centre_path_options *options,
                     struct centre_path *path)
{
    for (size_t i = 0; i < motion->piece.n; i++)
        if (!motion->piece.item[i].rapid)
            centre_path_piece(motion, i, options, path);
}

void centre_path_rapid(const struct nc_motion *motion, const struct centre_path_options *options,
                       struct centre_path *path)
{
    for (size_t i = 0; i < motion->piece.n; i++)
        if (motion->piece.item[i].rapid)
            centre_path_piece(motion, i, options, path);
}
