/* edge_unknown - see edge_steps.h. */
#include "edge_steps.h"
#include "math/cubic.h"
#include "math/sphere_grid.h"

/* Directions over the sphere that a point is looked at from. */
enum { DIRECTIONS = 500 };

/* Cosine of 60 degrees: over so much the point is the foremost; the sides of an edge make less than
 * 120. */
static const double SHARPER = 0.5;

/* In spacings: neighbours that are sides of an edge, no nearer across it and no farther; places
 * before the point; neighbours that may stand in front of it. */
static const double APART = 0.3, BESIDE = 2, AHEAD = 1.5, ABOUT = 3;

/* Of its way: no neighbour is so far in front of the highest point. */
static const double FRONT = 0.1;

/* In spacings: a point stands out by more from those about it, few and more, a surface with all
 * bends is further off these, and no place of an edge is as near: a feature not resolved.  Beside
 * EDGE_SIGMAS, and EDGE_UNEVEN, of the noise. */
static const double OUT = 0.1, ROUGH = 0.08, BARE = 1;

/* In spacings: two such points may be of one feature; a point so little beside the way between them
 * tells that they are not. */
static const double LINKED = 4, ASIDE = 0.3;

/* In spacings: a point that stands out by more is on what the points do not tell the shape of; by
 * less it is among its neighbours, and what is put before it is enough. */
static const double LARGE = 0.6;

/* In spacings: wider about a corner of a wall, too, the upper side has points in a quarter of the
 * turn alone. */
static const double WIDER = 5.6;

/* In spacings: there a point so far below the flank is down the wall. */
static const double DOWN = 1.4;

/* Least z of the normal of a flank that ends in a spur. */
static const double LEVEL = 0.5;

/* Least z of the middle of these directions: no ball comes from below. */
static const double UP = 0.05;

/* Its surface is known by itself. */
static bool is_explained(const struct edge_work *work, size_t i)
{
    const struct edge_flank *own = &work->flank[i];

    return edge_flank_certain(work, own) && !own->continued;
}

/* A place that an edge was found at, or that is on a cone, lies in front of the point, or no
 * further behind it than it may be off its surface. */
static bool has_place(const struct edge_work *work, const struct edge_hood *near, struct vec3 front)
{
    double reach = AHEAD * near->spacing, behind = edge_within(work, near->spacing);

    for (size_t k = 0; k < near->n; k++) {
        const struct vec3s *lists[] = {&work->found[near->index[k]],
                                       &work->between[near->index[k]]};
        for (int list = 0; list < 2; list++)
            for (size_t e = 0; e < lists[list]->n; e++) {
                struct vec3 to = vec_sub(lists[list]->item[e], near->point[0]);
                if (vec_dot(to, to) < reach * reach && vec_dot(to, front) > -behind)
                    return true;
            }
    }
    return false;
}

/* No neighbour stands in front of the point. */
static bool is_foremost(const struct edge_hood *near, struct vec3 front)
{
    double reach = ABOUT * near->spacing;

    for (size_t k = 1; k < near->n && near->distance2[k] < reach * reach; k++)
        if (vec_dot(front, vec_sub(near->point[k], near->point[0])) >
            FRONT * sqrt(near->distance2[k]))
            return false;
    return true;
}

/* An edge that the point is on: of the directions in which it is the foremost of all about it the
 * two that are furthest apart, the one amid them, and across the edge. */
struct sharp_edge {
    struct vec3 front, across;
    double cosine; /* of the two: the less the sharper */
};

static struct sharp_edge find_sharp(const struct edge_hood *near)
{
    struct sharp_edge edge = {.cosine = 1};
    struct vec3 front[DIRECTIONS];
    size_t n = 0;

    for (int k = 0; k < DIRECTIONS; k++) {
        struct vec3 way = sphere_spiral(k, 1 - (2 * k + 1.0) / DIRECTIONS);
        if (is_foremost(near, way))
            front[n++] = way;
    }
    for (size_t a = 0; a < n; a++)
        for (size_t b = a + 1; b < n; b++) {
            struct vec3 amid = vec_unit(vec_add(front[a], front[b]));
            if (vec_dot(front[a], front[b]) >= edge.cosine || !is_foremost(near, amid))
                continue; /* or it is the foremost on both sides of a plane */
            edge.cosine = vec_dot(front[a], front[b]);
            edge.front = amid;
            edge.across = vec_unit(vec_sub(front[a], front[b]));
        }
    return edge;
}

/* How far in front of the point the line from a neighbour goes on through it until it is over
 * another one on the other side, both as seen along the edge: at most. */
static double goes_on(const struct edge_hood *near, const struct sharp_edge *edge)
{
    double reach = BESIDE * near->spacing, steepest[2] = {0, 0}, widest[2] = {0, 0};

    for (size_t k = 1; k < near->n && near->distance2[k] < reach * reach; k++) {
        struct vec3 to = vec_sub(near->point[k], near->point[0]);
        double beside = vec_dot(to, edge->across), behind = -vec_dot(to, edge->front);
        if (fabs(beside) < APART * near->spacing)
            continue;
        steepest[beside > 0] = fmax(steepest[beside > 0], behind / fabs(beside));
        widest[beside > 0] = fmax(widest[beside > 0], fabs(beside));
    }
    return fmin(fmax(steepest[0] * widest[1], steepest[1] * widest[0]), reach);
}

/* Turns seen from above, of how many nothing is, beside each other. */
enum { TURNS = 24 };

static unsigned turn_of(struct vec3 to)
{
    return 1u << (unsigned)((atan2(to.y, to.x) + PI) / (2 * PI) * TURNS) % TURNS;
}

/* *amid: the middle of these, radians. */
static int widest_open(unsigned has, double *amid)
{
    int widest = 0, run = 0;

    for (int k = 0; k < 2 * TURNS; k++) {
        run = has & 1u << k % TURNS ? 0 : run + 1;
        if (run > widest)
            *amid = (k + 1 - run / 2.0) * 2 * PI / TURNS - PI;
        widest = run > widest ? run : widest;
    }
    return widest < TURNS ? widest : TURNS;
}

static bool is_open(unsigned has)
{
    enum { OPEN = 9 };
    double amid = 0;

    return widest_open(has, &amid) >= OPEN;
}

/* The scan ends beside the point: seen from above it has no neighbour over three eighths of the
 * turn. */
static bool is_at_border(const struct edge_hood *near)
{
    unsigned has = 0;

    for (size_t k = 1; k < near->n; k++)
        has |= turn_of(vec_sub(near->point[k], near->point[0]));
    return is_open(has);
}

/* The turns in which a flank goes on, or what is above it, by points near and by those near as seen
 * from above; all of them, where the scan ends beside it. */
static unsigned goes_on_in(const struct edge_work *work, size_t i, double spacing, struct vec3 up)
{
    const struct point_grid *grid = work->options->point_grid;
    struct edge_about about = edge_about(work, i);
    struct sizes near = {0};
    unsigned has = 0, seen = 0;

    point_grid_within(grid, grid->point[i], WIDER * spacing, &near);
    for (size_t k; edge_about_next(&about, &k);)
        *array_push(&near) = k;
    for (size_t k = 0; k < near.n; k++) {
        struct vec3 to = vec_sub(grid->point[near.item[k]], grid->point[i]);
        double far = hypot(to.x, to.y);
        unsigned turn = far > 0 ? turn_of(to) : 0;
        seen |= turn;
        if (-vec_dot(to, up) < fmin(far, DOWN * spacing))
            has |= turn;
    }
    array_free(&near);
    return is_open(seen) ? ~0u : has;
}

/* The point is above a wall on a flank that is certain, and wide about it only points steeply below
 * that lie over three quarters of a turn: a spur, and not the rim that points anywhere make.
 * *ahead: that way, along the flank, one mm long seen from above. */
static bool is_spur(const struct edge_work *work, size_t i, const struct edge_hood *near,
                    struct vec3 *ahead)
{
    enum { OPEN = 18 };
    const struct edge_flank *flank = &work->flank[i];
    double amid = 0;

    if (!edge_flank_certain(work, flank))
        return false;
    struct vec3 up = quadric_normal_at(&flank->q, near->point[0]);
    if (up.z < LEVEL || widest_open(goes_on_in(work, i, near->spacing, up), &amid) < OPEN)
        return false;
    double x = cos(amid), y = sin(amid);
    *ahead = vec(x, y, -(x * up.x + y * up.y) / up.z);
    return true;
}

bool edge_on_known(const struct edge_work *work, size_t i)
{
    enum { MANY = 4 * EDGE_NEAR };
    const struct point_grid *b = work->options->point_grid;
    uint32_t index[MANY];
    double distance2[MANY];
    size_t n = point_grid_nearest(b, b->point[i], MANY, index, distance2), known = 0;

    for (size_t k = 0; k < n; k++)
        known += edge_flank_certain(work, &work->flank[index[k]]);
    return 3 * known > n;
}

static bool is_bare(const struct edge_work *work, const struct edge_hood *near)
{
    for (size_t k = 0; k < near->n; k++) {
        const struct vec3s *lists[] = {&work->found[near->index[k]],
                                       &work->between[near->index[k]]};
        for (int list = 0; list < 2; list++)
            for (size_t e = 0; e < lists[list]->n; e++)
                if (vec_distance(lists[list]->item[e], near->point[0]) < BARE * near->spacing)
                    return false;
    }
    return true;
}

/* No surface that bends comes near to all points about. */
static bool is_rough(const struct edge_work *work, const struct edge_hood *near)
{
    double least = hypot(ROUGH * near->spacing, EDGE_UNEVEN * work->options->noise);
    struct quadric q, cubic;

    return quadric_fit_free(near->point, EDGE_SMOOTH, near->point[0], &q) != 0 ||
           (quadric_spread(&q, near->point, EDGE_SMOOTH, 6) > least &&
            (cubic_fit(near->point, NULL, EDGE_SMOOTH, near->point[0], quadric_normal(&q),
                       &cubic) != 0 ||
             quadric_spread(&cubic, near->point, EDGE_SMOOTH, 10) > least));
}

/* How far the point stands out amid a scan whose surface is known, of what is so small that the
 * points do not tell its shape. */
static double unresolved_depth(const struct edge_work *work, const struct edge_hood *near)
{
    double out = edge_hood_out(near, EDGE_SMOOTH / 2), wide = edge_hood_out(near, EDGE_SMOOTH);
    double least = OUT * near->spacing + EDGE_SIGMAS * work->options->noise;

    return fmin(out, wide) > least && is_rough(work, near) && is_bare(work, near) ? fmax(out, wide)
                                                                                  : 0;
}

/* Of a point above a wall, which may be higher than its neighbours are far: up to the points below,
 * at a corner or spur. */
static struct edge_unknown above_wall(const struct edge_work *work, size_t i,
                                      const struct edge_hood *near)
{
    struct edge_unknown u = {.depth = 0}, corner = u;

    u.spur = is_spur(work, i, near, &u.ahead);
    if (u.spur)
        u.depth = work->gap[i];
    if (!is_at_border(near))
        corner.depth = edge_cliff_corner(work, i, &corner.ahead);
    if (corner.depth > 0) {
        u.depth = corner.depth;
        u.ahead = corner.ahead;
    }
    return u;
}

/* Of one on a sharp edge, or on what the points do not resolve. */
static struct edge_unknown in_front(const struct edge_work *work, const struct edge_hood *near)
{
    struct sharp_edge edge = find_sharp(near);
    struct edge_unknown u = {.ahead = edge.front};

    if (edge.cosine > SHARPER || edge.front.z < UP || has_place(work, near, edge.front)) {
        struct vec3 normal = plane_normal(near->point, EDGE_SMOOTH);
        u.ahead = normal.z < 0 ? vec_scale(-1, normal) : normal;
        u.depth = unresolved_depth(work, near);
    } else {
        u.depth = goes_on(near, &edge);
    }
    u.large = u.depth > LARGE * near->spacing;
    return u;
}

struct edge_unknown edge_unknown_find(const struct edge_work *work, size_t i)
{
    struct edge_unknown none = {.depth = 0};
    struct edge_hood near;

    if (!(work->gap[i] > 0) && is_explained(work, i))
        return none;
    edge_hood_find(work, i, &near);
    if (work->gap[i] > 0)
        return above_wall(work, i, &near);
    return is_at_border(&near) || !edge_on_known(work, i) ? none : in_front(work, &near);
}

/* From the tip down to a point, as dense as places of edges are. */
static void add_side(const struct edge_work *work, struct vec3 tip, struct vec3 down,
                     struct vec3s *to)
{
    enum { MOST = 20 };
    double parts = fmin(ceil(vec_distance(tip, down) / work->options->along), MOST);

    for (double part = 0; part < parts; part++)
        *array_push(to) = vec_mix(tip, down, part / parts);
}

/* So far the part may go on before point i. */
static struct vec3 tip_of(const struct edge_work *work, size_t i)
{
    const struct edge_unknown *u = &work->unknown[i];

    return vec_along(work->options->point_grid->point[i], u->depth, u->ahead);
}

/* A point lies below the way to neighbour k, and seen from above hardly beside it. */
static bool has_below(const struct edge_hood *near, size_t k)
{
    double least = ASIDE * near->spacing;
    struct vec3 from = near->point[0], way = vec_sub(near->point[k], from);
    double length2 = way.x * way.x + way.y * way.y;

    for (size_t j = 1; j < near->n; j++) {
        struct vec3 to = vec_sub(near->point[j], from);
        double part = (to.x * way.x + to.y * way.y) / length2;
        if (part > 0 && part < 1 && fabs(to.x * way.y - to.y * way.x) < least * sqrt(length2) &&
            to.z - part * way.z < -least)
            return true;
    }
    return false;
}

/* There is one more such point near, or point i is above a wall: a single one may be astray. */
static bool counts(const struct edge_work *work, size_t i, const struct edge_hood *near)
{
    if (work->gap[i] > 0)
        return true;
    for (size_t k = 1; k < near->n; k++)
        if (work->unknown[near->index[k]].depth > 0)
            return true;
    return false;
}

/* The same of any point. */
static bool does_count(const struct edge_work *work, size_t i)
{
    struct edge_hood near;

    edge_hood_find(work, i, &near);
    return counts(work, i, &near);
}

/* Of such points about it that count none goes on farther: one of each feature. */
static bool leads(const struct edge_work *work, size_t i, const struct edge_hood *near)
{
    for (size_t k = 1; k < near->n; k++) {
        size_t j = near->index[k];
        double more = work->unknown[j].depth - work->unknown[i].depth;
        if (near->distance2[k] < BESIDE * BESIDE * near->spacing * near->spacing &&
            (more > 0 || (!(more < 0) && j < i)) && does_count(work, j))
            return false;
    }
    return true;
}

void edge_unknown_add(const struct edge_work *work, size_t i, struct vec3s *to)
{
    struct edge_hood near;

    if (!(work->unknown[i].depth > 0))
        return;
    edge_hood_find(work, i, &near);
    if (!counts(work, i, &near))
        return;
    struct vec3 tip = tip_of(work, i);
    for (size_t k = 1; k < near.n; k++) {
        size_t j = near.index[k];
        double far = sqrt(near.distance2[k]);
        if (!(work->unknown[j].depth > 0)) {
            if (far < BESIDE * near.spacing)
                add_side(work, tip, near.point[k], to);
        } else if (j > i && far < LINKED * near.spacing && !has_below(&near, k)) {
            add_side(work, tip, tip_of(work, j), to);
            add_side(work, near.point[0], near.point[k], to);
        }
    }
}

void edge_unknown_sum(const struct edge_work *work, size_t i, struct edge_gaps *gaps)
{
    const struct edge_unknown *u = &work->unknown[i];
    struct edge_hood near;

    if (!(u->depth > 0))
        return;
    edge_hood_find(work, i, &near);
    if (!counts(work, i, &near))
        return;
    gaps->unknown++;
    gaps->features += leads(work, i, &near);
    gaps->spurs += u->spur;
    gaps->large += u->large;
    if (u->depth > gaps->depth) {
        gaps->depth = u->depth;
        gaps->unknown_at = work->options->point_grid->point[i];
    }
}
