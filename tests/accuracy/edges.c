/*
 * edges - sharp and thin shapes that are known exactly, to measure how deep a ball goes into them:
 *
 *	edges                              their names
 *	edges SHAPE grid|lines|random STEP SEED [SIGMA]    a scan of it, points about STEP apart,
 *	                                   moved by normal noise along z
 *	edges SHAPE truth STEP SEED        the surface itself, STEP apart, without the outermost mm,
 *	                                   where scans of points anywhere may end; on its edges closer,
 *	                                   by an eighth, and down upright walls
 *
 * Each is seen from above over 24 x 24 mm; SEED turns it and moves it aside, so that no edge lies
 * on a raster.  Lines are two steps apart and points half a step along them; a point strays by 0.6
 * of its step along and 0.4 across.
 */
#include <math.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const double HALF = 12, BORDER = 1, PI2 = 6.283185307179586;
enum { DEPTH = 3 }; /* halvings of a square of the truth at an edge */

typedef double height(double x, double y);

static double positive(double z)
{
    return fmax(0, z);
}

static double pyramid(double x, double y)
{
    return positive(8 - fmax(fabs(x), fabs(y)));
}

static double plateau(double x, double y)
{
    return positive(fmin(4, 4 - 1.7 * fmax(fabs(x) - 5, fabs(y) - 3)));
}

static double post(double x, double y)
{
    return fabs(x) < 3 && fabs(y) < 2 ? 4 : 0;
}

static double rib_low(double x, double y)
{
    (void)y;
    return fabs(x) < 0.4 ? 0.8 : 0;
}

static double rib_thin(double x, double y)
{
    (void)y;
    return fabs(x) < 0.25 ? 0.8 : 0;
}

static double rib_high(double x, double y)
{
    (void)y;
    return fabs(x) < 0.4 ? 2 : 0;
}

static double rib_smooth(double x, double y)
{
    (void)y;
    return 0.8 * exp(-x * x / 0.36);
}

/* 30 degrees between its sides. */
static double knife(double x, double y)
{
    (void)y;
    return positive(6 - 3.7320508 * fabs(x));
}

/* 14 degrees. */
static double blade(double x, double y)
{
    (void)y;
    return positive(8 - 8 * fabs(x));
}

/* Flat on one side, steep on the other. */
static double wedge(double x, double y)
{
    (void)y;
    return positive(fmin(5 + 0.4 * x, 5 - 6 * x));
}

/* Its edge turns, and its sides grow steeper along it. */
static double twisted(double x, double y)
{
    double d = x - 0.03 * y * y, slope = 2.5 + 0.12 * y;
    return positive(5 - slope * fabs(d));
}

/* A ring of a blade of 28 degrees. */
static double ring(double x, double y)
{
    return positive(4 - 4 * fabs(hypot(x, y) - 6));
}

/* The rim of a cup: its wall 0.8 mm thick and round at the top. */
static double rim(double x, double y)
{
    double d = hypot(x, y) - 6;
    return fabs(d) < 0.4 ? 3 + sqrt(0.16 - d * d) : 0;
}

static double cone_60(double x, double y)
{
    return positive(7 - 1.7320508 * hypot(x, y));
}

static double cone_40(double x, double y)
{
    return positive(7 - 2.7474774 * hypot(x, y));
}

/* Round, its sides 70 degrees steep. */
static double mesa(double x, double y)
{
    return positive(fmin(6, 6 - 2.747 * (hypot(x, y) - 3)));
}

/* Square, its sides as steep. */
static double frustum(double x, double y)
{
    return positive(fmin(6, 6 - 2.747 * (fmax(fabs(x), fabs(y)) - 3)));
}

/* Upright, with five tips of 36 degrees. */
static double star(double x, double y)
{
    double t = fabs(fmod(atan2(y, x) + PI2 + PI2 / 20, PI2 / 5) - PI2 / 10);
    /* the side from the tip, 8 out, to the corner 3.0557 out, 36 degrees on */
    double r = hypot(x, y), s = PI2 / 10 - t;
    return r * sin(s + PI2 / 20) < 8 * sin(PI2 / 20) ? 3 : 0;
}

/* Upright teeth with straight sides. */
static double gear(double x, double y)
{
    double r = hypot(x, y), t = fabs(fmod(atan2(y, x) + PI2, PI2 / 9) - PI2 / 18) * r;
    return r < 5.5 || (r < 8 && t < 1.4 - 0.3 * (r - 5.5)) ? 3 : 0;
}

static double saw(double x, double y)
{
    double u = x - 6 * floor(x / 6);
    (void)y;
    return u < 5 ? 0.5 * u : 2.5 * (6 - u);
}

/* A fin that stands alone and ends: 1.6 mm thick at its foot, 0.4 at its top. */
static double fin(double x, double y)
{
    return positive(fmin(5, fmin(5 - (fabs(x) - 0.2) * 8, 5 - (fabs(y) - 6) * 4)));
}

static double tetrahedron(double x, double y)
{
    double a = y, b = -0.8660254 * x - 0.5 * y, c = 0.8660254 * x - 0.5 * y;
    return positive(8 - 2.8284271 * fmax(a, fmax(b, c)));
}

/* Two planes that meet in a roof, its ends upright. */
static double gable(double x, double y)
{
    return fabs(y) < 7 ? positive(5 - 0.8 * fabs(x)) : 0;
}

/* Four steps of 0.5 mm and more of them, 2.2 mm wide; of 1.5 mm, 4 mm wide. */
static double terraces(double x, double y)
{
    (void)y;
    return 0.5 * floor((x + 20) / 2.2);
}

static double terraces_high(double x, double y)
{
    (void)y;
    return 1.5 * floor((x + 20) / 4);
}

/* Risers of 0.9 mm, rings of 1.5 mm. */
static double stepped_cone(double x, double y)
{
    return 0.9 * positive(6 - floor(hypot(x, y) / 1.5));
}

/* Pockets with upright walls, 0.4 deep, in a dome. */
static double pockets(double x, double y)
{
    double u = x - 5 * floor(x / 5 + 0.5), v = y - 5 * floor(y / 5 + 0.5);
    return sqrt(900 - x * x - y * y) - 20 - (fmax(fabs(u), fabs(v)) < 1.5 ? 0.4 : 0);
}

/* An upright disc with twelve pointed teeth, 2 mm high. */
static double toothed(double x, double y)
{
    double t = fabs(fmod(atan2(y, x) + PI2, PI2 / 12) - PI2 / 24) * 24 / PI2;
    return hypot(x, y) < 8.5 - 2 * t ? 2 : 0;
}

/* A star that stands on a slope, its top as steep. */
static double star_on_slope(double x, double y)
{
    return 0.35 * x + 0.1 * y + 0.6 * star(x, y);
}

/* A hexagon nut, its upper edge turned off by a cone of 30 degrees, with a hole. */
static double nut(double x, double y)
{
    double most = 0, r = hypot(x, y);
    for (int k = 0; k < 3; k++)
        most = fmax(most, fabs(x * cos(k * PI2 / 6) + y * sin(k * PI2 / 6)));
    return most < 6.5 && r > 3 ? 4 - 0.577 * positive(r - 6.3) : 0;
}

/* A ramp that steps go up beside. */
static double ramp(double x, double y)
{
    double slope = 0.4 * (x + 12);
    return y < 0 ? slope : 1.2 * floor(slope / 1.2);
}

/* A dome of tangent planes at places anywhere. */
static double facets(double x, double y)
{
    double z = 1e9;
    for (int k = 0; k < 60; k++) {
        double r = 13 * sqrt((k + 0.5) / 60), t = 2.39996 * k, u = r * cos(t), v = r * sin(t);
        double h = sqrt(400 - u * u - v * v);
        z = fmin(z, h + (u * (u - x) + v * (v - y)) / h);
    }
    return z - 10;
}

/* Crossed grooves of 90 degrees, 2.5 mm apart, that leave pyramids. */
static double knurl(double x, double y)
{
    double u = x - 2.5 * floor(x / 2.5 + 0.5), v = y - 2.5 * floor(y / 2.5 + 0.5);
    return 1.25 - fmax(fabs(u), fabs(v));
}

/* The upper side of a bolt of 16 mm, its thread 4 mm a turn, 60 degrees. */
static double thread(double x, double y)
{
    double u = fabs(y) < 7.9 ? y : 7.9, a = asin(u / 8) / PI2, t = x / 4 + a;
    double r = 8 - 1.732 * 4 * 0.5 * fabs(2 * (t - floor(t)) - 1) * 0.5;
    return fabs(y) < r ? sqrt(r * r - y * y) : 0;
}

/* Two planes that make 150 degrees. */
static double obtuse(double x, double y)
{
    return 5 - 0.268 * fabs(x) + 0.05 * y;
}

/* A block with upright sides and a chamfer of 1 mm. */
static double chamfered(double x, double y)
{
    double d = fmax(fabs(x) - 6, fabs(y) - 5);
    return d < 0 ? fmin(4, 3 - d) : 0;
}

/* Two ribs that cross, 2 mm wide, one higher. */
static double cross(double x, double y)
{
    return fabs(x) < 1 ? 3 : fabs(y) < 1 ? 2 : 0;
}

/* Three planes that are hardly off each other, 10 degrees, and one that is steep. */
static double gem(double x, double y)
{
    double z = 6;
    for (int k = 0; k < 7; k++) {
        double along = x * cos(k * PI2 / 7) + y * sin(k * PI2 / 7);
        z = fmin(z, fmin(7 - 0.25 * along, 9 - 0.9 * along));
    }
    return z;
}

/* A round boss with an upright wall, on a cone. */
static double boss(double x, double y)
{
    double r = hypot(x, y);
    return r < 4 ? 5 : 3 - 0.25 * r;
}

/* A ratchet wheel, its teeth rising along their backs, their fronts upright. */
static double ratchet(double x, double y)
{
    double r = hypot(x, y), t = fmod(atan2(y, x) + PI2, PI2 / 10) / (PI2 / 10);
    return r < 10 && r > 3 ? 2 + 1.2 * t : 0;
}

/* A rail with a groove in its top and a step at each side. */
static double rail(double x, double y)
{
    double d = fabs(x);
    (void)y;
    return d < 0.8 ? 2.5 : d < 3 ? 4 : d < 5 ? 1 : 0;
}

/* Eight steps round a post. */
static double spiral(double x, double y)
{
    return hypot(x, y) < 9 ? 0.7 * floor(8 * (atan2(y, x) / PI2 + 0.5)) : 0;
}

/* Four ribs of 1.2 mm that cross, each of another height. */
static double crossed(double x, double y)
{
    double z = 0;
    z = fmax(z, fabs(x + 3) < 0.6 ? 1 : 0);
    z = fmax(z, fabs(x - 3) < 0.6 ? 1.8 : 0);
    z = fmax(z, fabs(y + 3) < 0.6 ? 1.4 : 0);
    return fmax(z, fabs(y - 3) < 0.6 ? 2.4 : 0);
}

/* A field of cones. */
static double spikes(double x, double y)
{
    double u = x - 4 * floor(x / 4 + 0.5), v = y - 4 * floor(y / 4 + 0.5);
    return positive(2.5 - 1.8 * hypot(u, v));
}

/* How far a place is out in a hexagon. */
static double hexagon(double x, double y)
{
    double most = 0;
    for (int k = 0; k < 3; k++)
        most = fmax(most, fabs(x * cos(k * PI2 / 6) + y * sin(k * PI2 / 6)));
    return most;
}

/* A disc with a hole of six sides. */
static double socket(double x, double y)
{
    return hypot(x, y) < 9 ? (hexagon(x, y) < 5 ? 2 : 5) : 0;
}

/* Two roofs, one across the other. */
static double roofs(double x, double y)
{
    return fmax(positive(4 - 0.9 * fabs(x)), positive(3 - 0.6 * fabs(y + 0.3 * x)));
}

/* A stair whose steps slope along it. */
static double stair(double x, double y)
{
    return 0.3 * y + 0.8 * floor((x + 0.25 * y) / 3);
}

/* Posts of six sides, of several heights, their tops tilted. */
static double posts(double x, double y)
{
    double i = floor(x / 6 + 0.5), j = floor(y / 6 + 0.5), u = x - 6 * i;
    return hexagon(u, y - 6 * j) < 2.2 ? 2 + sin(3 * i + 5 * j) + 0.2 * u : 0;
}

/* A dome that two planes cut. */
static double cut_dome(double x, double y)
{
    double r2 = x * x + y * y, z = r2 < 81 ? sqrt(144 - r2) - 7.937 : 0;
    return positive(fmin(z, fmin(3.2 - 0.1 * x, 5.5 + 0.9 * y)));
}

static const struct shape {
    const char *name;
    height *z;
} shapes[] = {{"pyramid", pyramid},
              {"plateau", plateau},
              {"post", post},
              {"rib_low", rib_low},
              {"rib_thin", rib_thin},
              {"rib_high", rib_high},
              {"rib_smooth", rib_smooth},
              {"knife", knife},
              {"blade", blade},
              {"wedge", wedge},
              {"twisted", twisted},
              {"ring", ring},
              {"rim", rim},
              {"cone_60", cone_60},
              {"cone_40", cone_40},
              {"mesa", mesa},
              {"frustum", frustum},
              {"star", star},
              {"gear", gear},
              {"saw", saw},
              {"fin", fin},
              {"tetrahedron", tetrahedron},
              {"gable", gable},
              {"terraces", terraces},
              {"terraces_high", terraces_high},
              {"stepped_cone", stepped_cone},
              {"pockets", pockets},
              {"toothed", toothed},
              {"star_on_slope", star_on_slope},
              {"nut", nut},
              {"ramp", ramp},
              {"facets", facets},
              {"knurl", knurl},
              {"thread", thread},
              {"obtuse", obtuse},
              {"chamfered", chamfered},
              {"cross", cross},
              {"gem", gem},
              {"boss", boss},
              {"ratchet", ratchet},
              {"rail", rail},
              {"spiral", spiral},
              {"crossed", crossed},
              {"spikes", spikes},
              {"socket", socket},
              {"roofs", roofs},
              {"stair", stair},
              {"posts", posts},
              {"cut_dome", cut_dome}};

/* A uniform number, -1 to 1: splitmix64. */
static double uniform(uint64_t *seed)
{
    uint64_t z = *seed += 0x9e3779b97f4a7c15u;
    z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9u;
    z = (z ^ z >> 27) * 0x94d049bb133111ebu;
    return (double)((z ^ z >> 31) >> 11) / 4503599627370496.0 - 1;
}

/* The shape, where it lies. */
struct part {
    height *z;
    double turn, x, y;
};

static double height_at(const struct part *part, double x, double y)
{
    double u = x - part->x, v = y - part->y, c = cos(part->turn), s = sin(part->turn);
    return part->z(u * c + v * s, v * c - u * s);
}

/* Of standard deviation 1, near enough: the sum of twelve. */
static double normal(uint64_t *seed)
{
    double sum = 0;
    for (int i = 0; i < 12; i++)
        sum += uniform(seed) / 2;
    return sum;
}

static void scan(const struct part *part, const char *pattern, double step, double sigma,
                 uint64_t *seed)
{
    bool lines = strcmp(pattern, "lines") == 0, anywhere = strcmp(pattern, "random") == 0;
    double along = lines ? step / 2 : step, across = lines ? 2 * step : step;
    for (double y = -HALF; y <= HALF + 1e-9; y += across)
        for (double x = -HALF; x <= HALF + 1e-9; x += along) {
            double right = uniform(seed), up = uniform(seed), u = x, v = y;
            if (anywhere) {
                u = HALF * right;
                v = HALF * up;
            } else if (lines) {
                u += 0.6 * along * right;
                v += 0.4 * along * up;
            }
            double z = height_at(part, u, v);
            printf("%.4f %.4f %.4f\n", u, v, sigma > 0 ? z + sigma * normal(seed) : z);
        }
}

static void print_true(double x, double y, double z)
{
    printf("%.5f %.5f %.5f\n", x, y, z);
}

/* Where the surface stands highest over the chord from (x, y) to (x + u, y + v): at an edge between
 * them, at its upper side where it is a wall. */
static void crossing(const struct part *part, double x, double y, double u, double v)
{
    enum { TURNS = 40 };
    double from = height_at(part, x, y), to = height_at(part, x + u, y + v), low = 0, high = 1;

    if (fabs(to - from) > 10 * hypot(u, v)) {
        for (int k = 0; k < TURNS; k++) { /* low: on the upper side */
            double t = (low + high) / 2, at = to > from ? 1 - t : t;
            if (height_at(part, x + at * u, y + at * v) > (from + to) / 2)
                low = t;
            else
                high = t;
        }
        low = to > from ? 1 - low : low;
    } else {
        for (int k = 0; k < TURNS; k++) {
            double a = low + (high - low) / 3, b = high - (high - low) / 3;
            if (height_at(part, x + a * u, y + a * v) - a * (to - from) <
                height_at(part, x + b * u, y + b * v) - b * (to - from))
                low = a;
            else
                high = b;
        }
    }
    print_true(x + low * u, y + low * v, height_at(part, x + low * u, y + low * v));
}

/* The highest place of a square, from its middle. */
static void summit(const struct part *part, double x, double y, double side)
{
    double u = x + side / 2, v = y + side / 2, z = height_at(part, u, v);

    for (double step = side / 2; step > 1e-6; step /= 2)
        for (int k = 0; k < 9; k++) {
            double a = fmin(fmax(u + (k % 3 - 1) * step, x), x + side);
            double b = fmin(fmax(v + (k / 3 - 1) * step, y), y + side);
            if (height_at(part, a, b) > z) {
                z = height_at(part, a, b);
                u = a;
                v = b;
            }
        }
    print_true(u, v, z);
}

/* A square, and its parts where it is uneven. */
static void square(const struct part *part, double x, double y, double step, double top, int depth)
{
    double z[3][3], most = 0, high = -HUGE_VAL, low = HUGE_VAL;

    for (int k = 0; k < 9; k++) {
        double at = z[k / 3][k % 3] = height_at(part, x + k % 3 * step / 2, y + k / 3 * step / 2);
        high = fmax(high, at);
        low = fmin(low, at);
    }
    for (int k = 0; k < 3; k += 2) {
        most = fmax(most, fabs(z[1][k] - (z[0][k] + z[2][k]) / 2));
        most = fmax(most, fabs(z[k][1] - (z[k][0] + z[k][2]) / 2));
    }
    most = fmax(most, fabs(z[1][1] - (z[0][0] + z[0][2] + z[2][0] + z[2][2]) / 4));
    if (depth == 0)
        print_true(x, y, z[0][0]);
    if (most < 1e-4)
        return;
    if (depth < DEPTH) {
        for (int k = 0; k < 4; k++)
            square(part, x + k % 2 * step / 2, y + k / 2 * step / 2, step / 2, top, depth + 1);
        return;
    }
    crossing(part, x, y, step, 0);
    crossing(part, x, y, 0, step);
    summit(part, x, y, step);
    for (double down = top; down < high - low && high - low > 10 * step; down += top)
        print_true(x, y, high - down);
}

static void truth(const struct part *part, double step)
{
    double half = HALF - BORDER;

    for (double y = -half; y < half - 1e-9; y += step)
        for (double x = -half; x < half - 1e-9; x += step)
            square(part, x, y, step, step, 0);
}

int main(int argc, char *argv[])
{
    size_t n = sizeof shapes / sizeof *shapes;

    for (size_t i = 0; i < n && argc == 1; i++)
        printf("%s\n", shapes[i].name);
    for (size_t i = 0; i < n && argc >= 5; i++) {
        if (strcmp(argv[1], shapes[i].name) != 0)
            continue;
        uint64_t seed = strtoull(argv[4], NULL, 10) * 1000;
        struct part part = {.z = shapes[i].z, .turn = 0.4 + 0.3 * uniform(&seed)};
        part.x = 0.7 * uniform(&seed);
        part.y = 0.7 * uniform(&seed);
        if (strcmp(argv[2], "truth") == 0)
            truth(&part, atof(argv[3]));
        else
            scan(&part, argv[2], atof(argv[3]), argc > 5 ? atof(argv[5]) : 0, &seed);
        return 0;
    }
    if (argc == 1)
        return 0;
    fprintf(stderr, "usage: edges [SHAPE grid|lines|random|truth STEP SEED [SIGMA]]\n");
    return 2;
}
