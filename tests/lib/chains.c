/* chains - see chains.h. */
#include "chains.h"
#include "seed.h"

uint64_t seed;

double chance(void)
{
    seed = seed * 6364136223846793005u + seed_step();
    return (double)(seed >> 11) / 9007199254740992.0;
}

struct vec3 random_unit(void)
{
    double z = 2 * chance() - 1, turn = 2 * PI * chance(), r = sqrt(1 - z * z);
    return vec(r * cos(turn), r * sin(turn), z);
}

struct rotary rotary_of(struct vec3 axis, struct vec3 centre, bool table)
{
    return (struct rotary){vec_unit(axis), centre, table, -1e9, 1e9, 0};
}

struct kinematic_chain chain_of(int kind)
{
    struct vec3 x = vec(1, 0, 0), y = vec(0, 1, 0), z = vec(0, 0, 1), yz = vec(0, 1, 1);
    struct vec3 c = vec(3, -7, 20), d = vec(-1, 5, 130);
    struct kinematic_chain chain = {.n = 2, .master = 1, .tool = z};
    const struct rotary pair[KINDS][2] = {
        [KIND_TABLE_AC] = {rotary_of(z, c, true), rotary_of(x, d, true)},
        [KIND_TABLE_BC] = {rotary_of(z, c, true), rotary_of(y, d, true)},
        [KIND_HEAD_TABLE] = {rotary_of(z, c, true), rotary_of(y, d, false)},
        [KIND_HEAD_HEAD] = {rotary_of(z, c, false), rotary_of(x, d, false)},
        [KIND_NUTATING_HEAD] = {rotary_of(z, c, true), rotary_of(yz, d, false)},
        [KIND_NUTATING_TABLE] = {rotary_of(vec(0, 0, -1), c, true), rotary_of(yz, d, true)},
    };
    chain.rotary[0] = pair[kind][0];
    chain.rotary[1] = pair[kind][1];
    return chain;
}
