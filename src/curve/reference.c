/* reference - see reference.h. */
#include "curve/reference.h"

#include <stdlib.h>

#include "curve/polyline.h"

static const double REPEATED = 1e-7; /* mm: points this near to each other are one */
static const double TURNED = 2e-9;   /* of unit vectors: above this two axes differ */
static const double NEAR = 0.75;     /* of the spacing asked for: nearer points are left out */

static struct reference reference_new(size_t n, const struct run *run, bool centre)
{
    double radius = run->radius > 0 ? run->radius : 0;
    return (struct reference){
        .n = n,
        .point = mem_alloc(n, sizeof(struct vec3)),
        .other = mem_alloc(n, sizeof(struct vec3)),
        .axis = mem_alloc(n, sizeof(struct vec3)),
        .chord = mem_alloc(n, sizeof(double)),
        .length = mem_alloc(n, sizeof(double)),
        .offset = centre ? -radius : radius,
    };
}

void reference_free(struct reference *reference)
{
    free(reference->point);
    free(reference->other);
    free(reference->axis);
    free(reference->tangent);
    free(reference->chord);
    free(reference->length);
    array_free(&reference->point_stays);
    array_free(&reference->other_stays);
    *reference = (struct reference){0};
}

void reference_find_stays(struct reference *r)
{
    r->point_stays = r->other_stays = (struct stays){0};
    polyline_find_stays((struct polyline){r->n, r->point}, &r->point_stays);
    polyline_find_stays((struct polyline){r->n, r->other}, &r->other_stays);
}

static void set_point(struct reference *reference, size_t k, const struct run_point *p, bool centre)
{
    reference->point[k] = centre ? p->ball : p->tip;
    reference->axis[k] = p->axis;
    reference->other[k] = vec_along(reference->point[k], reference->offset, p->axis);
}

static void set_chord(struct reference *reference, size_t k, double chord)
{
    reference->chord[k - 1] = chord;
    reference->length[k] = reference->length[k - 1] + chord;
}

static bool axis_turns(const struct reference *reference)
{
    for (size_t i = 1; i < reference->n; i++)
        if (vec_distance(reference->axis[i], reference->axis[0]) > TURNED)
            return true;
    return false;
}

static bool other_path_is_longer(const struct reference *reference)
{
    double point = 0, other = 0;

    for (size_t k = 0; k + 1 < reference->n; k++) {
        point += vec_distance(reference->point[k], reference->point[k + 1]);
        other += vec_distance(reference->other[k], reference->other[k + 1]);
    }
    return other > point;
}

static void set_turns(struct reference *reference)
{
    reference->turns = axis_turns(reference);
    reference->other_leads = reference->turns && other_path_is_longer(reference);
    for (int i = 0; i < 3; i++)
        reference->flat[i] = true;
    for (size_t k = 0; k < reference->n; k++) {
        const struct vec3 a = reference->axis[k];
        reference->flat[0] = reference->flat[0] && a.x == 0;
        reference->flat[1] = reference->flat[1] && a.y == 0;
        reference->flat[2] = reference->flat[2] && a.z == 0;
    }
}

struct vec3 reference_flat(const struct reference *reference, struct vec3 v, struct vec3 zero)
{
    const bool *flat = reference->flat;

    return vec(flat[0] ? zero.x : v.x, flat[1] ? zero.y : v.y, flat[2] ? zero.z : v.z);
}

struct reference reference_of(const struct run *run, size_t from, size_t n, bool centre,
                              bool forward)
{
    struct reference r = reference_new(n, run, centre);
    struct run alone = {.radius = run->radius, .edges = run->edges};

    for (size_t i = 0; i < n; i++) {
        const struct run_point *p = &run->item[from + i];
        set_point(&r, i, p, centre);
        if (i > 0)
            set_chord(&r, i, vec_distance(r.point[i - 1], r.point[i]));
        /* a tip is not bound to the surface: its tangents take no heed of the normals */
        struct run_point *at = array_push(&alone);
        *at = centre || forward ? *p : (struct run_point){.ball = r.point[i]};
        at->ball = r.point[i];
    }
    r.tangent = mem_alloc(n, sizeof *r.tangent);
    run_tangents(&alone, forward, r.tangent);
    array_free(&alone);
    set_turns(&r);
    reference_find_stays(&r);
    return r;
}

struct vec3 reference_flat_axis(const struct reference *reference, struct vec3 axis)
{
    struct vec3 flat = reference_flat(reference, axis, vec(0, 0, 0));

    return vec_distance(flat, axis) > 0 ? vec_unit(flat) : axis;
}

/* The root of the mean square of how far the tip and the end of the radius move. */
static double chord_of_both(const struct run *run, size_t i, size_t j)
{
    const struct run_point *a = &run->item[i], *b = &run->item[j];
    double radius = run->radius > 0 ? run->radius : 1;
    struct vec3 tip = vec_sub(b->tip, a->tip);
    struct vec3 end = vec_along(tip, radius, vec_sub(b->axis, a->axis));

    return sqrt((vec_dot(tip, tip) + vec_dot(end, end)) / 2);
}

/* The points that stay; at least the first one. */
static struct sizes without_repeats(const struct run *run)
{
    struct sizes keep = {0};

    *array_push(&keep) = 0;
    for (size_t i = 1; i < run->n; i++)
        if (chord_of_both(run, keep.item[keep.n - 1], i) > REPEATED)
            *array_push(&keep) = i;
    if (keep.n > 1)
        keep.item[keep.n - 1] = run->n - 1;
    return keep;
}

struct reference reference_distinct(const struct run *run, bool centre)
{
    struct sizes keep = without_repeats(run);
    struct reference r = reference_new(keep.n, run, centre);

    for (size_t k = 0; k < r.n; k++) {
        set_point(&r, k, &run->item[keep.item[k]], centre);
        if (k > 0)
            set_chord(&r, k, chord_of_both(run, keep.item[k - 1], keep.item[k]));
    }
    array_free(&keep);
    set_turns(&r);
    return r;
}

/* Appends the sample at the fraction s of the way from point k to the next one. */
static void add_sample(struct reference *sample, const struct reference *r, size_t k, double s,
                       double length)
{
    size_t i = sample->n++, next = k + 1 < r->n ? k + 1 : k;

    sample->length[i] = length;
    sample->point[i] = vec_mix(r->point[k], r->point[next], s);
    if (!sample->turns)
        return;
    sample->axis[i] = vec_unit(vec_mix(r->axis[k], r->axis[next], s));
    sample->other[i] = vec_mix(r->other[k], r->other[next], s);
}

/* Appends the samples of the chord after point k. */
static void sample_chord(struct reference *sample, const struct reference *r, size_t k,
                         double spacing)
{
    double chord = r->chord[k], pieces = ceil(chord / spacing - 1e-9);
    bool near = sample->n > 0 && r->length[k] - sample->length[sample->n - 1] < NEAR * spacing;

    for (int j = near ? 1 : 0; j == 0 || j < pieces; j++)
        add_sample(sample, r, k, j / fmax(pieces, 1), r->length[k] + chord * j / fmax(pieces, 1));
}

struct reference reference_sample(const struct reference *r, size_t parts)
{
    size_t room = 3 * parts + 3, last = r->n - 1;
    struct reference sample = {.offset = r->offset,
                               .turns = r->turns,
                               .other_leads = r->other_leads,
                               .point = mem_alloc(room, sizeof(struct vec3)),
                               .length = mem_alloc(room, sizeof(double))};
    double spacing = r->length[last] / (double)parts;

    if (r->turns) {
        sample.other = mem_alloc(room, sizeof(struct vec3));
        sample.axis = mem_alloc(room, sizeof(struct vec3));
    }
    for (size_t k = 0; k < last; k++)
        if (k == 0 || r->chord[k] > spacing ||
            r->length[k] - sample.length[sample.n - 1] >= NEAR * spacing)
            sample_chord(&sample, r, k, spacing);
    if (sample.n > 1 && r->length[last] - sample.length[sample.n - 1] < NEAR / 2 * spacing)
        sample.n--;
    add_sample(&sample, r, last, 0, r->length[last]);
    return sample;
}

size_t reference_interval(const struct reference *r, double place, double *part)
{
    double last = (double)(r->n - 1);
    place = fmin(last, fmax(0, place));
    size_t i = (size_t)place;
    if (i + 1 >= r->n)
        i = r->n > 1 ? r->n - 2 : 0;
    *part = place - (double)i;
    return i;
}

struct vec3 reference_point(const struct reference *r, double place)
{
    double part;
    size_t i = reference_interval(r, place, &part);
    return part > 0 ? vec_mix(r->point[i], r->point[i + 1], part) : r->point[i];
}

struct vec3 reference_axis(const struct reference *r, double place)
{
    double part;
    size_t i = reference_interval(r, place, &part);
    return part <= 0   ? r->axis[i]
           : part >= 1 ? r->axis[i + 1]
                       : vec_slerp(r->axis[i], r->axis[i + 1], part);
}

bool reference_axis_still(const struct reference *r, size_t from, size_t to)
{
    for (size_t i = from + 1; i <= to; i++)
        if (vec_distance(r->axis[i], r->axis[from]) > 0)
            return false;
    return true;
}

double reference_place(const struct reference *r, struct vec3 q, double place)
{
    if (r->n < 2)
        return 0;
    double part;
    size_t k = reference_interval(r, place, &part);
    struct polyline line = {r->n, r->point};
    polyline_descend(line, &r->point_stays, q, &k);
    return (double)k + vec_segment_foot(r->point[k], r->point[k + 1], q);
}

bool deviation_within(const struct deviation *found, const struct deviation *within)
{
    return found->point <= within->point && found->other <= within->other &&
           found->axis <= within->axis;
}

struct deviation deviation_worst(struct deviation a, struct deviation b)
{
    return (struct deviation){fmax(a.point, b.point), fmax(a.other, b.other), fmax(a.axis, b.axis)};
}
