/* effort - see effort.h. */
#include "base/effort.h"

#include "base/cli.h"

/* What is looked at, and what becomes of more of it. */
static const struct {
    size_t most;
    const char *what, *beyond;
} bounds[] = {
    [EFFORT_CREASES] = {12000, "edges that may cross a crease", "none is looked at"},
    [EFFORT_WALLS] = {200000, "edges of the mesh", "short walls are taken for roughness"},
    [EFFORT_RIBS] = {71000, "places on the surface", "none is fitted along ribs and grooves"},
    [EFFORT_SURFACE] = {200000, "points with noise", "only those of a grid are moved"},
    [EFFORT_COMPARISON] = {100000, "points", "some of them choose between two meshes"},
    [EFFORT_NEIGHBOURS] = {4000000, "neighbours of all vertices", "surfaces go through fewer"},
    [EFFORT_GUARD_NOISE] = {400000, "points of the scan", "their noise stays in"},
    [EFFORT_GUARD_BETWEEN] = {400000, "points of the scan", "none is put between them"},
    [EFFORT_GUARD_NEAR] = {16000000, "neighbours of all places", "surfaces go through fewer"},
};

size_t effort_most(enum effort_bound bound, int effort)
{
    return bounds[bound].most * (size_t)(effort > 0 ? effort : 1);
}

bool effort_covers(enum effort_bound bound, int effort, size_t n)
{
    return n <= effort_most(bound, effort);
}

int effort_for(enum effort_bound bound, size_t n)
{
    return n > 0 ? (int)((n - 1) / bounds[bound].most + 1) : 1;
}

void effort_say(enum effort_bound bound, int effort, size_t n)
{
    if (!effort_covers(bound, effort, n))
        say("%zu %s, more than %zu: %s; --effort %d takes all", n, bounds[bound].what,
            effort_most(bound, effort), bounds[bound].beyond, effort_for(bound, n));
}
