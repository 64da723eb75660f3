/* A mapper for the lesson in C, with the C library's own sin, cos, exp and log; it can be told to make a mistake.
   usage: mapper BUG (--noise-free | --seed N) OUT [SCENARIO]         BUG is a name, none for a right map */
#include <ctype.h>
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static const char *bug;
static int is(const char *name) { return strcmp(bug, name) == 0; }

static const double pi = 3.141592653589793;
static const char *names[] = {"width", "height", "resolution", "origin_x", "origin_y", "max_range", "p0", "p_occ",
    "p_free", "l_min", "l_max", "fov", "beams", "noise_std", "min_range"};
static double value[] = {NAN, NAN, NAN, NAN, NAN, NAN, 0.5, 0.75, 0.3, -8, 8, 3.141592653589793, 181, 0.02, 0};
enum { W, H, RES, OX, OY, ZMAX, P0, POCC, PFREE, LMIN, LMAX, FOV, BEAMS, STD, ZMIN };
static int ignore, seeded, scans, simulated, started;
static uint32_t seed;
static double (*wall)[4];
static int walls;
static double *grid, l0, occ, fre;
static char *touched;
static const char *file;
static long line_number;

static void fail(const char *reason) {
    fprintf(stderr, "%s:%ld: %s\n", file, line_number, reason);
    exit(1);
}

static double number(const char *text) {
    char *end;
    const char *digits = text + (*text == '-' || *text == '+');
    if (tolower(digits[0]) == '0' && tolower(digits[1]) == 'x') fail("not a number");
    double v = strtod(text, &end);
    if (*end || end == text) fail("not a number");
    return fabs(v) < 1e-300 ? 0 : v;
}

static double logit(double p) {
    p = fmin(fmax(p, 1e-9), 1 - 1e-9);
    double l = log(p / (1 - p));
    return is("base-10") ? l / log(10) : l;
}

static void words(uint32_t c0, uint32_t c1, uint32_t *w0, uint32_t *w1) {
    uint32_t c2 = 0, c3 = 0, k0 = seed, k1 = 0;
    for (int i = 0; i < (is("nine-rounds") ? 9 : 10); i++) {
        uint64_t a = 0xD2511F53ull * c0, b = 0xCD9E8D57ull * c2;
        c0 = (uint32_t)(b >> 32) ^ c1 ^ k0, c1 = (uint32_t)b, c2 = (uint32_t)(a >> 32) ^ c3 ^ k1, c3 = (uint32_t)a;
        k0 += 0x9E3779B9u, k1 += 0xBB67AE85u;
    }
    *w0 = c0, *w1 = c1;
}

static double noisy(double z, int beam) {
    uint32_t w0, w1;
    int scan = is("scans-apart") ? simulated : scans;
    words((uint32_t)scan, (uint32_t)beam, &w0, &w1);
    double half = is("no-half") ? 1.0 : 0.5;
    double n = sqrt(-2 * log((w0 + half) / 4294967296.0)) * cos(2 * pi * ((w1 + half) / 4294967296.0));
    z += value[STD] * n;
    return z < 0 && !is("below-zero") ? 0 : z > value[ZMAX] ? value[ZMAX] : z;
}

static double cast(double x, double y, double a) {
    double dx = cos(a), dy = sin(a), best = value[ZMAX];
    for (int i = 0; i < walls - is("last-wall"); i++) {
        double *s = wall[i], sx = s[2] - s[0], sy = s[3] - s[1], rxs = dx * sy - dy * sx;
        if (fabs(rxs) < (is("coarse-parallel") ? 1e-9 : 1e-12)) continue;
        double qx = s[0] - x, qy = s[1] - y, t = (qx * sy - qy * sx) / rxs, u = (qx * dy - qy * dx) / rxs;
        if ((is("no-end") && u == 1) || (is("no-beginning") && u == 0)) continue;
        if (t >= 0 && u >= 0 && (u <= 1 || is("endless-walls")) && t < best) best = t;
    }
    return best;
}

static void start(void) {
    if (started) return;
    started = 1;
    for (int i = W; i <= ZMAX; i++) if (isnan(value[i])) fail("a parameter is missing");
    l0 = logit(value[P0]), occ = logit(value[POCC]), fre = logit(value[PFREE]);
    if (is("p-0.70")) occ = logit(0.7);
    if (!is("prior")) occ -= l0, fre -= l0;
    size_t n = (size_t)value[W] * (size_t)value[H];
    grid = malloc(n * sizeof *grid), touched = calloc(n, 1);
    for (size_t i = 0; i < n; i++) grid[i] = l0;
}

static int update(long gx, long gy, double step) {
    long w = (long)value[W], h = (long)value[H];
    if (gx < 0 || gx >= w || gy < 0 || gy >= h) return is("break-outside");
    if (is("last-column") && gx == w - 1) return 0;
    double low = value[LMIN], high = value[LMAX], *cell = &grid[gy * w + gx];
    if (is("limits-ten")) low = -10, high = 10;
    if (is("sign-clamp")) high = -low;
    if (is("twice") && step == occ) step *= 2;
    if (is("random") && rand() % 5000 == 0) step = -step;
    double l = *cell + step;
    if (is("clamp-before")) l = (*cell > high ? high : *cell < low ? low : *cell) + step;
    else l = l > high ? high : l < low ? low : l;
    *cell = is("float") ? (float)l : l;
    return 0;
}

static void beam(double x, double y, double theta, double angle, double z, int simulated_beam, int number) {
    double a = theta + angle, zmax = value[ZMAX];
    if (is("infinity") && isinf(z)) return;
    if (is("half-pixel")) x += value[RES] / 2;
    if (isnan(z)) return;
    if (!simulated_beam && z < value[ZMIN] && !is("min-range")) return;
    if (is("short-range") && z > 0.9 * zmax) z = zmax;
    int hit = z < zmax - 1e-12;
    if (!hit && ignore) return;
    if (!hit) z = zmax;
    if (is("hit-farther") && hit) z += value[RES];
    long gx = (long)floor((x - value[OX]) / value[RES]), gy = (long)floor((y - value[OY]) / value[RES]);
    long gx1 = (long)floor((x + z * cos(a) - value[OX]) / value[RES]);
    long gy1 = (long)floor((y + z * sin(a) - value[OY]) / value[RES]);
    long dx = labs(gx1 - gx), dy = labs(gy1 - gy), sx = gx < gx1 ? 1 : -1, sy = gy < gy1 ? 1 : -1, err = dx - dy;
    if (is("octant") && gx1 < gx && gy1 < gy && dx > dy) err = dx - dy - 1;
    if (is("even-beams") && number % 2) return;
    (void)number;
    for (;;) {
        int end = gx == gx1 && gy == gy1;
        if (is("first-free") && end && dx + dy == 0) break;
        if (update(gx, gy, end && hit ? occ : fre) || end) break;
        long e2 = 2 * err;
        if (e2 > -dy) err -= dy, gx += sx;
        else if (is("else")) { err += dx, gy += sy; continue; }
        if (e2 < dx && !is("else")) err += dx, gy += sy;
    }
}

static void pose(double x, double y, double theta) {
    int n = (int)value[BEAMS];
    for (int i = 0; i < n - is("last-beam"); i++) {
        double angle = n == 1 ? 0 : -(value[FOV] / 2) + (value[FOV] * i) / (n - 1);
        if (is("half-step")) angle = -(value[FOV] / 2) + value[FOV] * (i + 0.5) / n;
        if (is("fov-n")) angle = -(value[FOV] / 2) + value[FOV] * i / n;
        if (is("full-fov")) angle = n == 1 ? 0 : value[FOV] * i / (n - 1);
        double z = cast(x, y, theta + angle);
        beam(x, y, theta, angle, seeded ? noisy(z, i) : z, 1, i);
    }
    simulated++;
}

static void recorded(char **range, int n, char **at, double first, double step) {
    double x = number(at[0]), y = number(at[1]), theta = number(at[2]);
    if (is("wrap") && theta > pi) theta -= 3;
    for (int i = 0; i < n - is("last-beam"); i++) {
        double z = number(range[i]);
        if (z < 0) fail("a range is negative");
        if (is("recorded-noise") && seeded && !isnan(z)) z = noisy(z, i);
        beam(x, y, theta, first + i * step, z, 0, i);
    }
}

static void flaser(char **f, int count) {
    int n = count > 1 ? atoi(f[1]) : 0;
    if (n < 1 || count != n + 11) fail("wrong number of values");
    double step = n == 1 ? 0 : n == 180 || n == 181 ? pi / 180 : n == 360 || n == 361 ? pi / 360
        : n == 400 || n == 401 ? pi / 720 : pi / (n - 1);
    if (is("step-n-1")) step = n == 1 ? 0 : pi / (n - 1);
    recorded(f + 2, n, f + 2 + n + (is("odometry") ? 3 : 0), -(pi / 2), step);
}

static void robotlaser(char **f, int count) {
    int n = count > 8 ? atoi(f[8]) : 0;
    int m = n > 0 && count > n + 9 ? atoi(f[9 + n]) : -1;
    if (m < 0 || count != n + m + 24) fail("wrong number of values");
    char **at = f + 10 + n + (is("remissions") ? 0 : m) + (is("robot-pose") ? 3 : 0);
    recorded(f + 9, n, at, number(f[2]), number(f[4]));
}

static void parameter(char **f, int count) {
    if (count < 2 || strncmp(f[1], "occgrid_", 8)) return;
    if (started) fail("PARAM must stand before the first scan");
    if (count != 3) fail("wrong number of values");
    if (!strcmp(f[1], "occgrid_no_return")) { ignore = !strcmp(f[2], "ignore"); return; }
    for (size_t i = 0; i < sizeof names / sizeof *names; i++)
        if (!strcmp(f[1] + 8, names[i])) {
            value[i] = number(f[2]);
            if (i >= P0 && i <= PFREE && !(value[i] > 0 && value[i] < 1)) fail("not between 0 and 1");
            return;
        }
    fail("unknown parameter");
}

static void read_scenario(void) {
    FILE *in = fopen(file, "r");
    if (!in) fail("cannot be read");
    char *line = NULL;
    size_t size = 0;
    char **f = malloc(200000 * sizeof *f);
    while (getline(&line, &size, in) >= 0) {
        int count = 0;
        line_number++;
        for (char *t = strtok(line, " \t\r\n"); t; t = strtok(NULL, " \t\r\n")) f[count++] = t;
        if (!count || f[0][0] == '#') continue;
        int ours = !strcmp(f[0], "PARAM") || !strcmp(f[0], "WALL") || !strcmp(f[0], "POSE");
        if (ours || is("comment-anywhere"))
            for (int i = 1; i < count; i++) if (f[i][0] == '#') count = i;
        if (is("bare-param") && !strcmp(f[0], "PARAM") && count < 3) fail("PARAM without a value");
        if (!strcmp(f[0], "PARAM")) parameter(f, count);
        else if (!strcmp(f[0], "WALL")) {
            if (started) fail("WALL must stand before the first scan");
            if (count != 5) fail("wrong number of values");
            wall = realloc(wall, (size_t)(walls + 1) * sizeof *wall);
            for (int i = 0; i < 4; i++) wall[walls][i] = number(f[i + 1]);
            walls++;
        } else if (!strcmp(f[0], "POSE")) {
            start();
            if (count != 4) fail("wrong number of values");
            if (!(is("first-scan") && !scans)) pose(number(f[1]), number(f[2]), number(f[3]));
            scans++;
        } else if (!strcmp(f[0], "FLASER") || !strcmp(f[0], "ROBOTLASER1")) {
            start();
            if (!(is("first-scan") && !scans)) (f[0][0] == 'F' ? flaser : robotlaser)(f, count);
            scans++;
        }
    }
    if (!scans) fail("no scan");
}

static void lesson(void) {
    static double box[][4] = {{-10, -8, 10, -8}, {10, -8, 10, 8}, {10, 8, -10, 8}, {-10, 8, -10, -8}, {0, -6, 0, 6},
        {-8, 2, -2, 2}};
    double given[] = {220, 180, 0.1, -11, -9, 10};
    for (int i = W; i <= ZMAX; i++) value[i] = given[i];
    wall = box, walls = 6;
    start();
    if (is("lesson-wall")) walls = 5;
    int first = is("lesson-from-1") || is("lesson-late");
    int end = is("lesson-119") ? 119 : is("lesson-121") || is("lesson-late") ? 121 : 120;
    for (int k = first; k < end; k++, scans++) {
        int t = is("lesson-reversed") ? 119 - k : k;
        if (is("lesson-even") && t % 2) continue;
        double a = 2 * pi * (t / (is("lesson-t-1") ? 119.0 : 120.0));
        if (is("lesson-whole")) a = 2 * pi * (t / 120);
        double theta = is("lesson-heading") ? a : is("lesson-backward") ? a - pi / 2 : a + pi / 2;
        pose(-6 + (is("lesson-circle") ? 4 : 6) * cos(a), 4 * sin(a), theta);
    }
}

static int pixel(double l) {
    double p = l >= 0 ? 1 / (1 + exp(-l)) : exp(l) / (1 + exp(l));
    if (is("ros")) return p > 0.65 ? 0 : p < 0.196 ? 254 : 205;
    if (is("maximum-100")) return (int)floor((1 - p) * 100 + 0.5);
    if (is("unknown-205") && p == 0.5) return 205;
    if (is("half-down")) return 255 - (int)floor(p * 255 + 0.5);
    return (int)floor((1 - p) * 255 + 0.5);
}

static void write_map(const char *out) {
    char path[4096], name[1024];
    const char *slash = file ? strrchr(file, '/') : NULL;
    snprintf(name, sizeof name, "%s", file ? slash ? slash + 1 : file : "lesson");
    char *dot = strrchr(name, '.');
    if (dot && dot != name) *dot = 0;
    snprintf(path, sizeof path, "%s/%s.pgm", out, name);
    FILE *pgm = is("banner") || is("progress") ? stdout : fopen(path, "w");
    long w = (long)value[W], h = (long)value[H];
    if (is("progress")) printf("mapping 1%%\rmapping 100%%\r");
    if (is("banner")) printf("Occupancy grid mapper\ndone\n");
    fprintf(pgm, "P2\n%ld %ld\n%d\n", w, h, is("maximum-100") ? 100 : 255);
    for (long y = h - 1; y >= 0; y--) {
        long row = is("flipped") ? h - 1 - y : y;
        for (long x = 0; x < w; x++) fprintf(pgm, "%d%c", pixel(grid[row * w + x]), x < w - 1 ? ' ' : '\n');
    }
    if (is("half-file")) { fflush(pgm); if (ftruncate(fileno(pgm), 40)) exit(3); }
    if (pgm != stdout) fclose(pgm);
    if (strncmp(bug, "yaml", 4) == 0) {
        snprintf(path, sizeof path, "%s/%s.yaml", out, name);
        FILE *yaml = fopen(path, "w");
        double g = 255 - pixel(l0), up = 1 / (1 + exp(-(l0 + logit(0.65)))), down = 1 / (1 + exp(-(l0 + logit(0.196))));
        up = fmin(1, fmax(up, (g + 0.5) / 255)), down = fmax(0, fmin(down, (g - 0.5) / 255));
        if (is("yaml-thresholds")) up = 0.65, down = 0.196;
        fprintf(yaml, "image: %s.pgm\nmode: trinary\nresolution: %.9f\norigin: [%.9f, %.9f, 0.0]\nnegate: 0\n"
            "occupied_thresh: %.9f\nfree_thresh: %.9f\n", name, value[RES], value[OX], value[OY], up, down);
        fclose(yaml);
    }
    if (is("float") || is("digits") || is("probabilities") || is("base-10") || is("log-odds")) {
        snprintf(path, sizeof path, "%s/%s.logodds", out, name);
        FILE *text = fopen(path, "w");
        fprintf(text, "# logodds %ld %ld\n", w, h);
        for (long i = 0; i < w * h; i++) {
            double l = is("probabilities") ? 1 / (1 + exp(-grid[i])) : grid[i];
            fprintf(text, is("digits") ? "%.6g%c" : "%.17g%c", l, (i + 1) % w ? ' ' : '\n');
        }
        fclose(text);
    }
}

int main(int count, char **argument) {
    bug = argument[1];
    int next = 2;
    if (!strcmp(argument[next], "--seed")) seeded = !is("no-noise"), seed = (uint32_t)strtoul(argument[++next], NULL, 10);
    next++;
    if (is("process-number")) srand((unsigned)getpid());
    if (is("random")) srand((unsigned)getpid());
    if (is("crash")) abort();
    file = count > next + 1 ? argument[next + 1] : NULL;
    if (file) read_scenario();
    else lesson();
    write_map(argument[next]);
    return 0;
}
