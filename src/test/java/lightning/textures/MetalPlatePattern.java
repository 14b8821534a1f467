package lightning.textures;

import static lightning.textures.PatternMath.gradient;
import static lightning.textures.PatternMath.hex;
import static lightning.textures.PatternMath.line;
import static lightning.textures.PatternMath.mix;
import static lightning.textures.PatternMath.smoothstep;

import java.util.ArrayList;
import java.util.List;
import lightning.base.math.Rgb;

/** Hull of a spaceship: plates of many sizes with seams, rivets, vents, color marks, streaks and scratches. */
final class MetalPlatePattern implements TexturePattern {

    private static final double MIN_PLATE_SIZE = 0.11;
    private static final double RIVET_SPACING = 0.028;

    private record Plate(double left, double top, double width, double height, int number) {}

    private final List<Plate> plates = new ArrayList<>();

    MetalPlatePattern() {
        split(0, 0, 1, 1, 1);
    }

    private void split(double left, double top, double width, double height, int number) {
        double longer = Math.max(width, height);
        if (longer < 2 * MIN_PLATE_SIZE || longer < 0.45 && TileableNoise.hash(number, 1, 1200) < 0.38) {
            plates.add(new Plate(left, top, width, height, number));
            return;
        }
        double share = 0.5 + 0.12 * Math.rint(4 * TileableNoise.hash(number, 2, 1200) - 2) / 2;
        if (width > height) {
            split(left, top, width * share, height, 2 * number);
            split(left + width * share, top, width * (1 - share), height, 2 * number + 1);
        } else {
            split(left, top, width, height * share, 2 * number);
            split(left, top + height * share, width, height * (1 - share), 2 * number + 1);
        }
    }

    @Override
    public Sample at(double u, double v) {
        Plate plate = plateAt(u, v);
        double x = u - plate.left;
        double y = v - plate.top;
        double edge = Math.min(Math.min(x, plate.width - x), Math.min(y, plate.height - y));

        double tone = TileableNoise.hash(plate.number, 3, 1200);
        Rgb colour = gradient(tone, hex(0x848C94), hex(0x9CA4AB), hex(0xAFB5B9), hex(0xC2C6C7));
        double kind = TileableNoise.hash(plate.number, 4, 1200);
        boolean painted = kind > 0.86;
        if (painted) {
            double chipped = smoothstep(0.12, 0.2, TileableNoise.fbm(u, v, 14, 14, 4, 1210));
            colour = mix(kind > 0.93 ? hex(0xC4622C) : hex(0x3F5F7E), colour, chipped);
        }
        // Brushing direction of the plate.
        boolean upright = TileableNoise.hash(plate.number, 5, 1200) < 0.5;
        double brush = upright ? TileableNoise.at(u, v, 190, 9, 1220) : TileableNoise.at(u, v, 9, 190, 1221);
        double stain = TileableNoise.fbm(u, v, 5, 5, 5, 1230);
        double streak = smoothstep(0.05, 0.5, TileableNoise.at(u, v, 46, 2, 1240)) * smoothstep(0, 0.25, y);
        colour = colour.times(1 + 0.045 * brush + 0.22 * stain);
        colour = mix(colour, hex(0x4C4640), 0.22 * streak);
        double scratch = line(TileableNoise.at(u + 0.3 * v, v, 8, 7, 1250), 0.004, 0.008)
                * smoothstep(0.15, 0.4, TileableNoise.at(u, v, 11, 11, 1251));
        colour = mix(colour, hex(0xDDE2E6), 0.35 * scratch);

        double seam = line(edge, 0.0022, 0.0014);
        double height = 0.004 * smoothstep(0.001, 0.0065, edge) + 0.0012 * (tone - 0.5);
        if (kind < 0.16 && plate.width > 0.09 && plate.height > 0.09) {
            double slot = vent(plate, x, y);
            colour = mix(colour, hex(0x24272B), 0.85 * slot);
            height -= 0.0045 * slot;
        } else {
            double rivet = rivet(plate, x, y);
            colour = mix(colour, colour.times(1.12), rivet);
            height += 0.0030 * rivet;
        }
        double grime = 1 - smoothstep(0, 0.02, edge + 0.012 * TileableNoise.fbm(u, v, 10, 10, 3, 1260));
        colour = mix(colour, hex(0x3B3936), 0.30 * grime);
        return new Sample(mix(colour, hex(0x1B1D20), 0.9 * seam), height);
    }

    private Plate plateAt(double u, double v) {
        for (Plate plate : plates) {
            if (u < plate.left + plate.width && v < plate.top + plate.height && u >= plate.left && v >= plate.top) {
                return plate;
            }
        }
        // The sum of widths may end an ulp before the border.
        return plates.getLast();
    }

    /** Returns rounded heads in a row along the plate's border; 0…1. */
    private static double rivet(Plate plate, double x, double y) {
        double inset = 0.0125;
        double toX = Math.min(Math.abs(x - inset), Math.abs(plate.width - x - inset));
        double toY = Math.min(Math.abs(y - inset), Math.abs(plate.height - y - inset));
        double alongX = nearestOnRow(x - inset, plate.width - 2 * inset);
        double alongY = nearestOnRow(y - inset, plate.height - 2 * inset);
        double horizontal = Math.sqrt(toY * toY + alongX * alongX);
        double vertical = Math.sqrt(toX * toX + alongY * alongY);
        return 1 - smoothstep(0.0018, 0.0042, Math.min(horizontal, vertical));
    }

    /** Returns the distance from x to the nearest rivet of a row from 0 to {@code length}, with one at each end. */
    private static double nearestOnRow(double x, double length) {
        long gaps = Math.max(1, Math.round(length / RIVET_SPACING));
        double apart = length / gaps;
        double nearest = Math.clamp(Math.rint(x / apart), 0, gaps) * apart;
        return Math.abs(x - nearest);
    }

    /** Returns a field of rounded slots in the middle of the plate; 0…1. */
    private static double vent(Plate plate, double x, double y) {
        double halfWidth = plate.width / 2 - 0.026;
        double fromMiddle = x - plate.width / 2;
        double field = plate.height - 0.05;
        long slots = Math.max(2, Math.round(field / 0.018));
        double apart = field / slots;
        double slotY = PatternMath.fraction((y - 0.025) / apart) - 0.5;
        if (y < 0.025 || y > plate.height - 0.025) {
            return 0;
        }
        double distance = MasonryPatterns.roundedBox(fromMiddle, slotY * apart, halfWidth, apart * 0.28, apart * 0.28);
        return smoothstep(0.0008, -0.0012, distance);
    }
}
