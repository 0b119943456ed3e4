/*
 * programs - what the unit tests of the post share: a path for an upright tool as text, planned for
 * a control and the usual machine, and the program's lines.
 */
#ifndef CLOUDMILL_TEST_PROGRAMS_H
#define CLOUDMILL_TEST_PROGRAMS_H

#include <check.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "post/post.h"
#include "scratch.h"

static struct path path;
static struct machine machine;
static struct post *post;
static struct error error;

/* The path and the usual machine are read anew; 0.002 mm and 1 degree for the post, 800 mm/min. */
static inline struct post_options programs_begin(enum control_id control, const char *text)
{
    path = (struct path){.name = ""};
    ck_assert_msg(path_read(scratch_text(text), &path, &error) == 0, "%s", error.text);
    machine = machine_default();
    ck_assert_int_eq(machine_control(&machine, control_row(control)->name, &error), 0);
    ck_assert_int_eq(machine_finish(&machine, &error), 0);
    return (struct post_options){.chord = 0.002, .axis_tolerance = RADIANS(1), .feed = 800};
}

static inline int programs_plan(enum control_id control, const struct post_options *options)
{
    int status;
    post = post_plan(control, &path, &machine, options, &status, &error);
    ck_assert_int_eq(post != NULL, status == 0);
    return status;
}

static inline void programs_end(void)
{
    if (post)
        post_free(post);
    post = NULL;
    path_free(&path);
}

/* A file without its comments; the text lasts until the next call. */
static inline const char *programs_text(const char *file)
{
    static char text[20000];
    char line[400];
    size_t n = 0;
    FILE *f = fopen(file, "r");
    ck_assert_ptr_nonnull(f);
    *text = '\0';
    while (fgets(line, sizeof line, f)) {
        if (*line == '(' || *line == '%' || *line == 'O')
            continue;
        n += (size_t)snprintf(text + n, sizeof text - n, "%s", line);
        ck_assert_uint_lt(n, sizeof text);
    }
    fclose(f);
    return text;
}

#endif
