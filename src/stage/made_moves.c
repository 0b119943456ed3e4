/* made_moves - see made_moves.h. */
#include "stage/made_moves.h"

#include <stdlib.h>

#include "base/cli.h"
#include "cloud/believed.h"
#include "guard_read.h"

/* Noises that a point may stand out by: the points are as they were scanned. */
static const double SIGMAS = 3;

static const char UNCHECKED[] = "the moves added for rotary axes are not checked";

struct gouge_refit_options made_moves_tool(const struct path *path)
{
    return (struct gouge_refit_options){.radius = path_ball(path),
                                        .centre = path->head.track == TRACK_CENTRE,
                                        .holder = path_holder(path)};
}

/* The points that are believed; what they may be off their surface by. */
static struct gouge_check *believed_guard(struct vec3s *point, double noise, int threads,
                                          double *sigma, struct error *error)
{
    const struct believed_options options = {noise, threads};
    unsigned char *out = mem_alloc(point->n + 1, 1);
    struct vec3s kept = {0};
    struct believed believed;
    struct gouge_check *guard = NULL;

    believed_unround(point->item, point->n, noise, threads);
    if (believed_find(point->item, point->n, &options, out, &believed, error) == 0) {
        believed_keep_beneath(out, point->n);
        for (size_t i = 0; i < point->n; i++)
            if (!out[i])
                *array_push(&kept) = point->item[i];
        *sigma = believed.sigma;
        guard = gouge_new(kept, threads);
    }
    free(out);
    return guard;
}

/* The deepest place of all moves, and how many are too deep. */
static size_t sweep(const struct made_moves *moves, const struct gouge_refit_options *tool,
                    struct gouge *worst, unsigned *line)
{
    struct gouge_track track = {0};
    struct gouges gouges = {0};
    size_t n = 0;

    for (size_t i = 0; i < moves->n; i++) {
        const struct motion motion = motion_line(moves->item[i].from, moves->item[i].to);
        gouges.n = 0;
        gouge_refit_motion(tool, &motion, &track, &gouges);
        struct gouge deepest = gouge_refit_beyond(tool, &gouges);
        n += deepest.depth > 0;
        if (deepest.depth > worst->depth) {
            *worst = deepest;
            *line = moves->item[i].line;
        }
    }
    array_free(&gouges);
    gouge_track_free(&track);
    return n;
}

/* What is known of the part. */
struct made_guard {
    struct gouge_check *check; /* NULL: nothing is */
    double sigma;              /* noise of its points, mm */
    const char *name;          /* what it is, for messages */
};

/* By the scan that the path names.  A scan that is gone is said. */
static int guard_by_scan(const struct path_head *head, double radius, int threads,
                         struct made_guard *guard, struct error *error)
{
    const struct guard_choice named = {.none = false};
    struct guard_scan scan;

    if (guard_scan_read(&named, &head->scan, radius, "the path", UNCHECKED, &scan, NULL, error) !=
        0)
        return -1;
    if (scan.point.n > 0)
        guard->check = believed_guard(&scan.point, head->noise_given ? head->noise : -1, threads,
                                      &guard->sigma, error);
    guard->name = "scan";
    guard_scan_free(&scan);
    return 0;
}

/* By the mesh that it names.  One that is not there is unmet: the path was made without a scan, and
 * nobody else looks. */
static int guard_by_mesh(const struct path_head *head, double radius, int threads,
                         struct made_guard *guard, struct unmets *unmet, struct error *error)
{
    struct vec3s points = {0};

    if (guard_mesh_read(&head->mesh.item[0], radius, &points, error) == 0)
        guard->check = gouge_new(points, threads);
    else if (error->system)
        return -1;
    else
        unmet_say(unmet, "the mesh that the path names is not looked at: %s; %s", error->text,
                  UNCHECKED);
    guard->name = "mesh";
    return 0;
}

int made_moves_check(const struct made_moves *moves, const struct path *path,
                     struct gouge_refit_options tool, double deep, int threads,
                     struct unmets *unmet, struct error *error)
{
    const struct path_head *head = &path->head;
    struct made_guard guard = {NULL};
    struct gouge worst = {.depth = 0};
    unsigned line = 0;
    int result = 0;

    if (moves->n == 0 || !(tool.radius > 0))
        return 0;
    if (head->scan.n > 0)
        result = guard_by_scan(head, tool.radius, threads, &guard, error);
    else if (head->mesh.n > 0)
        result = guard_by_mesh(head, tool.radius, threads, &guard, unmet, error);
    if (result != 0 || !guard.check)
        return result;
    tool.guard = guard.check;
    tool.tolerance = deep + SIGMAS * guard.sigma;
    size_t n = sweep(moves, &tool, &worst, &line);
    gouge_free(guard.check);
    if (n > 0)
        unmet_say(
            unmet,
            "so that a rotary axis can turn, the %s goes %.3f mm deep into the %s after line "
            "%u of the path, with the ball's centre at %.3f %.3f %.3f (%zu of %zu such moves)",
            tool_part_name(worst.part), worst.depth, guard.name, line, worst.ball.x, worst.ball.y,
            worst.ball.z, n, moves->n);
    return 0;
}
