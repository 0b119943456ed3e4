/* post_head - see post_head.h. */
#include "post_head.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/num.h"

enum { PLANES_SHOWN = 12 };

double nc_ledger_sum(const struct path *path, const struct nc_plan *plan)
{
    double sum = path_spent(path) + plan->total.spent.point * plan->ability.unit;
    sum += plan->ability.smoothing;
    return isnan(path->head.chord) ? sum : sum + path->head.chord;
}

static void tool_line(struct nc_program *p, int number, const double *cutter, int n, double ball)
{
    double unit = p->plan->ability.unit;
    char d[NUM_MAX], r[NUM_MAX];
    if (n == 0)
        return;
    num_write_short(d, unit * cutter[0], 3, false);
    num_write_short(r, n > 1 ? unit * cutter[1] : 0, 3, false);
    nc_comment(&p->w, "Tool %d: %s D %.20s R %.20s", number, ball > 0 ? "ball nose" : "cutter", d,
               r);
}

static void head_tool(struct nc_program *p)
{
    const struct path *path = p->path;
    tool_line(p, path->head.tool, path->head.cutter, path->head.cutter_n, path_ball(path));
    for (size_t i = 0; i < path->tool.n; i++) {
        const struct path_tool *tool = &path->tool.item[i];
        tool_line(p, tool->number, tool->cutter, tool->cutter_n, path_tool_ball(tool));
    }
    if (path->head.track == TRACK_CENTRE) {
        nc_comment(&p->w, "*** ATTENTION: X Y Z ARE THE CENTRE OF THE BALL, NOT THE TIP ***");
        nc_comment(&p->w, "*** the tool's length must be measured to the ball's centre ***");
    } else {
        nc_comment(&p->w, "X Y Z are the tool tip");
    }
}

/* To four decimals, never too small. */
static double rounded_up(double mm)
{
    return fmax(0, ceil(mm * 1e4 - 1e-6)) / 1e4 + 0.0;
}

static void head_ledger(struct nc_program *p)
{
    const struct path_head *head = &p->path->head;
    const struct nc_total *total = &p->plan->total;
    for (size_t i = 0; i < head->ledger.n; i++)
        nc_comment(&p->w, "Tolerance %-12s %.4f", head->ledger.item[i].stage,
                   rounded_up(head->ledger.item[i].spent));
    if (!isnan(head->chord))
        nc_comment(&p->w, "Tolerance %-12s %.4f", "chord", rounded_up(head->chord));
    nc_comment(&p->w, "Tolerance %-12s %.4f", "ncpost",
               rounded_up(total->spent.point * p->plan->ability.unit));
    if (p->plan->ability.smoothing > 0)
        nc_comment(&p->w, "Tolerance %-12s %.4f", "smoothing",
                   rounded_up(p->plan->ability.smoothing));
    nc_comment(&p->w, "Tolerance %-12s %.4f mm, axis %.4f deg", "sum",
               rounded_up(nc_ledger_sum(p->path, p->plan)), rounded_up(DEGREES(total->spent.axis)));
}

void nc_head(struct nc_program *p)
{
    const struct nc_total *total = &p->plan->total;
    const char *partno = p->path->head.partno;
    if (partno && *partno)
        nc_comment(&p->w, "%.70s", partno);
    nc_comment(&p->w, "cloudmill ncpost for %s, %.50s", control_row(p->control)->title,
               p->machine->name);
    if (p->parts)
        nc_comment(&p->w, "Part %zu of %zu; figures below are those of the whole", p->part,
                   p->parts);
    if (p->plan->ability.unit > 1)
        nc_comment(&p->w, "Inches; all figures in these lines are mm");
    if (p->plane)
        nc_comment(&p->w, "X Y Z in the tilted plane%s", p->planes.n > 1 ? "s" : "");
    for (size_t i = 0; p->plane && i < p->planes.n && i < PLANES_SHOWN; i++)
        nc_comment(&p->w, "Z along %.6f %.6f %.6f", p->planes.item[i].axis.x,
                   p->planes.item[i].axis.y, p->planes.item[i].axis.z);
    head_tool(p);
    head_ledger(p);
    double unit = p->plan->ability.unit;
    nc_comment(&p->w, "Cut %.1f mm, rapid %.1f mm, %.1f min", total->cut * unit,
               total->rapid * unit, total->minutes);
    nc_comment(&p->w, "Passes %zu, lines %zu, arcs %zu, splines %zu, rapids %zu", total->passes,
               total->lines, total->arcs, total->splines, total->rapids);
    if (total->holes)
        nc_comment(&p->w, "Holes in drilling cycles %zu", total->holes);
}
