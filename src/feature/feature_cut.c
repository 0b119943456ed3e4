/* feature_cut - see feature_steps.h. */
#include "feature_steps.h"

#include <stdlib.h>

/* The vertices put into an edge, as the side of a facet goes along it: first and last are on the
 * sheets of the side's ends, the inner ones on the wall. */
struct chain {
    int n; /* 0, 2, 4 */
    int v[4];
};

struct splitting {
    struct mesh *mesh;
    const struct mesh_edges *edges;
    struct chain *chain; /* of each edge, from its v[0] to its v[1] */
    struct faces face;   /* what comes of the facets */
};

static int add_vertex(struct mesh *mesh, struct vec3 place, struct vec3 normal, int row, int col)
{
    *array_push(&mesh->vertex) = place;
    *array_push(&mesh->normal) = normal;
    if (mesh->row.n > 0) {
        *array_push(&mesh->row) = row;
        *array_push(&mesh->col) = col;
    }
    if (mesh->kmax.n > 0)
        *array_push(&mesh->kmax) = 0;
    return (int)mesh->vertex.n - 1;
}

static struct chain add_chain(struct mesh *mesh, const struct mesh_edge *edge,
                              const struct feature *f)
{
    struct chain c = {0};
    bool rows = mesh->row.n > 0 && mesh->row.item[edge->v[0]] == mesh->row.item[edge->v[1]];
    int row = rows ? mesh->row.item[edge->v[0]] : -1, col = rows ? mesh->col.item[edge->v[0]] : -1;

    c.v[c.n++] = add_vertex(mesh, f->place[0], f->normal[0], row, col);
    if (f->kind == FEATURE_WALL) {
        c.v[c.n++] = add_vertex(mesh, f->place[0], f->wall, row, col);
        c.v[c.n++] = add_vertex(mesh, f->place[1], f->wall, row, col);
    }
    c.v[c.n++] = add_vertex(mesh, f->place[1], f->normal[1], row, col);
    return c;
}

/* The chain of the side of a facet that begins at its corner i. */
static struct chain chain_of(const struct splitting *s, size_t facet, int i)
{
    int e = s->edges->of[facet][i];
    struct chain c = s->chain[e], back = {.n = c.n};

    if (s->mesh->face.item[facet].v[i] == s->edges->edge[e].v[0])
        return c;
    for (int k = 0; k < c.n; k++)
        back.v[k] = c.v[c.n - 1 - k];
    return back;
}

static bool same_place(const struct mesh *mesh, int a, int b)
{
    return vec_distance(mesh->vertex.item[a], mesh->vertex.item[b]) < 1e-9;
}

static void add_facet(struct splitting *s, int a, int b, int c)
{
    const struct mesh *m = s->mesh;

    if (same_place(m, a, b) || same_place(m, b, c) || same_place(m, c, a))
        return;
    *array_push(&s->face) = (struct face){{a, b, c}};
}

/* Two facets a b c d, divided by the shorter diagonal. */
static void add_four(struct splitting *s, int a, int b, int c, int d)
{
    const struct vec3 *p = s->mesh->vertex.item;

    if (vec_distance(p[a], p[c]) <= vec_distance(p[b], p[d])) {
        add_facet(s, a, b, c);
        add_facet(s, a, c, d);
    } else {
        add_facet(s, b, c, d);
        add_facet(s, b, d, a);
    }
}

/* The feature ends on the side from corner i: the opposite corner sees all of it. */
static void split_one(struct splitting *s, const int v[3], const struct chain *c, int i)
{
    int a = v[i], b = v[(i + 1) % 3], far = v[(i + 2) % 3];

    add_facet(s, a, c->v[0], far);
    if (c->n == 4)
        add_facet(s, c->v[1], c->v[2], far);
    add_facet(s, c->v[c->n - 1], b, far);
}

static struct feature_corner_plane plane_at(const struct splitting *s, int v)
{
    return (struct feature_corner_plane){s->mesh->vertex.item[v], s->mesh->normal.item[v]};
}

/* The sheet that two vertices are on. */
static struct feature_corner_plane sheet_at(const struct splitting *s, int v, int w)
{
    return feature_corner_mean(plane_at(s, v), plane_at(s, w));
}

/* A vertex at a corner, with the normal that another one has. */
static int corner_like(struct splitting *s, struct vec3 place, int v)
{
    return add_vertex(s->mesh, place, s->mesh->normal.item[v], -1, -1);
}

/* The same on a sheet that two vertices are on; *second is another one where their normals
 * differ. */
static int corner_on(struct splitting *s, struct vec3 place, int v, int w, int *second)
{
    const double same = 0.99;
    bool one = vec_dot(s->mesh->normal.item[v], s->mesh->normal.item[w]) > same;

    if (one)
        return *second = add_vertex(s->mesh, place, sheet_at(s, v, w).normal, -1, -1);
    *second = corner_like(s, place, w);
    return corner_like(s, place, v);
}

/* What two chains bound: corner a's side of the feature, and that of b and c. */
struct between {
    int a, b, c;
    int a_out, a_in; /* the first of the chain from a to b, the last of that from c to a */
    int b_out, c_in; /* the other ends of these */
};

/* Facets about a corner of the feature, on_a on the side of a, on_b on the other. */
static void fan_about(struct splitting *s, const struct between *t, struct vec3 on_a,
                      struct vec3 on_b)
{
    int second, first = corner_on(s, on_a, t->a_out, t->a_in, &second);

    add_facet(s, t->a, t->a_out, first);
    add_facet(s, t->a, second, t->a_in);
    first = corner_on(s, on_b, t->b_out, t->c_in, &second);
    add_facet(s, first, t->b_out, t->b);
    add_facet(s, first, t->b, t->c);
    add_facet(s, second, t->c, t->c_in);
}

/* A quadrangle of two walls that turn within the facet. */
static void wall_to(struct splitting *s, const struct chain *out, struct vec3 top, struct vec3 foot)
{
    int v = corner_like(s, top, out->v[1]), w = corner_like(s, foot, out->v[1]);

    add_four(s, out->v[1], out->v[2], w, v);
}

/* Two walls that meet within the facet.  False: they do not. */
static bool walls_meet(struct splitting *s, const struct between *t, const struct chain *out,
                       const struct chain *in)
{
    const struct vec3 *at = s->mesh->vertex.item;
    const struct vec3 corner[3] = {at[t->a], at[t->b], at[t->c]};
    struct feature_corner_plane plane[3] = {plane_at(s, out->v[1]), plane_at(s, in->v[1]),
                                            sheet_at(s, t->a_out, t->a_in)};
    struct vec3 on_a, on_b;

    if (!feature_corner(plane, corner, &on_a))
        return false;
    plane[2] = sheet_at(s, t->b_out, t->c_in);
    if (!feature_corner(plane, corner, &on_b))
        return false;
    struct chain back = {4, {in->v[3], in->v[2], in->v[1], in->v[0]}};
    fan_about(s, t, on_a, on_b);
    wall_to(s, out, on_a, on_b);
    int v = corner_like(s, on_a, back.v[1]), w = corner_like(s, on_b, back.v[1]);
    add_four(s, back.v[2], back.v[1], v, w);
    return true;
}

/* Two creases about one sheet that meet within the facet.  False: they do not. */
static bool creases_meet(struct splitting *s, const struct between *t)
{
    const struct vec3 *at = s->mesh->vertex.item, *normal = s->mesh->normal.item;
    const struct vec3 corner[3] = {at[t->a], at[t->b], at[t->c]};
    double turn_a = vec_dot(normal[t->a_out], normal[t->a_in]);
    bool one = turn_a > vec_dot(normal[t->b_out], normal[t->c_in]);
    struct feature_corner_plane plane[3] = {one ? plane_at(s, t->b_out) : plane_at(s, t->a_out),
                                            one ? plane_at(s, t->c_in) : plane_at(s, t->a_in),
                                            one ? sheet_at(s, t->a_out, t->a_in)
                                                : sheet_at(s, t->b_out, t->c_in)};
    struct vec3 on;

    if (!feature_corner(plane, corner, &on))
        return false;
    fan_about(s, t, on, on);
    return true;
}

/* The feature separates corner i from the other two; `out` is on the side that begins at it, `in`
 * on the one that ends there. */
static void split_two(struct splitting *s, const int v[3], int i, const struct chain *out,
                      const struct chain *in)
{
    int a = v[i], b = v[(i + 1) % 3], c = v[(i + 2) % 3];
    int out_wall = out->n == 4 ? 1 : 0, in_wall = in->n == 4 ? 1 : 0;
    struct between t = {a, b, c, out->v[0], in->v[in->n - 1], out->v[out->n - 1], in->v[0]};

    if ((out_wall && in_wall && walls_meet(s, &t, out, in)) ||
        (!out_wall && !in_wall && creases_meet(s, &t)))
        return;
    add_facet(s, a, t.a_out, t.a_in);
    if (out_wall || in_wall)
        add_four(s, out->v[out_wall], out->v[out->n - 1 - out_wall], in->v[in_wall],
                 in->v[in->n - 1 - in_wall]);
    add_four(s, t.b_out, b, c, t.c_in);
}

/* Three sheets that meet within the facet.  False: they do not. */
static bool sheets_meet(struct splitting *s, const int v[3], const struct chain c[3])
{
    const struct vec3 *at = s->mesh->vertex.item;
    const struct vec3 corner[3] = {at[v[0]], at[v[1]], at[v[2]]};
    struct feature_corner_plane plane[3];
    struct vec3 on;

    for (int i = 0; i < 3; i++) {
        if (c[i].n != 2)
            return false;
        plane[i] = sheet_at(s, c[i].v[0], c[(i + 2) % 3].v[1]);
    }
    if (!feature_corner(plane, corner, &on))
        return false;
    for (int i = 0; i < 3; i++) {
        int last = c[(i + 2) % 3].v[1], second, first = corner_on(s, on, c[i].v[0], last, &second);
        add_facet(s, v[i], c[i].v[0], first);
        add_facet(s, v[i], second, last);
    }
    return true;
}

/* Features on all sides: a corner facet each, and what is left between them. */
static void split_three(struct splitting *s, const int v[3], const struct chain c[3])
{
    int around[6], n = 0;

    if (sheets_meet(s, v, c))
        return;
    for (int i = 0; i < 3; i++) {
        const struct chain *in = &c[(i + 2) % 3];
        add_facet(s, v[i], c[i].v[0], in->v[in->n - 1]);
        around[n++] = c[i].v[c[i].n == 4 ? 1 : 0];
        around[n++] = c[i].v[c[i].n == 4 ? 2 : 1];
    }
    for (int i = 1; i + 1 < n; i++)
        add_facet(s, around[0], around[i], around[i + 1]);
}

static void split_facet(struct splitting *s, size_t facet)
{
    const int *v = s->mesh->face.item[facet].v;
    struct chain c[3];
    int crossed = 0, whole = 0, one = 0;

    for (int i = 0; i < 3; i++) {
        c[i] = chain_of(s, facet, i);
        crossed += c[i].n > 0;
        whole = c[i].n > 0 ? whole : i;
        one = c[i].n > 0 ? i : one;
    }
    if (crossed == 0) {
        *array_push(&s->face) = s->mesh->face.item[facet];
    } else if (crossed == 1) {
        split_one(s, v, &c[one], one);
    } else if (crossed == 2) {
        int corner = (whole + 2) % 3;
        split_two(s, v, corner, &c[corner], &c[(corner + 2) % 3]);
    } else {
        split_three(s, v, c);
    }
}

void feature_cut(struct mesh *mesh, const struct mesh_edges *edges, const struct feature *feature)
{
    struct splitting s = {.mesh = mesh, .edges = edges};

    s.chain = mem_alloc(edges->n, sizeof *s.chain);
    for (size_t e = 0; e < edges->n; e++)
        if (feature[e].kind != FEATURE_NONE)
            s.chain[e] = add_chain(mesh, &edges->edge[e], &feature[e]);
    for (size_t f = 0; f < mesh->face.n; f++)
        split_facet(&s, f);
    array_free(&mesh->face);
    mesh->face = s.face;
    free(s.chain);
}
