/* feature_relocate - see feature_steps.h. */
#include "feature_steps.h"

#include <stdlib.h>
#include <string.h>

static const double CLEAR = 0.25; /* of the edge, between a vertex and the feature ... */
static const double KNOWN = 6;    /* ... or of so many spacings: as far as its sheets are known */

static const double ROOM = 0.1;     /* of the side of a facet, between it and a corner */
static const double FARTHEST = 0.4; /* of the side: so far vertices move for a corner */

/* What the features do to a vertex. */
struct beside {
    bool near;
    struct vec3 shift; /* away from the nearest one */
};

/* Across a feature, between the two sheets, from its end 1 to its end 0 (the edge's ends). */
static struct vec3 across_of(const struct feature *f, const struct vec3 at[2])
{
    struct vec3 across = vec_unit(vec_cross(f->along, vec_add(f->end[0], f->end[1])));

    return vec_dot(vec_sub(at[0], at[1]), across) < 0 ? vec_scale(-1, across) : across;
}

/* On which side of it a point near a feature is: at a wall by its height, for it may be on it. */
static int side_of(const struct feature *f, const struct vec3 at[2], struct vec3 p)
{
    if (f->kind == FEATURE_WALL)
        return fabs(p.z - f->place[0].z) <= fabs(p.z - f->place[1].z) ? 0 : 1;
    return vec_dot(vec_sub(p, f->place[0]), across_of(f, at)) >= 0 ? 0 : 1;
}

/* Moves a vertex that is nearer to the feature than `clear`, along the sheet of its side; onto it
 * when it is further off it than `aloof`, as one that is on the wall. */
static void keep_away(struct beside *b, const struct feature *f, int i, const struct vec3 at[2],
                      struct vec3 p, double clear, double aloof)
{
    struct vec3 across = vec_scale(i == 0 ? 1 : -1, across_of(f, at));
    struct vec3 away = vec_unit(vec_reject(across, f->end[i])); /* on the sheet */
    double off = vec_dot(vec_sub(p, f->place[i]), away);
    double above = vec_dot(vec_sub(p, f->place[i]), f->end[i]);
    bool wrong = fabs(above) > aloof && (f->kind == FEATURE_WALL || fabs(above) < clear / 2);
    struct vec3 shift = vec_along(vec_scale(clear - off, away), wrong ? -above : 0, f->end[i]);

    b->near = true;
    if (off < clear && vec_length(shift) > vec_length(b->shift))
        b->shift = shift;
}

/* Do features that run different ways cross the facet?  Where two walls meet at a corner a vertex
 * may well be behind one of them. */
static bool has_corner(const struct feature_relocate *s, int facet)
{
    const double same = 0.94;
    const struct feature *first = NULL;

    for (int i = 0; i < 3; i++) {
        const struct feature *f = &s->feature[s->edges->of[facet][i]];
        if (f->kind == FEATURE_NONE)
            continue;
        if (first && fabs(vec_dot(first->along, f->along)) < same)
            return true;
        first = first ? first : f;
    }
    return false;
}

/* The vertices of the two facets beside an edge keep away from its feature. */
static void clear_edge(const struct feature_relocate *s, size_t e, struct beside *beside)
{
    const struct mesh_edge *edge = &s->edges->edge[e];
    const struct feature *f = &s->feature[e];
    const struct vec3 *p = s->mesh->vertex.item;
    const struct vec3 at[2] = {p[edge->v[0]], p[edge->v[1]]};
    double length = hypot(at[1].x - at[0].x, at[1].y - at[0].y);
    double clear = CLEAR * fmin(length, KNOWN * s->spacing);
    double aloof = 3 * s->noise + 0.1 * s->spacing;

    for (int i = 0; i < 2; i++)
        keep_away(&beside[edge->v[i]], f, i, at, at[i], clear, aloof);
    for (int k = 0; k < 2 && edge->facet[k] >= 0; k++) {
        const int *v = s->mesh->face.item[edge->facet[k]].v;
        int third = v[0] + v[1] + v[2] - edge->v[0] - edge->v[1];
        int i = side_of(f, at, p[third]);
        struct vec3 off = vec_sub(p[third], f->place[i]);
        bool behind = vec_dot(off, across_of(f, at)) * (i == 0 ? 1 : -1) < -clear / 2;
        if (!(behind && has_corner(s, edge->facet[k])) && fabs(vec_dot(off, f->along)) < length)
            keep_away(&beside[third], f, i, at, p[third], clear, aloof);
    }
}

/* On the side of a vertex of its edge. */
static struct feature_corner_plane sheet_of(const struct feature_relocate *s, size_t e, int v)
{
    const struct feature *f = &s->feature[e];
    int i = s->edges->edge[e].v[0] == v ? 0 : 1;

    return (struct feature_corner_plane){f->place[i], f->normal[i]};
}

/* Where the features of the edges from a to b and from c to a meet. */
static bool find_corner(const struct feature_relocate *s, const size_t e[2], int a, int b, int c,
                        struct vec3 *corner)
{
    const struct feature *f[2] = {&s->feature[e[0]], &s->feature[e[1]]};
    struct feature_corner_plane on_a[2] = {sheet_of(s, e[0], a), sheet_of(s, e[1], a)};
    struct feature_corner_plane on_b[2] = {sheet_of(s, e[0], b), sheet_of(s, e[1], c)};
    struct feature_corner_plane plane[3] = {{on_b[0].place, f[0]->wall},
                                            {on_b[1].place, f[1]->wall},
                                            feature_corner_mean(on_b[0], on_b[1])};

    if (f[0]->kind == FEATURE_CREASE) {
        double turn_a = vec_dot(on_a[0].normal, on_a[1].normal);
        bool one = turn_a > vec_dot(on_b[0].normal, on_b[1].normal);
        plane[0] = one ? on_b[0] : on_a[0];
        plane[1] = one ? on_b[1] : on_a[1];
        plane[2] = one ? feature_corner_mean(on_a[0], on_a[1]) : plane[2];
    }
    return feature_corner_of(plane, on_b[0].place, corner);
}

/* A corner that juts out of the facet over the side from b to c: these make room for it. */
static void make_room(const struct feature_relocate *s, const size_t e[2], int a, int b, int c,
                      struct beside *beside)
{
    const struct vec3 *p = s->mesh->vertex.item;
    struct vec3 corner, side = vec_sub(p[c], p[b]);
    double length = hypot(side.x, side.y);
    struct vec3 out = vec(side.y / length, -side.x / length, 0);
    int v[2] = {b, c};

    if (!(length > 0) || s->feature[e[0]].kind != s->feature[e[1]].kind ||
        !find_corner(s, e, a, b, c, &corner))
        return;
    struct vec3 off = vec_sub(corner, p[b]);
    double over = vec_dot(off, out) + ROOM * length, along = (off.x * side.x + off.y * side.y);
    if (!(over > 0 && over < FARTHEST * length && along > 0 && along < length * length))
        return;
    for (int i = 0; i < 2; i++) {
        struct vec3 normal = sheet_of(s, e[i], v[i]).normal;
        struct vec3 shift = vec_scale(over, vec_unit(vec_reject(out, normal)));
        if (vec_length(shift) > vec_length(beside[v[i]].shift))
            beside[v[i]].shift = shift;
    }
}

/* The same for each facet that two features cross. */
static void clear_corners(const struct feature_relocate *s, struct beside *beside)
{
    for (size_t f = 0; f < s->mesh->face.n; f++) {
        const int *v = s->mesh->face.item[f].v, *of = s->edges->of[f];
        int crossed = 0, whole = 0;
        for (int i = 0; i < 3; i++) {
            bool cross = s->feature[of[i]].kind != FEATURE_NONE;
            crossed += cross;
            whole = cross ? whole : i;
        }
        int a = (whole + 2) % 3, b = whole, c = (whole + 1) % 3;
        const size_t e[2] = {(size_t)of[a], (size_t)of[c]};
        if (crossed == 2)
            make_room(s, e, v[a], v[b], v[c], beside);
    }
}

/* Which vertices are beside a feature, and where they are to go. */
static struct beside *find_beside(const struct feature_relocate *s)
{
    struct beside *beside = mem_alloc(s->mesh->vertex.n, sizeof *beside);

    for (size_t e = 0; e < s->edges->n; e++)
        if (s->feature[e].kind != FEATURE_NONE)
            clear_edge(s, e, beside);
    clear_corners(s, beside);
    return beside;
}

void feature_relocate_places(const struct feature_relocate *s, unsigned char *beside)
{
    struct mesh *m = s->mesh;
    struct beside *found = find_beside(s);

    for (size_t v = 0; v < m->vertex.n; v++) {
        beside[v] = found[v].near;
        m->vertex.item[v] = vec_add(m->vertex.item[v], found[v].shift);
    }
    free(found);
}

void feature_relocate_normals(const struct feature_relocate *s)
{
    struct mesh *m = s->mesh;
    struct vec3 *sum = mem_alloc(m->vertex.n, sizeof *sum);

    for (size_t e = 0; e < s->edges->n; e++) {
        for (int i = 0; i < 2 && s->feature[e].kind != FEATURE_NONE; i++) {
            struct vec3 *n = &sum[s->edges->edge[e].v[i]];
            *n = vec_add(*n, s->feature[e].end[i]);
        }
    }
    for (size_t v = 0; v < m->vertex.n; v++)
        if (vec_length(sum[v]) > 0)
            m->normal.item[v] = vec_unit(sum[v]);
    free(sum);
}

void feature_relocate_feet(const struct feature_relocate *s)
{
    struct mesh *m = s->mesh;
    struct vec3 *sum = mem_alloc(m->vertex.n, sizeof *sum);
    double *count = mem_alloc(m->vertex.n, sizeof *count);

    for (size_t e = 0; e < s->edges->n; e++) {
        const struct feature *f = &s->feature[e];
        for (int i = 0; i < 2 && f->kind != FEATURE_NONE; i++) {
            int v = s->edges->edge[e].v[i];
            if (vec_distance(f->place[i], m->vertex.item[v]) > f->known)
                continue;
            sum[v] = vec_add(sum[v], vec_sub(f->foot[i], m->vertex.item[v]));
            count[v]++;
        }
    }
    for (size_t v = 0; v < m->vertex.n; v++)
        if (count[v] > 0)
            m->vertex.item[v] = vec_along(m->vertex.item[v], 1 / count[v], sum[v]);
    free(sum);
    free(count);
}

void feature_relocate_back(const struct feature_relocate *s, const struct mesh *before)
{
    struct mesh *m = s->mesh;
    struct beside *found = find_beside(s);

    for (size_t v = 0; v < m->vertex.n; v++) {
        double moved = vec_distance(m->vertex.item[v], before->vertex.item[v]);
        if (found[v].near && moved <= KNOWN * s->spacing)
            continue;
        m->vertex.item[v] = before->vertex.item[v];
        m->normal.item[v] = before->normal.item[v];
    }
    free(found);
}
