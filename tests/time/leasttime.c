/*
 * leasttime - the least time of a Siemens program of lines and arcs on a trunnion table (A carries
 * C, the part on the turning centre), by code that shares nothing with the suite: it reads the
 * words itself, turns tool vectors into angles itself, and drives the five axes along the way as
 * fast as their largest speeds and accelerations allow.
 *
 *   leasttime PROGRAM [FEED]
 *
 * FEED: mm/min that was asked for, by which the ideal time counts the way cut; else each block's F.
 * The machine: 30 m/min and 3 m/s^2 on X Y Z, 20 rev/min and 1,000 degrees/s^2 on A C; the control
 * rounds the axes' ways by a mean over 0.2 mm.  With LOST in the environment the lines that lose
 * time are on standard error: line, seconds, mm/s.  Prints one line:
 *
 *   least MIN  ideal MIN  ratio R  turn-A DEG  turn-C DEG  motions N  over N  most R
 *
 * over: blocks that ask an axis for more than its largest speed at the F that is printed; most: how
 * much more.  Exit 1: the program cannot be read.
 */
#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { AXES = 5 };
static const double PI = 3.14159265358979323846;
static const double fastest[AXES] = {500, 500, 500, 120, 120};       /* mm/s, degrees/s */
static const double quickest[AXES] = {3000, 3000, 3000, 1000, 1000}; /* mm/s^2, degrees/s^2 */
static const double step = 0.04, rounding = 0.2;                     /* mm */
static const double narrow =
    0.02; /* mm: what an axis has to do is looked at over no less, if a block
                                      has two of that */
static const double per_degree = 0.05; /* mm that a degree counts where the tip hardly moves */

struct v {
    double x, y, z;
};

struct place {
    struct v p, a;
    double q[2]; /* A, C: degrees */
};

struct sample {
    double axis[AXES], feed; /* mm/s */
    long line;
};

struct run {
    long n, cap;
    struct sample *s;
    double carry;
};

struct sums {
    double least, ideal, turn[2], most;
    long motions, over;
};

static struct v mix(struct v a, double s, struct v b)
{
    return (struct v){a.x + s * b.x, a.y + s * b.y, a.z + s * b.z};
}

static double dot(struct v a, struct v b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

static struct v cross(struct v a, struct v b)
{
    return (struct v){a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

static struct v times(double s, struct v a)
{
    return (struct v){s * a.x, s * a.y, s * a.z};
}

static double length(struct v a)
{
    return sqrt(dot(a, a));
}

/* The tool as the part sees it when the table stands at A, C: the part turns by C about z, then by
 * A about x, and the tool stands along z. */
static struct v tool_of(const double q[2])
{
    double a = q[0] * PI / 180, c = q[1] * PI / 180;
    return (struct v){sin(a) * sin(c), sin(a) * cos(c), cos(a)};
}

/* The angles of a tool vector nearest to those before. */
static void angles_of(struct v a, const double before[2], double q[2])
{
    double tilt = atan2(hypot(a.x, a.y), a.z) * 180 / PI, best = HUGE_VAL;
    bool leans = hypot(a.x, a.y) > 1e-7;
    for (int k = 0; k < 2; k++) {
        double A = k ? -tilt : tilt;
        double C = leans ? atan2(a.x, a.y) * 180 / PI + 180 * k : before[1];
        C += 360 * round((before[1] - C) / 360);
        double off = fabs(A - before[0]) + fabs(C - before[1]);
        if (off < best) {
            best = off;
            q[0] = A;
            q[1] = C;
        }
    }
}

static void axes_of(struct v p, const double q[2], double axis[AXES])
{
    double a = q[0] * PI / 180, c = q[1] * PI / 180;
    struct v t = {p.x * cos(c) - p.y * sin(c), p.x * sin(c) + p.y * cos(c), p.z};
    axis[0] = t.x;
    axis[1] = t.y * cos(a) - t.z * sin(a);
    axis[2] = t.y * sin(a) + t.z * cos(a);
    axis[3] = q[0];
    axis[4] = q[1];
}

/* ---- a block */

struct block {
    struct place from, to;
    struct v centre, u, w; /* of an arc: its centre, and two directions at right angles */
    double sweep, radius, feed;
    bool arc, vectors;
};

/* Through the three points; false: they are in a line. */
static bool arc_through(struct block *b, struct v mid)
{
    struct v x = mix(mid, -1, b->from.p), y = mix(b->to.p, -1, b->from.p), n = cross(x, y);
    double n2 = dot(n, n);
    if (n2 < 1e-18)
        return false;
    struct v r = mix(times(dot(x, x), cross(y, n)), dot(y, y), cross(n, x));
    r = times(1 / (2 * n2), r);
    b->centre = mix(b->from.p, 1, r);
    b->radius = length(r);
    b->u = times(-1 / b->radius, r);
    b->w = cross(times(1 / sqrt(n2), n), b->u);
    struct v end = mix(b->to.p, -1, b->centre);
    b->sweep = atan2(dot(end, b->w), dot(end, b->u));
    if (b->sweep <= 0)
        b->sweep += 2 * PI;
    return true;
}

static void place_at(const struct block *b, double s, const double before[2], struct place *at)
{
    at->p = mix(b->from.p, s, mix(b->to.p, -1, b->from.p));
    if (b->arc) {
        double t = s * b->sweep;
        at->p = mix(mix(b->centre, b->radius * cos(t), b->u), b->radius * sin(t), b->w);
    }
    if (!b->vectors) {
        for (int k = 0; k < 2; k++)
            at->q[k] = b->from.q[k] + s * (b->to.q[k] - b->from.q[k]);
        return;
    }
    double turn = atan2(length(cross(b->from.a, b->to.a)), dot(b->from.a, b->to.a));
    at->a = turn < 1e-9 ? b->to.a
                        : times(1 / sin(turn),
                                mix(times(sin((1 - s) * turn), b->from.a), sin(s * turn), b->to.a));
    angles_of(at->a, before, at->q);
}

static double way_between(const struct place *a, const struct place *b)
{
    double turn = fmax(fabs(a->q[0] - b->q[0]), fabs(a->q[1] - b->q[1]));
    return fmax(length(mix(b->p, -1, a->p)), per_degree * turn);
}

static void add_sample(struct run *run, const struct place *at, double feed, long line)
{
    if (run->n == run->cap) {
        run->cap = run->cap ? 2 * run->cap : 1024;
        run->s = realloc(run->s, (size_t)run->cap * sizeof *run->s);
        if (!run->s)
            exit(1);
    }
    struct sample *s = &run->s[run->n++];
    axes_of(at->p, at->q, s->axis);
    s->feed = feed;
    s->line = line;
}

/* How fast along its way a block is at its F, which is the tip's, or counts degrees where that
 * stands. */
static double speed_of(const struct block *b)
{
    enum { LOOKS = 64 };
    double way = 0, tip = 0;
    struct place at = b->from, last = b->from;
    for (int i = 1; i <= LOOKS; i++) {
        place_at(b, (double)i / LOOKS, last.q, &at);
        way += way_between(&last, &at);
        tip += length(mix(at.p, -1, last.p));
        last = at;
    }
    return tip > 1e-5 ? b->feed * way / tip : b->feed * per_degree;
}

/* The block in even steps; what it turns, how long it is, and what its axes would have to do. */
static void follow(struct run *run, struct block *b, struct sums *sums, double own, long line)
{
    enum { LOOKS = 256 };
    struct place at = b->from, last = b->from;
    double way = 0, tip = 0, mark_tip = 0, least = 0, mark = step - run->carry, speed = speed_of(b);
    double whole = b->arc ? b->radius * b->sweep : length(mix(b->to.p, -1, b->from.p));
    int every = (int)fmin(LOOKS / 2, ceil(narrow / fmax(whole, 1e-6) * LOOKS));
    struct place mark_at = b->from;
    for (int i = 1; i <= LOOKS; i++) {
        double axis[AXES], old[AXES];
        place_at(b, (double)i / LOOKS, last.q, &at);
        double h = way_between(&last, &at), along = length(mix(at.p, -1, last.p));
        axes_of(mark_at.p, mark_at.q, old);
        axes_of(at.p, at.q, axis);
        double over = tip + along - mark_tip; /* what F counts: along the arc, not its chord */
        for (int k = 0; k < AXES && i % every == 0 && over > 1e-6; k++)
            least = fmax(least, fabs(axis[k] - old[k]) / fastest[k] / (over / b->feed));
        if (i % every == 0) {
            mark_at = at;
            mark_tip = tip + along;
        }
        for (int k = 0; k < 2; k++)
            sums->turn[k] += fabs(at.q[k] - last.q[k]);
        for (; h > 0 && mark <= way + h; mark += step) {
            struct place here;
            place_at(b, (i - 1 + (mark - way) / h) / LOOKS, last.q, &here);
            add_sample(run, &here, speed, line);
        }
        way += h;
        tip += along;
        last = at;
    }
    run->carry = way - (mark - step);
    b->to.q[0] = last.q[0];
    b->to.q[1] = last.q[1];
    sums->ideal += own > 0 ? tip / own : tip / b->feed / 60;
    sums->motions++;
    if (least > 1.01) {
        sums->over++;
        sums->most = fmax(sums->most, least);
    }
}

/* ---- a stretch at feed, from standstill to standstill */

static void round_off(struct run *run)
{
    long half = (long)(rounding / step / 2 + 0.5);
    struct sample *mean = malloc((size_t)(run->n ? run->n : 1) * sizeof *mean);
    if (!mean)
        exit(1);
    for (long i = 0; i < run->n; i++) {
        long h = half < i ? half : i;
        h = h < run->n - 1 - i ? h : run->n - 1 - i;
        mean[i] = run->s[i];
        for (int k = 0; k < AXES; k++) {
            double sum = 0;
            for (long j = i - h; j <= i + h; j++)
                sum += run->s[j].axis[k];
            mean[i].axis[k] = sum / (double)(2 * h + 1);
        }
    }
    free(run->s);
    run->s = mean;
    run->cap = run->n ? run->n : 1;
}

/* How fast along the way, by what its ways per mm and their changes ask of each axis. */
static double fastest_at(const struct run *run, long i, double d1[AXES], double d2[AXES])
{
    const struct sample *s = run->s + i;
    double v = s->feed;
    for (int k = 0; k < AXES; k++) {
        d1[k] = (s[1].axis[k] - s[-1].axis[k]) / (2 * step);
        d2[k] = (s[1].axis[k] - 2 * s[0].axis[k] + s[-1].axis[k]) / (step * step);
        if (d1[k] != 0)
            v = fmin(v, fastest[k] / fabs(d1[k]));
        if (d2[k] != 0)
            v = fmin(v, sqrt(quickest[k] / fabs(d2[k])));
    }
    return v;
}

/* How much faster it can be a step on: what the bend of the way leaves of each acceleration. */
static double faster(const struct run *run, long i, double v)
{
    double d1[AXES], d2[AXES], most = HUGE_VAL;
    fastest_at(run, i, d1, d2);
    for (int k = 0; k < AXES; k++)
        if (d1[k] != 0)
            most = fmin(most, fmax(0, quickest[k] - fabs(d2[k]) * v * v) / fabs(d1[k]));
    return sqrt(v * v + 2 * step * most);
}

static void time_run(struct run *run, struct sums *sums, const char *lost)
{
    long n = run->n;
    run->carry = 0;
    run->n = 0;
    if (n < 3)
        return;
    run->n = n;
    round_off(run);
    double *v = malloc((size_t)n * sizeof *v);
    if (!v)
        exit(1);
    for (long i = 0; i < n; i++) {
        double d1[AXES], d2[AXES];
        v[i] = i == 0 || i == n - 1 ? 0 : fastest_at(run, i, d1, d2);
    }
    for (long i = 1; i < n - 1; i++)
        v[i] = fmin(v[i], i == 1 ? v[1] : faster(run, i - 1, v[i - 1]));
    for (long i = n - 2; i > 0; i--)
        v[i] = fmin(v[i], i == n - 2 ? v[i] : faster(run, i + 1, v[i + 1]));
    for (long i = 1; i < n; i++) {
        double t = 2 * step / fmax(v[i] + v[i - 1], 1e-6);
        sums->least += t / 60;
        if (lost && t > 3 * step / run->s[i].feed)
            fprintf(stderr, "%ld %.4f %.3f\n", run->s[i].line, t - step / run->s[i].feed, v[i]);
    }
    free(v);
    run->n = 0;
}

/* ---- the words of a block */

static bool word(const char *line, const char *name, double *value)
{
    size_t n = strlen(name);
    for (const char *p = line; (p = strstr(p, name)) != NULL; p++) {
        bool starts = p == line || p[-1] == ' ';
        const char *at = p + n;
        if (!starts)
            continue;
        if (*at == '=')
            at++;
        if (strncmp(at, "AC(", 3) == 0 || strncmp(at, "DC(", 3) == 0)
            at += 3;
        if (!strchr("0123456789-+.", *at) || *at == '\0')
            continue;
        char *end;
        double number = strtod(at, &end);
        if (*end == '=') /* A3= is not A */
            continue;
        *value = number;
        return true;
    }
    return false;
}

static bool has(const char *line, const char *name)
{
    size_t n = strlen(name);
    for (const char *p = line; (p = strstr(p, name)) != NULL; p++)
        if ((p == line || p[-1] == ' ') && (p[n] == ' ' || p[n] == '\n' || p[n] == '\0'))
            return true;
    return false;
}

int main(int argc, char **argv)
{
    FILE *f = argc > 1 ? fopen(argv[1], "r") : NULL;
    double own = argc > 2 ? atof(argv[2]) : 0, feed = 0, value;
    const char *lost = getenv("LOST");
    char line[4096];
    struct sums sums = {0};
    struct run run = {0};
    struct place at = {.a = {0, 0, 1}};
    enum { RAPID, LINE, ARC } kind = RAPID;
    bool tcp = false;
    if (!f)
        return fprintf(stderr, "usage: leasttime PROGRAM [FEED]\n"), 1;
    for (long number = 1; fgets(line, sizeof line, f); number++) {
        struct block b = {.from = at, .to = at};
        struct v mid = at.p;
        if (line[0] == ';' || line[0] == '%')
            continue;
        if (strstr(line, "POLY") || strstr(line, "BSPLINE") || strstr(line, "PO["))
            return fprintf(stderr, "%s:%ld: found a curve\n", argv[1], number), 1;
        tcp = (tcp || strstr(line, "TRAORI")) && !strstr(line, "TRAFOOF");
        kind = has(line, "G0") ? RAPID : has(line, "G1") ? LINE : has(line, "CIP") ? ARC : kind;
        if (word(line, "F", &value))
            feed = value;
        bool moves = false, turns = false, vectors = false;
        double *const to[] = {&b.to.p.x, &b.to.p.y, &b.to.p.z, &b.to.q[0], &b.to.q[1], &b.to.a.x,
                              &b.to.a.y, &b.to.a.z, &mid.x,    &mid.y,     &mid.z};
        const char *const name[] = {"X", "Y", "Z", "A", "C", "A3", "B3", "C3", "I1", "J1", "K1"};
        for (int i = 0; i < 11; i++)
            if (word(line, name[i], to[i])) {
                moves = moves || i < 3;
                turns = turns || i == 3 || i == 4;
                vectors = vectors || (i > 4 && i < 8);
            }
        if (!moves && !turns && !vectors)
            continue;
        if (turns) {
            b.to.q[1] += 360 * round((at.q[1] - b.to.q[1]) / 360);
            b.to.a = tool_of(b.to.q);
        }
        if (vectors)
            b.to.a = times(1 / length(b.to.a), b.to.a);
        b.vectors = !turns;
        b.arc = kind == ARC && arc_through(&b, mid);
        b.feed = feed / 60;
        if (kind != RAPID && tcp && b.feed > 0) {
            follow(&run, &b, &sums, own, number);
        } else {
            struct place end;
            time_run(&run, &sums, lost);
            place_at(&b, 1, at.q, &end);
            b.to.q[0] = end.q[0];
            b.to.q[1] = end.q[1];
        }
        at = b.to;
    }
    time_run(&run, &sums, lost);
    printf("least %.3f  ideal %.3f  ratio %.3f  turn-A %.0f  turn-C %.0f  motions %ld  over %ld  "
           "most %.2f\n",
           sums.least, sums.ideal, sums.ideal > 0 ? sums.least / sums.ideal : 0, sums.turn[0],
           sums.turn[1], sums.motions, sums.over, sums.most);
    free(run.s);
    fclose(f);
    return 0;
}
