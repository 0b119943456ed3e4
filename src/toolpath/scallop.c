/* scallop - see scallop.h. */
#include "toolpath/scallop.h"

#include <stdlib.h>

static const double INSIDE = 0.01;               /* of the step: the last plane from the border */
static const double SMOOTH = 0.8660254037844386; /* cos 30 degrees: normal against facet */
static const double STEEP = 0.10452846326765347; /* sin 6 degrees */
static const double LEAST = 0.05;                /* of 1 + R k */

double scallop_step(double h, double radius, double curvature)
{
    double k = fmax(curvature, (LEAST - 1) / radius);
    double high = fmin(h, radius);
    double half2 = high * (2 * radius - high) / ((1 + radius * k) * (1 + high * k));
    double quarter = fmin(half2, 2 / (k * k)); /* of the circle: farther round, its chord is less */

    return 2 * sqrt(quarter * (1 - k * k * quarter / 4));
}

void scallop_equal(double low, double high, double step, struct doubles *height)
{
    double inside = fmin(INSIDE * step, (high - low) / 2);
    double width = high - low - inside, n = ceil(width / step - 1e-9);

    for (double i = 0; i <= n; i++)
        *array_push(height) = low + width * (n > 0 ? i / n : 0);
}

/* The second fundamental form of a facet: [a b; b c] in the frame u, v. */
struct form {
    struct vec3 u, v;
    double a, b, c;
};

/* From the change of the normals along the three sides, by least squares (Rusinkiewicz 2004). */
static struct form form_of(const struct mesh *mesh, size_t facet)
{
    const int *corner = mesh->face.item[facet].v;
    const struct vec3 *p = mesh->vertex.item, *n = mesh->normal.item;
    struct vec3 across = vec_unit(mesh_face_cross(mesh, facet));
    struct form f = {.u = vec_unit(vec_sub(p[corner[1]], p[corner[0]]))};
    double uu = 0, uv = 0, vv = 0, r[3] = {0, 0, 0};

    f.v = vec_cross(across, f.u);
    for (int i = 0; i < 3; i++) {
        int from = corner[i], to = corner[(i + 1) % 3];
        struct vec3 side = vec_sub(p[to], p[from]), turn = vec_sub(n[to], n[from]);
        double du = vec_dot(side, f.u), dv = vec_dot(side, f.v);
        double nu = vec_dot(turn, f.u), nv = vec_dot(turn, f.v);
        uu += du * du;
        uv += du * dv;
        vv += dv * dv;
        r[0] += du * nu;
        r[1] += dv * nu + du * nv;
        r[2] += dv * nv;
    }
    if (uu > 0 && vv > 0) {
        f.b = (r[1] - uv * (r[0] / uu + r[2] / vv)) / (uu + vv - uv * uv * (1 / uu + 1 / vv));
        f.a = (r[0] - uv * f.b) / uu;
        f.c = (r[2] - uv * f.b) / vv;
    }
    return f;
}

static bool is_smooth(const struct mesh *mesh, size_t facet)
{
    struct vec3 across = vec_unit(mesh_face_cross(mesh, facet));

    for (int i = 0; i < 3; i++) {
        if (vec_dot(across, mesh->normal.item[mesh->face.item[facet].v[i]]) < SMOOTH)
            return false;
    }
    return true;
}

/* Normal curvature of each vertex across the passes: the mean of its facets' by area. */
static double *curvatures(const struct mesh *mesh, struct vec3 normal)
{
    double *sum = mem_alloc(mesh->vertex.n, sizeof *sum);
    double *area = mem_alloc(mesh->vertex.n, sizeof *area);

    for (size_t f = 0; f < mesh->face.n; f++) {
        struct vec3 cross = mesh_face_cross(mesh, f);
        struct vec3 b = vec_unit(vec_reject(normal, vec_unit(cross)));
        double size = vec_length(cross);
        if (!is_smooth(mesh, f) || vec_length(b) == 0)
            continue;
        struct form form = form_of(mesh, f);
        double u = vec_dot(b, form.u), v = vec_dot(b, form.v);
        double k = form.a * u * u + 2 * form.b * u * v + form.c * v * v;
        for (int i = 0; i < 3; i++) {
            sum[mesh->face.item[f].v[i]] += size * k;
            area[mesh->face.item[f].v[i]] += size;
        }
    }
    for (size_t v = 0; v < mesh->vertex.n; v++)
        sum[v] = area[v] > 0 ? sum[v] / area[v] : 0;
    free(area);
    return sum;
}

/* A facet's reach along the planes' normal, how far apart planes may be on it, and its area. */
struct slab {
    double low, high, step, area;
    size_t facet;
};

struct slabs {
    size_t n, cap;
    struct slab *item;
};

static int compare_slabs(const void *pa, const void *pb)
{
    const struct slab *a = pa, *b = pb;

    if (a->low != b->low)
        return a->low < b->low ? -1 : 1;
    return (a->facet > b->facet) - (a->facet < b->facet);
}

static int compare_steps(const void *pa, const void *pb)
{
    const struct slab *a = pa, *b = pb;

    if (a->step != b->step)
        return a->step < b->step ? -1 : 1;
    return (a->facet > b->facet) - (a->facet < b->facet);
}

static struct slab slab_of(const struct mesh *mesh, size_t facet, const double *curvature,
                           const struct scallop_options *o, struct scallop_report *report)
{
    const int *corner = mesh->face.item[facet].v;
    struct vec3 cross = mesh_face_cross(mesh, facet);
    struct slab slab = {HUGE_VAL, -HUGE_VAL, o->radius, vec_length(cross) / 2, facet};
    double facing = fabs(vec_dot(vec_unit(cross), o->normal));
    double level = sqrt(fmax(1 - facing * facing, 0)), least = fmax(o->steepest, STEEP);

    if (level < STEEP && report->steep++ == 0)
        report->steep_at = vec_scale(
            1 / 3.0, vec_add(mesh->vertex.item[corner[0]],
                             vec_add(mesh->vertex.item[corner[1]], mesh->vertex.item[corner[2]])));
    for (int i = 0; i < 3; i++) {
        double at = vec_dot(mesh->vertex.item[corner[i]], o->normal);
        double step = scallop_step(o->h, o->radius, curvature[corner[i]]) * fmax(level, least);
        slab.low = fmin(slab.low, at);
        slab.high = fmax(slab.high, at);
        slab.step = fmin(slab.step, step);
    }
    return slab;
}

/* The step that serves all of these slabs but a share of their area. */
static double step_of(struct slabs *near, double beyond, double most)
{
    double area = 0, before = 0;

    for (size_t i = 0; i < near->n; i++)
        area += near->item[i].area;
    if (near->n > 1)
        qsort(near->item, near->n, sizeof *near->item, compare_steps);
    for (size_t i = 0; i < near->n; i++) {
        before += near->item[i].area;
        if (before > beyond * area)
            return fmin(near->item[i].step, most);
    }
    return most;
}

/* How far the next plane may be from the one at `at`; slabs by their lower ends, none of them
 * wider than `widest`. */
static double next_step(const struct slabs *slab, double widest, double at,
                        const struct scallop_options *o)
{
    size_t low = 0, high = slab->n;
    double most = o->radius, step = most;
    struct slabs near = {0};

    while (low < high) {
        size_t middle = low + (high - low) / 2;
        if (slab->item[middle].low < at - widest)
            low = middle + 1;
        else
            high = middle;
    }
    for (size_t i = low; i < slab->n && slab->item[i].low < at + step; i++) {
        if (slab->item[i].high < at)
            continue;
        if (o->beyond > 0)
            *array_push(&near) = slab->item[i];
        else
            step = fmin(step, slab->item[i].step);
    }
    if (o->beyond > 0)
        step = step_of(&near, o->beyond, most);
    array_free(&near);
    return step;
}

struct scallop_report scallop_heights(const struct mesh *mesh, const struct scallop_options *o,
                                      double low, double high, struct doubles *height)
{
    struct scallop_report report = {.narrowest = HUGE_VAL};
    double *curvature = curvatures(mesh, o->normal), widest = 0;
    struct slabs slab = {0};

    for (size_t f = 0; f < mesh->face.n; f++) {
        struct slab s = slab_of(mesh, f, curvature, o, &report);
        widest = fmax(widest, s.high - s.low);
        *array_push(&slab) = s;
    }
    if (slab.n > 0)
        qsort(slab.item, slab.n, sizeof *slab.item, compare_slabs);
    for (double at = low, step = 0;; at += step) {
        *array_push(height) = at;
        step = next_step(&slab, widest, at, o);
        double left = high - INSIDE * step - at;
        if (left <= 0)
            break;
        step = fmin(step, left);
        report.narrowest = fmin(report.narrowest, step);
        report.widest = fmax(report.widest, step);
        if (left == step) {
            *array_push(height) = at + step;
            break;
        }
    }
    array_free(&slab);
    free(curvature);
    return report;
}
