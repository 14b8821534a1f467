package lightning.textures;

import static lightning.textures.PatternMath.fraction;
import static lightning.textures.PatternMath.gradient;
import static lightning.textures.PatternMath.hex;
import static lightning.textures.PatternMath.line;
import static lightning.textures.PatternMath.mix;
import static lightning.textures.PatternMath.smoothstep;

import lightning.base.math.Rgb;

/** Patterns of fabric and paper: cloth, leather, a book cover and a printed page. */
final class FabricPatterns {

    private static final Rgb GOLD = hex(0xD9B25A);

    /** Letter cells across a page, including its margins. */
    private static final int LETTERS = 100;

    private FabricPatterns() {}

    /** Plain weave of 64 threads each way, linen with a check of blue stripes. */
    static TexturePattern.Sample cloth(double u, double v) {
        int n = 64;
        double x = (u + 0.0016 * TileableNoise.at(u, v, 16, 24, 800)) * n;
        double y = (v + 0.0016 * TileableNoise.at(u, v, 24, 16, 801)) * n;
        int column = Math.floorMod((int) Math.floor(x), n);
        int row = Math.floorMod((int) Math.floor(y), n);
        double fx = fraction(x) - 0.5;
        double fy = fraction(y) - 0.5;
        int up = (column + row) % 2 == 0 ? 1 : -1;
        // Each thread is a bent tube: it rises over one neighbor and dives under the next.
        double warp = tube(fx, 0.40 + 0.07 * TileableNoise.hash(column, 0, 802)) + 0.55 * up * StrictMath.cos(Math.PI * fy);
        double weft = tube(fy, 0.40 + 0.07 * TileableNoise.hash(0, row, 803)) - 0.55 * up * StrictMath.cos(Math.PI * fx);
        boolean warpOnTop = warp > weft;
        double top = Math.max(warp, weft);
        int thread = warpOnTop ? column : row;
        Rgb colour = stripe(thread, n).times(0.92 + 0.14 * TileableNoise.hash(thread, warpOnTop ? 1 : 2, 804));
        // Fibres run along the thread, slightly twisted.
        double twist = warpOnTop ? StrictMath.sin(2 * Math.PI * (y * 1.0 + fx * 1.5)) : StrictMath.sin(2 * Math.PI * (x * 1.0 + fy * 1.5));
        double fuzz = TileableNoise.at(u, v, 110, 110, 805);
        colour = colour.times(1 + 0.035 * twist + 0.04 * fuzz);
        colour = colour.times(0.42 + 0.58 * smoothstep(-0.25, 1.1, top));
        return new TexturePattern.Sample(colour, 0.0028 * Math.max(top, -0.2));
    }

    private static double tube(double across, double halfWidth) {
        double t = across / halfWidth;
        return t * t < 1 ? Math.sqrt(1 - t * t) : -0.6;
    }

    private static Rgb stripe(int thread, int n) {
        int at = Math.floorMod(thread, n / 2);
        if (at >= 11 && at < 21) {
            return hex(0x3E6190);
        }
        return at == 8 || at == 23 ? hex(0xB8484A) : hex(0xE9DFC9);
    }

    /** Full-grain brown leather: small cushions between creases. */
    static TexturePattern.Sample leather(double u, double v) {
        double warpU = u + 0.012 * TileableNoise.fbm(u, v, 9, 9, 3, 900);
        double warpV = v + 0.012 * TileableNoise.fbm(u, v, 9, 9, 3, 904);
        TileableNoise.Cell big = TileableNoise.cells(warpU, warpV, 26, 30, 1, 910);
        TileableNoise.Cell small = TileableNoise.cells(warpU, warpV, 60, 66, 1, 920);
        double cushion = smoothstep(0.0, 0.38, big.second() - big.nearest());
        double pebble = smoothstep(0.0, 0.45, small.second() - small.nearest());
        double slow = TileableNoise.fbm(u, v, 3, 3, 4, 930);
        double wear = smoothstep(0.05, 0.45, TileableNoise.fbm(u, v, 4, 4, 5, 940));
        Rgb colour = gradient(0.5 + 0.8 * slow, hex(0x5F3419), hex(0x7A4522), hex(0x8F552C));
        colour = mix(colour, hex(0xB07A48), 0.38 * wear * cushion);
        colour = mix(hex(0x3A1E0E), colour, 0.30 + 0.45 * cushion + 0.25 * pebble);
        colour = colour.times(1 + 0.03 * TileableNoise.at(u, v, 160, 160, 950)).times(0.95 + 0.1 * TileableNoise.hash(big.id(), 1, 911));
        return new TexturePattern.Sample(colour, 0.0042 * cushion + 0.0018 * pebble + 0.004 * slow);
    }

    /** Book bound in wine-red cloth, with frame, corners and medallion stamped in gold. */
    static TexturePattern.Sample bookCover(double u, double v) {
        double x = Math.abs(u - 0.5);
        double y = Math.abs(v - 0.5);
        double border = 0.5 - Math.max(x, y);
        double cx = 0.395 - x;
        double cy = 0.395 - y;
        double corner = Math.sqrt(cx * cx + cy * cy);
        double petals = corner * (1 + 0.22 * StrictMath.cos(8 * StrictMath.atan2(cy, cx)));
        double gold = Math.max(line(border - 0.050, 0.0045, 0.0018), line(border - 0.066, 0.0014, 0.0016));
        gold = Math.max(gold, Math.max(line(petals - 0.027, 0.0022, 0.0016), line(corner, 0.008, 0.002)));
        // The inner frame ends at the flowers in the corners.
        gold = Math.max(gold, line(border - 0.105, 0.0020, 0.0016) * smoothstep(0.036, 0.040, corner));
        double lozenge = x / 0.20 + y / 0.27;
        gold = Math.max(gold, Math.max(line((lozenge - 1) * 0.16, 0.0030, 0.0016), line((lozenge - 0.9) * 0.16, 0.0012, 0.0014)));
        double radius = Math.sqrt(x * x + y * y);
        double rosette = radius * (1 + 0.16 * StrictMath.cos(12 * StrictMath.atan2(y, x)));
        gold = Math.max(gold, Math.max(line(rosette - 0.078, 0.0026, 0.0016), line(rosette - 0.040, 0.0020, 0.0016)));
        gold = Math.max(gold, line(radius, 0.016, 0.002));

        double weaveX = StrictMath.sin(2 * Math.PI * 96 * u);
        double weaveY = StrictMath.sin(2 * Math.PI * 96 * v);
        double weave = weaveX * weaveY;
        double slow = TileableNoise.fbm(u, v, 3, 3, 4, 1000);
        Rgb cloth = gradient(0.5 + 0.9 * slow, hex(0x5E1420), hex(0x761B29), hex(0x8C2732)).times(1 + 0.07 * weave);
        double rubbed = smoothstep(0.12, 0.42, TileableNoise.fbm(u, v, 10, 10, 4, 1010));
        double shine = 0.5 + 0.9 * TileableNoise.fbm(u, v, 5, 5, 4, 1020);
        Rgb gilt = mix(hex(0xB48A3A), hex(0xF3D98C), shine);
        Rgb colour = mix(cloth, mix(gilt, GOLD, 0.3), gold * (1 - 0.55 * rubbed));
        colour = colour.times(0.80 + 0.20 * smoothstep(0, 0.022, border));
        double height = 0.0007 * weave * (1 - gold) - 0.0016 * gold;
        return new TexturePattern.Sample(colour, height);
    }

    /** Page of a printed book at a distance where words look gray but letters are almost legible. */
    static TexturePattern.Sample paper(double u, double v) {
        int lines = 22;
        double fibre = TileableNoise.fbm(u, v, 24, 24, 4, 1100);
        double thread = smoothstep(0.55, 0.8, TileableNoise.at(u + 0.02 * TileableNoise.at(u, v, 9, 9, 1101), v, 30, 90, 1102));
        double slow = TileableNoise.fbm(u, v, 2, 2, 4, 1110);
        Rgb sheet = mix(hex(0xF3EAD3), hex(0xE6D8B8), 0.5 + 0.9 * slow).times(1 + 0.03 * fibre);
        sheet = mix(sheet, hex(0xCDB98F), 0.25 * thread);
        int number = (int) Math.floor(v * lines);
        double inLine = v * lines - number;
        int letter = (int) Math.floor(u * LETTERS);
        int first = number % 7 == 0 ? 13 : 9;
        int last = number % 7 == 6 ? 52 : LETTERS - 10;
        double ink = letter >= first && letter <= last ? ink(letter, u * LETTERS - letter, inLine, number) : 0;
        Rgb colour = mix(sheet, hex(0x2B2722), 0.86 * ink);
        return new TexturePattern.Sample(colour, 0.0012 * fibre);
    }

    /** Returns the ink 0…1 of one cell of a line: a letter of strokes and bows, or a space. */
    private static double ink(int letter, double x, double inLine, int number) {
        if (isSpace(letter, number)) {
            return 0;
        }
        double kind = TileableNoise.hash(letter, number, 1120);
        double top = kind < 0.28 ? 0.22 : 0.40;
        double bottom = kind > 0.86 ? 0.86 : 0.70;
        double within = smoothstep(top - 0.03, top + 0.02, inLine) * (1 - smoothstep(bottom - 0.02, bottom + 0.03, inLine));
        double stem = line(x - 0.28, 0.09, 0.08) * within;
        double bowX = (x - 0.52) / 0.34;
        double bowY = (inLine - 0.55) / 0.15;
        double bow = line(Math.sqrt(bowX * bowX + bowY * bowY) - 0.85, 0.16, 0.2);
        double second = line(x - 0.76, 0.09, 0.08)
                * smoothstep(0.38, 0.42, inLine) * (1 - smoothstep(0.68, 0.73, inLine));
        return switch ((int) (TileableNoise.hash(letter, number, 1121) * 5)) {
            case 0 -> Math.max(stem, bow);
            case 1 -> bow;
            case 2 -> Math.max(stem, second);
            case 3 -> Math.max(stem, Math.max(second, line(inLine - 0.42, 0.03, 0.04) * line(x - 0.52, 0.22, 0.06)));
            default -> stem;
        };
    }

    private static boolean isSpace(int letter, int number) {
        // One of every five cells is a space, the first to the fourth: words of one to eight letters.
        int group = Math.floorDiv(letter, 5);
        return Math.floorMod(letter, 5) == (int) (4 * TileableNoise.hash(group, number, 1130));
    }
}
