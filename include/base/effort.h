/*
 * effort - how much is looked at before a tool contents itself with less.
 *
 * Some searches take too long on a large scan.  Each has its bound in the table of effort.c, and
 * `--effort N` multiplies all of them.  Below its bound a search looks at everything; where it is
 * above, the tool says so, and which N looks at everything.
 */
#ifndef CLOUDMILL_EFFORT_H
#define CLOUDMILL_EFFORT_H

#include <stdbool.h>
#include <stddef.h>

enum effort_bound {
    EFFORT_CREASES,       /* edges of a mesh that may cross a crease */
    EFFORT_WALLS,         /* edges of a mesh in which a short chain is a wall */
    EFFORT_RIBS,          /* vertices, or points, about which surfaces along ribs are tried */
    EFFORT_SURFACE,       /* points of which all are moved onto the surface, for -e */
    EFFORT_COMPARISON,    /* points by which one of two meshes is chosen */
    EFFORT_NEIGHBOURS,    /* points that go into the surfaces about all vertices */
    EFFORT_GUARD_NOISE,   /* points of a scan that guards, whose noise is taken out unasked */
    EFFORT_GUARD_BETWEEN, /* ... and between which points are put */
    EFFORT_GUARD_NEAR,    /* ... and that go into the surfaces about all of them */
};

/* How many `effort` (--effort; 0: 1) looks at. */
size_t effort_most(enum effort_bound bound, int effort);

/* Does it look at all n? */
bool effort_covers(enum effort_bound bound, int effort, size_t n);

/* The least effort that looks at all n. */
int effort_for(enum effort_bound bound, size_t n);

/* Says, where the bound binds, what is done without of n, and the effort that it takes. */
void effort_say(enum effort_bound bound, int effort, size_t n);

/* The row of a tool's table of options (cli.h). */
#define EFFORT_OPTION(value)                                                         \
    {                                                                                \
        0, "effort", "N",                                                            \
            "look N times as far as usual before something is left out of a large\n" \
            "scan (default: 1; messages say which N leaves nothing out)",            \
            CLI_COUNT, value, 1, 1000000, 0, NULL                                    \
    }

#endif
