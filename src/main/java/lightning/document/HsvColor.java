package lightning.document;

import lightning.base.math.Rgb;
import lightning.scene.value.SceneLimits;

/**
 * Color as hue, saturation and value (Smith, 1978) of its linear channels.
 *
 * @param hue        degrees, 0…360: red, yellow, green, cyan, blue, magenta every 60; 0 for grays
 * @param saturation 0…1; 0 for grays
 * @param value      largest channel, ≥ 0
 */
public record HsvColor(double hue, double saturation, double value) {
    private static final double SECTOR = 60;

    public HsvColor {
        SceneLimits.checkRange("hue", hue, 0, 6 * SECTOR);
        SceneLimits.checkRange("saturation", saturation, 0, 1);
        SceneLimits.checkRange("value", value, 0, SceneLimits.MAX_EMISSION);
    }

    /** @param c channels ≥ 0 */
    public static HsvColor of(Rgb c) {
        double max = c.max();
        double range = max - c.min();
        if (range == 0) {
            return new HsvColor(0, 0, max);
        }
        double sector;
        if (max == c.r()) {
            sector = (c.g() - c.b()) / range;
        } else if (max == c.g()) {
            sector = 2 + (c.b() - c.r()) / range;
        } else {
            sector = 4 + (c.r() - c.g()) / range;
        }
        return new HsvColor(SECTOR * (sector < 0 ? sector + 6 : sector), range / max, max);
    }

    public Rgb rgb() {
        return new Rgb(channel(5), channel(3), channel(1));
    }

    /** Returns the channel whose hexagon starts at sector {@code n}: full, falling, empty, rising. */
    private double channel(int n) {
        double k = (n + hue / SECTOR) % 6;
        return value - value * saturation * Math.clamp(Math.min(k, 4 - k), 0, 1);
    }
}
