/* verify_made - see verify_made.h. */
#include "verify_made.h"

#include "math/elementary.h"
#include "ncread/ncread_made.h"
#include "verify_finding.h"

static size_t first_cut(const struct nc_motion *motion)
{
    size_t i = 0;
    while (i + 1 < motion->piece.n && motion->piece.item[i].rapid)
        i++;
    return i;
}

/* Tool and spindle, against the path. */
static void judge_tool(struct verdict *v, size_t cut)
{
    const struct nc_motion *path = v->program.path, *motion = v->program.motion;
    const double even = 0.01;
    bool known = path->speed > 0 && motion->turns != 0;
    if (known && path->turns != motion->turns)
        finding_add(v, true, cut, "the path turns the spindle %s, the program the other way",
                    path->turns > 0 ? "clockwise" : "anticlockwise");
    if (known && motion->speed == 0)
        finding_add(v, true, cut, "the path's spindle turns at %g, the program says no speed",
                    path->speed);
    else if (known && fabs(motion->speed - path->speed) > fmax(1, even * path->speed))
        finding_add(v, true, cut, "the path's spindle turns at %g, the program's at %g",
                    path->speed, motion->speed);
    if (path->tool > 0 && motion->tool == 0)
        finding_add(v, v->program.calls, cut, "the path is for tool %d, the program calls none",
                    path->tool);
    if (path->tool > 0 && motion->tool > 0 && path->tool != motion->tool)
        finding_add(v, true, cut, "the path is for tool %d, the program takes tool %d", path->tool,
                    motion->tool);
    if (path->offset > 0 && motion->offset > 0 && path->offset != motion->offset)
        finding_add(v, true, cut, "the path is for the length H%d, the program switches on H%d",
                    path->offset, motion->offset);
}

/* Tool, against the head. */
static void judge_only_tool(struct verdict *v, size_t cut)
{
    int said = v->program.tool, tool = v->program.motion->tool;
    if (said > 0 && tool > 0 && tool != said)
        finding_add(v, true, cut, "the program's head says tool %d, it takes tool %d", said, tool);
    if (said > 0 && tool == 0 && v->program.calls)
        finding_add(v, true, cut, "the program's head says tool %d, it calls none", said);
    if (said > 0 && v->program.motion->offset > 0 && v->program.motion->offset != said)
        finding_add(v, false, cut,
                    "tool %d cuts with the length of another number, %d: nobody knows whether that "
                    "was asked for without the path (-p)",
                    said, v->program.motion->offset);
}

/* Without a path its head alone knows that no coolant was asked for. */
static void judge_coolant(struct verdict *v, size_t cut)
{
    const struct nc_motion *path = v->program.path;
    if (v->program.motion->coolant)
        return;
    if (path && path->coolant)
        finding_add(v, true, cut, "the path has coolant on, the program cuts without");
    else if (!path && v->program.wet)
        finding_add(v, true, cut,
                    "the program cuts without coolant, and its head does not say so "
                    "(COOLANT: NONE)");
}

/* The head alone knows it, too. */
static void judge_sense(struct verdict *v, size_t cut)
{
    if (v->program.clockwise && v->program.motion->turns < 0)
        finding_add(v, true, cut,
                    "the spindle turns anticlockwise, and the program's head does not say so "
                    "(SPINDLE: CCLW)");
}

static void judge_work(struct verdict *v, size_t cut)
{
    const char *made = v->program.work, *work = v->program.motion->work;
    if (!made || ncread_made_same(made, work))
        return;
    if (!*work && *made != 'G') /* of G code the reader says it */
        finding_add(v, true, cut, "cuts without the work offset, %s (--set offset)", made);
    else if (*work)
        finding_add(v, true, cut,
                    "the work offset is %s, and the program was made for %s (--set "
                    "offset)",
                    work, *made ? made : "the active preset");
}

void verify_made(struct verdict *v)
{
    size_t cut = first_cut(v->program.motion);
    if (v->cut.n == 0)
        return;
    if (v->program.path) {
        judge_tool(v, cut);
    } else {
        judge_only_tool(v, cut);
        judge_sense(v, cut);
    }
    judge_coolant(v, cut);
    judge_work(v, cut);
}
