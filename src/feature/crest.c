/* crest - ribs and grooves that a mesh cuts off, found over its edges and put into it; see
 * feature.h and feature_steps.h. */
#include <stdbool.h>
#include <stdlib.h>

#include "feature_steps.h"
#include "math/ridge_direction.h"
#include "feature/feature.h"
#include "math/earclip.h"
#include "mesh/mesh_edges.h"
#include "base/parallel.h"

enum { STEPS = 48, FEW = 12, SOME = 24, MANY = 48, SHARED = 96, TRIES = 5 };

static const double STEP = 0.5;    /* spacings */
static const double BEND = 0.04;   /* of the edge, at a crest */
static const double BESIDE = 0.08; /* of the edge, beside it, but no more than ... */
static const double FAR = 0.4;     /* ... mean spacings */
static const double ROUND = 0.4;   /* curvature along by that across: more is no rib */
static const double BENT = 0.5;    /* curvature across by the length of the edge: less is no rib */
static const double TIGHT = 1.5;   /* curvature by the length of the edge: so tight it is a peak */
static const double FACING = 0.3;  /* z of a normal that is seen well from above */
static const double NOISY = 0.05;  /* spacings: less noise needs no more points */
static const double STILL = 0.03;  /* spacings: a step that is no longer comes to rest */

/* The surface over an edge, in equal steps. */
struct profile {
    const struct feature_cloud *cloud;
    struct vec3 a, b, up; /* ends, the normal of the neighbourhood */
    double length;        /* from a to b across `up` */
    int n;
    double height[STEPS + 1]; /* along `up`, over a */
    struct vec3 near[SHARED]; /* points about the middle that serve all steps, 0: too many would */
    size_t gathered;
};

/* Points about a place of the crest, which serve places beside it too, and how it runs there, unit;
 * none to begin with. */
struct hood {
    struct vec3 near[RIDGE_DIRECTION_LONGER * MANY], at, way;
    size_t n;
};

/* Twice as many points where there is much noise, from few on. */
static size_t points_needed(const struct feature_cloud *cloud, size_t few)
{
    double noisy = cloud->noise / cloud->spacing / NOISY - 1;

    return few + (size_t)((double)few * fmin(fmax(noisy, 0), 1));
}

/* Over the way from a to b, at the height h. */
static struct vec3 place_over(const struct profile *p, double part, double h)
{
    struct vec3 way = vec_reject(vec_sub(p->b, p->a), p->up);

    return vec_along(vec_along(p->a, part, way), h, p->up);
}

/* Is the neighbourhood seen from above, and no edge along its normal? */
static bool measure_way(struct profile *p)
{
    p->length = vec_length(vec_reject(vec_sub(p->b, p->a), p->up));
    return p->length > 0 && p->up.z > FACING;
}

/* The points that are nearest to any step lie in a ball about the middle. */
static void gather_points(struct profile *p)
{
    double each =
        (double)points_needed(p->cloud, FEW) / (PI * p->up.z); /* spacings^2 that a step takes */
    double reach = p->length / 2 / p->cloud->spacing + sqrt(each);
    double k = ceil(PI * p->up.z * reach * reach);

    p->gathered = 0;
    if (k <= SHARED)
        p->gathered = feature_near(p->cloud, vec_mix(p->a, p->b, 0.5), (size_t)k, p->near);
}

/* A quadric through the points nearest to a place. */
static bool fit_at(const struct profile *p, struct vec3 at, struct quadric *q)
{
    struct vec3 near[SOME];
    size_t k = points_needed(p->cloud, FEW);

    if (p->gathered >= k)
        k = neighbourhood_along(p->near, p->gathered, at, p->up, 1, k, near);
    else
        k = feature_near(p->cloud, at, k, near);
    return quadric_fit(near, k, at, p->up, q) == 0;
}

/* Follows the surface from a to b, each step from the height where the one before leads. */
static bool follow_surface(struct profile *p)
{
    double slope = 0, far = 3 * p->cloud->spacing;
    int n = (int)fmin(ceil(p->length / (STEP * p->cloud->spacing)), STEPS);

    p->n = n > 4 ? n : 4;
    p->height[0] = 0;
    gather_points(p);
    for (int i = 1; i < p->n; i++) {
        struct quadric q;
        struct vec3 way = vec_scale(1.0 / p->n, vec_reject(vec_sub(p->b, p->a), p->up));
        double h = p->height[i - 1] + slope;
        if (fit_at(p, place_over(p, (double)i / p->n, h), &q)) {
            if (!(fabs(q.c[0]) < far))
                return false;
            h += q.c[0];
            slope = q.c[1] * vec_dot(way, q.u) + q.c[2] * vec_dot(way, q.v);
        }
        p->height[i] = h;
    }
    p->height[p->n] = vec_dot(vec_sub(p->b, p->a), p->up);
    return true;
}

/* How far a height is over the chord from end to end. */
static double over_chord(const struct profile *p, double part, double height)
{
    return height - part * p->height[p->n];
}

/* The step that is highest over the chord, or deepest under it where sign is -1; 0: none is. */
static int extreme_step(const struct profile *p, double sign, double *over)
{
    int top = 0;

    *over = 0;
    for (int i = 1; i < p->n; i++) {
        double off = sign * over_chord(p, (double)i / p->n, p->height[i]);
        if (off > *over) {
            *over = off;
            top = i;
        }
    }
    return top;
}

/* The way in which a surface bends least, across its w. */
static struct vec3 straight_direction(const struct quadric *q, bool *rib, double *across)
{
    double xx = 2 * q->c[3], xy = q->c[4], yy = 2 * q->c[5];
    double middle = (xx + yy) / 2, half = hypot((xx - yy) / 2, xy);
    double turn = 0.5 * atan2(2 * xy, xx - yy) + (middle < 0 ? 0 : PI / 2);

    *across = middle + (middle < 0 ? -half : half);
    *rib = fabs(2 * middle - *across) <= ROUND * fabs(*across);
    return vec_along(vec_scale(cos(turn), q->u), sin(turn), q->v);
}

/* The points leave a surface along a rib no more than noise and rounding do. */
static bool is_explained(const struct profile *p, double rms, double round)
{
    return rms < 1.6 * p->cloud->noise + round * p->cloud->spacing;
}

/* The surface along the rib at a place beside the one whose points these are. */
static bool fit_beside(const struct profile *p, struct vec3 at, struct hood *hood,
                       struct quadric *q)
{
    size_t some = points_needed(p->cloud, SOME);
    struct ridge_direction best;
    double across;
    bool rib;

    if (!ridge_direction_follow(hood->near, hood->n, at, p->up, hood->way, some, &best))
        return false;
    *q = best.q;
    hood->way = best.way;
    straight_direction(q, &rib, &across);
    return fabs(across) * p->length >= BENT && quadric_normal(q).z > FACING &&
           is_explained(p, best.rms, 0.15);
}

/* The surface along the rib at a place that is near to it; false: there is no rib. */
static bool fit_along(const struct profile *p, struct vec3 at, struct hood *hood, struct quadric *q)
{
    size_t some = points_needed(p->cloud, SOME);
    double across;
    bool rib;

    /* cppcheck-suppress ctuuninitvar ; n alone says whether there is anything in it */
    if (hood->n > 0 && vec_distance(at, hood->at) < p->cloud->spacing)
        return fit_beside(p, at, hood, q);
    size_t k = feature_near(p->cloud, at, RIDGE_DIRECTION_LONGER * some, hood->near);
    hood->n = 0;
    if (quadric_fit(hood->near, k < some ? k : some, at, p->up, q) < 0)
        return false;
    struct vec3 way = straight_direction(q, &rib, &across);
    if (fabs(across) * p->length < BENT || quadric_normal(q).z < FACING)
        return false;
    if (rib) {
        struct ridge_direction best;
        if (!ridge_direction_find(hood->near, k, at, p->up, way, some, &best))
            return false;
        *q = best.q;
        hood->n = k;
        hood->at = at;
        hood->way = best.way;
        return quadric_normal(q).z > FACING && is_explained(p, best.rms, 0.15);
    }
    double rms = quadric_rms(q, hood->near, k < some ? k : some);
    return fabs(across) * p->length > TIGHT && is_explained(p, rms, 0.1);
}

/* Along the way over the edge: first and second derivative of the surface, by mm. */
static void slope_and_bend(const struct profile *p, const struct quadric *q, double *slope,
                           double *bend)
{
    struct vec3 way = vec_unit(vec_reject(vec_sub(p->b, p->a), p->up));
    double u = vec_dot(way, q->u), v = vec_dot(way, q->v);

    *slope = q->c[1] * u + q->c[2] * v;
    *bend = 2 * (q->c[3] * u * u + q->c[4] * u * v + q->c[5] * v * v);
}

static void add_point(struct crest *c, int at, double part, const struct quadric *q)
{
    for (int i = c->n++; i > at; i--) {
        c->part[i] = c->part[i - 1];
        c->place[i] = c->place[i - 1];
        c->normal[i] = c->normal[i - 1];
        c->kmax[i] = c->kmax[i - 1];
    }
    c->part[at] = part;
    c->place[at] = vec_along(q->origin, q->c[0], q->w);
    c->normal[at] = quadric_normal(q);
    c->kmax[at] = quadric_curvature(q);
    if (c->top >= at)
        c->top++;
}

/* The crest itself, from the step nearest to it. */
static bool find_crest(const struct profile *p, int step, double sign, struct crest *c)
{
    double part = (double)step / p->n, rim = fmin(0.06, 0.15 * p->cloud->spacing / p->length);
    double h = p->height[step];
    struct hood hood;
    struct quadric q;

    hood.n = 0;
    for (int i = 0; i < TRIES; i++) {
        double slope, bend;
        if (!fit_along(p, place_over(p, part, h), &hood, &q))
            return false;
        h += q.c[0];
        slope_and_bend(p, &q, &slope, &bend);
        if (!(sign * bend < 0))
            return false;
        double shift = -slope / bend / p->length, most = 2.0 / p->n;
        if (fabs(shift) * p->length < STILL * p->cloud->spacing)
            break;
        if (i + 1 < TRIES)
            part += fmin(fmax(shift, -most), most);
    }
    double least = fmax(BEND * p->length / 2, 1.3 * p->cloud->noise);
    if (!(part > rim && part < 1 - rim) || sign * over_chord(p, part, h) < least)
        return false;
    add_point(c, 0, part, &q);
    c->top = 0;
    return true;
}

/* The step that is farthest off the chord between two places on the way. */
static int off_chord(const struct profile *p, double from, double h0, double to, double h1,
                     double *most)
{
    int worst = -1;

    *most = 0;
    for (int i = 1; i < p->n; i++) {
        double part = (double)i / p->n, s = (part - from) / (to - from);
        if (!(s > 0 && s < 1))
            continue;
        double off = fabs(p->height[i] - h0 - s * (h1 - h0));
        if (off > *most) {
            *most = off;
            worst = i;
        }
    }
    return worst;
}

/* Puts a point where the surface is farthest off the chain.  False: nowhere far enough. */
static bool add_farthest(const struct profile *p, struct crest *c)
{
    double apart = p->cloud->spacing / p->length;
    double most = fmax(fmin(BESIDE * p->length, FAR * p->cloud->spacing), 2 * p->cloud->noise);
    int worst = -1, at = 0;

    for (int i = 0; i <= c->n; i++) {
        double from = i > 0 ? c->part[i - 1] : 0, to = i < c->n ? c->part[i] : 1, off;
        double h0 = i > 0 ? vec_dot(vec_sub(c->place[i - 1], p->a), p->up) : 0;
        double h1 = i < c->n ? vec_dot(vec_sub(c->place[i], p->a), p->up) : p->height[p->n];
        int step = off_chord(p, from, h0, to, h1, &off);
        double part = (double)step / p->n;
        if (off > most && part - from > apart && to - part > apart) {
            most = off;
            worst = step;
            at = i;
        }
    }
    double part = (double)worst / p->n;
    struct hood hood;
    struct quadric q;
    hood.n = 0;
    if (worst < 0 || !fit_along(p, place_over(p, part, p->height[worst]), &hood, &q))
        return false;
    add_point(c, at, part, &q);
    return true;
}

struct crest crest_find(const struct feature_cloud *cloud, struct vec3 a, struct vec3 b,
                        struct vec3 up)
{
    struct profile p = {.cloud = cloud, .a = a, .b = b, .up = up};
    struct crest c = {.n = 0, .top = -1};
    double sign[2] = {1, -1}, over[2];
    int step[2];

    if (!measure_way(&p) || !follow_surface(&p))
        return c;
    for (int i = 0; i < 2; i++)
        step[i] = extreme_step(&p, sign[i], &over[i]);
    int first = over[0] > over[1] ? 0 : 1;
    for (int i = 0; i < 2 && c.n == 0; i++) {
        int k = i == 0 ? first : 1 - first;
        if (over[k] > fmax(BEND * p.length, cloud->noise))
            find_crest(&p, step[k], sign[k], &c);
    }
    while (c.n < CREST_MOST && add_farthest(&p, &c))
        ;
    return c;
}

enum { LOOKS = 3, CORNERS = 3 * (CREST_MOST + 1) };

static const double TURN = 0.99452189536827333; /* cos 6 degrees between normals */
static const double OFF = 0.10452846326765347;  /* sin 6 degrees between an edge and the surface */
static const double LONG = 4.5;                 /* mean spacings */
static const double CLOSE = 0.25;               /* mean spacings: the corner opposite lies on it */

struct search {
    struct mesh *mesh;
    const struct mesh_edges *edges;
    struct faces part;  /* facets with a side that may cut off a crest, whose edges these are */
    struct sizes facet; /* which they are of the mesh */
    struct feature_cloud cloud;
    size_t first, last;  /* vertices of creases and walls, and those from there on are new */
    size_t most, looked; /* edges that may be looked at in all; that were */
    size_t widest;       /* facets that the mesh had, in the look when it had most */
    bool all;            /* edges may cut off a crest, wherever they are */
    bool bound;          /* there were more */
    size_t fresh;        /* those from there on are of the last look: other edges were looked at */
    struct sizes edge;   /* to be looked at */
    struct crest *crest; /* of each of those */
    int *of;             /* which one each edge of the mesh is, -1: none */
    int *vertex;         /* the first new one of each */
    struct faces face;   /* what comes of the facets */
};

/* On a small mesh all may. */
static bool may_cross(const struct search *s, int v, int w)
{
    const struct vec3 *n = s->mesh->normal.item, *p = s->mesh->vertex.item;

    struct vec3 way = vec_sub(p[w], p[v]);
    double length = vec_length(way);

    return s->all || vec_dot(n[v], n[w]) < TURN || length > LONG * s->cloud.spacing ||
           fabs(vec_dot(way, n[v])) > OFF * length || fabs(vec_dot(way, n[w])) > OFF * length;
}

/* The facets with such a side: edges are made of these alone, for smooth ground has none. */
static void choose_facets(struct search *s)
{
    s->part.n = s->facet.n = 0;
    for (size_t f = 0; f < s->mesh->face.n; f++) {
        const int *v = s->mesh->face.item[f].v;
        if (!may_cross(s, v[0], v[1]) && !may_cross(s, v[1], v[2]) && !may_cross(s, v[2], v[0]))
            continue;
        *array_push(&s->part) = s->mesh->face.item[f];
        *array_push(&s->facet) = f;
    }
}

/* Neither of a crease or wall, nor put into a row that has points between its own by now. */
static bool is_free(const struct search *s, const struct mesh_edge *e)
{
    const struct ints *row = &s->mesh->row;
    bool along = row->n > 0 && row->item[e->v[0]] >= 0 && row->item[e->v[0]] == row->item[e->v[1]];

    for (int i = 0; i < 2; i++) {
        size_t v = (size_t)e->v[i];
        if (v >= s->first && (v < s->last || along))
            return false;
    }
    return e->facet[0] >= 0 && (size_t)e->v[1] >= s->fresh;
}

/* The corner opposite, on one side, lies so close to the edge that a point put on the edge may come
 * to lie beyond it, and fold the facet over: it is on the crest by now. */
static bool is_taken(const struct search *s, const struct mesh_edge *e)
{
    const struct vec3 *p = s->mesh->vertex.item;
    double close = CLOSE * s->cloud.spacing;

    for (int i = 0; i < 2 && e->facet[i] >= 0; i++) {
        const int *v = s->part.item[e->facet[i]].v;
        int opposite = v[0] ^ v[1] ^ v[2] ^ e->v[0] ^ e->v[1];
        struct vec3 at = p[opposite];
        if (vec_distance(at, vec_segment_nearest(p[e->v[0]], p[e->v[1]], at)) < close)
            return true;
    }
    return false;
}

static void choose_edges(struct search *s)
{
    for (size_t e = 0; e < s->edges->n; e++) {
        const struct mesh_edge *edge = &s->edges->edge[e];
        s->of[e] = -1;
        if (!is_free(s, edge) || !may_cross(s, edge->v[0], edge->v[1]) || is_taken(s, edge))
            continue;
        s->of[e] = (int)s->edge.n;
        *array_push(&s->edge) = e;
    }
}

/* The normal of the neighbourhood of an edge: the mean of those of its ends and of the corners
 * opposite. */
static struct vec3 normal_about(const struct search *s, const struct mesh_edge *e)
{
    const struct vec3 *normal = s->mesh->normal.item;
    struct vec3 sum = vec_add(normal[e->v[0]], normal[e->v[1]]);

    for (int i = 0; i < 2 && e->facet[i] >= 0; i++) {
        const int *v = s->part.item[e->facet[i]].v;
        sum = vec_add(sum, normal[v[0] ^ v[1] ^ v[2] ^ e->v[0] ^ e->v[1]]);
    }
    return vec_unit(sum);
}

static void find_crests(void *context, size_t from, size_t to)
{
    const struct search *s = context;
    const struct vec3 *at = s->mesh->vertex.item;

    for (size_t i = from; i < to; i++) {
        const struct mesh_edge *e = &s->edges->edge[s->edge.item[i]];
        s->crest[i] = crest_find(&s->cloud, at[e->v[0]], at[e->v[1]], normal_about(s, e));
    }
}

static void add_vertices(struct search *s, size_t i)
{
    struct mesh *m = s->mesh;
    const int *v = s->edges->edge[s->edge.item[i]].v;
    const struct crest *c = &s->crest[i];
    bool rows = m->row.n > 0 && m->row.item[v[0]] == m->row.item[v[1]];

    s->vertex[i] = (int)m->vertex.n;
    for (int k = 0; k < c->n; k++) {
        *array_push(&m->vertex) = c->place[k];
        *array_push(&m->normal) = c->normal[k];
        if (m->kmax.n > 0)
            *array_push(&m->kmax) = c->kmax[k];
        if (m->row.n == 0)
            continue;
        int row = rows ? m->row.item[v[0]] : -1, col = rows ? m->col.item[v[0]] : -1;
        *array_push(&m->row) = row;
        *array_push(&m->col) = col;
    }
}

/* A facet and what its sides got, as a polygon: where no three of its corners lie on a line, for
 * its sides are bent inwards a little. */
struct polygon {
    size_t n;
    int corner[CORNERS];
    struct uv at[CORNERS];
    int tops;
    size_t top[3]; /* which corners are on crests */
};

static void add_side(const struct search *s, size_t facet, int i, struct polygon *p)
{
    const double inwards = 1e-3, height = 0.86602540378443865;
    const struct uv plane[3] = {{0, 0}, {1, 0}, {0.5, height}};
    struct uv a = plane[i], b = plane[(i + 1) % 3];
    int e = s->edges->of[facet][i], which = s->of[e];
    const struct crest *c = which < 0 ? NULL : &s->crest[which];
    bool forth = s->part.item[facet].v[i] == s->edges->edge[e].v[0];

    p->corner[p->n] = s->part.item[facet].v[i];
    p->at[p->n++] = a;
    for (int k = 0; c && k < c->n; k++) {
        int j = forth ? k : c->n - 1 - k;
        double t = forth ? c->part[j] : 1 - c->part[j], in = inwards * t * (1 - t);
        if (j == c->top && p->tops < 3)
            p->top[p->tops++] = p->n;
        p->corner[p->n] = s->vertex[which] + j;
        p->at[p->n++] = (struct uv){a.u + t * (b.u - a.u) - in * (b.v - a.v),
                                    a.v + t * (b.v - a.v) + in * (b.u - a.u)};
    }
}

/* The part of the polygon from one corner to another. */
static void cut_part(const struct polygon *p, size_t from, size_t to, struct faces *face)
{
    struct polygon part = {.n = 0};

    for (size_t i = from;; i = (i + 1) % p->n) {
        part.corner[part.n] = p->corner[i];
        part.at[part.n++] = p->at[i];
        if (i == to)
            break;
    }
    earclip(part.at, part.corner, part.n, face);
}

/* One of the part.  Cut first from crest to crest, or from the one crest to the corner opposite. */
static void split_facet(struct search *s, size_t facet)
{
    struct polygon p = {.n = 0};
    size_t side[3];

    for (int i = 0; i < 3; i++) {
        side[i] = p.n;
        add_side(s, facet, i, &p);
    }
    if (p.n == 3) {
        *array_push(&s->face) = s->part.item[facet];
        return;
    }
    if (p.tops == 1) {
        int on = p.top[0] > side[2] ? 2 : p.top[0] > side[1] ? 1 : 0;
        p.top[p.tops++] = side[(on + 2) % 3];
    }
    if (p.tops == 2) {
        cut_part(&p, p.top[0], p.top[1], &s->face);
        cut_part(&p, p.top[1], p.top[0], &s->face);
    } else {
        earclip(p.at, p.corner, p.n, &s->face);
    }
}

static size_t insert_crests(struct search *s)
{
    size_t found = 0;

    for (size_t i = 0; i < s->edge.n; i++) {
        add_vertices(s, i);
        found += s->crest[i].n > 0;
    }
    for (size_t f = 0, part = 0; f < s->mesh->face.n && found > 0; f++) {
        if (part < s->facet.n && s->facet.item[part] == f)
            split_facet(s, part++);
        else
            *array_push(&s->face) = s->mesh->face.item[f];
    }
    if (found > 0) {
        array_free(&s->mesh->face);
        s->mesh->face = s->face;
        s->face = (struct faces){0};
    }
    return found;
}

/* Looks once at the edges of the vertices from `fresh` on.  The points are sorted when it is
 * needed. */
static size_t search_once(struct search *s, size_t fresh, struct vec3 *point, size_t n,
                          struct point_grid *scan, const struct crest_mesh_options *options)
{
    size_t facets = s->mesh->face.n, found = 0;
    struct mesh part = {.vertex = s->mesh->vertex};

    s->widest = facets > s->widest ? facets : s->widest;
    s->all = effort_covers(EFFORT_CREST_FACETS, options->effort, facets);
    choose_facets(s);
    if (s->part.n == 0)
        return 0;
    part.face = s->part;
    struct mesh_edges edges = mesh_edges_find(&part);
    s->edges = &edges;
    s->of = mem_alloc(edges.n, sizeof *s->of);
    s->fresh = fresh;
    s->edge.n = s->face.n = 0;
    choose_edges(s);
    s->looked += s->edge.n;
    s->bound = s->looked > s->most;
    if (s->edge.n > 0 && !s->bound) {
        struct error error;
        if (!scan->first &&
            point_grid_make(point, n, options->spacing, options->threads, scan, &error) < 0)
            *scan = (struct point_grid){.n = 0};
        s->crest = mem_alloc(s->edge.n, sizeof *s->crest);
        s->vertex = mem_alloc(s->edge.n, sizeof *s->vertex);
        parallel_for(options->threads, s->edge.n, find_crests, s);
        found = insert_crests(s);
        free(s->crest);
        free(s->vertex);
    }
    free(s->of);
    mesh_edges_free(&edges);
    s->edges = NULL;
    return found;
}

struct crests crest_mesh_keep(struct mesh *mesh, size_t first, struct vec3 *point, size_t n,
                              const struct crest_mesh_options *options)
{
    bool large = !effort_covers(EFFORT_CREST_POINTS, options->effort, n);
    struct crests all = {.bound = large ? EFFORT_CRESTS_LARGE : EFFORT_CRESTS};
    struct point_grid scan = {.n = 0};
    if (options->sorted)
        scan = *options->sorted;
    struct search s = {
        .mesh = mesh,
        .cloud = {.scan = &scan, .spacing = options->spacing, .noise = options->noise},
        .first = first,
        .last = mesh->vertex.n,
        .most = effort_most(all.bound, options->effort)};
    size_t fresh = 0, found = 1;

    /* the edges between new points may cut off the crest where one is missing */
    for (int i = 0; i < LOOKS && found > 0; i++) {
        size_t next = mesh->vertex.n;
        found = search_once(&s, fresh, point, n, &scan, options);
        all.found += found;
        fresh = next;
    }
    all.facets = s.widest;
    all.wanted = s.bound ? s.looked : 0;
    if (!options->sorted)
        point_grid_free(&scan);
    array_free(&s.edge);
    array_free(&s.part);
    array_free(&s.facet);
    return all;
}
