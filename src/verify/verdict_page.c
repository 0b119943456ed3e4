/* verdict_page - one page for a browser, nothing loaded from anywhere: see verdict.h. */
#include <limits.h>
#include <math.h>
#include <stdlib.h>

#include "base/out.h"
#include "verify/verdict.h"
#include "verdict_script.h"
#include "verdict_side.h"

/* What a browser turns without delay. */
enum { POINTS = 60000, NODES = 60000, WORST = 12 };

static const char style[] =
    "body{font:15px/1.4 system-ui,sans-serif;margin:0;color:#1c1c1c;background:#fafafa}\n"
    "main{display:grid;grid-template-columns:minmax(0,1fr) 24rem;gap:1rem;padding:1rem}\n"
    "h1{font-size:1.2rem;margin:.6rem 1rem 0}h2{font-size:1rem;margin:.8rem 0 .3rem}\n"
    "#view{width:100%;height:70vh;background:#fff;border:1px solid #bbb;touch-action:none}\n"
    "#view:focus,button:focus-visible{outline:3px solid #2864dc}\n"
    "table{border-collapse:collapse}td,th{text-align:left;padding:.1rem .6rem .1rem 0}\n"
    "td.n{text-align:right;font-variant-numeric:tabular-nums}\n"
    "button{font:inherit;margin:.1rem .2rem .1rem 0;padding:.1rem .5rem;cursor:pointer}\n"
    "button[aria-pressed=true]{background:#dce8ff}#passes{max-height:16rem;overflow:auto}\n"
    ".bad{color:#b00020;font-weight:600}.good{color:#1b7a34;font-weight:600}\n"
    "@media(max-width:60rem){main{grid-template-columns:1fr}}\n";

static int thousandths(double mm)
{
    return (int)lround(fmax(fmin(mm, 2e6), -2e6) * 1000);
}

/* Deviations are told finer than places. */
static int fine(double mm)
{
    return (int)lround(fmin(mm, 2e5) * 10000);
}

static struct vec3 middle(const struct vec3s *points)
{
    struct vec3 low = points->item[0], high = low;
    for (size_t i = 1; i < points->n; i++) {
        struct vec3 p = points->item[i];
        low = vec(fmin(low.x, p.x), fmin(low.y, p.y), fmin(low.z, p.z));
        high = vec(fmax(high.x, p.x), fmax(high.y, p.y), fmax(high.z, p.z));
    }
    return vec_mix(low, high, 0.5);
}

static void place(struct out *o, struct vec3 p, struct vec3 centre)
{
    out_printf(o, "%d,%d,%d,", thousandths(p.x - centre.x), thousandths(p.y - centre.y),
               thousandths(p.z - centre.z));
}

/* How much a point is worth being shown. */
static double weight(const struct verdict *v, size_t i)
{
    double deviation = v->roll.deviation[i];
    if (!v->roll.region[i])
        return -1;
    return deviation < 0 ? 1000 - deviation : deviation;
}

/* Of as many points in a row as there are too many, the one that is worst. */
static void points(struct out *o, const struct verdict *v, struct vec3 centre,
                   struct side_rows *rows)
{
    size_t stride = v->roll.points / POINTS + 1;
    out_text(o, "points:[");
    for (size_t from = 0; from < v->roll.points; from += stride) {
        size_t to = from + stride < v->roll.points ? from + stride : v->roll.points, best = from;
        for (size_t i = from + 1; i < to; i++)
            if (weight(v, i) > weight(v, best))
                best = i;
        unsigned segment = v->roll.segment[best];
        place(o, v->point->item[best], centre);
        out_printf(o, "%d,%d,%ld,\n", fine(v->roll.deviation[best]), v->roll.region[best],
                   segment == UINT_MAX ? -1 : side_row(rows, v->cut->item[segment].piece));
    }
    out_text(o, "],\n");
}

/* The way of the tip; curves in eight steps. */
static void nodes(struct out *o, const struct verdict *v, struct vec3 centre,
                  struct side_rows *rows)
{
    const struct nc_motion *nc_motion = v->nc_motion;
    size_t stride = nc_motion->piece.n / NODES + 1;
    out_text(o, "nodes:[");
    for (size_t i = 0; i < nc_motion->piece.n; i++) {
        const struct nc_piece *piece = &nc_motion->piece.item[i];
        bool turn = i == 0 || piece->rapid != nc_motion->piece.item[i - 1].rapid;
        if (i % stride != 0 && !turn)
            continue;
        long row = side_row(rows, i);
        int steps = piece->shape == SHAPE_LINE ? 1 : 8;
        if (turn) {
            place(o, nc_motion_at(nc_motion, piece, 0).p, centre);
            out_printf(o, "0,%ld,\n", row);
        }
        for (int k = 1; k <= steps; k++) {
            place(o, nc_motion_at(nc_motion, piece, (double)k / steps).p, centre);
            out_printf(o, "%d,%ld,\n", piece->rapid ? 2 : 1, row);
        }
    }
    out_text(o, "],\n");
}

static void data(struct out *o, const struct verdict *v, struct side_rows *rows,
                 const size_t *worst, size_t n)
{
    struct vec3 centre = middle(v->point);
    double full = isfinite(v->left) ? v->left : 4 * v->tolerance;
    out_printf(o, "const D = {centre:[%d,%d,%d],tolerance:%d,full:%d,\n", thousandths(centre.x),
               thousandths(centre.y), thousandths(centre.z), fine(v->tolerance), fine(full));
    points(o, v, centre, rows);
    nodes(o, v, centre, rows);
    out_text(o, "worst:[");
    for (size_t i = 0; i < n; i++)
        out_printf(o, "%ld,", side_row(rows, worst[i]));
    out_text(o, "],\nrows:[");
    for (size_t i = 0; i < rows->piece.n; i++) {
        size_t at = rows->piece.item[i];
        const struct nc_piece *piece = &v->nc_motion->piece.item[at];
        out_printf(o, "%d,%zu,%u,%d,%d,\n", piece->block, piece->line, v->piece[at].pass,
                   fine((double)v->piece[at].gouge), fine((double)v->piece[at].over));
    }
    out_text(o, "]};\n");
}

static void body(struct out *o, const struct verdict *v, struct side_rows *rows,
                 const size_t *worst, size_t n)
{
    out_text(o, "<h1>");
    side_text(o, v->file);
    out_printf(o, ": %s, ball of radius %g, tolerance %g mm, machine ", v->control, v->radius,
               v->tolerance);
    side_text(o, v->machine);
    out_text(o,
             "</h1>\n<main><section>\n<canvas id=\"view\" tabindex=\"0\" role=\"img\" "
             "aria-label=\"the part, coloured by deviation; keys are told below\"></canvas>\n"
             "<p id=\"info\" aria-live=\"polite\">Nothing is chosen.</p>\n<p>"
             "<button type=\"button\" id=\"points\" aria-pressed=\"true\">points</button>"
             "<button type=\"button\" id=\"path\" aria-pressed=\"true\">path</button>"
             "<button type=\"button\" id=\"rapid\" aria-pressed=\"true\">rapids</button> "
             "<label>block <input id=\"find\" size=\"8\" inputmode=\"numeric\"></label></p>\n"
             "<p>Green is cut, red gouged, blue left, grey not of the region cut. Drag turns, with "
             "shift it moves, the wheel zooms, a click chooses. Keys: arrows turn, with shift "
             "move, + and - zoom, 0 begins anew, t from above, f from the front, n and p the next "
             "and the last of the worst blocks, ] and [ of the passes, Esc "
             "nothing.</p>\n</section><section>\n");
    side_write(o, v, rows, worst, n);
    out_text(o, "</section></main>\n");
}

void verdict_page(const struct verdict *v, const char *file)
{
    struct side_rows rows = {0};
    struct out *o = out_open(file);
    size_t worst[2 * WORST], n = verdict_worst(v, true, WORST, worst);
    while (n > 0 && (double)v->piece[worst[n - 1]].gouge <= v->tolerance)
        n--; /* what is within the tolerance is no matter */
    n += verdict_worst(v, false, WORST, worst + n);
    rows.of = mem_alloc(v->nc_motion->piece.n, sizeof *rows.of);
    out_text(o, "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">\n"
                "<meta name=\"viewport\" content=\"width=device-width\">\n<title>ncverify: ");
    side_text(o, v->file);
    out_text(o, "</title>\n<style>\n");
    out_text(o, style);
    out_text(o, "</style></head><body>\n");
    body(o, v, &rows, worst, n);
    out_text(o, "<script>\n");
    data(o, v, &rows, worst, n);
    for (const char *const *line = verdict_script; *line; line++) {
        out_text(o, *line);
        out_text(o, "\n");
    }
    out_text(o, "</script>\n</body></html>\n");
    out_close(o);
    free(rows.of);
    array_free(&rows.piece);
}
