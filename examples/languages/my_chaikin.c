// Tests a refinement in C against reference values:
//   subcert oracle chaikin --level 5 -o oracle_chaikin.h
//   cc -std=c99 my_chaikin.c -lm -o my_chaikin && ./my_chaikin
#include "oracle_chaikin.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

enum {
    CONTROL = sizeof oracle_chaikin_control / sizeof *oracle_chaikin_control,
    REFINED = sizeof oracle_chaikin_refined / sizeof *oracle_chaikin_refined
};

static void my_chaikin(const double *points, int count, double *refined) {
    for (int i = 0; i < count; i++) {
        const double here = points[i], next = points[(i + 1) % count];
        refined[2 * i] = 0.75 * here + 0.25 * next;
        refined[2 * i + 1] = 0.25 * here + 0.75 * next;
    }
}

int main(void) {
    static double points[2][REFINED];
    int count = CONTROL, wrong = 0;
    memcpy(points[0], oracle_chaikin_control, sizeof oracle_chaikin_control);
    for (int level = 0; level < oracle_chaikin_level; level++, count *= 2)
        my_chaikin(points[level % 2], count, points[(level + 1) % 2]);
    const double *found = points[oracle_chaikin_level % 2];
    for (int i = 0; i < REFINED; i++) {
        const double expected = oracle_chaikin_refined[i];
        if (!(fabs(found[i] - expected) <= 4 * oracle_chaikin_refined_ulp[i])) {
            printf("point %d is %.17g in place of %.17g\n", i, found[i], expected);
            wrong++;
        }
    }
    printf("%d of %d points agree\n", REFINED - wrong, REFINED);
    return wrong > 0;
}
