/* program_dir - see program_dir.h. */
#include "program_dir.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#ifdef _WIN32
enum { LIST_SEPARATOR = ';' };
#else
enum { LIST_SEPARATOR = ':' };
#endif

static const char *called = ""; /* the command line's first word */

void program_called(const char *word)
{
    called = word ? word : "";
}

/* The path that the system has for the running program; 0 where it tells none. */
static size_t system_path(char *path, size_t size)
{
#ifdef _WIN32
    int n = snprintf(path, size, "%s", _pgmptr);
    for (char *p = path; *p; p++)
        if (*p == '\\')
            *p = '/';
    return n < (int)size ? (size_t)n : 0;
#else
    const char *const links[] = {"/proc/self/exe", "/proc/curproc/file", "/proc/self/path/a.out"};
    for (size_t i = 0; i < sizeof links / sizeof *links; i++) {
        ssize_t n = readlink(links[i], path, size - 1);
        if (n > 0 && *path == '/') {
            path[n] = '\0';
            return (size_t)n;
        }
    }
    return 0;
#endif
}

/* The path that the command line names, found in PATH if it has no slash; 0 if there is none. */
static size_t called_path(char *path, size_t size)
{
    const char *list = getenv("PATH");
    if (strchr(called, '/')) {
        int n = snprintf(path, size, "%s", called);
        return n < (int)size ? (size_t)n : 0;
    }
    while (*called && list && *list) {
        int folder = (int)strcspn(list, (const char[]){LIST_SEPARATOR, '\0'});
        int n = snprintf(path, size, "%.*s/%s", folder, list, called);
        if (n < (int)size && access(path, X_OK) == 0)
            return (size_t)n;
        list += folder + (list[folder] != '\0');
    }
    return 0;
}

void program_dir(char *folder, size_t size)
{
    size_t n = system_path(folder, size);
    if (n == 0)
        n = called_path(folder, size);
    folder[n] = '\0';
    char *slash = strrchr(folder, '/');
    if (slash)
        *slash = '\0';
}
