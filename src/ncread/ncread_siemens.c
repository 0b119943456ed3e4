/* ncread_siemens - see ncread_siemens.h. */
#include "ncread_siemens.h"

#include <string.h>

/* The tool axis at the end of the block. */
static int block_axis(struct ncread *c, struct ncread_siemens_block *b, struct error *error)
{
    if ((b->vector_n != 0 && b->vector_n != 3) || (b->head_n != 0 && b->head_n != 3))
        return ncread_error(c, error, "a tool vector or second point wants all three words");
    if ((b->vector_n == 3) + (b->head_n == 3) + b->turns > 1)
        return ncread_error(c, error, "the tool axis is said twice");
    if (b->head_n == 3) {
        if (!c->curve)
            return ncread_error(c, error, "a second point without ORICURVE");
        b->to.head = vec(b->head[0], b->head[1], b->head[2]);
        b->to.has_head = true;
        struct vec3 tip = vec(b->to.at[0], b->to.at[1], b->to.at[2]);
        ncread_pointed(&b->to, vec_sub(b->to.head, tip));
    } else if (b->vector_n == 3) {
        struct vec3 axis = vec(b->vector[0], b->vector[1], b->vector[2]);
        if (!c->tcp || fabs(vec_length(axis) - 1) > 1e-3)
            return ncread_error(c, error, "a tool vector wants TRAORI and length 1");
        ncread_pointed(&b->to, axis);
        b->to.has_head = false;
    } else if (b->turns) {
        ncread_turned(c, &b->to);
        b->to.has_head = false;
    } else if (b->named && b->to.has_head) {
        return ncread_error(c, error, "the tip moves under ORICURVE, the second point does not");
    }
    return 0;
}

/* Coefficients of s = p / PL from those of p; the first follows from the ends. */
static void coefficients(const struct polynomial p[3], double length, struct vec3 from,
                         struct vec3 to, struct vec3 c[NC_MOTION_DEGREE])
{
    double power = length;
    c[0] = vec_sub(to, from);
    for (int i = 1; i < NC_MOTION_DEGREE; i++) {
        power *= length;
        c[i] = vec_scale(power, vec(p[0].value[i], p[1].value[i], p[2].value[i]));
        c[0] = vec_sub(c[0], c[i]);
    }
}

static int poly_piece(struct ncread *c, struct ncread_siemens_block *b, struct nc_piece *piece,
                      struct error *error)
{
    if (!(b->length > 0))
        return ncread_error(c, error, "POLY with a PL that is not above zero");
    struct nc_motion_polynomial sum = {.swings = b->head_n == 3};
    piece->shape = SHAPE_POLYNOMIAL;
    piece->index = c->nc_motion->polynomial.n;
    coefficients(b->tip, b->length, piece->p[0], piece->p[1], sum.p);
    if (b->head_n == 3 && piece->swing != SWING_HEAD)
        return ncread_error(c, error, "ORICURVE from a second point that is not known");
    if (sum.swings)
        coefficients(b->second, b->length, piece->q[0], piece->q[1], sum.q);
    *array_push(&c->nc_motion->polynomial) = sum;
    return 0;
}

/* One pole of a BSPLINE; the first pole is where the tool is. */
static int bspline_block(struct ncread *c, struct ncread_siemens_block *b, struct nc_piece *piece,
                         struct error *error)
{
    if (b->vector_n == 3 || b->length != 1)
        return ncread_error(c, error, "BSPLINE with tool vectors or PL");
    if (b->head_n == 3 && piece->swing != SWING_HEAD)
        return ncread_error(c, error, "ORICURVE from a second point that is not known");
    if (c->pole_p.n == 0) {
        if (ncread_ready(c, error) < 0)
            return -1;
        ncread_pole(c, piece, piece->p[0], piece->q[0]);
        *array_push(&c->weight) = 1;
    }
    ncread_pole(c, piece, piece->p[1], piece->q[1]);
    *array_push(&c->weight) = b->weight;
    c->here = b->to;
    return 0;
}

/* Uniform knots, the ends repeated: the spline that has been read is complete. */
static int bspline_ends(struct ncread *c, struct error *error)
{
    size_t order = c->order ? (size_t)c->order : 4, n = c->pole_p.n;
    if (n == 0)
        return 0;
    c->order = (int)order;
    for (size_t i = 0; i < n + order; i++)
        *array_push(&c->knot) = i < order ? 0
                                : i < n   ? (double)(i - order + 1)
                                          : (double)(n - order + 1);
    return ncread_spline(c, error);
}

static int arc_piece(struct ncread *c, struct ncread_siemens_block *b, struct nc_piece *piece,
                     struct error *error)
{
    if (b->centre_named == b->radius_named)
        return ncread_error(c, error, "an arc wants its centre by I J K or CR=, not both");
    if (b->radius_named)
        return ncread_arc_radius(c, piece, b->radius, c->move == MOVE_CCW, error);
    return ncread_arc(c, piece, vec_add(piece->p[0], b->centre), c->move == MOVE_CCW, error);
}

static int run_block(struct ncread *c, struct ncread_siemens_block *b, struct error *error)
{
    bool polynomials = false;
    for (int i = 0; i < 3; i++)
        polynomials = polynomials || b->tip[i].named || b->second[i].named;
    if (b->machine) {
        if (c->tcp)
            return ncread_error(c, error, "SUPA under TRAORI");
        memset(c->here.known, 0, sizeof c->here.known);
        return 0;
    }
    if (block_axis(c, b, error) < 0)
        return -1;
    if (!b->named)
        return c->move == MOVE_BSPLINE ? 0 : bspline_ends(c, error);
    if (c->move == MOVE_NONE)
        return ncread_error(c, error, "a place before G0 or G1");
    if (!c->absolute)
        return ncread_error(c, error, "a move under G91");
    if (c->hole.on)
        return ncread_hole_down(c, &b->to, error);
    if (b->weighs && c->move != MOVE_BSPLINE)
        return ncread_error(c, error, "PW without BSPLINE");
    if (polynomials && c->move != MOVE_POLY)
        return ncread_error(c, error, "PO[] without POLY");
    if (b->middle_n != (c->move == MOVE_CIP ? 3 : 0))
        return ncread_error(c, error, "CIP wants I1= J1= K1=, others none of them");
    if (c->move != MOVE_BSPLINE && bspline_ends(c, error) < 0)
        return -1;
    struct nc_piece piece = ncread_piece(c, &b->to);
    int result = 0;
    if (c->move == MOVE_BSPLINE)
        return bspline_block(c, b, &piece, error);
    if (c->move == MOVE_CW || c->move == MOVE_CCW)
        result = arc_piece(c, b, &piece, error);
    else if (c->move == MOVE_CIP)
        result =
            ncread_arc_through(c, &piece, vec(b->middle[0], b->middle[1], b->middle[2]), error);
    else if (c->move == MOVE_POLY)
        result = poly_piece(c, b, &piece, error);
    return result < 0 ? -1 : ncread_go(c, &b->to, piece, c->move == MOVE_RAPID, error);
}

static int read_block(struct ncread *c, const char *line, struct error *error)
{
    c->nc_motion->blocks++;
    if (c->line == 1) {
        size_t n = strlen(line);
        c->plane = 17;
        c->vectors = true;
        bool named = n > 8 && strncmp(line, "%_N_", 4) == 0 && strcmp(line + n - 4, "_MPF") == 0;
        return named ? 0 : ncread_error(c, error, "expected %_N_NAME_MPF");
    }
    if (c->ended)
        return ncread_error(c, error, "a block behind M30");
    if (strlen(line) > 512)
        return ncread_error(c, error, "a block of more than 512 characters");
    struct error found;
    int lexed = ncread_word_siemens(line, &c->words, &found);
    const struct ncread_word *n = ncread_word_find(&c->words, "N");
    if (n && ncread_block(c, n->value[0], error) < 0)
        return -1;
    if (lexed < 0)
        return ncread_error(c, error, found.text);
    struct ncread_siemens_block b = {.to = c->here, .length = 1, .weight = 1};
    if (ncread_siemens_words(c, &b, error) < 0)
        return -1;
    return run_block(c, &b, error);
}

static int read_end(struct ncread *c, struct error *error)
{
    if (!c->ended)
        return ncread_error(c, error, "the program ends without M30");
    if (c->pole_p.n > 0)
        return ncread_error(c, error, "the program ends inside a BSPLINE");
    if (c->tcp || c->spindle)
        return ncread_error(c, error, "ends with the spindle turning or with TRAORI on");
    return 0;
}

const struct ncread_dialect ncread_siemens = {"siemens", read_block, read_end};
