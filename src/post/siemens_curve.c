/* siemens_curve - see siemens_curve.h. */
#include "siemens_curve.h"

#include <string.h>

#include "ncwords.h"
#include "base/num.h"

const char *const siemens_vector[] = {"A3=", "B3=", "C3="};

bool siemens_turning_curves(const struct nc_plan *plan)
{
    for (size_t i = 0; i < plan->spline.n; i++)
        if (plan->spline.item[i].turns)
            return true;
    return false;
}

/* PO[X]=(end,a2,a3), to the power that the curve has. */
static void polynomial(struct nc_program *p, const char *axis, double end, const double factor[],
                       int n_factors, int digits)
{
    char word[(NC_POLY_DEGREE + 1) * NUM_MAX];
    size_t n = strlen(axis);
    memcpy(word, "PO[", 3);
    memcpy(word + 3, axis, n);
    memcpy(word + 3 + n, "]=(", 3);
    n += 6;
    n += num_write_short(word + n, end, p->plan->ability.digits.linear, false);
    for (int i = 0; i < n_factors; i++) {
        word[n++] = ',';
        n += num_write_short(word + n, factor[i], digits, false);
    }
    memcpy(word + n, ")", 2);
    nc_code(&p->w, word);
}

/* Those of X Y Z, or of XH YH ZH. */
static void three(struct nc_program *p, const char *const axis[3], struct vec3 end,
                  const struct vec3 *factor, int n, int digits)
{
    const double to[] = {end.x, end.y, end.z};
    double f[3][NC_POLY_DEGREE - 1];
    for (int i = 0; i < n; i++) {
        f[0][i] = factor[i].x;
        f[1][i] = factor[i].y;
        f[2][i] = factor[i].z;
    }
    for (int k = 0; k < 3; k++)
        polynomial(p, axis[k], to[k], f[k], n, digits);
}

static void polynomials(struct nc_program *p, const struct nc_spline *s, const struct nc_span *n)
{
    static const char *const tip[] = {"X", "Y", "Z"}, *const head[] = {"XH", "YH", "ZH"};
    int factors = nc_poly_factors(s->degree);
    three(p, tip, n->end, n->factor, factors, n->digits);
    if (s->turns)
        three(p, head, n->head_end, n->head_factor, factors, n->digits);
    nc_number(&p->w, "PL=", n->h, 6);
}

static void head_words(struct nc_program *p, struct vec3 head)
{
    int digits = p->plan->ability.digits.linear;
    nc_number(&p->w, "XH=", head.x, digits);
    nc_number(&p->w, "YH=", head.y, digits);
    nc_number(&p->w, "ZH=", head.z, digits);
}

/* Where the tool stands already, with the head point as the second curve's start; it also keeps
 * two B-splines apart. */
static void begin_curve(struct nc_program *p, const struct nc_move *move)
{
    const struct nc_spline *s = &p->plan->spline.item[move->index];
    if (!s->turns && strcmp(p->w.motion, "BSPLINE") != 0)
        return;
    p->w.motion = NULL;
    nc_motion(&p->w, "G1");
    if (s->turns) {
        nc_code(&p->w, "ORICURVE");
        head_words(p, s->head_start);
    }
    nc_feed(p, move);
    nc_end(&p->w);
}

void siemens_curve(struct nc_program *p, const struct nc_move *move)
{
    const struct nc_spline *s = &p->plan->spline.item[move->index];
    struct nc_writer *w = &p->w;
    begin_curve(p, move);
    for (size_t i = 0; i < s->span.n; i++) {
        nc_motion(w, "POLY");
        polynomials(p, s, &s->span.item[i]);
        nc_feed(p, move);
        nc_end(w);
    }
    for (size_t i = 1; s->form == NC_BSPLINE && i < s->curve.poles; i++) {
        if (nc_motion(w, "BSPLINE"))
            nc_code(w, "SD=3");
        nc_forget(w, NC_X, NC_Z);
        nc_place(p, s->curve.pole[i]);
        if (s->turns)
            head_words(p, s->curve.head[i]);
        nc_feed(p, move);
        nc_end(w);
    }
    nc_remember(w, NC_X, move->p.x);
    nc_remember(w, NC_Y, move->p.y);
    nc_remember(w, NC_Z, move->p.z);
    if (s->turns) {
        nc_forget(w, NC_I, NC_K);
        nc_motion(w, "G1");
        nc_code(w, "ORIVECT");
        nc_axis(p, move, siemens_vector);
        nc_end(w);
    }
}
