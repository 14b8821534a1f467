package lightning.textures;

import static lightning.textures.PatternMath.gradient;
import static lightning.textures.PatternMath.hex;
import static lightning.textures.PatternMath.mix;
import static lightning.textures.PatternMath.smoothstep;
import static lightning.textures.PatternMath.wrappedDistance;

import lightning.base.math.Rgb;

/** Lawn seen from above: thousands of bent, overlapping blades, dark at the root and light at the tip. */
final class GrassPattern implements TexturePattern {

    /** Cells in each direction; one blade per layer is rooted in each. */
    private static final int CELLS = 36;
    private static final int LAYERS = 2;
    private static final double MAX_LENGTH = 0.075;
    private static final double HALF_WIDTH = 0.0044;
    /** Maximum distance of a blade's root from a point that it covers, in cells. */
    private static final int CELL_RADIUS = (int) Math.ceil(MAX_LENGTH * CELLS);

    /**
     * Blade in texture coordinates.
     *
     * @param cos  cosine of its direction from the root to the tip
     * @param bend lateral offset of the tip from the root's direction
     * @param rank stacking order
     */
    private record Blade(double u, double v, double cos, double sin, double length, double bend, double rank, Rgb color) {}

    private final Blade[] blades = new Blade[LAYERS * CELLS * CELLS];

    GrassPattern() {
        for (int i = 0; i < blades.length; i++) {
            int cell = i / LAYERS;
            double u = (cell % CELLS + TileableNoise.hash(i, 1, 500)) / CELLS;
            double v = (cell / CELLS + TileableNoise.hash(i, 2, 500)) / CELLS;
            // Neighbors lean in similar directions, due to wind and mowing.
            double angle = 3.2 * TileableNoise.fbm(u, v, 5, 5, 2, 510) + 1.9 * (TileableNoise.hash(i, 3, 500) - 0.5) - 1.2;
            double length = MAX_LENGTH * (0.55 + 0.45 * TileableNoise.hash(i, 4, 500));
            double bend = length * 0.55 * (TileableNoise.hash(i, 5, 500) - 0.5);
            Rgb colour = gradient(0.15 + 0.7 * TileableNoise.hash(i, 6, 500) + 0.6 * TileableNoise.fbm(u, v, 3, 3, 3, 520),
                    hex(0x3B6A1E), hex(0x558427), hex(0x6F9C33), hex(0x93B547));
            Rgb dry = mix(colour, hex(0xBFB068), smoothstep(0.93, 1, TileableNoise.hash(i, 7, 500)));
            blades[i] = new Blade(u, v, StrictMath.cos(angle), StrictMath.sin(angle), length, bend,
                    TileableNoise.hash(i, 8, 500), dry);
        }
    }

    @Override
    public Sample at(double u, double v) {
        Rgb colour = mix(hex(0x1F3310), hex(0x2E4718), 0.5 + TileableNoise.fbm(u, v, 6, 6, 2, 530));
        double top = -1;
        int column = (int) Math.floor(u * CELLS);
        int row = (int) Math.floor(v * CELLS);
        for (int y = row - CELL_RADIUS; y <= row + CELL_RADIUS; y++) {
            for (int x = column - CELL_RADIUS; x <= column + CELL_RADIUS; x++) {
                int first = LAYERS * (Math.floorMod(y, CELLS) * CELLS + Math.floorMod(x, CELLS));
                for (int i = first; i < first + LAYERS; i++) {
                    Blade blade = blades[i];
                    double du = wrappedDistance(u, blade.u);
                    double dv = wrappedDistance(v, blade.v);
                    double t = (du * blade.cos + dv * blade.sin) / blade.length;
                    if (t < 0 || t > 1) {
                        continue;
                    }
                    double across = dv * blade.cos - du * blade.sin - blade.bend * t * t;
                    double halfWidth = HALF_WIDTH * StrictMath.sqrt(1 - t) * (0.6 + 0.4 * t);
                    double level = blade.rank + 0.8 * t;
                    if (Math.abs(across) < halfWidth && level > top) {
                        top = level;
                        // One half of a folded blade faces the light.
                        double fold = 1 + 0.16 * smoothstep(-0.3, 0.3, across / halfWidth) - 0.08;
                        colour = blade.color.times((0.50 + 0.38 * t + 0.36 * blade.rank) * fold);
                    }
                }
            }
        }
        return new Sample(colour, 0);
    }
}
