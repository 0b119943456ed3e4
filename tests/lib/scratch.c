/* scratch - see scratch.h. */
#include "scratch.h"

#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <unistd.h>

static char name[64];
static pid_t owner;

/* Check forks a process for each test: only the one that made the file takes it away. */
static void take_away(void)
{
    if (getpid() == owner)
        unlink(name);
}

static void fail(const char *what)
{
    perror(what);
    exit(1);
}

const char *scratch_name(void)
{
    if (name[0] && owner == getpid())
        return name;
    strcpy(name, "/dev/shm/cloudmill.XXXXXX"); /* in memory, where there is that */
    int fd = mkstemp(name);
    if (fd < 0) {
        strcpy(name, "/tmp/cloudmill.XXXXXX");
        fd = mkstemp(name);
    }
    if (fd < 0)
        fail(name);
    close(fd);
    owner = getpid();
    atexit(take_away);
    return name;
}

/* Not emptied first: some file systems flush a file to the disk that was, and a test writes
 * thousands. */
const char *scratch_bytes(const void *bytes, size_t n)
{
    int fd = open(scratch_name(), O_WRONLY);
    if (fd < 0 || write(fd, bytes, n) != (ssize_t)n || ftruncate(fd, (off_t)n) != 0)
        fail(name);
    close(fd);
    return name;
}

const char *scratch_text(const char *text)
{
    return scratch_bytes(text, strlen(text));
}

char *scratch_read(size_t *n)
{
    FILE *f = fopen(scratch_name(), "rb");
    size_t cap = 1 << 20;
    char *text = malloc(cap);
    if (!f || !text)
        fail(name);
    *n = fread(text, 1, cap - 1, f);
    text[*n] = '\0';
    fclose(f);
    return text;
}

static struct rlimit room;

void scratch_no_room(void)
{
    if (getrlimit(RLIMIT_FSIZE, &room) != 0 ||
        setrlimit(RLIMIT_FSIZE, &(struct rlimit){0, room.rlim_max}) != 0)
        abort();
}

void scratch_room(void)
{
    if (setrlimit(RLIMIT_FSIZE, &room) != 0)
        abort();
}
