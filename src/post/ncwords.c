/* ncwords - see ncwords.h. */
#include "ncwords.h"

#include "post/nccutcom.h"
#include "post_feed.h"
#include "nctemplate.h"

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

static void rotary(struct nc_program *p, int n, const double q[])
{
    const struct machine *m = p->machine;
    for (int i = n - 1; i >= 0; i--) { /* the tilting axis first, as people write it */
        const char address[2] = {machine_letter(m->letter[i]), '\0'};
        nc_modal(&p->w, i ? NC_Q1 : NC_Q0, address, DEGREES(q[i]), p->plan->ability.digits.angle);
    }
}

void nc_rotary(struct nc_program *p, const double q[])
{
    rotary(p, p->machine->chain.n, q);
}

void nc_home(struct nc_program *p, const char *usual)
{
    nc_template(p, p->machine->blocks.home, usual);
    nc_forget(&p->w, NC_X, NC_Z);
    p->w.motion = NULL;
}

void nc_minutes(struct nc_program *p)
{
    if (p->w.inverse)
        nc_block(&p->w, "G94");
    p->w.inverse = false;
}

void nc_rotary_home(struct nc_program *p)
{
    const double zero[ROTARY_MAX] = {0};
    int n = p->plane ? p->turned : p->machine->chain.n;
    if (!n)
        return;
    nc_forget(&p->w, NC_Q0, NC_Q1);
    nc_motion(&p->w, "G0");
    rotary(p, n, zero);
    nc_end(&p->w);
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
    nc_modal(&p->w, NC_F, "F", move->feed, nc_feed_digits(&p->plan->ability, move->feed));
}

void nc_offset(struct nc_program *p, const char *usual)
{
    if (*p->machine->offset || *usual)
        nc_code(&p->w, *p->machine->offset ? p->machine->offset : usual);
}

static void plane(struct nc_writer *w, int number)
{
    if (w->plane != number)
        nc_code(w, number == 17 ? "G17" : number == 18 ? "G18" : "G19");
    w->plane = number;
}

void nc_plane_arc(struct nc_program *p, const struct nc_move *move, const char *const address[3])
{
    const struct nc_arc *a = &p->plan->arc.item[move->index];
    int digits = p->plan->ability.digits.linear;
    struct nc_writer *w = &p->w;
    plane(w, a->plane);
    nc_motion(w, a->ccw ? "G3" : "G2");
    if (a->full) /* the end is named though it is where the tool stands */
        nc_forget(w, a->plane == 19 ? NC_Y : NC_X, a->plane == 17 ? NC_Y : NC_Z);
    nc_place(p, move->p);
    nc_axis(p, move, address);
    if (a->radius != 0) {
        nc_number(w, "R", a->radius, digits);
        return;
    }
    if (a->plane != 19)
        nc_number(w, "I", a->centre.x, digits);
    if (a->plane != 18)
        nc_number(w, "J", a->centre.y, digits);
    if (a->plane != 17)
        nc_number(w, "K", a->centre.z, digits);
}

static const char *const g_cutcom[] = {"G40", "G41", "G42"};

void nc_cutcom_off(struct nc_program *p)
{
    if (nc_cutcom_end(p))
        nc_block(&p->w, g_cutcom[CUTCOM_OFF]);
}

void nc_straight(struct nc_program *p, const struct nc_move *move, const char *const address[3])
{
    bool inverse = p->plan->ability.feeds == NC_FEEDS_INVERSE && move->kind != NC_RAPID;
    struct nc_writer *w = &p->w;
    if (inverse && !w->inverse) {
        nc_code(w, "G93");
        w->inverse = true;
    }
    nc_motion(w, move->kind == NC_RAPID ? "G0" : "G1");
    const char *cutcom = nc_cutcom_word(p, move, g_cutcom);
    if (cutcom)
        nc_code(w, cutcom);
    if (cutcom && p->cutcom.on && p->cutcom_offset)
        nc_count(w, "D", p->tooling.number ? p->tooling.number : 1);
    nc_place(p, move->p);
    nc_axis(p, move, address);
    nc_feed(p, move);
    nc_end(w);
}
