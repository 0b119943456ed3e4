/* post_words - see post_words.h. */
#include "post_words.h"

#include <stdio.h>
#include <string.h>

#include "base/num.h"
#include "post_feed.h"

struct vec3 nc_above_plane(const struct nc_program *p, const struct nc_move *first)
{
    return post_frame_work(p->planes.item[p->at_plane], dialect_of(p->control)->plane_angles,
                           p->plan->ability.digits.angle, first->p);
}

bool nc_zero_first(const struct nc_program *p)
{
    return p->plan->ability.tcp && p->machine->tcp_frame == TCP_FRAME_ZERO && p->machine->chain.n;
}

void nc_rotary_start(struct nc_program *p, const struct nc_move *first)
{
    double zero[ROTARY_MAX];
    chain_zero(&p->machine->chain, zero);
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
    const struct nc_word word[] = {
        {NC_X, digits, "X", to.x}, {NC_Y, digits, "Y", to.y}, {NC_Z, digits, "Z", to.z}};
    nc_modal_words(&p->w, word, 3);
}

static void vector_words(struct nc_program *p, const char *const address[3], struct vec3 a)
{
    struct nc_writer *w = &p->w;
    if (w->known[NC_I] && w->value[NC_I] == a.x && w->value[NC_J] == a.y && w->value[NC_K] == a.z)
        return;
    nc_forget(w, NC_I, NC_K);
    int digits = p->plan->ability.digits.vector;
    const struct nc_word word[] = {{NC_I, digits, address[0], a.x},
                                   {NC_J, digits, address[1], a.y},
                                   {NC_K, digits, address[2], a.z}};
    nc_modal_words(w, word, 3);
}

enum { ENDLESS = 3600 /* degrees: an axis with more travel turns without end */ };

static enum machine_rotary_words rotary_words(const struct nc_program *p, int i)
{
    const struct rotary *r = &p->machine->chain.rotary[i];
    enum machine_rotary_words words = (enum machine_rotary_words)p->machine->rotary_words;
    if (words == ROTARY_PLAIN || !(DEGREES(r->max - r->min) > ENDLESS))
        return ROTARY_PLAIN;
    bool dc = control_row(p->control)->dc;
    if (words == ROTARY_OWN)
        return dc ? ROTARY_DC : ROTARY_PLAIN;
    if (words == ROTARY_SHORTEST)
        return dc ? ROTARY_DC : ROTARY_WITHIN;
    return words;
}

/* The angle within 0 to 360, as it is printed. */
static double within_turn(double degrees, int digits)
{
    double within = num_round(degrees - 360 * floor(degrees / 360), digits);
    return within >= 360 ? 0 : within;
}

/* The word of one axis, which is not what the last one said, as an axis without an end has it. */
static void turn_word(struct nc_program *p, const struct nc_word *word,
                      enum machine_rotary_words words)
{
    struct nc_writer *w = &p->w;
    int digits = word->digits;
    char text[NUM_MAX + 12];
    double said = num_round(word->value, digits), before = w->value[word->slot];
    if (w->known[word->slot] && before == said)
        return;
    bool back = w->known[word->slot] && said < before;
    nc_remember(w, word->slot, said);
    double within = within_turn(said, digits);
    if (words == ROTARY_DC) {
        size_t n = (size_t)snprintf(text, sizeof text, "%s=DC(", word->address);
        n += num_write_short(text + n, within, digits, false);
        memcpy(text + n, ")", 2);
        nc_code(w, text);
    } else if (words == ROTARY_SIGNED && back) {
        nc_number(w, word->address, within > 0 ? -within : -360, digits);
    } else {
        nc_number(w, word->address, within, digits);
    }
}

void nc_rotary_axes(struct nc_program *p, int n, const double q[])
{
    const int digits = p->plan->ability.digits.angle;
    char address[ROTARY_MAX][2];
    struct nc_word word[ROTARY_MAX];
    size_t plain = 0;                  /* words that are not written yet */
    for (int i = n - 1; i >= 0; i--) { /* the tilting axis first, as people write it */
        enum machine_rotary_words words = rotary_words(p, i);
        struct nc_word *next = &word[plain];
        address[i][0] = machine_letter(p->machine->letter[i]);
        address[i][1] = '\0';
        *next = (struct nc_word){i ? NC_Q1 : NC_Q0, digits, address[i], DEGREES(q[i])};
        if (words == ROTARY_PLAIN) {
            plain++;
            continue;
        }
        nc_modal_words(&p->w, word, plain);
        plain = 0;
        turn_word(p, next, words);
    }
    nc_modal_words(&p->w, word, plain);
}

void nc_rotary(struct nc_program *p, const double q[])
{
    nc_rotary_axes(p, p->machine->chain.n, q);
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

/* ---- tools and work offsets */

const char *nc_work_offset(const struct nc_program *p, size_t n)
{
    const struct machine *m = p->machine;
    for (size_t i = n < MACHINE_OFFSETS ? n : MACHINE_OFFSETS; i-- > 0;)
        if (*m->tool_offset[i])
            return m->tool_offset[i];
    return n ? m->offset : "";
}

int nc_tool_after(const struct nc_program *p)
{
    size_t next = p->tooling.taken;
    const struct nc_plan *plan = p->plan;
    for (size_t i = 0; i < plan->move.n; i++)
        if (plan->move.item[i].kind == NC_TOOL && plan->move.item[i].index >= next)
            return p->path->tool.item[plan->move.item[i].index].number;
    return 0;
}

const char *nc_tool_name(const struct nc_program *p)
{
    const struct machine_tool *tool = machine_tool(p->machine, p->tooling.number);
    const struct path *path = p->path;
    if (!p->machine->tool_names || !dialect_of(p->control)->tool_named)
        return NULL;
    if (tool && *tool->name)
        return tool->name;
    const char *name =
        p->tooling.taken ? path->tool.item[p->tooling.taken - 1].name : path->head.tool_name;
    return *name ? name : NULL;
}
