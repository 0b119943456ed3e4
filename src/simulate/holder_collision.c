/* holder_collision - see holder_collision.h. */
#include "simulate/holder_collision.h"

#include <stdlib.h>

#include "base/array.h"
#include "base/parallel.h"

enum {
    CURVED = 8, /* parts that a curved piece is followed in */
    GROUP = 128 /* pieces that one thread follows at a time */
};

#define FINE 0.005  /* mm: a stretch that short is not halved further, nor one ... */
#define SHARE 0.25  /* ... shorter than this of the tolerance */
#define ALIKE 1.1   /* depths are found within a tenth */
#define ENOUGH 10   /* mm: more clearance than that is not measured */
#define GAIN 0.0005 /* mm: deeper by less than that is not deeper */
#define BEND 1.3    /* length of a part of a curved piece, at most, to the distance of its ends */

/* ---- the body */

static int clamp(double x, int n)
{
    return x < 0 ? 0 : x >= n ? n - 1 : (int)x;
}

struct collision_body collision_body_points(const struct vec3 *point, size_t n)
{
    return (struct collision_body){.tree = kdtree_new(point, n)};
}

/* Takes one place into the search; returns its distance. */
static double search_place(struct holder_search *search, struct vec3 place)
{
    double distance = tool_shape_distance(search->tool, search->centre, search->axis, place);
    if (distance < search->distance) {
        search->distance = distance;
        search->at = place;
    }
    return distance;
}

/* What a search is about. */
struct body_search {
    const struct collision_body *body;
    struct holder_search *holder;
};

/* Top of a column; where nothing is left, or beside the grid, the bottom. */
static double top_of(const struct stock *s, int i, int j)
{
    if (i < 0 || j < 0 || i >= s->nx || j >= s->ny)
        return s->bottom;
    const struct stock_column *c = stock_at(s, i, j);
    return c->low < c->high ? c->high : s->bottom;
}

/* The lowest top beside a column: down to it there is a wall. */
static double wall_foot(const struct stock *s, int i, int j)
{
    return fmin(fmin(top_of(s, i - 1, j), top_of(s, i + 1, j)),
                fmin(top_of(s, i, j - 1), top_of(s, i, j + 1)));
}

struct columns {
    int i0, i1, j0, j1;
};

static struct columns columns_of(const struct stock *s, int i, int j)
{
    struct columns at = {.i0 = i * STOCK_TILE, .j0 = j * STOCK_TILE};
    at.i1 = (i + 1) * STOCK_TILE < s->nx ? (i + 1) * STOCK_TILE : s->nx;
    at.j1 = (j + 1) * STOCK_TILE < s->ny ? (j + 1) * STOCK_TILE : s->ny;
    return at;
}

static void set_heights(struct collision_body *o, int i, int j)
{
    const struct stock *s = o->stock;
    struct columns at = columns_of(s, i, j);
    struct height_range range = {HUGE_VAL, -HUGE_VAL};
    for (int v = at.j0; v < at.j1; v++)
        for (int u = at.i0; u < at.i1; u++) {
            double top = top_of(s, u, v);
            range.high = fmax(range.high, top);
            range.low = fmin(range.low, fmin(top, wall_foot(s, u, v)));
        }
    height_pyramid_set(&o->heights, (struct height_cell){i, j}, range);
}

struct collision_body collision_body_stock(struct stock *s)
{
    struct collision_body o = {.stock = s};
    double dx = s->dx * STOCK_TILE, dy = s->dy * STOCK_TILE;
    o.heights =
        height_pyramid_new(s->x - s->dx / 2, s->y - s->dy / 2, dx, dy, s->tiles_x, s->tiles_y);
    for (int j = 0; j < s->tiles_y; j++)
        for (int i = 0; i < s->tiles_x; i++)
            set_heights(&o, i, j);
    return o;
}

/* Tiles beside one that was cut have new walls. */
static void mark_beside(struct stock *s, int tile)
{
    int i = tile % s->tiles_x, j = tile / s->tiles_x;
    for (int k = 0; k < 4; k++) {
        int u = i + (k == 0) - (k == 1), v = j + (k == 2) - (k == 3), n = v * s->tiles_x + u;
        if (u < 0 || v < 0 || u >= s->tiles_x || v >= s->tiles_y ||
            (s->changed[n] & STOCK_FOR_HOLDER))
            continue;
        s->changed[n] |= STOCK_FOR_HOLDER;
        *array_push(&s->holder) = n;
    }
}

static void follow_stock(struct collision_body *o)
{
    struct stock *s = o->stock;
    size_t cut = s->holder.n;
    for (size_t k = 0; k < cut; k++)
        mark_beside(s, s->holder.item[k]);
    for (size_t k = 0; k < s->holder.n; k++) {
        int tile = s->holder.item[k];
        set_heights(o, tile % s->tiles_x, tile / s->tiles_x);
        s->changed[tile] &= (unsigned char)~STOCK_FOR_HOLDER;
    }
    s->holder.n = 0;
}

/* The top of a column and, where they may be nearer than what was found, places down its wall. */
static void search_column(const struct stock *s, int i, int j, struct holder_search *search)
{
    double top = top_of(s, i, j), foot = wall_foot(s, i, j), step = fmin(s->dx, s->dy);
    struct vec3 place = vec(stock_x(s, i), stock_y(s, j), top);
    if (top <= s->bottom)
        return;
    double distance = search_place(search, place);
    while (place.z - step > foot && distance - (place.z - foot) < search->distance) {
        /* as far as nothing can be nearer than what was found already */
        place.z -= fmax(step, distance - search->distance);
        if (place.z > foot)
            distance = search_place(search, place);
    }
}

static double visit_stock(void *context, struct height_cell cell)
{
    const struct body_search *search = context;
    const struct stock *s = search->body->stock;
    struct columns at = columns_of(s, cell.column, cell.row);
    for (int v = at.j0; v < at.j1; v++)
        for (int u = at.i0; u < at.i1; u++)
            search_column(s, u, v, search->holder);
    return search->holder->distance;
}

static double bound_box(void *context, struct vec3 middle, struct vec3 half)
{
    const struct holder_search *s = ((const struct body_search *)context)->holder;
    return tool_shape_bound(s->tool, s->centre, s->axis, middle, half);
}

/* Has all cells of a stock looked at where something may be nearer. */
static void search_stock(const struct collision_body *o, struct holder_search *holder)
{
    struct body_search context = {o, holder};
    struct height_search search = {bound_box, visit_stock, &context, holder->distance,
                                   holder->enough};
    height_pyramid_search(&o->heights, &search);
}

static double value_of_point(const void *context, struct vec3 p, double below)
{
    const struct body_search *search = context;
    (void)below;
    return search_place(search->holder, p);
}

static double bound_of_box(const void *context, struct vec3 middle, struct vec3 half, double below)
{
    (void)below;
    const struct holder_search *s = ((const struct body_search *)context)->holder;
    return tool_shape_bound(s->tool, s->centre, s->axis, middle, half);
}

/* Has the points looked at where one may be nearer, by boxes in space: over a wall, a raster in
 * plan has all of its points in a few cells. */
static void search_points(const struct collision_body *o, struct holder_search *holder)
{
    struct body_search context = {o, holder};
    const struct kdtree_field field = {value_of_point, bound_of_box, &context};
    if (!(holder->enough > -HUGE_VAL) || !kdtree_any_lower(o->tree, &field, holder->enough, NULL))
        kdtree_lowest(o->tree, &field, holder->distance, NULL);
}

void collision_body_free(struct collision_body *body)
{
    height_pyramid_free(&body->heights);
    kdtree_free(body->tree);
}

/* What was nearest the last time is near still. */
static void search_hint(const struct collision_body *o, struct holder_search *search)
{
    const struct stock *s = o->stock;
    if (s)
        search_column(s, clamp((o->hint.x - s->x) / s->dx + 0.5, s->nx),
                      clamp((o->hint.y - s->y) / s->dy + 0.5, s->ny), search);
    else
        search_place(search, o->hint);
}

void collision_body_nearest(struct collision_body *o, struct holder_search *search)
{
    double before = search->distance;
    if (o->stock)
        follow_stock(o);
    if (o->hinted)
        search_hint(o, search);
    if (search->distance >= search->enough && o->stock)
        search_stock(o, search);
    else if (search->distance >= search->enough)
        search_points(o, search);
    if (search->distance < before) {
        o->hinted = true;
        o->hint = search->at;
    }
}

/* ---- the motion along it */

/* The tool following one piece. */
struct follower {
    const struct holder_collision_options *options;
    struct holder_collision *found;
    size_t piece;
    bool hit; /* the piece is one of found->pieces */
};

/* A part of the piece, from s to s. */
struct stretch {
    double from, to;
    struct nc_motion_pose a, b;
    double bend;
};

/* The ball's centre and the axis at s of the piece. */
static struct nc_motion_pose pose_at(const struct follower *f, double s)
{
    return nc_motion_ball(f->options->motion, f->piece, s, f->options->radius);
}

/* No place of the stack moves further than this, if the ball goes straight. */
static double largest_move(const struct follower *f, struct nc_motion_pose a,
                           struct nc_motion_pose b)
{
    return vec_distance(a.p, b.p) + tool_shape_reach(f->options->tool) * vec_angle(a.a, b.a);
}

/* How far the stack is off where it is nearer than `limit`; ends at anything nearer than `enough`.
 * Keeps the deepest. */
static double measure(struct follower *f, struct nc_motion_pose pose, double limit, double enough)
{
    const struct holder_collision_options *options = f->options;
    struct holder_collision *found = f->found;
    struct holder_search search = {options->tool, pose.p, pose.a, limit, enough, {0, 0, 0}};
    collision_body_nearest(options->body, &search);
    if (search.distance < limit && -search.distance > fmax(options->tolerance, found->depth)) {
        found->depth = -search.distance;
        found->piece = f->piece;
        found->at = search.at;
        found->height = vec_dot(vec_sub(search.at, pose.p), pose.a);
        found->width = tool_shape_radius(options->tool, found->height);
    }
    return search.distance;
}

/*
 * How far the stack is off at one place, at most ENOUGH.  Once the piece is known to hit, only what
 * is deeper than anything before is of interest, or may become so within `half`.
 */
static double clearance_at(struct follower *f, struct nc_motion_pose pose, double half)
{
    double tolerance = f->options->tolerance, depth = f->found->depth;
    if (!f->hit) {
        double clear = measure(f, pose, ENOUGH, -tolerance);
        if (clear >= -tolerance)
            return clear;
        f->hit = true;
        f->found->pieces++;
        depth = f->found->depth;
    }
    double limit = fmax(half - ALIKE * depth, -depth - GAIN);
    return measure(f, pose, limit, -HUGE_VAL);
}

static void follow_stretch(struct follower *f, struct stretch s)
{
    double tolerance = f->options->tolerance, length = s.bend * largest_move(f, s.a, s.b);
    double *budget = &f->found->budget;
    if (length <= *budget) {
        *budget -= length;
        return;
    }
    double middle = (s.from + s.to) / 2;
    struct nc_motion_pose m = pose_at(f, middle);
    double half = s.bend * fmax(largest_move(f, s.a, m), largest_move(f, m, s.b));
    double deepest = half - clearance_at(f, m, half); /* that it may be anywhere on the stretch */
    *budget = fmax(0, tolerance - deepest);
    if (deepest <= tolerance || half < fmax(FINE, SHARE * tolerance) ||
        (f->hit && deepest <= ALIKE * f->found->depth))
        return;
    *budget = 0;
    follow_stretch(f, (struct stretch){s.from, middle, s.a, m, s.bend});
    follow_stretch(f, (struct stretch){middle, s.to, m, s.b, s.bend});
}

void holder_collision_piece(const struct holder_collision_options *options,
                            struct holder_collision *found, size_t index)
{
    const struct nc_piece *piece = &options->motion->piece.item[index];
    struct follower f = {options, found, index, false};
    bool straight = piece->shape == SHAPE_LINE && vec_distance(piece->q[0], piece->q[1]) == 0 &&
                    piece->interpolation != AXIS_BY_HEAD;
    struct nc_motion_pose a = pose_at(&f, 0);
    int parts = straight ? 1 : CURVED;
    if (found->known)
        found->budget = fmax(0, found->budget - largest_move(&f, found->last, a));
    for (int i = 1; i <= parts; i++) {
        struct nc_motion_pose b = pose_at(&f, (double)i / parts);
        struct stretch s = {(i - 1.0) / parts, (double)i / parts, a, b, straight ? 1 : BEND};
        follow_stretch(&f, s);
        a = b;
    }
    found->last = a;
    found->known = true;
}

/* What each group of pieces found, the groups being the same however many threads there are. */
struct group_run {
    const struct holder_collision_options *options;
    struct holder_collision *found;
};

static void follow_groups(void *context, size_t from, size_t to)
{
    const struct group_run *run = context;
    size_t n = run->options->motion->piece.n;
    for (size_t g = from; g < to; g++) {
        struct collision_body body = *run->options->body; /* with a hint of its own */
        struct holder_collision_options options = *run->options;
        options.body = &body;
        body.hinted = false;
        for (size_t i = g * GROUP; i < (g + 1) * GROUP && i < n; i++)
            holder_collision_piece(&options, &run->found[g], i);
    }
}

struct holder_collision holder_collision_all(const struct holder_collision_options *options,
                                             int threads)
{
    size_t groups = (options->motion->piece.n + GROUP - 1) / GROUP, pieces = 0;
    struct group_run run = {options, mem_alloc(groups, sizeof *run.found)};
    struct holder_collision worst = {0};
    parallel_for(threads, groups, follow_groups, &run);
    for (size_t g = 0; g < groups; g++) {
        pieces += run.found[g].pieces;
        if (run.found[g].depth > worst.depth)
            worst = run.found[g];
    }
    free(run.found);
    worst.pieces = pieces;
    return worst;
}
