/* arcprint - see arcprint.h. */
#include "arcprint.h"

#include "math/elementary.h"

static const double SHORT = 1e-3; /* mm: nothing below this is an arc */
static const double THERE = 1e-5; /* mm: so near to the end of the reference its digits are it */

static struct printed print_line(const struct arc_piece *piece, struct vec3 from, struct vec3 to)
{
    struct printed p = {.piece = *piece};
    p.piece.arc = arc_line(from, to);
    return p;
}

struct printed arcprint_piece(const struct arc_piece *piece, struct vec3 from)
{
    struct vec3 to = vec_round(piece->arc.to, PATH_COORDINATE);
    struct arc exact = arc_to(from, piece->arc.tangent, to);
    if (arc_straight(&piece->arc) || arc_straight(&exact) || vec_distance(from, to) < SHORT)
        return print_line(piece, from, to);
    struct printed p = {.piece = *piece};
    p.arc.centre = vec_round(arc_centre(&exact), PATH_COORDINATE);
    p.arc.axis = vec_round(arc_axis(&exact), PATH_VECTOR);
    double r0 = vec_distance(from, p.arc.centre), r1 = vec_distance(to, p.arc.centre);
    p.arc.radius = num_round((r0 + r1) / 2, PATH_COORDINATE);
    p.piece.arc = arc_about(from, to, p.arc.centre, vec_unit(p.arc.axis));
    if (fabs(p.piece.arc.angle - exact.angle) > 0.01 * exact.angle)
        return print_line(piece, from, to);
    return p;
}

static bool is_same_arc(const struct arc *a, const struct arc *b)
{
    return vec_compare(&a->from, &b->from) == 0 && vec_compare(&a->to, &b->to) == 0 &&
           vec_compare(&a->tangent, &b->tangent) == 0 && vec_compare(&a->inward, &b->inward) == 0 &&
           vec_compare(&a->drift, &b->drift) == 0 && a->radius == b->radius && a->angle == b->angle;
}

static bool is_same(const struct arc_piece *a, const struct arc_piece *b)
{
    return a->from == b->from && a->to == b->to && vec_compare(&a->axis, &b->axis) == 0 &&
           vec_compare(&a->axis_to, &b->axis_to) == 0 && is_same_arc(&a->arc, &b->arc);
}

/* The same piece in a list, from number *k on; NULL: it is not there. */
static const struct printed *find_same(const struct printeds *list, size_t *k,
                                       const struct arc_piece *piece)
{
    while (list && *k < list->n && list->item[*k].piece.from < piece->from)
        ++*k;
    return list && *k < list->n && is_same(&list->item[*k].piece, piece) ? &list->item[*k] : NULL;
}

struct deviation arcprint_pieces(const struct reference *reference, const struct pieces *pieces,
                                 const struct printeds *before, struct printeds *printed)
{
    struct vec3 at = vec_round(reference->point[0], PATH_COORDINATE),
                end = reference->point[reference->n - 1];
    struct deviation worst = {0};
    size_t k = 0;

    printed->n = 0;
    for (size_t i = 0; i < pieces->n; i++) {
        struct printed p = arcprint_piece(&pieces->item[i], at);
        at = p.piece.arc.to;
        const struct printed *same = find_same(before, &k, &p.piece);
        p.off = same ? same->off : arc_piece_deviation(reference, &p.piece, 4, NULL);
        worst = deviation_worst(worst, p.off);
        *array_push(printed) = p;
    }
    if (pieces->n == 0 || vec_distance(at, end) >= THERE)
        worst.point = HUGE_VAL; /* what is missing is off by nothing */
    return worst;
}

int arcprint_chords(const struct arc_piece *piece, double offset, double sagitta)
{
    for (int n = 1; n < 4096; n *= 2) {
        double worst = 0;
        for (int i = 0; i < n; i++) {
            struct vec3 p[3], q[3];
            for (int k = 0; k < 3; k++) {
                double s = (i + k * 0.5) / n;
                p[k] = arc_at(&piece->arc, s);
                q[k] = vec_along(p[k], offset, vec_slerp(piece->axis, piece->axis_to, s));
            }
            worst = fmax(worst, vec_distance(p[1], vec_mix(p[0], p[2], 0.5)));
            worst = fmax(worst, vec_distance(q[1], vec_mix(q[0], q[2], 0.5)));
        }
        if (worst <= sagitta)
            return n;
    }
    return 4096;
}

void arcprint_comment(const struct path_arc *arc, char *text)
{
    const double v[] = {arc->centre.x, arc->centre.y, arc->centre.z, arc->axis.x,
                        arc->axis.y,   arc->axis.z,   arc->radius};

    for (const char *s = "$$ CIRCLE/"; *s; s++)
        *text++ = *s;
    for (int i = 0; i < 7; i++) {
        if (i > 0)
            *text++ = ',';
        text += num_write(text, v[i], i >= 3 && i < 6 ? PATH_VECTOR : PATH_COORDINATE);
    }
}
