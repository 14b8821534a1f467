package lightning.editor.window.model;

import javafx.geometry.Pos;

/**
 * Place of the preview's inset in the picture.
 *
 * @param size share of the largest width, from {@link #MIN_SIZE} to 1
 */
public record InsetPlace(Corner corner, double size) {
    public static final double MIN_SIZE = 0.3;
    public static final InsetPlace INITIAL = new InsetPlace(Corner.TOP_RIGHT, 1);

    /** Corner of the picture. */
    public enum Corner {
        TOP_LEFT(Pos.TOP_LEFT, Pos.BOTTOM_RIGHT), TOP_RIGHT(Pos.TOP_RIGHT, Pos.BOTTOM_LEFT),
        BOTTOM_LEFT(Pos.BOTTOM_LEFT, Pos.TOP_RIGHT), BOTTOM_RIGHT(Pos.BOTTOM_RIGHT, Pos.TOP_LEFT);

        private final Pos position;
        private final Pos innerCorner;

        Corner(Pos position, Pos innerCorner) {
            this.position = position;
            this.innerCorner = innerCorner;
        }

        public Pos position() {
            return position;
        }

        /** Returns the inset's corner that faces the picture's middle. */
        public Pos innerCorner() {
            return innerCorner;
        }

        /** Returns the corner next to a point, whose coordinates are shares of the width and height. */
        public static Corner nearest(double x, double y) {
            return y < 0.5 ? x < 0.5 ? TOP_LEFT : TOP_RIGHT : x < 0.5 ? BOTTOM_LEFT : BOTTOM_RIGHT;
        }
    }

    public InsetPlace withCorner(Corner v) {
        return new InsetPlace(v, size);
    }

    /** Returns the place with the allowed size next to the given one. */
    public InsetPlace withSize(double v) {
        return new InsetPlace(corner, Math.clamp(v, MIN_SIZE, 1));
    }
}
