/*
 * cloud_options - options that all readers of scans and models share, and whether a part has a
 * likely size in the unit that was taken and lies where a machine reaches.
 */
#ifndef CLOUDMILL_CLOUD_OPTIONS_H
#define CLOUDMILL_CLOUD_OPTIONS_H

#include "base/cli.h"
#include "math/box.h"

/* Words of -u, and the same by their index, for cloud_unit. */
#define UNIT_WORDS "mm|cm|m|um|inch|in"
extern const char *const unit_name[];

enum outliers { OUTLIERS_DROP, OUTLIERS_KEEP };

/* Rows of a tool's table of options (cli.h): `value` an int for the first, then a const char *, a
 * bool; `words` are the help, `given` a bool * or NULL. */
#define UNIT_OPTION(words, value, given)                                   \
    {                                                                      \
        'u', "units", UNIT_WORDS, words, CLI_CHOICE, value, 0, 0, 0, given \
    }
#define MATRIX_OPTION(value)                                                                   \
    {                                                                                          \
        0, "matrix", "FILE", "place the points by the 4 x 4 matrix in FILE (in mm)", CLI_TEXT, \
            value, 0, 0, 0, NULL                                                               \
    }
#define ORIGIN_OPTION(value)                                                                     \
    {                                                                                            \
        0, "origin", NULL, "move the smallest x and the smallest y to 0", CLI_FLAG, value, 0, 0, \
            0, NULL                                                                              \
    }
#define OUTLIERS_OPTION(words, value, given)                                                 \
    {                                                                                        \
        0, "outliers", "drop|keep",                                                          \
            "drop outliers and points below others, or only count them\n" words, CLI_CHOICE, \
            value, 0, 0, 0, given                                                            \
    }

/* False of a part of a length, mm, that is likely to be in another unit: of less than 1 mm, or of
 * more than 3 m. */
bool size_is_likely(double longest);

/* Says so of such a part.  `name`: its file. */
void say_unlikely_size(const char *name, double longest);

/* Says so if a scan lies farther from the zero of its x and y than machines travel, 3 m, as one in
 * map coordinates does, and names --origin.  `box`: about its points, mm. */
void say_far_away(const char *name, struct box box);

#endif
