package lightning.textures;

import static lightning.textures.PatternMath.hex;
import static lightning.textures.PatternMath.mix;
import static lightning.textures.PatternMath.smoothstep;

import lightning.base.math.Rgb;

/** Images of the theater stage: piano keys, a sheet of music, the moon and the lens of a spotlight. */
final class StagePatterns {
    private static final int WHITE_KEYS = 7;
    /** Places of the black keys, in white keys from C. */
    private static final double[] BLACK_KEYS = {0.94, 2.06, 3.91, 5, 6.09};
    private static final double BLACK_HALF = 0.29;
    private static final double BLACK_FRONT = 0.359375;

    private static final double MOON_RADIUS = 0.5;
    private static final Rgb HIGHLAND = hex(0xEFEADC);
    private static final Rgb LIMB = hex(0x928F86);
    private static final Rgb MARE = hex(0x8B8D90);

    private static final double STAVE_STEP = 0.011;

    private StagePatterns() {}

    /** An octave from C to B, with the player at v = 0. */
    static TexturePattern.Sample keys(double u, double v) {
        double key = u * WHITE_KEYS;
        for (double black : BLACK_KEYS) {
            double aside = Math.abs(key - black);
            if (v > BLACK_FRONT && aside < BLACK_HALF) {
                double top = 1 - smoothstep(0.6 * BLACK_HALF, 0.9 * BLACK_HALF, aside);
                double ramp = smoothstep(BLACK_FRONT, BLACK_FRONT + 0.06, v);
                return new TexturePattern.Sample(mix(hex(0x08080A), hex(0x24242A), top * ramp), 0);
            }
        }
        double gap = Math.abs(key - Math.round(key));
        return new TexturePattern.Sample(mix(hex(0x3A342A), hex(0xF4EEDD), smoothstep(0.012, 0.04, gap)), 0);
    }

    /** Two pages of music on cream paper. */
    static TexturePattern.Sample music(double u, double v) {
        Rgb paper = mix(hex(0xF1E9D6), hex(0xCFC3A8), 0.5 * StrictMath.exp(-Math.abs(u - 0.5) * 40));
        double x = (u < 0.5 ? u : u - 0.5) * 2;
        double system = (v - 0.08) / 0.105;
        double y = (system - Math.floor(system)) * 0.105;
        if (x < 0.1 || x > 0.9 || v < 0.08 || v > 0.92) {
            return new TexturePattern.Sample(paper, 0);
        }
        double ink = 0;
        for (int i = 0; i < 5; i++) {
            ink = Math.max(ink, PatternMath.line(y - 0.02 - i * STAVE_STEP, 0.0006, 0.0008));
        }
        int note = (int) Math.floor(x * 26);
        int row = (int) Math.floor(system) + (u < 0.5 ? 0 : 40);
        double height = 0.018 + STAVE_STEP * 0.5 * Math.floor(10 * TileableNoise.hash(row, note, 801));
        double dx = (x - (note + 0.5) / 26) / 0.012;
        double dy = (y - height) / 0.0055;
        boolean rest = TileableNoise.hash(row, note, 802) < 0.25;
        if (!rest) {
            ink = Math.max(ink, 1 - smoothstep(0.8, 1.2, Math.hypot(dx, dy)));
            boolean stem = Math.abs(dx - 0.9) < 0.12 && y < height && y > height - 0.034;
            ink = Math.max(ink, stem ? 0.9 : 0);
        }
        return new TexturePattern.Sample(mix(paper, hex(0x1C1814), ink), 0);
    }

    /** The full moon with its dark plains, craters and rays, as large as the image. */
    static TexturePattern.Sample moon(double u, double v) {
        double x = (u - 0.5) / MOON_RADIUS;
        double y = (v - 0.5) / MOON_RADIUS;
        double r = Math.hypot(x, y);
        if (r >= 1) {
            return new TexturePattern.Sample(LIMB, 0);
        }
        double z = Math.sqrt(1 - r * r);
        // Toward the limb the surface is foreshortened.
        double stretch = Math.asin(r) / Math.max(1e-9, r) / Math.PI;
        double a = 0.5 + 0.5 * x * stretch;
        double b = 0.5 + 0.5 * y * stretch;
        double plains = smoothstep(-0.05, 0.15, TileableNoise.fbm(a, b, 5, 5, 5, 811) + 0.2 * (0.55 - Math.hypot(x + 0.25, y + 0.2)));
        double rough = TileableNoise.fbm(a, b, 18, 18, 4, 812);
        Rgb color = mix(HIGHLAND, MARE, 0.85 * plains).times(1 + 0.16 * rough);
        for (int i = 0; i < 3; i++) {
            int cells = 9 << i;
            TileableNoise.Cell crater = TileableNoise.cells(a, b, cells, cells, 0.9, 820 + i);
            double size = 0.08 + 0.18 * TileableNoise.hash(crater.id(), 1, 823);
            double ring = crater.nearest() / size;
            double floor = 1 - smoothstep(0.5, 0.9, ring);
            double rim = smoothstep(0.6, 0.95, ring) * (1 - smoothstep(0.95, 1.5, ring));
            color = color.times(1 - 0.07 * floor + 0.06 * rim);
        }
        double tychoX = x - 0.12;
        double tychoY = y - 0.68;
        double rays = StrictMath.exp(-2.2 * Math.hypot(tychoX, tychoY)) * smoothstep(0.45, 0.8,
                0.5 + 0.5 * StrictMath.sin(9 * StrictMath.atan2(tychoY, tychoX) + 5 * rough));
        color = mix(color, hex(0xFFFBEF), 0.5 * rays);
        return new TexturePattern.Sample(color.times(0.62 + 0.38 * Math.sqrt(z)), 0);
    }

    /** Lens of a spotlight: rings around the image of its filament, darker toward the rim. */
    static TexturePattern.Sample lens(double u, double v) {
        double r = Math.hypot(u - 0.5, v - 0.5) / 0.5;
        if (r >= 1) {
            return new TexturePattern.Sample(Rgb.BLACK, 0);
        }
        double ring = PatternMath.fraction(r * 7);
        double groove = 1 - 0.4 * smoothstep(0.75, 1, ring) - 0.15 * (1 - smoothstep(0, 0.2, ring));
        double core = StrictMath.exp(-r * r * 7);
        Rgb color = mix(hex(0xB8641E), hex(0xFFD9A0), 0.25 + 0.75 * StrictMath.exp(-r * r * 2.2));
        color = mix(color.times(0.8 * groove), hex(0xFFFFFF), core);
        return new TexturePattern.Sample(color.times(1 - smoothstep(0.9, 1, r)), 0);
    }
}
