package lightning.textures;

import static lightning.textures.PatternMath.fraction;
import static lightning.textures.PatternMath.gradient;
import static lightning.textures.PatternMath.hex;
import static lightning.textures.PatternMath.line;
import static lightning.textures.PatternMath.mix;
import static lightning.textures.PatternMath.smoothstep;

import lightning.base.math.Rgb;

/** Patterns of masonry: brick, checker, stone and roof. */
final class MasonryPatterns {

    private static final Rgb MORTAR = hex(0xB8AD9B);

    private MasonryPatterns() {}

    /** Running bond of eight courses. */
    static TexturePattern.Sample brick(double u, double v) {
        int rows = 8;
        int columns = 4;
        double warpU = u + 0.0016 * TileableNoise.fbm(u, v, 16, 16, 2, 30);
        double warpV = v + 0.0016 * TileableNoise.fbm(u, v, 16, 16, 2, 33);
        int row = (int) Math.floor(warpV * rows);
        double shifted = warpU * columns + 0.5 * Math.floorMod(row, 2);
        int column = Math.floorMod((int) Math.floor(shifted), columns);
        row = Math.floorMod(row, rows);
        double x = (fraction(shifted) - 0.5) / columns;
        double y = (fraction(warpV * rows) - 0.5) / rows;
        double inside = roundedBox(x, y, 0.5 / columns - 0.006, 0.5 / rows - 0.006, 0.006);

        double kind = TileableNoise.hash(column, row, 3);
        Rgb body = gradient(kind, hex(0x7A3226), hex(0x9A4430), hex(0xA94E36), hex(0xB55B3E), hex(0xC67A55));
        double mottle = TileableNoise.fbm(u, v, 12, 12, 4, 40 + column * 8 + row * 32);
        double speck = smoothstep(0.45, 0.75, TileableNoise.at(u, v, 120, 120, 50));
        double grain = TileableNoise.at(u, v, 128, 128, 51);
        body = mix(body, hex(0x5A2A22), 0.55 * smoothstep(0.05, 0.5, mottle));
        body = mix(body, hex(0xD9A07C), 0.45 * smoothstep(0.05, 0.5, -mottle));
        body = mix(body, hex(0x4B221C), 0.35 * speck).times(1 + 0.05 * grain);
        Rgb mortar = MORTAR.times(0.94 + 0.10 * TileableNoise.fbm(u, v, 32, 32, 3, 60));

        double chip = 0.0020 * TileableNoise.fbm(u, v, 40, 40, 2, 70);
        double solid = smoothstep(-0.0010, 0.0014, -inside + chip);
        double height = 0.0055 * smoothstep(-0.001, 0.007, -inside + chip) + 0.0006 * mottle - 0.0004 * speck + 0.0002 * grain;
        return new TexturePattern.Sample(mix(mortar, body, solid), height);
    }

    /** Four by four tiles of light and dark marble, polished, with a thin joint. */
    static TexturePattern.Sample checker(double u, double v) {
        int n = 4;
        int column = (int) Math.floor(u * n);
        int row = (int) Math.floor(v * n);
        boolean light = (column + row) % 2 == 0;
        // Each tile comes from another place of the block; the joints hide that the veins do not meet.
        double tileU = fraction(u + TileableNoise.hash(column, row, 80));
        double tileV = fraction(v + TileableNoise.hash(column, row, 81));
        double vein = vein(tileU, tileV, 3, 3, 82);
        double fine = vein(tileU, tileV, 6, 6, 92);
        double cloud = TileableNoise.fbm(tileU, tileV, 4, 4, 4, 85);
        Rgb colour;
        if (light) {
            colour = mix(hex(0xF1EEE6), hex(0xD9D5CC), 0.5 + cloud);
            colour = mix(colour, hex(0x96928C), 0.55 * vein + 0.22 * fine);
        } else {
            colour = mix(hex(0x23252A), hex(0x343841), 0.5 + cloud);
            colour = mix(colour, hex(0xA8A39A), 0.42 * vein + 0.16 * fine);
        }
        double x = Math.min(fraction(u * n), 1 - fraction(u * n)) / n;
        double y = Math.min(fraction(v * n), 1 - fraction(v * n)) / n;
        double edge = Math.min(x, y);
        colour = mix(colour.times(0.97 + 0.06 * TileableNoise.hash(column, row, 84)), hex(0x6E685F), line(edge, 0.0009, 0.0012));
        return new TexturePattern.Sample(colour, 0.0015 * smoothstep(0.001, 0.004, edge));
    }

    /** Returns thin bright threads at the zeros of warped noise; 0…1. */
    static double vein(double u, double v, int fx, int fy, int seed) {
        double warpU = u + 0.11 * TileableNoise.fbm(u, v, fx, fy, 4, seed + 1);
        double warpV = v + 0.11 * TileableNoise.fbm(u, v, fx, fy, 4, seed + 5);
        double ridge = Math.abs(TileableNoise.at(warpU, warpV, fx, fy, seed));
        double strength = 0.35 + 0.65 * smoothstep(-0.3, 0.4, TileableNoise.at(u, v, fx, fy, seed + 9));
        return strength * StrictMath.exp(-ridge * 26) + 0.25 * strength * StrictMath.exp(-ridge * 6);
    }

    /** Irregular flagstones. */
    static TexturePattern.Sample stone(double u, double v) {
        double warpU = u + 0.018 * TileableNoise.fbm(u, v, 6, 6, 3, 100);
        double warpV = v + 0.018 * TileableNoise.fbm(u, v, 6, 6, 3, 104);
        TileableNoise.Cell cell = TileableNoise.cells(warpU, warpV, 6, 6, 0.75, 110);
        double edge = (cell.second() - cell.nearest()) / 12;
        double tone = TileableNoise.hash(cell.id(), 1, 111);
        double warm = TileableNoise.hash(cell.id(), 2, 111);
        Rgb body = gradient(tone, hex(0x77736D), hex(0x928C82), hex(0xA59D90), hex(0xB9B0A0));
        body = mix(body, hex(0xA98C6C), 0.45 * smoothstep(0.55, 1, warm));
        body = mix(body, hex(0x7C8790), 0.40 * smoothstep(0.55, 1, 1 - warm));
        // The offset per stone varies the grain of neighbors.
        double rough = TileableNoise.fbm(u, v, 10, 10, 5, 120 + cell.id() * 7);
        double pit = smoothstep(0.38, 0.62, TileableNoise.fbm(u, v, 48, 48, 2, 130));
        body = body.times(1 + 0.30 * rough);
        body = mix(body, hex(0x514C46), 0.5 * pit);
        double lichen =
                smoothstep(0.16, 0.34, TileableNoise.fbm(u, v, 7, 7, 4, 140)) * smoothstep(0.0, 0.3, TileableNoise.at(u, v, 40, 40, 141));
        body = mix(body, hex(0xB3B58A), 0.30 * lichen);
        Rgb joint = hex(0x5C554B).times(0.9 + 0.35 * TileableNoise.fbm(u, v, 40, 40, 3, 150));
        double solid = smoothstep(0.004, 0.0075, edge + 0.003 * TileableNoise.fbm(u, v, 32, 32, 2, 151));
        double height = 0.009 * smoothstep(0.002, 0.016, edge) + 0.006 * rough - 0.0012 * pit;
        return new TexturePattern.Sample(mix(joint, body, solid), height);
    }

    /** Fish-scale roof tiles of fired clay, eight columns, each row over the one below. */
    static TexturePattern.Sample roof(double u, double v) {
        int columns = 8;
        int rows = 10;
        // The topmost tile at a point is that of the highest row that reaches down to it.
        int below = (int) Math.floor(v * rows);
        for (int row = below - 1; row <= below + 1; row++) {
            double shifted = u * columns + 0.5 * Math.floorMod(row, 2);
            int column = Math.floorMod((int) Math.floor(shifted), columns);
            double x = fraction(shifted) - 0.5;
            double y = v * rows - row;
            double bottom = 0.35 + 0.85 * Math.sqrt(Math.max(0, 0.25 - x * x)) / 0.5;
            if (y <= bottom) {
                return tile(u, v, column, Math.floorMod(row, rows), x, y, bottom);
            }
        }
        throw new IllegalStateException("a tile of the next row reaches down to every point");
    }

    private static TexturePattern.Sample tile(double u, double v, int column, int row, double x, double y, double bottom) {
        double tone = TileableNoise.hash(column, row, 160);
        Rgb body = gradient(tone, hex(0x7E3A2B), hex(0x9C4A33), hex(0xB05A3C), hex(0xBF6E4A), hex(0x8B4A3E));
        double mottle = TileableNoise.fbm(u, v, 14, 14, 4, 170 + column * 11 + row * 5);
        body = body.times(1 + 0.35 * mottle + 0.05 * TileableNoise.at(u, v, 128, 128, 171));
        double moss = smoothstep(0.1, 0.4, TileableNoise.fbm(u, v, 5, 5, 5, 180)) * smoothstep(0.5, 0.1, bottom - y);
        body = mix(body, hex(0x6D7044), 0.5 * moss);
        double toEdge = Math.min(bottom - y, 0.5 - Math.abs(x));
        // The row above casts a shadow on the upper part; the lip catches light.
        double shade = 0.55 + 0.45 * smoothstep(-0.25, 0.45, y);
        body = mix(body.times(0.4), body.times(shade), smoothstep(0.0, 0.055, toEdge));
        double height = 0.012 * smoothstep(0, 0.16, toEdge) + 0.003 * mottle;
        return new TexturePattern.Sample(body, height);
    }

    /** Returns the signed distance to a rectangle with rounded corners; negative inside. */
    static double roundedBox(double x, double y, double halfWidth, double halfHeight, double radius) {
        double dx = Math.abs(x) - halfWidth + radius;
        double dy = Math.abs(y) - halfHeight + radius;
        double outX = Math.max(dx, 0);
        double outY = Math.max(dy, 0);
        return Math.sqrt(outX * outX + outY * outY) + Math.min(Math.max(dx, dy), 0) - radius;
    }
}
