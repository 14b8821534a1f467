package lightning.render.match;

import lightning.base.text.Messages;

/**
 * Round dab of a brush that says how a picture shall change there.
 *
 * @param x      center, pixels from the left
 * @param y      center, pixels from the top
 * @param radius pixels, &gt; 0
 */
public record BrushDab(Wish wish, double x, double y, double radius) {
    /** How the picture shall change. */
    public enum Wish {
        /** One stop more. */
        BRIGHTER(Messages.key("Brighter"), 2, 2, 2),
        /** One stop less. */
        DARKER(Messages.key("Darker"), 0.5, 0.5, 0.5),
        /** More red and less blue, of about the same brightness. */
        WARMER(Messages.key("Warmer"), 1.25, 1, 0.7),
        /** Less red and more blue, of about the same brightness. */
        COOLER(Messages.key("Cooler"), 0.75, 1.05, 1.4),
        /** No change. */
        KEEP(Messages.key("Keep"), 1, 1, 1);

        private final String title;
        private final float[] factors;

        Wish(String title, double red, double green, double blue) {
            this.title = title;
            factors = new float[] {(float) red, (float) green, (float) blue};
        }

        public String title() {
            return Messages.tr(title);
        }

        /** Returns the factor of the luminance of gray. */
        float luminance() {
            return (float) TargetCells.luminance(factors[0], factors[1], factors[2]);
        }

        /** Returns the factor of a channel: 0 for red, 1 for green, 2 for blue. */
        float factor(int channel) {
            return factors[channel];
        }
    }
}
