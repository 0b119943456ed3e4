/*
 * ncread_watch - what must not change while a program cuts: the work offset, the tool, its
 * offsets, the coolant, how the spindle turns.  What does is remarked in the motion, by its block,
 * once a cut follows.  The motion is told with what the first cut is made: spindle, tool, coolant.
 */
#ifndef CLOUDMILL_NCREAD_WATCH_H
#define CLOUDMILL_NCREAD_WATCH_H

#include "simulate/nc_motion.h"

struct ncread;

enum { NCREAD_WATCHED = 8 };

struct ncread_watch {
    bool skips;                   /* a block that may be skipped was seen */
    bool cuts;                    /* a cut was seen */
    int turns;                    /* the spindle, as in nc_motion */
    char work[60];                /* the work offset before it, as its words say it */
    bool known[NCREAD_WATCHED];   /* a word stood before it, */
    double value[NCREAD_WATCHED]; /* this */
    bool changed[NCREAD_WATCHED]; /* another one since, not told yet, in ... */
    double now[NCREAD_WATCHED];
    size_t line[NCREAD_WATCHED];
    long block[NCREAD_WATCHED];
};

/* The words of the block just read, for controls with G code; for Klartext its words as text. */
void ncread_watch_words(struct ncread *c);
void ncread_watch_text(struct ncread *c, int n, const char *const word[]);

/* The spindle's speed, as a word says it. */
void ncread_watch_speed(struct ncread *c, double speed);

/* It was said, and nothing turns so. */
bool ncread_watch_still(const struct ncread *c);

/* A tool was called before the first cut; an edge of it, D, which. */
bool ncread_watch_tool(const struct ncread *c);
bool ncread_watch_edge(const struct ncread *c, double *edge);

/* Remarks it of a place in the motion. */
void ncread_watch_remark(struct ncread *c, size_t line, long block, const char *text);

/* The same of what a path may have asked for (enum nc_asked), and others than ncpost have reasons
 * for that nobody knows. */
void ncread_watch_unasked(struct ncread *c, size_t line, long block, const char *text,
                          unsigned unless);

/* The line of a block: one that begins with `/` is run, and the first of them is told. */
void ncread_watch_skip(struct ncread *c, const char *line);

/* A cut begins or goes on in this block. */
void ncread_watch_cut(struct ncread *c);

#endif
