package lightning.render.shading;

import lightning.render.trace.HitRows;

/** Where columns come from: new memory that is kept, or scratch that is used again. */
public interface ColumnAllocator {
    /** A float column for {@code rows} rows; contents undefined. */
    float[] floats(int rows);

    /** A state column for {@code rows} rows; contents undefined. */
    byte[] states(int rows);

    /** A column of sets of samples for {@code rows} rows; contents undefined. */
    short[] shorts(int rows);

    /** New memory each time, just long enough. */
    ColumnAllocator NEW_ARRAYS = new ColumnAllocator() {
        @Override
        public float[] floats(int rows) {
            return new float[HitRows.paddedLength(rows)];
        }

        @Override
        public byte[] states(int rows) {
            return new byte[rows];
        }

        @Override
        public short[] shorts(int rows) {
            return new short[HitRows.paddedLength(rows)];
        }
    };
}
