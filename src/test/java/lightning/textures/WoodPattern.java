package lightning.textures;

import static lightning.textures.PatternMath.fraction;
import static lightning.textures.PatternMath.hex;
import static lightning.textures.PatternMath.line;
import static lightning.textures.PatternMath.mix;
import static lightning.textures.PatternMath.smoothstep;

import lightning.base.math.Rgb;

/** Oak planks: six rows along u, each plank with its own tone, growth rings, fibers, pores and an occasional knot. */
final class WoodPattern implements TexturePattern {

    private static final int ROWS = 6;
    /** No pattern within a plank needs to repeat: the joint hides the seam. */
    private static final int NO_KNOT = 1 << 20;

    private static final Rgb EARLYWOOD = hex(0xD3A066);
    private static final Rgb LATEWOOD = hex(0x8E5A2B);
    private static final Rgb RED = hex(0xA8623A);
    private static final Rgb PALE = hex(0xE3BC86);
    private static final Rgb GAP = hex(0x2A180C);
    private static final Rgb KNOT = hex(0x4E2B14);

    @Override
    public Sample at(double u, double v) {
        int row = (int) Math.floor(v * ROWS);
        double along = fraction(u + 0.618 * row + 0.08 * TileableNoise.hash(row, 1, 5));
        double across = v * ROWS - row;
        int seed = 100 + row;

        // A knot deflects the rings.
        double knotX = (along - (0.25 + 0.5 * TileableNoise.hash(row, 2, 5))) * ROWS;
        double knotY = across - (0.3 + 0.4 * TileableNoise.hash(row, 3, 5));
        boolean hasKnot = row % 2 == 1;
        double knot = Math.sqrt(knotX * knotX * 0.35 + knotY * knotY);
        double push = hasKnot ? 0.16 * StrictMath.exp(-knot * knot * 22) * Math.signum(knotY) : 0;

        double heart = 0.2 + 0.6 * TileableNoise.hash(row, 4, 5);
        double wave = 0.30 * TileableNoise.perlin(along * 2.2, across * 0.8, NO_KNOT, NO_KNOT, seed)
                + 0.07 * TileableNoise.perlin(along * 7, across * 3, NO_KNOT, NO_KNOT, seed + 20);
        double rings = 7.5 * Math.abs(across - heart + wave - push) + 1.3 * along;
        double ring = fraction(rings);
        double dark = smoothstep(0.15, 0.93, ring) * (1 - smoothstep(0.93, 1, ring));

        double fibre = TileableNoise.perlin(along * 18, across * 46, NO_KNOT, NO_KNOT, seed + 40);
        double fine = TileableNoise.perlin(along * 40, across * 110, NO_KNOT, NO_KNOT, seed + 50);
        double pore = smoothstep(0.42, 0.7, TileableNoise.perlin(along * 34, across * 70, NO_KNOT, NO_KNOT, seed + 60));

        double tone = TileableNoise.hash(row, 6, 5);
        Rgb early = mix(mix(EARLYWOOD, PALE, 0.8 * TileableNoise.hash(row, 7, 5)), RED, 0.35 * tone);
        Rgb late = mix(LATEWOOD, RED, 0.4 * tone);
        Rgb colour = mix(early, late, 0.72 * dark + 0.14 * fibre + 0.10 * fine);
        colour = mix(colour, late.times(0.62), 0.45 * pore);
        if (hasKnot) {
            double knotRings = 0.5 + 0.5 * StrictMath.sin(knot * 95 + 3 * wave);
            colour = mix(colour, mix(KNOT, LATEWOOD, 0.5 * knotRings), 1 - smoothstep(0.05, 0.13, knot));
        }

        double edgeAcross = Math.min(across, 1 - across) / ROWS;
        double edgeAlong = Math.min(along, 1 - along);
        double edge = Math.min(edgeAcross, edgeAlong);
        colour = mix(colour, GAP, 0.92 * line(edge, 0.0012, 0.0018));
        double height = 0.004 * smoothstep(0.0008, 0.005, edge) - 0.0005 * pore + 0.0002 * fibre;
        return new Sample(colour.times(0.93 + 0.14 * TileableNoise.hash(row, 8, 5)), height);
    }
}
