/* arc_calm - see arcfit.h, arcfit_calm: the axes at the joints moved. */
#include <stdlib.h>

#include "arcfit/arcfit.h"
#include "math/elementary.h"

enum { SWEEPS = 4, HALVINGS = 3 };

static const double UPRIGHT = RADIANS(1); /* axes that lean less stay: their bearing says little */
static const double LITTLE = 2e-5;        /* radians: less is not worth a look */

/* How an axis leans off Z, and to where: radians. */
struct leaning {
    double lean, bearing;
};

static struct leaning leaning_of(struct vec3 axis, double near)
{
    double bearing = atan2(axis.y, axis.x);

    return (struct leaning){atan2(hypot(axis.x, axis.y), axis.z),
                            near + remainder(bearing - near, 2 * PI)};
}

static struct vec3 axis_of(struct leaning a)
{
    return vec(sin(a.lean) * cos(a.bearing), sin(a.lean) * sin(a.bearing), cos(a.lean));
}

/* A smooth chain: its n pieces, their lengths, and the n + 1 axes at their ends. */
struct calm {
    const struct reference *reference;
    const struct deviation *within;
    size_t n;
    struct arc_piece *piece;
    double *length;
    struct leaning *at;
};

/* What one angle is at the five joints about joint k, and the lengths of the pieces between. */
struct five {
    double u[5], length[4];
    int first, last; /* of these joints that there are */
};

static struct five five_at(const struct calm *c, size_t k, bool bearing)
{
    struct five f = {.first = k >= 2 ? 0 : 1, .last = k + 2 <= c->n ? 4 : 3};

    for (int i = f.first; i <= f.last; i++) {
        size_t at = k + (size_t)i - 2;
        f.u[i] = bearing ? c->at[at].bearing : c->at[at].lean;
        if (i < f.last)
            f.length[i] = c->length[at];
    }
    return f;
}

/* By how much the middle one has to be more for the least sum of the squares of the changes of
 * speed, each by mm, at the inner joints. */
static double change_of(const struct five *f)
{
    double sum = 0, square = 0;

    for (int i = f->first + 1; i < f->last; i++) {
        double before = 1 / f->length[i - 1], after = 1 / f->length[i];
        double jump = (f->u[i + 1] - f->u[i]) * after - (f->u[i] - f->u[i - 1]) * before;
        double by = i == 1 ? after : i == 2 ? -before - after : before;
        sum += jump * by;
        square += by * by;
    }
    return square > 0 ? -sum / square : 0;
}

static bool holds(const struct calm *c, const struct arc_piece *piece)
{
    struct deviation off = arc_piece_decision(c->reference, piece, 4, c->within);

    return deviation_within(&off, c->within);
}

/* Joint k, neither the first nor the last, as far towards what is calm as the tolerance allows. */
static void move_joint(struct calm *c, size_t k)
{
    struct leaning was = c->at[k];
    struct five lean = five_at(c, k, false), bearing = five_at(c, k, true);
    struct leaning by = {change_of(&lean), change_of(&bearing)};

    if (fabs(by.lean) + sin(was.lean) * fabs(by.bearing) < LITTLE)
        return;
    for (int i = 0; i < HALVINGS; i++, by.lean /= 2, by.bearing /= 2) {
        struct leaning to = {was.lean + by.lean, was.bearing + by.bearing};
        struct arc_piece a = c->piece[k - 1], b = c->piece[k];
        a.axis_to = b.axis = reference_flat_axis(c->reference, axis_of(to));
        if (to.lean < UPRIGHT || !holds(c, &a) || !holds(c, &b))
            continue;
        c->piece[k - 1] = a;
        c->piece[k] = b;
        c->at[k] = to;
        return;
    }
}

static bool may_move(const struct calm *c, size_t k)
{
    return fmin(c->at[k - 1].lean, fmin(c->at[k].lean, c->at[k + 1].lean)) > UPRIGHT &&
           c->length[k - 1] > 0 && c->length[k] > 0;
}

static void calm_chain(struct calm *c)
{
    c->length = mem_alloc(c->n, sizeof *c->length);
    c->at = mem_alloc(c->n + 1, sizeof *c->at);
    for (size_t k = 0; k <= c->n; k++) {
        struct vec3 axis = k < c->n ? c->piece[k].axis : c->piece[k - 1].axis_to;
        c->at[k] = leaning_of(axis, k > 0 ? c->at[k - 1].bearing : 0);
        if (k < c->n)
            c->length[k] = fmax(arc_length(&c->piece[k].arc), 1e-3);
    }
    for (int sweep = 0; sweep < SWEEPS; sweep++)
        for (size_t i = 1; i < c->n; i++) {
            size_t k = sweep % 2 ? c->n - i : i;
            if (may_move(c, k))
                move_joint(c, k);
        }
    free(c->length);
    free(c->at);
}

void arcfit_calm(const struct reference *reference, const struct deviation *within, size_t from,
                 size_t to, struct pieces *pieces)
{
    struct calm c = {.reference = reference, .within = within};

    if (from + 1 >= to || !reference->turns)
        return;
    c.n = to - from;
    c.piece = &pieces->item[from];
    calm_chain(&c);
}
