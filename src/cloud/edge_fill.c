/* edge_fill - see edge_steps.h. */
#include "edge_steps.h"

#include "math/triangles.h"

/* Rings of places on a flank that is certain: up and down a steep one points are far apart. */
enum { CERTAIN_RINGS = 3 * EDGE_RINGS };

/* What is known about a flank at point i: which of the neighbours are on it, which are in a hollow
 * with it, each above the other's surface, and places of its edges. */
struct flank_patch {
    const struct edge_flank *flank;
    bool on[EDGE_NEAR], hollow[EDGE_NEAR];
    struct vec3s side; /* points and places of edges on it */
    size_t edges;      /* of these, places of edges */
    size_t sharp;      /* neighbours in a hollow that is sharp */
    bool certain;      /* where it goes on it is where its points tell */
    bool above_wall;   /* a point on it is above a wall */
    bool wide;         /* points farther about are among the former */
};

/* The flank of a point in a hollow turns up sharply from this one. */
static bool is_sharp(const struct flank_patch *patch, const struct edge_flank *other, struct vec3 p)
{
    struct vec3 normal[2];

    edge_flank_above(patch->flank, p, &normal[0]);
    edge_flank_above(other, p, &normal[1]);
    return vec_dot(normal[0], normal[1]) < EDGE_SHARP;
}

static struct flank_patch find_patch(const struct edge_work *work, const struct edge_hood *near,
                                     size_t i)
{
    struct flank_patch patch = {.flank = &work->flank[i],
                                .certain = edge_flank_certain(work, &work->flank[i])};
    double least = edge_within(work, patch.flank->spacing);
    struct vec3 normal;

    for (size_t k = 0; k < near->n; k++) {
        const struct vec3s *edge = &work->found[near->index[k]];
        const struct edge_flank *other = &work->flank[near->index[k]];
        double h = edge_flank_above(patch.flank, near->point[k], &normal);
        patch.on[k] = fabs(h) <= least;
        patch.hollow[k] = (h > least || (patch.on[k] && edge_flank_certain(work, other))) &&
                          edge_flank_known(other) &&
                          edge_flank_above(other, near->point[0], &normal) > least;
        patch.above_wall = patch.above_wall || (patch.on[k] && work->gap[near->index[k]] > 0);
        if (patch.on[k])
            *array_push(&patch.side) = near->point[k];
        for (size_t e = 0; e < edge->n; e++)
            if (fabs(edge_flank_above(patch.flank, edge->item[e], &normal)) <= least) {
                *array_push(&patch.side) = edge->item[e];
                patch.edges++;
            }
        patch.sharp += patch.hollow[k] && other->valid && is_sharp(&patch, other, near->point[k]);
    }
    return patch;
}

/* A cubic through all about a point of a certain flank bends away from it round an edge: it tells
 * of no place that is nearer to another point of the flank. */
static bool bends_away(const struct flank_patch *patch, const struct edge_flank *other)
{
    return patch->certain && other->bent && !other->rough && !other->valid;
}

/* The point of the other flank, which is on this one, too, fills it there: one on the edge of
 * both may have the other side's, that the place is below. */
static bool fills(const struct edge_flank *other, struct vec3 at, double least)
{
    struct vec3 normal;

    return other->valid && edge_flank_above(other, at, &normal) >= -least;
}

/* No point that fills the flank is nearer to the place than point i, all points about have
 * surfaces, and the place is above none of these, but for hollows. */
static bool is_on_patch(const struct edge_work *work, const struct edge_hood *near,
                        const struct flank_patch *patch, struct vec3 at)
{
    const double about = 2, beside = 1.5; /* beside: in spacings, for a point on the edge itself */
    double out = vec_distance(at, near->point[0]), least = edge_within(work, patch->flank->spacing);
    double reach = fmax(about * out, (work->lines ? EDGE_REACH : beside) * patch->flank->spacing);
    struct vec3 normal;

    for (size_t k = 1; k < near->n; k++) {
        const struct edge_flank *other = &work->flank[near->index[k]];
        double far = vec_distance(at, near->point[k]);
        if (patch->on[k] && !patch->hollow[k] && far < out && fills(other, at, least))
            return false;
        if (far >= reach || patch->hollow[k] ||
            (patch->on[k] && far > out && bends_away(patch, other)))
            continue;
        if (!edge_flank_known(other)
                ? far < about * out && !(patch->on[k] && patch->certain)
                : edge_flank_above(other, at, &normal) > (patch->on[k] ? least : least / 4))
            return false;
    }
    return true;
}

/* So far from the place towards (u, v) the flank has gone on above that of another point: their
 * edge is before. */
static bool is_beyond_edge(const struct edge_work *work, const struct edge_hood *near,
                           const struct flank_patch *patch, struct vec3 at, double u, double v)
{
    const struct quadric *q = &patch->flank->q;
    struct vec3 off = vec_sub(at, q->origin), normal;
    struct vec3 p = quadric_at(q, vec_dot(off, q->u) + u, vec_dot(off, q->v) + v);

    for (size_t k = 1; k < near->n; k++) {
        const struct edge_flank *other = &work->flank[near->index[k]];
        double least = edge_within(work, other->spacing);
        if (other->confirmed && !patch->on[k] && !patch->hollow[k] &&
            edge_flank_above(other, p, &normal) > least &&
            edge_flank_above(other, at, &normal) <= least)
            return true;
    }
    return false;
}

enum { SECTORS = 12 };

/* The sectors of the half plane that begins with one of them, a bit each. */
static unsigned half_plane(int from)
{
    unsigned half = ((1u << SECTORS / 2) - 1) << from;

    return (half | half >> SECTORS) & ((1u << SECTORS) - 1);
}

/* Every half plane has one of these sectors. */
static bool has_every_half(unsigned has)
{
    for (int from = 0; from < SECTORS; from++)
        if (!(has & half_plane(from)))
            return false;
    return true;
}

/* Every half plane of the flank through the place has a point or an edge of it that is near, or
 * goes on above another flank. */
static bool is_surrounded(const struct edge_work *work, const struct edge_hood *near,
                          const struct flank_patch *patch, struct vec3 at, double reach)
{
    const double far = 2;
    const struct quadric *q = &patch->flank->q;
    unsigned has = 0;

    for (size_t k = 0; k < patch->side.n; k++) {
        struct vec3 to = vec_sub(patch->side.item[k], at);
        double u = vec_dot(to, q->u), v = vec_dot(to, q->v);
        if (hypot_compare(u, v, reach) > 0)
            continue;
        unsigned more = has | 1u << (int)((atan2(v, u) + PI) / (2 * PI) * SECTORS) % SECTORS;
        if (more != has && has_every_half(more))
            return true;
        has = more;
    }
    for (int from = 0; from < SECTORS; from++) {
        for (int k = 0; patch->certain && k < SECTORS / 2 && !(has & half_plane(from)); k++) {
            int sector = (from + k) % SECTORS;
            double t = 2 * PI * (sector + 0.5) / SECTORS - PI;
            if (is_beyond_edge(work, near, patch, at, far * reach * cos(t), far * reach * sin(t)))
                has |= 1u << sector;
        }
        if (!(has & half_plane(from)))
            return false;
    }
    return true;
}

/* Adds what is on the flank farther about: up and down a steep one the nearest points are those of
 * others. */
static void widen_side(const struct edge_work *work, size_t i, struct flank_patch *patch)
{
    enum { WIDE = 160 };
    const struct point_grid *b = work->options->point_grid;
    uint32_t index[WIDE];
    double distance2[WIDE], least = edge_within(work, patch->flank->spacing);
    size_t n = point_grid_nearest(b, b->point[i], WIDE, index, distance2);
    struct vec3 normal;

    patch->wide = true;
    for (size_t k = EDGE_NEAR; k < n; k++) {
        struct vec3 p = b->point[index[k]];
        if (edge_flank_certain(work, &work->flank[index[k]]) &&
            fabs(edge_flank_above(patch->flank, p, &normal)) <= least)
            *array_push(&patch->side) = p;
    }
}

/* Places of the flank of point i that are nearest to it, as dense as those of edges are on
 * these. */
static void fill_patch(const struct edge_work *work, const struct edge_hood *near, size_t i,
                       struct flank_patch *patch, struct vec3s *to)
{
    const double dense = 0.65;
    const struct quadric *q = &patch->flank->q;
    double pitch = dense * work->options->along, reach = sqrt(near->distance2[EDGE_SMOOTH]);
    struct vec3 off = vec_sub(near->point[0], q->origin);
    int most = patch->certain ? CERTAIN_RINGS : EDGE_RINGS;
    int rings = (int)fmin(triangles_rings(reach, pitch), most);

    for (int row = -rings; row <= rings; row++)
        for (int k = -rings; k <= rings; k++) {
            double u, v;
            triangles_at(pitch, k, row, &u, &v);
            if ((k == 0 && row == 0) || hypot_compare(u, v, reach) > 0)
                continue;
            struct vec3 at = quadric_at(q, vec_dot(off, q->u) + u, vec_dot(off, q->v) + v);
            if (!is_on_patch(work, near, patch, at))
                continue;
            bool inside = is_surrounded(work, near, patch, at, fmax(reach, 2 * hypot(u, v)));
            if (!inside && patch->certain && !patch->wide) {
                widen_side(work, i, patch);
                inside = is_surrounded(work, near, patch, at, fmax(reach, 2 * hypot(u, v)));
            }
            if (inside)
                *array_push(to) = at;
        }
}

void edge_fill_add(const struct edge_work *work, const struct edge_hood *near, size_t i,
                   struct vec3s *to)
{
    struct flank_patch patch = find_patch(work, near, i);

    if (patch.edges > 0 || patch.sharp >= EDGE_FEWEST || patch.flank->along ||
        (patch.certain && (!(work->options->noise > 0) || patch.above_wall)))
        /* elsewhere it is rough, or by noise */
        fill_patch(work, near, i, &patch, to);
    array_free(&patch.side);
}
