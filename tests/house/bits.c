/* bits - prints what elementary_bits.h adds up, for compilers that have no Check; portability.t. */
#include <stdio.h>

#include "elementary_bits.h"

int main(void)
{
    printf("0x%llx\n", elementary_bits());
    return 0;
}
