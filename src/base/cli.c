/* cli - options by table and the help made from it; see cli.h. */
#include "base/cli.h"

#include <getopt.h>
#include <math.h>
#include <pthread.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "base/array.h"
#include "base/num.h"
#include "base/out.h"
#include "program_dir.h"
#include "system.h"

/* ---- messages, and the end of the process */

static struct {
    const char *tool;
    bool quiet, verbose, progress_shown;
} state = {.tool = "cloudmill"};

/* A fitter's scan and its path are read by two threads. */
static pthread_mutex_t lines = PTHREAD_MUTEX_INITIALIZER; /* on progress_shown, and on `last` */

/* The name before every message. */
static void message_begin(const char *tool)
{
    state.tool = tool;
}

const char *cli_tool(void)
{
    return state.tool;
}

/* quiet: errors only; verbose: summaries too.  Quiet wins. */
static void message_level(bool quiet, bool verbose)
{
    state.quiet = quiet;
    state.verbose = verbose && !quiet;
}

/* Prints one line; control characters, which may come from a hostile file, become `?`. */
static void print_line(const char *format, va_list args)
{
    char line[512];
    int n = snprintf(line, sizeof line, "%.40s: ", state.tool);
    vsnprintf(line + n, 395 - (size_t)n, format, args);
    for (char *p = line; *p; p++)
        if ((unsigned char)*p < ' ' || *p == 127)
            *p = '?';
    pthread_mutex_lock(&lines);
    if (state.progress_shown)
        fputs("\r\033[K", stderr);
    state.progress_shown = false;
    fprintf(stderr, "%s\n", line);
    pthread_mutex_unlock(&lines);
}

void warn(const char *format, ...)
{
    va_list args;
    va_start(args, format);
    print_line(format, args);
    va_end(args);
}

void say(const char *format, ...)
{
    if (state.quiet)
        return;
    va_list args;
    va_start(args, format);
    print_line(format, args);
    va_end(args);
}

bool notes_shown(void)
{
    return state.verbose;
}

void note(const char *format, ...)
{
    if (!state.verbose)
        return;
    va_list args;
    va_start(args, format);
    print_line(format, args);
    va_end(args);
}

void die(const char *format, ...)
{
    va_list args;
    va_start(args, format);
    out_abandon();
    print_line(format, args);
    va_end(args);
    exit(EXIT_FAILED);
}

void die_error(const struct error *error)
{
    die("%s", error->text);
}

void die_usage(const char *format, ...)
{
    va_list args;
    va_start(args, format);
    out_abandon();
    print_line(format, args);
    va_end(args);
    if (!state.quiet)
        fprintf(stderr, "try `%s --help`\n", state.tool);
    exit(EXIT_USAGE);
}

void die_unmet(const char *format, ...)
{
    va_list args;
    va_start(args, format);
    out_abandon();
    print_line(format, args);
    va_end(args);
    exit(EXIT_UNMET);
}

void die_given(const struct error *error)
{
    die_status(error->file ? EXIT_FAILED : EXIT_USAGE, error);
}

void die_status(int status, const struct error *error)
{
    if (status == EXIT_USAGE)
        die_usage("%s", error->text);
    if (status == EXIT_UNMET)
        die_unmet("%s", error->text);
    die_error(error);
}

void progress(const char *what, size_t done, size_t of)
{
    static time_t last;
    if (state.quiet || !isatty(2))
        return;
    pthread_mutex_lock(&lines);
    time_t now = time(NULL);
    if (done >= of || now != last) { /* at most once a second */
        last = now;
        if (done < of)
            fprintf(stderr, "\r%s: %s %d%% (%zu of %zu)\033[K", state.tool, what,
                    (int)(100.0 * (double)done / (double)of), done, of);
        else
            fputs("\r\033[K", stderr);
        fflush(stderr);
        state.progress_shown = done < of;
    }
    pthread_mutex_unlock(&lines);
}

/* ---- options */

static bool help, version, quiet, verbose;

enum { COMMON_HELP = 256 }; /* getopt's value for option i of the merged table: this + i */

/* The tool's options, followed by those that every tool has. */
struct table {
    size_t n, cap;
    struct cli_option *item;
};

static struct table merge_tables(struct cli *cli)
{
    const struct cli_option common[] = {
        {'o', "output", "FILE", "write to FILE instead of standard output", CLI_TEXT, &cli->output,
         0, 0, 0, NULL},
        {'j', "threads", "N", "use N threads (default: one a processor); the result is the same",
         CLI_COUNT, &cli->threads, 1, 1024, 0, NULL},
        {'q', "quiet", NULL, "say nothing but errors", CLI_FLAG, &quiet, 0, 0, 0, NULL},
        {'v', "verbose", NULL, "sum up input, output and tolerance kept", CLI_FLAG, &verbose, 0, 0,
         0, NULL},
        {'h', "help", NULL, "print this and exit; --help all: every option", CLI_FLAG, &help, 0, 0,
         0, NULL},
        {'V', "version", NULL, "print the version and exit", CLI_FLAG, &version, 0, 0, 0, NULL},
    };
    struct table t = {0};
    for (const struct cli_option *o = cli->option; o && o->name; o++)
        *array_push(&t) = *o;
    for (const struct cli_option *o = cli->more; o && o->name; o++)
        *array_push(&t) = *o;
    for (size_t i = 0; i < sizeof common / sizeof *common; i++)
        *array_push(&t) = common[i];
    return t;
}

enum { HELP_COLUMN = 25, HELP_WIDTH = 80 }; /* a terminal of the usual width */

/* The words of `text` in lines from HELP_COLUMN on; the cursor stands there. */
static void print_help_text(const char *text)
{
    int column = HELP_COLUMN;
    for (const char *p = text; *p;) {
        int n = (int)strcspn(p, " \n");
        if (column > HELP_COLUMN && column + 1 + n > HELP_WIDTH) {
            printf("\n%*s", HELP_COLUMN, "");
            column = HELP_COLUMN;
        }
        column += printf(column > HELP_COLUMN ? " %.*s" : "%.*s", n, p);
        p += n;
        p += strspn(p, " \n");
    }
    printf("\n");
}

/* Is it among the words of the list? */
static bool is_listed(const char *list, const char *word)
{
    size_t n = strlen(word);

    for (const char *p = list; (p = strstr(p, word)); p += n)
        if ((p == list || p[-1] == ' ') && (p[n] == ' ' || p[n] == '\0'))
            return true;
    return false;
}

/* The common options come last in the table; -o and -h are usual in every tool. */
static bool is_usual(const struct cli *cli, const struct cli_option *o)
{
    return !cli->usual || is_listed(cli->usual, o->name) || is_listed("output help", o->name);
}

static void print_help(const struct cli *cli, const struct table *t, bool all)
{
    size_t hidden = 0;
    printf("usage: %s %s\n%s\n\n", cli->tool, cli->usage, cli->about);
    for (size_t i = 0; i < t->n; i++) {
        const struct cli_option *o = &t->item[i];
        if (o->kind == CLI_ALIAS)
            continue;
        if (!all && !is_usual(cli, o)) {
            hidden++;
            continue;
        }
        int n =
            o->letter ? printf("  -%c, --%s", o->letter, o->name) : printf("      --%s", o->name);
        if (o->arg)
            n += printf(" %s", o->arg);
        if (n >= HELP_COLUMN - 1)
            n = printf("\n") - 1;
        printf("%*s", HELP_COLUMN - n, "");
        print_help_text(o->help);
    }
    printf("\n");
    if (hidden > 0)
        printf("%zu further options: %s --help all.  ", hidden, cli->tool);
    printf("Manual: man %s\n"
           "No FILE, or -: standard input.  Lengths in mm, angles in degrees.\n"
           "Exit status: 0 done, 1 input or output failed, 2 wrong usage, 3 written, but\n"
           "something asked for is not kept.\n",
           cli->tool);
}

/* How the option was meant: `-r` or `--radius`. */
static const char *option_name(const struct cli_option *o, char buf[64])
{
    if (o->letter)
        snprintf(buf, 64, "-%c/--%s", o->letter, o->name);
    else
        snprintf(buf, 64, "--%s", o->name);
    return buf;
}

static _Noreturn void refuse(const struct cli_option *o, const char *text, const char *expected)
{
    char name[64];
    die_usage("option %s: found `%.60s`, expected %s", option_name(o, name), text, expected);
}

static void expect_range(const struct cli_option *o, double value, const char *text)
{
    if (o->min == 0 && o->max == 0)
        return;
    if (value >= o->min && (o->max == 0 || value <= o->max))
        return;
    char expected[100], low[NUM_MAX], high[NUM_MAX];
    num_write_short(low, o->min, 6, false);
    num_write_short(high, o->max, 6, false);
    if (o->max != 0)
        snprintf(expected, sizeof expected, "%.40s to %.40s", low, high);
    else
        snprintf(expected, sizeof expected,
                 o->min == CLI_POSITIVE ? "a number above 0" : "%.40s or more", low);
    refuse(o, text, expected);
}

/* Lengths, angles and feeds whose squares still have all digits that matter. */
static bool is_moderate(double value)
{
    return fabs(value) <= CLI_LARGEST;
}

static int read_choice(const struct cli_option *o, const char *text)
{
    const char *word = o->arg ? o->arg : "";
    for (int i = 0;; i++) {
        size_t n = strcspn(word, "|");
        if (strlen(text) == n && strncmp(word, text, n) == 0)
            return i;
        if (!word[n]) {
            char expected[200];
            snprintf(expected, sizeof expected, "one of %s", o->arg);
            refuse(o, text, expected);
        }
        word += n + 1;
    }
}

static void read_numbers(const struct cli_option *o, const char *text)
{
    const char *p = text;
    double *value = o->value;
    int n = 0;
    while (n < o->count && num_read(&p, &value[n]) && is_moderate(value[n])) {
        n++;
        if (*p != ',')
            break;
        p++;
    }
    if (n != o->count || *p || (p > text && p[-1] == ',')) {
        char expected[64];
        snprintf(expected, sizeof expected, "%d numbers, none beyond %.0e, with commas between",
                 o->count, CLI_LARGEST);
        refuse(o, text, expected);
    }
}

static void set_value(const struct cli_option *o, const char *text)
{
    double number = 0;
    switch (o->kind) {
    case CLI_FLAG:
        *(bool *)o->value = true;
        break;
    case CLI_NUMBER:
        if (!num_whole(text, &number))
            refuse(o, text, "a number");
        if (!is_moderate(number))
            refuse(o, text, "a number of at most 1000000000");
        expect_range(o, number, text);
        *(double *)o->value = number;
        break;
    case CLI_COUNT:
        if (!num_whole(text, &number) || number != floor(number) || !is_moderate(number))
            refuse(o, text, "a whole number");
        expect_range(o, number, text);
        *(int *)o->value = (int)number;
        break;
    case CLI_TEXT:
        if (!*text)
            refuse(o, text, o->arg);
        *(const char **)o->value = text;
        break;
    case CLI_CHOICE:
        *(int *)o->value = read_choice(o, text);
        break;
    case CLI_NUMBERS:
        read_numbers(o, text);
        break;
    case CLI_LIST:
        *array_push((struct cli_list *)o->value) = text;
        break;
    case CLI_ALIAS: /* set_by_name */
        return;
    }
    if (o->given)
        *o->given = true;
}

/* Old names as the command line has them: told once the options say how much is to be said. */
struct old_names {
    size_t n, cap;
    const struct cli_option **item;
};

static void set_by_name(const struct table *t, const struct cli_option *o, const char *text,
                        struct old_names *old)
{
    if (o->kind != CLI_ALIAS) {
        set_value(o, text);
        return;
    }
    const char *name = o->value;
    size_t n = strcspn(name, "=");
    *array_push(old) = o;
    for (size_t i = 0; i < t->n; i++)
        if (strncmp(t->item[i].name, name, n) == 0 && !t->item[i].name[n])
            set_value(&t->item[i], name[n] ? name + n + 1 : text);
}

/*
 * A standard file that was closed is opened the wrong way round: no file opened later gets its
 * place, and whoever reads or writes it finds the failure.
 */
static void hold_standard_files(void)
{
    static const int mode[] = {O_WRONLY, O_RDONLY, O_WRONLY};
    for (int fd = 0; fd <= 2; fd++)
        if (!is_open_file(fd) && open(NOTHING_FILE, mode[fd]) != fd)
            exit(EXIT_FAILED);
    system_begin();
    out_once_each();
}

/* How many letters must be put in, taken out or changed to make one word of the other; `n` letters
 * of the first count (Levenshtein 1966), at most 62 of each. */
static size_t letters_apart(const char *a, size_t n, const char *b)
{
    size_t row[64], m = strlen(b);

    n = n < 62 ? n : 62;
    m = m < 62 ? m : 62;
    for (size_t k = 0; k <= m; k++)
        row[k] = k;
    for (size_t i = 1; i <= n; i++) {
        size_t corner = row[0];
        row[0] = i;
        for (size_t k = 1; k <= m; k++) {
            size_t change = corner + (a[i - 1] != b[k - 1]), other = 1 + row[k - 1];
            corner = row[k];
            other = other < 1 + corner ? other : 1 + corner;
            row[k] = change < other ? change : other;
        }
    }
    return row[m];
}

/* The long option that was perhaps meant; NULL: none is near. */
static const char *nearest_option(const struct table *t, const char *name)
{
    size_t n = strcspn(name, "="), nearest = n / 3 + 1;
    const char *found = NULL;

    for (size_t i = 0; i < t->n; i++) {
        const char *option = t->item[i].name;
        if (t->item[i].kind == CLI_ALIAS)
            continue;
        size_t apart = letters_apart(name, n, option);
        if (n > 2 && strncmp(name, option, n) == 0)
            apart = 0;
        if (apart <= nearest && (!found || apart < nearest)) {
            nearest = apart;
            found = option;
        }
    }
    return found;
}

/* The word that getopt stopped at: unknown, the beginning of several, or without its value. */
static _Noreturn void refuse_option(const struct table *t, const char *word, bool no_value)
{
    const char *what = no_value ? "has no value" : "is unknown or ambiguous";
    const char *near = no_value || strncmp(word, "--", 2) != 0 ? NULL : nearest_option(t, word + 2);

    if (optopt > 0 && optopt < COMMON_HELP)
        die_usage("option -%c %s", optopt, what);
    if (near)
        die_usage("option %.60s %s: did you mean --%s?", word, what, near);
    die_usage("option %.60s %s", word, what);
}

static void run_getopt(const struct table *t, int argc, char **argv, struct old_names *old)
{
    struct option *longs = mem_alloc(t->n + 1, sizeof *longs);
    char *shorts = mem_alloc(2 * t->n + 2, 1), *p = shorts;
    *p++ = ':';
    for (size_t i = 0; i < t->n; i++) {
        const struct cli_option *o = &t->item[i];
        longs[i] = (struct option){o->name, o->arg ? required_argument : no_argument, NULL,
                                   COMMON_HELP + (int)i};
        if (o->letter) {
            *p++ = (char)o->letter;
            if (o->arg)
                *p++ = ':';
        }
    }
    opterr = 0;
    for (int c; (c = getopt_long(argc, argv, shorts, longs, NULL)) != -1;) {
        if (c == '?' || c == ':')
            refuse_option(t, argv[optind - 1], c == ':');
        for (size_t i = 0; i < t->n; i++)
            if (c == COMMON_HELP + (int)i || c == t->item[i].letter)
                set_by_name(t, &t->item[i], optarg ? optarg : "", old);
    }
    free(longs);
    free(shorts);
}

/* Help and version go to standard output, and a full disk is an error there too. */
static _Noreturn void finish_stdout(void)
{
    if (fflush(stdout) != 0 || fclose(stdout) != 0)
        die("standard output: cannot write");
    exit(EXIT_DONE);
}

bool cli_is_operand(const struct cli *cli, const char *file)
{
    for (int i = 0; i < cli->files; i++)
        if (strcmp(cli->file[i], "-") != 0 && out_same_file(file, cli->file[i]))
            return true;
    return false;
}

/* A result takes no operand's place but by a tool that changes it; found before hours of work. */
static void check_output(const struct cli *cli)
{
    if (!cli->output || !cli_is_operand(cli, cli->output))
        return;
    if (!cli->in_place)
        die_usage("option -o: found %s, which is read, expected another file", cli->output);
    out_may_replace(cli->output);
}

void cli_parse(struct cli *cli, int argc, char **argv)
{
    static char standard_input[] = "-";
    static char *only_standard_input[] = {standard_input, NULL};

    hold_standard_files();
    program_called(argv[0]);
    message_begin(cli->tool);
    struct table t = merge_tables(cli);
    struct old_names old = {0};
    run_getopt(&t, argc, argv, &old);
    message_level(quiet, verbose);
    for (size_t i = 0; i < old.n; i++)
        say("--%s is now --%s", old.item[i]->name, (const char *)old.item[i]->value);
    array_free(&old);
    if (help) {
        print_help(cli, &t, optind < argc && strcmp(argv[optind], "all") == 0);
        finish_stdout();
    }
    if (version) {
        printf("%s (cloudmill) %s\n", cli->tool, cloudmill_version);
        finish_stdout();
    }
    array_free(&t);
    cli->files = argc - optind;
    cli->file = argv + optind;
    if (cli->files == 0) {
        cli->files = 1;
        cli->file = only_standard_input;
    }
    check_output(cli);
}
