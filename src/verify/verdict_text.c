/* verdict_text - the figures as text: see verdict.h. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "base/out.h"
#include "verify/verdict.h"

enum { WORST = 5 };

static void program(const struct verdict *v, struct out *o)
{
    const struct nc_motion *c = v->nc_motion;
    const struct axis_limits *load = &v->load;
    out_printf(o, "program      %s: %s, %zu lines; %zu straight, %zu arcs, %zu curves\n", v->file,
               v->control, c->blocks, c->lines, c->arcs, c->curves);
    out_printf(o, "machine      %s\n", v->machine);
    out_printf(o, "way          %.1f mm cut in %u passes, %.1f mm rapid\n", load->cut_length,
               v->passes, load->rapid_length);
    out_printf(o, "time         %.2f min at feed, %.2f min rapid", load->cut_time,
               load->rapid_time);
    if (c->dwell > 0)
        out_printf(o, ", %.2f min dwell", c->dwell);
    out_text(o, "\n");
}

static void axes(const struct verdict *v, struct out *o)
{
    static const char letter[] = "XYZABC";
    const struct axis_limits *load = &v->load;
    char place[60];
    for (int k = 0; k < LOAD_AXES; k++)
        if (load->low[k] < load->high[k])
            out_printf(o, "travel %c     %.3f to %.3f\n", letter[k], load->low[k], load->high[k]);
    if (load->jump.value > 0) {
        ncread_place(&v->nc_motion->piece.item[load->jump.piece], place, sizeof place);
        out_printf(o, "turn         axis %c by at most %.3f degrees in a block, %s\n",
                   letter[load->jump.axis], load->jump.value, place);
    }
    if (load->swing.value > 0) {
        ncread_place(&v->nc_motion->piece.item[load->swing.piece], place, sizeof place);
        out_printf(o, "swing        axis %c by at most %.3f degrees a mm, %s\n",
                   letter[load->swing.axis], load->swing.value, place);
    }
}

static void quantity(const struct verdict *v, struct out *o, bool gouge)
{
    const struct deviation_map *r = &v->roll;
    const double *part = gouge ? r->gouge_part : r->over_part;
    double worst = gouge ? r->gouge : r->over;
    struct vec3 p = v->point->item[gouge ? r->gouge_at : r->over_at];
    size_t piece[WORST], n = verdict_worst(v, gouge, WORST, piece);
    const char *name = gouge ? "gouge" : "left ";
    out_printf(o, "%s        worst %.4f mm at %.3f %.3f %.3f\n", name, worst, p.x, p.y, p.z);
    out_printf(o, "%s        50%% %.4f, 95%% %.4f, 99%% %.4f mm; %zu points beyond\n", name,
               part[0], part[1], part[2], gouge ? r->gouged : r->left);
    for (size_t i = 0; i < n; i++) {
        char place[60];
        const struct verdict_piece *at = &v->piece[piece[i]];
        ncread_place(&v->nc_motion->piece.item[piece[i]], place, sizeof place);
        out_printf(o, "%s        %.4f mm in %s, pass %u\n", name,
                   (double)(gouge ? at->gouge : at->over), place, at->pass);
    }
}

void verdict_text(const struct verdict *v, const char *file)
{
    struct out *o = out_open(file);
    program(v, o);
    axes(v, o);
    out_printf(o, "part         %zu points, %zu of them in the region cut\n", v->roll.points,
               v->roll.cut);
    if (v->roll.cut > 0) {
        quantity(v, o, true);
        quantity(v, o, false);
    }
    if (v->stock)
        verdict_stock(v, o);
    for (size_t i = 0; i < v->finding.n; i++)
        out_printf(o, "%s       %s\n", v->finding.item[i].fault ? "fault " : "notice",
                   v->finding.item[i].text);
    out_printf(o, "verdict      %s\n", verdict_refused(v) ? "refused" : "accepted");
    out_close(o);
}
