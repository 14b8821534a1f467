package lightning.render.shading.layer;

import lightning.render.trace.HitRows;

/** Allocates columns, from new memory or from reusable scratch memory. */
public interface ColumnAllocator {
    /** Returns a float column for {@code rows} rows; contents undefined. */
    float[] floats(int rows);

    /** Returns a state column for {@code rows} rows; contents undefined. */
    byte[] states(int rows);

    /** Returns a column of sample sets for {@code rows} rows; contents undefined. */
    short[] shorts(int rows);

    /** Allocates new arrays of the exact length. */
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
