/* link - see link.h. */
#include "gouge/link.h"

#include <stdlib.h>

#include "gouge/axis_smooth.h"
#include "link_sweep.h"

enum { FEWEST_PARTS = 4, TURNED_PARTS = 8, MOST_PARTS = 256 };

static const double ARCH = 0.4;   /* times s (1 - s), of the length: a tenth in the middle */
static const double WIDEST = 3;   /* radii: of a turn's tangents */
static const double NARROW = 0.7; /* 1 + cosine of a turn's tangents to its chord, no less */
static const double SAME = 1e-6;  /* mm and radians: a point that says what the next one does */
static const double UNDER = 0.7;  /* of the radius: what of a ball must come up from a link */

/* One way to go: an arch of this height, times its length, lifted along normals or axes; or turned
 * from the direction of one row to that of the next. */
struct arch {
    double height;
    bool along_axis, turned;
};

/* Where an arch is before it is lifted: a cubic from place to place with these derivatives. */
struct base_curve {
    struct vec3 from, to, leave, arrive;
    bool straight;
};

/* A turned one has the length of a circle's tangents where both ends turn alike; a long one turns
 * no wider than the tool. */
static struct base_curve base_curve(const struct link_options *options,
                                    const struct run_point *from, const struct run_point *to,
                                    const struct arch *arch)
{
    struct base_curve c = {.from = from->ball, .to = to->ball, .straight = !arch->turned};
    struct vec3 chord = vec_sub(c.to, c.from), ahead = vec_unit(chord);
    double cosine = (vec_dot(options->leave, ahead) + vec_dot(options->arrive, ahead)) / 2;
    double length = 2 * vec_length(chord) / fmax(1 + cosine, NARROW);

    length = fmin(length, WIDEST * options->radius);

    c.leave = vec_scale(length, options->leave);
    c.arrive = vec_scale(length, options->arrive);
    return c;
}

static struct vec3 base_at(const struct base_curve *c, double s)
{
    double to = s * s * (3 - 2 * s), r = 1 - s;

    if (c->straight)
        return vec_mix(c->from, c->to, s);
    return vec_along(vec_along(vec_mix(c->from, c->to, to), s * r * r, c->leave), -s * s * r,
                     c->arrive);
}

/* How much of its height an arch has at s: a turned one begins and ends level. */
static double height_at(const struct arch *arch, double s)
{
    double rise = s * (1 - s);

    return arch->height * (arch->turned ? 4 * rise * rise : rise);
}

/* How the axis turns from one end of a link to the other. */
struct axis_way {
    const struct rotary_frame *frame; /* NULL: on the great circle */
    struct vec3 from, to;
    struct rotary_angles from_angles, to_angles;
};

static struct axis_way axis_way(const struct link_options *options, struct vec3 from,
                                struct vec3 to)
{
    struct axis_way way = {.frame = options->frame, .from = from, .to = to};

    if (way.frame) {
        way.from_angles =
            rotary_angles_near(way.frame, from, (struct rotary_angles){.lean = 0, .turn = 0});
        way.to_angles = rotary_angles_near(way.frame, to, way.from_angles);
        if (way.from_angles.lean == 0)
            way.from_angles.turn = way.to_angles.turn;
    }
    return way;
}

static struct vec3 axis_on(const struct axis_way *way, double s)
{
    if (!way->frame)
        return vec_slerp(way->from, way->to, s);
    return rotary_axis(way->frame, rotary_angles_between(way->from_angles, way->to_angles, s));
}

/* Number k of the parts' ends in order, with the pole among them; more than 1: there is none. */
static double end_of_part(const struct axis_way *way, size_t parts, size_t k)
{
    double pole = way->frame ? rotary_pole_between(way->from_angles, way->to_angles) : -1;
    double before = floor(pole * (double)parts);

    if (pole <= 0 || (double)k <= before)
        return (double)k / (double)parts;
    return (double)k == before + 1 ? pole : (double)(k - 1) / (double)parts;
}

static bool is_free_above(const struct link_options *options, struct vec3 ball)
{
    return gouge_free_above(options->lift->guard, ball, UNDER * options->lift->offset);
}

/* The arch in `parts` equal parts; false if its ball is not clear. */
static bool try_arch(const struct link_options *options, const struct run_point *from,
                     const struct run_point *to, const struct arch *arch, size_t parts,
                     struct run *link)
{
    const struct gouge_lift_options *lift = options->lift;
    struct vec3 up0 = arch->along_axis ? from->axis : link_outward(from);
    struct vec3 up1 = arch->along_axis ? to->axis : link_outward(to);
    double length = vec_distance(from->ball, to->ball), gone = 0;
    struct axis_way way = axis_way(options, from->axis, to->axis);
    struct base_curve base = base_curve(options, from, to, arch);
    struct run_point before = *from;
    /* A scan is a shell: beside its border there is a way under it, in the part. */
    bool open = is_free_above(options, from->ball) || is_free_above(options, to->ball);
    double s = 0;

    for (size_t i = 1; s < 1; i++) {
        s = end_of_part(&way, parts, i);
        double high = height_at(arch, s) * length;
        struct vec3 up = vec_slerp(up0, up1, s);
        struct run_point p = {.axis = s < 1 ? axis_on(&way, s) : to->axis};
        p.ball = vec_along(base_at(&base, s), high, up);
        double rise = s < 1 ? gouge_rise(lift->guard, p.ball, up, lift->offset) : 0;
        p.ball = vec_along(p.ball, rise, up);
        p.tip = vec_along(p.ball, -link->radius, p.axis);
        gone += vec_distance(before.ball, p.ball);
        if (rise > options->limit || (open && s < 1 && !is_free_above(options, p.ball)) ||
            (options->longest > 0 && gone > options->longest) ||
            gouge_depth_along(lift->guard, before.ball, p.ball, lift->offset) >
                LINK_FEED * lift->tolerance)
            return false;
        before = p;
        if (s < 1)
            *array_push(link) = p;
    }
    return true;
}

/* The rotary axes have all directions of a motion; NULL: any axes do. */
static bool is_in_travel(const struct kinematic_chain *chain, const struct run_point *from,
                         const struct run_point *to)
{
    return !chain ||
           (rotary_allows(chain, to->axis) && rotary_reaches_between(chain, from->axis, to->axis));
}

/* The axis stays within its travel, turns no faster than it may, and the whole tool is clear on
 * the straight motions of its tip, on the link from point `first` of it on. */
static bool is_link_free(const struct link_options *options, const struct run_point *from,
                         const struct run_point *to, const struct run *link, size_t first)
{
    struct link_sweep sweep = link_sweep_begin(options);
    struct run_point before = *from;
    bool is_free = true;

    sweep.tool.any = true;
    for (size_t i = first; i <= link->n && is_free; i++) {
        struct run_point ends[2] = {before, i < link->n ? link->item[i] : *to};
        struct run both = {.n = 2, .item = ends, .radius = options->radius};
        link_sweep_to(&sweep, &ends[0], &ends[1]);
        is_free = is_in_travel(options->chain, &ends[0], &ends[1]) && sweep.gouges.n == 0 &&
                  !(options->rate > 0 && axis_smooth_fastest(&both) > options->rate);
        before = ends[1];
    }
    link_sweep_end(&sweep);
    return is_free;
}

/* The axis passes the pole of the rotary axes here: the point stays. */
static bool is_at_pole(const struct link_options *options, const struct run_point *p)
{
    return options->frame && vec_length(vec_cross(options->frame->pole, p->axis)) < 1e-9;
}

/* The straight motion is clear of ball and whole tool, and turns no faster than it may. */
static bool is_way_clear(const struct link_options *options, const struct run_point *from,
                         const struct run_point *to)
{
    const struct run straight = {.radius = options->radius};

    return gouge_depth_along(options->lift->guard, from->ball, to->ball, options->lift->offset) <=
               LINK_FEED * options->lift->tolerance &&
           is_link_free(options, from, to, &straight, 0);
}

/* The way turns sharply at a point, and is clear without it. */
static bool is_spike(const struct link_options *options, const struct run_point *before,
                     const struct run_point *p, const struct run_point *after)
{
    struct vec3 up = vec_sub(p->ball, before->ball), down = vec_sub(p->ball, after->ball);
    bool turns = vec_distance(before->axis, p->axis) + vec_distance(p->axis, after->axis) > SAME;

    return vec_dot(up, down) > 0 && !(turns && is_at_pole(options, p)) &&
           is_way_clear(options, before, after);
}

/* Leaves out spikes of a link from point `first` on: beside a wall, say, that those next to it
 * touch as deep as they may, one went up to where the ball touches nothing. */
static void drop_spikes(const struct link_options *options, const struct run_point *from,
                        const struct run_point *to, struct run *link, size_t first)
{
    size_t kept = first;

    for (size_t i = first; i < link->n; i++) {
        const struct run_point *before = kept > first ? &link->item[kept - 1] : from;
        const struct run_point *after = i + 1 < link->n ? &link->item[i + 1] : to;
        if (!is_spike(options, before, &link->item[i], after))
            link->item[kept++] = link->item[i];
    }
    link->n = kept;
}

bool link_low(const struct link_options *options, const struct run_point *from,
              const struct run_point *to, struct run *link)
{
    static const struct arch arch[] = {{ARCH, false, true},
                                       {ARCH, false, false},
                                       {ARCH, true, false},
                                       {3 * ARCH, false, false},
                                       {3 * ARCH, true, false}};
    bool known = vec_length(options->leave) > 0 && vec_length(options->arrive) > 0;
    size_t n = link->n;

    if (!options->lift->guard)
        return is_link_free(options, from, to, link, n);
    for (size_t k = known ? 0 : 1; k < sizeof arch / sizeof *arch; k++) {
        size_t fewest = arch[k].turned ? TURNED_PARTS : FEWEST_PARTS;
        for (size_t parts = fewest; parts <= MOST_PARTS; parts *= 4) {
            link->n = n;
            if (!try_arch(options, from, to, &arch[k], parts, link) ||
                !is_link_free(options, from, to, link, n))
                continue;
            drop_spikes(options, from, to, link, n);
            return true;
        }
    }
    link->n = n;
    return false;
}

/* The point may be left out between two others: it is no further than `off` beside the straight
 * motion past it, on which the tool is clear. */
static bool is_spare(const struct link_options *options, const struct run_point *before,
                     const struct run_point *p, const struct run_point *after, double off)
{
    if (vec_distance(p->tip, after->tip) + vec_distance(p->axis, after->axis) < SAME)
        return true;
    return !is_at_pole(options, p) &&
           vec_segment_distance(before->ball, after->ball, p->ball) <= off &&
           is_way_clear(options, before, after);
}

/* A point that is too near to `fixed` goes on towards its other neighbour, `away`, until its tip is
 * `least` from it; at the pole it keeps its axis.  It touches nothing then.  False, and it stays:
 * it would come too near to `away`, or the tool would not be clear on both sides of it. */
static bool slide(const struct link_options *options, const struct run_point *fixed,
                  const struct run_point *away, double least, struct run_point *p)
{
    struct vec3 along = vec_sub(away->tip, p->tip), off = vec_sub(p->tip, fixed->tip);
    double a = vec_dot(along, along), b = vec_dot(along, off);
    double c = vec_dot(off, off) - least * least; /* a s^2 + 2 b s + c = 0, c < 0 */
    double s = a > 0 ? (sqrt(b * b - a * c) - b) / a : 1;
    struct run_point q = {.axis = p->axis, .given = p->given, .straight = p->straight};

    if (!(s < 1) || (1 - s) * sqrt(a) < least)
        return false;
    if (!is_at_pole(options, p))
        q.axis = vec_unit(vec_mix(p->axis, away->axis, s));
    q.tip = vec_along(p->tip, s, along);
    q.ball = vec_along(q.tip, options->radius, q.axis);
    if (!is_way_clear(options, fixed, &q) || !is_way_clear(options, &q, away))
        return false;
    *p = q;
    return true;
}

void link_thin(const struct link_options *options, const struct run_point *from,
               const struct run_point *to, double least, double off, struct run *link)
{
    size_t kept = 0;

    for (size_t i = 0; i < link->n; i++) {
        struct run_point p = link->item[i];
        const struct run_point *next = i + 1 < link->n ? &link->item[i + 1] : to;
        const struct run_point *before = kept > 0 ? &link->item[kept - 1] : from;
        bool near = vec_distance(p.tip, before->tip) < least;
        bool ends = i + 1 == link->n && vec_distance(p.tip, to->tip) < least;
        if ((near || ends) && is_spare(options, before, &p, next, off))
            continue;
        if (near && kept > 0 && is_spare(options, kept > 1 ? before - 1 : from, before, &p, off))
            kept--;
        else if (near)
            slide(options, before, next, least, &p);
        else if (ends)
            slide(options, to, before, least, &p);
        link->item[kept++] = p;
    }
    link->n = kept;
}

/* All points between two may be left out. */
static bool are_spare(const struct link_options *options, const struct run_point *before,
                      const struct run_point *p, size_t n, const struct run_point *after,
                      double off)
{
    for (size_t i = 0; i < n; i++)
        if (is_at_pole(options, &p[i]) ||
            vec_segment_distance(before->ball, after->ball, p[i].ball) > off ||
            vec_segment_distance(before->tip, after->tip, p[i].tip) > off)
            return false;
    return is_spare(options, before, p, after, off);
}

void link_straighten(const struct link_options *options, const struct run_point *from,
                     const struct run_point *to, double off, struct run *link)
{
    struct run_point before = *from;
    size_t kept = 0;

    for (size_t i = 0; i < link->n;) {
        size_t n = 0;
        while (i + n < link->n && are_spare(options, &before, &link->item[i], n + 1,
                                            i + n + 1 < link->n ? &link->item[i + n + 1] : to, off))
            n++;
        i += n;
        if (i == link->n)
            break;
        before = link->item[i];
        link->item[kept++] = link->item[i++];
    }
    link->n = kept;
}
