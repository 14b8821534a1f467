package lightning.textures;

import static lightning.textures.PatternMath.add;
import static lightning.textures.PatternMath.gradient;
import static lightning.textures.PatternMath.hex;
import static lightning.textures.PatternMath.mix;
import static lightning.textures.PatternMath.smoothstep;

import lightning.base.math.Rgb;

/** Patterns of nature: marble, orange peel, sand and the night sky. */
final class NaturePatterns {

    private NaturePatterns() {}

    /** White marble with blue-gray veins and a trace of ochre. */
    static TexturePattern.Sample marble(double u, double v) {
        // Sheared by a whole number, so that the beds run diagonally and still meet themselves.
        double across = v + u;
        double big = MasonryPatterns.vein(u, across, 1, 3, 200);
        double middle = MasonryPatterns.vein(u, across, 2, 5, 220);
        double fine = MasonryPatterns.vein(u, across, 5, 9, 240);
        double cloud = TileableNoise.fbm(u, across, 2, 4, 5, 260);
        Rgb colour = mix(hex(0xF4F1EB), hex(0xD3D3D4), 0.45 + 1.1 * cloud);
        colour = mix(colour, hex(0xBFA57C), 0.55 * big * smoothstep(-0.1, 0.4, TileableNoise.fbm(u, v, 3, 3, 3, 270)));
        colour = mix(colour, hex(0x6A7078), 0.72 * big + 0.42 * middle);
        colour = mix(colour, hex(0x8C9196), 0.28 * fine);
        return new TexturePattern.Sample(colour, 0);
    }

    /** Skin of an orange: dimples of several sizes over slow changes of color. */
    static TexturePattern.Sample orangePeel(double u, double v) {
        double warpU = u + 0.004 * TileableNoise.fbm(u, v, 20, 20, 2, 300);
        double warpV = v + 0.004 * TileableNoise.fbm(u, v, 20, 20, 2, 303);
        TileableNoise.Cell pore = TileableNoise.cells(warpU, warpV, 30, 30, 0.85, 310);
        double size = 0.24 + 0.26 * TileableNoise.hash(pore.id(), 1, 311);
        // If two pores nearly touch, both are shallow, so that no ridge forms between them.
        double dimple = (1 - smoothstep(0, size, pore.nearest())) * smoothstep(0, 0.3, pore.second() - pore.nearest());
        double slow = TileableNoise.fbm(u, v, 3, 3, 4, 320);
        double spot = TileableNoise.fbm(u, v, 12, 12, 3, 330);
        Rgb colour = gradient(0.5 + 0.9 * slow + 0.25 * spot, hex(0xE06A0C), hex(0xEE8414), hex(0xF59A22), hex(0xF8B03A));
        colour = mix(colour, hex(0xC45608), 0.34 * dimple);
        // A few pale scars and greenish freckles keep it from looking moulded.
        colour = mix(colour, hex(0xD8A050), 0.35 * smoothstep(0.30, 0.45, TileableNoise.fbm(u, v, 9, 9, 4, 340)));
        colour = mix(colour, hex(0xA8882A), 0.30 * dimple * smoothstep(0.1, 0.4, TileableNoise.fbm(u, v, 5, 5, 3, 350)));
        double height = -0.0036 * dimple + 0.002 * spot;
        return new TexturePattern.Sample(colour, height);
    }

    /** Wind-blown sand: ripples that fork, and grains. */
    static TexturePattern.Sample sand(double u, double v) {
        double bend = 0.75 * TileableNoise.fbm(u, v, 2, 2, 3, 400) + 0.13 * TileableNoise.at(u, v, 8, 8, 404);
        double phase = 2 * Math.PI * (9 * v + u + 2.0 * bend);
        double depth = 0.35 + 0.65 * smoothstep(-0.35, 0.4, TileableNoise.fbm(u, v, 3, 3, 2, 410));
        // A second harmonic makes the lee side steep.
        double ripple = depth * (StrictMath.sin(phase) + 0.28 * StrictMath.sin(2 * phase + 0.8));
        double grain = TileableNoise.at(u, v, 128, 128, 420);
        TileableNoise.Cell speck = TileableNoise.cells(u, v, 70, 70, 1, 430);
        double coarse = (1 - smoothstep(0.05, 0.17, speck.nearest())) * smoothstep(0.55, 1, TileableNoise.hash(speck.id(), 1, 431));
        double slow = TileableNoise.fbm(u, v, 4, 4, 3, 440);
        Rgb colour = gradient(0.5 + 0.28 * ripple + 0.5 * slow, hex(0xB08A5C), hex(0xCBA674), hex(0xDDBD8C), hex(0xEBD2A8));
        colour = colour.times(1 + 0.035 * grain);
        colour = mix(colour, hex(0x7D6244), 0.55 * coarse);
        return new TexturePattern.Sample(colour, 0.0085 * ripple + 0.0002 * grain + 0.003 * slow);
    }

    /** Clear night: the haze of the Milky Way across the corner, dust in it, stars of several sizes and color temperatures. */
    static TexturePattern.Sample nightSky(double u, double v) {
        double bend = 0.10 * TileableNoise.fbm(u, v, 2, 2, 4, 700);
        double across = PatternMath.wrappedDistance(u + v + bend, 0.5);
        double cloud = TileableNoise.fbm(u, v, 4, 4, 6, 710);
        double band = StrictMath.exp(-across * across * 34) * Math.clamp(0.62 + 1.1 * cloud, 0, 1.2);
        double dust = smoothstep(0.02, 0.34, TileableNoise.fbm(u, v, 5, 5, 5, 720)) * StrictMath.exp(-across * across * 90);
        Rgb colour = mix(hex(0x070B1A), hex(0x101A33), 0.5 + TileableNoise.fbm(u, v, 2, 2, 4, 730));
        colour = mix(colour, hex(0x6C6F92), 0.62 * band * (1 - 0.8 * dust));
        colour = mix(colour, hex(0x8A5A72), 0.30 * band * smoothstep(0.1, 0.4, TileableNoise.fbm(u, v, 6, 6, 4, 740)));
        colour = stars(colour, u, v, 90, 0.0011, 0.50 + 0.9 * band, 750);
        colour = stars(colour, u, v, 40, 0.0018, 0.80, 760);
        colour = stars(colour, u, v, 9, 0.0034, 1.4, 770);
        return new TexturePattern.Sample(colour, 0);
    }

    private static Rgb stars(Rgb sky, double u, double v, int cells, double radius, double brightness, int seed) {
        TileableNoise.Cell cell = TileableNoise.cells(u, v, cells, cells, 0.9, seed);
        double magnitude = TileableNoise.hash(cell.id(), 1, seed);
        double distance = cell.nearest() / cells / (radius * (0.5 + magnitude));
        double light = brightness * magnitude * magnitude
                * (StrictMath.exp(-distance * distance) + 0.10 * StrictMath.exp(-distance * 0.9));
        double warmth = TileableNoise.hash(cell.id(), 2, seed);
        return add(sky, gradient(warmth, hex(0xFFD2A0), hex(0xFFF6EC), hex(0xC8D8FF)).times(light));
    }
}
