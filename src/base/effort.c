/* effort - see effort.h. */
#include "base/effort.h"

#include <math.h>

#include "base/cli.h"

/* How many are covered, what they are, and what happens beyond. */
static const struct {
    double most;
    const char *what, *beyond;
} bounds[] = {
    [EFFORT_CREASES] = {12000, "edges that may cross a crease", "they are not checked"},
    [EFFORT_WALLS] = {200000, "edges of the mesh", "short walls count as roughness"},
    [EFFORT_CRESTS] = {12000, "edges that may cut off a rib", "the last of them are not checked"},
    [EFFORT_CRESTS_LARGE] = {4000, "edges that may cut off a rib",
                             "the last of them are not checked"},
    [EFFORT_CREST_POINTS] = {400000, "points", "fewer edges are checked for ribs"},
    [EFFORT_CREST_FACETS] = {4000, "facets of the mesh", "ribs are detected only where it bends"},
    [EFFORT_ALONG] = {71000, "places on the surface",
                      "no surface is fitted along ribs and grooves"},
    [EFFORT_SURFACE] = {200000, "points with noise", "only those of a grid are moved"},
    [EFFORT_COMPARISON] = {100000, "points", "two meshes are compared by some of them"},
    [EFFORT_NEIGHBOURS] = {4e6, "neighbours of all vertices", "surfaces are fitted to fewer"},
    [EFFORT_GUARD_NOISE] = {400000, "points of the scan", "their noise is not removed"},
    [EFFORT_GUARD_BETWEEN] = {400000, "points of the scan", "none is inserted between them"},
    [EFFORT_GUARD_NEAR] = {16e6, "neighbours of all places", "surfaces are fitted to fewer"},
};

size_t effort_most(enum effort_bound bound, double effort)
{
    return (size_t)(bounds[bound].most * (effort > 0 ? effort : 1));
}

bool effort_covers(enum effort_bound bound, double effort, size_t n)
{
    return n <= effort_most(bound, effort);
}

double effort_for(enum effort_bound bound, size_t n)
{
    double least = (double)(n + 1) / bounds[bound].most; /* one more, for rounding down */

    if (least > 1)
        return ceil((double)n / bounds[bound].most);
    double digits = 100; /* three digits that count: least * digits is from 100 to 1,000 */
    while (least * digits < 100)
        digits *= 10;
    return ceil(least * digits) / digits;
}

void effort_say(enum effort_bound bound, double effort, size_t n)
{
    if (!effort_covers(bound, effort, n))
        say("%zu %s, more than %zu: %s; --effort %g covers all", n, bounds[bound].what,
            effort_most(bound, effort), bounds[bound].beyond, effort_for(bound, n));
}
