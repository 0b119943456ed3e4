/* spool - see spool.h. */
#include "base/spool.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

#include "base/array.h"
#include "system.h"

#ifdef _WIN32

/* There is no file without a name; the system's own is gone once it is closed. */
FILE *spool_open(void)
{
    return tmpfile();
}

#else

/* -1: no file can be made in the folder. */
static int create_in(const char *folder)
{
    static const char name[] = "/cloudmill.XXXXXX";
    size_t n = strlen(folder);
    char *file = mem_alloc(n + sizeof name, 1);

    memcpy(file, folder, n);
    memcpy(file + n, name, sizeof name);
    int fd = mkstemp(file);
    if (fd >= 0)
        unlink(file);
    free(file);
    return fd;
}

FILE *spool_open(void)
{
    const char *folder[] = {getenv("TMPDIR"), "/var/tmp", "/tmp"};
    int fd = -1;

    ignore_file_limit();
    for (size_t i = 0; i < sizeof folder / sizeof *folder && fd < 0; i++)
        if (folder[i] && *folder[i])
            fd = create_in(folder[i]);
    if (fd < 0)
        return NULL;
    FILE *file = fdopen(fd, "w+b");
    int why = errno;
    if (!file)
        close(fd);
    errno = why;
    return file;
}

#endif
