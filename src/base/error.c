/* error - see error.h. */
#include "base/error.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

int error_set(struct error *error, const char *format, ...)
{
    va_list args;
    va_start(args, format);
    vsnprintf(error->text, sizeof error->text, format, args);
    va_end(args);
    error->file = error->system = false;
    return -1;
}

int error_at(struct error *error, const char *name, size_t line, const char *format, ...)
{
    int n = line ? snprintf(error->text, sizeof error->text, "%.200s:%zu: ", name, line)
                 : snprintf(error->text, sizeof error->text, "%.200s: ", name);
    va_list args;
    va_start(args, format);
    vsnprintf(error->text + n, sizeof error->text - (size_t)n, format, args);
    va_end(args);
    error->file = true;
    error->system = false;
    return -1;
}

void error_add(struct error *error, const char *format, ...)
{
    size_t n = strlen(error->text);
    va_list args;
    va_start(args, format);
    vsnprintf(error->text + n, sizeof error->text - n, format, args);
    va_end(args);
}
