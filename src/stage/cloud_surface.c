/* cloud_surface - see cloud_surface.h.  All in axes turned to the direction, and back at the
 * end. */
#include "stage/cloud_surface.h"

#include <stdlib.h>

#include "math/elementary.h"
#include "base/array.h"
#include "base/parallel.h"
#include "cloud/plan_extent.h"
#include "meshing/scan_border.h"
#include "net_corners.h"
#include "nurbs/height_knots.h"
#include "nurbs/net_patches.h"

enum { SAMPLED = 20000 };

static const double SMOOTH_BORDER = 0.5; /* of the points' spacing */

/* ---- distances */

struct measuring {
    const struct nurbs *surface;
    const struct vec3 *point;
    double *off;
};

static void measure_some(void *context, size_t from, size_t to)
{
    const struct measuring *m = context;

    for (size_t i = from; i < to; i++) {
        struct vec3 d[3][3], p = m->point[i];
        nurbs_derivatives(m->surface, (struct uv){p.x, p.y}, 1, d);
        m->off[i] = fabs(vec_dot(vec_sub(p, d[0][0]), vec_unit(vec_cross(d[1][0], d[0][1]))));
    }
}

/* How far points, in the surface's axes, are from it. */
static void measure(const struct nurbs *surface, const struct vec3 *point, size_t n, int threads,
                    struct cloud_surface *result)
{
    struct measuring m = {surface, point, mem_alloc(n, sizeof *m.off)};
    double sum2 = 0;

    parallel_for(threads, n, measure_some, &m);
    result->worst = -1;
    for (size_t i = 0; i < n; i++) {
        sum2 += m.off[i] * m.off[i];
        if (m.off[i] > result->worst) {
            result->worst = m.off[i];
            result->at = point[i];
        }
    }
    result->rms = sqrt(sum2 / (double)n);
    free(m.off);
}

/* ---- the three kinds */

static int make_bspline(const struct cloud_surface_options *options, const struct plan_extent *f,
                        const struct vec3 *point, size_t n, struct nurbs *surface,
                        struct cloud_surface *result, struct error *error)
{
    const double x[2] = {f->xmin, f->xmax}, y[2] = {f->ymin, f->ymax};
    struct height_knots_options how = {options->error, options->smooth, options->uniform, SAMPLED};
    struct height_knots found;

    if (height_knots_search(point, n, x, y, &how, &found) < 0)
        return error_set(error, "the points determine no surface, expected more of them");
    *surface = height_fit_surface(&found.fit);
    result->fits = found.fits;
    height_fit_free(&found.fit);
    return 0;
}

static struct nurbs net_of_spacing(const struct cloud_surface_options *options,
                                   const struct plan_extent *f, const struct net_corners *corners,
                                   double spacing)
{
    double wide = f->xmax - f->xmin, high = f->ymax - f->ymin;
    struct net_patches net = net_patches_new((size_t)fmax(2, ceil(wide / spacing - 1e-9) + 1),
                                             (size_t)fmax(2, ceil(high / spacing - 1e-9) + 1));

    net.x = f->xmin;
    net.y = f->ymin;
    net.dx = wide / (double)(net.columns - 1);
    net.dy = high / (double)(net.rows - 1);
    net_corners_find(corners, &net, options->threads);
    if (options->kind == CLOUD_SURFACE_FERGUSON)
        net_patches_ferguson(&net);
    else
        net_patches_bezier(&net);
    struct nurbs surface = net_patches_surface(&net);
    net_patches_free(&net);
    return surface;
}

/* The widest net, of those that are closer and closer, that keeps the error; or the closest. */
static int make_patches(const struct cloud_surface_options *options, const struct plan_extent *f,
                        const struct vec3 *point, size_t n, struct nurbs *surface,
                        struct cloud_surface *result, struct error *error)
{
    const double closer = 0.84, closest = 1.5; /* spacings of the points */
    double widest = fmin(f->xmax - f->xmin, f->ymax - f->ymin) / 2;
    struct net_corners corners = net_corners_new(point, n, options->mean, options->noise);

    result->spacing = options->spacing > 0 ? options->spacing : widest;
    if ((f->xmax - f->xmin) * (f->ymax - f->ymin) >
        50 * (double)n * result->spacing * result->spacing) {
        net_corners_free(&corners);
        return error_set(error,
                         "a net of %g mm is far closer than the points, expected a wider one",
                         result->spacing);
    }
    for (;; result->spacing *= closer) {
        *surface = net_of_spacing(options, f, &corners, result->spacing);
        result->fits++;
        measure(surface, point, n, options->threads, result);
        if (options->spacing > 0 || result->worst <= options->error ||
            closer * result->spacing < closest * options->mean)
            break;
        nurbs_free(surface);
    }
    net_corners_free(&corners);
    return 0;
}

/* ---- the border */

/* Half a spacing of the points, mm: the border is smoothed over less, and where it is as near to
 * the rectangle's it is that. */
static double border_reach(const struct cloud_surface_options *options)
{
    return SMOOTH_BORDER * options->mean;
}

static double snap(double t, double from, double to, double reach)
{
    return t < from + reach ? from : t > to - reach ? to : t;
}

/* A corner of the rectangle that the border goes round between points a and b, close to both. */
static bool goes_round(const struct plan_extent *f, struct vec3 a, struct vec3 b, double near,
                       struct vec3 *corner)
{
    for (int turn = 0; turn < 2; turn++) { /* one on an upright side, one on a level one */
        struct vec3 p = turn == 0 ? a : b, q = turn == 0 ? b : a, c = vec(p.x, q.y, 0);
        bool upright = !(p.x > f->xmin) || !(p.x < f->xmax);
        bool level = !(q.y > f->ymin) || !(q.y < f->ymax);
        if (upright && level && vec_distance(p, c) < near && vec_distance(q, c) < near &&
            vec_distance(p, c) > 0 && vec_distance(q, c) > 0) {
            *corner = c;
            return true;
        }
    }
    return false;
}

/* A loop of the border as places of the plan, on the rectangle's border where that is near. */
static struct vec3s loop_places(const struct cloud_surface_options *options,
                                const struct plan_extent *f, const struct ints *loop,
                                const struct vec3 *point)
{
    double reach = border_reach(options);
    struct vec3s places = {0};
    struct vec3 corner;

    for (size_t i = 0; i <= loop->n; i++) {
        struct vec3 p = point[loop->item[i % loop->n]];
        p = vec(snap(p.x, f->xmin, f->xmax, reach), snap(p.y, f->ymin, f->ymax, reach), 0);
        if (places.n > 0 && goes_round(f, places.item[places.n - 1], p, options->gap / 2, &corner))
            *array_push(&places) = corner;
        if (i < loop->n)
            *array_push(&places) = p;
    }
    return places;
}

static void add_loop(struct patch *patch, const struct vec3s *place, double tolerance)
{
    struct patch_loop lines = {0};
    struct ints all = {0};
    struct sizes kept = {0};

    for (size_t i = 0; i < place->n; i++)
        *array_push(&all) = (int)i;
    bool *keep = mem_alloc(place->n, sizeof *keep);
    scan_border_thin(&all, place->item, tolerance, keep);
    for (size_t i = 0; i < place->n; i++)
        if (keep[i])
            *array_push(&kept) = i;
    for (size_t k = 0; k < kept.n; k++) {
        struct vec3 a = place->item[kept.item[k]], b = place->item[kept.item[(k + 1) % kept.n]];
        *array_push(&lines) = patch_line((struct uv){a.x, a.y}, (struct uv){b.x, b.y});
    }
    *array_push(&patch->loop) = lines;
    array_free(&kept);
    array_free(&all);
    free(keep);
}

/* Is a loop the border of the whole rectangle? */
static bool is_whole(const struct plan_extent *f, const struct vec3s *place)
{
    double area2 = 0, whole = (f->xmax - f->xmin) * (f->ymax - f->ymin);

    for (size_t i = 0; i < place->n; i++) {
        struct vec3 a = place->item[i], b = place->item[(i + 1) % place->n];
        area2 += a.x * b.y - a.y * b.x;
    }
    return fabs(area2 / 2 - whole) < 1e-9 * whole;
}

/* The border as loops; none where it is that of the rectangle. */
static void trim(const struct cloud_surface_options *options, const struct plan_extent *f,
                 const struct vec3 *point, size_t n, struct patch *patch,
                 struct cloud_surface *result)
{
    struct scan_border border = scan_border_find(point, n, options->gap);

    for (size_t k = 0; k < border.n; k++) {
        struct vec3s places = loop_places(options, f, &border.item[k], point);
        if (places.n >= 3 && !(border.n == 1 && is_whole(f, &places)))
            add_loop(patch, &places, border_reach(options));
        array_free(&places);
    }
    result->holes = border.n > 0 ? border.n - 1 : 0;
    scan_border_free(&border);
}

static void turn_back(const struct plan_extent *f, struct nurbs *surface)
{
    for (size_t k = 0; k < surface->u.poles * surface->v.poles; k++) {
        struct nurbs_pole *p = &surface->pole[k];
        struct vec3 at = plan_extent_turn_back(f, vec(p->wx, p->wy, p->wz));
        *p = (struct nurbs_pole){at.x, at.y, at.z, p->w};
    }
}

int cloud_surface_make(const struct cloud_surface_options *options, const struct vec3s *points,
                       struct cloud_surface *result, struct error *error)
{
    size_t n = points->n;
    struct patch patch = {.entity = 1};

    *result = (struct cloud_surface){.worst = -1};
    if (plan_extent_check(points->item, n, error) < 0)
        return -1;
    struct plan_extent f = plan_extent_of(points->item, n, options->direction);
    struct vec3 *point = mem_alloc(n, sizeof *point);
    for (size_t i = 0; i < n; i++)
        point[i] = plan_extent_turn(&f, points->item[i]);
    int status = options->kind == CLOUD_SURFACE_BSPLINE
                     ? make_bspline(options, &f, point, n, &patch.surface, result, error)
                     : make_patches(options, &f, point, n, &patch.surface, result, error);
    if (status == 0) {
        measure(&patch.surface, point, n, options->threads, result);
        result->at = plan_extent_turn_back(&f, result->at);
        if (!options->untrimmed)
            trim(options, &f, point, n, &patch, result);
        turn_back(&f, &patch.surface);
        *array_push(&result->patches) = patch;
    }
    free(point);
    return status;
}
