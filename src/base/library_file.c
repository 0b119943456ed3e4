/* library_file - see library_file.h. */
#include "base/library_file.h"

#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "program_dir.h"

static bool is_file(const char *name)
{
    return name[strcspn(name, "/.")] != '\0';
}

/* From the tools' folder to the sources: build/bin, build/static/bin, build/portable/musl/bin. */
static const char *way_to_sources(const char *tools)
{
    static const char *const ways[] = {"/../../..", "/../../../.."};
    char file[LIBRARY_FILE];
    for (size_t i = 0; i < sizeof ways / sizeof *ways; i++) {
        snprintf(file, sizeof file, "%s%s/VERSION", tools, ways[i]);
        if (access(file, R_OK) == 0)
            return ways[i];
    }
    return "/../..";
}

/* The folders of the tools and of what is installed with them: PREFIX/bin and
 * PREFIX/share/cloudmill, or build/bin and the sources'; wherever they were moved to. */
static void installed_folders(const char *what, char installed[LIBRARY_FILE],
                              char built[LIBRARY_FILE])
{
    enum { LONGEST = 900 };
    char prefix[LONGEST];
    program_dir(prefix, sizeof prefix);
    snprintf(built, LIBRARY_FILE, "%s%s/%s", prefix, way_to_sources(prefix), what);
    char *slash = strrchr(prefix, '/');
    bool up = slash && strcmp(slash, "/.") != 0 && strcmp(slash, "/..") != 0;
    if (up)
        *slash = '\0';
    snprintf(installed, LIBRARY_FILE, "%s%s/share/cloudmill/%s", prefix, up ? "" : "/..", what);
}

int library_file_find(const struct library *library, const char *name, const char *beside,
                      char file[LIBRARY_FILE], struct error *error)
{
    const char *slash = beside ? strrchr(beside, '/') : NULL;
    int folder = slash && *name != '/' ? (int)(slash - beside + 1) : 0;
    const char *own = getenv(library->variable);
    if (is_file(name)) {
        int n = snprintf(file, LIBRARY_FILE, "%.*s%s", folder, folder ? beside : "", name);
        if (n >= LIBRARY_FILE)
            return error_set(error, "%.40s...: file name too long", name);
        return 0;
    }
    char installed[LIBRARY_FILE], built[LIBRARY_FILE];
    installed_folders(library->folder, installed, built);
    const char *const places[] = {".", own && *own ? own : ".", installed, built};
    int n = snprintf(file, LIBRARY_FILE, "%.*s%s.txt", folder, folder ? beside : "", name);
    for (size_t i = 0; i < sizeof places / sizeof *places; i++) {
        if (n < LIBRARY_FILE && access(file, R_OK) == 0)
            return 0;
        n = snprintf(file, LIBRARY_FILE, "%s/%s.txt", places[i], name);
    }
    if (n < LIBRARY_FILE && access(file, R_OK) == 0)
        return 0;
    error_set(error, "%s %.100s: not found in this folder, in $%s or in %s", library->what, name,
              library->variable, installed);
    error->file = true;
    return -1;
}
