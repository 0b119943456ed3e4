/*
 * effort - how much is looked at before a tool contents itself with less.
 *
 * Some searches take too long on a large scan.  Each has its bound in the table of effort.c, and
 * `--effort X` multiplies all of them.  Below its bound a search looks at everything; where it is
 * above, the tool says so, and which X looks at everything.
 */
#ifndef CLOUDMILL_EFFORT_H
#define CLOUDMILL_EFFORT_H

#include <stdbool.h>
#include <stddef.h>

enum effort_bound {
    EFFORT_CREASES,      /* edges of a mesh that may cross a crease */
    EFFORT_WALLS,        /* edges of a mesh on which a short chain of them is a wall */
    EFFORT_CRESTS,       /* edges that may cut off ribs and grooves, ... */
    EFFORT_CRESTS_LARGE, /* ... of a scan of more points than ... */
    EFFORT_CREST_POINTS, /* ... these */
    EFFORT_CREST_EDGES, /* edges of a mesh of which all may cut them off, not only where it bends */
    EFFORT_ALONG,       /* places about which surfaces along ribs and grooves are tried */
    EFFORT_SURFACE,     /* points of which all are moved onto the surface, for -e */
    EFFORT_COMPARISON,  /* points by which one of two meshes is chosen */
    EFFORT_NEIGHBOURS,  /* points that go into the surfaces about all vertices */
    EFFORT_GUARD_NOISE, /* points of a scan that guards, whose noise is taken out unasked */
    EFFORT_GUARD_BETWEEN, /* ... and between which points are put */
    EFFORT_GUARD_NEAR     /* ... and that go into the surfaces about all of them */
};

/* How many `effort` (--effort; not above 0: 1) looks at. */
size_t effort_most(enum effort_bound bound, double effort);

/* Does it look at all n? */
bool effort_covers(enum effort_bound bound, double effort, size_t n);

/* The least effort that looks at all n: a whole number, or below 1 one of three digits. */
double effort_for(enum effort_bound bound, size_t n);

/* Says, where the bound binds, what is done without of n, and the effort that it takes. */
void effort_say(enum effort_bound bound, double effort, size_t n);

/* The row of a tool's table of options (cli.h). */
#define EFFORT_OPTION(value)                                                         \
    {                                                                                \
        0, "effort", "X",                                                            \
            "look X times as far as usual before something is left out of a large\n" \
            "scan (default: 1; messages say which X leaves nothing out)",            \
            CLI_NUMBER, value, CLI_POSITIVE, 1e9, 0, NULL                            \
    }

#endif
