/* pathguard - see pathguard.h. */
#include "pathguard.h"

#include <stdlib.h>

#include "path_run.h"
#include "scan.h"

/* Where the ball is at the points of all runs. */
static struct vec3s balls_of(const struct path *path)
{
    struct vec3s ball = {0};

    for (size_t from = 0, to; path_next_run(path, &from, &to); from = to) {
        struct run run = {0};
        path_run_take(path, from, to, &run);
        for (size_t i = 0; i < run.n; i++)
            *array_push(&ball) = run.item[i].ball;
        array_free(&run);
    }
    return ball;
}

int pathguard_read(struct pathguard *guard, const struct path *path, double tolerance, int threads,
                   struct error *error)
{
    struct scan_rule rule = {path_ball(path), tolerance, guard->noise, threads, {0}, {0}};

    if (guard->files.n == 0)
        return 0;
    if (!(rule.radius > 0) || path->head.track == TRACK_CONTACT)
        return error_at(error, path->name, 0,
                        "found no path of a ball cutter, expected one to guard by a scan");
    struct vec3s ball = balls_of(path);
    guard->rule = (struct recheck_rule){.radius = rule.radius,
                                        .tolerance = tolerance,
                                        .centre = path->head.track == TRACK_CENTRE};
    guard->rule.guard =
        scan_guard_points(&guard->files, &ball, 3 * rule.radius, &rule, error);
    array_free(&ball);
    array_free(&rule.certain);
    array_free(&rule.doubtful);
    return guard->rule.guard ? 0 : -1;
}

/* The last pass that begins before the item. */
static size_t pass_of(const struct path *path, size_t item)
{
    for (size_t i = item; i-- > 0;)
        if (path->item.item[i].kind == PATH_PASS)
            return path->item.item[i].index;
    return 0;
}

void pathguard_add(struct pathguard *guard, const struct path *path, size_t item,
                   const struct recheck_result *result)
{
    guard->lift = fmax(guard->lift, result->lift);
    guard->left += result->deepest.depth > 0;
    if (result->deepest.depth > guard->deepest.depth) {
        guard->deepest = result->deepest;
        guard->pass = pass_of(path, item);
    }
}

int pathguard_conclude(const struct pathguard *guard)
{
    struct vec3 at = guard->deepest.ball;

    if (guard->lift > 0)
        note("points lifted by at most %.4f mm where motions went too deep between them",
             guard->lift);
    if (guard->left == 0)
        return EXIT_DONE;
    say("in %zu runs the ball goes deeper than %g mm into the scan, in pass %zu %.4f mm with its "
        "centre at %.3f %.3f %.3f",
        guard->left, guard->rule.tolerance, guard->pass, guard->deepest.depth, at.x, at.y, at.z);
    return EXIT_UNMET;
}

void pathguard_free(struct pathguard *guard)
{
    guard_free((struct guard *)guard->rule.guard);
}
