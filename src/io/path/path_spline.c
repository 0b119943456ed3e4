/* path_spline - see path_spline.h. */
#include "path_spline.h"

#include <stdlib.h>
#include <string.h>

#include "math/elementary.h"

/* -1: an argument after the first is not a number. */
static int expect_numbers(const struct apt *apt, const char *name, struct error *error)
{
    for (size_t i = 1; i < apt->argument.n; i++)
        if (!apt->argument.item[i].is_number)
            return error_at(error, name, apt->line,
                            "found `%.40s` in MOVNRB, expected a finite number",
                            apt->argument.item[i].text);
    return 0;
}

static int begin_spline(struct spline_parse *s, const struct apt *apt, const char *name,
                        double unit, struct pose at, struct error *error)
{
    if (s->stage != SPLINE_NONE)
        return error_at(error, name, apt->line,
                        "found MOVNRB/%.20s within another MOVNRB, expected "
                        "MOVNRB/OFF first",
                        apt->argument.item[0].text);
    s->from = at;
    s->five_axes = apt_is(apt, 0, "5AXIS");
    s->length = 0;
    if (s->five_axes) {
        if (!apt_is(apt, 1, "LENGTH") ||
            apt_numbers(apt, name, 2, 1, &s->length, "length", error) < 0 || !(s->length > 0))
            return error_at(error, name, apt->line,
                            "found MOVNRB/5AXIS without its length, expected LENGTH and a number "
                            "above 0");
        s->length *= unit;
    }
    s->stage = SPLINE_BEGUN;
    return 0;
}

/* MOVNRB/ON,order,knots,weights,poles,length */
static int read_sizes(struct spline_parse *s, const struct apt *apt, const char *name,
                      struct error *error)
{
    double v[4];
    if (apt_numbers(apt, name, 1, 4, v, "order, knots, weights, poles", error) < 0)
        return -1;
    if (v[2] != 0)
        return error_at(error, name, apt->line, "found MOVNRB with weights, expected none (0)");
    if (!(v[0] >= 2 && v[0] <= BSPLINE_DEGREE_MAX + 1 && v[0] == floor(v[0])) ||
        !(v[3] >= v[0] && v[3] <= 1e7 && v[3] == floor(v[3])) || v[1] != v[0] + v[3])
        return error_at(error, name, apt->line,
                        "found MOVNRB of order %g with %g knots and %g poles, expected order 2 to "
                        "10, no fewer poles, and knots = poles + order",
                        v[0], v[1], v[3]);
    s->degree = (int)v[0] - 1;
    s->knots = (size_t)v[1];
    s->poles = (size_t)v[3];
    s->stage = SPLINE_DATA;
    return 0;
}

static int read_knots(struct spline_parse *s, const struct apt *apt, const char *name,
                      struct error *error)
{
    if (apt->argument.n != s->knots + 1)
        return error_at(error, name, apt->line, "found %zu knots in MOVNRB/1, expected %zu",
                        apt->argument.n - 1, s->knots);
    size_t order = (size_t)s->degree + 1;
    for (size_t i = 0; i < s->knots; i++)
        *array_push(&s->knot) = apt->argument.item[i + 1].number;
    const double *k = s->knot.item;
    for (size_t i = 1; i < s->knots; i++)
        if (k[i] < k[i - 1])
            return error_at(error, name, apt->line,
                            "found knot %zu below the one before, expected "
                            "rising knots",
                            i + 1);
    for (size_t i = 1; i + order < s->knots; i++)
        if (k[i] == k[i + order - 1])
            return error_at(error, name, apt->line,
                            "found knot %zu more than %d times, expected a curve without gaps",
                            i + order, s->degree);
    if (k[0] != k[order - 1] || k[s->knots - 1] != k[s->knots - order] || !(k[s->knots - 1] > k[0]))
        return error_at(error, name, apt->line,
                        "found end knots that are not repeated %zu times, "
                        "expected that",
                        order);
    return 0;
}

static int read_poles(struct spline_parse *s, const struct apt *apt, const char *name, double unit,
                      struct vec3s *pole, struct error *error)
{
    if (apt->argument.n != 3 * s->poles + 1)
        return error_at(error, name, apt->line, "found %zu numbers in MOVNRB/%s, expected %zu",
                        apt->argument.n - 1, apt->argument.item[0].text, 3 * s->poles);
    for (size_t i = 1; i + 2 < apt->argument.n; i += 3) {
        struct vec3 at = vec(apt->argument.item[i].number, apt->argument.item[i + 1].number,
                             apt->argument.item[i + 2].number);
        if (!(unit * vec_length(at) < 1e8))
            return error_at(error, name, apt->line,
                            "found a pole too far for any machine, expected less than 1e8 mm");
        *array_push(pole) = vec_scale(unit, at);
    }
    return 0;
}

/* -1: a part is missing, or the curve does not start where the tool is. */
static int expect_whole(const struct spline_parse *s, const struct apt *apt, const char *name,
                        struct error *error)
{
    size_t heads = s->five_axes ? s->poles : 0;
    if (s->knot.n != s->knots || s->pole.n != s->poles || s->head.n != heads)
        return error_at(error, name, apt->line,
                        "found MOVNRB/NEXT with %zu knots, %zu poles and %zu head poles, expected "
                        "%zu, %zu and %zu",
                        s->knot.n, s->pole.n, s->head.n, s->knots, s->poles, heads);
    if (vec_distance(s->pole.item[0], s->from.p) > 0.01)
        return error_at(error, name, apt->line,
                        "found the first pole %.4f mm from where the tool is, expected it there",
                        vec_distance(s->pole.item[0], s->from.p));
    for (size_t i = 0; i<s->head.n; i += s->head.n> 1 ? s->head.n - 1 : 1)
        if (fabs(vec_distance(s->head.item[i], s->pole.item[i]) - s->length) > 0.01)
            return error_at(error, name, apt->line,
                            "found a head %.4f mm from its tip, expected the "
                            "LENGTH %.4f",
                            vec_distance(s->head.item[i], s->pole.item[i]), s->length);
    return 0;
}

int spline_parse(struct spline_parse *s, const struct apt *apt, const char *name, double unit,
                 struct pose at, struct error *error)
{
    if (apt_is(apt, 0, "5AXIS") || apt_is(apt, 0, "M3AXIS"))
        return begin_spline(s, apt, name, unit, at, error);
    if (apt_is(apt, 0, "ON") && s->stage == SPLINE_BEGUN)
        return read_sizes(s, apt, name, error);
    if (apt_is(apt, 0, "OFF") && s->stage == SPLINE_FALLBACK)
        return 1;
    if (s->stage == SPLINE_DATA) {
        if (expect_numbers(apt, name, error) < 0)
            return -1;
        if (apt_is(apt, 0, "1") && !s->knot.n)
            return read_knots(s, apt, name, error);
        if (apt_is(apt, 0, "2") && !s->pole.n)
            return read_poles(s, apt, name, unit, &s->pole, error);
        if (apt_is(apt, 0, "3") && s->five_axes && !s->head.n)
            return read_poles(s, apt, name, unit, &s->head, error);
        if (apt_is(apt, 0, "NEXT")) {
            s->stage = SPLINE_FALLBACK;
            return expect_whole(s, apt, name, error);
        }
    }
    return error_at(error, name, apt->line,
                    "found MOVNRB/%.20s out of its order, expected 5AXIS or "
                    "M3AXIS, ON, 1, 2, 3, NEXT, OFF",
                    apt->argument.n ? apt->argument.item[0].text : "");
}

void spline_parse_point(struct spline_parse *s, struct pose pose)
{
    *array_push(&s->fallback) = pose;
}

struct path_spline spline_parse_finish(struct spline_parse *s, struct pose *end)
{
    struct bspline c = bspline_new(s->degree, s->poles, s->five_axes);
    memcpy(c.knot, s->knot.item, s->knots * sizeof *c.knot);
    memcpy(c.pole, s->pole.item, s->poles * sizeof *c.pole);
    if (s->five_axes)
        memcpy(c.head, s->head.item, s->poles * sizeof *c.head);
    c.length = s->length;
    end->p = c.pole[s->poles - 1];
    end->a = s->five_axes ? vec_unit(vec_sub(c.head[s->poles - 1], end->p)) : s->from.a;
    struct path_spline spline = {.curve = c,
                                 .fallback = {s->fallback.n, s->fallback.cap, s->fallback.item}};
    memset(&s->fallback, 0, sizeof s->fallback);
    spline_parse_free(s);
    return spline;
}

void spline_parse_free(struct spline_parse *s)
{
    array_free(&s->knot);
    array_free(&s->pole);
    array_free(&s->head);
    array_free(&s->fallback);
    memset(s, 0, sizeof *s);
}
