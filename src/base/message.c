/* message - what a tool tells people on standard error (cli.h), and the ends of the process. */
#include "message.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>
#include <unistd.h>

#include "base/cli.h"
#include "base/out.h"

static struct {
    const char *tool;
    bool quiet, verbose, progress_shown;
} state = {.tool = "cloudmill"};

void message_begin(const char *tool)
{
    state.tool = tool;
}

void message_level(bool quiet, bool verbose)
{
    state.quiet = quiet;
    state.verbose = verbose && !quiet;
}

/* One line; control characters, which a hostile file may have brought in, become `?`. */
static void print(const char *format, va_list args)
{
    char line[512];
    int n = snprintf(line, sizeof line, "%.40s: ", state.tool);
    vsnprintf(line + n, 395 - (size_t)n, format, args);
    for (char *p = line; *p; p++)
        if ((unsigned char)*p < ' ' || *p == 127)
            *p = '?';
    if (state.progress_shown)
        fputs("\r\033[K", stderr);
    state.progress_shown = false;
    fprintf(stderr, "%s\n", line);
}

void say(const char *format, ...)
{
    if (state.quiet)
        return;
    va_list args;
    va_start(args, format);
    print(format, args);
    va_end(args);
}

void note(const char *format, ...)
{
    if (!state.verbose)
        return;
    va_list args;
    va_start(args, format);
    print(format, args);
    va_end(args);
}

void die(const char *format, ...)
{
    va_list args;
    va_start(args, format);
    out_abandon();
    print(format, args);
    va_end(args);
    exit(EXIT_FAILED);
}

void die_error(const struct error *error)
{
    die("%s", error->text);
}

void die_usage(const char *format, ...)
{
    va_list args;
    va_start(args, format);
    out_abandon();
    print(format, args);
    va_end(args);
    if (!state.quiet)
        fprintf(stderr, "try `%s --help`\n", state.tool);
    exit(EXIT_USAGE);
}

void die_unmet(const char *format, ...)
{
    va_list args;
    va_start(args, format);
    out_abandon();
    print(format, args);
    va_end(args);
    exit(EXIT_UNMET);
}

void progress(const char *what, size_t done, size_t of)
{
    static time_t last;
    if (state.quiet || !isatty(2))
        return;
    time_t now = time(NULL);
    if (done < of && now == last) /* at most once a second */
        return;
    last = now;
    if (done < of)
        fprintf(stderr, "\r%s: %s %d%% (%zu of %zu)\033[K", state.tool, what,
                (int)(100.0 * (double)done / (double)of), done, of);
    else
        fputs("\r\033[K", stderr);
    fflush(stderr);
    state.progress_shown = done < of;
}
