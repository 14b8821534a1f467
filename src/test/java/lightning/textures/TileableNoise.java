package lightning.textures;

/** Hashed, gradient and cellular noise that repeats with a whole number of lattice cells. */
final class TileableNoise {

    /** Nearest and second nearest of one random point per cell. */
    record Cell(double nearest, double second, int id, double dx, double dy) {}

    private TileableNoise() {}

    /** Returns a pseudorandom number in [0, 1). */
    static double hash(int x, int y, int seed) {
        int h = x * 0x27D4EB2D ^ y * 0x165667B1 ^ seed * 0x9E3779B1;
        h = (h ^ h >>> 15) * 0x85EBCA6B;
        h = (h ^ h >>> 13) * 0xC2B2AE35;
        h ^= h >>> 16;
        return (h >>> 8) / (double) (1 << 24);
    }

    /** Returns gradient noise (Perlin 2002) over a lattice that repeats every px by py cells; about −1…1. */
    static double perlin(double x, double y, int px, int py, int seed) {
        int ix = (int) Math.floor(x);
        int iy = (int) Math.floor(y);
        double fx = x - ix;
        double fy = y - iy;
        double sx = fade(fx);
        double sy = fade(fy);
        double top = lerp(corner(ix, iy, fx, fy, px, py, seed), corner(ix + 1, iy, fx - 1, fy, px, py, seed), sx);
        double bottom =
                lerp(corner(ix, iy + 1, fx, fy - 1, px, py, seed), corner(ix + 1, iy + 1, fx - 1, fy - 1, px, py, seed), sx);
        return 1.5 * lerp(top, bottom, sy);
    }

    /** Returns gradient noise of fx by fy cells over the unit square. */
    static double at(double u, double v, int fx, int fy, int seed) {
        return perlin(u * fx, v * fy, fx, fy, seed);
    }

    /** Returns octaves of noise, each twice as fine and half as strong; about −1…1. */
    static double fbm(double u, double v, int fx, int fy, int octaves, int seed) {
        double sum = 0;
        double strength = 0.5;
        for (int i = 0; i < octaves; i++) {
            sum += strength * at(u, v, fx << i, fy << i, seed + i);
            strength *= 0.5;
        }
        return sum;
    }

    /** Returns cellular noise (Worley 1996) with nx by ny cells over the unit square; distances in cells. */
    static Cell cells(double u, double v, int nx, int ny, double jitter, int seed) {
        double x = u * nx;
        double y = v * ny;
        int ix = (int) Math.floor(x);
        int iy = (int) Math.floor(y);
        double nearest = Double.MAX_VALUE;
        double second = Double.MAX_VALUE;
        int id = 0;
        double dx = 0;
        double dy = 0;
        for (int cy = iy - 1; cy <= iy + 1; cy++) {
            for (int cx = ix - 1; cx <= ix + 1; cx++) {
                int wx = Math.floorMod(cx, nx);
                int wy = Math.floorMod(cy, ny);
                double toX = cx + 0.5 + jitter * (hash(wx, wy, seed) - 0.5) - x;
                double toY = cy + 0.5 + jitter * (hash(wx, wy, seed + 77) - 0.5) - y;
                double distance = Math.sqrt(toX * toX + toY * toY);
                if (distance < nearest) {
                    second = nearest;
                    nearest = distance;
                    id = wy * nx + wx;
                    dx = toX;
                    dy = toY;
                } else if (distance < second) {
                    second = distance;
                }
            }
        }
        return new Cell(nearest, second, id, dx, dy);
    }

    private static double corner(int ix, int iy, double dx, double dy, int px, int py, int seed) {
        double angle = 2 * Math.PI * hash(Math.floorMod(ix, px), Math.floorMod(iy, py), seed);
        return StrictMath.cos(angle) * dx + StrictMath.sin(angle) * dy;
    }

    private static double fade(double t) {
        return t * t * t * (t * (t * 6 - 15) + 10);
    }

    private static double lerp(double a, double b, double t) {
        return a + t * (b - a);
    }
}
