/*
 * tool_options - the tool above its ball as the options of a maker of paths say it: --flute,
 * --holder, --tool-file, --ball-only.
 */
#ifndef CLOUDMILL_TOOL_OPTIONS_H
#define CLOUDMILL_TOOL_OPTIONS_H

#include "base/cli.h"
#include "stage/tool_file.h"

struct tool_options {
    double flute; /* mm, where flute_given; else TOOL_FLUTE radii */
    bool flute_given, ball_only;
    const char *holder; /* text as in holder_text.h; NULL: none */
    struct cli_list files;
    struct tool_file file; /* what they say */
};

/* The rows of a tool's table of options. */
/* clang-format off */
#define TOOL_OPTIONS(options) \
    {0, "flute", "MM", "length of the cylinder of the ball's radius above its centre, kept\n" \
     "clear like the ball (default: four radii; 0: none)", \
     CLI_NUMBER, &(options)->flute, 0, 10000, 0, &(options)->flute_given}, \
    {0, "holder", "SPEC", \
     "shank and holder from the ball's centre up, kept clear\n" \
     "too: cones R0:R1:L or cylinders R:L joined by +", \
     CLI_TEXT, &(options)->holder, 0, 0, 0, NULL}, \
    {0, "tool-file", "NAME", "cutter or holder: NAME.txt in this folder, in $CLOUDMILL_TOOLS or\n" \
     "among the installed ones, or a file; may be given for each of them", \
     CLI_LIST, &(options)->files, 0, 0, 0, NULL}, \
    {0, "ball-only", NULL, "keep nothing clear but the ball", \
     CLI_FLAG, &(options)->ball_only, 0, 0, 0, NULL}
/* clang-format on */

/* Reads the files.  *radius: of the ball, 0: not given, then that of the files. */
int tool_options_files(struct tool_options *options, double *radius, struct error *error);

/* The tool that they say for a ball of this radius; -1: an error of usage. */
int tool_options_read(const struct tool_options *options, double radius, struct tool_body *body,
                      struct error *error);

/* Says, or if the whole tool is looked at notes, what it is in one line. */
void tool_options_say(const struct tool_body *body, double radius);

#endif
