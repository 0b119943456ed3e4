/*
 * path_parse - reading a path stream, statement by statement: what path_read.c (motions) and
 * path_parse.c (the head and its comments) share.
 */
#ifndef CLOUDMILL_PATH_PARSE_H
#define CLOUDMILL_PATH_PARSE_H

#include "apt.h"
#include "path.h"
#include "path_spline.h"

/* What the statements read so far leave behind for those that come. */
struct path_parse {
    struct path *path;
    struct reader reader;
    struct apt apt;
    struct error *error;
    double unit; /* millimetres */
    bool rapid;  /* RAPID was said: the next point is one */
    bool moved;  /* `at` is known */
    struct pose at;
    bool touches; /* CONTCT was said for the next point */
    struct contact contact;
    bool in_circle; /* CIRCLE was said: the next statement is its end */
    struct path_arc arc;
    struct spline_parse spline;
    bool ended;
};

/* What to do with a statement: 0, or -1 with the error filled. */
struct path_row {
    const char *word;
    int (*read)(struct path_parse *p);
};

/* The row for a word of the head, or of a `$$->` comment; NULL: none. */
const struct path_row *path_head_row(const char *word);
const struct path_row *path_comment_row(const char *word);

/* The row of a table for a word; NULL: none. */
const struct path_row *path_find_row(const struct path_row *rows, size_t n, const char *word);

/* Carries the statement along as it is. */
int path_keep_text(struct path_parse *p);

/* Arguments from, from + 1, ... as n numbers. */
int path_numbers(struct path_parse *p, size_t from, size_t n, double *value, const char *what);

/* Three numbers in the stream's unit as mm. */
struct vec3 path_length_of(const struct path_parse *p, const double *v);

/* A direction: unit length when it is that but for its printed digits, made so when it is not. */
int path_direction(struct path_parse *p, const double *v, const char *what, struct vec3 *unit);

#endif
