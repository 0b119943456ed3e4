/* post_words - see post_words.h. */
#include "post_words.h"

#include <string.h>

#include "base/num.h"
#include "machine/template.h"
#include "post_feed.h"

/* ---- blocks that a machine file words itself */

enum { ROOM = 200 };

/* 1 at 0.1 mm and above, for speed, to 10 at 0.001 mm and below, for accuracy. */
static double smoothing_level(double tolerance)
{
    return fmin(10, fmax(1, round(1 + 4.5 * log10(0.1 / tolerance))));
}

static size_t template_value(const struct nc_program *p, enum template_word word, char *text)
{
    const struct nc_tooling *t = &p->tooling;
    if (word >= TEMPLATE_PLANE) {
        struct nc_plane plane = {0};
        if (p->at_plane < p->planes.n)
            plane = p->planes.item[p->at_plane];
        const double angle[] = {plane.a, plane.b, plane.i, plane.j, plane.k};
        int i = (int)word - TEMPLATE_PLANE;
        bool sign = p->w.style.sign && angle[i] >= 0;
        *text = '+';
        return sign + num_write_short(text + sign, angle[i], p->plan->ability.digits.angle,
                                      p->w.style.point);
    }
    const double values[TEMPLATE_PLANE] = {[TEMPLATE_TOOL] = t->number ? t->number : 1,
                                           [TEMPLATE_OFFSET] = t->offset,
                                           [TEMPLATE_RPM] = t->spindle,
                                           [TEMPLATE_TOLERANCE] = p->options.chord,
                                           [TEMPLATE_ORIENTATION] =
                                               DEGREES(p->options.axis_tolerance),
                                           [TEMPLATE_LEVEL] = smoothing_level(p->options.chord)};
    bool angle_or_length = word == TEMPLATE_TOLERANCE || word == TEMPLATE_ORIENTATION;
    return num_write_short(text, values[word], angle_or_length ? 4 : 0, false);
}

/* A key whose value is `none` words no block. */
void nc_template(struct nc_program *p, const char *own, const char *usual)
{
    if (strcmp(own, "none") == 0)
        return;
    char block[ROOM + NUM_MAX];
    size_t n = 0;
    for (const char *s = *own ? own : usual;; s++) {
        size_t length;
        enum template_word word = template_word(s, &length);
        if (word != TEMPLATE_NONE) {
            n += template_value(p, word, block + n);
            s += length - 1;
        } else if (*s && *s != '|') {
            block[n++] = *s;
        } else {
            block[n] = '\0';
            while (n && block[n - 1] == ' ')
                block[--n] = '\0';
            if (n)
                nc_block(&p->w, block + strspn(block, " "));
            n = 0;
        }
        if (!*s)
            return;
        if (n > ROOM)
            n = ROOM;
    }
}

/* ---- words */

struct vec3 nc_above_plane(const struct nc_program *p, const struct nc_move *first)
{
    return post_frame_work(p->planes.item[p->at_plane], dialect_of(p->control)->plane_euler,
                           p->plan->ability.digits.angle, first->p);
}

bool nc_zero_first(const struct nc_program *p)
{
    return p->plan->ability.tcp && p->machine->tcp_frame == TCP_FRAME_ZERO && p->machine->chain.n;
}

/* The rotary axes at zero, or as near as their travel lets them be. */
static void zero_angles(const struct nc_program *p, double q[])
{
    for (int i = 0; i < ROTARY_MAX; i++) {
        const struct rotary *r = &p->machine->chain.rotary[i];
        q[i] = i < p->machine->chain.n ? fmin(fmax(0, r->min), r->max) : 0;
    }
}

void nc_rotary_start(struct nc_program *p, const struct nc_move *first)
{
    double zero[ROTARY_MAX];
    zero_angles(p, zero);
    nc_rotary(p, nc_zero_first(p) ? zero : first->q);
}

const struct nc_move *nc_first_move(const struct nc_program *p)
{
    const struct nc_move *move = p->plan->move.item + p->tooling.next;
    while (!nc_moves(move))
        move++;
    return move;
}

void nc_place(struct nc_program *p, struct vec3 to)
{
    int digits = p->plan->ability.digits.linear;
    nc_modal(&p->w, NC_X, "X", to.x, digits);
    nc_modal(&p->w, NC_Y, "Y", to.y, digits);
    nc_modal(&p->w, NC_Z, "Z", to.z, digits);
}

static void vector_words(struct nc_program *p, const char *const address[3], struct vec3 a)
{
    struct nc_writer *w = &p->w;
    if (w->known[NC_I] && w->value[NC_I] == a.x && w->value[NC_J] == a.y && w->value[NC_K] == a.z)
        return;
    nc_forget(w, NC_I, NC_K);
    nc_modal(w, NC_I, address[0], a.x, p->plan->ability.digits.vector);
    nc_modal(w, NC_J, address[1], a.y, p->plan->ability.digits.vector);
    nc_modal(w, NC_K, address[2], a.z, p->plan->ability.digits.vector);
}

void nc_rotary_axes(struct nc_program *p, int n, const double q[])
{
    const struct machine *m = p->machine;
    for (int i = n - 1; i >= 0; i--) { /* the tilting axis first, as people write it */
        const char address[2] = {machine_letter(m->letter[i]), '\0'};
        nc_modal(&p->w, i ? NC_Q1 : NC_Q0, address, DEGREES(q[i]), p->plan->ability.digits.angle);
    }
}

void nc_rotary(struct nc_program *p, const double q[])
{
    nc_rotary_axes(p, p->machine->chain.n, q);
}

void nc_home(struct nc_program *p, const char *usual)
{
    nc_template(p, p->machine->blocks.home, usual);
    nc_forget(&p->w, NC_X, NC_Z);
    p->w.motion = NULL;
}

void nc_axis(struct nc_program *p, const struct nc_move *move, const char *const address[3])
{
    if (p->plan->ability.mode == INTERPOLATE_VECTOR)
        vector_words(p, address, p->plan->vector.item[move->vector]);
    else
        nc_rotary(p, move->q);
}

void nc_feed(struct nc_program *p, const struct nc_move *move)
{
    if (move->kind == NC_RAPID)
        return;
    if (p->w.inverse)
        nc_forget(&p->w, NC_F, NC_F);
    nc_modal(&p->w, NC_F, "F", move->feed, post_feed_digits(&p->plan->ability, move->feed));
}

void nc_offset(struct nc_program *p, const char *usual)
{
    if (*p->machine->offset || *usual)
        nc_code(&p->w, *p->machine->offset ? p->machine->offset : usual);
}
