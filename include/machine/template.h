/*
 * template - the wording of blocks in a machine file, with words in braces for what a program fills
 * in.
 *
 * A template is one block or more with `|` between.  {tool} stands for the tool's number, {offset}
 * for that of its length, {rpm} for the spindle's speed, {tolerance} for ncpost's share of the
 * tolerance in mm, {orientation} for that of the tool axis in degrees, {level} for the tolerance as
 * 1 (0.1 mm, for speed) to 10 (0.001 mm, for accuracy).  Of a tilted plane {a} {b} are the angles
 * about X and the turned Y, {i} {j} {k} Euler's about Z, the turned X and the turned Z, degrees.
 */
#ifndef CLOUDMILL_TEMPLATE_H
#define CLOUDMILL_TEMPLATE_H

#include <stddef.h>

#include "base/error.h"

enum template_word {
    TEMPLATE_TOOL,
    TEMPLATE_OFFSET,
    TEMPLATE_RPM,
    TEMPLATE_TOLERANCE,
    TEMPLATE_ORIENTATION,
    TEMPLATE_LEVEL,
    TEMPLATE_A,
    TEMPLATE_B,
    TEMPLATE_I,
    TEMPLATE_J,
    TEMPLATE_K,
    TEMPLATE_NONE,
    TEMPLATE_PLANE = TEMPLATE_A /* the first that a tilted plane fills in */
};

/* The word that `text` begins with and its length, braces included; TEMPLATE_NONE: none. */
enum template_word template_word(const char *text, size_t *length);

/* -1: a brace that opens none of the words. */
int template_check(const char *text, struct error *error);

#endif
