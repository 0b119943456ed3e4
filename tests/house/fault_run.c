/*
 * fault_run LIBRARY KINDS MOST COMMAND... - runs a command again and again, each time with another
 * call failing (fault_lib.c), and says what came of it.
 *
 * The command runs in the folder `work`, made anew from the folder `before` for each run, so all
 * its inputs and older outputs are in there; its standard output goes to `work/stdout`.  A first
 * run without a fault says what is right.  KINDS are kinds of fault_lib with commas between; of
 * each, at most MOST calls are tried, evenly spread from the first to the last (0: all of them).
 *
 * A run with a fault is good
 * - with exit status 1, one line on standard error that begins with the name of the tool, after
 *   none but lines of the first run, each file as it was before or as the first run left it, no
 *   other file, and on standard output not all that the first run wrote there (but when its close
 *   failed, or the tool was killed then); or
 * - if all is as in the first run, standard error too: the call did not matter.
 * After bytes, some and -intr, which are no failures, only the latter; after kill, kill-mem and
 * moment a temporary file may be left, and standard error be empty.
 *
 * The kind moment is no call: SIGKILL from outside at MOST moments by chance (SEED), half of them
 * in the last third of the time that the first run took, when files are written.  Where a temporary
 * file is left, the command runs once more beside it and must do as in the first run.
 *
 * Prints a line `bad KIND N: WHAT` for each that is not good, and `KIND: N runs, N bad` for each
 * kind; exits with 1 if any is bad.
 */
#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

enum { MOST_FILES = 64, NAME = 128, SECONDS = 60, MOMENTS = 1000 };

struct file {
    char name[NAME], *text;
    size_t n;
};

/* What lies in a folder. */
struct folder {
    int n;
    struct file file[MOST_FILES];
};

struct outcome {
    int status;     /* of waitpid */
    double seconds; /* by the clock */
    struct folder folder;
    struct file err;
};

static _Noreturn void stop(const char *what, const char *name)
{
    fprintf(stderr, "fault_run: %s %s: %s\n", what, name, strerror(errno));
    exit(2);
}

static struct file read_whole(const char *folder, const char *name)
{
    struct file f = {.text = NULL};
    char path[2 * NAME];
    snprintf(f.name, sizeof f.name, "%s", name);
    snprintf(path, sizeof path, "%s/%s", folder, name);
    FILE *in = fopen(path, "r");
    struct stat st;
    if (!in || fstat(fileno(in), &st) != 0)
        stop("cannot read", path);
    f.text = malloc((size_t)st.st_size + 1);
    f.n = f.text ? fread(f.text, 1, (size_t)st.st_size, in) : 0;
    fclose(in);
    return f;
}

static struct folder read_folder(const char *name)
{
    struct folder all = {.n = 0};
    DIR *dir = opendir(name);
    if (!dir)
        stop("cannot read", name);
    for (struct dirent *e; (e = readdir(dir));)
        if (e->d_name[0] != '.' && all.n < MOST_FILES)
            all.file[all.n++] = read_whole(name, e->d_name);
    closedir(dir);
    return all;
}

static void free_folder(struct folder *all)
{
    for (int i = 0; i < all->n; i++)
        free(all->file[i].text);
    all->n = 0;
}

static const struct file *find(const struct folder *all, const char *name)
{
    for (int i = 0; i < all->n; i++)
        if (strcmp(all->file[i].name, name) == 0)
            return &all->file[i];
    return NULL;
}

static bool same(const struct file *a, const struct file *b)
{
    return a && b && a->n == b->n && (a->n == 0 || memcmp(a->text, b->text, a->n) == 0);
}

/* `work` as `before` was. */
static void make_work(const struct folder *before)
{
    char path[2 * NAME];
    if (mkdir("work", 0777) != 0 && errno != EEXIST)
        stop("cannot make", "work");
    struct folder left = read_folder("work");
    for (int i = 0; i < left.n; i++) {
        snprintf(path, sizeof path, "work/%s", left.file[i].name);
        if (!same(&left.file[i], find(before, left.file[i].name)))
            unlink(path);
    }
    for (int i = 0; i < before->n; i++) {
        const struct file *f = &before->file[i];
        if (same(f, find(&left, f->name)))
            continue;
        snprintf(path, sizeof path, "work/%s", f->name);
        FILE *out = fopen(path, "w");
        if (!out || fwrite(f->text, 1, f->n, out) != f->n || fclose(out) != 0)
            stop("cannot write", path);
    }
    free_folder(&left);
}

static void send_to(int fd, const char *name)
{
    int file = open(name, O_WRONLY | O_CREAT | O_TRUNC, 0666);
    if (file < 0 || dup2(file, fd) < 0)
        _exit(126);
    close(file);
}

static double now(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static void wait_for(double seconds)
{
    struct timespec t = {.tv_sec = (time_t)seconds};
    t.tv_nsec = (long)(1e9 * (seconds - (double)t.tv_sec));
    nanosleep(&t, NULL);
}

/* $FED on standard input by a pipe, from a process that writes it. */
static void feed(void)
{
    int end[2];
    const char *name = getenv("FED");
    if (!name || !*name)
        return;
    int in = open(name, O_RDONLY);
    if (in < 0 || pipe(end) != 0)
        _exit(126);
    if (fork() == 0) {
        char chunk[1 << 12];
        close(end[0]);
        for (ssize_t n; (n = read(in, chunk, sizeof chunk)) > 0;)
            if (write(end[1], chunk, (size_t)n) != n)
                break;
        _exit(0);
    }
    if (dup2(end[0], 0) != 0)
        _exit(126);
    close(in);
    close(end[0]);
    close(end[1]);
}

/* The command in `work` as it is, with this fault (NULL: none); killed after `moment` seconds
   (0: not). */
static struct outcome run_there(const char *library, const char *fault, double moment,
                                char **command)
{
    struct outcome o = {.status = 0};
    double began = now();
    pid_t child = fork();
    if (child == 0) {
        if (moment > 0)
            setpgid(0, 0);
        alarm(SECONDS);
        send_to(2, "stderr");
        if (chdir("work") != 0)
            _exit(126);
        send_to(1, "stdout");
        feed();
        setenv("LD_PRELOAD", library, 1);
        if (fault)
            setenv("FAULT", fault, 1);
        else
            setenv("FAULT_COUNTS", "../counts", 1);
        execvp(command[0], command);
        _exit(127);
    }
    if (child > 0 && moment > 0) { /* with what it started */
        setpgid(child, child);
        wait_for(moment);
        kill(-child, SIGKILL);
    }
    if (child < 0 || waitpid(child, &o.status, 0) != child)
        stop("cannot run", command[0]);
    o.seconds = now() - began;
    o.folder = read_folder("work");
    o.err = read_whole(".", "stderr");
    return o;
}

/* The same in `work` made anew. */
static struct outcome run(const struct folder *before, const char *library, const char *fault,
                          char **command)
{
    make_work(before);
    return run_there(library, fault, 0, command);
}

static void free_outcome(struct outcome *o)
{
    free_folder(&o->folder);
    free(o->err.text);
}

static bool all_as(const struct outcome *got, const struct outcome *right)
{
    bool as = got->status == right->status && got->folder.n == right->folder.n &&
              same(&got->err, &right->err);
    for (int i = 0; i < got->folder.n && as; i++)
        as = same(&got->folder.file[i], find(&right->folder, got->folder.file[i].name));
    return as;
}

/* Says what is wrong with a run that failed; NULL: nothing.  `killed`: by SIGKILL. */
static const char *blame(const struct outcome *got, const struct folder *before,
                         const struct outcome *right, bool killed, bool last)
{
    const struct file *all = find(&right->folder, "stdout"), *out = find(&got->folder, "stdout");
    for (int i = 0; i < got->folder.n; i++) {
        const struct file *f = &got->folder.file[i], *was = find(before, f->name);
        const struct file *now = find(&right->folder, f->name);
        if (!was && !now && !killed)
            return "a file was left that should not be there";
        if ((was || now) && f != out && !same(f, was) && !same(f, now))
            return "a file is neither old nor new";
    }
    for (int i = 0; i < before->n; i++)
        if (!find(&got->folder, before->file[i].name))
            return "an older file is gone";
    if (!last && all && all->n > 0 && same(out, all))
        return "all was written to standard output, and yet it failed";
    return NULL;
}

/* What was told beyond what the first run told too. */
static const char *own_message(const struct outcome *got, const struct outcome *right)
{
    const char *own = got->err.text;
    got->err.text[got->err.n] = right->err.text[right->err.n] = '\0';
    for (const char *end; (end = strchr(own, '\n')); own = end + 1) {
        size_t n = (size_t)(end - own) + 1;
        const char *at = right->err.text;
        while (strncmp(at, own, n) != 0 && (at = strchr(at, '\n')))
            at++;
        if (!at)
            break;
    }
    return own;
}

static const char *judge_message(const struct outcome *got, const struct outcome *right,
                                 const char *tool)
{
    static char what[300];
    const char *own = own_message(got, right), *end = strchr(own, '\n');
    const char *slash = strrchr(tool, '/');
    tool = slash ? slash + 1 : tool;
    if (!WIFEXITED(got->status) || WEXITSTATUS(got->status) != 1) {
        snprintf(what, sizeof what, "%s %d, expected exit status 1",
                 WIFEXITED(got->status) ? "exit status" : "killed by signal",
                 WIFEXITED(got->status) ? WEXITSTATUS(got->status) : WTERMSIG(got->status));
        return what;
    }
    if (!end || end[1] || strncmp(own, tool, strlen(tool)) != 0) {
        snprintf(what, sizeof what, "%s", end ? own : "nothing told");
        return what;
    }
    return NULL;
}

static long count_of(const char *kind)
{
    static const struct {
        const char *kind, *calls;
    } of[] = {{"end", " read "},
              {"bytes", " read "},
              {"read-intr", " read "},
              {"write-intr", " write "},
              {"full", " write "},
              {"some", " write "},
              {"kill", " open read write close fsync rename "},
              {"term", " open read write close fsync rename "},
              {"kill-mem", " malloc calloc realloc "},
              {"term-mem", " malloc calloc realloc "}};
    char calls[80], name[40], word[44];
    long n, sum = 0;
    snprintf(calls, sizeof calls, " %s ", kind);
    for (size_t i = 0; i < sizeof of / sizeof *of; i++)
        if (strcmp(of[i].kind, kind) == 0)
            snprintf(calls, sizeof calls, "%s", of[i].calls);
    FILE *in = fopen("counts", "r");
    if (strcmp(kind, "moment") == 0)
        sum = MOMENTS;
    if (!in)
        stop("cannot read", "counts");
    while (fscanf(in, "%39s %ld", name, &n) == 2) {
        snprintf(word, sizeof word, " %s ", name);
        sum += strstr(calls, word) ? n : 0;
    }
    fclose(in);
    return sum;
}

/* Tries one call; says what was wrong, NULL: nothing. */
static const char *try_call(const char *library, const char *kind, long n,
                            const struct folder *before, const struct outcome *right,
                            char **command)
{
    char fault[80];
    snprintf(fault, sizeof fault, "%s:%ld", kind, n);
    struct outcome got = run(before, library, fault, command);
    bool killed = strncmp(kind, "kill", 4) == 0, ended = strncmp(kind, "term", 4) == 0;
    bool harmless =
        strcmp(kind, "bytes") == 0 || strcmp(kind, "some") == 0 || strstr(kind, "-intr");
    const char *bad = NULL;
    if (!all_as(&got, right)) {
        bad = harmless ? "the result is another"
                       : blame(&got, before, right, killed,
                               killed || ended || strcmp(kind, "close") == 0);
        if (!bad && killed && WIFSIGNALED(got.status))
            ;
        else if (!bad && ended)
            bad = WIFSIGNALED(got.status) && WTERMSIG(got.status) == SIGTERM ? NULL
                                                                             : "not ended by it";
        else if (!bad)
            bad = judge_message(&got, right, command[0]);
    }
    free_outcome(&got);
    return bad;
}

/* The next of a course of numbers between 0 and 1 that $SEED begins. */
static double by_chance(void)
{
    static unsigned long long state;
    const char *seed = getenv("SEED");
    if (!state)
        state = seed ? strtoull(seed, NULL, 10) * 2 + 1 : 1;
    state = state * 6364136223846793005ULL + 1442695040888963407ULL;
    return (double)(state >> 11) / 9007199254740992.0;
}

/* Beside what a killed run left, the command must do as if nothing were there. */
static const char *try_again(const char *library, const struct outcome *killed,
                             const struct outcome *right, char **command)
{
    const char *bad = NULL;
    struct outcome got = run_there(library, NULL, 0, command);
    if (got.status != right->status || !same(&got.err, &right->err))
        bad = "the next run trips over what was left";
    for (int i = 0; i < right->folder.n && !bad; i++)
        if (!same(&right->folder.file[i], find(&got.folder, right->folder.file[i].name)))
            bad = "the next run writes other files beside what was left";
    for (int i = 0; i < got.folder.n && !bad; i++)
        if (!find(&killed->folder, got.folder.file[i].name) &&
            !find(&right->folder, got.folder.file[i].name))
            bad = "the next run leaves one file more";
    free_outcome(&got);
    return bad;
}

static long killed_runs, left_runs;

/* Kills the command at the nth moment; says what was wrong, NULL: nothing. */
static const char *try_moment(const char *library, long n, const struct folder *before,
                              const struct outcome *right, char **command)
{
    double share = by_chance(), all = 1.05 * right->seconds;
    make_work(before);
    double moment = all * (n % 2 ? share : 1 - share / 3);
    struct outcome got = run_there(library, NULL, moment, command);
    const char *bad = NULL;
    if (WIFSIGNALED(got.status) || !all_as(&got, right))
        bad = blame(&got, before, right, true, true);
    killed_runs += WIFSIGNALED(got.status);
    if (!bad && !WIFSIGNALED(got.status))
        bad = all_as(&got, right) ? NULL : "ended otherwise before it was killed";
    for (int i = 0; i < got.folder.n && !bad; i++)
        if (!find(before, got.folder.file[i].name) &&
            !find(&right->folder, got.folder.file[i].name)) {
            bad = try_again(library, &got, right, command);
            left_runs++;
            break;
        }
    free_outcome(&got);
    return bad;
}

int main(int argc, char **argv)
{
    if (argc < 5)
        stop("usage:", "fault_run LIBRARY KINDS MOST COMMAND...");
    long most = strtol(argv[3], NULL, 10), all_bad = 0;
    char **command = argv + 4;
    struct folder before = read_folder("before");
    struct outcome right = run(&before, argv[1], NULL, command);
    int ended = WIFEXITED(right.status) ? WEXITSTATUS(right.status) : 1;
    if (ended != 0 && ended != 3) {
        printf("bad none 0: the command fails without a fault: %s\n", right.err.text);
        return 1;
    }
    for (char *kind = strtok(argv[2], ","); kind; kind = strtok(NULL, ",")) {
        long calls = count_of(kind), tries = most == 0 || calls < most ? calls : most, bad = 0;
        for (long i = 0; i < tries; i++) {
            long n = tries == 1 ? 1 : 1 + i * (calls - 1) / (tries - 1);
            const char *what = strcmp(kind, "moment") == 0
                                   ? try_moment(argv[1], n, &before, &right, command)
                                   : try_call(argv[1], kind, n, &before, &right, command);
            if (what)
                printf("bad %s %ld: %s\n", kind, n, what);
            bad += what != NULL;
        }
        printf("%s: %ld of %ld calls, %ld bad\n", kind, tries, calls, bad);
        if (strcmp(kind, "moment") == 0)
            printf("%ld killed, %ld left a temporary file\n", killed_runs, left_runs);
        fflush(stdout);
        all_bad += bad;
    }
    return all_bad > 0;
}
