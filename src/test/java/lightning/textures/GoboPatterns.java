package lightning.textures;

import lightning.base.math.Rgb;

/** Gobo images for spotlights: white where light passes, with black borders, so that they repeat without a seam. */
final class GoboPatterns {
    private static final int LEAVES = 110;
    private static final double GOLDEN_ANGLE = Math.PI * (3 - Math.sqrt(5));
    /** Half the width of the window, and the height at which its sides begin to lean. */
    private static final double HALF = 0.25;
    private static final double SPRING = 0.06;

    private GoboPatterns() {}

    /** Leaded window with a pointed arch and slightly different panes. */
    static TexturePattern.Sample window(double u, double v) {
        double x = u - 0.5;
        double y = 0.5 - v;
        boolean inside = y > -0.44 && Math.abs(x) < HALF
                && (y < SPRING || Math.hypot(x + HALF, y - SPRING) < 2 * HALF && Math.hypot(x - HALF, y - SPRING) < 2 * HALF);
        boolean mullion = Math.abs(x) < 0.018 || Math.abs(Math.abs(x) - HALF / 2) < 0.007;
        double bars = Math.abs(Math.IEEEremainder(y + 0.44, 0.125));
        boolean rose = Math.abs(Math.hypot(x, y - 0.26) - 0.085) < 0.011;
        if (!inside || mullion || bars < 0.008 || rose) {
            return gray(0);
        }
        double pane = Math.floor((x + HALF) / (HALF / 2)) * 3 + Math.floor((y + 0.44) / 0.125) * 5;
        return gray(0.8 + 0.2 * Math.sin(pane * 1.7));
    }

    /** Light between leaves: pointed gaps, denser in the middle. */
    static TexturePattern.Sample leaves(double u, double v) {
        double x = u - 0.5;
        double y = v - 0.5;
        double light = 0;
        for (int i = 0; i < LEAVES; i++) {
            double away = 0.43 * Math.sqrt((i + 0.5) / LEAVES);
            double around = i * GOLDEN_ANGLE;
            double turn = around * 1.6 + i * 0.9;
            double dx = x - away * Math.cos(around);
            double dy = y - away * Math.sin(around);
            double along = (dx * Math.cos(turn) + dy * Math.sin(turn)) / (0.034 + 0.012 * Math.sin(i * 2.1));
            double across = (dy * Math.cos(turn) - dx * Math.sin(turn)) / 0.0125;
            double inside = 1 - along * along - Math.abs(across);
            light = Math.max(light, Math.clamp(inside * 3, 0, 1));
        }
        return gray(light);
    }

    private static TexturePattern.Sample gray(double value) {
        return new TexturePattern.Sample(new Rgb(value, value, value), 0);
    }
}
