package lightning.shading;

import lightning.trace.HitRows;

/** Where columns come from: new memory that is kept, or scratch that is used again. */
public interface Columns {
    /** A float column for {@code rows} rows; contents undefined. */
    float[] floats(int rows);

    /** A state column for {@code rows} rows; contents undefined. */
    byte[] states(int rows);

    /** New memory each time, just long enough. */
    Columns FRESH = new Columns() {
        @Override
        public float[] floats(int rows) {
            return new float[HitRows.padded(rows)];
        }

        @Override
        public byte[] states(int rows) {
            return new byte[rows];
        }
    };
}
