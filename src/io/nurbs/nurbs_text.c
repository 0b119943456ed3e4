/* nurbs_text - see nurbs_text.h. */
#include "nurbs_text.h"

#include <stdlib.h>
#include <string.h>

#include "base/array.h"
#include "io/cloud/cloud.h"
#include "base/num.h"
#include "io/nurbs/surfaces_scan.h"

/* Words come one after the other, lines do not matter. */
struct source {
    struct reader *reader;
    char *rest; /* of the line */
    char *word; /* the last one taken, NULL: the text has ended */
    double mm;
    bool unit_given; /* on the command line: the text's own is ignored */
    struct patches *patches;
    struct error *error;
};

/* What a surface needs, as its keywords come. */
struct draft {
    struct nurbs s;
    bool range;
    struct doubles weight;
    struct patch_loops loop;
    size_t line;
};

static int error_expected(const struct source *s, const char *expected)
{
    return error_at(s->error, s->reader->name, s->reader->line, "%s%.40s%s, expected %s",
                    s->word ? "'" : "", s->word ? s->word : "the end of the text",
                    s->word ? "'" : "", expected);
}

static int next_word(struct source *s)
{
    size_t n;
    s->word = NULL;
    for (;;) {
        char *from = s->rest ? s->rest + strspn(s->rest, " \t\r\f\v") : NULL;
        if (from && *from && *from != '#') {
            char *end = from + strcspn(from, " \t\r\f\v#");
            s->rest = *end == '#' ? NULL : *end ? end + 1 : end;
            *end = '\0';
            s->word = from;
            return 0;
        }
        if (from && *from == '#')
            surfaces_scan_line(from + 1 + strspn(from + 1, " "), &s->patches->scan);
        int got = reader_line(s->reader, &s->rest, &n, s->error);
        if (got <= 0)
            return got;
        if (memchr(s->rest, '\0', n))
            return error_at(s->error, s->reader->name, s->reader->line,
                            "a NUL byte, expected text");
    }
}

static bool is_word(const struct source *s, const char *word)
{
    return s->word && strcmp(s->word, word) == 0;
}

/* `n` finite numbers; none of them is made room for before it is there. */
static int read_finite(struct source *s, size_t n, struct doubles *to, const char *expected)
{
    to->n = 0;
    for (size_t i = 0; i < n; i++) {
        double x;
        if (next_word(s) < 0)
            return -1;
        if (!s->word || !num_whole(s->word, &x))
            return error_expected(s, expected);
        *array_push(to) = x;
    }
    return 0;
}

static int read_counts(struct source *s, double least, double most, int two[2],
                       const char *expected)
{
    struct doubles v = {0};
    int status = read_finite(s, 2, &v, expected);
    for (size_t i = 0; i < 2 && status == 0; i++)
        if (!(v.item[i] >= least && v.item[i] <= most) || v.item[i] > floor(v.item[i]))
            status = error_expected(s, expected);
        else
            two[i] = (int)v.item[i];
    array_free(&v);
    return status;
}

static int read_knots(struct source *s, struct nurbs_axis *axis)
{
    struct doubles v = {0};
    if (axis->poles == 0 || axis->degree == 0 || axis->knot)
        return error_expected(s, "degree and poles before the knots, and these once");
    if (read_finite(s, axis->poles + (size_t)axis->degree + 1, &v, "a knot, a finite number") < 0) {
        array_free(&v);
        return -1;
    }
    axis->knot = v.item;
    return 0;
}

static int read_points(struct source *s, struct nurbs *surface)
{
    struct doubles v = {0};
    size_t n = surface->u.poles * surface->v.poles;
    if (n == 0 || surface->pole)
        return error_expected(s, "poles before the points, and these once");
    int status = read_finite(s, 3 * n, &v, "a coordinate, a finite number");
    surface->pole = status == 0 ? mem_alloc(n, sizeof *surface->pole) : NULL;
    for (size_t i = 0; i < n && status == 0; i++) {
        const double *p = v.item + 3 * i;
        surface->pole[i] = (struct nurbs_pole){p[0] * s->mm, p[1] * s->mm, p[2] * s->mm, 1};
    }
    array_free(&v);
    return status;
}

static int read_range(struct source *s, struct draft *d)
{
    struct doubles v = {0};
    int status = read_finite(s, 4, &v, "four finite numbers for the range");
    if (status == 0) {
        d->s.u.from = v.item[0];
        d->s.u.to = v.item[1];
        d->s.v.from = v.item[2];
        d->s.v.to = v.item[3];
        d->range = true;
    }
    array_free(&v);
    return status;
}

/* Pairs u v up to the next word that is no number; the last joins the first. */
static int read_loop(struct source *s, struct draft *d)
{
    struct doubles v = {0};
    double x;
    struct patch_loop loop = {0};
    if (next_word(s) < 0)
        return -1;
    while (s->word && num_whole(s->word, &x) && fabs(x) <= NURBS_LARGEST) {
        *array_push(&v) = x;
        if (next_word(s) < 0) {
            array_free(&v);
            return -1;
        }
    }
    size_t n = v.n / 2;
    bool sound = n >= 3 && v.n % 2 == 0;
    for (size_t i = 0; i < n && sound; i++) {
        const double *p = v.item + 2 * i, *q = v.item + 2 * ((i + 1) % n);
        *array_push(&loop) = patch_line((struct uv){p[0], p[1]}, (struct uv){q[0], q[1]});
    }
    array_free(&v);
    if (!sound)
        return error_expected(s, "pairs u v of a loop, three at least");
    *array_push(&d->loop) = loop;
    return 0;
}

/* One keyword of a surface and what follows it; at its end the next word is taken. */
static int read_part(struct source *s, struct draft *d)
{
    int two[2] = {0, 0}, status;
    if (is_word(s, "loop"))
        return read_loop(s, d);
    if (is_word(s, "degree")) {
        status = read_counts(s, 1, NURBS_DEGREE_MAX, two, "two degrees, 1 to 25");
        if (status == 0) {
            d->s.u.degree = two[0];
            d->s.v.degree = two[1];
        }
    } else if (is_word(s, "poles")) {
        status = read_counts(s, 2, 1e6, two, "two counts of poles, 2 to 1000000");
        if (status == 0 && d->s.u.poles > 0)
            return error_expected(s, "poles once");
        if (status == 0) {
            d->s.u.poles = (size_t)two[0];
            d->s.v.poles = (size_t)two[1];
        }
    } else if (is_word(s, "knots_u")) {
        status = read_knots(s, &d->s.u);
    } else if (is_word(s, "knots_v")) {
        status = read_knots(s, &d->s.v);
    } else if (is_word(s, "points")) {
        status = read_points(s, &d->s);
    } else if (is_word(s, "weights")) {
        status = d->s.u.poles == 0 ? error_expected(s, "poles before the weights")
                                   : read_finite(s, d->s.u.poles * d->s.v.poles, &d->weight,
                                                 "a weight, a finite number");
    } else if (is_word(s, "range")) {
        status = read_range(s, d);
    } else {
        return error_expected(
            s, "degree, poles, knots_u, knots_v, points, weights, range, loop, surface "
               "or end");
    }
    return status < 0 ? -1 : next_word(s);
}

static int finish(struct source *s, struct draft *d)
{
    struct error why;
    if (!d->s.u.knot || !d->s.v.knot || !d->s.pole)
        return error_at(s->error, s->reader->name, d->line, "a surface without %s, expected it",
                        !d->s.pole     ? "points"
                        : !d->s.u.knot ? "knots_u"
                                       : "knots_v");
    if (!d->range) {
        d->s.u.from = d->s.v.from = -HUGE_VAL;
        d->s.u.to = d->s.v.to = HUGE_VAL;
    }
    if (nurbs_axis_check(&d->s.u, "u", &why) < 0 || nurbs_axis_check(&d->s.v, "v", &why) < 0)
        return error_at(s->error, s->reader->name, d->line, "%s", why.text);
    for (size_t i = 0; i < d->weight.n; i++) {
        struct nurbs_pole *p = &d->s.pole[i];
        double w = d->weight.item[i];
        if (!(w > 0))
            return error_at(s->error, s->reader->name, d->line,
                            "weight %g of pole %zu, expected a positive one", w, i + 1);
        *p = (struct nurbs_pole){w * p->wx, w * p->wy, w * p->wz, w};
    }
    return 0;
}

static int read_surface(struct source *s)
{
    struct draft d = {.line = s->reader->line};
    int status = next_word(s);
    while (status == 0 && s->word && !is_word(s, "surface") && !is_word(s, "end"))
        status = read_part(s, &d);
    if (status == 0)
        status = finish(s, &d);
    array_free(&d.weight);
    struct patch *patch = array_push(s->patches);
    *patch = (struct patch){.surface = d.s, .loop = d.loop};
    return status;
}

static int read_unit(struct source *s)
{
    if (next_word(s) < 0)
        return -1;
    double mm = s->word ? cloud_unit(s->word) : 0;
    if (!(mm > 0))
        return error_expected(s, "a unit: mm, cm, m, um or inch");
    if (!s->unit_given)
        s->mm = mm;
    return next_word(s);
}

int nurbs_text_read(struct reader *r, double mm, struct patches *patches, struct error *error)
{
    struct source s = {.reader = r,
                       .mm = mm > 0 ? mm : 1,
                       .unit_given = mm > 0,
                       .patches = patches,
                       .error = error};
    size_t before = patches->n;
    if (next_word(&s) < 0)
        return -1;
    if (!is_word(&s, "nurbs"))
        return error_expected(&s, "nurbs 1");
    if (next_word(&s) < 0)
        return -1;
    if (!is_word(&s, "1"))
        return error_expected(&s, "1, the version of the text");
    if (next_word(&s) < 0 || (is_word(&s, "unit") && read_unit(&s) < 0))
        return -1;
    for (int number = 1; is_word(&s, "surface"); number++) {
        if (read_surface(&s) < 0)
            return -1;
        struct patch *patch = &patches->item[patches->n - 1];
        patch->entity = number;
        patch->file = mem_string(r->name, strlen(r->name));
    }
    if (!is_word(&s, "end") || patches->n == before)
        return error_expected(&s, patches->n == before ? "surface" : "surface or end");
    return 0;
}
