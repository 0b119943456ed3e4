/*
 * hammer RUNS SEED SECONDS FOLDER COMMAND... -- FILE... - runs a tool on files with something wrong
 * in them, made from good ones, and keeps in FOLDER those that it does not take as it should.
 *
 * RUNS: how many, or with an s behind it for how many seconds.  COMMAND has {} where the file's
 * name goes.  Each file is one of FILE... with one to four changes:
 * a number replaced by a hostile one (0, huge, tiny, nan, negative, another of the file), a line
 * doubled, left out or exchanged, bytes changed, the end cut off.
 *
 * Not as it should: killed by a signal, longer than SECONDS of processor time, an exit status that
 * is not 0, 1 or 3, no message beside 1 and 3, or `nan` or `inf` as a word of standard output.
 * Prints a line for each, and the number of runs of each exit status; exits with 1 if any is bad.
 */
#include <ctype.h>
#include <fcntl.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

enum { MOST = 1 << 20, SEEDS = 200, WORDS = 60 };

static const char *const hostile[] = {
    "0",     "-1",    "1e9",        "-1e9",       "1e300", "1e-300",     "nan",
    "inf",   "1e15",  "4294967296", "2147483647", "-0",    "0.00000001", "1e5",
    "1e-12", "99999", "100000.001", "-inf",       "1e38",  "3000000000"};

static uint64_t state;

static size_t below(size_t n)
{
    state = state * 6364136223846793005u + 1442695040888963407u;
    return n ? (size_t)((state >> 33) % n) : 0;
}

struct text {
    size_t n;
    char byte[MOST];
};

static struct text made;

static void read_seed(const char *file)
{
    FILE *in = fopen(file, "rb");
    made.n = in ? fread(made.byte, 1, MOST / 2, in) : 0;
    if (!in || fclose(in) != 0) {
        perror(file);
        exit(2);
    }
}

static void replace(size_t at, size_t n, const char *by, size_t by_n)
{
    if (made.n - n + by_n >= MOST)
        return;
    memmove(made.byte + at + by_n, made.byte + at + n, made.n - at - n);
    memcpy(made.byte + at, by, by_n);
    made.n = made.n - n + by_n;
}

/* The number at or after a random place: where, and how long; 0: none. */
static size_t find_number(size_t *at)
{
    size_t from = below(made.n), n = 0;
    while (from < made.n && !isdigit((unsigned char)made.byte[from]))
        from++;
    while (from > 0 && strchr("0123456789.-+", made.byte[from - 1]))
        from--;
    while (from + n < made.n && made.byte[from + n] &&
           strchr("0123456789.-+eE", made.byte[from + n]))
        n++;
    *at = from;
    return n;
}

static void change_number(void)
{
    char other[60];
    size_t at, from, n = find_number(&at), m = find_number(&from);
    if (n == 0)
        return;
    if (below(3) == 0 && m < sizeof other) {
        memcpy(other, made.byte + from, m);
        replace(at, n, other, m);
    } else {
        const char *by = hostile[below(sizeof hostile / sizeof *hostile)];
        replace(at, n, by, strlen(by));
    }
}

static size_t find_line(size_t *at)
{
    size_t from = below(made.n);
    while (from > 0 && made.byte[from - 1] != '\n')
        from--;
    const char *end = memchr(made.byte + from, '\n', made.n - from);
    *at = from;
    return end ? (size_t)(end - made.byte) - from + 1 : made.n - from;
}

static void change_line(void)
{
    static char line[MOST];
    size_t at, to, n = find_line(&at);
    memcpy(line, made.byte + at, n);
    if (below(2))
        replace(at, n, "", 0);
    find_line(&to);
    if (below(2))
        replace(to, 0, line, n);
}

static void change(void)
{
    size_t kind = below(20);
    if (made.n == 0)
        return;
    if (kind < 12)
        change_number();
    else if (kind < 16)
        change_line();
    else if (kind < 19)
        made.byte[below(made.n)] = (char)below(256);
    else
        made.n = below(made.n);
}

static void write_file(const char *name)
{
    FILE *out = fopen(name, "wb");
    if (!out || fwrite(made.byte, 1, made.n, out) != made.n || fclose(out) != 0) {
        perror(name);
        exit(2);
    }
}

static bool has_no_number(const char *file)
{
    FILE *in = fopen(file, "r");
    char word[80];
    bool found = false;
    while (in && !found && fscanf(in, "%79[a-zA-Z_]", word) != EOF) {
        found = strcmp(word, "nan") == 0 || strcmp(word, "inf") == 0;
        word[0] = '\0';
        found = found && fscanf(in, "%79[^a-zA-Z_]", word) >= 0;
        if (word[0] == '\0' && fscanf(in, "%79[^a-zA-Z_]", word) == EOF)
            break;
    }
    if (in)
        fclose(in);
    return found;
}

/* What is done but not as asked says so in its output. */
static bool says_why(const char *file)
{
    FILE *in = fopen(file, "r");
    char line[1000];
    bool found = false;
    while (in && !found && fgets(line, sizeof line, in))
        found = strstr(line, "UNMET") || strstr(line, "refused") || strstr(line, "REFUSED");
    if (in)
        fclose(in);
    return found;
}

static void in_child(char **command, unsigned seconds)
{
    struct rlimit time = {seconds, seconds + 1};
    int out = open("out", O_WRONLY | O_CREAT | O_TRUNC, 0666);
    int err = open("err", O_WRONLY | O_CREAT | O_TRUNC, 0666);
    setrlimit(RLIMIT_CPU, &time);
    alarm(20 * seconds);
    if (dup2(out, 1) < 0 || dup2(err, 2) < 0)
        _exit(126);
    execvp(command[0], command);
    _exit(127);
}

/* What was wrong, NULL: nothing. */
static const char *run(char **command, unsigned seconds, size_t count[4])
{
    static char what[60];
    int status;
    pid_t child = fork();
    if (child == 0)
        in_child(command, seconds);
    if (child < 0 || waitpid(child, &status, 0) != child)
        return "cannot run";
    FILE *err = fopen("err", "r");
    bool told = err && fgetc(err) != EOF;
    if (err)
        fclose(err);
    snprintf(what, sizeof what, "%s %d", WIFSIGNALED(status) ? "signal" : "exit status",
             WIFSIGNALED(status) ? WTERMSIG(status) : WEXITSTATUS(status));
    if (!WIFEXITED(status) || WEXITSTATUS(status) > 3 || WEXITSTATUS(status) == 2)
        return what;
    count[WEXITSTATUS(status)]++;
    if (WEXITSTATUS(status) != 0 && !told && !(WEXITSTATUS(status) == 3 && says_why("out")))
        return "nothing told";
    return WEXITSTATUS(status) != 1 && has_no_number("out") ? "nan or inf" : NULL;
}

int main(int argc, char **argv)
{
    int dashes = 5;
    while (dashes < argc && strcmp(argv[dashes], "--") != 0)
        dashes++;
    if (dashes + 1 >= argc || chdir(argv[4]) != 0) {
        fprintf(stderr, "usage: hammer RUNS SEED SECONDS FOLDER COMMAND... -- FILE...\n");
        return 2;
    }
    static char file[] = "file";
    char **command = argv + 5;
    argv[dashes] = NULL;
    for (char **word = command; *word; word++)
        if (strcmp(*word, "{}") == 0)
            *word = file;
    char *unit;
    size_t most = strtoul(argv[1], &unit, 10), runs = 0, bad = 0, count[4] = {0};
    time_t begun = time(NULL);
    unsigned long first = strtoul(argv[2], NULL, 10);
    for (size_t i = 0; *unit == 's' ? time(NULL) - begun < (time_t)most : i < most; i++, runs++) {
        state = (first << 32) + i;
        below(1);
        read_seed(argv[(size_t)dashes + 1 + below((size_t)(argc - dashes - 1))]);
        for (size_t k = 1 + below(4); k > 0; k--)
            change();
        write_file(file);
        const char *what = run(command, (unsigned)strtoul(argv[3], NULL, 10), count);
        if (what) {
            char name[80];
            snprintf(name, sizeof name, "bad-%lu-%zu", first, i);
            write_file(name);
            printf("%s: %s\n", name, what);
            fflush(stdout);
            bad++;
        }
    }
    printf("%zu runs: %zu done, %zu refused, %zu unmet, %zu bad\n", runs, count[0], count[1],
           count[3], bad);
    return bad > 0;
}
