/* toolpath_report - what the path leaves uncut, and what is told of it in the end. */
#include <stdlib.h>

#include "base/cli.h"
#include "base/parallel.h"
#include "math/kdtree.h"
#include "toolpath_parts.h"

struct uncut_check {
    const struct toolpath *t;
    struct kdtree *ball; /* where its centre is at the points of the path */
    bool *uncut;         /* at each place: more than may be */
};

/* No ball comes nearer to the place than this above it. */
static bool is_uncut(const struct uncut_check *check, const struct toolpath_uncut *s, double height)
{
    struct vec3 at = s->place.contact;

    return s->place.height > height && !kdtree_any_beside(check->ball, at, at, s->offset + height);
}

static void check_places(void *context, size_t from, size_t to)
{
    struct uncut_check *check = context;

    for (size_t i = from; i < to; i++)
        check->uncut[i] = is_uncut(check, &check->t->uncut.item[i], check->t->lift.uncut);
}

/* Counts what stays uncut, and finds the highest. */
static void find_highest_uncut(struct toolpath *t, const struct uncut_check *check)
{
    for (size_t i = 0; i < t->uncut.n; i++) {
        const struct toolpath_uncut *s = &t->uncut.item[i];
        struct vec3 at = s->place.contact;
        size_t nearest;
        t->uncut_places += check->uncut[i];
        if (!check->uncut[i] || !is_uncut(check, s, t->uncut_height))
            continue;
        double far = s->offset + s->place.height;
        t->uncut_height = kdtree_nearest_segment(check->ball, at, at, far, &nearest) - s->offset;
        t->uncut_at = at;
        t->uncut_pass = s->pass;
    }
}

void toolpath_find_uncut(struct toolpath *t)
{
    struct uncut_check check = {.t = t};

    if (t->uncut.n == 0)
        return;
    check.ball = kdtree_new_by(t->ball.item, t->ball.n, t->threads);
    check.uncut = mem_alloc(t->uncut.n, sizeof *check.uncut);
    parallel_for(t->threads, t->uncut.n, check_places, &check);
    find_highest_uncut(t, &check);
    free(check.uncut);
    kdtree_free(check.ball);
    array_free(&t->uncut);
}

/* Flute and shank were kept clear of the part themselves, whatever its normals are. */
static bool is_shank_checked(const struct toolpath *t)
{
    return t->lift.guard && t->rule.holder.n > 0;
}

/* What does not hold, and where. */
static void say_unmet(const struct toolpath *t)
{
    const struct gouge_lift_report *r = &t->report;
    struct unmets *unmet = &t->path->head.unmet;
    struct unmets *uncut = t->rule.avoid ? NULL : unmet, *out = t->rule.skip ? NULL : unmet;
    struct vec3 at = r->unreachable_at;

    if (r->unreachable > 0)
        unmet_say(
            uncut,
            "the ball cannot reach %zu points of the path with a lift of at most %g mm and skips "
            "them, worst in pass %zu by %.3f mm at %.3f %.3f %.3f",
            r->unreachable, t->lift.limit, t->unreachable_pass, r->unreachable_by, at.x, at.y,
            at.z);
    at = t->uncut_at;
    if (t->uncut_places > 0)
        unmet_say(
            uncut,
            "the ball does not fit at %zu points of the path and leaves material there, worst in "
            "pass %zu, %.3f mm at %.3f %.3f %.3f",
            t->uncut_places, t->uncut_pass, t->uncut_height, at.x, at.y, at.z);
    if ((r->unreachable > 0 || t->uncut_places > 0) && !t->rule.avoid)
        say("a smaller ball must remove it; --avoid accepts it");
    at = t->blocked_at;
    if (t->blocked > 0)
        unmet_say(
            out,
            "no way between the clearance plane and %zu run%s is clear for the whole tool: left "
            "out, %.1f mm2, the first in pass %zu at %.3f %.3f %.3f",
            t->blocked, t->blocked == 1 ? "" : "s", t->blocked_area, t->blocked_pass, at.x, at.y,
            at.z);
    at = t->skipped_at;
    if (t->skipped > 0)
        unmet_say(
            out,
            "no direction of the axis keeps flute, shank and holder clear at %zu points, about "
            "%.1f mm2: left out, the first in pass %zu at %.3f %.3f %.3f",
            t->skipped, t->skipped_area, t->skipped_pass, at.x, at.y, at.z);
    if (t->shank > 0)
        unmet_say(is_shank_checked(t) ? NULL : unmet,
                  "at %zu points the normal is more than 90 degrees off the axis: %s", t->shank,
                  is_shank_checked(t) ? "flute and shank were kept clear of the scan there"
                                      : "the shank touches there, not the ball");
}

int toolpath_conclude(const struct toolpath *t)
{
    const struct gouge_lift_report *r = &t->report;

    note("%zu points in %zu passes, %zu links with the tool down, %zu over the clearance plane",
         r->points, t->pass, t->low, t->high);
    if (t->slivers > 0)
        note("%zu runs shorter than the radius left out: their neighbours cut all of them",
             t->slivers);
    note("%zu points lifted, at most by %.4f mm at %.3f %.3f %.3f", r->lifted, r->highest,
         r->highest_at.x, r->highest_at.y, r->highest_at.z);
    if (t->rule.holder.n > 0)
        note("axes at most %.2f degrees off their rule", DEGREES(t->leaned));
    if (t->lift.between)
        note("straight lines within %g mm of the lifted path", t->lift.tolerance);
    else
        note("straight lines up to %.4f mm from the smooth path", t->chord);
    say_unmet(t);
    bool left = (r->unreachable > 0 || t->uncut_places > 0) && !t->rule.avoid;
    left = left || ((t->skipped > 0 || t->blocked > 0) && !t->rule.skip);
    left = path_check_conclude(&t->check, &t->path->head.unmet) != EXIT_DONE || left;
    return left || (t->shank > 0 && !is_shank_checked(t)) ? EXIT_UNMET : EXIT_DONE;
}
