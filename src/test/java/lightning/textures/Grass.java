package lightning.textures;

import static lightning.textures.Paint.around;
import static lightning.textures.Paint.gradient;
import static lightning.textures.Paint.hex;
import static lightning.textures.Paint.mix;
import static lightning.textures.Paint.smooth;

import lightning.base.math.Rgb;

/** A lawn seen from above: some thousand bent blades over each other, dark at the root and light at the tip. */
final class Grass implements Pattern {

    /** Cells in each direction, in each of which one blade is rooted per layer. */
    private static final int CELLS = 36;
    private static final int LAYERS = 2;
    private static final double LONGEST = 0.075;
    private static final double HALF_WIDTH = 0.0044;
    /** How many cells away the root of a blade over a point can be. */
    private static final int REACH = (int) Math.ceil(LONGEST * CELLS);

    /**
     * A blade in the coordinates of the texture.
     *
     * @param cos  of its direction, which points from the root to the tip
     * @param bend how far the tip lies beside the direction of the root
     * @param rank which of two blades lies on top
     */
    private record Blade(double u, double v, double cos, double sin, double length, double bend, double rank, Rgb colour) {}

    private final Blade[] blades = new Blade[LAYERS * CELLS * CELLS];

    Grass() {
        for (int i = 0; i < blades.length; i++) {
            int cell = i / LAYERS;
            double u = (cell % CELLS + Noise.hash(i, 1, 500)) / CELLS;
            double v = (cell / CELLS + Noise.hash(i, 2, 500)) / CELLS;
            // Neighbours lean alike, as the wind and the mower left them.
            double angle = 3.2 * Noise.fbm(u, v, 5, 5, 2, 510) + 1.9 * (Noise.hash(i, 3, 500) - 0.5) - 1.2;
            double length = LONGEST * (0.55 + 0.45 * Noise.hash(i, 4, 500));
            double bend = length * 0.55 * (Noise.hash(i, 5, 500) - 0.5);
            Rgb colour = gradient(0.15 + 0.7 * Noise.hash(i, 6, 500) + 0.6 * Noise.fbm(u, v, 3, 3, 3, 520),
                    hex(0x3B6A1E), hex(0x558427), hex(0x6F9C33), hex(0x93B547));
            Rgb dry = mix(colour, hex(0xBFB068), smooth(0.93, 1, Noise.hash(i, 7, 500)));
            blades[i] = new Blade(u, v, StrictMath.cos(angle), StrictMath.sin(angle), length, bend,
                    Noise.hash(i, 8, 500), dry);
        }
    }

    @Override
    public Point at(double u, double v) {
        Rgb colour = mix(hex(0x1F3310), hex(0x2E4718), 0.5 + Noise.fbm(u, v, 6, 6, 2, 530));
        double top = -1;
        int column = (int) Math.floor(u * CELLS);
        int row = (int) Math.floor(v * CELLS);
        for (int y = row - REACH; y <= row + REACH; y++) {
            for (int x = column - REACH; x <= column + REACH; x++) {
                int first = LAYERS * (Math.floorMod(y, CELLS) * CELLS + Math.floorMod(x, CELLS));
                for (int i = first; i < first + LAYERS; i++) {
                    Blade blade = blades[i];
                    double du = around(u, blade.u);
                    double dv = around(v, blade.v);
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
                        double fold = 1 + 0.16 * smooth(-0.3, 0.3, across / halfWidth) - 0.08;
                        colour = blade.colour.times((0.50 + 0.38 * t + 0.36 * blade.rank) * fold);
                    }
                }
            }
        }
        return new Point(colour, 0);
    }
}
