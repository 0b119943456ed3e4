/* decimals - see decimals.h. */
#include "decimals.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static uint64_t next_random(uint64_t *state)
{
    *state ^= *state << 13;
    *state ^= *state >> 7;
    *state ^= *state << 17;
    return *state;
}

/* Digits times 2 or 5, with what carries over in front. */
static size_t multiply(char *digit, size_t n, int factor)
{
    int carry = 0;
    for (size_t i = n; i-- > 0;) {
        carry += (digit[i] - '0') * factor;
        digit[i] = (char)('0' + carry % 10);
        carry /= 10;
    }
    if (carry) {
        memmove(digit + 1, digit, n + 1);
        digit[0] = (char)('0' + carry);
        n++;
    }
    return n;
}

/* An odd number of 54 bits (fewer where doubles have fewer) times 2^power. */
static void half_way(uint64_t *state, char *text)
{
    uint64_t random = next_random(state);
    int power = random % 256 ? (int)(random / 256 % 80) - 60 : (int)(random / 256 % 2044) - 1075;
    int bits = power == -1075 ? 1 + (int)(random >> 40) % 53 : 54;
    uint64_t odd = next_random(state) >> (64 - bits) | 1 | (uint64_t)1 << (bits - 1);
    size_t n = (size_t)snprintf(text, DECIMAL_MAX, "%llu", (unsigned long long)odd);

    for (int i = 0; i < power || i < -power; i++)
        n = multiply(text, n, power < 0 ? 5 : 2);
    int change = (int)(next_random(state) % 4);
    if (change == 1)
        text[n - 1] = (char)(text[n - 1] + (text[n - 1] < '9'));
    if (change == 2)
        text[n - 1] = (char)(text[n - 1] - (text[n - 1] > '0'));
    n += (size_t)snprintf(text + n, DECIMAL_MAX - n, "%s", change == 3 ? ".00000000001" : "");
    if (power < 0)
        snprintf(text + n, DECIMAL_MAX - n, "e%d", power);
}

static void any_digits(uint64_t *state, char *text)
{
    uint64_t random = next_random(state);
    int digits = 1 + (int)(random % 40), point = (int)(random >> 8) % 48;
    size_t n = 0;

    if (random >> 63)
        text[n++] = '-';
    for (int i = 0; i < digits; i++) {
        if (i == point)
            text[n++] = '.';
        text[n++] = (char)('0' + next_random(state) % 10);
    }
    text[n] = '\0';
    random = next_random(state);
    if (random % 4)
        snprintf(text + n, DECIMAL_MAX - n, "e%d",
                 random % 4 == 1 ? (int)(random / 4 % 700) - 370 : (int)(random / 4 % 60) - 30);
}

void decimal_hard(uint64_t *state, uint64_t i, char text[DECIMAL_MAX])
{
    uint64_t random = next_random(state);
    double value;

    switch (i % 4) {
    case 0:
        value = (double)(int64_t)random / 9e15;
        snprintf(text, DECIMAL_MAX, "%.*f", (int)(random % 10), value);
        break;
    case 1:
        memcpy(&value, &random, sizeof value);
        snprintf(text, DECIMAL_MAX, "%.17g", isfinite(value) ? value : 1e300);
        break;
    case 2:
        any_digits(state, text);
        break;
    default:
        half_way(state, text);
    }
}
