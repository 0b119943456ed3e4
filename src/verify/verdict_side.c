/* verdict_side - see verdict_side.h. */
#include "verdict_side.h"

#include <math.h>
#include <stdlib.h>

enum { BARS = 41 };

long side_row(struct side_rows *rows, size_t piece)
{
    if (rows->of[piece] == 0) {
        *array_push(&rows->piece) = piece;
        rows->of[piece] = rows->piece.n;
    }
    return (long)rows->of[piece] - 1;
}

void side_text(struct out *o, const char *s)
{
    for (; *s; s++) {
        if (*s == '<' || *s == '>' || *s == '&')
            out_text(o, *s == '<' ? "&lt;" : *s == '>' ? "&gt;" : "&amp;");
        else
            out_bytes(o, s, 1);
    }
}

static void row(struct out *o, const char *what, double worst, const double *part, size_t beyond)
{
    out_printf(o, "<tr><th scope=\"row\">%s</th>", what);
    out_printf(o, "<td class=\"n\">%.4f</td><td class=\"n\">%.4f</td>", worst, part[0]);
    out_printf(o, "<td class=\"n\">%.4f</td><td class=\"n\">%.4f</td>", part[1], part[2]);
    out_printf(o, "<td class=\"n\">%zu</td></tr>\n", beyond);
}

static void figures(struct out *o, const struct verdict *v)
{
    static const char letter[] = "XYZABC";
    const struct deviation_map *r = &v->roll;
    out_text(o, "<h2>Figures, mm</h2>\n<table><tr><td></td><th>worst</th><th>50%</th><th>95%</th>"
                "<th>99%</th><th>points beyond</th></tr>\n");
    row(o, "gouge", r->gouge, r->gouge_part, r->gouged);
    row(o, "left", r->over, r->over_part, r->left);
    out_printf(o, "</table>\n<p>%zu points, %zu in the region cut. %.1f mm in %u passes, ",
               r->points, r->cut, v->load.cut_length, v->passes);
    out_printf(o, "%.2f min at feed; %.1f mm rapid, %.2f min.</p>\n<table>", v->load.cut_time,
               v->load.rapid_length, v->load.rapid_time);
    for (int k = 0; k < LOAD_AXES; k++)
        if (v->load.low[k] < v->load.high[k])
            out_printf(o,
                       "<tr><th scope=\"row\">travel %c</th><td class=\"n\">%.3f</td>"
                       "<td class=\"n\">%.3f</td></tr>\n",
                       letter[k], v->load.low[k], v->load.high[k]);
    out_text(o, "</table>\n");
}

static void findings(struct out *o, const struct verdict *v)
{
    out_printf(o, "<p class=\"%s\" role=\"status\">%s</p>\n", verdict_refused(v) ? "bad" : "good",
               verdict_refused(v) ? "refused" : "accepted");
    out_text(o, "<ul>\n");
    for (size_t i = 0; i < v->finding.n; i++) {
        out_printf(o, "<li%s>", v->finding.item[i].fault ? " class=\"bad\"" : "");
        side_text(o, v->finding.item[i].text);
        out_text(o, "</li>\n");
    }
    out_text(o, "</ul>\n");
}

/* Bars of how many points there are at each deviation, from the worst gouge to `most`. */
static void histogram(struct out *o, const struct verdict *v)
{
    size_t count[BARS] = {0}, highest = 1;
    double low = -fmax(v->roll.gouge, v->tolerance), high = fmax(v->roll.over_part[2] * 1.2, -low);
    for (size_t i = 0; i < v->roll.points; i++) {
        double share = (v->roll.deviation[i] - low) / (high - low);
        if (v->roll.region[i])
            count[(int)fmin(fmax(share * BARS, 0), BARS - 1)]++;
    }
    for (int i = 0; i < BARS; i++)
        highest = count[i] > highest ? count[i] : highest;
    out_text(o, "<h2>How many points at which deviation</h2>\n<svg viewBox=\"0 0 410 130\" "
                "width=\"100%\" role=\"img\" aria-label=\"histogram of deviations\">\n");
    for (int i = 0; i < BARS; i++) {
        /* by the logarithm, so that a few gouged points are seen */
        double tall = 100 * log1p((double)count[i]) / log1p((double)highest);
        double at = low + (high - low) * (i + 0.5) / BARS;
        out_printf(o, "<rect x=\"%d\" y=\"%.1f\" width=\"9\" height=\"%.1f\" fill=\"%s\">", 10 * i,
                   105 - tall, tall,
                   at < -v->tolerance   ? "#dc1e1e"
                   : at <= v->tolerance ? "#46aa5a"
                                        : "#285adc");
        out_printf(o, "<title>%.4f mm: %zu points</title></rect>\n", at, count[i]);
    }
    out_printf(o, "<text x=\"0\" y=\"122\" font-size=\"12\">%.4f</text>", low);
    out_printf(o,
               "<text x=\"410\" y=\"122\" font-size=\"12\" text-anchor=\"end\">%.4f mm</text>"
               "</svg>\n<p>Heights by the logarithm.</p>\n",
               high);
}

static void blocks(struct out *o, const struct verdict *v, struct side_rows *rows,
                   const size_t *worst, size_t n)
{
    out_text(o, "<h2>Worst blocks</h2>\n<div>\n");
    for (size_t i = 0; i < n; i++) {
        const struct verdict_piece *at = &v->piece[worst[i]];
        bool gouge = (double)at->gouge > v->tolerance || at->over <= 0;
        char where[60];
        ncread_place(&v->nc_motion->piece.item[worst[i]], where, sizeof where);
        out_printf(o, "<button type=\"button\" data-row=\"%ld\">%s, pass %u: %s %.4f</button>\n",
                   side_row(rows, worst[i]), where, at->pass, gouge ? "gouge" : "left",
                   (double)(gouge ? at->gouge : at->over));
    }
    out_text(o, "</div>\n");
}

/* What one pass did. */
struct pass {
    double gouge, over, length; /* mm */
    const struct nc_piece *first, *last;
};

static double length_of(const struct nc_motion *nc_motion, const struct nc_piece *piece)
{
    enum { STEPS = 8 };
    double length = 0;
    for (int k = 0; k < STEPS; k++)
        length += vec_distance(nc_motion_at(nc_motion, piece, (double)k / STEPS).p,
                               nc_motion_at(nc_motion, piece, (double)(k + 1) / STEPS).p);
    return length;
}

/* A button for each pass. */
static void passes(struct out *o, const struct verdict *v)
{
    struct pass *pass = mem_alloc((size_t)v->passes + 1, sizeof *pass);
    for (size_t i = 0; i < v->nc_motion->piece.n; i++) {
        const struct nc_piece *piece = &v->nc_motion->piece.item[i];
        struct pass *p = &pass[v->piece[i].pass];
        if (piece->rapid || v->piece[i].pass > v->passes)
            continue;
        p->gouge = fmax(p->gouge, (double)v->piece[i].gouge);
        p->over = fmax(p->over, (double)v->piece[i].over);
        p->length += length_of(v->nc_motion, piece);
        p->first = p->first ? p->first : piece;
        p->last = piece;
    }
    out_text(o, "<h2>Passes</h2>\n<div id=\"passes\">\n");
    for (unsigned i = 0; i <= v->passes; i++) {
        char from[60], to[60];
        if (!pass[i].first)
            continue;
        ncread_place(pass[i].first, from, sizeof from);
        ncread_place(pass[i].last, to, sizeof to);
        out_printf(o,
                   "<button type=\"button\" data-pass=\"%u\" aria-pressed=\"false\" "
                   "title=\"%s to %s\">pass %u: gouge %.4f, left %.4f, %.1f mm</button>\n",
                   i, from, to, i, pass[i].gouge, pass[i].over, pass[i].length);
    }
    out_text(o, "</div>\n");
    free(pass);
}

void side_write(struct out *o, const struct verdict *v, struct side_rows *rows, const size_t *worst,
                size_t n)
{
    findings(o, v);
    figures(o, v);
    histogram(o, v);
    blocks(o, v, rows, worst, n);
    passes(o, v);
}
