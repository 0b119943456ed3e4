/*
 * unmet - what was asked for and is not kept, stage by stage, so that no pipe loses it: the tool
 * that finds it says it, writes it into its stream and ends with EXIT_UNMET; each later stage
 * carries it, and the fitters, ncpost and ncverify end with EXIT_UNMET too.
 */
#ifndef CLOUDMILL_UNMET_H
#define CLOUDMILL_UNMET_H

#include <stddef.h>

struct unmet {
    char *stage; /* the tool that could not keep it */
    char *text;  /* one line: what, where, how much */
};

struct unmets {
    size_t n, cap;
    struct unmet *item;
};

/* Says the line with warn(), under -q, too, for it is why the tool ends with EXIT_UNMET, and keeps
 * it under the name of this tool; NULL: it is accepted, and only said with say(). */
void unmet_say(struct unmets *unmets, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

/* The same, with warn() where it is accepted, too. */
void unmet_warn(struct unmets *unmets, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

/* The same, with say(): what a later stage may make up for, so that this one succeeds. */
void unmet_later(struct unmets *unmets, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

/* Adds what another stage could not keep; bytes below a blank become `?`. */
void unmets_add(struct unmets *unmets, const char *stage, const char *text);

/* Adds all of `from`. */
void unmets_add_all(struct unmets *unmets, const struct unmets *from);

/* EXIT_UNMET when there are any, else EXIT_DONE. */
int unmets_status(const struct unmets *unmets);

void unmets_free(struct unmets *unmets);

#endif
