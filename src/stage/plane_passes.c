/* plane_passes - see plane_passes.h. */
#include "stage/plane_passes.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/cli.h"
#include "stage/path_options.h"
#include "base/num.h"
#include "base/parallel.h"
#include "math/box.h"
#include "toolpath/pass_extend.h"
#include "toolpath/scallop.h"
#include "surface_contacts.h"

/* Of the tolerance and the noise: how far the ball may be off on the surface near a border. */
static const double SURE = 0.5;

/* Of the distance of two planes: shorter pieces between them are not worth their links. */
static const double LONG = 1.5;

/* What one plane cuts: strips in order along it. */
struct plane_cut {
    double height;
    struct slice_chains strips;
};

struct plane_cuts {
    size_t n, cap;
    struct plane_cut *item;
};

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

int plane_passes_bounded(const struct mesh *mesh, struct vec3 normal, double step,
                         struct error *error)
{
    const double most_planes = 1e5, most_points = 2e7;
    struct box box = box_around(mesh->vertex.item, mesh->vertex.n);
    bool known = vec_length(normal) > 0;
    double low = HUGE_VAL, high = -HUGE_VAL, points = 0;

    for (size_t f = 0; f < mesh->face.n && known; f++) {
        double least = HUGE_VAL, most = -HUGE_VAL;
        for (int i = 0; i < 3; i++) {
            double at = vec_dot(mesh->vertex.item[mesh->face.item[f].v[i]], normal);
            least = fmin(least, at);
            most = fmax(most, at);
        }
        points += (most - least) / step;
        low = fmin(low, least);
        high = fmax(high, most);
    }
    /* in every direction at least as many as across the shorter side */
    double wide =
        known ? fmax(high - low, 0) : fmin(box.high.x - box.low.x, box.high.y - box.low.y);
    double planes = ceil(wide / step);
    if (planes > most_planes)
        return error_set(error,
                         "would make %.0f planes, expected at most %.0f: is the unit of the part "
                         "right? Planes farther apart (-s, --scallop) are fewer",
                         planes, most_planes);
    if (points > most_points)
        return error_set(error,
                         "would make about %.0f million points on %.0f planes, expected at most "
                         "%.0f million: planes farther apart (-s, --scallop), or a coarser mesh, "
                         "make fewer",
                         points / 1e6, planes, most_points / 1e6);
    return 0;
}

/* Planes a little apart cut a facet in all over as much as its area across them holds. */
int plane_passes_short(const struct plane_passes *p, const struct mesh *mesh, struct error *error)
{
    const double sure = 1.1; /* what is cut in fact is looked at again */
    double length = 0;
    char said[400];

    for (size_t f = 0; f < mesh->face.n; f++) {
        struct vec3 cross = mesh_face_cross(mesh, f);
        if (!p->rule.faced || vec_dot(cross, p->rule.facing) > 0)
            length += vec_length(vec_cross(cross, p->rule.normal)) / 2;
    }
    length /= plane_passes_apart(p);
    snprintf(said, sizeof said, "about %.0f m", length / 1e3);
    return toolpath_length_bounded(length / sure, p->rule.radius, said, error);
}

double plane_passes_apart(const struct plane_passes *p)
{
    const struct doubles *height = &p->height;

    return height->n > 1 ? (height->item[height->n - 1] - height->item[0]) / (double)(height->n - 1)
                         : HUGE_VAL;
}

static void move_first(struct plane_passes *p)
{
    double low = slice_low(p->cut), high = slice_high(p->cut);
    double distance = p->height.n > 1 ? p->height.item[1] - p->height.item[0] : high - low;

    p->height.item[0] = first_height(p->cut, 0.01 * distance);
}

void plane_passes_equal(struct plane_passes *p, const struct mesh *mesh, double step)
{
    p->cut = slice_new(mesh, p->rule.normal, !path_options.paper, p->threads);
    scallop_equal(slice_low(p->cut), slice_high(p->cut), step, &p->height);
    p->widest = step;
    move_first(p);
}

void plane_passes_scallop(struct plane_passes *p, const struct mesh *mesh, double h)
{
    struct scallop_options options = {p->rule.normal, h, p->rule.radius, p->steepest, p->beyond};

    p->cut = slice_new(mesh, p->rule.normal, !path_options.paper, p->threads);
    struct scallop_report report =
        scallop_heights(mesh, &options, slice_low(p->cut), slice_high(p->cut), &p->height);
    p->widest = report.widest;
    p->steep = report.steep > 0 && p->beyond == 0;
    note("planes %.4f to %.4f mm apart", report.narrowest, report.widest);
    if (p->steep)
        say("%zu facets stand within 6 degrees of the planes, the first at %.3f %.3f %.3f: there "
            "the cusps are higher than %g",
            report.steep, report.steep_at.x, report.steep_at.y, report.steep_at.z, h);
    move_first(p);
}

/* About how long all passes are; HUGE_VAL: they are more than a path may have. */
static double length_at(const struct mesh *mesh, double angle, double radius, double h)
{
    struct pass_options rule = plane_passes_upright(angle, radius);
    struct error error;
    if (plane_passes_bounded(mesh, rule.normal, scallop_step(h, radius, 0), &error) != 0)
        return HUGE_VAL;
    struct slice *cut = slice_new(mesh, rule.normal, true, 0);
    struct scallop_options options = {.normal = rule.normal, .h = h, .radius = radius};
    struct doubles height = {0};
    double length = 0;

    scallop_heights(mesh, &options, slice_low(cut), slice_high(cut), &height);
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
        /* planes that run along what is to be cut, and cross nothing of it, are no way to cut it */
        if (now > 0 && now < *length * (1 - 1e-9)) {
            *length = now;
            best = angle;
        }
        progress("directions", (size_t)i + 1, DIRECTIONS);
    }
    *length = *length < HUGE_VAL ? *length : 0;
    return best;
}

bool plane_passes_direction_read(const char *text)
{
    double degrees;

    return strcmp(text, "auto") == 0 || num_whole(text, &degrees);
}

double plane_passes_direction(const char *text, const struct mesh *mesh, double radius, double h)
{
    double length, degrees = 0;

    if (num_whole(text, &degrees))
        return RADIANS(degrees);
    double angle = plane_passes_best(mesh, radius, h, &length);
    say("planes at %g degrees: the fewest millimetres of cut, about %.0f", DEGREES(angle), length);
    return angle;
}

/* Points of the mesh on the surfaces that it was made from, if these are given. */
static void put_on_surfaces(struct plane_passes *p, struct slice_chains *chains)
{
    const double curve = 0.25; /* of the tolerance, off half way: nearly as much as anywhere */
    const struct surface_contacts rule = {.on = p->on,
                                          .plane = p->rule.normal,
                                          .reach = p->reach,
                                          .radius = path_options.radius,
                                          .off = curve * path_options.tolerance,
                                          .threads = p->threads};

    if (p->on)
        p->beside += surface_contacts_put(&rule, chains);
}

/* ---- strips run out to the border of the scan */

/* What the threads share that lengthen strips. */
struct lengthening {
    const struct plane_passes *path;
    struct plane_cuts *cuts;
    double *length;
    size_t *beyond;
};

static struct border_surface_plane plane_at(const struct plane_passes *p, double height)
{
    return (struct border_surface_plane){p->rule.normal, p->rule.along, height};
}

static void lengthen_strips(void *context, size_t from, size_t to)
{
    struct lengthening *e = context;

    for (size_t i = from; i < to; i++) {
        struct plane_cut *cut = &e->cuts->item[i];
        struct border_surface_plane plane = plane_at(e->path, cut->height);
        e->beyond[i] =
            e->path->extended ? 0 : pass_extend_within(e->path->border_surface, &cut->strips);
        e->length[i] = pass_extend_ends(e->path->border_surface, &plane, &cut->strips);
    }
}

static double lengthen_all(const struct plane_passes *p, struct plane_cuts *cuts)
{
    struct lengthening e = {p, cuts, mem_alloc(cuts->n + 1, sizeof(double)),
                            mem_alloc(cuts->n + 1, sizeof(size_t))};
    double length = 0;
    size_t beyond = 0;

    parallel_for(p->threads, cuts->n, lengthen_strips, &e);
    for (size_t i = 0; i < cuts->n; i++)
        length += e.length[i];
    for (size_t i = 0; i < cuts->n; i++)
        beyond += e.beyond[i];
    if (beyond > 0)
        note("%zu points of the mesh beyond the border of the scan left out", beyond);
    free(e.length);
    free(e.beyond);
    return length;
}

/* What the plane has beside the strips of a neighbouring one and not beside those on its other side
 * (NULL: none). */
static double add_beside(const struct plane_passes *p, const struct plane_cut *from,
                         const struct plane_cut *beyond, double shortest, struct plane_cut *cut)
{
    struct border_surface_plane plane = plane_at(p, cut->height);
    struct pass_extend_neighbours beside = {&from->strips, beyond ? &beyond->strips : NULL};

    return pass_extend_beside(p->border_surface, &plane, &beside, shortest, &cut->strips);
}

static double add_beside_all(const struct plane_passes *p, struct plane_cuts *cuts)
{
    double length = 0;

    for (size_t i = 1; i < cuts->n; i++) {
        struct plane_cut *low = &cuts->item[i - 1], *high = &cuts->item[i];
        length += add_beside(p, low, NULL, (high->height - low->height) / 2, high);
    }
    for (size_t i = cuts->n - 1; i-- > 0;) {
        struct plane_cut *low = &cuts->item[i], *high = &cuts->item[i + 1];
        length += add_beside(p, high, NULL, (high->height - low->height) / 2, low);
    }
    return length;
}

/* Planes from the end on (`way` 1: beyond the last, -1: before the first), as long as the scan has
 * something for them. */
static double add_planes_beyond(const struct plane_passes *p, const struct plane_cut *end,
                                double way, double step, struct plane_cuts *more)
{
    double length = 0;

    for (struct plane_cut last = *end;; last = more->item[more->n - 1]) {
        struct plane_cut next = {last.height + way * step, {{0}, {0}}};
        double added = add_beside(p, &last, NULL, step / 2, &next);
        if (added == 0)
            return length;
        length += added;
        *array_push(more) = next;
    }
}

/* What the threads share that look for planes between others. */
struct betweens {
    const struct plane_passes *path;
    const struct plane_cuts *cuts;
    struct plane_cut *cut; /* after the i-th of them, where it has a length */
    double *length;
};

/* Two planes, of which one ends well before the other where the border runs nearly along them: what
 * goes between. */
static void find_betweens(void *context, size_t from, size_t to)
{
    struct betweens *w = context;

    for (size_t i = from; i < to; i++) {
        const struct plane_cut *low = &w->cuts->item[i], *high = low + 1;
        double step = high->height - low->height;
        struct plane_cut between = {low->height + step / 2, {{0}, {0}}};
        w->length[i] = add_beside(w->path, low, high, LONG * step, &between) +
                       add_beside(w->path, high, low, LONG * step, &between);
        w->cut[i] = between;
    }
}

/* All planes, and those between them. */
static double add_planes_between(const struct plane_passes *p, const struct plane_cuts *cuts,
                                 struct plane_cuts *all)
{
    struct betweens w = {p, cuts, mem_alloc(cuts->n, sizeof *w.cut),
                         mem_alloc(cuts->n, sizeof *w.length)};
    double length = 0;

    parallel_for(p->threads, cuts->n - 1, find_betweens, &w);
    for (size_t i = 0; i < cuts->n; i++) {
        *array_push(all) = cuts->item[i];
        length += w.length[i];
        if (w.length[i] > 0)
            *array_push(all) = w.cut[i];
    }
    free(w.cut);
    free(w.length);
    return length;
}

/* Half the distance of the planes at an end; the one at the border may have come nearer. */
static double end_step(const struct plane_passes *p, bool last)
{
    const double *h = p->height.item;
    size_t n = p->height.n;

    if (n < 4)
        return p->widest / 2;
    return (last ? h[n - 2] - h[n - 3] : h[2] - h[1]) / 2;
}

/* Strips run out to the border of the scan; with more planes, half as far apart, beyond the first
 * and the last. */
static void extend_cuts(const struct plane_passes *p, struct plane_cuts *cuts)
{
    struct plane_cuts before = {0}, after = {0}, all = {0};
    double length = lengthen_all(p, cuts);

    if (cuts->n == 0)
        return;
    length += add_beside_all(p, cuts);
    length += add_planes_beyond(p, &cuts->item[0], -1, end_step(p, false), &before);
    length += add_planes_beyond(p, &cuts->item[cuts->n - 1], 1, end_step(p, true), &after);
    for (size_t i = before.n; i-- > 0;)
        *array_push(&all) = before.item[i];
    length += add_planes_between(p, cuts, &all);
    for (size_t i = 0; i < after.n; i++)
        *array_push(&all) = after.item[i];
    note("rows run out to the border of the scan: %.1f mm more, %zu planes more", length,
         all.n - cuts->n);
    array_free(&before);
    array_free(&after);
    array_free(cuts);
    *cuts = all;
}

void plane_passes_run_out(struct plane_passes *p, const struct mesh *mesh)
{
    struct border_surface_options rule = {
        .scan = &path_options.certain,
        .doubtful = &path_options.doubtful,
        .spacing = mesh->origin.spacing,
        .radius = path_options.radius,
        .sure = SURE * (path_options.tolerance + fmax(path_options.noise, 0))};

    if (!p->region && rule.scan->n > 0 && rule.spacing > 0 && mesh->origin.part.n == 0 &&
        p->rule.normal.z == 0)
        p->border_surface = border_surface_new(&rule, mesh);
    p->extended = mesh->origin.extended > 0;
    array_free(&path_options.certain);
    array_free(&path_options.doubtful);
    array_free(&path_options.curtain);
}

/* ---- planes to passes */

static struct plane_cuts cut_all(struct plane_passes *p)
{
    struct plane_cuts cuts = {0};

    for (size_t i = 0; i < p->height.n; i++) {
        struct slice_chains chains = {0}, strips = {0};
        slice_at(p->cut, p->height.item[i], &chains);
        put_on_surfaces(p, &chains);
        p->left_out += passes_make(&chains, &p->rule, &strips);
        *array_push(&cuts) = (struct plane_cut){p->height.item[i], strips};
        slice_chains_free(&chains);
    }
    if (p->border_surface)
        extend_cuts(p, &cuts);
    return cuts;
}

static void make_pass(const struct plane_passes *p, const struct slice_chains *strips, size_t pass,
                      struct toolpath *t)
{
    bool back = !path_options.one_way && pass % 2 == 0;
    struct slice_chains pass_strips = {0};

    for (size_t i = 0; i < strips->point.n; i++)
        *array_push(&pass_strips.point) = strips->point.item[i];
    for (size_t k = 0; k < strips->chain.n; k++)
        *array_push(&pass_strips.chain) = strips->chain.item[k];
    if (back)
        passes_reverse(&pass_strips);
    for (size_t k = 0; k < pass_strips.chain.n; k++) {
        const struct slice_chain *chain = &pass_strips.chain.item[k];
        t->lift.feed.side = p->rule.normal;
        t->lift.feed.plane = passes_forward(&pass_strips, k, p->rule.normal);
        toolpath_strip(t, pass, &pass_strips.point.item[chain->from], chain->to - chain->from,
                       vec_scale(back ? -1 : 1, p->rule.along));
    }
    slice_chains_free(&pass_strips);
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

int plane_passes_make(struct plane_passes *set, size_t n, struct toolpath *t, struct error *error)
{
    size_t pass = 1, beside = 0, left_out = 0;
    int end = 0;
    struct plane_cuts *cuts = mem_alloc(n, sizeof *cuts);

    for (size_t k = 0; k < n; k++)
        cuts[k] = cut_all(&set[k]);
    for (int layer = path_options.layers - 1; layer >= 0 && end == 0; layer--) {
        t->lift.offset = path_options.radius + layer * path_options.depth;
        for (size_t k = 0; k < n; k++) {
            for (size_t i = 0; i < cuts[k].n; i++) {
                make_pass(&set[k], &cuts[k].item[i].strips, pass++, t);
                progress("planes", i + 1, cuts[k].n);
            }
        }
        if (layer == path_options.layers - 1)
            end = toolpath_bounded(t, path_options.layers, error);
    }
    free_cuts(cuts, n);
    if (end != 0)
        return -1;
    toolpath_cut(t);
    t->lift.feed.plane = vec(0, 0, 0);
    if (t->swept.n == 0)
        return error_set(error, "found nothing that the planes cross and that faces the tool");
    for (size_t k = 0; k < n; k++) {
        beside += set[k].beside;
        left_out += set[k].left_out;
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
