/* library_file - see library_file.h. */
#include "base/library_file.h"

#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "program_dir.h"

#ifndef CLOUDMILL_DATADIR
#define CLOUDMILL_DATADIR "/usr/local/share/cloudmill"
#endif

static bool is_file(const char *name)
{
    return name[strcspn(name, "/.")] != '\0';
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
    char self[LIBRARY_FILE], beside_installed[LIBRARY_FILE + 32], beside_built[LIBRARY_FILE + 32];
    char installed[LIBRARY_FILE];
    program_dir(self, sizeof self);
    snprintf(beside_installed, sizeof beside_installed, "%s/../share/cloudmill/%s", self,
             library->folder);
    snprintf(beside_built, sizeof beside_built, "%s/../../%s", self, library->folder);
    snprintf(installed, sizeof installed, CLOUDMILL_DATADIR "/%s", library->folder);
    const char *const places[] = {".", own && *own ? own : ".", beside_installed, beside_built,
                                  installed};
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
