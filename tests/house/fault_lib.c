/*
 * fault_lib - a library that is put before libc (LD_PRELOAD) and lets one call of a kind fail.
 *
 * FAULT=KIND:N lets the N-th call of this kind fail, from 1, as the system would:
 *
 *	malloc calloc realloc aligned   no memory (aligned: aligned_alloc)
 *	read, end, bytes                fails with EIO; says that the file has ended, from there on;
 *	                                gives one byte only, which is no failure
 *	write, full, some               fails with EIO; with ENOSPC; writes one byte only, no failure
 *	open close fsync rename thread  fails with EIO (thread: pthread_create, with EAGAIN)
 *	stat seek temp mode             fstat, lseek, mkstemp, fchmod fail with EIO
 *	read-intr, write-intr           comes back with EINTR once, which is no failure
 *	kill, term                      SIGKILL or SIGTERM before the N-th call of open, read, write,
 *	                                close, fsync and rename together; kill-mem, term-mem: before
 *	                                the N-th of malloc, calloc, realloc
 *
 * FAULT_COUNTS=FILE: at the end the numbers of calls of each kind are written to it, as lines
 * `KIND N`.  glibc only: memory comes from its __libc_malloc, so that nothing is looked up.
 */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <pthread.h>
#include <signal.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

void *__libc_malloc(size_t n);
void *__libc_calloc(size_t n, size_t size);
void *__libc_realloc(void *p, size_t n);
void *__libc_memalign(size_t align, size_t n);

enum call {
    MALLOC,
    CALLOC,
    REALLOC,
    ALIGNED,
    READ,
    WRITE,
    OPEN,
    CLOSE,
    FSYNC,
    RENAME,
    THREAD,
    STAT,
    SEEK,
    TEMP,
    MODE,
    CALLS
};

static const char *const call_name[CALLS] = {"malloc", "calloc", "realloc", "aligned", "read",
                                             "write",  "open",   "close",   "fsync",   "rename",
                                             "thread", "stat",   "seek",    "temp",    "mode"};

enum effect { NONE, FAIL, END, ONE_BYTE, NO_SPACE, DIE_KILL, DIE_TERM, INTERRUPTED };

static const struct kind {
    const char *name;
    unsigned calls; /* bit 1 << call */
    enum effect effect;
} kinds[] = {
    {"malloc", 1u << MALLOC, FAIL},
    {"calloc", 1u << CALLOC, FAIL},
    {"realloc", 1u << REALLOC, FAIL},
    {"aligned", 1u << ALIGNED, FAIL},
    {"read", 1u << READ, FAIL},
    {"end", 1u << READ, END},
    {"bytes", 1u << READ, ONE_BYTE},
    {"write", 1u << WRITE, FAIL},
    {"full", 1u << WRITE, NO_SPACE},
    {"some", 1u << WRITE, ONE_BYTE},
    {"open", 1u << OPEN, FAIL},
    {"close", 1u << CLOSE, FAIL},
    {"fsync", 1u << FSYNC, FAIL},
    {"rename", 1u << RENAME, FAIL},
    {"thread", 1u << THREAD, FAIL},
    {"stat", 1u << STAT, FAIL},
    {"seek", 1u << SEEK, FAIL},
    {"temp", 1u << TEMP, FAIL},
    {"mode", 1u << MODE, FAIL},
    {"read-intr", 1u << READ, INTERRUPTED},
    {"write-intr", 1u << WRITE, INTERRUPTED},
#define FILES (1u << OPEN | 1u << READ | 1u << WRITE | 1u << CLOSE | 1u << FSYNC | 1u << RENAME)
#define MEMORY (1u << MALLOC | 1u << CALLOC | 1u << REALLOC)
    {"kill", FILES, DIE_KILL},
    {"term", FILES, DIE_TERM},
    {"kill-mem", MEMORY, DIE_KILL},
    {"term-mem", MEMORY, DIE_TERM},
};

static const struct kind *asked;
static long at;          /* which call of that kind */
static long seen;        /* calls of that kind so far */
static long made[CALLS]; /* calls of each */
static int ended_fd = -1;

__attribute__((constructor)) static void begin(void)
{
    const char *fault = getenv("FAULT"), *colon = fault ? strchr(fault, ':') : NULL;
    for (size_t i = 0; colon && i < sizeof kinds / sizeof *kinds; i++)
        if (strlen(kinds[i].name) == (size_t)(colon - fault) &&
            strncmp(kinds[i].name, fault, (size_t)(colon - fault)) == 0)
            asked = &kinds[i];
    at = colon ? strtol(colon + 1, NULL, 10) : 0;
    memset(made, 0, sizeof made);
    seen = 0;
}

__attribute__((destructor)) static void end(void)
{
    const char *file = getenv("FAULT_COUNTS");
    long fd = file ? syscall(SYS_openat, AT_FDCWD, file, O_WRONLY | O_CREAT | O_TRUNC, 0666) : -1;
    for (int i = 0; fd >= 0 && i < CALLS; i++) {
        char line[60];
        int n = snprintf(line, sizeof line, "%s %ld\n", call_name[i], made[i]);
        if (syscall(SYS_write, fd, line, n) != n)
            _exit(99);
    }
    if (fd >= 0)
        syscall(SYS_close, fd);
}

/* What is to become of this call. */
static enum effect effect_of(enum call call)
{
    __atomic_add_fetch(&made[call], 1, __ATOMIC_RELAXED);
    if (!asked || !(asked->calls & 1u << call) ||
        __atomic_add_fetch(&seen, 1, __ATOMIC_RELAXED) != at)
        return NONE;
    if (asked->effect == DIE_KILL || asked->effect == DIE_TERM)
        raise(asked->effect == DIE_KILL ? SIGKILL : SIGTERM);
    return asked->effect;
}

static bool fails(enum call call, int why)
{
    bool it_does = effect_of(call) == FAIL;
    if (it_does)
        errno = why;
    return it_does;
}

void *malloc(size_t n)
{
    return fails(MALLOC, ENOMEM) ? NULL : __libc_malloc(n);
}

void *calloc(size_t n, size_t size)
{
    return fails(CALLOC, ENOMEM) ? NULL : __libc_calloc(n, size);
}

void *realloc(void *p, size_t n)
{
    return fails(REALLOC, ENOMEM) ? NULL : __libc_realloc(p, n);
}

void *aligned_alloc(size_t align, size_t n)
{
    return fails(ALIGNED, ENOMEM) ? NULL : __libc_memalign(align, n);
}

ssize_t read(int fd, void *p, size_t n)
{
    enum effect effect = effect_of(READ);
    if (effect == END)
        ended_fd = fd;
    if (fd == ended_fd)
        return 0;
    if (effect == FAIL || effect == INTERRUPTED) {
        errno = effect == FAIL ? EIO : EINTR;
        return -1;
    }
    return syscall(SYS_read, fd, p, effect == ONE_BYTE && n > 0 ? 1 : n);
}

ssize_t write(int fd, const void *p, size_t n)
{
    enum effect effect = effect_of(WRITE);
    if (effect == FAIL || effect == NO_SPACE || effect == INTERRUPTED) {
        errno = effect == FAIL ? EIO : effect == NO_SPACE ? ENOSPC : EINTR;
        return -1;
    }
    return syscall(SYS_write, fd, p, effect == ONE_BYTE && n > 0 ? 1 : n);
}

int open(const char *file, int flags, ...)
{
    va_list list;
    va_start(list, flags);
    unsigned mode = flags & O_CREAT ? va_arg(list, unsigned) : 0;
    va_end(list);
    if (fails(OPEN, EIO))
        return -1;
    return (int)syscall(SYS_openat, AT_FDCWD, file, flags, mode);
}

int close(int fd)
{
    bool failed = fails(CLOSE, EIO);
    if (fd == ended_fd)
        ended_fd = -1;
    int result = (int)syscall(SYS_close, fd);
    if (failed)
        errno = EIO;
    return failed ? -1 : result;
}

int fsync(int fd)
{
    return fails(FSYNC, EIO) ? -1 : (int)syscall(SYS_fsync, fd);
}

int rename(const char *from, const char *to)
{
    return fails(RENAME, EIO) ? -1 : (int)syscall(SYS_renameat2, AT_FDCWD, from, AT_FDCWD, to, 0);
}

int fstat(int fd, struct stat *st)
{
    return fails(STAT, EIO) ? -1 : (int)syscall(SYS_fstat, fd, st);
}

off_t lseek(int fd, off_t by, int from)
{
    return fails(SEEK, EIO) ? -1 : syscall(SYS_lseek, fd, by, from);
}

int fchmod(int fd, mode_t mode)
{
    return fails(MODE, EIO) ? -1 : (int)syscall(SYS_fchmod, fd, mode);
}

int mkstemp(char *name)
{
    static int (*real)(char *);
    if (!real)
        *(void **)&real = dlsym(RTLD_NEXT, "mkstemp");
    return fails(TEMP, EIO) ? -1 : real(name);
}

/* A thread that asks for no size of its stack gets little, as of some libraries. */
int pthread_create(pthread_t *thread, const pthread_attr_t *how, void *(*work)(void *),
                   void *context)
{
    static int (*real)(pthread_t *, const pthread_attr_t *, void *(*)(void *), void *);
    pthread_attr_t small;
    if (!real)
        *(void **)&real = dlsym(RTLD_NEXT, "pthread_create");
    pthread_attr_init(&small);
    pthread_attr_setstacksize(&small, 1 << 15);
    return effect_of(THREAD) == FAIL ? EAGAIN : real(thread, how ? how : &small, work, context);
}
