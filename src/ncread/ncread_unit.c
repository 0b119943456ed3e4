/* ncread_unit - see ncread_unit.h. */
#include "ncread_unit.h"

#include "ncread/ncread.h"

int ncread_unit(struct ncread *c, double mm, struct error *error)
{
    if (c->unit > 0 && c->unit != mm)
        return ncread_error(c, error, "millimetres and inches in one program");
    c->unit = mm;
    return 0;
}

static void ends(double unit, struct nc_piece *piece)
{
    for (int i = 0; i < 2; i++) {
        piece->p[i] = vec_scale(unit, piece->p[i]);
        if (piece->swing == SWING_HEAD)
            piece->q[i] = vec_scale(unit, piece->q[i]);
    }
    if (!piece->inverse)
        piece->feed *= unit;
}

void ncread_unit_piece(struct ncread *c, struct nc_piece *piece)
{
    if (!(c->unit > 0)) /* only rapid moves: the frame is set later */
        return;
    ends(c->unit, piece);
    if (piece->shape == SHAPE_ARC) {
        struct nc_motion_arc *arc = &c->nc_motion->arc.item[piece->index];
        arc->centre = vec_scale(c->unit, arc->centre);
    } else if (piece->shape == SHAPE_POLYNOMIAL) {
        struct nc_motion_polynomial *sum = &c->nc_motion->polynomial.item[piece->index];
        for (int i = 0; i < NC_MOTION_DEGREE; i++) {
            sum->p[i] = vec_scale(c->unit, sum->p[i]);
            sum->q[i] = vec_scale(c->unit, sum->q[i]);
        }
    }
}

void ncread_unit_poles(struct ncread *c)
{
    for (size_t i = 0; i < c->pole_p.n; i++) {
        c->pole_p.item[i] = vec_scale(c->unit, c->pole_p.item[i]);
        if (c->spline.swing == SWING_HEAD)
            c->pole_q.item[i] = vec_scale(c->unit, c->pole_q.item[i]);
    }
    ends(c->unit, &c->spline);
}
