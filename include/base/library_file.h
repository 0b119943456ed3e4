/*
 * library_file - files that are installed or built with the program, by their names: machines,
 * tools.
 */
#ifndef CLOUDMILL_LIBRARY_FILE_H
#define CLOUDMILL_LIBRARY_FILE_H

#include "base/error.h"

enum { LIBRARY_FILE = 1024 };

struct library {
    const char *what;     /* for messages: "machine" */
    const char *folder;   /* among the installed files: "machines" */
    const char *variable; /* of the environment: "CLOUDMILL_MACHINES" */
};

/*
 * Where the file called `name` is.  With a slash or an ending that file itself, seen from the
 * folder of `beside`, the file that names it (NULL: none); else NAME.txt beside that, in the
 * current folder, in the variable's, then among those installed, or built, with the running
 * program.
 */
int library_file_find(const struct library *library, const char *name, const char *beside,
                      char file[LIBRARY_FILE], struct error *error);

#endif
