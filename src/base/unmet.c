/* unmet - see unmet.h. */
#include "base/unmet.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/array.h"
#include "base/cli.h"

enum { TEXT_MAX = 360 }; /* as say() prints a line */

/* One line, whatever a file's name brought into it. */
static char *line_of(const char *text)
{
    char *line = mem_string(text, strlen(text));

    for (char *p = line; *p; p++)
        if ((unsigned char)*p < ' ' || *p == 127)
            *p = '?';
    return line;
}

void unmets_add(struct unmets *unmets, const char *stage, const char *text)
{
    *array_push(unmets) = (struct unmet){line_of(stage), line_of(text)};
}

void unmets_add_all(struct unmets *unmets, const struct unmets *from)
{
    for (size_t i = 0; i < from->n; i++)
        unmets_add(unmets, from->item[i].stage, from->item[i].text);
}

/* By `how`, say or warn, and kept. */
static void tell(struct unmets *unmets, void (*how)(const char *format, ...), const char *format,
                 va_list args)
{
    char text[TEXT_MAX];

    vsnprintf(text, sizeof text, format, args);
    how("%s", text);
    if (unmets)
        unmets_add(unmets, cli_tool(), text);
}

void unmet_say(struct unmets *unmets, const char *format, ...)
{
    va_list args;

    va_start(args, format);
    tell(unmets, unmets ? warn : say, format, args);
    va_end(args);
}

void unmet_warn(struct unmets *unmets, const char *format, ...)
{
    va_list args;

    va_start(args, format);
    tell(unmets, warn, format, args);
    va_end(args);
}

void unmet_later(struct unmets *unmets, const char *format, ...)
{
    va_list args;

    va_start(args, format);
    tell(unmets, say, format, args);
    va_end(args);
}

int unmets_status(const struct unmets *unmets)
{
    return unmets->n > 0 ? EXIT_UNMET : EXIT_DONE;
}

void unmets_free(struct unmets *unmets)
{
    for (size_t i = 0; i < unmets->n; i++) {
        free(unmets->item[i].stage);
        free(unmets->item[i].text);
    }
    array_free(unmets);
}
