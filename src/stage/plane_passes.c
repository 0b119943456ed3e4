/* plane_passes - see plane_passes.h. */
#include "stage/plane_passes.h"

#include <stdlib.h>
#include <string.h>

#include "base/cli.h"
#include "stage/path_options.h"
#include "base/num.h"
#include "base/parallel.h"
#include "toolpath/scallop.h"

enum { DIRECTIONS = 12, LOOKED_AT = 24 };

struct pass_options plane_passes_upright(double angle, double radius)
{
    struct pass_options rule = {.along = vec(cos(angle), sin(angle), 0),
                                .normal = vec(-sin(angle), cos(angle), 0),
                                .gap = 0.1,
                                .facing = vec(0, 0, 1),
                                .radius = radius,
                                .tolerance = 0.002};

    if (rule.normal.x + rule.normal.y < 0)
        rule.normal = vec_scale(-1, rule.normal);
    return rule;
}

struct pass_options plane_passes_along(const struct mesh_part *part, double radius)
{
    struct pass_options rule = plane_passes_upright(0, radius);

    rule.along = part->along;
    rule.normal = vec_cross(part->up, part->along);
    rule.facing = part->up;
    return rule;
}

/* A border that is straight along the planes has the first of them on it, another one just inside.
 */
static double first_height(struct slice *cut, double inside)
{
    double low = slice_low(cut), length[2];

    for (int i = 0; i < 2; i++) {
        struct slice_chains chains = {0};
        slice_at(cut, low + i * inside, &chains);
        length[i] = slice_chains_length(&chains);
        slice_chains_free(&chains);
    }
    return length[0] > 0.9 * length[1] ? low : low + inside;
}

static void move_first(struct plane_passes *p)
{
    double low = slice_low(p->cut), high = slice_high(p->cut);
    double distance = p->height.n > 1 ? p->height.item[1] - p->height.item[0] : high - low;

    p->height.item[0] = first_height(p->cut, 0.01 * distance);
}

void plane_passes_equal(struct plane_passes *p, const struct mesh *mesh, double step)
{
    p->cut = slice_new(mesh, p->rule.normal, !cutting.paper);
    scallop_equal(slice_low(p->cut), slice_high(p->cut), step, &p->height);
    p->widest = step;
    move_first(p);
}

void plane_passes_scallop(struct plane_passes *p, const struct mesh *mesh, double h)
{
    p->cut = slice_new(mesh, p->rule.normal, !cutting.paper);
    struct scallop_report report = scallop_heights(
        mesh, p->rule.normal, slice_low(p->cut), slice_high(p->cut), h, p->rule.radius, &p->height);
    p->widest = report.widest;
    p->steep = report.steep > 0;
    note("planes %.4f to %.4f mm apart", report.narrowest, report.widest);
    if (p->steep)
        say("%zu facets stand within 6 degrees of the planes, the first at %.3f %.3f %.3f: there "
            "the cusps are higher than %g",
            report.steep, report.steep_at.x, report.steep_at.y, report.steep_at.z, h);
    move_first(p);
}

/* About how long all passes are. */
static double length_at(const struct mesh *mesh, double angle, double radius, double h)
{
    struct pass_options rule = plane_passes_upright(angle, radius);
    struct slice *cut = slice_new(mesh, rule.normal, true);
    struct doubles height = {0};
    double length = 0;

    scallop_heights(mesh, rule.normal, slice_low(cut), slice_high(cut), h, radius, &height);
    size_t look = height.n < LOOKED_AT ? height.n : LOOKED_AT;
    for (size_t i = 0; i < look; i++) {
        struct slice_chains chains = {0};
        slice_at(cut, height.item[(2 * i + 1) * height.n / (2 * look)], &chains);
        length += slice_chains_length(&chains) * (double)height.n / (double)look;
        slice_chains_free(&chains);
    }
    array_free(&height);
    slice_free(cut);
    return length;
}

double plane_passes_best(const struct mesh *mesh, double radius, double h, double *length)
{
    double best = 0;

    *length = HUGE_VAL;
    for (int i = 0; i < DIRECTIONS; i++) {
        double angle = PI * i / DIRECTIONS, now = length_at(mesh, angle, radius, h);
        if (now < *length * (1 - 1e-9)) {
            *length = now;
            best = angle;
        }
        progress("directions", (size_t)i + 1, DIRECTIONS);
    }
    return best;
}

bool plane_passes_direction(const char *text, const struct mesh *mesh, double radius, double h,
                            double *angle)
{
    double length, degrees;

    if (strcmp(text, "auto") == 0) {
        *angle = plane_passes_best(mesh, radius, h, &length);
        say("planes at %g degrees: the fewest millimetres of cut, about %.0f", DEGREES(*angle),
            length);
        return true;
    }
    if (!num_whole(text, &degrees))
        return false;
    *angle = RADIANS(degrees);
    return true;
}

/* What the threads share. */
struct putting {
    const struct plane_passes *path;
    struct contact *point;
    bool *beside;
};

static void put_some(void *context, size_t from, size_t to)
{
    struct putting *p = context;

    for (size_t i = from; i < to; i++)
        p->beside[i] =
            project_contact(p->path->on, p->path->rule.normal, p->path->reach, &p->point[i]) < 0;
}

static void put_on_surfaces(struct plane_passes *p, struct contacts *points)
{
    struct putting put = {p, points->item, mem_alloc(points->n + 1, sizeof *put.beside)};

    if (p->on)
        parallel_for(p->threads, points->n, put_some, &put);
    for (size_t i = 0; i < points->n; i++)
        p->beside += put.beside[i];
    free(put.beside);
}

static struct plane_cuts cut_all(struct plane_passes *p)
{
    struct plane_cuts cuts = {0};

    for (size_t i = 0; i < p->height.n; i++) {
        struct slice_chains chains = {0}, strips = {0};
        slice_at(p->cut, p->height.item[i], &chains);
        put_on_surfaces(p, &chains.point);
        p->left_out += passes_make(&chains, &p->rule, &strips);
        *array_push(&cuts) = (struct plane_cut){p->height.item[i], strips};
        slice_chains_free(&chains);
    }
    if (p->border_surface)
        plane_passes_go_beyond(p, &cuts);
    return cuts;
}

static void make_pass(const struct plane_passes *p, const struct slice_chains *strips, size_t pass,
                      struct toolpath *t)
{
    bool back = !cutting.one_way && pass % 2 == 0;
    struct slice_chains way = {0};

    for (size_t i = 0; i < strips->point.n; i++)
        *array_push(&way.point) = strips->point.item[i];
    for (size_t k = 0; k < strips->chain.n; k++)
        *array_push(&way.chain) = strips->chain.item[k];
    if (back)
        passes_reverse(&way);
    for (size_t k = 0; k < way.chain.n; k++) {
        const struct slice_chain *chain = &way.chain.item[k];
        t->lift.feed.side = p->rule.normal;
        t->lift.feed.plane = passes_forward(&way, k, p->rule.normal);
        toolpath_strip(t, pass, &way.point.item[chain->from], chain->to - chain->from,
                       vec_scale(back ? -1 : 1, p->rule.along));
    }
    slice_chains_free(&way);
}

static void free_cuts(struct plane_cuts *cuts, size_t n)
{
    for (size_t k = 0; k < n; k++) {
        for (size_t i = 0; i < cuts[k].n; i++)
            slice_chains_free(&cuts[k].item[i].strips);
        array_free(&cuts[k]);
    }
    free(cuts);
}

int plane_passes_make(struct plane_passes *paths, size_t n, struct toolpath *t, struct error *error)
{
    size_t pass = 1, beside = 0, left_out = 0;
    struct plane_cuts *cuts = mem_alloc(n, sizeof *cuts);

    for (size_t k = 0; k < n; k++)
        cuts[k] = cut_all(&paths[k]);
    for (int layer = cutting.layers - 1; layer >= 0; layer--) {
        t->lift.offset = cutting.radius + layer * cutting.depth;
        for (size_t k = 0; k < n; k++) {
            for (size_t i = 0; i < cuts[k].n; i++) {
                make_pass(&paths[k], &cuts[k].item[i].strips, pass++, t);
                progress("planes", i + 1, cuts[k].n);
            }
        }
    }
    free_cuts(cuts, n);
    toolpath_end(t);
    if (t->pass == 0)
        return error_set(error, "found nothing that the planes cross and that faces the tool");
    for (size_t k = 0; k < n; k++) {
        beside += paths[k].beside;
        left_out += paths[k].left_out;
    }
    if (beside > 0)
        say("%zu points have no surface near them and stay on the mesh", beside);
    if (left_out > 0)
        say("%zu points face away from the tool and are left out", left_out);
    return 0;
}

void plane_passes_free(struct plane_passes *p)
{
    slice_free(p->cut);
    array_free(&p->height);
    project_free(p->on);
    border_surface_free(p->border_surface);
}
