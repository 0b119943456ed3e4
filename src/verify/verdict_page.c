/*
 * verdict_page - the verdict as one page for a browser, nothing loaded from anywhere: page.html
 * with each {{name}} replaced by what stands in `fields` below (see verify.h).
 *
 * page.js reads `const D`: centre [x y z], points (x y z deviation inside row), nodes (x y z kind
 * row; kind 0 begins, 1 cuts, 2 is rapid), rows (block line pass gouge left), speed (of each row,
 * in hundredths of the feed; empty: not known), worst (rows),
 * tolerance and full (deviations of full colour).  Places are whole thousandths of a mm, deviations
 * ten-thousandths.
 */
#include <limits.h>
#include <stdlib.h>
#include <string.h>

#include "math/elementary.h"
#include "base/array.h"
#include "base/out.h"
#include "math/box.h"
#include "ncread/ncread.h"
#include "verify/verify.h"

/* The files of these names, which make builds in. */
extern const char page_html[], page_css[], page_js[];

enum {
    POINTS = 60000,
    NODES = 60000, /* what a browser turns without delay */
    WORST = 12,    /* blocks with the deepest gouges, and as many with most left */
    BARS = 41      /* of the histogram */
};

/* Rows of the table of pieces that the page knows, each once. */
struct page_rows {
    size_t *of; /* number of each piece's row, from 1; 0: none yet */
    struct sizes piece;
};

struct page {
    struct out *out;
    const struct verdict *verdict;
    struct page_rows rows;
    size_t worst[2 * WORST], worst_n; /* pieces */
};

/* Number of the piece's row, from 0; a new one where it has none. */
static long row_of(struct page_rows *rows, size_t piece)
{
    if (rows->of[piece] == 0) {
        *array_push(&rows->piece) = piece;
        rows->of[piece] = rows->piece.n;
    }
    return (long)rows->of[piece] - 1;
}

/* Text with what HTML has for <, > and &. */
static void print_escaped(struct out *o, const char *s)
{
    for (; *s; s++) {
        if (*s == '<' || *s == '>' || *s == '&')
            out_text(o, *s == '<' ? "&lt;" : *s == '>' ? "&gt;" : "&amp;");
        else
            out_bytes(o, s, 1);
    }
}

/* ---- the data of the script */

static int thousandths(double mm)
{
    return (int)lround(fmax(fmin(mm, 2e6), -2e6) * 1000);
}

/* Deviations have a digit more than places. */
static int fine(double mm)
{
    return (int)lround(fmin(mm, 2e5) * 10000);
}

static struct vec3 middle_of(const struct vec3s *points)
{
    struct box box = box_around(points->item, points->n);
    return vec_mix(box.low, box.high, 0.5);
}

static void print_place(struct out *o, struct vec3 p, struct vec3 centre)
{
    out_printf(o, "%d,%d,%d,", thousandths(p.x - centre.x), thousandths(p.y - centre.y),
               thousandths(p.z - centre.z));
}

/* How much a point is worth being shown. */
static double weight(const struct verdict *v, size_t i)
{
    double deviation = v->map.deviation[i];
    if (!v->map.region[i])
        return -1;
    return deviation < 0 ? 1000 - deviation : deviation;
}

/* Of as many points in a row as there are too many, the one that is worst. */
static void print_points(struct out *o, const struct verdict *v, struct vec3 centre,
                         struct page_rows *rows)
{
    size_t stride = v->map.points / POINTS + 1;
    out_text(o, "points:[");
    for (size_t from = 0; from < v->map.points; from += stride) {
        size_t to = from + stride < v->map.points ? from + stride : v->map.points, best = from;
        for (size_t i = from + 1; i < to; i++)
            if (weight(v, i) > weight(v, best))
                best = i;
        unsigned segment = v->map.segment[best];
        print_place(o, v->program.part->item[best], centre);
        out_printf(o, "%d,%d,%ld,\n", fine(v->map.deviation[best]), v->map.region[best],
                   segment == UINT_MAX ? -1 : row_of(rows, v->cut.item[segment].piece));
    }
    out_text(o, "],\n");
}

/* The path of the tip; curves in eight steps. */
static void print_nodes(struct out *o, const struct verdict *v, struct vec3 centre,
                        struct page_rows *rows)
{
    const struct nc_motion *motion = v->program.motion;
    size_t stride = motion->piece.n / NODES + 1;
    out_text(o, "nodes:[");
    for (size_t i = 0; i < motion->piece.n; i++) {
        const struct nc_piece *piece = &motion->piece.item[i];
        bool turn = i == 0 || piece->rapid != motion->piece.item[i - 1].rapid;
        if (i % stride != 0 && !turn)
            continue;
        long row = row_of(rows, i);
        int steps = piece->shape == SHAPE_LINE ? 1 : 8;
        if (turn) {
            print_place(o, nc_motion_at(motion, piece, 0).p, centre);
            out_printf(o, "0,%ld,\n", row);
        }
        for (int k = 1; k <= steps; k++) {
            print_place(o, nc_motion_at(motion, piece, (double)k / steps).p, centre);
            out_printf(o, "%d,%ld,\n", piece->rapid ? 2 : 1, row);
        }
    }
    out_text(o, "],\n");
}

static void print_data(struct page *page)
{
    const struct verdict *v = page->verdict;
    struct out *o = page->out;
    struct page_rows *rows = &page->rows;
    struct vec3 centre = middle_of(v->program.part);
    double full = isfinite(v->options.left) ? v->options.left : 4 * v->options.tolerance;
    out_printf(o, "const D = {centre:[%d,%d,%d],tolerance:%d,full:%d,\n", thousandths(centre.x),
               thousandths(centre.y), thousandths(centre.z), fine(v->options.tolerance),
               fine(full));
    print_points(o, v, centre, rows);
    print_nodes(o, v, centre, rows);
    out_text(o, "worst:[");
    for (size_t i = 0; i < page->worst_n; i++)
        out_printf(o, "%ld,", row_of(rows, page->worst[i]));
    out_text(o, "],\nrows:[");
    for (size_t i = 0; i < rows->piece.n; i++) {
        size_t at = rows->piece.item[i];
        const struct nc_piece *piece = &v->program.motion->piece.item[at];
        out_printf(o, "%d,%zu,%u,%d,%d,\n", piece->block, piece->line, v->piece[at].pass,
                   fine((double)v->piece[at].gouge), fine((double)v->piece[at].over));
    }
    out_text(o, "],\nspeed:["); /* of the rows, in hundredths of the feed */
    for (size_t i = 0; i < rows->piece.n && v->time.share; i++)
        out_printf(o, "%ld,", lround(100 * (double)v->time.share[rows->piece.item[i]]));
    out_text(o, "]};\n");
}

/* ---- beside the view */

static void print_row(struct out *o, const char *what, double worst, const double *part,
                      size_t beyond)
{
    out_printf(o, "<tr><th scope=\"row\">%s</th>", what);
    out_printf(o, "<td class=\"n\">%.4f</td><td class=\"n\">%.4f</td>", worst, part[0]);
    out_printf(o, "<td class=\"n\">%.4f</td><td class=\"n\">%.4f</td>", part[1], part[2]);
    out_printf(o, "<td class=\"n\">%zu</td></tr>\n", beyond);
}

static void print_figures(struct out *o, const struct verdict *v)
{
    static const char letter[] = "XYZABC";
    const struct deviation_map *r = &v->map;
    out_text(o, "<h2>Figures, mm</h2>\n<table><tr><td></td><th>worst</th><th>50%</th><th>95%</th>"
                "<th>99%</th><th>points beyond</th></tr>\n");
    print_row(o, "gouge", r->gouge, r->gouge_part, r->gouged);
    print_row(o, "left", r->over, r->over_part, r->left);
    out_printf(o, "</table>\n<p>%zu points, %zu of them judged. %.1f mm in %u cuts, ", r->points,
               r->cut, v->axes.cut_length, v->passes);
    out_printf(o, "%.2f min at feed; %.1f mm rapid, %.2f min.</p>\n<table>", v->axes.cut_time,
               v->axes.rapid_length, v->axes.rapid_time);
    for (int k = 0; k < NC_AXES; k++)
        if (v->axes.low[k] < v->axes.high[k])
            out_printf(o,
                       "<tr><th scope=\"row\">travel %c</th><td class=\"n\">%.3f</td>"
                       "<td class=\"n\">%.3f</td></tr>\n",
                       letter[k], v->axes.low[k], v->axes.high[k]);
    out_text(o, "</table>\n");
}

/* Points and area of each class. */
static void print_coverage(struct out *o, const struct verdict *v)
{
    if (!v->coverage.of)
        return;
    out_text(o, "<h2>Coverage</h2>\n<table><tr><td></td><th>points</th><th>mm2</th>"
                "<th>most left, mm</th></tr>\n");
    for (int k = 0; k < COVERAGE_CLASSES; k++) {
        const struct part_coverage_sum *sum = &v->coverage.sum[k];
        out_printf(o, "<tr><th scope=\"row\">%s</th><td class=\"n\">%zu</td>", verdict_class(k),
                   sum->points);
        out_printf(o, "<td class=\"n\">%.1f</td><td class=\"n\">%.4f</td></tr>\n", sum->area,
                   fmax(0, sum->worst));
    }
    out_text(o, "</table>\n");
}

static void print_findings(struct out *o, const struct verdict *v)
{
    out_printf(o, "<p class=\"%s\" role=\"status\">%s</p>\n", verdict_refused(v) ? "bad" : "good",
               verdict_refused(v) ? "refused" : "accepted");
    out_text(o, "<ul>\n");
    for (size_t i = 0; i < v->finding.n; i++) {
        out_printf(o, "<li%s>", v->finding.item[i].fault ? " class=\"bad\"" : "");
        print_escaped(o, v->finding.item[i].text);
        out_text(o, "</li>\n");
    }
    out_text(o, "</ul>\n");
}

/* Bars of how many points there are at each deviation, from the worst gouge to `most`. */
static void print_histogram(struct out *o, const struct verdict *v)
{
    size_t count[BARS] = {0}, highest = 1;
    double low = -fmax(v->map.gouge, v->options.tolerance),
           high = fmax(v->map.over_part[2] * 1.2, -low);
    for (size_t i = 0; i < v->map.points; i++) {
        double share = (v->map.deviation[i] - low) / (high - low);
        if (v->map.region[i])
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
                   at < -v->options.tolerance   ? "#dc1e1e"
                   : at <= v->options.tolerance ? "#46aa5a"
                                                : "#285adc");
        out_printf(o, "<title>%.4f mm: %zu points</title></rect>\n", at, count[i]);
    }
    out_printf(o, "<text x=\"0\" y=\"122\" font-size=\"12\">%.4f</text>", low);
    out_printf(o,
               "<text x=\"410\" y=\"122\" font-size=\"12\" text-anchor=\"end\">%.4f mm</text>"
               "</svg>\n<p>Heights by the logarithm.</p>\n",
               high);
}

static void print_blocks(struct out *o, const struct verdict *v, struct page_rows *rows,
                         const size_t *worst, size_t n)
{
    out_text(o, "<h2>Worst blocks</h2>\n<div>\n");
    for (size_t i = 0; i < n; i++) {
        const struct verdict_piece *at = &v->piece[worst[i]];
        bool gouge = (double)at->gouge > v->options.tolerance || at->over <= 0;
        char where[60];
        ncread_place(&v->program.motion->piece.item[worst[i]], where, sizeof where);
        out_printf(o, "<button type=\"button\" data-row=\"%ld\">%s, cut %u: %s %.4f</button>\n",
                   row_of(rows, worst[i]), where, at->pass, gouge ? "gouge" : "left",
                   (double)(gouge ? at->gouge : at->over));
    }
    out_text(o, "</div>\n");
}

/* What one pass did. */
struct pass_sum {
    double gouge, over, length; /* mm */
    const struct nc_piece *first, *last;
};

static double length_of(const struct nc_motion *motion, const struct nc_piece *piece)
{
    enum { STEPS = 8 };
    double length = 0;
    for (int k = 0; k < STEPS; k++)
        length += vec_distance(nc_motion_at(motion, piece, (double)k / STEPS).p,
                               nc_motion_at(motion, piece, (double)(k + 1) / STEPS).p);
    return length;
}

/* A button for each pass. */
static void print_passes(struct out *o, const struct verdict *v)
{
    struct pass_sum *pass = mem_alloc((size_t)v->passes + 1, sizeof *pass);
    for (size_t i = 0; i < v->program.motion->piece.n; i++) {
        const struct nc_piece *piece = &v->program.motion->piece.item[i];
        struct pass_sum *p = &pass[v->piece[i].pass];
        if (piece->rapid || v->piece[i].pass > v->passes)
            continue;
        p->gouge = fmax(p->gouge, (double)v->piece[i].gouge);
        p->over = fmax(p->over, (double)v->piece[i].over);
        p->length += length_of(v->program.motion, piece);
        p->first = p->first ? p->first : piece;
        p->last = piece;
    }
    out_text(o, "<h2>Cuts, from rapid to rapid</h2>\n<div id=\"passes\">\n");
    for (unsigned i = 0; i <= v->passes; i++) {
        char from[60], to[60];
        if (!pass[i].first)
            continue;
        ncread_place(pass[i].first, from, sizeof from);
        ncread_place(pass[i].last, to, sizeof to);
        out_printf(o,
                   "<button type=\"button\" data-pass=\"%u\" aria-pressed=\"false\" "
                   "title=\"%s to %s\">cut %u: gouge %.4f, left %.4f, %.1f mm</button>\n",
                   i, from, to, i, pass[i].gouge, pass[i].over, pass[i].length);
    }
    out_text(o, "</div>\n");
    free(pass);
}

/* ---- the fields of page.html */

static void print_file(struct page *page)
{
    print_escaped(page->out, page->verdict->program.file);
}

static void print_program(struct page *page)
{
    const struct verdict *v = page->verdict;
    out_printf(page->out, "%s, ball of radius %g, tolerance %g mm, machine ", v->program.control,
               v->options.radius, v->options.tolerance);
    print_escaped(page->out, v->program.machine);
}

static void print_verdict(struct page *page)
{
    print_findings(page->out, page->verdict);
    print_figures(page->out, page->verdict);
    print_coverage(page->out, page->verdict);
    print_histogram(page->out, page->verdict);
    print_blocks(page->out, page->verdict, &page->rows, page->worst, page->worst_n);
    print_passes(page->out, page->verdict);
}

static void print_css(struct page *page)
{
    out_text(page->out, page_css);
}

static void print_js(struct page *page)
{
    out_text(page->out, page_js);
}

static const struct {
    const char *name;
    void (*print)(struct page *page);
} fields[] = {{"file", print_file}, {"program", print_program}, {"verdict", print_verdict},
              {"data", print_data}, {"page.css", print_css},    {"page.js", print_js}};

/* The field whose name begins at s: printed. */
static void print_field(struct page *page, const char *s, size_t n)
{
    for (size_t i = 0; i < sizeof fields / sizeof *fields; i++)
        if (strlen(fields[i].name) == n && strncmp(fields[i].name, s, n) == 0)
            fields[i].print(page);
}

static void find_worst(struct page *page)
{
    const struct verdict *v = page->verdict;
    size_t n = verdict_worst(v, true, WORST, page->worst);
    while (n > 0 && (double)v->piece[page->worst[n - 1]].gouge <= v->options.tolerance)
        n--; /* what is within the tolerance is no matter */
    page->worst_n = n + verdict_worst(v, false, WORST, page->worst + n);
}

void verdict_page(const struct verdict *v, const char *file)
{
    struct page page = {.out = out_open(file), .verdict = v};
    page.rows.of = mem_alloc(v->program.motion->piece.n, sizeof *page.rows.of);
    find_worst(&page);
    const char *s = page_html;
    for (const char *field; (field = strstr(s, "{{")); s = strstr(field, "}}") + 2) {
        out_bytes(page.out, s, (size_t)(field - s));
        print_field(&page, field + 2, (size_t)(strstr(field, "}}") - field - 2));
    }
    out_text(page.out, s);
    out_close(page.out);
    free(page.rows.of);
    array_free(&page.rows.piece);
}
