/* path_check - see path_check.h. */
#include "stage/path_check.h"

#include <stdlib.h>

#include "base/cli.h"
#include "base/parallel.h"
#include "machine/rotary_cost.h"

/* A motion of the path, and what is too deep on it. */
struct checked_motion {
    struct motion motion;
    enum path_motion kind;
    size_t pass;
    struct gouge deepest;
};

struct checked_motions {
    size_t n, cap;
    struct checked_motion *item;
};

struct sweep {
    const struct path_check *check;
    struct checked_motions *motions;
};

static void sweep_motions(void *context, size_t from, size_t to)
{
    const struct sweep *s = context;
    struct gouges gouges = {0};
    struct gouge_track track = {0};

    for (size_t i = from; i < to; i++) {
        struct checked_motion *m = &s->motions->item[i];
        const struct gouge_refit_options *tool = &s->check->tool;
        gouges.n = 0;
        gouge_refit_motion(tool, &m->motion, &track, &gouges);
        m->deepest = gouge_refit_beyond(tool, &gouges);
    }
    array_free(&gouges);
    gouge_track_free(&track);
}

static void keep_worst(struct path_check *check, const struct checked_motions *motions)
{
    for (size_t i = 0; i < motions->n; i++) {
        const struct checked_motion *m = &motions->item[i];
        struct path_check_deep *deep = &check->deep[m->kind];
        deep->n += m->deepest.depth > 0;
        if (m->deepest.depth > deep->deepest.depth) {
            deep->deepest = m->deepest;
            deep->pass = m->pass;
        }
    }
}

static void look_at_feed(struct path_check *check)
{
    if (!(check->feed > 0) || check->feed >= PATH_CHECK_SLOWEST)
        return;
    if (check->slow++ == 0 || check->feed < check->slowest) {
        check->slowest = check->feed;
        check->slow_pass = check->pass;
    }
}

/* Far below the part nobody knows what is there. */
static void look_below(struct path_check *check, struct pose to)
{
    double z = to.p.z + (check->tool.centre ? 0 : check->tool.radius * to.a.z);

    if (!check->floored || z >= check->floor || (check->low++ > 0 && z >= check->lowest))
        return;
    check->lowest = z;
    check->low_pass = check->pass;
}

/* At its end, and on the way there at feed: a rapid is ncpost's to turn as it may. */
static void look_at_axis(struct path_check *check, const struct path_item *item)
{
    struct pose to = item->to;
    bool on_way = check->begun && item->kind == PATH_POINT && !path_is_rapid(item);

    if ((rotary_allows(&check->chain, to.a) &&
         !(on_way && !rotary_reaches_between(&check->chain, check->at.a, to.a))) ||
        check->out++ > 0)
        return;
    check->out_at = to;
    check->out_pass = check->pass;
}

/* A cut is what leads from a contact to a contact; in a path without any, all at feed. */
static enum path_motion kind_of(const struct path_check *check, const struct path_item *item)
{
    if (path_is_rapid(item))
        return MOTION_RAPID;
    return !check->contacts || (item->touches && check->touched) ? MOTION_CUT : MOTION_LINK;
}

static void follow_item(struct path_check *check, const struct path *path, size_t i,
                        struct checked_motions *motions)
{
    const struct path_item *item = &path->item.item[i];
    bool clear = check->clear && check->clear[i];

    if (item->kind == PATH_PASS)
        check->pass = item->index;
    if (item->kind == PATH_FEED)
        check->feed = item->feed;
    if (item->kind == PATH_TOOL || item->kind == PATH_HOLE)
        check->begun = false; /* another tool, or a cycle: not this one's way */
    if (item->kind != PATH_POINT && item->kind != PATH_ARC && item->kind != PATH_SPLINE)
        return;
    if (!path_is_rapid(item))
        look_at_feed(check);
    look_at_axis(check, item);
    look_below(check, item->to);
    enum path_motion kind = kind_of(check, item);
    if (check->begun && check->tool.guard && !clear && !(kind == MOTION_CUT && check->coarse))
        *array_push(motions) = (struct checked_motion){
            .motion = path_item_motion(path, item, check->at), .kind = kind, .pass = check->pass};
    check->at = item->to;
    check->begun = true;
    check->touched = item->touches;
}

void path_check_items(struct path_check *check, const struct path *path, size_t from, size_t to)
{
    struct checked_motions motions = {0};
    struct sweep sweep = {check, &motions};

    check->contacts = check->contacts || path->contact.n > 0;
    for (size_t i = from; i < to; i++)
        follow_item(check, path, i, &motions);
    parallel_for(check->threads, motions.n, sweep_motions, &sweep);
    keep_worst(check, &motions);
    array_free(&motions);
}

void path_check_follow(struct path_check *check, const struct path *path, size_t from, size_t to)
{
    struct path_check ahead = *check;

    ahead.tool.guard = NULL;
    path_check_items(&ahead, path, from, to);
    check->at = ahead.at;
    check->begun = ahead.begun;
    check->touched = ahead.touched;
    check->contacts = ahead.contacts;
    check->pass = ahead.pass;
    check->feed = ahead.feed;
}

int path_check_conclude(const struct path_check *check, struct unmets *unmet)
{
    static const char *const name[] = {"cutting motions", "links at feed", "rapids"};
    bool kept = check->slow == 0;

    for (int k = 0; k < 3; k++) {
        const struct path_check_deep *d = &check->deep[k];
        struct vec3 at = d->deepest.ball;
        if (d->n == 0)
            continue;
        kept = false;
        unmet_say(unmet,
                  "in %zu %s the tool goes deeper than %g mm into the part, worst in pass %zu the "
                  "%s by %.4f mm with the ball's centre at %.3f %.3f %.3f",
                  d->n, name[k], check->tool.tolerance, d->pass, tool_part_name(d->deepest.part),
                  d->deepest.depth, at.x, at.y, at.z);
    }
    if (check->low > 0)
        unmet_say(unmet,
                  "the ball goes far below the part at %zu places, in pass %zu its centre to z "
                  "%.3f",
                  check->low, check->low_pass, check->lowest);
    if (check->slow > 0)
        unmet_say(unmet, "%zu motions have a feed below %g mm/min, the slowest in pass %zu: %g",
                  check->slow, PATH_CHECK_SLOWEST, check->slow_pass, check->slowest);
    if (check->out > 0)
        unmet_say(
            unmet,
            "at %zu places of the path the axis is out of the travel of the machine (-m), first "
            "in pass %zu: %.6f %.6f %.6f at %.3f %.3f %.3f",
            check->out, check->out_pass, check->out_at.a.x, check->out_at.a.y, check->out_at.a.z,
            check->out_at.p.x, check->out_at.p.y, check->out_at.p.z);
    return kept && check->low == 0 && check->out == 0 ? EXIT_DONE : EXIT_UNMET;
}
