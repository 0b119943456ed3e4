/*
 * effort - bounds of the work on a large scan.
 *
 * Some searches take too long on a large scan.  Each has its bound in the table of effort.c, and
 * `--effort X` multiplies all bounds.  Within its bound a search is complete; beyond it the tool
 * prints what it leaves out and the X that covers everything.
 */
#ifndef CLOUDMILL_EFFORT_H
#define CLOUDMILL_EFFORT_H

#include <stdbool.h>
#include <stddef.h>

enum effort_bound {
    EFFORT_CREASES,       /* edges of a mesh that may cross a crease */
    EFFORT_WALLS,         /* edges of a mesh on which a short chain is a wall */
    EFFORT_CRESTS,        /* edges that may cut off ribs and grooves */
    EFFORT_CRESTS_LARGE,  /* the same of a scan of more points than */
    EFFORT_CREST_POINTS,  /* this */
    EFFORT_CREST_FACETS,  /* facets whose edges are all checked for that, not only where it bends */
    EFFORT_ALONG,         /* places where surfaces along ribs and grooves are fitted */
    EFFORT_SURFACE,       /* points that are all moved onto the surface, for -e */
    EFFORT_COMPARISON,    /* points by which two meshes are compared */
    EFFORT_NEIGHBOURS,    /* points that the surfaces of all vertices are fitted to, in sum */
    EFFORT_GUARD_NOISE,   /* points of a guarding scan whose noise is removed by default */
    EFFORT_GUARD_BETWEEN, /* ... between which points are inserted */
    EFFORT_GUARD_NEAR     /* ... that the surfaces of all of them are fitted to, in sum */
};

/* The number that `effort` covers (--effort; 0 or less: 1). */
size_t effort_most(enum effort_bound bound, double effort);

/* True if it covers all n. */
bool effort_covers(enum effort_bound bound, double effort, size_t n);

/* The least effort that covers all n: a whole number, or below 1 a number of three digits. */
double effort_for(enum effort_bound bound, size_t n);

/* If n exceeds the bound, prints what is left out and the effort that covers all n. */
void effort_say(enum effort_bound bound, double effort, size_t n);

/* The row of a tool's table of options (cli.h). */
#define EFFORT_OPTION(value)                                                         \
    {                                                                                \
        0, "effort", "X",                                                            \
            "allow X times the usual work before something is left out of a large\n" \
            "scan (default: 1; messages say which X leaves nothing out)",            \
            CLI_NUMBER, value, CLI_POSITIVE, 1e9, 0, NULL                            \
    }

#endif
