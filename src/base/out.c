/* out - see out.h. */
#include "base/out.h"

#include <errno.h>
#include <pthread.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/array.h"
#include "base/cli.h"
#include "base/num.h"
#include "system.h"

enum { BUFFER = 1 << 16, LINK_MAX_BYTES = 4096, NAME_MAX_BYTES = 255 };

struct out {
    int fd;
    const char *name; /* for messages */
    char *target;     /* the name it gets when complete; NULL: written directly */
    bool in_memory;   /* there, in place of a file: */
    struct {
        size_t n, cap;
        char *item;
    } kept;
    size_t n;
    char buf[BUFFER];
};

/* The unfinished file's name while there is one: read by the signal handler, hence global. */
static char *volatile unfinished;

void out_abandon(void)
{
    if (unfinished)
        unlink(unfinished);
    unfinished = NULL;
}

static void on_signal(int signal_number)
{
    out_abandon();
    signal(signal_number, SIG_DFL);
    raise(signal_number);
}

static const int ending[] = {
    SIGINT,  SIGTERM, SIGHUP, SIGPIPE,
#ifdef SIGXCPU
    SIGQUIT, SIGXCPU,
#endif
};

static void watch_signals(void)
{
    struct sigaction action = {.sa_handler = on_signal}, was;
    for (size_t i = 0; i < sizeof ending / sizeof *ending; i++)
        if (sigaction(ending[i], NULL, &was) == 0 && was.sa_handler == SIG_DFL)
            sigaction(ending[i], &action, NULL);
}

struct file_ids {
    size_t n, cap;
    struct file_id {
        dev_t device;
        ino_t number;
    } * item;
};

/* The files that this process has given their names: two results with one name are one too few; and
 * those that it reads. */
static struct file_ids written, kept;
static pthread_mutex_t keeping = PTHREAD_MUTEX_INITIALIZER;

/* A file that a result may replace though it is read. */
static struct file_id in_place;

static bool once;

/* Something went to standard output, or took the name of the file that it is. */
static bool standard;

void out_once_each(void)
{
    once = true;
}

static bool is_file(const struct file_id *id, const struct stat *st)
{
    return st->st_ino != 0 && id->device == st->st_dev && id->number == st->st_ino;
}

static bool is_among(const struct file_ids *ids, const struct stat *st)
{
    for (size_t i = 0; i < ids->n; i++)
        if (is_file(&ids->item[i], st))
            return true;
    return false;
}

void out_keep(int fd)
{
    struct stat st;

    if (fstat(fd, &st) != 0 || !S_ISREG(st.st_mode))
        return;
    pthread_mutex_lock(&keeping);
    if (!is_among(&kept, &st))
        *array_push(&kept) = (struct file_id){st.st_dev, st.st_ino};
    pthread_mutex_unlock(&keeping);
}

void out_may_replace(const char *file)
{
    struct stat st;

    if (stat(file, &st) == 0)
        in_place = (struct file_id){st.st_dev, st.st_ino};
}

/* A file that has been read, under whatever name. */
static void check_kept(const char *file)
{
    struct stat st;

    if (!once || stat(file, &st) != 0 || !S_ISREG(st.st_mode) || is_file(&in_place, &st))
        return;
    pthread_mutex_lock(&keeping);
    bool is_kept = is_among(&kept, &st);
    pthread_mutex_unlock(&keeping);
    if (is_kept)
        die("%s: found a file that is read, expected another name for the result", file);
}

static bool is_same(const struct stat *a, const struct stat *b)
{
    return a->st_ino != 0 && a->st_ino == b->st_ino && a->st_dev == b->st_dev;
}

static bool is_standard(const struct stat *st)
{
    struct stat of;
    return fstat(1, &of) == 0 && is_same(st, &of);
}

/* The file that `file` leads to through symbolic links, so that a rename keeps the links; the last
 * one may lead to a file that is not there yet.  There is no circle of links: stat has told. */
static char *resolve_links(const char *file)
{
    char to[LINK_MAX_BYTES] = {0};
    char *real = realpath(file, NULL);
    ssize_t n = real ? -1 : readlink(file, to, sizeof to);
    if (n < 0 || n == sizeof to)
        return real ? real : mem_string(file, strlen(file));
    const char *slash = *to == '/' ? NULL : strrchr(file, '/');
    size_t folder = slash ? (size_t)(slash - file) + 1 : 0;
    char *next = mem_alloc(folder + (size_t)n + 1, 1);
    memcpy(next, file, folder);
    memcpy(next + folder, to, (size_t)n);
    real = resolve_links(next);
    free(next);
    return real;
}

/* A signal between the two would leave the file: it waits.  -1: as mkstemp. */
static int create_watched(char *name)
{
    sigset_t held, before;
    sigemptyset(&held);
    for (size_t i = 0; i < sizeof ending / sizeof *ending; i++)
        sigaddset(&held, ending[i]);
    sigprocmask(SIG_BLOCK, &held, &before);
    int fd = mkstemp(name), why = errno;
    if (fd >= 0) {
        unfinished = name;
        watch_signals();
    }
    sigprocmask(SIG_SETMASK, &before, NULL);
    errno = why;
    return fd;
}

/* A new file beside the target, with the permissions that the target has or the umask gives. */
static int create_beside(struct out *o, const struct stat *older)
{
    static const char suffix[] = ".XXXXXX";
    const char *slash = strrchr(o->target, '/');
    size_t folder = slash ? (size_t)(slash - o->target) + 1 : 0, n = strlen(o->target);
    if (n - folder > NAME_MAX_BYTES - (sizeof suffix - 1)) /* no name of a file may be longer */
        n = folder + NAME_MAX_BYTES - (sizeof suffix - 1);
    char *name = mem_alloc(n + sizeof suffix, 1);
    memcpy(name, o->target, n);
    memcpy(name + n, suffix, sizeof suffix);
    int fd = create_watched(name);
    if (fd < 0)
        die("%s: cannot write: %s", o->name, strerror(errno));
    mode_t mask = umask(0);
    umask(mask);
    if (fchmod(fd, older ? older->st_mode & 07777 : 0666 & ~mask) < 0)
        die("%s: cannot set permissions: %s", o->name, strerror(errno));
    return fd;
}

bool out_may_be_file(const char *file)
{
    struct stat st;

    return stat(file, &st) != 0 || S_ISREG(st.st_mode);
}

bool out_same_file(const char *file, const char *other)
{
    struct stat a, b;

    if (strcmp(file, other) == 0)
        return true;
    return stat(file, &a) == 0 && stat(other, &b) == 0 && is_same(&a, &b);
}

struct out *out_open(const char *file)
{
    struct out *o = mem_alloc(1, sizeof *o);
    ignore_file_limit();
    if (!file || strcmp(file, "-") == 0) {
        o->fd = 1;
        o->name = "standard output";
        if (standard)
            die("%s: found two results, expected a file for each", o->name);
        standard = true;
        return o;
    }
    o->name = file;
    struct stat st;
    bool there = stat(file, &st) == 0;
    if (!there && errno != ENOENT)
        die("%s: cannot write: %s", file, strerror(errno));
    if (there && S_ISDIR(st.st_mode))
        die("%s: is a directory, expected a file to write", file);
    if (there && !S_ISREG(st.st_mode)) {
        o->fd = open(file, O_WRONLY | O_CLOEXEC);
        if (o->fd < 0)
            die("%s: cannot write: %s", file, strerror(errno));
        return o;
    }
    bool over = there && is_standard(&st);
    if (there && (is_among(&written, &st) || (over && standard)))
        die("%s: found two results for this file, expected a file for each", file);
    standard |= over;
    if (there && access(file, W_OK) < 0)
        die("%s: cannot write: %s", file, strerror(errno));
    check_kept(file);
    o->target = resolve_links(file);
    o->fd = create_beside(o, there ? &st : NULL);
    return o;
}

static void put_bytes(struct out *o, const char *p, size_t n)
{
    if (o->in_memory) {
        array_reserve(&o->kept, o->kept.n + n);
        memcpy(o->kept.item + o->kept.n, p, n);
        o->kept.n += n;
        return;
    }
    while (n) {
        ssize_t done = write(o->fd, p, n);
        if (done < 0 && errno == EINTR)
            continue;
        if (done < 0)
            die("%s: cannot write: %s", o->name, strerror(errno));
        p += done;
        n -= (size_t)done;
    }
}

static void flush(struct out *o)
{
    put_bytes(o, o->buf, o->n);
    o->n = 0;
}

void out_bytes(struct out *o, const void *p, size_t n)
{
    if (n > BUFFER - o->n)
        flush(o);
    if (n > BUFFER) {
        put_bytes(o, p, n);
        return;
    }
    if (n > 0) /* p may be NULL */
        memcpy(o->buf + o->n, p, n);
    o->n += n;
}

struct out *out_memory(void)
{
    struct out *o = mem_alloc(1, sizeof *o);
    o->in_memory = true;
    return o;
}

void out_join(struct out *o, struct out *memory)
{
    out_bytes(o, memory->kept.item, memory->kept.n);
    out_bytes(o, memory->buf, memory->n);
    memory->kept.n = memory->n = 0;
}

char *out_room(struct out *o, size_t n)
{
    if (n > BUFFER - o->n)
        flush(o);
    return o->buf + o->n;
}

void out_take(struct out *o, size_t n)
{
    o->n += n;
}

void out_text(struct out *o, const char *s)
{
    out_bytes(o, s, strlen(s));
}

void out_printf(struct out *o, const char *format, ...)
{
    va_list args, again;
    va_start(args, format);
    va_copy(again, args);
    char small[512];
    int n = vsnprintf(small, sizeof small, format, args);
    if (n < (int)sizeof small) {
        out_bytes(o, small, (size_t)n);
    } else {
        char *large = mem_alloc((size_t)n + 1, 1);
        vsnprintf(large, (size_t)n + 1, format, again);
        out_bytes(o, large, (size_t)n);
        free(large);
    }
    va_end(again);
    va_end(args);
}

void out_num(struct out *o, double x, int digits)
{
    if (BUFFER - o->n < NUM_MAX)
        flush(o);
    o->n += num_write(o->buf + o->n, x, digits);
}

void out_exact(struct out *o, double x)
{
    char text[40];
    double back;

    for (int digits = 15; digits <= 17; digits++) {
        snprintf(text, sizeof text, "%.*g", digits, x == 0 ? 0 : x);
        if (num_whole(text, &back) && !(back < x) && !(back > x))
            break;
    }
    out_text(o, text);
}

void out_int(struct out *o, long long i)
{
    char digit[24], *first = digit + sizeof digit;
    unsigned long long left = i < 0 ? 0 - (unsigned long long)i : (unsigned long long)i;

    for (; left > 9; left /= 10)
        *--first = (char)('0' + left % 10);
    *--first = (char)('0' + left);
    if (i < 0)
        *--first = '-';
    out_bytes(o, first, (size_t)(digit + sizeof digit - first));
}

void out_close(struct out *o)
{
    if (o->in_memory) {
        array_free(&o->kept);
        free(o);
        return;
    }
    flush(o);
    if (o->target && fsync(o->fd) < 0)
        die("%s: cannot write: %s", o->name, strerror(errno));
    struct stat st;
    if (once && o->target && fstat(o->fd, &st) == 0)
        *array_push(&written) = (struct file_id){st.st_dev, st.st_ino};
    if (close(o->fd) < 0)
        die("%s: cannot write: %s", o->name, strerror(errno));
    if (o->target) {
        char *done = unfinished;
        check_kept(o->target); /* it may have been read meanwhile */
        if (rename(done, o->target) < 0)
            die("%s: cannot rename: %s", o->name, strerror(errno));
        unfinished = NULL;
        free(done);
        free(o->target);
    }
    free(o);
}
