/*
 * message - how loud a tool is, and under which name; the messages themselves are in cli.h.
 */
#ifndef CLOUDMILL_MESSAGE_H
#define CLOUDMILL_MESSAGE_H

#include <stdbool.h>

/* The name in front of every message. */
void message_begin(const char *tool);

/* quiet: errors only; verbose: summaries too.  Quiet wins. */
void message_level(bool quiet, bool verbose);

#endif
