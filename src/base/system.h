/*
 * system - POSIX as base uses it.  Windows (mingw-w64) has most of it under other names; what it
 * has not at all, signals that are held and permissions, does nothing there.
 */
#ifndef CLOUDMILL_SYSTEM_H
#define CLOUDMILL_SYSTEM_H

#include <fcntl.h>
#include <signal.h>
#include <sys/stat.h>
#include <unistd.h>

/* A write tells that a file is at its limit; no signal ends the process. */
static inline void ignore_file_limit(void)
{
#ifdef SIGXFSZ
    signal(SIGXFSZ, SIG_IGN);
#endif
}

#ifndef _WIN32

#include <sys/mman.h>

/* Bytes are bytes: no file is translated. */
static inline void system_begin(void)
{
}

static inline int is_open_file(int fd)
{
    return fcntl(fd, F_GETFD) >= 0;
}

#define NOTHING_FILE "/dev/null"

#else

#include <io.h>
#include <stdio.h>
#include <stdlib.h>
#include <windows.h>
#undef near
#undef far
#undef small

#define NOTHING_FILE "NUL"
#define O_CLOEXEC (O_BINARY | O_NOINHERIT)
#define _SC_NPROCESSORS_ONLN 0
#define aligned_alloc(alignment, bytes) malloc(bytes)
#define fchmod(fd, mode) 0
#define fsync(fd) _commit(fd)
#define realpath(file, room) _fullpath(room, file, 0)
#define readlink(file, to, room) (-1)
#define rename(from, to) (MoveFileExA(from, to, MOVEFILE_REPLACE_EXISTING) ? 0 : -1)
#define sysconf(which) atol(getenv("NUMBER_OF_PROCESSORS") ? getenv("NUMBER_OF_PROCESSORS") : "1")

static inline void system_begin(void)
{
    _setmode(0, O_BINARY);
    _setmode(1, O_BINARY);
    _setmode(2, O_BINARY);
}

static inline int is_open_file(int fd)
{
    return _get_osfhandle(fd) != -1;
}

enum { SIGHUP = SIGTERM, SIGPIPE = SIGTERM };

struct sigaction {
    void (*sa_handler)(int);
};

typedef int held_signals;

static inline int sigaction(int signal_number, const struct sigaction *to, struct sigaction *was)
{
    if (was)
        was->sa_handler = SIG_DFL;
    if (to)
        signal(signal_number, to->sa_handler);
    return 0;
}

#define sigset_t held_signals
#define sigemptyset(set) (void)(*(set) = 0)
#define sigaddset(set, signal_number) (void)(*(set) |= 1 << (signal_number))
#define sigprocmask(how, set, before) (void)(set)

#endif

#endif
